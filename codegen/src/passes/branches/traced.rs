//! Which branch each value belongs to, and which values of different branches are alike.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::alike::Branches;
use crate::{
    expr::{Expr, ExprGraph, Input, Node, NodeId},
    id::BodyId,
    passes::sines,
    tree::Tree,
};

/// What is known before the loop, whichever number it is.
const KNOWN: u32 = 0;

/// What is known of each node of a graph.
pub(super) struct Traced {
    /// The branch that it belongs to, where it belongs to one.
    pub(super) lanes: Vec<Option<usize>>,
    /// What it is, but for numbers, signs and the branch: nodes of a colour are alike.
    pub(super) colors: Vec<u32>,
    /// Whether it is needed.
    pub(super) needed: Vec<bool>,
}

/// What makes a colour.
#[derive(PartialEq, Eq, Hash)]
enum Kind {
    /// An input of a body of a branch: by what is given, by the body's place there, and by its own place among such.
    Given(&'static str, usize, usize),
    /// What has no like.
    Itself(NodeId),
    /// An operation on operands of these colours.
    Operation(&'static str, [u32; 2]),
}

impl Traced {
    pub(super) fn of(tree: &Tree, branches: &Branches, graph: &ExprGraph, roots: &[Expr]) -> Self {
        let givens = givens(tree);
        let mut known: FxHashMap<Kind, u32> = FxHashMap::default();
        let mut traced = Self {
            lanes: vec![None; graph.len()],
            colors: vec![KNOWN; graph.len()],
            needed: graph.reachable(roots),
        };
        for id in graph.ids().filter(|id| traced.needed[id.index()]) {
            let node = graph.node(id);
            let (kind, lane) = match node {
                Node::Number(_) | Node::Input(Input::Parameter(_) | Input::Prepared(_)) => continue,
                Node::Input(input) => given(branches, &givens, id, input),
                _ => (traced.operation(node), traced.lane(node)),
            };
            let next = u32::try_from(known.len()).expect("passes: fewer colours than nodes") + 1;
            traced.colors[id.index()] = *known.entry(kind).or_insert(next);
            traced.lanes[id.index()] = lane;
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
    fn lane(&self, node: Node) -> Option<usize> {
        let mut lanes = node.operands().filter_map(|id| self.lanes[id.index()]);
        let first = lanes.next()?;
        lanes.all(|lane| lane == first).then_some(first)
    }
}

/// What an input is, and its branch.
fn given(
    branches: &Branches,
    givens: &BTreeMap<Input, (&'static str, BodyId, usize)>,
    id: NodeId,
    input: Input,
) -> (Kind, Option<usize>) {
    let known = givens.get(&input).copied().or(match input {
        Input::Force(body, axis) => Some(("force", body, axis)),
        Input::Moment(body, axis) => Some(("moment", body, axis)),
        Input::RelativeAngularVelocity(body, axis) => Some(("turn", body, axis)),
        _ => None,
    });
    let own = known.and_then(|(what, body, place)| {
        let (lane, of) = branches.place(body)?;
        Some((Kind::Given(what, of, place), Some(lane)))
    });
    own.unwrap_or((Kind::Itself(id), None))
}

/// Whose the inputs are that are numbered over the whole tree: what each is, its body, and its place among such of the body.
fn givens(tree: &Tree) -> BTreeMap<Input, (&'static str, BodyId, usize)> {
    let mut givens = BTreeMap::new();
    for body in tree.body_ids() {
        let joint = &tree.body(body).joint;
        for (place, (_, coordinate)) in joint.coordinates().into_iter().enumerate() {
            givens.insert(Input::Q(coordinate), ("q", body, place));
        }
        for (place, (_, speed)) in joint.speeds().into_iter().enumerate() {
            let inputs = [
                (Input::U(speed), "u"),
                (Input::UDot(speed), "u_dot"),
                (Input::Tau(speed), "tau"),
            ];
            givens.extend(inputs.map(|(input, what)| (input, (what, body, place))));
        }
    }
    for (place, angle) in sines::angles(tree).into_iter().enumerate() {
        let (what, of) = (angle.body, angle.coordinate.index());
        let first = tree.body(what).joint.coordinates();
        let first = first.iter().map(|(_, own)| own.index()).min().unwrap_or(of);
        givens.insert(Input::Sine(place), ("sine", what, of - first));
        givens.insert(Input::Cosine(place), ("cosine", what, of - first));
    }
    givens
}
