//! Frames that have names: where they are, how they move and what moves them, from Eqs. (3), (11), (15), (22), (25), (28) and
//! what stands before Eq. (33).

use super::{
    orientation, position,
    velocity::{self, Rotational},
};
use crate::{
    expr::{Expr, ExprGraph, Matrix, Vector, negated, transpose},
    given::{
        self, Accelerations, FrameMotion, FramePose, FrameWrench, frame_origin, frame_rotation,
    },
    id::{BodyMap, SpeedId},
    partition::Row,
    tree::{NamedFrame, Tree},
};

/// `R_F = A_F R_K`, and `R_K^T (p_O_K + o_F)`.
pub fn pose(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> FramePose {
    let own = frame_rotation(graph, tree, frame);
    let origin = frame_origin(graph, tree, frame);
    let Some(body) = tree.frame_body(frame) else {
        return FramePose {
            rotation: own,
            position: origin,
        };
    };
    let relative = orientation::relative(graph, tree);
    let absolute = orientation::absolute(graph, tree, &relative);
    let origins = position::origin(graph, tree, &relative);
    graph.enter(body);
    let position = graph.add_vectors(origins[body], origin);
    FramePose {
        rotation: graph.mul_matrices(&own, &absolute[body]),
        position: graph.mul_vector(&transpose(&absolute[body]), position),
    }
}

/// The same from another frame, along its axes: `R_F R_G^T`, and `R_G (p_F - p_G)`.
pub fn seen_pose(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    from: NamedFrame,
) -> FramePose {
    let [own, view] = [frame, from].map(|frame| pose(graph, tree, frame));
    let apart = graph.sub_vectors(own.position, view.position);
    FramePose {
        rotation: graph.mul_matrices(&own.rotation, &transpose(&view.rotation)),
        position: graph.mul_vector(&view.rotation, apart),
    }
}

/// `R_K^T` times the velocity along the internal axes: inertial components.
pub fn velocity(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> FrameMotion {
    let rotational = velocity::rotational(graph, tree);
    let motion = velocity_in_body(graph, tree, frame, &rotational);
    to_inertial(graph, tree, frame, motion)
}

/// The same, components along the frame's own axes.
pub fn local_velocity(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> FrameMotion {
    let rotational = velocity::rotational(graph, tree);
    let motion = velocity_in_body(graph, tree, frame, &rotational);
    to_own(graph, tree, frame, motion)
}

/// `R_K^T` times the acceleration along the internal axes: inertial components.
pub fn acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    accelerations: Accelerations<'_>,
) -> FrameMotion {
    let motion = acceleration_in_body(graph, tree, frame, accelerations);
    to_inertial(graph, tree, frame, motion)
}

/// The same, components along the frame's own axes.
pub fn local_acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    accelerations: Accelerations<'_>,
) -> FrameMotion {
    let motion = acceleration_in_body(graph, tree, frame, accelerations);
    to_own(graph, tree, frame, motion)
}

/// The acceleration of the frame's origin less gravity, and its angular velocity, along its own axes.
pub fn imu(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> FrameMotion {
    let acceleration = local_acceleration(graph, tree, frame, Accelerations::Given);
    let rotation = pose(graph, tree, frame).rotation;
    let gravity = given::gravity(graph, tree);
    let gravity = graph.mul_vector(&rotation, gravity);
    FrameMotion {
        linear: graph.sub_vectors(acceleration.linear, gravity),
        angular: local_velocity(graph, tree, frame).angular,
    }
}

/// `R_K^T` times the partial velocities of the frame, or of a point that it is given: inertial components, a column for every
/// speed that moves it.
pub fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    point: Option<Vector>,
) -> Vec<(SpeedId, FrameMotion)> {
    let rows = in_inertial(graph, tree, frame, point);
    columns(graph, tree, &rows)
}

/// The same, components along the frame's own axes.
pub fn local_jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    point: Option<Vector>,
) -> Vec<(SpeedId, FrameMotion)> {
    let rotation = pose(graph, tree, frame).rotation;
    let rows = in_inertial(graph, tree, frame, point).turned(graph, &rotation);
    columns(graph, tree, &rows)
}

/// The same as it is seen from another frame: of the difference, `v_F - v_G - tilde(w_G)(p_F - p_G)`, components along the
/// other's axes.
pub fn seen_jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    (frame, point): (NamedFrame, Option<Vector>),
    from: NamedFrame,
) -> Vec<(SpeedId, FrameMotion)> {
    let mut place = pose(graph, tree, frame);
    if let Some(point) = point {
        let step = graph.mul_vector(&transpose(&place.rotation), point);
        place.position = graph.add_vectors(place.position, step);
    }
    let view = pose(graph, tree, from);
    let own = in_inertial(graph, tree, frame, point);
    let other = in_inertial(graph, tree, from, None);
    let apart = graph.sub_vectors(place.position, view.position);
    let carried = other.angular.crossed(graph, apart);
    let carried = FrameRows {
        linear: other.linear.plus(graph, carried),
        angular: other.angular,
    };
    let own = own.turned(graph, &view.rotation);
    let carried = carried.turned(graph, &view.rotation);
    let minus = columns(graph, tree, &carried).into_iter();
    let minus = minus.map(|(speed, motion)| {
        let FrameMotion { linear, angular } = motion;
        let (linear, angular) = (negated(linear), negated(angular));
        (speed, FrameMotion { linear, angular })
    });
    let own = columns(graph, tree, &own).into_iter();
    own.chain(minus).collect()
}

/// `J^T` of a wrench at the frame's origin, inertial components: Eq. (36).
pub fn generalized_force(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    wrench: FrameWrench,
) -> Vec<Expr> {
    let columns = jacobian(graph, tree, frame, None);
    projected(graph, tree, &columns, wrench)
}

/// The same, components along the frame's own axes.
pub fn local_generalized_force(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    wrench: FrameWrench,
) -> Vec<Expr> {
    let columns = local_jacobian(graph, tree, frame, None);
    projected(graph, tree, &columns, wrench)
}

fn projected(
    graph: &mut ExprGraph,
    tree: &Tree,
    columns: &[(SpeedId, FrameMotion)],
    wrench: FrameWrench,
) -> Vec<Expr> {
    let FrameWrench { force, moment } = wrench;
    let mut tau = vec![graph.zero(); tree.n_speeds];
    for (speed, FrameMotion { linear, angular }) in columns {
        let (along, about) = (graph.dot(*linear, force), graph.dot(*angular, moment));
        let share = graph.add(along, about);
        tau[speed.index()] = graph.add(tau[speed.index()], share);
    }
    tau
}

/// Partial velocities of a frame.
struct FrameRows {
    linear: Row,
    angular: Row,
}

impl FrameRows {
    fn turned(&self, graph: &mut ExprGraph, rotation: &Matrix) -> Self {
        Self {
            linear: self.linear.premultiplied(graph, rotation),
            angular: self.angular.premultiplied(graph, rotation),
        }
    }
}

fn columns(graph: &mut ExprGraph, tree: &Tree, rows: &FrameRows) -> Vec<(SpeedId, FrameMotion)> {
    let linear = rows.linear.columns(graph, tree);
    let angular = rows.angular.columns(graph, tree);
    let zero = graph.zero_vector();
    let linear = linear.into_iter().map(|(speed, linear)| {
        let angular = zero;
        (speed, FrameMotion { linear, angular })
    });
    let angular = angular.into_iter().map(|(speed, angular)| {
        let linear = zero;
        (speed, FrameMotion { linear, angular })
    });
    linear.chain(angular).collect()
}

/// `JR_K V_O_K - tilde(o_F) W_K` and `W_K`, both times `R_K^T`.
fn in_inertial(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    point: Option<Vector>,
) -> FrameRows {
    let Some(body) = tree.frame_body(frame) else {
        return FrameRows {
            linear: Row::default(),
            angular: Row::default(),
        };
    };
    let relative = orientation::relative(graph, tree);
    let absolute = orientation::absolute(graph, tree, &relative);
    let partials = velocity::partials(graph, tree, &relative);
    let mut origin = frame_origin(graph, tree, frame);
    if let Some(point) = point {
        let own = frame_rotation(graph, tree, frame);
        let step = graph.mul_vector(&transpose(&own), point);
        origin = graph.add_vectors(origin, step);
    }
    graph.enter(body);
    let carried = partials.origin[body].premultiplied(graph, &relative[body]);
    let turned = partials.angular[body].crossed(graph, origin);
    let rows = FrameRows {
        linear: carried.plus(graph, turned),
        angular: partials.angular[body].clone(),
    };
    rows.turned(graph, &transpose(&absolute[body]))
}

/// `JR_K v_O_K + tilde(w_K) o_F` and `w_K`: components along the internal axes of the body that holds the frame.
fn velocity_in_body(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    rotational: &Rotational,
) -> FrameMotion {
    let Some(body) = tree.frame_body(frame) else {
        return still(graph);
    };
    let origins = velocity::origin(graph, tree, rotational);
    let origin = frame_origin(graph, tree, frame);
    let carried = graph.mul_vector(&rotational.relative[body], origins[body]);
    let turned = graph.cross(rotational.w[body], origin);
    FrameMotion {
        linear: graph.add_vectors(carried, turned),
        angular: rotational.w[body],
    }
}

/// `a_G_K + (tilde(alpha_K) + tilde(w_K) tilde(w_K))(o_F - r_K)` and `alpha_K`, the same components.
fn acceleration_in_body(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    accelerations: Accelerations<'_>,
) -> FrameMotion {
    let Some(body) = tree.frame_body(frame) else {
        return still(graph);
    };
    let of_bodies = velocity::accelerations(graph, tree, accelerations);
    let (w, alpha) = (of_bodies.rotational.w[body], of_bodies.alpha[body]);
    let origin = frame_origin(graph, tree, frame);
    let center = given::mass_center(graph, tree.body(body));
    let apart = graph.sub_vectors(origin, center);
    let swung = graph.cross(alpha, apart);
    let swept = graph.cross(w, apart);
    let convected = graph.cross(w, swept);
    let linear = graph.add_vectors(of_bodies.mass_center[body], swung);
    FrameMotion {
        linear: graph.add_vectors(linear, convected),
        angular: alpha,
    }
}

fn still(graph: &mut ExprGraph) -> FrameMotion {
    let zero = graph.zero_vector();
    FrameMotion {
        linear: zero,
        angular: zero,
    }
}

fn to_inertial(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    motion: FrameMotion,
) -> FrameMotion {
    let Some(body) = tree.frame_body(frame) else {
        return motion;
    };
    let relative = orientation::relative(graph, tree);
    let absolute: BodyMap<Matrix> = orientation::absolute(graph, tree, &relative);
    graph.enter(body);
    turned(graph, &transpose(&absolute[body]), motion)
}

fn to_own(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    motion: FrameMotion,
) -> FrameMotion {
    let own = frame_rotation(graph, tree, frame);
    turned(graph, &own, motion)
}

fn turned(graph: &mut ExprGraph, rotation: &Matrix, motion: FrameMotion) -> FrameMotion {
    FrameMotion {
        linear: graph.mul_vector(rotation, motion.linear),
        angular: graph.mul_vector(rotation, motion.angular),
    }
}
