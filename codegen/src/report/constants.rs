//! What the constants of a module hold.

use syn::{Expr, ExprLit, File, Item, Lit, Member};

/// The value of a constant.
pub(super) fn constant<'f>(file: &'f File, name: &str) -> Option<&'f Expr> {
    file.items.iter().find_map(|item| match item {
        Item::Const(constant) if constant.ident == name => Some(&*constant.expr),
        _ => None,
    })
}

/// The entries of a constant; none where it is not there.
pub(super) fn list<'f>(file: &'f File, name: &str) -> Vec<&'f Expr> {
    constant(file, name).map_or_else(Vec::new, entries)
}

/// The entries of an array.
pub(super) fn entries(list: &Expr) -> Vec<&Expr> {
    match list {
        Expr::Array(list) => list.elems.iter().collect(),
        _ => Vec::new(),
    }
}

/// The text that a literal is.
pub(super) fn string(value: &Expr) -> Option<String> {
    match value {
        Expr::Lit(ExprLit {
            lit: Lit::Str(text),
            ..
        }) => Some(text.value()),
        _ => None,
    }
}

/// The number that a literal is.
pub(super) fn integer(value: &Expr) -> Option<u64> {
    match value {
        Expr::Lit(ExprLit {
            lit: Lit::Int(digits),
            ..
        }) => digits.base10_parse().ok(),
        _ => None,
    }
}

/// The value of a struct's field.
pub(super) fn field<'e>(value: &'e Expr, name: &str) -> Option<&'e Expr> {
    let Expr::Struct(value) = value else {
        return None;
    };
    let mut fields = value.fields.iter();
    let is_named = |member: &Member| matches!(member, Member::Named(own) if own == name);
    let field = fields.find(|field| is_named(&field.member))?;
    Some(&field.expr)
}

/// What stands in `Some(..)`.
pub(super) fn some(value: &Expr) -> Option<&Expr> {
    match value {
        Expr::Call(call) => call.args.first(),
        _ => None,
    }
}
