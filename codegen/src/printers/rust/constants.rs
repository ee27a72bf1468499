//! Constants.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};
use syn::{Item, parse_quote};

use super::{
    syntax,
    text::{allow_numbers, allow_unused, doc, ident},
};
use crate::{
    functions::{CompactBlock, PREPARE, PREPARED_NEW},
    listing::{BaseTerm, Constant, Data, Frame, Function, Joint},
    program::Operations,
};

/// The items of constants, in order.
pub(super) fn items(constants: &[Constant<'_>]) -> Vec<Item> {
    constants.iter().map(item).collect()
}

fn item(constant: &Constant<'_>) -> Item {
    let (name, doc) = (ident(constant.name), doc([constant.doc.as_ref()]));
    let allow = match constant.data {
        Data::Numbers(..) | Data::Joints(..) | Data::Frames(_) | Data::Terms(_) => allow_numbers(),
        _ => allow_unused(),
    };
    let (held, value) = held(&constant.data);
    parse_quote!(#doc #allow pub const #name: #held = #value;)
}

/// The type and the value of what a constant holds.
fn held(data: &Data<'_>) -> (TokenStream, TokenStream) {
    match data {
        Data::Size(size) => (quote!(usize), integer(*size)),
        Data::Hash(hash) => (quote!(u64), syntax::hexadecimal(*hash).into_token_stream()),
        Data::Text(text) => (quote!(&str), quote!(#text)),
        Data::Texts(length, texts) => array(
            &quote!(&str),
            length,
            texts.iter().map(|text| quote!(#text)),
        ),
        Data::Truths(length, truths) => array(
            &quote!(bool),
            length,
            truths.iter().map(|truth| quote!(#truth)),
        ),
        Data::Integers(length, numbers) => {
            array(&quote!(usize), length, numbers.iter().copied().map(integer))
        }
        Data::Numbers(length, values) => {
            let length = ident(length);
            (
                quote!([f64; #length]),
                numbers(values, &length.into_token_stream()),
            )
        }
        Data::Places(length, places) => {
            let places = places.iter().map(|place| {
                let [row, column] = place.map(integer);
                quote!([#row, #column])
            });
            let (held, places) = array(&quote!([usize; 2]), length, places);
            (quote!(&#held), quote!(&#places))
        }
        Data::Joints(length, joints) => {
            array(&quote!(kane::Joint), length, joints.iter().map(joint))
        }
        Data::Frames(frames) => list(&quote!(kane::Frame), frames.iter().map(frame)),
        Data::Terms(terms) => list(&quote!(kane::BaseTerm), terms.iter().map(term)),
        Data::Blocks(blocks) => list(&quote!(kane::Block), blocks.iter().map(block)),
        Data::Costs(functions) => list(&quote!(kane::Cost), functions.iter().map(|one| cost(one))),
    }
}

/// An array whose length has a name.
fn array(
    element: &TokenStream,
    length: &str,
    values: impl Iterator<Item = TokenStream>,
) -> (TokenStream, TokenStream) {
    let length = ident(length);
    (quote!([#element; #length]), quote!([#(#values),*]))
}

/// An array whose length has none.
fn list(
    element: &TokenStream,
    values: impl ExactSizeIterator<Item = TokenStream>,
) -> (TokenStream, TokenStream) {
    let length = integer(values.len());
    (quote!([#element; #length]), quote!([#(#values),*]))
}

fn cost(function: &Function) -> TokenStream {
    let name = match function.signature.name.as_str() {
        PREPARE => PREPARED_NEW,
        name => name,
    };
    let Operations {
        mul,
        add,
        div,
        trig,
    } = function.operations;
    let counts = [mul, add, div, trig].map(integer);
    quote!(kane::Cost::new(#name, [#(#counts),*]))
}

fn term(term: &BaseTerm) -> TokenStream {
    let [base, body, parameter] = [term.base, term.body, term.parameter].map(integer);
    let factor = number(term.factor);
    quote!(kane::BaseTerm { base: #base, body: #body, parameter: #parameter, factor: #factor })
}

fn block(block: &CompactBlock) -> TokenStream {
    let [body, partition, speed, columns, first] = [
        block.body,
        block.partition,
        block.speed,
        block.columns,
        block.first,
    ]
    .map(integer);
    quote!(kane::Block { body: #body, partition: #partition, speed: #speed, columns: #columns, first: #first })
}

fn joint(joint: &Joint) -> TokenStream {
    let chart = ident(joint.chart.name());
    let name = &joint.name;
    let (q, u) = (joint.q.map(place), joint.u.map(place));
    quote!(kane::Joint { name: #name, chart: kane::Chart::#chart, q: [#(#q),*], u: [#(#u),*] })
}

fn place(place: Option<usize>) -> TokenStream {
    match place.map(integer) {
        None => quote!(None),
        Some(place) => quote!(Some(#place)),
    }
}

fn frame(frame: &Frame) -> TokenStream {
    let name = &frame.name;
    let body = place(frame.body);
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

fn integer(value: usize) -> TokenStream {
    Literal::usize_unsuffixed(value).into_token_stream()
}
