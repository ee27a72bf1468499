//! What a function runs on several columns: straight lines for one column, which a loop of fixed length repeats.

use proc_macro2::Literal;
use quote::quote;
use syn::{Expr, Item, Stmt, parse_quote};

use super::{
    expression::{LANE, Writer, kept_by_lane},
    statements, syntax,
    text::{allow_generated, doc, ident},
};
use crate::{
    functions::{Declared, Length},
    listing::{Expression, Facts, Function, Helper, Role},
};

/// The helpers of a function, of which nobody else knows.
pub(super) fn items(facts: &Facts, function: &Function) -> impl Iterator<Item = Item> {
    let helpers = function.helpers.iter();
    helpers.map(move |helper| item(facts, helper))
}

/// A helper. What it computes is some numbers first, as scratch is.
fn item(facts: &Facts, helper: &Helper) -> Item {
    let signature = &helper.signature;
    let mut lines = signature.doc.clone();
    lines.push(String::new());
    lines.push("For one of them:".to_owned());
    lines.extend(helper.cost());
    let (doc, allow, name) = (doc(lines), allow_generated(), ident(&signature.name));
    let roles = [Role::Shared, Role::Sides, Role::Solved];
    let [shared, sides, solved] = roles.map(|role| ident(role.name()));
    let [n_shared, n_sides, n_solved] = roles.map(|role| helper.argument(role).map(length));
    let n_shared = n_shared.into_iter();
    let lanes = number_of(helper.lanes);
    let (kept, loops) = (kept(helper), loops(facts, helper));
    let some = some();
    parse_quote! {
        #doc
        #allow
        #[inline(never)]
        fn #name<R: kane::Real>(#(#shared: &[R; #n_shared],)* #sides: &[[R; #lanes]; #n_sides]) -> [[R; #lanes]; #n_solved] {
            let mut #solved = [[#some; #lanes]; #n_solved];
            #(#kept)*
            #(#loops)*
            #solved
        }
    }
}

/// The rows that loops keep for later ones.
fn kept(helper: &Helper) -> Vec<Stmt> {
    let (some, lanes) = (some(), number_of(helper.lanes));
    let keeping = helper.loops.iter().filter(|stage| !stage.kept.is_empty());
    let rows = keeping.map(|stage| {
        let (name, n_kept) = (ident(&stage.keeps), number_of(stage.kept.len()));
        parse_quote!(let mut #name = [[#some; #lanes]; #n_kept];)
    });
    rows.collect()
}

/// The loops over columns. They count along an array: of `0..2` LLVM takes the counter apart, and makes no vectors.
fn loops(facts: &Facts, helper: &Helper) -> Vec<Stmt> {
    let (sides, lane) = (ident(Role::Sides.name()), ident(LANE));
    let of = |statements: Vec<Stmt>| -> Stmt {
        parse_quote! {
            for (#lane, _) in #sides[0].iter().enumerate() {
                #(#statements)*
            }
        }
    };
    if helper.loops.is_empty() {
        return vec![of(statements::of(&Writer::of_helper(facts, helper)))];
    }
    let loops = helper.loops.iter().map(|stage| {
        let writer = Writer::of_loop(facts, helper, stage);
        let keep = |local| {
            let kept = stage.kept.iter();
            let mut kept = kept.map(|own| own.value == Expression::Local(local));
            let place = kept.position(|is_own| is_own)?;
            let value = syntax::name(&writer.local(local));
            Some(syntax::assign(kept_by_lane(stage, place), value))
        };
        of(statements::keeping(&writer, keep))
    });
    loops.collect()
}

fn length(argument: &Declared) -> Literal {
    match argument.lengths[..] {
        [Length::Number(length)] => number_of(length),
        _ => unreachable!("printers: a helper's arguments are arrays of known length"),
    }
}

/// The number that arrays are filled with before they are: not zero, which a compiler would write by a call of `memset`.
fn some() -> Expr {
    syntax::call(syntax::of_scalar("from_f64"), [syntax::number(1.0)])
}

fn number_of(number: usize) -> Literal {
    Literal::usize_unsuffixed(number)
}

/// What a function fills for its calls, before it does.
pub(super) fn scratch(function: &Function) -> Vec<Stmt> {
    let arrays = function.scratch.iter().map(|array| {
        let name = ident(&array.name);
        let number = some();
        let filled = array.lengths.iter().rev();
        let filled = filled.fold(quote!(#number), |row, length| match length {
            Length::Number(length) => {
                let length = number_of(*length);
                quote!([#row; #length])
            }
            Length::Constant(_) | Length::Twice(_) => {
                unreachable!("printers: scratch has known lengths")
            }
        });
        parse_quote!(let mut #name = #filled;)
    });
    arrays.collect()
}
