//! Transformation matrices, Eqs. (2)-(5).

use super::given;
use crate::{
    expr::{Expr, ExprGraph, Matrix, Vector},
    id::BodyMap,
    tree::{Joint, Tree},
};

/// Sine and cosine of a joint's three angles.
#[derive(Clone, Copy, Debug)]
pub struct Trigonometry {
    /// `sin(theta_1)`, `sin(theta_2)`, `sin(theta_3)`.
    pub sines: Vector,
    /// `cos(theta_1)`, `cos(theta_2)`, `cos(theta_3)`.
    pub cosines: Vector,
}

/// Sines and cosines of a joint's angles: numbers where they are locked.
pub fn trigonometry(graph: &mut ExprGraph, joint: &Joint) -> Trigonometry {
    let angles = joint.angles.map(|angle| given::coordinate(graph, angle));
    let sines = angles.map(|angle| graph.sin(angle));
    let cosines = angles.map(|angle| graph.cos(angle));
    for i in 0..3 {
        graph.name(sines[i], format!("sin{}", i + 1));
        graph.name(cosines[i], format!("cos{}", i + 1));
    }
    Trigonometry { sines, cosines }
}

/// `JR_K`, Eq. (4): lower-body components to body components, for every body.
pub fn relative(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Matrix> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let trigonometry = trigonometry(graph, &tree.body(body).joint);
        let matrix = body_fixed_123(graph, &trigonometry);
        graph.name_matrix(&matrix, "rel");
        matrix
    })
}

/// `R_K = JR_K R_J`, Eq. (3): inertial components to body components, for every body.
pub fn absolute(graph: &mut ExprGraph, tree: &Tree, relative: &BodyMap<Matrix>) -> BodyMap<Matrix> {
    BodyMap::outward(tree.bodies.len(), |body, rotations| {
        graph.enter(body);
        let Some(lower) = tree.lower(body) else {
            return relative[body];
        };
        let matrix = graph.mul_matrices(&relative[body], &rotations[lower]);
        graph.name_matrix(&matrix, "rot");
        matrix
    })
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
