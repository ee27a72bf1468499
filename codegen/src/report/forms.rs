//! Why much of a long function's text changed where its model hardly did: helpers and stages that came or went, inputs in which alike
//! branches or columns differ, and how values are declared.
//!
//! In: two modules. Out: each function of both with what of this changed. Operations are told by `compare`.

use std::{collections::BTreeMap, iter};

use syn::{Expr, File, FnArg, Item, ItemFn, Lit, Pat, Stmt, Type, Visibility};

use crate::{
    functions::{HELPER_INFIX, STAGE_INFIX},
    listing::Role,
};

/// A function that is written in another form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FormChange {
    /// The function's name.
    pub name: String,
    /// What changed of its form, one reason each.
    pub reasons: Vec<String>,
}

/// Compares the forms of the public functions that two modules have.
pub(super) fn forms(old: &Forms, new: &Forms) -> Vec<FormChange> {
    let changed = old.iter().filter_map(|(name, old)| {
        let reasons = reasons(old, new.get(name)?);
        let name = name.clone();
        (!reasons.is_empty()).then_some(FormChange { name, reasons })
    });
    changed.collect()
}

/// Of each public function.
pub(super) type Forms = BTreeMap<String, Form>;

/// How a function is written.
#[derive(Debug, Default)]
pub(super) struct Form {
    /// By their numbers.
    helpers: BTreeMap<usize, Helper>,
    n_stages: usize,
    /// True where values are declared before they are computed, several at once.
    are_together: bool,
}

/// What a helper is run on.
#[derive(Debug)]
struct Helper {
    lanes: usize,
    /// What each lane has of its own.
    inputs: usize,
}

pub(super) fn of_file(file: &File) -> Forms {
    let items = file.items.iter().filter_map(|item| match item {
        Item::Fn(function) => Some(function),
        _ => None,
    });
    let (public, private): (Vec<_>, Vec<_>) =
        items.partition(|function| matches!(function.vis, Visibility::Public(_)));
    let form = |function: &ItemFn| {
        let form = Form {
            are_together: function.block.stmts.iter().any(declares_several),
            ..Form::default()
        };
        (function.sig.ident.to_string(), form)
    };
    let mut forms: Forms = public.into_iter().map(form).collect();
    for function in private {
        let name = function.sig.ident.to_string();
        if let Some((form, number)) = part_of(&mut forms, &name, HELPER_INFIX) {
            form.helpers
                .extend(helper(function).map(|own| (number, own)));
        } else if let Some((form, _)) = part_of(&mut forms, &name, STAGE_INFIX) {
            form.n_stages += 1;
            form.are_together |= function.block.stmts.iter().any(declares_several);
        }
    }
    forms
}

/// The function that a helper or stage of this name is part of, and its number there.
fn part_of<'a>(forms: &'a mut Forms, name: &str, infix: &str) -> Option<(&'a mut Form, usize)> {
    let (of, number) = name.rsplit_once(infix)?;
    Some((forms.get_mut(of)?, number.parse().ok()?))
}

fn declares_several(statement: &Stmt) -> bool {
    match statement {
        Stmt::Local(local) => local.init.is_none() && matches!(local.pat, Pat::Tuple(_)),
        _ => false,
    }
}

/// Of `sides: &[[R; 4]; 21]` the numbers.
fn helper(function: &ItemFn) -> Option<Helper> {
    let mut arguments = function.sig.inputs.iter();
    let sides = arguments.find_map(|argument| match argument {
        FnArg::Typed(typed) => match &*typed.pat {
            Pat::Ident(name) if name.ident == Role::Sides.name() => Some(&*typed.ty),
            _ => None,
        },
        FnArg::Receiver(_) => None,
    });
    let Type::Reference(sides) = sides? else {
        return None;
    };
    let (lanes, inputs) = array(&sides.elem)?;
    let (_, lanes) = array(lanes)?;
    Some(Helper { lanes, inputs })
}

/// The entries of an array, and how many these are.
fn array(of: &Type) -> Option<(&Type, usize)> {
    let Type::Array(array) = of else {
        return None;
    };
    let Expr::Lit(length) = &array.len else {
        return None;
    };
    let Lit::Int(length) = &length.lit else {
        return None;
    };
    Some((&array.elem, length.base10_parse().ok()?))
}

fn reasons(old: &Form, new: &Form) -> Vec<String> {
    let mut reasons = Vec::new();
    let mut count = |what: &str, old: usize, new: usize| {
        if old != new {
            reasons.push(format!("{what}: {old} -> {new}"));
        }
    };
    count("helpers", old.helpers.len(), new.helpers.len());
    count("stages", old.n_stages, new.n_stages);
    // Where one came or went, others have its number.
    if old.helpers.len() == new.helpers.len() {
        let pairs = || iter::zip(&old.helpers, &new.helpers);
        let changed = |of: fn(&Helper) -> usize| -> Vec<String> {
            let numbers = pairs().map(|((number, old), (_, new))| (number, of(old), of(new)));
            let numbers = numbers.filter(|(_, old, new)| old != new);
            let infix = HELPER_INFIX.trim_start_matches('_');
            let told =
                numbers.map(|(number, old, new)| format!("{old} -> {new} in {infix}{number}"));
            told.collect()
        };
        let lanes = changed(|helper| helper.lanes);
        let inputs = changed(|helper| helper.inputs);
        let told = [
            ("branches or columns side by side", lanes),
            ("inputs in which branches or columns differ", inputs),
        ];
        let told = told.into_iter().filter(|(_, list)| !list.is_empty());
        reasons.extend(told.map(|(what, list)| format!("{what}: {}", list.join(", "))));
    }
    let declared = match (old.are_together, new.are_together) {
        (false, true) => {
            Some("values are declared in groups, because rustc's stack limits single declarations")
        }
        (true, false) => {
            Some("values are declared one by one, because rustc's stack allows it again")
        }
        _ => None,
    };
    reasons.extend(declared.map(str::to_owned));
    reasons
}
