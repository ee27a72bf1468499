//! What stands in one piece in memory: parameters, what is prepared from them, sines and cosines.

use std::collections::BTreeMap;

use quote::quote;
use syn::{Expr, Item, parse_quote};

use super::{
    expression::Writer,
    statements,
    text::{allow_generated, allow_numbers, allow_unused, doc, ident},
};
use crate::{
    functions::N_PARAMETERS,
    listing::{Code, Expression, Facts, Member, Module, Statement, Step, nominal},
};

/// How many fields of a structure are compared. A derived comparison is one expression, nested once a field, for which the compiler's
/// stack is too small at 6000.
const MOST_COMPARED: usize = 1_000;

/// `Parameters` and its nominal values.
pub(super) fn parameters(module: &Module) -> Vec<Item> {
    let allow = allow_unused();
    let parameters = &module.facts.parameters;
    if parameters.is_empty() {
        let mut items = vec![
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
        items.extend(as_array(&module.facts));
        return items;
    }
    let names = parameters.iter().map(|parameter| ident(&parameter.name));
    let names: Vec<_> = names.collect();
    let docs = parameters.iter().map(|parameter| doc([nominal(parameter)]));
    let writer = Writer::new(&module.facts, &module.nominal);
    let values = fields(&module.nominal.code);
    let values = values.into_values().map(|value| writer.expression(value));
    let allow_numbers = allow_numbers();
    let mut items = vec![
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
                    Self { #(#names: #values,)* }
                }
            }
        },
    ];
    items.extend(as_array(&module.facts));
    items
}

/// `Parameters` as an array, in modules that have some, or derivatives by them.
fn as_array(facts: &Facts) -> Option<Item> {
    let length = ident(&facts.sizes.named(N_PARAMETERS)?.name);
    let names = facts.parameters.iter();
    let names: Vec<_> = names.map(|parameter| ident(&parameter.name)).collect();
    let allow = allow_unused();
    let given = if names.is_empty() {
        quote!(scalar: core::marker::PhantomData)
    } else {
        quote!(#(#names),*)
    };
    Some(parse_quote! {
        impl<R: Copy> Parameters<R> {
            /// These values, in the order of `PARAMETER_NAMES`.
            #allow
            #[inline]
            pub fn from_array(values: [R; #length]) -> Self {
                let [#(#names),*] = values;
                Self { #given }
            }

            /// The values, in the order of `PARAMETER_NAMES`.
            #allow
            #[inline]
            pub fn to_array(self) -> [R; #length] {
                [#(self.#names),*]
            }
        }
    })
}

/// `Prepared` and what computes it.
pub(super) fn prepared(module: &Module) -> Vec<Item> {
    let (facts, prepare) = (&module.facts, &module.prepare);
    let (allow, allow_generated) = (allow_unused(), allow_generated());
    let writer = Writer::new(facts, prepare);
    let statements = statements::without_stores(&writer);
    let names = facts.fields.iter().map(|field| ident(field));
    let values = fields(&prepare.code).into_values();
    let values = values.map(|value| writer.expression(value));
    let assigned = names.clone().zip(values).map(|(name, value)| match &value {
        Expr::Path(path) if path.path.is_ident(&name) => quote!(#name),
        _ => quote!(#name: #value),
    });
    let (declared, assigned) = if facts.fields.is_empty() {
        let marker = quote!(core::marker::PhantomData);
        (quote!(scalar: #marker<R>), quote!(scalar: #marker))
    } else {
        (quote!(#(#names: R,)*), quote!(#(#assigned,)*))
    };
    let cost = doc(prepare.cost());
    let compared = (facts.fields.len() <= MOST_COMPARED).then(|| quote!(, PartialEq));
    vec![
        parse_quote! {
            /// Whatever depends on parameters alone, computed once, outside the control loop.
            #allow
            #[repr(C)]
            #[derive(Clone, Copy, Debug #compared)]
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

/// What holds sines and cosines.
pub(super) fn sin_cos() -> Item {
    let allow = allow_unused();
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
    }
}

/// What is stored to the fields of a structure, in their order.
fn fields(code: &Code) -> BTreeMap<usize, &Expression> {
    let stores = code.statements.iter().filter_map(|statement| {
        let Statement::Store { place, value, .. } = statement else {
            return None;
        };
        match place.steps[..] {
            [Step::Member(Member::Parameter(field) | Member::Prepared(field))] => {
                Some((field, value))
            }
            _ => None,
        }
    });
    stores.collect()
}
