//! Tables of joints, of frames fixed in bodies, and of limits.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};
use syn::{Item, parse_quote};

use super::{allow_generated, doc, syntax};
use crate::tree::{ChartCoordinates, Coordinate, Frame, Joint, Mechanics, Orientation, Tree};

/// `JOINTS`, `FRAMES`, and the limits.
pub(super) fn of(tree: &Tree) -> Vec<Item> {
    let mut items = Vec::new();
    let mut table = |text: &str, item: TokenStream| {
        let (doc, allow) = (doc([text]), allow_generated());
        items.push(parse_quote!(#doc #allow #item));
    };
    let joints = tree.bodies.iter().map(|body| joint(&body.joint));
    table(
        "Each body's joint: the places of its coordinates and speeds.",
        quote!(pub const JOINTS: [kane::Joint; NB] = [#(#joints),*];),
    );
    let n_frames = Literal::usize_unsuffixed(tree.frames.len());
    let frames = tree.frames.iter().map(frame);
    table(
        "Frames of the model's bodies that are fixed to others, and part of them.",
        quote!(pub const FRAMES: [kane::Frame; #n_frames] = [#(#frames),*];),
    );
    let lower = numbers(
        &along_coordinates(tree, |mechanics| mechanics.range[0], f64::NEG_INFINITY),
        &quote!(NQ),
    );
    table(
        "The least value of each coordinate, rad, m: data only.",
        quote!(pub const LOWER_LIMITS: [f64; NQ] = #lower;),
    );
    let upper = numbers(
        &along_coordinates(tree, |mechanics| mechanics.range[1], f64::INFINITY),
        &quote!(NQ),
    );
    table(
        "The greatest value of each coordinate, rad, m: data only.",
        quote!(pub const UPPER_LIMITS: [f64; NQ] = #upper;),
    );
    let velocity = numbers(
        &along_speeds(tree, |mechanics| mechanics.velocity),
        &quote!(NU),
    );
    table(
        "The greatest magnitude of each speed, rad/s, m/s: data only.",
        quote!(pub const VELOCITY_LIMITS: [f64; NU] = #velocity;),
    );
    let effort = numbers(
        &along_speeds(tree, |mechanics| mechanics.effort),
        &quote!(NU),
    );
    table(
        "The greatest magnitude of each generalized force, N m, N: data only.",
        quote!(pub const EFFORT_LIMITS: [f64; NU] = #effort;),
    );
    let friction = numbers(
        &along_speeds(tree, |mechanics| mechanics.friction),
        &quote!(NU),
    );
    table(
        "Coulomb friction along each speed, N m, N: data only, no part of any function.",
        quote!(pub const FRICTION: [f64; NU] = #friction;),
    );
    items
}

fn joint(joint: &Joint) -> TokenStream {
    let (chart, mut q) = match joint.orientation {
        Orientation::Rates(_) => (quote!(AngleRates), [None; 7]),
        Orientation::AngularVelocity {
            chart: ChartCoordinates::Angles(_),
            ..
        } => (quote!(Angles), [None; 7]),
        Orientation::AngularVelocity {
            chart: ChartCoordinates::EulerParameters(_),
            ..
        } => (quote!(EulerParameters), [None; 7]),
    };
    for (kind, coordinate) in joint.coordinates() {
        let slot = match kind {
            "theta1" | "e0" => 0,
            "theta2" | "e1" => 1,
            "theta3" | "e2" => 2,
            "e3" => 3,
            "s1" => 4,
            "s2" => 5,
            _ => 6,
        };
        q[slot] = Some(coordinate.index());
    }
    let mut u = [None; 6];
    for (motion, speed) in joint.speeds() {
        u[motion] = Some(speed.index());
    }
    let name = &joint.name;
    let (q, u) = (q.map(place), u.map(place));
    quote!(kane::Joint { name: #name, chart: kane::Chart::#chart, q: [#(#q),*], u: [#(#u),*] })
}

fn place(place: Option<usize>) -> TokenStream {
    match place {
        None => quote!(None),
        Some(place) => {
            let place = Literal::usize_unsuffixed(place);
            quote!(Some(#place))
        }
    }
}

fn frame(frame: &Frame) -> TokenStream {
    let name = &frame.name;
    let body = place(frame.body.map(crate::id::BodyId::index));
    let rows = frame.rotation.iter().map(|row| {
        let row = row.iter().map(|entry| number(*entry));
        quote!([#(#row),*])
    });
    let position = frame.position.iter().map(|entry| number(*entry));
    quote! {
        kane::Frame {
            name: #name,
            body: #body,
            rotation: [#(#rows),*],
            position: [#(#position),*],
        }
    }
}

fn along_coordinates(tree: &Tree, of: impl Fn(&Mechanics) -> f64, none: f64) -> Vec<f64> {
    let mut values = vec![none; tree.n_coordinates];
    for body in &tree.bodies {
        let joint = &body.joint;
        let angles = joint.angles().into_iter().flatten();
        let angles = angles.zip(&joint.mechanics);
        let translations = joint.translations.iter().copied();
        let translations = translations.zip(&joint.mechanics[3..]);
        for (coordinate, mechanics) in angles.chain(translations) {
            if let Coordinate::Free { coordinate, .. } = coordinate {
                values[coordinate.index()] = of(mechanics);
            }
        }
    }
    values
}

fn along_speeds(tree: &Tree, of: impl Fn(&Mechanics) -> f64) -> Vec<f64> {
    let mut values = vec![0.0; tree.n_speeds];
    for body in &tree.bodies {
        for (motion, speed) in body.joint.speeds() {
            values[speed.index()] = of(&body.joint.mechanics[motion]);
        }
    }
    values
}

/// A list of numbers; short where all are the same.
fn numbers(values: &[f64], length: &TokenStream) -> TokenStream {
    match values {
        [first, rest @ ..] if rest.iter().all(|value| value == first) => {
            let first = number(*first);
            quote!([#first; #length])
        }
        _ => {
            let values = values.iter().map(|value| number(*value));
            quote!([#(#values),*])
        }
    }
}

fn number(value: f64) -> TokenStream {
    if value == f64::INFINITY {
        quote!(f64::INFINITY)
    } else if value == f64::NEG_INFINITY {
        quote!(f64::NEG_INFINITY)
    } else {
        syntax::number(value).into_token_stream()
    }
}
