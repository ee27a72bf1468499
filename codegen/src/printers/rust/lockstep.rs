//! What a function runs on several columns: straight lines for one column, which a loop of fixed length repeats.

use proc_macro2::{Ident, Literal};
use quote::quote;
use syn::{Expr, Item, parse_quote};

use super::{
    expression::Writer,
    statements, syntax,
    text::{allow_generated, doc, ident},
};
use crate::{
    expr::LANES,
    functions::{Declared, Length},
    listing::{Expression, Facts, Function, SHARED, SIDES, SOLVED},
};

/// What counts the columns.
pub(super) const LANE: &str = "lane";

/// The helpers of a function, of which nobody else knows.
pub(super) fn items(facts: &Facts, function: &Function) -> Vec<Item> {
    let helpers = function.helpers.iter();
    helpers.map(|helper| item(facts, helper)).collect()
}

/// A helper. What it computes is first given some numbers: zeros a compiler would write by a call of `memset`.
fn item(facts: &Facts, helper: &Function) -> Item {
    let signature = &helper.signature;
    let mut lines = signature.doc.clone();
    lines.push(String::new());
    lines.push("For one column:".to_owned());
    lines.extend(helper.cost());
    let (doc, allow, name) = (doc(lines), allow_generated(), ident(&signature.name));
    let [shared, sides, solved] = [SHARED, SIDES, SOLVED].map(ident);
    let [n_shared, n_sides, n_solved] = [0, 1, 2].map(|place| length(&signature.arguments[place]));
    let (lane, lanes) = (ident(LANE), number(LANES));
    let statements = statements::of(&Writer::of_helper(facts, helper));
    parse_quote! {
        #doc
        #allow
        #[inline(never)]
        fn #name<R: kane::Real>(#shared: &[R; #n_shared], #sides: &[[R; #lanes]; #n_sides]) -> [[R; #lanes]; #n_solved] {
            let mut #solved = [#sides[0]; #n_solved];
            for #lane in 0..#lanes {
                #(#statements)*
            }
            #solved
        }
    }
}

fn length(argument: &Declared) -> Literal {
    match argument.lengths[..] {
        [Length::Number(length)] => number(length),
        _ => unreachable!("printers: a helper's arguments are arrays of known length"),
    }
}

fn number(number: usize) -> Literal {
    Literal::usize_unsuffixed(number)
}

/// The call of a helper of a function: on what columns share, and on rows of what they do not.
pub(super) fn call(writer: &Writer<'_>, helper: usize, shared: &str, sides: &[Expression]) -> Expr {
    let rows = sides.chunks(LANES).map(|row| {
        let row = row.iter().map(|side| writer.expression(side));
        syntax::array(row)
    });
    let name: Ident = ident(&format!("{}_lockstep_{}", writer.of, helper + 1));
    let (shared, sides) = (ident(shared), syntax::array(rows));
    let call = quote!(self::#name(&#shared, &#sides));
    syn::parse2(call).unwrap_or_else(|error| unreachable!("printers: a call is no syntax: {error}"))
}
