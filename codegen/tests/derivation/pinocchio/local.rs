//! Derivatives along a floating base's own axes.
//!
//! Here its linear speeds and forces are along inertial axes: with `R` from the base's axes and `T` that of all speeds, `u = T v`,
//! `u_dot = T (a + w x v)`, `tau = T tau_there`, and displacements likewise. As the base turns by e in its axes, what is given along
//! inertial axes changes there by its product with e, and a result that is wanted along them by the opposite.

use kane_test_support::{json::flat, numeric::Matrix};
use serde_json::Value;

use super::robot::{Robot, base, cross, sum, vector};

/// What the base has at a sample.
pub(super) struct Local {
    /// `T`.
    turn: Matrix,
    /// How v changes with displacements.
    v_by_q: Matrix,
    /// How a changes with v.
    a_by_v: Matrix,
}

impl Local {
    pub(super) fn at(robot: &Robot, sample: &Value) -> Self {
        let (n, [q, v]) = (
            robot.tree.n_speeds,
            ["q", "v"].map(|name| flat(&sample[name])),
        );
        let r = base(&q);
        let mut turn = Matrix::identity(n);
        for (row, entries) in r.iter().enumerate() {
            turn.entries[row * n..][..3].copy_from_slice(entries);
        }
        let v_by_q = crossed(n, 3, vector(&v, 0));
        let a_by_v = v_by_q.plus_scaled(-1.0, &crossed(n, 0, vector(&v, 3)));
        Self {
            turn,
            v_by_q,
            a_by_v,
        }
    }

    /// Of forces, by coordinates, speeds and accelerations; the accelerations are those of the sample.
    pub(super) fn of_forces(&self, sample: &Value, found: [Matrix; 3]) -> [Matrix; 3] {
        let [by_q, by_u, by_a] = found.map(|matrix| self.along_base(&matrix));
        let tau_by_q = self.turned(sample, "inverse_dynamics");
        let by_q = by_q.plus_scaled(1.0, &tau_by_q);
        let by_q = by_q.plus_scaled(-1.0, &by_u.product(&self.v_by_q));
        let by_q = by_q.plus_scaled(-1.0, &by_a.product(&self.whole_by_q(sample, "a")));
        let by_u = by_u.plus_scaled(-1.0, &by_a.product(&self.a_by_v));
        [by_q, by_u, by_a]
    }

    /// Of accelerations, by coordinates, speeds and forces; the forces are those of the sample.
    pub(super) fn of_accelerations(&self, sample: &Value, found: [Matrix; 3]) -> [Matrix; 3] {
        let [by_q, by_u, by_tau] = found.map(|matrix| self.along_base(&matrix));
        let whole_by_q = self.whole_by_q(sample, "forward_dynamics");
        let by_q = by_q.plus_scaled(1.0, &whole_by_q);
        let by_q = by_q.plus_scaled(-1.0, &by_u.product(&self.v_by_q));
        let by_q = by_q.plus_scaled(-1.0, &by_tau.product(&self.turned(sample, "tau")));
        let by_u = by_u.plus_scaled(1.0, &self.a_by_v);
        [by_q, by_u, by_tau]
    }

    /// `T^T m T`.
    fn along_base(&self, m: &Matrix) -> Matrix {
        self.turn.transposed().product(&m.product(&self.turn))
    }

    /// How forces that are held along inertial axes change with displacements.
    fn turned(&self, sample: &Value, forces: &str) -> Matrix {
        crossed(self.turn.n, 3, vector(&flat(&sample[forces]), 0))
    }

    /// How `a + w x v` that is held along inertial axes changes with displacements.
    fn whole_by_q(&self, sample: &Value, accelerations: &str) -> Matrix {
        let [v, a] = ["v", accelerations].map(|name| flat(&sample[name]));
        let whole = sum(vector(&a, 0), cross(vector(&v, 3), vector(&v, 0)));
        crossed(self.turn.n, 3, whole)
    }
}

/// The matrix that makes of what begins at this column its product with a vector, `x` first, in the base's linear rows.
fn crossed(n: usize, first: usize, x: [f64; 3]) -> Matrix {
    let mut matrix = Matrix::new(n, vec![0.0; n * n]);
    for column in 0..3 {
        let mut axis = [0.0; 3];
        axis[column] = 1.0;
        for (row, entry) in cross(x, axis).into_iter().enumerate() {
            matrix.entries[row * n + first + column] = entry;
        }
    }
    matrix
}
