//! The runtime's traits for derivatives, as `Prepared` implements them.

use syn::{Item, parse_quote};

use super::{signature, text::ident};
use crate::listing::Function;

/// The implementation of the trait for a function that has one.
pub(super) fn trait_impl(function: &Function) -> Option<Item> {
    let known = function.derivative_trait.as_ref()?;
    let (name, method) = (ident(known.name), ident(&known.method));
    let own = ident(&function.signature.name);
    // The first one is `self`.
    let arguments = function.signature.arguments.iter().skip(1);
    let names = arguments.clone().map(|argument| ident(&argument.name));
    let declared = arguments.map(signature::declared);
    Some(parse_quote! {
        impl<R: kane::Real> kane::functions::#name<R> for Prepared<R> {
            #[inline]
            fn #method(&self, #(#declared),*) {
                self::#own(self, #(#names),*);
            }
        }
    })
}
