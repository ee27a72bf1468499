//! Arguments as Rust declares them.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::text::ident;
use crate::functions::{Access, Declared, Element, Length};

/// `m: &mut [[R; NU]; NU]`.
pub(super) fn declared(argument: &Declared) -> TokenStream {
    let (name, held) = (ident(&argument.name), held(argument, "R"));
    match argument.access {
        Access::Read => quote!(#name: &#held),
        Access::Written => quote!(#name: &mut #held),
    }
}

/// What an argument leads to: `[[R; NU]; NU]`, with the scalar's name for `R`.
pub(super) fn held(argument: &Declared, scalar: &str) -> TokenStream {
    let scalar = ident(scalar);
    let element = match argument.element {
        Element::Scalar => quote!(#scalar),
        Element::Load => quote!(kane::Load<#scalar>),
        Element::Parameters => quote!(Parameters<#scalar>),
        Element::Prepared => quote!(Prepared<#scalar>),
        Element::SinCos => quote!(SinCos<#scalar>),
    };
    let lengths = argument.lengths.iter().rev();
    lengths.fold(element, |held, length| match length {
        Length::Number(number) => {
            let number = Literal::usize_unsuffixed(*number);
            quote!([#held; #number])
        }
        Length::Constant(name) => {
            let name = ident(name);
            quote!([#held; #name])
        }
        Length::Twice(name) => {
            let name = ident(name);
            quote!([#held; 2 * #name])
        }
    })
}
