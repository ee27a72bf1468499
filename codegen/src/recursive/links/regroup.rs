//! Base inertial parameters: what a joint does not move of a link's inertia is given to its lower link.
//!
//! A link that only turns moves a mass on its axis as its lower link does, so mass, first moment and second moment along the
//! axis may stand there as well: three numbers fewer for the link (Khalil and Kleinfinger 1987), and no more for a lower link
//! that has all ten.

use super::{
    inertia::{Composite, LinkInertia},
    passage::Passage,
    rotation::{ConstantRotation, Turn},
    rounding,
};
use crate::{
    expr::{Axis, ExprGraph},
    id::{BodyId, BodyMap},
    recursive::{
        plan::{Plan, Regroup},
        technique::Technique,
    },
    tree::Tree,
};

/// The links' own inertias, regrouped from the leaves inward.
pub(in crate::recursive) fn regrouped(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    passages: &BodyMap<Passage>,
    own: BodyMap<LinkInertia>,
) -> BodyMap<LinkInertia> {
    let mut regrouping = Regrouping {
        tree,
        plan,
        passages,
        inertias: own,
    };
    for body in tree.body_ids().rev() {
        regrouping.regroup(graph, body);
    }
    regrouping.inertias
}

struct Regrouping<'a> {
    tree: &'a Tree,
    plan: &'a Plan,
    passages: &'a BodyMap<Passage>,
    /// Regrouped already, on the bodies that come before; the others have what those gave them.
    inertias: BodyMap<LinkInertia>,
}

impl Regrouping<'_> {
    /// Gives the lower link what the joint does not move of a link's inertia.
    fn regroup(&mut self, graph: &mut ExprGraph, body: BodyId) {
        let lower = self.tree.lower(body);
        // Of a body without mass more would be needed than is saved.
        let has_mass = |body: BodyId| !graph.is_zero(self.inertias[body].composite.mass);
        if !lower.is_none_or(has_mass) {
            return;
        }
        graph.enter(body);
        let joint = &self.tree.body(body).joint;
        let (passage, own) = (&self.passages[body], &self.inertias[body]);
        let (kept, given) = match (self.plan.regroup(body), joint.hinge_axis()) {
            (Regroup::None, _) => return,
            (choice, Some(axis)) => {
                let (kept, given) = split_on_axis(graph, axis, choice, own);
                let turned = passage.constant.backward_composite(graph, &given);
                (kept, turned.moved(graph, passage.offset))
            }
            (_, None) if joint.only_translates() => split_tensor(graph, &passage.constant, own),
            _ => return,
        };
        self.inertias[body] = kept;
        let Some(lower) = lower else {
            return;
        };
        graph.enter(lower);
        let below = self.inertias[lower].composite.plus(graph, &given);
        self.inertias[lower] = LinkInertia::new(graph, below);
        if self.plan.uses(Technique::Balance) && joint.hinge_axis().is_some() {
            self.balance(graph, body, lower);
        }
    }

    /// Takes back so much of a mass on the axis that the lower link's first moment has no part along the way to it, where that
    /// is no multiple of what there is. Of the bodies on the lower link the lowest-numbered does so, which is met last.
    fn balance(&mut self, graph: &mut ExprGraph, body: BodyId, lower: BodyId) {
        let is_last = self.tree.uppers(lower).first() == Some(&body);
        let own = self.tree.body(lower).joint.turning_axis();
        let offset = self.passages[body].offset;
        let below = self.inertias[lower].composite;
        let moments = rounding::without_crumbs(graph, below.moment, below.moment);
        let Some(total) = graph.as_number(below.mass).filter(|_| is_last) else {
            return;
        };
        let numbers = |graph: &ExprGraph, axis: usize| {
            let moment = graph.as_number(moments[axis])?;
            let distance = graph.as_number(offset[axis]).filter(|d| *d != 0.0)?;
            let kept = moment / distance;
            (moment != 0.0 && kept.abs() <= MOST_KEPT * total.abs()).then_some(kept)
        };
        let mut axes = Axis::ALL.into_iter().filter(|axis| Some(*axis) != own);
        let found = axes.find_map(|axis| Some((axis.index(), numbers(graph, axis.index())?)));
        let Some((axis, kept)) = found else {
            return;
        };
        let taken = graph.number(-kept);
        let taken = Composite::point(graph, taken).moved(graph, offset);
        let mut inertia = below.plus(graph, &taken);
        inertia.moment[axis] = graph.zero();
        self.inertias[lower] = LinkInertia::new(graph, inertia);
        self.inertias[body].composite.mass = graph.number(kept);
    }
}

/// What a link keeps that turns, and what it gives of what lies on its axis, along the joint's axes: a mass, its first moment,
/// and its second moment.
fn split_on_axis(
    graph: &mut ExprGraph,
    axis: Axis,
    choice: Regroup,
    own: &LinkInertia,
) -> (LinkInertia, Composite) {
    let (a, (b, c)) = (axis.index(), axis.others());
    let mut inertia = own.composite;
    let along = match choice {
        Regroup::None => graph.zero(),
        Regroup::Second => own.second[a],
        Regroup::First => inertia.inertia.diagonal[b],
        Regroup::Last => inertia.inertia.diagonal[c],
    };
    let mut given = Composite::point(graph, inertia.mass);
    given.moment[a] = inertia.moment[a];
    let zero = graph.zero();
    inertia.mass = zero;
    inertia.moment[a] = zero;
    for across in [b, c] {
        given.inertia.diagonal[across] = along;
        let rest = graph.sub(inertia.inertia.diagonal[across], along);
        inertia.inertia.diagonal[across] = rest;
    }
    let mut kept = LinkInertia::new(graph, inertia);
    if choice == Regroup::Second {
        kept.second[a] = zero;
    }
    (kept, given)
}

/// What a link keeps that only translates, and what it gives, along the lower link's axes: all inertia but mass and first
/// moment, for it turns as that does.
fn split_tensor(
    graph: &mut ExprGraph,
    constant: &ConstantRotation,
    own: &LinkInertia,
) -> (LinkInertia, Composite) {
    let given = Composite {
        inertia: constant.backward_symmetric(graph, &own.composite.inertia),
        ..Composite::zero(graph)
    };
    let rest = Composite {
        inertia: graph.zero_symmetric(),
        ..own.composite
    };
    (LinkInertia::new(graph, rest), given)
}

/// How many times the mass that there is may be kept on an axis: what is added and taken away must not drown the rest.
const MOST_KEPT: f64 = 4.0;
