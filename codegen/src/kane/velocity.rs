//! Velocities, partial velocities and accelerations of origins and mass centres, Eqs. (25)-(34).

use super::{angular, orientation};
use crate::{
    expr::{ExprGraph, Matrix, Purpose, Vector, transpose},
    geometry::IDENTITY,
    given::{self, Accelerations},
    id::BodyMap,
    partition::{Block, Partition, Row},
    tree::{Joint, Tree},
};

/// Rotations and angular velocities, from which the translational quantities follow.
#[derive(Debug)]
pub struct Rotational {
    /// `JR_K`, Eq. (4).
    pub relative: BodyMap<Matrix>,
    /// `w_rel_K`, Eq. (8).
    pub w_rel: BodyMap<Vector>,
    /// `w_K`, Eq. (11).
    pub w: BodyMap<Vector>,
}

/// Partial velocities and, where asked for, their derivatives.
#[derive(Debug)]
pub struct Partials {
    /// Partial angular velocities `W_K`, Eq. (15), or their derivatives, Eq. (20).
    pub angular: BodyMap<Row>,
    /// Of the origins `V_O_K`, lower-body components, Eq. (28), or their derivatives, Eq. (34).
    pub origin: BodyMap<Row>,
    /// Of the mass centres `V_G_K`, body components, Eq. (32), or their derivatives, Eq. (33).
    pub mass_center: BodyMap<Row>,
}

/// Eqs. (4), (8), (11).
pub fn rotational(graph: &mut ExprGraph, tree: &Tree) -> Rotational {
    let relative = orientation::relative(graph, tree);
    let w_rel = angular::relative_velocity(graph, tree);
    let w = angular::velocity(graph, tree, &relative, &w_rel);
    Rotational { relative, w_rel, w }
}

/// `s_dot_K`, lower-body components.
fn shift_velocity(graph: &mut ExprGraph, joint: &Joint) -> Vector {
    let s_dot = given::shift_speeds(graph, joint);
    given::constant_back(graph, &joint.rotation, s_dot)
}

/// The directions of the translations by columns, lower-body components: the identity of Eq. (30) where the joint's axes
/// are the lower body's.
fn shift_block(graph: &mut ExprGraph, joint: &Joint) -> Block {
    if joint.rotation == IDENTITY {
        return Block::Identity;
    }
    let directions = given::shift_directions(graph, joint);
    Block::Full(transpose(&directions))
}

/// `v_O_K = LJR_J v_O_J + s_dot_K + tilde(w_J)(q_K + s_K)`, Eq. (25): lower-body components, for every body.
pub fn origin(graph: &mut ExprGraph, tree: &Tree, rotational: &Rotational) -> BodyMap<Vector> {
    graph.begin(Purpose::Velocity);
    BodyMap::outward(tree.bodies.len(), |body, v| {
        graph.enter(body);
        let s_dot = shift_velocity(graph, &tree.body(body).joint);
        let Some(lower) = tree.lower(body) else {
            return s_dot;
        };
        // What bodies on one lower body share is the lower body's.
        graph.enter(lower);
        let carried = graph.mul_vector(&rotational.relative[lower], v[lower]);
        graph.enter(body);
        let offset = given::offset(graph, tree.body(body));
        let turned = graph.cross(rotational.w[lower], offset);
        let moved = graph.add_vectors(carried, s_dot);
        let sum = graph.add_vectors(moved, turned);
        graph.name_vector(sum, "v_o");
        sum
    })
}

/// `v_G_K = JR_K v_O_K + tilde(w_K) r_K`, Eq. (27): body components, for every body.
pub fn mass_center(
    graph: &mut ExprGraph,
    tree: &Tree,
    rotational: &Rotational,
    v_origin: &BodyMap<Vector>,
) -> BodyMap<Vector> {
    graph.begin(Purpose::Velocity);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let carried = graph.mul_vector(&rotational.relative[body], v_origin[body]);
        let r = given::mass_center(graph, tree.body(body));
        let turned = graph.cross(rotational.w[body], r);
        let sum = graph.add_vectors(carried, turned);
        graph.name_vector(sum, "v_g");
        sum
    })
}

/// `V_O_K = LJR_J V_O_J - tilde(q_K + s_K) W_J + [0 .. 1 at N + K .. 0]`, Eqs. (28)-(30), and
/// `V_G_K = JR_K V_O_K - tilde(r_K) W_K`, Eq. (32), with `W_K` of Eq. (15).
pub fn partials(graph: &mut ExprGraph, tree: &Tree, relative: &BodyMap<Matrix>) -> Partials {
    graph.begin(Purpose::PartialVelocity);
    let angular = angular::partial(graph, tree, relative);
    let origin = BodyMap::outward(tree.bodies.len(), |body, rows: &BodyMap<Row>| {
        graph.enter(body);
        let directions = shift_block(graph, &tree.body(body).joint);
        let own = Row::single(tree, Partition::Translations(body), directions);
        let Some(lower) = tree.lower(body) else {
            return own;
        };
        graph.enter(lower);
        let carried = rows[lower].premultiplied(graph, &relative[lower]);
        graph.enter(body);
        let offset = given::offset(graph, tree.body(body));
        let turned = angular[lower].crossed(graph, offset);
        let row = carried.plus(graph, turned).plus(graph, own);
        row.name(graph, tree, "vo");
        row
    });
    let mass_center = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let r = given::mass_center(graph, tree.body(body));
        let carried = origin[body].premultiplied(graph, &relative[body]);
        let turned = angular[body].crossed(graph, r);
        let row = carried.plus(graph, turned);
        row.name(graph, tree, "v");
        row
    });
    Partials {
        angular,
        origin,
        mass_center,
    }
}

/// Eqs. (20), (34) and (33): the time derivatives of the partials.
pub fn partials_dot(
    graph: &mut ExprGraph,
    tree: &Tree,
    rotational: &Rotational,
    partials: &Partials,
) -> Partials {
    graph.begin(Purpose::PartialVelocityDot);
    let Rotational {
        relative, w_rel, ..
    } = rotational;
    let angular = angular::partial_dot(graph, tree, relative, w_rel, &partials.angular);
    let origin = BodyMap::outward(tree.bodies.len(), |body, rows: &BodyMap<Row>| {
        graph.enter(body);
        let Some(lower) = tree.lower(body) else {
            return Row::default();
        };
        graph.enter(lower);
        let carried = rows[lower].premultiplied(graph, &relative[lower]);
        let turned = partials.origin[lower]
            .premultiplied(graph, &relative[lower])
            .crossed(graph, w_rel[lower]);
        graph.enter(body);
        let s_dot = shift_velocity(graph, &tree.body(body).joint);
        let extended = partials.angular[lower].crossed(graph, s_dot);
        let offset = given::offset(graph, tree.body(body));
        let accelerated = angular[lower].crossed(graph, offset);
        let row = carried
            .plus(graph, turned)
            .plus(graph, extended)
            .plus(graph, accelerated);
        row.name(graph, tree, "vo_dot");
        row
    });
    let mass_center = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let carried = origin[body].premultiplied(graph, &relative[body]);
        let turned = partials.origin[body]
            .premultiplied(graph, &relative[body])
            .crossed(graph, w_rel[body]);
        let r = given::mass_center(graph, tree.body(body));
        let accelerated = angular[body].crossed(graph, r);
        let row = carried.plus(graph, turned).plus(graph, accelerated);
        row.name(graph, tree, "v_dot");
        row
    });
    Partials {
        angular,
        origin,
        mass_center,
    }
}

/// Accelerations of every body.
#[derive(Debug)]
pub struct BodyAccelerations {
    /// Rotations and angular velocities.
    pub rotational: Rotational,
    /// Angular accelerations, below Eq. (19).
    pub alpha: BodyMap<Vector>,
    /// `a_G_K = V_G_K y_dot + V_G_dot_K y + tilde(w_K) v_G_K`, before Eq. (33): body components.
    pub mass_center: BodyMap<Vector>,
}

/// The accelerations of mass centres and bodies.
///
/// Eqs. (32)-(34) are multiplied by `y` and `y_dot` before they recur, so that no matrix is built.
pub fn accelerations(
    graph: &mut ExprGraph,
    tree: &Tree,
    accelerations: Accelerations<'_>,
) -> BodyAccelerations {
    graph.begin(Purpose::Acceleration);
    let rotational = rotational(graph, tree);
    let Rotational { relative, w_rel, w } = &rotational;
    let alpha = angular::acceleration(graph, tree, relative, w_rel, w, accelerations);
    let v_origin = origin(graph, tree, &rotational);
    let v_mass_center = mass_center(graph, tree, &rotational, &v_origin);
    // V_O y_dot + V_O_dot y, lower-body components: Eqs. (28) and (34).
    let z = BodyMap::outward(tree.bodies.len(), |body, z| {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        let second = joint
            .shifts()
            .map(|s| given::acceleration(graph, s, accelerations));
        let second = given::constant_back(graph, &joint.rotation, second);
        let Some(lower) = tree.lower(body) else {
            return second;
        };
        graph.enter(lower);
        let carried = graph.mul_vector(&relative[lower], z[lower]);
        let v_lower = graph.mul_vector(&relative[lower], v_origin[lower]);
        let turned = graph.cross(v_lower, w_rel[lower]);
        graph.enter(body);
        let s_dot = shift_velocity(graph, joint);
        let extended = graph.cross(w[lower], s_dot);
        let offset = given::offset(graph, tree.body(body));
        let accelerated = graph.cross(alpha[lower], offset);
        [turned, second, extended, accelerated]
            .into_iter()
            .fold(carried, |sum, term| graph.add_vectors(sum, term))
    });
    let mass_center = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let carried = graph.mul_vector(&relative[body], z[body]);
        let v = graph.mul_vector(&relative[body], v_origin[body]);
        let turned = graph.cross(v, w_rel[body]);
        let r = given::mass_center(graph, tree.body(body));
        let accelerated = graph.cross(alpha[body], r);
        let convected = graph.cross(w[body], v_mass_center[body]);
        let sum = [turned, accelerated, convected]
            .into_iter()
            .fold(carried, |sum, term| graph.add_vectors(sum, term));
        graph.name_vector(sum, "a_g");
        sum
    });
    BodyAccelerations {
        rotational,
        alpha,
        mass_center,
    }
}
