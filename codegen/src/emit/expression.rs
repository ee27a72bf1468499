//! Expressions: built as syntax, never spliced as tokens, so that no parenthesis is lost.

use syn::{
    BinOp, Expr,
    token::{Minus, Plus, Slash, Star},
};

use super::{ident, syntax};
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
        let (plus, minus) = (Plus::default(), Minus::default());
        match operation {
            Operation::Add(a, b) if b.is_negative() => {
                syntax::binary(self.left_of_sum(a), BinOp::Sub(minus), self.factor(-b))
            }
            Operation::Add(a, b) => {
                syntax::binary(self.left_of_sum(a), BinOp::Add(plus), self.right_of_sum(b))
            }
            Operation::Mul(a, b) => syntax::binary(
                self.left_of_product(a),
                BinOp::Mul(Star::default()),
                self.atom(b),
            ),
            Operation::Div(a, b) => syntax::binary(
                self.left_of_product(a),
                BinOp::Div(Slash::default()),
                self.atom(b),
            ),
            Operation::MulAdd(a, b, c) => self.call("mul_add", &[a, b, c]),
            Operation::Abs(a) => self.call("abs", &[a]),
            Operation::Neg(a) => self.negated(a),
        }
    }

    /// A function of `R`.
    pub(super) fn call(&self, function: &str, arguments: &[Operand]) -> Expr {
        let arguments = arguments.iter().map(|&argument| self.operand(argument));
        syntax::call(syntax::of_scalar(function), arguments)
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
        syntax::negative(self.atom(operand))
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
            Origin::Input(Input::Prepared(_)) => syntax::field(syntax::name(&ident("p")), &name),
            _ => syntax::name(&name),
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
            Some(Operation::Add(..)) => syntax::parenthesised(self.operand(operand)),
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
                syntax::parenthesised(self.operand(operand))
            }
            _ => self.operand(operand),
        }
    }
}

/// A number as a value of R.
pub(super) fn number(value: f64) -> Expr {
    syntax::call(syntax::of_scalar("from_f64"), [syntax::number(value)])
}

/// Where an input is read from.
pub(super) fn input(input: Input, parameters: &[String]) -> Expr {
    let name = |text: &str| syntax::name(&ident(text));
    let field = |base: Expr, field: &str| syntax::field(base, &ident(field));
    let index = syntax::index;
    match input {
        Input::Q(id) => index(name("q"), id.index()),
        Input::Sine(place) => index(field(name("sin_cos"), "sines"), place),
        Input::Cosine(place) => index(field(name("sin_cos"), "cosines"), place),
        Input::U(id) => index(name("u"), id.index()),
        Input::UDot(id) => index(name("u_dot"), id.index()),
        Input::Tau(id) => index(name("tau"), id.index()),
        Input::Force(body, axis) => index(field(index(name("loads"), body.index()), "force"), axis),
        Input::Moment(body, axis) => {
            index(field(index(name("loads"), body.index()), "moment"), axis)
        }
        Input::RelativeAngularVelocity(body, axis) => {
            index(index(name("w_rel"), body.index()), axis)
        }
        Input::Parameter(id) => field(name("parameters"), &parameters[id.index()]),
        Input::Prepared(_) => unreachable!("emit: prepared values are fields, not locals"),
    }
}
