//! A closed loop: a motor at the crank turns a four-bar linkage.
//!
//! The model is the linkage cut open between coupler and rocker, a tree of three links. The gap `e` between the two ends has the rate
//! `ė = J u`, and `ë = J u̇ + J̇ u`. Forces `λ` on the coupler's end, and `-λ` on the rocker's, hold them together: `M u̇ + b = τ + Jᵀ λ`.
//!
//! The controller wants the crank to accelerate by `a`. With `ë = 0` the other two joints follow, with the inverse dynamics of all three
//! the forces `τ + Jᵀ λ`; where no motor acts, these are `λ`'s alone, so they give `λ`, and that the motor's torque.

use std::fmt;

use kane::{
    functions::Seen,
    integrate::rk4_step_with,
    inverse_kinematics::{Goal, InverseKinematics, Limits},
    view,
};
use nalgebra::{Matrix2, SMatrix, SVector, Vector2};

use crate::{
    CallTimes, Desired, PERIOD,
    four_bar::{self, NQ, NU, Prepared, frames},
    periods, raise,
};

/// How fast errors of the crank fade, rad/s.
const BANDWIDTH: f64 = 40.0;
/// How fast the plant closes what rounding and integration open, 1/s.
const CLOSING: f64 = 100.0;
/// Twice the area of the triangle that coupler and rocker span, m², below which the law does without.
const LEAST_AREA: f64 = 1e-6;
/// Where the crank begins, rad.
const START: f64 = 0.3;

/// The ends of the loop's two branches, in the plane of the linkage.
struct Ends {
    /// `e`, the coupler's end as it is seen from the rocker's, m.
    gap: Vector2<f64>,
    /// `J`.
    jacobian: SMatrix<f64, 2, NU>,
    /// `J̇ u`, m/s².
    drift: Vector2<f64>,
}

impl Ends {
    fn new(linkage: &Prepared<f64>, q: &[f64; NQ], u: &[f64; NU]) -> Self {
        let [mut coupler, mut rocker, mut drift, mut drift_of_rocker] = [[0.0; 3]; 4];
        let [mut jacobian, mut jacobian_of_rocker] = [[[0.0; NU]; 3]; 2];
        four_bar::ends(
            linkage,
            q,
            u,
            &mut coupler,
            &mut jacobian,
            &mut drift,
            &mut rocker,
            &mut jacobian_of_rocker,
            &mut drift_of_rocker,
        );
        let between = |a: [f64; 3], b: [f64; 3]| Vector2::from_fn(|i, _| a[i] - b[i]);
        Self {
            gap: between(coupler, rocker),
            jacobian: SMatrix::from_fn(|i, k| jacobian[i][k] - jacobian_of_rocker[i][k]),
            drift: between(drift, drift_of_rocker),
        }
    }

    /// The columns of `J` that belong to coupler and rocker.
    fn of_followers(&self) -> Matrix2<f64> {
        self.jacobian.fixed_columns::<2>(1).into_owned()
    }
}

/// The law, and what it knows of the linkage.
#[derive(Debug)]
pub struct Controller {
    linkage: Prepared<f64>,
}

impl Default for Controller {
    fn default() -> Self {
        let linkage = Prepared::nominal();
        Self { linkage }
    }
}

impl Controller {
    /// The motor's torque, N m; `None` where coupler and rocker are in one line, which the crank cannot push them out of.
    pub fn torque(&self, q: &[f64; NQ], u: &[f64; NU], desired: &Desired<f64, 1>) -> Option<f64> {
        let [crank] = desired.acceleration(BANDWIDTH, &[q[0]], &[u[0]]);
        let ends = Ends::new(&self.linkage, q, u);
        let of_crank = ends.jacobian.column(0);
        let of_followers = ends.of_followers();
        let area = of_followers.determinant();
        let of_others = of_followers
            .try_inverse()
            .filter(|_| area.abs() > LEAST_AREA)?;
        let others = of_others * -(ends.drift + of_crank * crank);

        let mut forces = [0.0; NU];
        let u_dot = [crank, others[0], others[1]];
        four_bar::inverse_dynamics(&self.linkage, q, u, &u_dot, &mut forces);
        let holding = of_others.transpose() * Vector2::new(forces[1], forces[2]);
        Some(forces[0] - of_crank.dot(&holding))
    }
}

/// The forces of motor and loop together, `τ + Jᵀ λ`, and `λ`, N: so that `ë + 2 κ ė + κ² e = 0` with the `κ` of [`CLOSING`], which
/// keeps what rounding opens from growing (Baumgarte's stabilisation).
fn held(
    plant: &Prepared<f64>,
    q: &[f64; NQ],
    u: &[f64; NU],
    tau: &[f64; NU],
) -> ([f64; NU], Vector2<f64>) {
    let Ends {
        gap,
        jacobian,
        drift,
    } = Ends::new(plant, q, u);
    let (mut free, mut inverse) = ([0.0; NU], [[0.0; NU]; NU]);
    four_bar::forward_dynamics(plant, q, u, tau, &mut free);
    four_bar::mass_matrix_inverse(plant, q, &mut inverse);
    let rate = jacobian * view::vector(u);
    let opening = jacobian * view::vector(&free) + drift;
    let closing = 2.0 * CLOSING * rate + CLOSING * CLOSING * gap;
    // `Δ`, what unit forces at the ends accelerate.
    let delta = jacobian * view::matrix(&inverse) * jacobian.transpose();
    let lambda = delta
        .cholesky()
        .map(|delta| delta.solve(&-(opening + closing)));
    // Where nothing can move the ends apart, no number is right.
    let lambda = lambda.unwrap_or(Vector2::from_element(f64::NAN));
    let forces: SVector<f64, NU> = view::vector(tau) + jacobian.transpose() * lambda;
    (forces.into(), lambda)
}

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Report {
    /// The greatest error of the crank, rad.
    pub error: f64,
    /// How far the ends came apart, m.
    pub gap: f64,
    /// The greatest force in the loop, N.
    pub force: f64,
    /// The greatest torque of the motor, N m.
    pub torque: f64,
    /// The coordinates at the end, rad.
    pub q: [f64; NQ],
}

/// The linkage with its loop closed and the crank at an angle, rad; `None` where that is too far from where it begins.
pub fn closed(linkage: &Prepared<f64>, crank: f64) -> Option<[f64; NQ]> {
    let mut limits = Limits::of::<Prepared<f64>>();
    (limits.lower[0], limits.upper[0]) = (crank, crank);
    let solver = InverseKinematics {
        tolerance: 1e-12,
        ..InverseKinematics::new(limits)
    };
    // The rocker leans outward, so that the linkage is not folded.
    let mut q = [crank, 0.3, 1.2];
    let goal = Goal::<f64, Seen<frames::CouplerEnd, frames::RockerEnd>>::position([0.0; 3]);
    let remaining = solver.solve(linkage, &goal, &mut q, 100);
    remaining.is_within(1e-12).then_some(q)
}

/// Turns the crank so often, in `duration`, s, from rest to rest; `None` where the law has no torque.
pub fn run(turns: f64, duration: f64, calls: &mut CallTimes) -> Option<Report> {
    let (controller, plant) = (Controller::default(), Prepared::nominal());
    let start = closed(&plant, START).expect("linkage: it closes where the crank begins");
    let (mut q, mut u) = (start, [0.0; NU]);
    let end = START + turns * std::f64::consts::TAU;
    let mut report = Report::default();
    for period in 0..periods(duration) {
        let desired = Desired::between(&[START], &[end], period as f64 * PERIOD, duration);
        let torque = calls.time(|| controller.torque(&q, &u, &desired))?;
        let tau = [torque, 0.0, 0.0];
        let (_, lambda) = held(&plant, &q, &u, &tau);
        raise(&mut report.error, [desired.q[0] - q[0]]);
        raise(
            &mut report.gap,
            Ends::new(&plant, &q, &u).gap.iter().copied(),
        );
        raise(&mut report.force, [lambda.norm()]);
        raise(&mut report.torque, [torque]);
        rk4_step_with(&plant, PERIOD, &mut q, &mut u, |q, u, forces| {
            (*forces, _) = held(&plant, q, u, &tau);
        });
    }
    report.q = q;
    Some(report)
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "error up to {:.3} mrad, torque up to {:.1} N m, force in the loop up to {:.0} N, which opens by {:.1e} m",
            1e3 * self.error,
            self.torque,
            self.force,
            self.gap,
        )
    }
}
