//! Base inertial parameters: what a joint does not move of a link's inertia is given to its lower link.
//!
//! A link that only turns moves a mass on its axis as its lower link does, so mass, first moment and second moment along the
//! axis may stand there as well: three numbers fewer for the link (Khalil and Kleinfinger 1987), and no more for a lower link
//! that has all ten.

use super::{
    inertia::Composite,
    layout,
    link::Link,
    plan::{Plan, Regroup, Technique},
    rotation::Turn,
};
use crate::{
    expr::{Axis, ExprGraph, Symmetric},
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
    if layout::only_translates(&tree.body(body).joint) {
        return give_tensor(graph, tree, body, plan, links);
    }
    let Some((axis, lower)) = receiver(graph, tree, body, links) else {
        return;
    };
    graph.enter(body);
    let choice = plan.regroup(body);
    let (a, (b, c)) = (axis.index(), axis.others());
    let link = &links[body];
    let mut inertia = link.inertia;
    let along = match choice {
        Regroup::None => return,
        Regroup::Second => link.second[a],
        Regroup::First => inertia.inertia.diagonal[b],
        Regroup::Last => inertia.inertia.diagonal[c],
    };
    let zero = graph.zero();
    // On the axis: a mass, its first moment, and its second moment.
    let mut given = Composite {
        mass: inertia.mass,
        moment: [zero; 3],
        inertia: Symmetric {
            diagonal: [along; 3],
            mixed: [zero; 3],
        },
    };
    given.moment[a] = inertia.moment[a];
    given.inertia.diagonal[a] = zero;
    inertia.mass = zero;
    inertia.moment[a] = zero;
    for across in [b, c] {
        let rest = graph.sub(inertia.inertia.diagonal[across], along);
        inertia.inertia.diagonal[across] = rest;
    }
    let mut second = inertia.second_moments(graph);
    if choice == Regroup::Second {
        second[a] = zero;
    }
    let given = link
        .constant
        .backward_composite(graph, &given)
        .moved(graph, link.offset);
    (links[body].inertia, links[body].second) = (inertia, second);
    if let Some(lower) = lower {
        graph.enter(lower);
        let below = &mut links[lower];
        below.inertia = below.inertia.plus(graph, &given);
        below.second = below.inertia.second_moments(graph);
        if plan.uses(Technique::Balance) {
            balance(graph, tree, body, lower, links);
        }
    }
}

/// A link that only translates turns as its lower link does: all its inertia may stand there, but for mass and first moment.
fn give_tensor(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    plan: &Plan,
    links: &mut BodyMap<Link>,
) {
    let lower = tree.lower(body);
    let has_mass = |lower: BodyId| !graph.is_zero(links[lower].inertia.mass);
    if plan.regroup(body) == Regroup::None || !lower.is_none_or(has_mass) {
        return;
    }
    graph.enter(body);
    let zero = graph.zero();
    let none = Symmetric {
        diagonal: [zero; 3],
        mixed: [zero; 3],
    };
    let link = &mut links[body];
    let tensor = link
        .constant
        .backward_symmetric(graph, &link.inertia.inertia);
    link.inertia.inertia = none;
    link.second = [zero; 3];
    if let Some(lower) = lower {
        graph.enter(lower);
        let below = &mut links[lower];
        let given = Composite {
            mass: zero,
            moment: [zero; 3],
            inertia: tensor,
        };
        below.inertia = below.inertia.plus(graph, &given);
        below.second = below.inertia.second_moments(graph);
    }
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
    let is_last = tree
        .body_ids()
        .find(|upper| tree.lower(*upper) == Some(lower))
        == Some(body);
    let own = layout::turning_axis(&tree.body(lower).joint);
    let offset = links[body].offset;
    let below = links[lower].inertia;
    let moments = layout::without_crumbs(graph, below.moment, below.moment);
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
    let zero = graph.zero();
    let taken = Composite {
        mass: graph.number(-kept),
        moment: [zero; 3],
        inertia: Symmetric {
            diagonal: [zero; 3],
            mixed: [zero; 3],
        },
    };
    let taken = taken.moved(graph, offset);
    let mut inertia = below.plus(graph, &taken);
    inertia.moment[axis] = zero;
    let second = inertia.second_moments(graph);
    (links[lower].inertia, links[lower].second) = (inertia, second);
    links[body].inertia.mass = graph.number(kept);
}

/// How many times the mass that there is may be kept on an axis: what is added and taken away must not drown the rest.
const MOST_KEPT: f64 = 4.0;

/// The axis of a joint that only turns, and the lower body that can be given what it does not move: `None` for the inertial
/// frame. A body without mass is given none, for that would cost more there than it saves.
fn receiver(
    graph: &ExprGraph,
    tree: &Tree,
    body: BodyId,
    links: &BodyMap<Link>,
) -> Option<(Axis, Option<BodyId>)> {
    let joint = &tree.body(body).joint;
    let axis = layout::turning_axis(joint)?;
    if joint.shifts().iter().any(Option::is_some) {
        return None;
    }
    let lower = tree.lower(body);
    let has_mass = |body: BodyId| !graph.is_zero(links[body].inertia.mass);
    lower.is_none_or(has_mass).then_some((axis, lower))
}
