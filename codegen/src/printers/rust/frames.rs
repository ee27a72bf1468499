//! The frames that functions are of: types that stand for them, and the traits of the functions.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Item, parse_quote};

use super::{
    signature,
    text::{allow_unused, doc, ident},
};
use crate::{
    functions::{Axes, FrameFunction, Subject},
    listing::{Function, Module},
};

/// A type for each frame, in a module of their own; none where no function is of a frame.
pub(super) fn types(module: &Module) -> Option<Item> {
    let functions = module.functions.iter();
    let subjects = functions.filter_map(|function| function.of_frame.as_ref());
    let frames: BTreeMap<&str, &str> = subjects
        .map(|(_, subject)| (subject.identifier.as_str(), subject.name.as_str()))
        .collect();
    if frames.is_empty() {
        return None;
    }
    let types = frames.into_iter().map(|(identifier, name)| {
        let (doc, allow) = (
            doc([format!("The frame `{}`.", name.escape_debug())]),
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
fn type_name(identifier: &str) -> String {
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

/// The runtime crate's trait for a function of a frame.
pub(super) fn trait_impl(
    function: &Function,
    of_frame: &FrameFunction,
    subject: &Subject,
) -> Option<Item> {
    let (trait_name, method) = (ident(of_frame.trait_name?), ident(of_frame.name));
    let own = ident(&function.signature.name);
    // The first one is `self`.
    let arguments = function.signature.arguments.iter().skip(1);
    let names = arguments.clone().map(|argument| ident(&argument.name));
    let arguments = arguments.map(signature::declared);
    let frame = frame_type(subject);
    Some(parse_quote! {
        impl<R: kane::Real> kane::functions::#trait_name<R, #frame> for Prepared<R> {
            #[inline]
            fn #method(&self, #(#arguments),*) {
                self::#own(self, #(#names),*);
            }
        }
    })
}

fn frame_type(subject: &Subject) -> TokenStream {
    let name = ident(&type_name(&subject.identifier));
    match subject.axes {
        Axes::Inertial => quote!(frames::#name),
        Axes::Local => quote!(kane::functions::Local<frames::#name>),
    }
}

#[cfg(test)]
mod tests {
    use super::type_name;

    #[test]
    fn no_two_frames_become_one_type() {
        let names = ["tool0", "tool_0", "left_foot", "leftfoot", "a_b_1"];
        assert_eq!(
            names.map(type_name),
            ["Tool0", "Tool_0", "LeftFoot", "Leftfoot", "AB_1"]
        );
    }
}
