//! The functions of a module for C: `extern "C"`, in a file of their own, which stands beside the module.

use std::{collections::BTreeSet, ffi::CString};

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::{Item, parse_quote};

use super::{
    signature, steps,
    syntax::hexadecimal,
    text::{banner, doc, ident, printed},
};
use crate::{
    functions::{Access, Element, Length, NOMINAL, PREPARE, Signature},
    listing::{Facts, Module, constants::FINGERPRINT},
    printers::c::{
        rules::{RULES, SCALARS, symbol},
        runtime::{self, RuntimeFunction, RuntimeKind},
    },
    words::C_INPUT,
};

/// The text of the file beside the module `name`.
pub(crate) fn source(module: &Module, name: &str) -> String {
    let runtime = runtime::of(module);
    let own = module.all().map(|function| &function.signature);
    let own: Vec<_> = own.collect();
    let of_runtime = runtime.iter().map(|function| &function.signature);
    let signatures: Vec<_> = own.iter().copied().chain(of_runtime).collect();
    let mut text = banner(&module.facts.origin.lines());
    let what = format!(
        "The functions of the module `{name}` for C; `{name}.h` declares them. In the crate: `mod {name}; mod {name}_c;`."
    );
    for line in ["", &what, "", "# Safety", ""].into_iter().chain(RULES) {
        text.push_str(format!("// {line}").trim_end());
        text.push('\n');
    }
    let mut items = vec![
        imports(&signatures, name),
        belongs_together(module, name),
        input(module, name),
    ];
    for signature in own {
        let body = call(signature, name);
        items.extend(functions(signature, name, &module.facts, &body));
    }
    for RuntimeFunction { signature, kind } in &runtime {
        let body = runtime_call(*kind);
        items.extend(functions(signature, name, &module.facts, &body));
    }
    text + &printed(items)
}

/// The constants and types of the module that the functions name.
fn imports(signatures: &[&Signature], name: &str) -> Item {
    let arguments = signatures.iter().flat_map(|one| &one.arguments);
    let named = arguments.flat_map(|argument| {
        let constants = argument.lengths.iter().filter_map(Length::constant);
        let element = match argument.element {
            Element::Scalar | Element::Load => None,
            Element::Parameters => Some("Parameters"),
            Element::Prepared => Some("Prepared"),
            Element::SinCos => Some("SinCos"),
        };
        constants.chain(element)
    });
    let named: BTreeSet<&str> = named.chain([FINGERPRINT]).collect();
    let (name, named) = (ident(name), named.into_iter().map(ident));
    parse_quote!(use super::#name::{#(#named),*};)
}

/// What does not compile beside a module of another model, or with other prepared parameters than the header has.
fn belongs_together(module: &Module, name: &str) -> Item {
    let Facts { origin, fields, .. } = &module.facts;
    let fingerprint = hexadecimal(origin.fingerprint);
    let prepared = Literal::usize_unsuffixed(fields.len() * size_of::<f64>());
    let message = format!(
        "`{name}_c.rs` and `{name}.h` are not of the model or the options of `{name}.rs`: generate them together"
    );
    parse_quote! {
        const _: () = {
            let is_same_model = FINGERPRINT == #fingerprint;
            let has_same_size = core::mem::size_of::<Prepared<f64>>() == #prepared;
            assert!(is_same_model && has_same_size, #message);
        };
    }
}

/// What a header can be compared with.
fn input(module: &Module, name: &str) -> Item {
    let symbol = ident(&format!("{name}_{C_INPUT}"));
    let text = CString::new(module.facts.origin.input_text());
    let text = Literal::c_string(&text.expect("hexadecimal digits have no zero among them"));
    let doc = doc([
        "The hash of what this was generated from, the same as in the header that belongs to it.",
    ]);
    parse_quote! {
        #doc
        #[unsafe(no_mangle)]
        pub extern "C" fn #symbol() -> *const core::ffi::c_char {
            #text.as_ptr()
        }
    }
}

/// A function for each scalar.
fn functions(signature: &Signature, name: &str, facts: &Facts, body: &TokenStream) -> [Item; 2] {
    let [double, single] = SCALARS;
    let lines = signature.lines(|unit| facts.units.among(unit));
    let same = format!("As `{}`.", symbol(name, &signature.name, double));
    [
        function(signature, (name, double), lines, body),
        function(signature, (name, single), vec![same], body),
    ]
}

fn function(
    signature: &Signature,
    (module, scalar): (&str, &str),
    lines: Vec<String>,
    body: &TokenStream,
) -> Item {
    let safety = "As the beginning of this file says.";
    let lines = lines
        .into_iter()
        .chain(["", "# Safety", safety].map(str::to_owned));
    let doc = doc(lines);
    let allow = (signature.arguments.len() > 7).then(|| {
        quote!(#[allow(clippy::too_many_arguments, reason = "generated: arguments follow one pattern")])
    });
    let declared = signature.arguments.iter().map(|argument| {
        let (name, held) = (ident(&argument.name), signature::held(argument, scalar));
        match argument.access {
            Access::Read => quote!(#name: *const #held),
            Access::Written => quote!(#name: *mut #held),
        }
    });
    let name = ident(&symbol(module, &signature.name, scalar));
    parse_quote! {
        #doc
        #allow
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn #name(#(#declared),*) {
            unsafe { #body }
        }
    }
}

/// The call of a function of the module.
fn call(signature: &Signature, module: &str) -> TokenStream {
    let passed = signature.arguments.iter().map(|argument| {
        let name = ident(&argument.name);
        match argument.access {
            Access::Read => quote!(&*#name),
            Access::Written => quote!(&mut *#name),
        }
    });
    let (own, module) = (ident(&signature.name), ident(module));
    match signature.name.as_str() {
        NOMINAL => quote!(parameters.write(Parameters::default());),
        PREPARE => quote!(p.write(Prepared::new(&*parameters));),
        _ => quote!(super::#module::#own(#(#passed),*);),
    }
}

/// The call of a function of the runtime crate.
fn runtime_call(kind: RuntimeKind) -> TokenStream {
    match kind {
        RuntimeKind::QPlus => quote! {
            q_after.write(kane::manifold::q_plus(&*p, &*q, &*direction));
        },
        RuntimeKind::QMinus => quote! {
            direction.write(kane::manifold::q_minus(&*p, &*q_from, &*q_to));
        },
        RuntimeKind::ScaleQuaternions => quote! {
            q_after.write(*q);
            kane::manifold::scale_quaternions(&*p, &mut *q_after);
        },
        RuntimeKind::Step(step) => steps::call(step),
    }
}
