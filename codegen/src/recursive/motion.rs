//! How links move, and the wrenches that they need for it.
//!
//! Inertia forces are taken about the link's origin, so no velocity of a mass centre is formed; gravity is an
//! upward acceleration of the inertial frame. With `U = tilde(alpha) + tilde(w)^2` the force is `m a + U h`,
//! and the moment is `h × a` plus products of the inertia's components with entries of U and of `w w^T`.

use super::{
    link::{self, Link, Turning},
    linkage::Linkage,
    plan::Technique,
    rotation::{Rotation, Turn},
};
use crate::{
    expr::{Axis, Expr, ExprGraph, Matrix, Vector, negated},
    id::BodyMap,
    kane::{Accelerations, given},
    tree::{Joint, Motion},
};

/// A force and its moment about the link's origin, link components.
#[derive(Clone, Copy, Debug)]
pub struct Wrench {
    /// The force.
    pub force: Vector,
    /// The moment.
    pub moment: Vector,
}

impl Wrench {
    /// Both together, about the same point.
    pub(super) fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            force: graph.add_vectors(self.force, other.force),
            moment: graph.add_vectors(self.moment, other.moment),
        }
    }
}

/// A link's motion, link components.
#[derive(Clone, Copy, Debug)]
struct LinkMotion {
    /// Angular velocity.
    w: Vector,
    /// `tilde(alpha) + tilde(w)^2`: what a point's position is multiplied by for its acceleration.
    u: Matrix,
    /// The squares of its components, and the products `w_y w_z`, `w_z w_x`, `w_x w_y`.
    squares: Vector,
    products: Vector,
    /// Angular acceleration.
    alpha: Vector,
    /// Acceleration of the origin, less gravity.
    a: Vector,
}

/// What each link needs to move as it does, weight included.
pub(super) fn wrenches(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    accelerations: Accelerations,
) -> BodyMap<Wrench> {
    let Linkage {
        tree, links, falls, ..
    } = linkage;
    let gravity = given::gravity(graph, tree);
    let by_second = linkage.plan.uses(Technique::SecondMoments);
    let motions = BodyMap::outward(tree.bodies.len(), |body, motions: &BodyMap<LinkMotion>| {
        graph.enter(body);
        let lower = tree.lower(body).map(|lower| &motions[lower]);
        let joint = &tree.body(body).joint;
        let base = if falls[body] {
            graph.zero_vector()
        } else {
            negated(gravity)
        };
        outward(graph, joint, &links[body], lower, base, accelerations)
    });
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let (link, motion) = (&links[body], &motions[body]);
        let inertia = &link.inertia;
        let carried = graph.scale(inertia.mass, motion.a);
        let turned = graph.mul_vector(&motion.u, inertia.moment);
        let lever = graph.cross(inertia.moment, motion.a);
        let spin = euler(graph, link, motion, by_second);
        Wrench {
            force: graph.add_vectors(carried, turned),
            moment: graph.add_vectors(spin, lever),
        }
    })
}

/// The motion of a link from that of its lower link; `None` is the inertial frame.
fn outward(
    graph: &mut ExprGraph,
    joint: &Joint,
    link: &Link,
    lower: Option<&LinkMotion>,
    base: Vector,
    accelerations: Accelerations,
) -> LinkMotion {
    let s_dot = given::shift_speeds(graph, joint);
    let s_ddot = joint
        .shifts()
        .map(|s| given::acceleration(graph, s, accelerations));
    let (mut w, mut alpha) = ([graph.zero(); 3], [graph.zero(); 3]);
    let mut a = base;
    if let Some(lower) = lower {
        (w, alpha) = (lower.w, lower.alpha);
        let turned = graph.mul_vector(&lower.u, link.offset);
        a = graph.add_vectors(lower.a, turned);
    }
    [w, alpha, a] = [w, alpha, a].map(|v| link.constant.forward(graph, v));
    let two = graph.number(2.0);
    let twice = graph.scale(two, s_dot);
    let coriolis = graph.cross(w, twice);
    a = graph.add_vectors(a, coriolis);
    a = graph.add_vectors(a, s_ddot);
    match &link.turning {
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
    if let Some(motions) = link::angular_velocity(joint) {
        (w, alpha) = spin(graph, motions, w, alpha, accelerations);
    }
    graph.name_vector(w, "w");
    graph.name_vector(alpha, "alpha");
    graph.name_vector(a, "a");
    let squares = w.map(|component| graph.mul(component, component));
    let products = Axis::ALL.map(|axis| {
        let (b, c) = axis.others();
        graph.mul(w[b], w[c])
    });
    let u = acceleration_matrix(graph, squares, products, alpha);
    graph.name_matrix(&u, "u");
    LinkMotion {
        w,
        u,
        squares,
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

/// `tilde(alpha) + tilde(w)^2`.
fn acceleration_matrix(
    graph: &mut ExprGraph,
    squares: Vector,
    products: Vector,
    alpha: Vector,
) -> Matrix {
    let mut u = [[graph.zero(); 3]; 3];
    for axis in Axis::ALL {
        let (a, (b, c)) = (axis.index(), axis.others());
        u[a][a] = -graph.add(squares[b], squares[c]);
        u[b][c] = graph.sub(products[a], alpha[a]);
        u[c][b] = graph.add(products[a], alpha[a]);
    }
    u
}

/// `I alpha + tilde(w) I w` by the entries of `U`: about x it is
/// `I_xx alpha_x + (I_zz - I_yy) w_y w_z - I_xy U_zx + I_xz U_yx + I_yz (U_yy - U_zz)`.
///
/// With the second moments `S = tr(I) 1 / 2 - I` the first two terms are `S_yy U_zy - S_zz U_yz`: one, where a second moment
/// is zero.
fn euler(graph: &mut ExprGraph, link: &Link, motion: &LinkMotion, by_second: bool) -> Vector {
    let LinkMotion {
        u,
        squares,
        products,
        alpha,
        ..
    } = motion;
    let tensor = &link.inertia.inertia;
    Axis::ALL.map(|axis| {
        let (a, (b, c)) = (axis.index(), axis.others());
        let second = [link.second[b], link.second[c]];
        let zeros = second.map(|moment| graph.is_zero(moment));
        let [first, gyroscopic] = if by_second && zeros[0] != zeros[1] {
            [(second[0], u[c][b]), (-second[1], u[b][c])]
        } else {
            let spread = graph.sub(tensor.diagonal[c], tensor.diagonal[b]);
            [(tensor.diagonal[a], alpha[a]), (spread, products[a])]
        };
        // U_yy - U_zz without what cancels.
        let tilt = graph.sub(squares[b], squares[c]);
        let products = [
            gyroscopic,
            (-tensor.entry(a, b), u[c][a]),
            (tensor.entry(a, c), u[b][a]),
            (tensor.entry(b, c), tilt),
        ];
        let mut sum = graph.mul(first.0, first.1);
        for (constant, motion) in products {
            let term = graph.mul(constant, motion);
            sum = graph.add(sum, term);
        }
        sum
    })
}

/// Adds what acts along a motion to the generalized force of its speed.
pub fn add(graph: &mut ExprGraph, tau: &mut [Expr], motion: Option<Motion>, along: Expr) {
    let Some(Motion { speed, factor }) = motion else {
        return;
    };
    let factor = graph.number(factor);
    let share = graph.mul(factor, along);
    tau[speed.index()] = graph.add(tau[speed.index()], share);
}
