//! Transformation matrices, Eqs. (2)-(5), or of Euler parameters.

use super::given;
use crate::{
    expr::{Expr, ExprGraph, Input, Matrix, Vector, transpose},
    id::BodyMap,
    tree::{ChartCoordinates, Coordinate, Joint, Orientation, Tree, snapped_sin_cos},
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
        _ => Ok(given::coordinate(graph, angle)),
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
    if let Some(angles) = joint.angles() {
        let trigonometry = trigonometry(graph, tree, angles);
        return body_fixed_123(graph, &trigonometry);
    }
    let e = joint
        .euler_parameters()
        .map(|parameter| graph.input(Input::Q(parameter)));
    transpose(&quaternion(graph, e))
}

/// `JR_K`, Eq. (4), after the constant `A_K`: lower-body components to body components, for every body.
pub fn relative(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Matrix> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        let turned = of_joint(graph, tree, joint);
        let constant = given::constant(graph, &joint.rotation);
        let matrix = graph.mul_matrices(&turned, &constant);
        graph.name_matrix(&matrix, "rel");
        matrix
    })
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

/// The coordinates with their quaternions brought back to length one: `e (3 - e·e) / 2`, twice.
pub fn normalized(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let mut coordinates = vec![graph.zero(); tree.n_coordinates];
    for body in tree.body_ids() {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        for (_, coordinate) in joint.coordinates() {
            coordinates[coordinate.index()] = graph.input(Input::Q(coordinate));
        }
        if let Orientation::AngularVelocity {
            chart: ChartCoordinates::EulerParameters(parameters),
            ..
        } = joint.orientation
        {
            let mut e = parameters.map(|parameter| graph.input(Input::Q(parameter)));
            for _ in 0..2 {
                e = nearer_to_unit(graph, e);
            }
            for (parameter, e) in parameters.into_iter().zip(e) {
                coordinates[parameter.index()] = e;
            }
        }
    }
    coordinates
}

/// A step of Newton's iteration for `e / |e|`.
fn nearer_to_unit(graph: &mut ExprGraph, e: [Expr; 4]) -> [Expr; 4] {
    let mut square = graph.mul(e[0], e[0]);
    for entry in &e[1..] {
        let term = graph.mul(*entry, *entry);
        square = graph.add(square, term);
    }
    let (three, half) = (graph.number(3.0), graph.number(0.5));
    let rest = graph.sub(three, square);
    let factor = graph.mul(half, rest);
    e.map(|entry| graph.mul(factor, entry))
}
