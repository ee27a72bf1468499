//! How a joint turns its body: sines and cosines of its angles, its transformation matrix, the rates of its angles.

use super::joint::coordinate;
use crate::{
    expr::{Expr, ExprGraph, Input, Matrix, Vector, transpose},
    tree::{Attitude, Coordinate, Joint, Tree, snapped_sin_cos},
};

/// Sine and cosine of a joint's three angles.
#[derive(Clone, Copy, Debug)]
pub struct Trigonometry {
    /// `sin(theta_1)`, `sin(theta_2)`, `sin(theta_3)`.
    pub sines: Vector,
    /// `cos(theta_1)`, `cos(theta_2)`, `cos(theta_3)`.
    pub cosines: Vector,
}

/// Sines and cosines of three angles: numbers where they are locked, made exact as entries of rotations are.
pub fn trigonometry(graph: &mut ExprGraph, tree: &Tree, angles: [Coordinate; 3]) -> Trigonometry {
    let values = angles.map(|angle| match angle {
        Coordinate::Locked(angle) => Err(angle),
        _ => Ok(coordinate(graph, angle)),
    });
    let sines = values.map(|angle| match angle {
        Ok(angle) => graph.sin(angle),
        Err(locked) => graph.number(snapped_sin_cos(locked, tree.snap).0),
    });
    let cosines = values.map(|angle| match angle {
        Ok(angle) => graph.cos(angle),
        Err(locked) => graph.number(snapped_sin_cos(locked, tree.snap).1),
    });
    for i in 0..3 {
        graph.name(sines[i], format!("sin{}", i + 1));
        graph.name(cosines[i], format!("cos{}", i + 1));
    }
    Trigonometry { sines, cosines }
}

/// From the joint's axes in the lower body to the body's: Eq. (4), or `C(e)^T`.
pub fn of_joint(graph: &mut ExprGraph, tree: &Tree, joint: &Joint) -> Matrix {
    match joint.attitude() {
        Attitude::Angles(angles) => {
            let trigonometry = trigonometry(graph, tree, angles);
            body_fixed_123(graph, &trigonometry)
        }
        Attitude::EulerParameters(parameters) => {
            let e = parameters.map(|parameter| graph.input(Input::Q(parameter)));
            transpose(&quaternion(graph, e))
        }
    }
}

/// `C(e)` of a unit quaternion, scalar first, Hamilton's product: body components to lower-body components.
fn quaternion(graph: &mut ExprGraph, [e0, e1, e2, e3]: [Expr; 4]) -> Matrix {
    let two = graph.number(2.0);
    let (d1, d2, d3) = (graph.mul(two, e1), graph.mul(two, e2), graph.mul(two, e3));
    let one = graph.one();
    let (s1, s2, s3) = (graph.mul(d1, e1), graph.mul(d2, e2), graph.mul(d3, e3));
    let mut sum = |a: Expr, b: Expr, c: Expr, d: Expr| {
        let (a, b) = (graph.mul(a, b), graph.mul(c, d));
        (graph.add(a, b), graph.sub(a, b))
    };
    let (yx, xy) = sum(d1, e2, d3, e0);
    let (xz, zx) = sum(d1, e3, d2, e0);
    let (zy, yz) = sum(d2, e3, d1, e0);
    let mut diagonal = |a: Expr, b: Expr| {
        let both = graph.add(a, b);
        graph.sub(one, both)
    };
    [
        [diagonal(s2, s3), xy, xz],
        [yx, diagonal(s1, s3), yz],
        [zx, zy, diagonal(s1, s2)],
    ]
}

fn body_fixed_123(graph: &mut ExprGraph, trigonometry: &Trigonometry) -> Matrix {
    let ([s1, s2, s3], [c1, c2, c3]) = (trigonometry.sines, trigonometry.cosines);
    // The products are taken in one association, so that rows share them.
    let (s1s2, c1s2) = (graph.mul(s1, s2), graph.mul(c1, s2));
    let mut sum_of_products = |a: [Expr; 2], b: [Expr; 2]| {
        let (a, b) = (graph.mul(a[0], a[1]), graph.mul(b[0], b[1]));
        graph.add(a, b)
    };
    let xy = sum_of_products([c1, s3], [s1s2, c3]);
    let xz = sum_of_products([s1, s3], [-c1s2, c3]);
    let yy = sum_of_products([c1, c3], [-s1s2, s3]);
    let yz = sum_of_products([s1, c3], [c1s2, s3]);
    [
        [graph.mul(c2, c3), xy, xz],
        [graph.mul(-c2, s3), yy, yz],
        [s2, graph.mul(-s1, c2), graph.mul(c1, c2)],
    ]
}

/// The rates of three free angles, Eq. (9).
pub fn rates(
    graph: &mut ExprGraph,
    tree: &Tree,
    angles: [Coordinate; 3],
    [w1, w2, w3]: Vector,
) -> Vector {
    let t = trigonometry(graph, tree, angles);
    let (s3, c3) = (t.sines[2], t.cosines[2]);
    let (a, b) = (graph.mul(c3, w1), graph.mul(s3, w2));
    let along_lower_axis = graph.sub(a, b);
    let theta1_dot = graph.div(along_lower_axis, t.cosines[1]);
    let (a, b) = (graph.mul(s3, w1), graph.mul(c3, w2));
    let theta2_dot = graph.add(a, b);
    let shared = graph.mul(t.sines[1], theta1_dot);
    [theta1_dot, theta2_dot, graph.sub(w3, shared)]
}
