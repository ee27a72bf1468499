//! Right-hand sides in two passes: motion outward, forces inward (Luh, Walker and Paul 1980).
//!
//! Inertia forces are taken about the body's origin, so no velocity of a mass centre is formed; gravity is an
//! upward acceleration of the inertial frame. With `U = tilde(alpha) + tilde(w)^2` the force is `m a + U h`,
//! and the moment is `h × a` plus products of the inertia's components with entries of U and of `w w^T`.

use crate::{
    expr::{Axis, Expr, ExprGraph, Matrix, Symmetric, Vector, negated, transpose},
    id::{BodyId, BodyMap},
    kane::{Accelerations, given},
    recursive::{
        frames::{self, Frame, Rotation, Turning},
        inertia,
    },
    tree::{Motion, Tree},
};

/// `A y_dot - f` without loads: `tau` for given accelerations, the bias for none.
pub fn inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    accelerations: Accelerations,
) -> Vec<Expr> {
    let frames = frames::frames(graph, tree);
    let wrenches = inertia_and_weight(graph, tree, &frames, accelerations);
    project(graph, tree, &frames, wrenches)
}

/// `f`, Eq. (43): the loads less the bias.
pub fn forcing(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let frames = frames::frames(graph, tree);
    let inertial = inertia_and_weight(graph, tree, &frames, Accelerations::Zero);
    let net = BodyMap::outward(tree.bodies.len(), |body, _| {
        let load = load(graph, tree, body);
        Wrench {
            force: graph.sub_vectors(load.force, inertial[body].force),
            moment: graph.sub_vectors(load.moment, inertial[body].moment),
        }
    });
    project(graph, tree, &frames, net)
}

/// `F_y`, Eq. (36), of the loads.
pub fn generalized_forces(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let frames = frames::frames(graph, tree);
    let loads = BodyMap::outward(tree.bodies.len(), |body, _| load(graph, tree, body));
    project(graph, tree, &frames, loads)
}

/// A force and its moment about the body's origin, body components.
#[derive(Clone, Copy, Debug)]
struct Wrench {
    force: Vector,
    moment: Vector,
}

/// A body's motion, body components.
#[derive(Clone, Copy, Debug)]
struct BodyMotion {
    /// Angular velocity.
    w: Vector,
    /// `tilde(alpha) + tilde(w)^2`: what a point's position is multiplied by for its acceleration.
    u: Matrix,
    /// The products `w_y w_z`, `w_z w_x`, `w_x w_y`.
    products: Vector,
    /// Angular acceleration.
    alpha: Vector,
    /// Acceleration of the origin, less gravity.
    a: Vector,
}

/// The load of a body about its origin.
fn load(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Wrench {
    graph.enter(body);
    let center = given::mass_center(graph, tree.body(body));
    let (force, moment) = (
        given::force(graph, tree, body),
        given::moment(graph, tree, body),
    );
    let lever = graph.cross(center, force);
    Wrench {
        force,
        moment: graph.add_vectors(moment, lever),
    }
}

/// What each body needs to move as it does, weight included.
fn inertia_and_weight(
    graph: &mut ExprGraph,
    tree: &Tree,
    frames: &BodyMap<Frame>,
    accelerations: Accelerations,
) -> BodyMap<Wrench> {
    let gravity = given::gravity(graph, tree);
    let motions = BodyMap::outward(tree.bodies.len(), |body, motions: &BodyMap<BodyMotion>| {
        graph.enter(body);
        let lower = tree.lower(body).map(|lower| &motions[lower]);
        outward(
            graph,
            tree,
            body,
            &frames[body],
            lower,
            negated(gravity),
            accelerations,
        )
    });
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let inertia = inertia::own(graph, tree.body(body));
        let motion = &motions[body];
        let carried = graph.scale(inertia.mass, motion.a);
        let turned = graph.mul_vector(&motion.u, inertia.moment);
        let lever = graph.cross(inertia.moment, motion.a);
        let spin = euler(graph, &inertia.inertia, motion);
        Wrench {
            force: graph.add_vectors(carried, turned),
            moment: graph.add_vectors(spin, lever),
        }
    })
}

/// The motion of a body from that of its lower body; `None` is the inertial frame.
fn outward(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    frame: &Frame,
    lower: Option<&BodyMotion>,
    base: Vector,
    accelerations: Accelerations,
) -> BodyMotion {
    let joint = &tree.body(body).joint;
    let s_dot = given::shift_speeds(graph, joint);
    let s_dot = frame.before_constant(graph, s_dot);
    let s_ddot = joint
        .shifts()
        .map(|s| given::acceleration(graph, s, accelerations));
    let mut a = frame.before_constant(graph, s_ddot);
    let (mut w, mut alpha) = ([graph.zero(); 3], [graph.zero(); 3]);
    match lower {
        None => a = graph.add_vectors(base, a),
        Some(lower) => {
            (w, alpha) = (lower.w, lower.alpha);
            let turned = graph.mul_vector(&lower.u, frame.offset);
            let two = graph.number(2.0);
            let twice = graph.scale(two, s_dot);
            let coriolis = graph.cross(w, twice);
            a = [lower.a, turned, coriolis]
                .into_iter()
                .fold(a, |sum, term| graph.add_vectors(sum, term));
        }
    }
    [w, alpha, a] = [w, alpha, a].map(|v| graph.mul_vector(&frame.constant, v));
    match &frame.turning {
        Turning::Angles(rotations) => {
            for rotation in rotations {
                (w, alpha) = turn(graph, rotation, w, alpha, accelerations);
                a = rotation.forward(graph, a);
            }
        }
        Turning::Matrix(matrix) => {
            [w, alpha, a] = [w, alpha, a].map(|v| graph.mul_vector(matrix, v));
        }
    }
    if let Some(motions) = frames::angular_velocity(joint) {
        (w, alpha) = spin(graph, motions, w, alpha, accelerations);
    }
    graph.name_vector(w, "w");
    graph.name_vector(alpha, "alpha");
    graph.name_vector(a, "a");
    let (u, products) = acceleration_matrix(graph, w, alpha);
    graph.name_matrix(&u, "u");
    BodyMotion {
        w,
        u,
        products,
        alpha,
        a,
    }
}

/// Angular velocity and acceleration after a rotation whose angle moves.
fn turn(
    graph: &mut ExprGraph,
    rotation: &Rotation,
    w: Vector,
    alpha: Vector,
    accelerations: Accelerations,
) -> (Vector, Vector) {
    let (mut w, mut alpha) = (rotation.forward(graph, w), rotation.forward(graph, alpha));
    let rate = given::speed(graph, rotation.motion);
    let second = given::acceleration(graph, rotation.motion, accelerations);
    let (a, (b, c)) = (rotation.axis.index(), rotation.axis.others());
    // (w × e_a) times the rate: the lower axes turn under the new ones.
    let (along_b, along_c) = (graph.mul(w[c], rate), graph.mul(w[b], rate));
    alpha[b] = graph.add(alpha[b], along_b);
    alpha[c] = graph.sub(alpha[c], along_c);
    alpha[a] = graph.add(alpha[a], second);
    w[a] = graph.add(w[a], rate);
    (w, alpha)
}

/// Angular velocity and acceleration with a relative angular velocity whose components are the speeds.
fn spin(
    graph: &mut ExprGraph,
    motions: [Motion; 3],
    w: Vector,
    alpha: Vector,
    accelerations: Accelerations,
) -> (Vector, Vector) {
    let relative = motions.map(|motion| given::speed(graph, Some(motion)));
    let second = motions.map(|motion| given::acceleration(graph, Some(motion), accelerations));
    // The lower axes turn under the new ones.
    let turned = graph.cross(w, relative);
    let alpha = graph.add_vectors(alpha, turned);
    (
        graph.add_vectors(w, relative),
        graph.add_vectors(alpha, second),
    )
}

/// `tilde(alpha) + tilde(w)^2`, and the mixed products of `w`.
fn acceleration_matrix(graph: &mut ExprGraph, w: Vector, alpha: Vector) -> (Matrix, Vector) {
    let squares = w.map(|component| graph.mul(component, component));
    let products = Axis::ALL.map(|axis| {
        let (b, c) = axis.others();
        graph.mul(w[b], w[c])
    });
    let mut u = [[graph.zero(); 3]; 3];
    for axis in Axis::ALL {
        let (a, (b, c)) = (axis.index(), axis.others());
        u[a][a] = -graph.add(squares[b], squares[c]);
        u[b][c] = graph.sub(products[a], alpha[a]);
        u[c][b] = graph.add(products[a], alpha[a]);
    }
    (u, products)
}

/// `I alpha + tilde(w) I w` by the entries of `U`: about x it is
/// `I_xx alpha_x + (I_zz - I_yy) w_y w_z - I_xy U_zx + I_xz U_yx + I_yz (U_yy - U_zz)`.
fn euler(graph: &mut ExprGraph, tensor: &Symmetric, motion: &BodyMotion) -> Vector {
    let BodyMotion {
        u, products, alpha, ..
    } = motion;
    Axis::ALL.map(|axis| {
        let (a, (b, c)) = (axis.index(), axis.others());
        let mut sum = graph.mul(tensor.diagonal[a], alpha[a]);
        let spread = graph.sub(tensor.diagonal[c], tensor.diagonal[b]);
        // w_y² - w_z² is U_yy - U_zz: sums of squares that are there already.
        let tilt = graph.sub(u[b][b], u[c][c]);
        let products = [
            (spread, products[a]),
            (-tensor.entry(a, b), u[c][a]),
            (tensor.entry(a, c), u[b][a]),
            (tensor.entry(b, c), tilt),
        ];
        for (constant, motion) in products {
            let term = graph.mul(constant, motion);
            sum = graph.add(sum, term);
        }
        sum
    })
}

/// The generalized force of every speed, from the wrench on every body: from the leaves inward.
fn project(
    graph: &mut ExprGraph,
    tree: &Tree,
    frames: &BodyMap<Frame>,
    mut wrenches: BodyMap<Wrench>,
) -> Vec<Expr> {
    let mut tau = vec![graph.zero(); tree.n_speeds];
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let frame = &frames[body];
        let Wrench {
            mut force,
            mut moment,
        } = wrenches[body];
        graph.name_vector(force, "f");
        graph.name_vector(moment, "n");
        let joint = &tree.body(body).joint;
        for (axis, motion) in frames::angular_velocity(joint)
            .into_iter()
            .flatten()
            .enumerate()
        {
            add(graph, &mut tau, Some(motion), moment[axis]);
        }
        match &frame.turning {
            Turning::Angles(rotations) => {
                for rotation in rotations.iter().rev() {
                    add(
                        graph,
                        &mut tau,
                        rotation.motion,
                        moment[rotation.axis.index()],
                    );
                    force = rotation.backward(graph, force);
                    moment = rotation.backward(graph, moment);
                }
            }
            Turning::Matrix(matrix) => {
                let back = transpose(matrix);
                [force, moment] = [force, moment].map(|v| graph.mul_vector(&back, v));
            }
        }
        for (axis, shift) in joint.shifts().into_iter().enumerate() {
            add(graph, &mut tau, shift, force[axis]);
        }
        [force, moment] = [force, moment].map(|v| frame.before_constant(graph, v));
        if let Some(lower) = tree.lower(body) {
            let lever = graph.cross(frame.offset, force);
            let moment = graph.add_vectors(moment, lever);
            graph.enter(lower);
            let below = wrenches[lower];
            wrenches[lower] = Wrench {
                force: graph.add_vectors(below.force, force),
                moment: graph.add_vectors(below.moment, moment),
            };
        }
    }
    tau
}

/// Adds what acts along a motion to the generalized force of its speed.
fn add(graph: &mut ExprGraph, tau: &mut [Expr], motion: Option<Motion>, along: Expr) {
    let Some(Motion { speed, factor }) = motion else {
        return;
    };
    let factor = graph.number(factor);
    let share = graph.mul(factor, along);
    tau[speed.index()] = graph.add(tau[speed.index()], share);
}
