//! The frames that functions are of: types that stand for them.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Item, parse_quote};

use super::text::{allow_unused, doc, ident};
use crate::{
    diagnostic::Escaped,
    functions::{Subject, SubjectFrame, View},
    listing::Module,
};

/// A type for each frame, in a module of their own; none where no function is of a frame.
pub(super) fn types(module: &Module) -> Option<Item> {
    let functions = module.functions.iter();
    let subjects =
        functions.filter_map(|function| function.catalogue_part.as_ref()?.subject.as_ref());
    let frames: BTreeMap<&str, &str> = subjects
        .flat_map(|subject| &subject.frames)
        .map(|frame| (frame.identifier.as_str(), frame.name.as_str()))
        .collect();
    if frames.is_empty() {
        return None;
    }
    let types = frames.into_iter().map(|(identifier, name)| {
        let (doc, allow) = (
            doc([format!("The frame `{}`.", name.escaped())]),
            allow_unused(),
        );
        let name = ident(&type_name(identifier));
        quote! {
            #doc
            #allow
            #[derive(Clone, Copy, Debug)]
            pub struct #name;
        }
    });
    let doc =
        doc(["Frames that functions are of: types that stand for them in the runtime's traits."]);
    Some(parse_quote! {
        #doc
        #[allow(non_camel_case_types, reason = "digits are kept apart as in the frames' names")]
        pub mod frames {
            #(#types)*
        }
    })
}

/// `Tool0` for `tool0`; digits that begin a word keep their distance, so that no two names become one.
pub(super) fn type_name(identifier: &str) -> String {
    let mut name = String::new();
    for word in identifier.split('_') {
        let mut characters = word.chars();
        let first = characters.next().unwrap_or('_');
        if first.is_ascii_digit() {
            name.push('_');
        }
        name.push(first.to_ascii_uppercase());
        name.extend(characters);
    }
    name
}

/// The type that stands for frames, with how they are seen.
pub(super) fn frame_type(subject: &Subject) -> TokenStream {
    let name = |frame: &SubjectFrame| {
        let name = ident(&type_name(&frame.identifier));
        quote!(frames::#name)
    };
    let names = subject.frames.iter().map(name);
    match (subject.view, names.len()) {
        (View::Inertial, 1) => quote!(#(#names)*),
        (View::Inertial, _) => quote!((#(#names),*)),
        (View::Local, 1) => quote!(kane::functions::Local<#(#names)*>),
        (View::Local, _) => quote!(kane::functions::Local<(#(#names),*)>),
        (View::Other, _) => quote!(kane::functions::Seen<#(#names),*>),
    }
}
