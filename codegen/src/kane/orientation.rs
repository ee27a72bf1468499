//! Transformation matrices of all bodies, Eqs. (2)-(5).

use crate::{
    expr::{Expr, ExprGraph, Input, Matrix, Purpose},
    given::{self, orientation},
    id::BodyMap,
    tree::Tree,
};

/// `JR_K`, Eq. (4), after the constant `A_K`: lower-body components to body components, for every body.
pub fn relative(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Matrix> {
    graph.begin(Purpose::Rotation);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        let turned = orientation::of_joint(graph, tree, joint);
        let constant = given::constant(graph, &joint.rotation);
        let matrix = graph.mul_matrices(&turned, &constant);
        graph.name_matrix(&matrix, "rel");
        matrix
    })
}

/// `R_K = JR_K R_J`, Eq. (3): inertial components to body components, for every body.
pub fn absolute(graph: &mut ExprGraph, tree: &Tree, relative: &BodyMap<Matrix>) -> BodyMap<Matrix> {
    graph.begin(Purpose::Rotation);
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

/// The coordinates with their quaternions brought back to length one: `e (3 - e·e) / 2`, twice.
pub fn normalized(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let mut coordinates = vec![graph.zero(); tree.n_coordinates];
    for body in tree.body_ids() {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        for (_, coordinate) in joint.coordinates() {
            coordinates[coordinate.index()] = graph.input(Input::Q(coordinate));
        }
        if let Some(parameters) = joint.euler_parameters() {
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
