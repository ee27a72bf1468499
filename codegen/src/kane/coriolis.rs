//! The Coriolis matrix and the rate of the mass matrix, from the partial velocities of Eqs. (15), (32) and their derivatives,
//! Eqs. (20), (33), as sums over bodies.
//!
//! Of a particle `C` is `m V^T V_dot`, with `V_dot` the derivative in the inertial frame, `V_G_dot_K + tilde(w_K) V_G_K` for a mass
//! centre. What the particles of a body add to its mass centre's comes to `W_K^T (I_K W_dot_K + tilde(S_K w_K) W_K)`, with the second
//! moments `S = tr(I) 1 / 2 - I`; times `y` it is the moment of Eq. (43), for `S w × w = w × I w`. The parts with `tilde` are skew.

use super::velocity;
use crate::{
    expr::{Axis, Expr, ExprGraph, Symmetric, Vector},
    given,
    id::{BodyId, SpeedId},
    solve::{SpeedMatrix, zero_matrix},
    tree::Tree,
};

/// The columns of a body's partial velocities, or of their derivatives.
type Columns = Vec<(SpeedId, Vector)>;

/// What a body adds: mass and inertia, its angular velocity, partial velocities with their derivatives.
struct Moving {
    mass: Expr,
    inertia: Symmetric,
    w: Vector,
    velocities: [Columns; 2],
    angular: [Columns; 2],
}

/// `C = sum_K m_K V_G_K^T (V_G_dot_K + tilde(w_K) V_G_K) + W_K^T (I_K W_dot_K + tilde(S_K w_K) W_K)`.
pub fn coriolis_matrix(graph: &mut ExprGraph, tree: &Tree) -> SpeedMatrix {
    let mut c = zero(graph, tree);
    for (body, moving) in moving(graph, tree) {
        graph.enter(body);
        moving.add_changes(graph, &mut c);
        let momentum = graph.scale(moving.mass, moving.w);
        add_skew(graph, &mut c, &moving.velocities[0], momentum);
        let spread = spread(graph, &moving.inertia, moving.w);
        add_skew(graph, &mut c, &moving.angular[0], spread);
    }
    c
}

/// `dA/dt = C + C^T`, of which the skew parts are no part.
pub fn mass_matrix_dot(graph: &mut ExprGraph, tree: &Tree) -> SpeedMatrix {
    let mut changes = zero(graph, tree);
    for (body, moving) in moving(graph, tree) {
        graph.enter(body);
        moving.add_changes(graph, &mut changes);
    }
    let mut sum = zero(graph, tree);
    for row in 0..tree.n_speeds {
        for column in 0..=row {
            let entry = graph.add(changes[row][column], changes[column][row]);
            (sum[row][column], sum[column][row]) = (entry, entry);
        }
    }
    sum
}

fn zero(graph: &mut ExprGraph, tree: &Tree) -> SpeedMatrix {
    zero_matrix(graph, tree.n_speeds)
}

fn moving(graph: &mut ExprGraph, tree: &Tree) -> Vec<(BodyId, Moving)> {
    let rotational = velocity::rotational(graph, tree);
    let partials = velocity::partials(graph, tree, &rotational.relative);
    let dot = velocity::partials_dot(graph, tree, &rotational, &partials);
    let of_body = |body: BodyId| {
        graph.enter(body);
        let velocities = [&partials.mass_center[body], &dot.mass_center[body]];
        let angular = [&partials.angular[body], &dot.angular[body]];
        let moving = Moving {
            mass: given::mass(graph, tree.body(body)),
            inertia: given::inertia(graph, tree.body(body)),
            w: rotational.w[body],
            velocities: velocities.map(|row| row.merged_columns(graph, tree)),
            angular: angular.map(|row| row.merged_columns(graph, tree)),
        };
        (body, moving)
    };
    tree.body_ids().map(of_body).collect()
}

impl Moving {
    /// `m V_G^T V_G_dot + W^T I W_dot`.
    fn add_changes(&self, graph: &mut ExprGraph, c: &mut SpeedMatrix) {
        let [columns, dots] = &self.velocities;
        for &(speed, dot) in dots {
            let needed = graph.scale(self.mass, dot);
            add(graph, c, columns, speed, needed);
        }
        let [columns, dots] = &self.angular;
        for &(speed, dot) in dots {
            let needed = graph.mul_symmetric(&self.inertia, dot);
            add(graph, c, columns, speed, needed);
        }
    }
}

/// `S w`, with the second moments about the mass centre.
fn spread(graph: &mut ExprGraph, inertia: &Symmetric, w: Vector) -> Vector {
    let half = graph.number(0.5);
    let [xx, yy, zz] = inertia.diagonal;
    let sum = graph.add(xx, yy);
    let trace = graph.add(sum, zz);
    let trace = graph.mul(half, trace);
    let second = Symmetric {
        diagonal: Axis::ALL.map(|axis| graph.sub(trace, inertia.diagonal[axis.index()])),
        mixed: inertia.mixed.map(|mixed| -mixed),
    };
    graph.mul_symmetric(&second, w)
}

/// Adds what a column needs, projected on all rows, to the column of its speed.
fn add(
    graph: &mut ExprGraph,
    c: &mut SpeedMatrix,
    rows: &Columns,
    column: SpeedId,
    needed: Vector,
) {
    for &(row, along) in rows {
        let term = graph.dot(along, needed);
        let entry = &mut c[row.index()][column.index()];
        *entry = graph.add(*entry, term);
    }
}

/// Adds `columns^T tilde(v) columns`.
fn add_skew(graph: &mut ExprGraph, c: &mut SpeedMatrix, columns: &Columns, v: Vector) {
    for (place, &(s, second)) in columns.iter().enumerate() {
        for &(r, first) in &columns[..place] {
            let across = graph.cross(second, first);
            let term = graph.dot(v, across);
            for (row, column, term) in [(r, s, term), (s, r, -term)] {
                let entry = &mut c[row.index()][column.index()];
                *entry = graph.add(*entry, term);
            }
        }
    }
}
