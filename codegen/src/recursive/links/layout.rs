//! Where the recursion puts a link's origin and axes: the body's internal ones, slid along and turned about its joint's axis.
//!
//! A joint about an axis leaves the axis where it is, so any point of it can be the link's origin, and any turn about it is
//! only a phase of the angle. Chosen well, what leads from link to link is sparse.

use super::{
    inertia,
    rounding::{exact, without_crumbs},
};
use crate::{
    expr::{Axis, Expr, ExprGraph, Vector},
    geometry::{self, IDENTITY, Rotation},
    given,
    id::{BodyId, BodyMap},
    recursive::{plan::Plan, technique::Technique},
    tree::{Tree, Value},
};

/// A link's frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    /// From the lower link's axes to those of the joint's coordinates.
    pub(in crate::recursive) constant: Rotation,
    /// From the lower link's origin to where the joint's translations start, lower-link components.
    pub(in crate::recursive) attachment: Vector,
    /// What is added to the angle, rad.
    pub(in crate::recursive) phase: f64,
    /// From the body's internal axes to the link's: a turn about the joint's axis.
    pub(in crate::recursive) axes: Rotation,
    /// From the link's origin to the body's internal one, link components.
    pub(in crate::recursive) origin: Vector,
}

/// The layout of every link.
pub(super) fn layouts(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> BodyMap<Layout> {
    BodyMap::outward(tree.bodies.len(), |body, layouts: &BodyMap<Layout>| {
        graph.enter(body);
        let lower = tree.lower(body).map(|lower| layouts[lower]);
        let mut layout = given_layout(graph, tree, body, lower);
        if plan.uses(Technique::Slide) {
            layout = slid(graph, tree, body, layout);
        }
        if plan.uses(Technique::Turn) {
            layout = turned(graph, tree, body, layout);
        }
        layout
    })
}

/// The body's internal frame, on its lower link.
fn given_layout(graph: &mut ExprGraph, tree: &Tree, body: BodyId, lower: Option<Layout>) -> Layout {
    let joint = &tree.body(body).joint;
    let mut attachment = given::attachment(graph, joint);
    let mut constant = joint.rotation;
    if let Some(lower) = lower {
        let turned = given::constant(graph, &lower.axes);
        attachment = graph.mul_vector(&turned, attachment);
        attachment = graph.add_vectors(lower.origin, attachment);
        if lower.axes != IDENTITY {
            attachment = without_crumbs(graph, attachment, attachment);
            let turned = geometry::then(&geometry::transposed(&lower.axes), &constant);
            constant = turned.map(exact);
        }
    }
    Layout {
        constant,
        attachment,
        phase: 0.0,
        axes: IDENTITY,
        origin: graph.zero_vector(),
    }
}

/// With the origin moved so that the offset from the lower link's has no part along the joint's axis. The offset of a link on
/// the inertial frame is of no account.
fn slid(graph: &mut ExprGraph, tree: &Tree, body: BodyId, layout: Layout) -> Layout {
    let joint = &tree.body(body).joint;
    let constant = given::constant(graph, &layout.constant);
    if joint.only_translates() {
        return Layout {
            attachment: graph.zero_vector(),
            origin: graph.mul_vector(&constant, layout.attachment),
            ..layout
        };
    }
    let Some(axis) = joint.turning_axis() else {
        return layout;
    };
    let (attachment, along) = if tree.lower(body).is_none() {
        let along = slid_to_upper(graph, tree, body, axis);
        (layout.attachment, along)
    } else {
        across(graph, constant[axis.index()], layout.attachment)
    };
    let mut origin = layout.origin;
    origin[axis.index()] = along;
    Layout {
        attachment,
        origin,
        ..layout
    }
}

/// For a link on the inertial frame, how far its origin is moved down its axis to meet the first body on it that sits off
/// the internal origin and cannot move there itself.
fn slid_to_upper(graph: &mut ExprGraph, tree: &Tree, body: BodyId, axis: Axis) -> Expr {
    for &upper in tree.uppers(body) {
        let joint = &tree.body(upper).joint;
        let mut attachment = given::attachment(graph, joint);
        if let Some(turning) = joint.turning_axis() {
            let direction = joint.rotation[turning.index()].map(Value::Baked);
            let direction = given::vector(graph, direction);
            (attachment, _) = across(graph, direction, attachment);
        }
        if !graph.is_zero(attachment[axis.index()]) {
            return -attachment[axis.index()];
        }
    }
    graph.zero()
}

/// The part of a vector across a direction, and how much of it is along that.
fn across(graph: &mut ExprGraph, direction: Vector, v: Vector) -> (Vector, Expr) {
    let along = graph.dot(direction, v);
    let part = graph.scale(along, direction);
    let rest = graph.sub_vectors(v, part);
    (without_crumbs(graph, rest, v), along)
}

/// With the joint's axes turned before the angle, and the link's after it.
fn turned(graph: &mut ExprGraph, tree: &Tree, body: BodyId, layout: Layout) -> Layout {
    let joint = &tree.body(body).joint;
    let Some(axis) = joint.turning_axis() else {
        return layout;
    };
    let (constant, before) = sparser(layout.constant, axis);
    let after = if tree.uppers(body).is_empty() {
        toward_mass(graph, tree, body, axis)
    } else {
        toward_upper(graph, tree, body, axis)
    };
    Layout {
        constant,
        axes: about(axis, after),
        phase: after - before,
        ..layout
    }
}

/// A constant rotation, turned about the axis that it leads to until it is as sparse as that permits, and the angle, rad.
fn sparser(constant: Rotation, axis: Axis) -> (Rotation, f64) {
    let (a, (b, c)) = (axis.index(), axis.others());
    let normal = (0..3).find(|&p| constant[a][p] == 0.0);
    let Some(p) = normal else {
        return (constant, 0.0);
    };
    // The coordinate axis p lies in the plane of the other two rows: one of them becomes it.
    let (along_b, along_c) = (constant[b][p], constant[c][p]);
    if along_b == 0.0 || along_c == 0.0 {
        return (constant, 0.0);
    }
    let mut sparser = constant;
    let mut unit = [0.0; 3];
    let angle = if along_b.abs() >= along_c.abs() {
        let sign = 1.0_f64.copysign(along_b);
        unit[p] = sign;
        sparser[b] = unit;
        sparser[c] = geometry::cross(constant[a], unit);
        libm::atan2(sign * along_c, sign * along_b)
    } else {
        let sign = 1.0_f64.copysign(along_c);
        unit[p] = sign;
        sparser[c] = unit;
        sparser[b] = geometry::cross(unit, constant[a]);
        libm::atan2(-sign * along_b, sign * along_c)
    };
    (sparser, angle)
}

/// The turn of a link after which the axis of the first body on it that has one askew lies in a coordinate plane, or, where
/// that axis is parallel, the way to it along a coordinate axis.
fn toward_upper(graph: &mut ExprGraph, tree: &Tree, body: BodyId, axis: Axis) -> f64 {
    let (b, c) = axis.others();
    for &upper in tree.uppers(body) {
        let joint = &tree.body(upper).joint;
        let Some(turning) = joint.turning_axis() else {
            continue;
        };
        let mut across = joint.rotation[turning.index()];
        if across[b] == 0.0 && across[c] == 0.0 {
            let attachment = given::attachment(graph, joint);
            across = attachment.map(|component| graph.as_number(component).unwrap_or(0.0));
        }
        if across[b] != 0.0 && across[c] != 0.0 {
            return to_an_axis(across[b], across[c]);
        }
    }
    0.0
}

/// The smaller of the turns after which a vector in the plane across an axis lies along a coordinate axis.
fn to_an_axis(along_b: f64, along_c: f64) -> f64 {
    if along_b.abs() >= along_c.abs() {
        libm::atan(along_c / along_b)
    } else {
        -libm::atan(along_b / along_c)
    }
}

/// The turn of a link that carries none after which its first moment lies in a coordinate plane with the joint's axis.
fn toward_mass(graph: &mut ExprGraph, tree: &Tree, body: BodyId, axis: Axis) -> f64 {
    let (b, c) = axis.others();
    let moment = inertia::own(graph, &tree.body(body).parts).moment;
    match (graph.as_number(moment[b]), graph.as_number(moment[c])) {
        (Some(along_b), Some(along_c)) if along_b != 0.0 && along_c != 0.0 => {
            to_an_axis(along_b, along_c)
        }
        _ => 0.0,
    }
}

/// A rotation about a coordinate axis.
fn about(axis: Axis, angle: f64) -> Rotation {
    let (b, c) = axis.others();
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let mut rotation = IDENTITY;
    rotation[b][b] = cosine;
    rotation[b][c] = sine;
    rotation[c][b] = -sine;
    rotation[c][c] = cosine;
    rotation
}
