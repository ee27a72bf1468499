//! Which branch each value belongs to, and which values of different branches are alike.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::{
    alike::{Branch, Branches},
    givens::{Given, Givens},
};
use crate::{
    expr::{CallId, CallResult, Expr, ExprGraph, Input, Node, NodeId},
    id::BodyId,
};

/// What is known before the loop, whichever number it is.
const KNOWN: u32 = 0;

/// What is known of each node of a graph.
pub(super) struct Traced {
    /// The branch that it belongs to, where it belongs to one.
    pub(super) branches: Vec<Option<Branch>>,
    /// What it is, but for numbers, signs and the lane: nodes of a colour are alike.
    pub(super) colors: Vec<u32>,
    /// Whether it is needed.
    pub(super) needed: Vec<bool>,
}

/// A lane of a call.
type Column = (CallId, u16);

/// What makes a colour.
#[derive(PartialEq, Eq, Hash)]
enum Kind {
    /// An input of a branch: its team, argument, body and place.
    Given([usize; 4]),
    /// What a column of a call computed for a body of a branch: its team, the body's place, and its own among those of the body.
    Called(Column, [usize; 3]),
    /// What has no like.
    Itself(NodeId),
    /// An operation on operands of these colours.
    Operation(&'static str, [u32; 2]),
}

/// What columns of calls compute, body by body.
struct Called {
    /// The branch of each body that is in one, and its place there.
    bodies: BTreeMap<BodyId, (Branch, usize)>,
    /// How many numbers of a column of a body were met.
    n_own: FxHashMap<(Column, BodyId), usize>,
}

impl Called {
    /// What the next number of a body is, where the body is in a branch.
    fn get(&mut self, body: Option<BodyId>, result: CallResult) -> Option<(Kind, Branch)> {
        let body = body?;
        let &(branch, place) = self.bodies.get(&body)?;
        let column = (result.call, result.lane);
        let n_own = self.n_own.entry((column, body)).or_insert(0);
        *n_own += 1;
        Some((Kind::Called(column, [branch.team, place, *n_own]), branch))
    }
}

impl Traced {
    pub(super) fn of(
        branches: &Branches,
        givens: &Givens,
        graph: &ExprGraph,
        roots: &[Expr],
    ) -> Self {
        let mut known: FxHashMap<Kind, u32> = FxHashMap::default();
        let mut called = Called {
            bodies: branches.by_body(),
            n_own: FxHashMap::default(),
        };
        let mut traced = Self {
            branches: vec![None; graph.len()],
            colors: vec![KNOWN; graph.len()],
            needed: graph.reachable(roots),
        };
        for id in graph.ids().filter(|id| traced.needed[id.index()]) {
            let node = graph.node(id);
            let (kind, branch) = match node {
                Node::Number(_) | Node::Input(Input::Parameter(_) | Input::Prepared(_)) => continue,
                Node::Input(Input::CallResult(result)) => match called.get(graph.scope(id), result)
                {
                    Some((kind, branch)) => (kind, Some(branch)),
                    None => (Kind::Itself(id), None),
                },
                Node::Input(input) => match givens.get(input) {
                    Some(given) => (Kind::given(given), Some(given.branch)),
                    None => (Kind::Itself(id), None),
                },
                _ => (traced.operation(node), traced.branch(node)),
            };
            let next = u32::try_from(known.len()).expect("passes: fewer colours than nodes") + 1;
            traced.colors[id.index()] = *known.entry(kind).or_insert(next);
            traced.branches[id.index()] = branch;
        }
        traced
    }

    fn operation(&self, node: Node) -> Kind {
        let color = |id: NodeId| self.colors[id.index()];
        let either = |a, b| {
            if color(b) < color(a) {
                [color(b), color(a)]
            } else {
                [color(a), color(b)]
            }
        };
        match node {
            Node::Number(_) | Node::Input(_) => unreachable!("passes: no operation"),
            Node::Sin(a) => Kind::Operation("sin", [color(a); 2]),
            Node::Cos(a) => Kind::Operation("cos", [color(a); 2]),
            Node::Abs(a) => Kind::Operation("abs", [color(a); 2]),
            Node::Add(a, b) => Kind::Operation("add", either(a.node(), b.node())),
            Node::Mul(a, b) => Kind::Operation("mul", either(a, b)),
            Node::Div(a, b) => Kind::Operation("div", [color(a), color(b)]),
        }
    }

    /// The branch that all operands which belong to one belong to.
    fn branch(&self, node: Node) -> Option<Branch> {
        let mut branches = node.operands().filter_map(|id| self.branches[id.index()]);
        let first = branches.next()?;
        branches.all(|own| own == first).then_some(first)
    }
}

impl Kind {
    fn given(given: Given) -> Self {
        let Given {
            branch,
            argument,
            body,
            place,
        } = given;
        Self::Given([branch.team, argument, body, place])
    }
}
