//! The tests beside a module: calls of `kane::self_test`, with their states and values.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::{Expr, Item, parse_quote};

use super::{
    signature, syntax,
    text::{banner, ident, printed},
};
use crate::{
    functions::{Argument, Declared, Element},
    listing::{Facts, Function, Module},
    number::one_digit,
    samples::{Sample, Sampled},
    tree::Parameter,
};

/// The text of the tests of the module `name`, which stands beside theirs.
pub(crate) fn self_tests(
    module: &Module,
    name: &str,
    samples: &[Sample],
    functions: &[Sampled],
) -> String {
    let mut text = banner(&module.facts.origin.lines());
    let what =
        format!("// Tests of the module `{name}`: `mod {name}; #[cfg(test)] mod {name}_tests;`.\n");
    text.push_str(&what);
    let name = ident(name);
    // Called by its path, a function may have the name of anything that stands here.
    let mut items = vec![
        parse_quote!(use super::#name as module;),
        parse_quote!(use super::#name::*;),
    ];
    items.extend(states(module, samples));
    let sampled = module.functions.iter().zip(functions);
    items.extend(sampled.map(|(function, sampled)| values(function, sampled)));
    items.extend(identities(module));
    text + &printed(items)
}

/// The states, and of what else functions are given as much as they need.
fn states(module: &Module, samples: &[Sample]) -> Vec<Item> {
    let count = syntax::integer(samples.len());
    let states = samples.iter().map(|sample| {
        let of_state = Argument::ALL.into_iter();
        let of_state = of_state.filter(|argument| argument.sampled().is_none());
        let fields = of_state.map(|argument| {
            let name = ident(argument.name());
            let numbers = numbers(&module.facts, argument, sample);
            quote!(#name: #numbers)
        });
        quote!(kane::self_test::State { #(#fields),* })
    });
    let mut items = vec![parse_quote! {
        const STATES: [kane::self_test::State<NQ, NU>; #count] = [#(#states),*];
    }];
    items.extend(systems(&module.facts, samples));
    let functions = module.functions.iter();
    let given: BTreeSet<Argument> = functions.flat_map(|one| &one.arguments).copied().collect();
    let mut known = BTreeSet::new();
    items.extend(given.into_iter().filter_map(|argument| {
        let name = argument.sampled()?;
        // Multipliers of different outputs may be alike.
        if !known.insert(name.clone()) {
            return None;
        }
        let name = ident(&name);
        let held = signature::held(&argument.declared(), "f64");
        let samples = samples.iter();
        let samples = samples.map(|sample| numbers(&module.facts, argument, sample));
        Some(parse_quote! {
            const #name: [#held; #count] = [#(#samples),*];
        })
    }));
    items
}

/// What a sample has for an argument.
fn numbers(facts: &Facts, argument: Argument, sample: &Sample) -> Expr {
    let extent = facts.extent(&argument.declared());
    nested(sample.of(argument), extent.lengths(), argument.element())
}

/// Nested arrays of these lengths, outermost first.
fn nested(numbers: &[f64], lengths: &[usize], element: Element) -> Expr {
    match (lengths, element.vectors()) {
        (&[length, ref inner @ ..], _) => {
            // None has entries where there are none, or where these are empty.
            let size = numbers.len().checked_div(length).unwrap_or(0);
            let entries = (0..length).map(|place| &numbers[place * size..(place + 1) * size]);
            syntax::array(entries.map(|entry| nested(entry, inner, element)))
        }
        ([], []) => syntax::number(numbers[0]),
        ([], vectors) => {
            let (names, vectors) = (vectors.iter().map(|name| ident(name)), numbers.chunks(3));
            let vectors = vectors.map(|vector| nested(vector, &[3], Element::Scalar));
            parse_quote!(kane::Load { #(#names: #vectors),* })
        }
    }
}

/// The system in each state: with the parameters of that, if it has any.
fn systems(facts: &Facts, samples: &[Sample]) -> Vec<Item> {
    if facts.parameters.is_empty() {
        return vec![parse_quote! {
            fn system(_: usize) -> Prepared<f64> {
                Prepared::nominal()
            }
        }];
    }
    let count = syntax::integer(samples.len());
    let parameters = facts.parameters.iter();
    let fields: Vec<Ident> = parameters.map(|parameter| ident(&parameter.name)).collect();
    let values = samples.iter().map(|sample| {
        let numbers = sample.parameters.iter().copied().map(syntax::number);
        quote!(Parameters { #(#fields: #numbers),* })
    });
    vec![
        parse_quote! {
            const PARAMETERS: [Parameters<f64>; #count] = [#(#values),*];
        },
        parse_quote! {
            fn system(place: usize) -> Prepared<f64> {
                Prepared::new(&PARAMETERS[place])
            }
        },
    ]
}

/// The test that a function has its values.
fn values(function: &Function, sampled: &Sampled) -> Item {
    let name = &function.signature.name;
    let (test, call) = (format_ident!("{name}_has_its_values"), ident(name));
    let places: Vec<Expr> = (0..sampled.lengths.len()).map(syntax::integer).collect();
    let n_states = syntax::integer(sampled.values.len());
    let numbers = sampled.values.first().into_iter().flatten();
    let types = numbers.map(|numbers| {
        let count = syntax::integer(numbers.len());
        quote!([(f64, f64); #count])
    });
    let expected = sampled.values.iter().map(|outputs| {
        let outputs = outputs.iter().map(|numbers| pairs(numbers));
        quote!((#(#outputs,)*))
    });
    let empty = sampled.lengths.iter().map(|lengths| {
        lengths
            .iter()
            .rev()
            .fold(quote!(f64::NAN), |inner, &length| {
                let length = syntax::integer(length);
                quote!([#inner; #length])
            })
    });
    let found =
        sampled
            .lengths
            .iter()
            .zip(&places)
            .map(|(lengths, place)| match lengths.as_slice() {
                [] => quote!(&[outputs.#place]),
                [_] => quote!(&outputs.#place),
                [_, inner @ ..] => {
                    let flattened = inner.iter().map(|_| quote!(.as_flattened()));
                    quote!(outputs.#place #(#flattened)*)
                }
            });
    let entries = sampled
        .entries
        .iter()
        .map(|&entries| syntax::integer(entries));
    let given = arguments(function);
    let mut inputs = function.inputs();
    let is_at_sin_cos = inputs.any(|input| input.element == Element::SinCos);
    let sines = is_at_sin_cos.then(|| {
        quote! {
            let mut given = SinCos { sines: [f64::NAN; NA], cosines: [f64::NAN; NA] };
            sin_cos(&p, &STATES[place].q, &mut given);
        }
    });
    parse_quote! {
        #[test]
        fn #test() -> Result<(), kane::self_test::Mismatch> {
            const EXPECTED: [(#(#types,)*); #n_states] = [#(#expected),*];
            for (place, expected) in EXPECTED.iter().enumerate() {
                let p = system(place);
                #sines
                let mut outputs = (#(#empty,)*);
                module::#call(&p, #(#given,)* #(&mut outputs.#places),*);
                #(kane::self_test::has_values(#name, #found, #entries, &expected.#places)?;)*
            }
            Ok(())
        }
    }
}

/// What a function is given after the system.
fn arguments(function: &Function) -> Vec<TokenStream> {
    let argument = |declared: &Declared| match declared.element {
        Element::Prepared => None,
        Element::SinCos => Some(quote!(&given)),
        Element::Scalar | Element::Load | Element::Parameters => {
            let mut arguments = function.arguments.iter().copied();
            let argument = arguments.find(|argument| argument.name() == declared.name);
            Some(place_of(argument.unwrap_or_else(|| {
                unreachable!("self tests: nothing is sampled for `{}`", declared.name)
            })))
        }
    };
    function.inputs().filter_map(argument).collect()
}

/// Where an argument's sample stands.
fn place_of(argument: Argument) -> TokenStream {
    let Some(constant) = argument.sampled().map(|name| ident(&name)) else {
        let field = ident(argument.name());
        return quote!(&STATES[place].#field);
    };
    quote!(&#constant[place])
}

/// The tests of what holds for every system, as far as the module has the functions.
fn identities(module: &Module) -> Vec<Item> {
    let mut items = Vec::new();
    for (name, needed, arguments) in [
        (
            "mass_matrix_is_positive_definite",
            &["mass_matrix"][..],
            &["q"][..],
        ),
        (
            "forward_undoes_inverse",
            &["inverse_dynamics", "forward_dynamics"],
            &["q", "u", "u_dot"],
        ),
        (
            "power_is_the_rate_of_energy",
            &[
                "inverse_dynamics",
                "bias",
                "kinetic_energy",
                "potential_energy",
            ],
            &["q", "u", "u_dot"],
        ),
        (
            "bias_follows_the_mass_matrix",
            &["mass_matrix", "bias"],
            &["q", "u"],
        ),
    ] {
        if has(module, needed) {
            let (name, arguments) = (ident(name), arguments.iter().map(|name| ident(name)));
            items.push(parse_quote! {
                #[test]
                fn #name() -> Result<(), kane::self_test::Mismatch> {
                    STATES.iter().enumerate().try_for_each(|(place, state)| {
                        kane::self_test::#name(&system(place), #(&state.#arguments),*)
                    })
                }
            });
        }
    }
    if has(module, &["inverse_dynamics"]) {
        items.extend(module.facts.parameters.iter().filter_map(linear));
    }
    items
}

/// True where the module has these functions of the system, whatever they are called there.
fn has(module: &Module, names: &[&str]) -> bool {
    let parts = module.functions.iter();
    let parts = parts.filter_map(|own| own.catalogue_part.as_ref());
    let known: Vec<&str> = parts.map(|part| part.function.name).collect();
    names.iter().all(|name| known.contains(name))
}

/// The test that forces are linear in a parameter; they are in all but lengths and angles.
fn linear(parameter: &Parameter) -> Option<Item> {
    if ["m", "rad"].contains(&parameter.unit) {
        return None;
    }
    let field: Ident = ident(&parameter.name);
    let test = format_ident!("inverse_dynamics_is_linear_in_{field}");
    let step = 0.25 * parameter.nominal.abs();
    let step = syntax::number(if step == 0.0 { 0.25 } else { step });
    Some(parse_quote! {
        #[test]
        fn #test() -> Result<(), kane::self_test::Mismatch> {
            STATES.iter().zip(PARAMETERS).try_for_each(|(state, parameters)| {
                let [below, at, above] = [-1.0, 0.0, 1.0].map(|steps| {
                    let mut parameters = parameters;
                    parameters.#field += steps * #step;
                    Prepared::new(&parameters)
                });
                kane::self_test::inverse_dynamics_is_linear([&below, &at, &above], &state.q, &state.u, &state.u_dot)
            })
        }
    })
}

/// Numbers with their tolerances, of which one digit is enough: the next larger.
fn pairs(numbers: &[(f64, f64)]) -> Expr {
    syntax::array(numbers.iter().map(|&(number, tolerance)| {
        let (number, tolerance) = (syntax::number(number), syntax::number(one_digit(tolerance)));
        parse_quote!((#number, #tolerance))
    }))
}
