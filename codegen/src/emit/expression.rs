//! Expressions: built as syntax, never spliced as tokens, so that no parenthesis is lost.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::{
    BinOp, Expr, ExprBinary, ExprParen, ExprUnary, LitFloat, UnOp, parse_quote,
    token::{Minus, Paren},
};

use super::ident;
use crate::{
    expr::Input,
    program::{Groups, Operand, Operation, Origin, Program, ValueId},
};

/// A program's names and groups, from which its expressions are built.
pub(super) struct Writer<'a> {
    pub(super) program: &'a Program,
    pub(super) groups: &'a Groups,
    pub(super) names: &'a [String],
}

impl Writer<'_> {
    /// An operation, with the operations that stand inside it.
    pub(super) fn operation(&self, operation: Operation) -> Expr {
        match operation {
            Operation::Add(a, b) if b.is_negative() => {
                binary(self.left_of_sum(a), parse_quote!(-), self.factor(-b))
            }
            Operation::Add(a, b) => {
                binary(self.left_of_sum(a), parse_quote!(+), self.right_of_sum(b))
            }
            Operation::Mul(a, b) => binary(self.left_of_product(a), parse_quote!(*), self.atom(b)),
            Operation::Div(a, b) => binary(self.left_of_product(a), parse_quote!(/), self.atom(b)),
            Operation::MulAdd(a, b, c) => {
                let [a, b, c] = [a, b, c].map(|operand| self.operand(operand));
                parse_quote!(R::mul_add(#a, #b, #c))
            }
            Operation::Abs(a) => {
                let a = self.operand(a);
                parse_quote!(R::abs(#a))
            }
            Operation::Neg(a) => self.negated(a),
        }
    }

    /// A number, a name, or the negative of one.
    pub(super) fn operand(&self, operand: Operand) -> Expr {
        match operand {
            Operand::Number(value) => number(value),
            Operand::Value {
                id,
                negative: false,
            } => self.value(id),
            Operand::Value { id, negative: true } => self.negated(Operand::Value {
                id,
                negative: false,
            }),
        }
    }

    fn negated(&self, operand: Operand) -> Expr {
        let expr = Box::new(self.atom(operand));
        Expr::Unary(ExprUnary {
            attrs: Vec::new(),
            op: UnOp::Neg(Minus::default()),
            expr,
        })
    }

    /// The values with names of their own that an operation and those inside it read, in order.
    pub(super) fn read_by(&self, operation: Operation, read: &mut Vec<ValueId>) {
        for id in operation.operands().filter_map(Operand::value) {
            match self.groups.inlined(id) {
                Some(inner) => self.read_by(inner, read),
                None => read.push(id),
            }
        }
    }

    fn value(&self, id: ValueId) -> Expr {
        if let Some(operation) = self.groups.inlined(id) {
            return self.operation(operation);
        }
        let name = ident(&self.names[id.index()]);
        match self.program.value(id).origin {
            Origin::Input(Input::Prepared(_)) => parse_quote!(p.#name),
            _ => parse_quote!(#name),
        }
    }

    /// The operation of an operand that is written in place.
    fn inner(&self, operand: Operand) -> Option<Operation> {
        operand.value().and_then(|id| self.groups.inlined(id))
    }

    fn left_of_sum(&self, operand: Operand) -> Expr {
        self.operand(operand)
    }

    /// Right of a plus: a sum keeps its parentheses, for its association.
    fn right_of_sum(&self, operand: Operand) -> Expr {
        self.factor(operand)
    }

    /// Where a product may stand bare but a sum may not.
    fn factor(&self, operand: Operand) -> Expr {
        match self.inner(operand) {
            Some(Operation::Add(..)) => parenthesised(self.operand(operand)),
            _ => self.operand(operand),
        }
    }

    /// Left of a times: a product may stand bare, its association is the same.
    fn left_of_product(&self, operand: Operand) -> Expr {
        self.factor(operand)
    }

    /// Where no operation may stand bare.
    fn atom(&self, operand: Operand) -> Expr {
        match self.inner(operand) {
            Some(Operation::Add(..) | Operation::Mul(..) | Operation::Div(..)) => {
                parenthesised(self.operand(operand))
            }
            _ => self.operand(operand),
        }
    }
}

/// The magnitude of a number: the shortest text that reads back bit for bit.
pub(super) fn digits(value: f64) -> LitFloat {
    let digits = syn::parse_str::<LitFloat>(&format!("{:?}", value.abs()));
    digits.expect("emit: Debug of a finite f64 is a literal")
}

/// A number as a value of R.
pub(super) fn number(value: f64) -> Expr {
    let digits = digits(value);
    if value < 0.0 {
        parse_quote!(R::from_f64(-#digits))
    } else {
        parse_quote!(R::from_f64(#digits))
    }
}

/// Where an input is read from.
pub(super) fn input(input: Input, parameters: &[String]) -> TokenStream {
    let literal = Literal::usize_unsuffixed;
    match input {
        Input::Q(id) => index("q", &literal(id.index())),
        Input::Sine(place) => given_sine("sines", place),
        Input::Cosine(place) => given_sine("cosines", place),
        Input::U(id) => index("u", &literal(id.index())),
        Input::UDot(id) => index("u_dot", &literal(id.index())),
        Input::Tau(id) => index("tau", &literal(id.index())),
        Input::Force(body, axis) => {
            let (body, axis) = (literal(body.index()), literal(axis));
            quote!(loads[#body].force[#axis])
        }
        Input::Moment(body, axis) => {
            let (body, axis) = (literal(body.index()), literal(axis));
            quote!(loads[#body].moment[#axis])
        }
        Input::RelativeAngularVelocity(body, axis) => {
            let (body, axis) = (literal(body.index()), literal(axis));
            quote!(w_rel[#body][#axis])
        }
        Input::Parameter(id) => {
            let field = ident(&parameters[id.index()]);
            quote!(parameters.#field)
        }
        Input::Prepared(_) => unreachable!("emit: prepared values are fields, not locals"),
    }
}

fn given_sine(array: &str, place: usize) -> TokenStream {
    let (array, place) = (ident(array), Literal::usize_unsuffixed(place));
    quote!(sin_cos.#array[#place])
}

fn index(array: &str, place: &Literal) -> TokenStream {
    let array = ident(array);
    quote!(#array[#place])
}

fn binary(left: Expr, op: BinOp, right: Expr) -> Expr {
    Expr::Binary(ExprBinary {
        attrs: Vec::new(),
        left: Box::new(left),
        op,
        right: Box::new(right),
    })
}

fn parenthesised(expr: Expr) -> Expr {
    Expr::Paren(ExprParen {
        attrs: Vec::new(),
        paren_token: Paren::default(),
        expr: Box::new(expr),
    })
}
