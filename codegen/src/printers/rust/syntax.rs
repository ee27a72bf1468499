//! Syntax built part by part, for what a function has thousands of: it would cost more to parse than to derive.

use proc_macro2::Span;
use syn::{
    BinOp, Expr, ExprArray, ExprAssign, ExprBinary, ExprCall, ExprField, ExprIndex, ExprInfer,
    ExprLit, ExprParen, ExprPath, ExprReference, ExprTuple, ExprUnary, Ident, Lit, LitFloat,
    LitInt, Local, LocalInit, LocalModifiers, Pat, PatIdent, PatTuple, PatWild, Path, Stmt, UnOp,
    punctuated::Punctuated,
    token::{And, Bracket, Dot, Eq, Let, Minus, Mut, Paren, PathSep, Semi, Star, Underscore},
};

/// A name.
pub(super) fn name(name: &Ident) -> Expr {
    path([name.clone()].into_iter())
}

/// What `R` has under this name.
pub(super) fn of_scalar(function: &str) -> Expr {
    let function = Ident::new(function, Span::call_site());
    path([Ident::new("R", Span::call_site()), function].into_iter())
}

/// An item of the module itself.
pub(super) fn of_module(name: &Ident) -> Expr {
    path([Ident::new("self", Span::call_site()), name.clone()].into_iter())
}

fn path(segments: impl Iterator<Item = Ident>) -> Expr {
    let mut path = Path {
        leading_colon: None,
        segments: Punctuated::<_, PathSep>::new(),
    };
    path.segments.extend(segments.map(syn::PathSegment::from));
    Expr::Path(ExprPath {
        attrs: Vec::new(),
        qself: None,
        path,
    })
}

/// `function(arguments)`.
pub(super) fn call(function: Expr, arguments: impl IntoIterator<Item = Expr>) -> Expr {
    Expr::Call(ExprCall {
        attrs: Vec::new(),
        func: Box::new(function),
        paren_token: Paren::default(),
        args: arguments.into_iter().collect(),
    })
}

/// `base.field`.
pub(super) fn field(base: Expr, field: &Ident) -> Expr {
    Expr::Field(ExprField {
        attrs: Vec::new(),
        base: Box::new(base),
        dot_token: Dot::default(),
        member: field.clone().into(),
    })
}

/// `base[place]`.
pub(super) fn index(base: Expr, place: usize) -> Expr {
    index_by(base, integer(place))
}

/// The same, by a variable.
pub(super) fn index_by(base: Expr, place: Expr) -> Expr {
    Expr::Index(ExprIndex {
        attrs: Vec::new(),
        expr: Box::new(base),
        bracket_token: Bracket::default(),
        index: Box::new(place),
    })
}

/// `&a`.
pub(super) fn reference(a: Expr) -> Expr {
    borrow(None, a)
}

fn borrow(mutability: Option<Mut>, a: Expr) -> Expr {
    Expr::Reference(ExprReference {
        attrs: Vec::new(),
        and_token: And::default(),
        mutability,
        expr: Box::new(a),
    })
}

/// A number of 16 hexadecimal digits, in groups.
pub(super) fn hexadecimal(value: u64) -> LitInt {
    let groups = [48, 32, 16, 0].map(|shift| format!("{:04x}", value >> shift & 0xffff));
    LitInt::new(&format!("0x{}", groups.join("_")), Span::call_site())
}

/// A whole number.
pub(super) fn integer(value: usize) -> Expr {
    let digits = LitInt::new(&value.to_string(), Span::call_site());
    literal(Lit::Int(digits))
}

/// A finite number: the shortest text that reads back bit for bit.
pub(super) fn number(value: f64) -> Expr {
    let digits = LitFloat::new(&format!("{:?}", value.abs()), Span::call_site());
    let digits = literal(Lit::Float(digits));
    if value < 0.0 {
        negative(digits)
    } else {
        digits
    }
}

fn literal(lit: Lit) -> Expr {
    Expr::Lit(ExprLit {
        attrs: Vec::new(),
        lit,
    })
}

pub(super) fn negative(expr: Expr) -> Expr {
    unary(UnOp::Neg(Minus::default()), expr)
}

pub(super) fn dereferenced(expr: Expr) -> Expr {
    unary(UnOp::Deref(Star::default()), expr)
}

fn unary(op: UnOp, expr: Expr) -> Expr {
    Expr::Unary(ExprUnary {
        attrs: Vec::new(),
        op,
        expr: Box::new(expr),
    })
}

pub(super) fn binary(left: Expr, op: BinOp, right: Expr) -> Expr {
    Expr::Binary(ExprBinary {
        attrs: Vec::new(),
        left: Box::new(left),
        op,
        right: Box::new(right),
    })
}

pub(super) fn parenthesised(expr: Expr) -> Expr {
    Expr::Paren(ExprParen {
        attrs: Vec::new(),
        paren_token: Paren::default(),
        expr: Box::new(expr),
    })
}

pub(super) fn array(elements: impl IntoIterator<Item = Expr>) -> Expr {
    Expr::Array(ExprArray {
        attrs: Vec::new(),
        bracket_token: Bracket::default(),
        elems: elements.into_iter().collect(),
    })
}

/// `let pattern = value;` or `let pattern;`.
pub(super) fn declare(pattern: Pat, value: Option<Expr>) -> Stmt {
    let init = value.map(|value| LocalInit {
        eq_token: Eq::default(),
        expr: Box::new(value),
        diverge: None,
    });
    Stmt::Local(Local {
        attrs: Vec::new(),
        let_token: Let::default(),
        modifiers: LocalModifiers::default(),
        pat: pattern,
        init,
        semi_token: Semi::default(),
    })
}

/// `place = value;`.
pub(super) fn assign(place: Expr, value: Expr) -> Stmt {
    let assign = Expr::Assign(ExprAssign {
        attrs: Vec::new(),
        left: Box::new(place),
        eq_token: Eq::default(),
        right: Box::new(value),
    });
    Stmt::Expr(assign, Some(Semi::default()))
}

/// `kane::store(&mut place, value);`, which joins it with no store after it.
pub(super) fn store(place: Expr, value: Expr) -> Stmt {
    let function = ["kane", "store"].map(|name| Ident::new(name, Span::call_site()));
    let place = borrow(Some(Mut::default()), place);
    let call = call(path(function.into_iter()), [place, value]);
    Stmt::Expr(call, Some(Semi::default()))
}

/// The pattern that takes one value, or a tuple of them; those without a name are dropped.
pub(super) fn pattern(names: &[Option<Ident>]) -> Pat {
    let one = |name: &Option<Ident>| match name {
        Some(name) => Pat::Ident(PatIdent {
            attrs: Vec::new(),
            by_ref: None,
            mutability: None,
            ident: name.clone(),
            subpat: None,
        }),
        None => Pat::Wild(PatWild {
            attrs: Vec::new(),
            underscore_token: Underscore::default(),
        }),
    };
    match names {
        [name] => one(name),
        names => Pat::Tuple(PatTuple {
            attrs: Vec::new(),
            paren_token: Paren::default(),
            elems: names.iter().map(one).collect(),
        }),
    }
}

/// As [`pattern`], where the names are declared already.
pub(super) fn places(names: &[Option<Ident>]) -> Expr {
    let one = |place: &Option<Ident>| match place {
        Some(place) => name(place),
        None => Expr::Infer(ExprInfer {
            attrs: Vec::new(),
            underscore_token: Underscore::default(),
        }),
    };
    match names {
        [name] => one(name),
        names => Expr::Tuple(ExprTuple {
            attrs: Vec::new(),
            paren_token: Paren::default(),
            elems: names.iter().map(one).collect(),
        }),
    }
}
