//! The runtime's traits for derivatives, as `Prepared` implements them.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Item, parse_quote};

use super::{signature, text::ident};
use crate::{
    functions::{Declared, Length, N_PARAMETERS, N_SPEEDS, PARAMETER_NAMES},
    listing::Function,
};

/// The implementation of the trait for a function that has one.
pub(super) fn trait_impl(function: &Function) -> Option<Item> {
    let (name, own) = (
        ident(function.derivative_trait?),
        ident(&function.signature.name),
    );
    // The first one is `self`.
    let arguments = function.signature.arguments.iter().skip(1);
    let names = arguments.clone().map(|argument| ident(&argument.name));
    let declared = arguments.map(signature::declared);
    let associated = associated(&function.signature.arguments);
    Some(parse_quote! {
        impl<R: kane::Real> kane::functions::#name<R> for Prepared<R> {
            #associated
            #[inline]
            fn #own(&self, #(#declared),*) {
                self::#own(self, #(#names),*);
            }
        }
    })
}

/// The types that the trait leaves to the system: those of what its arguments are by.
fn associated(arguments: &[Declared]) -> TokenStream {
    let is_of = |axes: &[&str]| {
        let lengths: Vec<_> = axes
            .iter()
            .map(|name| Length::Constant((*name).to_owned()))
            .collect();
        let mut arguments = arguments.iter();
        arguments.any(|argument| argument.lengths == lengths)
    };
    let matrix = is_of(&[N_SPEEDS, N_SPEEDS]).then(|| {
        quote!(
            type Matrix = [[R; NU]; NU];
        )
    });
    let values = ident(N_PARAMETERS);
    let names = ident(PARAMETER_NAMES);
    let by_parameters = is_of(&[N_SPEEDS, N_PARAMETERS]);
    let by = by_parameters.then(|| quote!(type ByParameters = [[R; #values]; NU];));
    let has_values = by_parameters || is_of(&[N_PARAMETERS]);
    let values = has_values.then(|| {
        quote! {
            type Values = [R; #values];
            const PARAMETER_NAMES: &'static [&'static str] = &#names;
        }
    });
    quote!(#matrix #values #by)
}
