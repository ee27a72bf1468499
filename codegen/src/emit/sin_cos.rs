//! Sines and cosines as a value of their own, for the functions that are given them.

use proc_macro2::Literal;
use quote::quote;
use syn::{Item, parse_quote};

use super::{allow_generated, allow_unused, doc, signature::declared, statements::ANGLES_OF_CALL};
use crate::{functions::Signature, passes::sines, program::Operations, tree::Tree};

/// The number and names of the angles, the type that holds their sines and cosines, and the function that computes them.
pub(super) fn items(tree: &Tree) -> Vec<Item> {
    let angles = sines::angles(tree);
    let n_angles = Literal::usize_unsuffixed(angles.len());
    let coordinates = tree.coordinate_names();
    let names = angles
        .iter()
        .map(|angle| &coordinates[angle.coordinate.index()]);
    let places = |first: usize, count: usize| (first..first + count).map(Literal::usize_unsuffixed);
    let firsts = (0..).step_by(ANGLES_OF_CALL);
    let calls = firsts
        .zip(angles.chunks(ANGLES_OF_CALL))
        .map(|(first, angles)| {
            let coordinates = angles
                .iter()
                .map(|angle| Literal::usize_unsuffixed(angle.coordinate.index()));
            let [sines, cosines] = [(); 2].map(|()| places(first, angles.len()));
            quote! {
                let (sines, cosines) = R::sin_cos_array([#(q[#coordinates]),*]);
                [#(sin_cos.sines[#sines]),*] = sines;
                [#(sin_cos.cosines[#cosines]),*] = cosines;
            }
        });
    let Signature {
        doc: lines,
        arguments,
        ..
    } = Signature::sin_cos();
    let cost = format!("Operations: {}.", operations(tree));
    let doc = doc(lines.into_iter().chain([String::new(), cost]));
    let arguments = arguments.iter().map(declared);
    let (allow, allow_generated) = (allow_unused(), allow_generated());
    vec![
        parse_quote! {
            /// Number of angles among the coordinates.
            #allow
            pub const NA: usize = #n_angles;
        },
        parse_quote! {
            /// The names of the angles among the coordinates, in the order of `q`.
            #allow
            pub const ANGLE_NAMES: [&str; NA] = [#(#names),*];
        },
        parse_quote! {
            /// The sine and cosine of every angle among the coordinates.
            #allow
            #[repr(C)]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct SinCos<R> {
                /// The sines, in the order of `ANGLE_NAMES`.
                pub sines: [R; NA],
                /// The cosines.
                pub cosines: [R; NA],
            }
        },
        parse_quote! {
            #doc
            #allow_generated
            #[inline(never)]
            pub fn sin_cos<R: kane::Real>(#(#arguments),*) {
                #(#calls)*
            }
        },
    ]
}

/// What the function costs.
pub(super) fn operations(tree: &Tree) -> Operations {
    Operations {
        trig: 2 * sines::angles(tree).len(),
        ..Operations::default()
    }
}
