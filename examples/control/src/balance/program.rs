//! The quadratic program: of the forces that the ground can exert, those that lead back best.

use std::{f64::consts::FRAC_1_SQRT_2, fmt};

use clarabel::{
    algebra::CscMatrix,
    solver::{DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus},
};
use nalgebra::{SMatrix, SVector};

use super::sizes::{FEET, FORCES, MOTORS, Scalar};

/// The coefficient of friction that is counted on.
const FRICTION: Scalar = 0.7;
/// How steep the pyramid of forces is that stands within the cone.
pub(super) const SLOPE: Scalar = FRICTION * FRAC_1_SQRT_2;
/// What each foot presses at least, N.
const LEAST_FORCE: Scalar = 0.5;
/// The greatest torque, N m: as much as motors of this size have. The URDF names 1000, which limits nothing.
const TORQUE: Scalar = 2.5;
/// An angular acceleration of 1 rad/s² too much is as bad as a force of so many newtons.
const LEVER: Scalar = 0.3;
/// What the square of a force costs beside the square of one that is missing: enough to choose among forces that do the same.
const REGULARISATION: Scalar = 1e-3;

/// What is linear in the forces `f` of the feet, but for a constant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Affine<const ROWS: usize> {
    pub(super) by_force: SMatrix<Scalar, ROWS, FORCES>,
    pub(super) constant: SVector<Scalar, ROWS>,
}

impl<const ROWS: usize> Affine<ROWS> {
    /// `A x + b` of this `x`.
    pub(super) fn through<const OUT: usize>(
        &self,
        a: &SMatrix<Scalar, OUT, ROWS>,
        b: &SVector<Scalar, OUT>,
    ) -> Affine<OUT> {
        Affine {
            by_force: a * self.by_force,
            constant: a * self.constant + b,
        }
    }

    /// Where the forces are these.
    pub(super) fn at(&self, forces: &SVector<Scalar, FORCES>) -> SVector<Scalar, ROWS> {
        self.by_force * forces + self.constant
    }
}

/// Rows that keep a foot's force in its pyramid, and let it press.
const PYRAMID: [[Scalar; 3]; 5] = [
    [1.0, 0.0, -SLOPE],
    [-1.0, 0.0, -SLOPE],
    [0.0, 1.0, -SLOPE],
    [0.0, -1.0, -SLOPE],
    [0.0, 0.0, -1.0],
];
/// The first of the rows that keep torques within their limits, from above and then from below.
const TORQUES: usize = FEET * PYRAMID.len();
const CONSTRAINTS: usize = TORQUES + 2 * MOTORS;
/// Of a symmetric matrix on and above its diagonal.
const UPPER: usize = FORCES * (FORCES + 1) / 2;

/// `min ½ fᵀ P f + qᵀ f` where `A f <= b`. All is allocated once; each call fills in new numbers.
pub(super) struct Program {
    solver: DefaultSolver<Scalar>,
    p: Vec<Scalar>,
    q: Vec<Scalar>,
    a: Vec<Scalar>,
    b: Vec<Scalar>,
}

impl Default for Program {
    fn default() -> Self {
        let (p, q) = (vec![0.0; UPPER], vec![0.0; FORCES]);
        let (a, b) = (vec![1.0; CONSTRAINTS * FORCES], vec![1.0; CONSTRAINTS]);
        let column_ends = |column: usize| column * (column + 1) / 2;
        let rows_of_p = (0..FORCES).flat_map(|column| 0..=column).collect();
        let columns_of_p = (0..=FORCES).map(column_ends).collect();
        let rows_of_a = (0..FORCES).flat_map(|_| 0..CONSTRAINTS).collect();
        let columns_of_a = (0..=FORCES).map(|column| column * CONSTRAINTS).collect();
        let settings = DefaultSettings {
            verbose: false,
            // New numbers are refused of what has been presolved.
            presolve_enable: false,
            // It would scale by the first numbers, which are none.
            equilibrate_enable: false,
            max_iter: 50,
            direct_solve_method: "qdldl".to_owned(),
            ..DefaultSettings::default()
        };
        let solver = DefaultSolver::new(
            &CscMatrix::new(FORCES, FORCES, columns_of_p, rows_of_p, p.clone()),
            &q,
            &CscMatrix::new(CONSTRAINTS, FORCES, columns_of_a, rows_of_a, a.clone()),
            &b,
            &[NonnegativeConeT(CONSTRAINTS)],
            settings,
        );
        Self { solver, p, q, a, b }
    }
}

impl Program {
    /// `missing` is to be small: a force, N, and an angular acceleration, rad/s². `tau` is to be within its limits.
    pub(super) fn set(&mut self, missing: &Affine<6>, tau: &Affine<MOTORS>) {
        let mut weighted = *missing;
        for i in 3..6 {
            weighted.by_force.row_mut(i).scale_mut(LEVER);
            weighted.constant[i] *= LEVER;
        }
        let p = weighted.by_force.transpose() * weighted.by_force
            + SMatrix::<Scalar, FORCES, FORCES>::identity() * REGULARISATION;
        let upper = (0..FORCES).flat_map(|j| (0..=j).map(move |i| (i, j)));
        for (entry, place) in self.p.iter_mut().zip(upper) {
            *entry = p[place];
        }
        let q = weighted.by_force.transpose() * weighted.constant;
        self.q.copy_from_slice(q.as_slice());

        let (a, b) = constraints(tau);
        self.a.copy_from_slice(a.as_slice());
        self.b.copy_from_slice(b.as_slice());
    }

    /// Solves what has been set.
    pub(super) fn solve(&mut self) {
        let updated = self.solver.update_data(&self.p, &self.q, &self.a, &self.b);
        updated.expect("lengths are those of the first numbers, and nothing is presolved");
        self.solver.solve();
    }

    /// How many iterations it took.
    pub(super) fn iterations(&self) -> u32 {
        self.solver.solution.iterations
    }

    /// The forces found, N, if there are any.
    pub(super) fn forces(&self) -> Option<SVector<Scalar, FORCES>> {
        let solution = &self.solver.solution;
        let found = solution.status == SolverStatus::Solved;
        found.then(|| SVector::from_column_slice(&solution.x))
    }
}

/// `A`, column by column, and `b`.
fn constraints(
    tau: &Affine<MOTORS>,
) -> (
    SMatrix<Scalar, CONSTRAINTS, FORCES>,
    SVector<Scalar, CONSTRAINTS>,
) {
    let mut a = SMatrix::<Scalar, CONSTRAINTS, FORCES>::zeros();
    let mut b = SVector::<Scalar, CONSTRAINTS>::zeros();
    for foot in 0..FEET {
        let (first, column) = (foot * PYRAMID.len(), 3 * foot);
        for (i, row) in PYRAMID.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                a[(first + i, column + j)] = *entry;
            }
        }
        b[first + 4] = -LEAST_FORCE;
    }
    a.fixed_rows_mut::<MOTORS>(TORQUES).copy_from(&tau.by_force);
    a.fixed_rows_mut::<MOTORS>(TORQUES + MOTORS)
        .copy_from(&-tau.by_force);
    for i in 0..MOTORS {
        b[TORQUES + i] = TORQUE - tau.constant[i];
        b[TORQUES + MOTORS + i] = TORQUE + tau.constant[i];
    }
    (a, b)
}

impl fmt::Debug for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Program").finish_non_exhaustive()
    }
}
