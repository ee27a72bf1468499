//! Expressions: built as syntax, never spliced as tokens, so that no parenthesis is lost.

use proc_macro2::Ident;
use syn::{
    BinOp, Expr,
    token::{Minus, Plus, Slash, Star},
};

use super::{syntax, text::ident};
use crate::{
    functions::Declared,
    listing::{
        Array, Code, Entry, Expression, Facts, Function, Helper, LocalId, Member, Role, Stage,
        Step, Tightness,
    },
};

/// What counts the columns of a helper.
pub(super) const LANE: &str = "lane";

/// What a loop keeps for later ones, at this place.
pub(super) fn kept_by_lane(stage: &Stage, place: usize) -> Expr {
    let kept = syntax::name(&ident(&stage.keeps));
    syntax::index_by(syntax::index(kept, place), syntax::name(&ident(LANE)))
}

/// What a function's names are known from.
pub(super) struct Writer<'a> {
    pub(super) facts: &'a Facts,
    /// What entries stand in.
    arguments: Vec<&'a Declared>,
    pub(super) code: &'a Code,
    /// The stages of the function, where this is one.
    stages: &'a [Stage],
    /// What the function runs on several columns.
    helpers: &'a [Helper],
    /// What the arguments are of a helper, which takes one column after the other.
    roles: Option<Vec<Role>>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(facts: &'a Facts, function: &'a Function) -> Self {
        Self {
            facts,
            arguments: function.places().collect(),
            code: &function.code,
            stages: &[],
            helpers: &function.helpers,
            roles: None,
        }
    }

    pub(super) fn of_helper(facts: &'a Facts, helper: &'a Helper) -> Self {
        Self {
            facts,
            arguments: helper.signature.arguments.iter().collect(),
            code: &helper.code,
            stages: &[],
            helpers: &[],
            roles: Some(helper.roles.clone()),
        }
    }

    pub(super) fn of_stage(facts: &'a Facts, function: &'a Function, stage: &'a Stage) -> Self {
        Self {
            arguments: stage.signature.arguments.iter().collect(),
            code: &stage.code,
            stages: &function.stages,
            ..Self::new(facts, function)
        }
    }

    /// A loop of a helper.
    pub(super) fn of_loop(facts: &'a Facts, helper: &'a Helper, stage: &'a Stage) -> Self {
        let roles = stage.given.iter().map(|&place| helper.roles[place]);
        Self {
            arguments: stage.signature.arguments.iter().collect(),
            code: &stage.code,
            stages: &helper.loops,
            roles: Some(roles.collect()),
            ..Self::of_helper(facts, helper)
        }
    }

    pub(super) fn expression(&self, expression: &Expression) -> Expr {
        let infix = |[left, right]: &[Expression; 2], op, bindings: [Tightness; 2]| {
            let [left, right] = [(left, bindings[0]), (right, bindings[1])]
                .map(|(operand, binding)| self.bound(operand, binding));
            syntax::binary(left, op, right)
        };
        // Right of a sign a sum keeps its parentheses, and a product right of a times, for their association.
        let in_sum = [Tightness::Sum, Tightness::Product];
        let in_product = [Tightness::Product, Tightness::Whole];
        match expression {
            Expression::Number(value) => number(*value),
            Expression::Local(id) => syntax::name(&self.local(*id)),
            Expression::Element(id, place) => {
                let Array { name, row, .. } = self.code.array(*id);
                let array = syntax::name(&ident(name));
                match row {
                    Some(row) => syntax::index(syntax::index(array, place / row), place % row),
                    None => syntax::index(array, *place),
                }
            }
            Expression::Entry(entry) => self.entry(entry),
            Expression::Kept(stage, place) if self.roles.is_some() => {
                kept_by_lane(&self.stages[*stage], *place)
            }
            Expression::Kept(stage, place) => {
                let stage = &self.stages[*stage];
                let kept = syntax::name(&ident(&stage.keeps));
                syntax::field(kept, &ident(&stage.kept[*place].name))
            }
            Expression::Negative(a) => syntax::negative(self.bound(a, Tightness::Whole)),
            Expression::Absolute(a) => self.call("abs", std::slice::from_ref(a)),
            Expression::Sum(both) => infix(both, BinOp::Add(Plus::default()), in_sum),
            Expression::Difference(both) => infix(both, BinOp::Sub(Minus::default()), in_sum),
            Expression::Product(both) => infix(both, BinOp::Mul(Star::default()), in_product),
            Expression::Quotient(both) => infix(both, BinOp::Div(Slash::default()), in_product),
            Expression::Fused(all) => self.call("mul_add", all.as_slice()),
        }
    }

    /// In parentheses, where it would fall apart.
    fn bound(&self, expression: &Expression, binding: Tightness) -> Expr {
        let expr = self.expression(expression);
        if expression.tightness() < binding {
            syntax::parenthesised(expr)
        } else {
            expr
        }
    }

    /// The call of a helper: on what columns share, and on rows of what they do not.
    pub(super) fn helped<'b>(&self, helper: usize, given: impl Iterator<Item = &'b usize>) -> Expr {
        let name = ident(&self.helpers[helper].signature.name);
        let given = given.map(|&place| self.lent(place));
        syntax::call(syntax::of_module(&name), given)
    }

    /// A function of `R`.
    pub(super) fn call(&self, function: &str, arguments: &[Expression]) -> Expr {
        let arguments = arguments.iter().map(|argument| self.expression(argument));
        syntax::call(syntax::of_scalar(function), arguments)
    }

    /// An argument, lent to a call: a function's own array is no reference, that of a stage is.
    fn lent(&self, place: usize) -> Expr {
        let name = syntax::name(&ident(&self.arguments[place].name));
        if self.stages.is_empty() {
            syntax::reference(name)
        } else {
            name
        }
    }

    pub(super) fn local(&self, id: LocalId) -> Ident {
        ident(&self.code.local(id).name)
    }

    /// Where a number of an argument stands.
    pub(super) fn entry(&self, entry: &Entry) -> Expr {
        let declared = self.arguments[entry.argument];
        let argument = syntax::name(&ident(&declared.name));
        if entry.steps.is_empty() {
            return syntax::dereferenced(argument);
        }
        let steps = entry.steps.iter();
        let number = steps.fold(argument, |base, step| match *step {
            Step::Index(place) => syntax::index(base, place),
            Step::Member(member) => syntax::field(base, &ident(self.member(member))),
        });
        let role = self.roles.as_ref().map(|roles| roles[entry.argument]);
        match role {
            None | Some(Role::Shared) => number,
            Some(Role::Sides | Role::Solved) => {
                syntax::index_by(number, syntax::name(&ident(LANE)))
            }
        }
    }

    fn member(&self, member: Member) -> &str {
        match member {
            Member::Force => "force",
            Member::Moment => "moment",
            Member::Sines => "sines",
            Member::Cosines => "cosines",
            Member::Parameter(place) => &self.facts.parameters[place].name,
            Member::Prepared(place) => &self.facts.fields[place],
        }
    }
}

/// A number as a value of R.
fn number(value: f64) -> Expr {
    syntax::call(syntax::of_scalar("from_f64"), [syntax::number(value)])
}
