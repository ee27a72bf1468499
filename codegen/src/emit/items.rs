//! Everything of a module that is not a function: sizes, names, parameters, the trait `System`.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::{Item, parse_quote};

use super::{
    Module, allow_generated, allow_unused, doc, expression, ident,
    statements::{self, Stores},
    syntax, tables,
};
use crate::{
    program::{self, Groups, Operations, Place},
    tree::Tree,
};

/// Sizes and name tables.
pub(super) fn constants(tree: &Tree) -> Vec<Item> {
    let literal = Literal::usize_unsuffixed;
    let sizes = [
        ("NB", "Number of bodies.", tree.bodies.len()),
        (
            "NQ",
            "Number of generalized coordinates, the length of `q`.",
            tree.n_coordinates,
        ),
        (
            "NU",
            "Number of generalized speeds, the length of `u`.",
            tree.n_speeds,
        ),
    ];
    let allow = allow_unused();
    let mut items: Vec<Item> = sizes
        .into_iter()
        .map(|(name, text, size)| {
            let (name, doc, size) = (ident(name), doc([text]), literal(size));
            parse_quote!(#doc #allow pub const #name: usize = #size;)
        })
        .collect();
    let coordinates = tree.coordinate_names();
    let speeds = tree.speed_names();
    let lower = tree
        .body_ids()
        .map(|body| literal(tree.lower(body).map_or(0, |lower| lower.index() + 1)));
    let speed_bodies = tree
        .speed_bodies()
        .into_iter()
        .map(|body| literal(body.index()));
    let names = tree.bodies.iter().map(|body| &body.name);
    let name = &tree.name;
    let mut table = |text: &str, item: TokenStream| {
        let doc = doc([text]);
        items.push(parse_quote!(#doc #allow #item));
    };
    table("The system's name.", quote!(pub const NAME: &str = #name;));
    table(
        "The body-connection array: the number of each body's lower body (parent), counted from 1; 0 is the inertial frame.",
        quote!(pub const LOWER_BODIES: [usize; NB] = [#(#lower),*];),
    );
    table(
        "The bodies' names.",
        quote!(pub const BODY_NAMES: [&str; NB] = [#(#names),*];),
    );
    table(
        "The coordinates' names: theta in rad, about the x, y, z of a 1-2-3 body-fixed sequence; e of a unit quaternion, scalar first; s in m, along the joint's axes in the lower body.",
        quote!(pub const COORDINATE_NAMES: [&str; NQ] = [#(#coordinates),*];),
    );
    table(
        "The speeds' names, rad/s and m/s; w is a component of the relative angular velocity.",
        quote!(pub const SPEED_NAMES: [&str; NU] = [#(#speeds),*];),
    );
    table(
        "The body that each speed moves relative to its lower body, as an index into `BODY_NAMES`.",
        quote!(pub const SPEED_BODIES: [usize; NU] = [#(#speed_bodies),*];),
    );
    items.extend(tables::of(tree));
    items
}

/// Which model it is, and what its functions cost.
pub(super) fn identity(module: &Module<'_>) -> Vec<Item> {
    let literal = Literal::usize_unsuffixed;
    let costs = module.costs();
    let n_costs = literal(costs.len());
    let costs = costs.into_iter().map(|(function, operations)| {
        let Operations {
            mul,
            add,
            div,
            trig,
        } = operations;
        let counts = [mul, add, div, trig].map(literal);
        quote!(kane::Cost::new(#function, [#(#counts),*]))
    });
    let fingerprint = syntax::hexadecimal(module.origin.fingerprint);
    let allow = allow_unused();
    vec![
        parse_quote! {
            /// Hash of the model: of every name, number, joint and place in it after all changes, whatever is generated from it.
            #allow
            pub const FINGERPRINT: u64 = #fingerprint;
        },
        parse_quote! {
            /// Of each function the multiplications, additions, divisions, sines and cosines of one call.
            #allow
            pub const OPERATIONS: [kane::Cost; #n_costs] = [#(#costs),*];
        },
    ]
}

/// How long a packed mass matrix is, and where its entries stand.
pub(super) fn packed(tree: &Tree) -> Vec<Item> {
    let places = tree.coupled_speeds();
    let len = Literal::usize_unsuffixed(places.len());
    let places = places.iter().map(|place| {
        let [row, column] = place.map(Literal::usize_unsuffixed);
        quote!([#row, #column])
    });
    let allow = allow_unused();
    vec![
        parse_quote! {
            /// Number of entries that `mass_matrix_packed` writes.
            #allow
            pub const MASS_MATRIX_PACKED_LEN: usize = #len;
        },
        parse_quote! {
            /// The row and column of each entry that `mass_matrix_packed` writes; those above the diagonal are the same.
            #allow
            pub const MASS_MATRIX_PACKED_PLACES: &[[usize; 2]; MASS_MATRIX_PACKED_LEN] = &[#(#places),*];
        },
    ]
}

/// `Parameters` and its nominal values.
pub(super) fn parameters(tree: &Tree) -> Vec<Item> {
    let allow = allow_unused();
    if tree.parameters.is_empty() {
        return vec![
            parse_quote! {
                /// Values set at run time: this model has none.
                #allow
                #[repr(C)]
                #[derive(Clone, Copy, Debug, PartialEq)]
                pub struct Parameters<R> {
                    scalar: core::marker::PhantomData<R>,
                }
            },
            parse_quote! {
                impl<R: kane::Real> Default for Parameters<R> {
                    fn default() -> Self {
                        Self { scalar: core::marker::PhantomData }
                    }
                }
            },
        ];
    }
    let names: Vec<_> = tree
        .parameters
        .iter()
        .map(|parameter| ident(&parameter.name))
        .collect();
    let docs = tree.parameters.iter().map(|parameter| {
        doc([format!(
            "Nominal value {:?} {}.",
            parameter.nominal, parameter.unit
        )])
    });
    let nominal = tree
        .parameters
        .iter()
        .map(|parameter| expression::number(parameter.nominal));
    let allow_numbers = allow_generated();
    vec![
        parse_quote! {
            /// Values set at run time; the default is the model's nominal values.
            #allow
            #[repr(C)]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct Parameters<R> {
                #(#docs pub #names: R,)*
            }
        },
        parse_quote! {
            #allow_numbers
            impl<R: kane::Real> Default for Parameters<R> {
                fn default() -> Self {
                    Self { #(#names: #nominal,)* }
                }
            }
        },
    ]
}

/// `Prepared` and what computes it.
pub(super) fn prepared(module: &Module<'_>, fields: &[String]) -> Vec<Item> {
    let program = &module.preparation;
    let (allow, allow_generated) = (allow_unused(), allow_generated());
    let groups = Groups::of(program);
    let names = program::names(program, &groups, module.tree, Place::Preparation);
    let parameters: Vec<String> = module
        .tree
        .parameters
        .iter()
        .map(|parameter| parameter.name.clone())
        .collect();
    let statements = statements::of(program, &groups, &names, &parameters, Stores::default());
    let writer = expression::Writer {
        program,
        groups: &groups,
        names: &names,
    };
    // In order of name, whatever was asked for first.
    let mut order: Vec<usize> = (0..fields.len()).collect();
    order.sort_by_key(|&place| &fields[place]);
    let names = order.iter().map(|&place| ident(&fields[place]));
    let values = order
        .iter()
        .map(|&place| writer.operand(program.stores[place]));
    let assigned = names.clone().zip(values).map(|(name, value)| match &value {
        syn::Expr::Path(path) if path.path.is_ident(&name) => quote!(#name),
        _ => quote!(#name: #value),
    });
    let (declared, assigned) = if fields.is_empty() {
        let marker = quote!(core::marker::PhantomData);
        (quote!(scalar: #marker<R>), quote!(scalar: #marker))
    } else {
        (quote!(#(#names: R,)*), quote!(#(#assigned,)*))
    };
    let cost = doc([format!("Operations: {}.", program.operations())]);
    vec![
        parse_quote! {
            /// Whatever depends on parameters alone, computed once, outside the control loop.
            #allow
            #[repr(C)]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct Prepared<R> {
                #declared
            }
        },
        parse_quote! {
            impl<R: kane::Real> Prepared<R> {
                /// Prepares a set of parameters.
                ///
                #cost
                #allow_generated
                #[inline(never)]
                pub fn new(parameters: &Parameters<R>) -> Self {
                    #(#statements)*
                    Self { #assigned }
                }

                /// Prepares the nominal parameters.
                #allow
                pub fn nominal() -> Self {
                    Self::new(&Parameters::default())
                }
            }
        },
    ]
}

/// The trait that every system has.
pub(super) fn system(tree: &Tree) -> Item {
    debug_assert!(!tree.bodies.is_empty(), "tree: a system has bodies");
    let normalize = tree.has_quaternions().then(|| {
        quote! {
            #[inline]
            fn normalize(&self, q: &mut [R; NQ]) {
                let given = *q;
                self::normalize(self, &given, q);
            }
        }
    });
    parse_quote! {
        impl<R: kane::Real> kane::System<R> for Prepared<R> {
            type Q = [R; NQ];
            type U = [R; NU];
            type Loads = [kane::Load<R>; NB];
            type Scalars = [R; NB];
            type Vectors = [[R; 3]; NB];
            type Rotations = [[[R; 3]; 3]; NB];
            const NAME: &'static str = NAME;
            const LOWER_BODIES: &'static [usize] = &LOWER_BODIES;
            const BODY_NAMES: &'static [&'static str] = &BODY_NAMES;
            const COORDINATE_NAMES: &'static [&'static str] = &COORDINATE_NAMES;
            const SPEED_NAMES: &'static [&'static str] = &SPEED_NAMES;
            const SPEED_BODIES: &'static [usize] = &SPEED_BODIES;
            const JOINTS: &'static [kane::Joint] = &JOINTS;
            const FRAMES: &'static [kane::Frame] = &FRAMES;
            const LOWER_LIMITS: &'static [f64] = &LOWER_LIMITS;
            const UPPER_LIMITS: &'static [f64] = &UPPER_LIMITS;
            const VELOCITY_LIMITS: &'static [f64] = &VELOCITY_LIMITS;
            const EFFORT_LIMITS: &'static [f64] = &EFFORT_LIMITS;
            const FRICTION: &'static [f64] = &FRICTION;
            const FINGERPRINT: u64 = FINGERPRINT;
            const OPERATIONS: &'static [kane::Cost] = &OPERATIONS;
            #[inline]
            fn q_dot(&self, q: &[R; NQ], u: &[R; NU], q_dot: &mut [R; NQ]) {
                self::q_dot(self, q, u, q_dot);
            }
            #normalize
        }
    }
}
