//! Base inertial parameters: what a joint does not move of a link's inertia is given to its lower link.
//!
//! A link that only turns moves a mass on its axis as its lower link does, so mass, first moment and second moment along the
//! axis may stand there as well: three numbers fewer for the link (Khalil and Kleinfinger 1987), and no more for a lower link
//! that has all ten.

use super::{
    inertia::Composite,
    link::Link,
    plan::{Plan, Regroup, Technique},
    rotation::Turn,
    rounding,
};
use crate::{
    expr::{Axis, ExprGraph},
    id::{BodyId, BodyMap},
    tree::Tree,
};

/// Regroups all links, from the leaves inward.
pub(super) fn run(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, links: &mut BodyMap<Link>) {
    for body in tree.body_ids().rev() {
        regroup(graph, tree, body, plan, links);
    }
}

/// Gives the lower link what the joint does not move of a link's inertia.
fn regroup(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    plan: &Plan,
    links: &mut BodyMap<Link>,
) {
    let lower = tree.lower(body);
    // Of a body without mass more would be needed than is saved.
    let has_mass = |body: BodyId| !graph.is_zero(links[body].inertia.mass);
    if !lower.is_none_or(has_mass) {
        return;
    }
    graph.enter(body);
    let (joint, choice) = (&tree.body(body).joint, plan.regroup(body));
    let link = &mut links[body];
    let given = if choice == Regroup::None {
        return;
    } else if let Some(axis) = joint.hinge_axis() {
        let given = take_from_axis(graph, axis, choice, link);
        let turned = link.constant.backward_composite(graph, &given);
        turned.moved(graph, link.offset)
    } else if joint.only_translates() {
        take_tensor(graph, link)
    } else {
        return;
    };
    let Some(lower) = lower else {
        return;
    };
    graph.enter(lower);
    let below = links[lower].inertia.plus(graph, &given);
    links[lower].set_inertia(graph, below);
    if plan.uses(Technique::Balance) && joint.hinge_axis().is_some() {
        balance(graph, tree, body, lower, links);
    }
}

/// Takes from a link that turns what lies on its axis, along the joint's axes: a mass, its first moment, and its second moment.
fn take_from_axis(
    graph: &mut ExprGraph,
    axis: Axis,
    choice: Regroup,
    link: &mut Link,
) -> Composite {
    let (a, (b, c)) = (axis.index(), axis.others());
    let mut inertia = link.inertia;
    let along = match choice {
        Regroup::None => graph.zero(),
        Regroup::Second => link.second[a],
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
    link.set_inertia(graph, inertia);
    if choice == Regroup::Second {
        link.second[a] = zero;
    }
    given
}

/// Takes all inertia but mass and first moment from a link that only translates, along the lower link's axes: it turns as that
/// does.
fn take_tensor(graph: &mut ExprGraph, link: &mut Link) -> Composite {
    let given = Composite {
        inertia: link
            .constant
            .backward_symmetric(graph, &link.inertia.inertia),
        ..Composite::zero(graph)
    };
    let rest = Composite {
        inertia: graph.zero_symmetric(),
        ..link.inertia
    };
    link.set_inertia(graph, rest);
    given
}

/// Takes back so much of a mass on the axis that the lower link's first moment has no part along the way to it, where that
/// is no multiple of what there is. Of the bodies on the lower link the lowest-numbered does so, which is met last.
fn balance(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    lower: BodyId,
    links: &mut BodyMap<Link>,
) {
    let is_last = tree.uppers(lower).first() == Some(&body);
    let own = tree.body(lower).joint.turning_axis();
    let offset = links[body].offset;
    let below = links[lower].inertia;
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
    links[lower].set_inertia(graph, inertia);
    links[body].inertia.mass = graph.number(kept);
}

/// How many times the mass that there is may be kept on an axis: what is added and taken away must not drown the rest.
const MOST_KEPT: f64 = 4.0;
