//! What the constants of a module hold.

use syn::{Expr, ExprLit, ExprRepeat, File, Item, Lit, Member};

/// More than any array of a module has: a length is only read, and may be anything.
const MOST_ENTRIES: u64 = 1_000_000;

/// The value of a constant.
pub(super) fn constant<'f>(file: &'f File, name: &str) -> Option<&'f Expr> {
    file.items.iter().find_map(|item| match item {
        Item::Const(constant) if constant.ident == name => Some(&*constant.expr),
        _ => None,
    })
}

/// The entries of a constant, `[x; N]` too; none where it is not there.
pub(super) fn list<'f>(file: &'f File, name: &str) -> Vec<&'f Expr> {
    match constant(file, name) {
        Some(Expr::Repeat(list)) => repeated(file, list),
        Some(list) => entries(list),
        None => Vec::new(),
    }
}

/// The entries of `[x; N]`; none where no constant has its length, or an absurd one.
fn repeated<'f>(file: &'f File, list: &'f ExprRepeat) -> Vec<&'f Expr> {
    let length = match &*list.len {
        Expr::Path(path) => path.path.get_ident(),
        _ => None,
    };
    let length = length.map(ToString::to_string);
    let length = length.and_then(|name| constant(file, &name));
    let length = integer(length.unwrap_or(&list.len)).filter(|&length| length <= MOST_ENTRIES);
    let length = length.and_then(|length| usize::try_from(length).ok());
    vec![&*list.expr; length.unwrap_or(0)]
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
