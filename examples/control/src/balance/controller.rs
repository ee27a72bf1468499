//! The law: which forces the ground is to exert on the feet, and the torques that make it.

use std::array::from_fn;

use kane::{rotation, view};
use nalgebra::{SMatrix, SVector};

use super::{
    program::{Affine, Program},
    sizes::{FEET, FORCES, MOTORS, ROOT, Scalar},
};
use crate::solo12::{self, NQ, NU, Prepared, balance, feet};

/// `ω`, rad/s.
const BANDWIDTH: Scalar = 15.0;

type Matrix<const ROWS: usize, const COLUMNS: usize> = SMatrix<Scalar, ROWS, COLUMNS>;
type Vector<const ROWS: usize> = SVector<Scalar, ROWS>;

/// The law, what it knows of the robot, and where that is to stand.
#[derive(Debug)]
pub struct Controller {
    robot: Prepared<Scalar>,
    /// `m`, kg.
    mass: Scalar,
    /// `c_d`, m.
    center: [Scalar; 3],
    /// How the base is to be turned, as `pose` writes it.
    rotation: [[Scalar; 3]; 3],
    program: Program,
    /// `τ` of the last call, N m.
    tau: [Scalar; MOTORS],
    /// In how many calls no forces were found.
    pub failures: u32,
}

impl Controller {
    /// Stands as at `q`.
    pub fn new(q: &[Scalar; NQ]) -> Self {
        let robot = Prepared::nominal();
        let u = [0.0; NU];
        let balance = Balance::new(&robot, q, &u);
        let (mut m, mut bias) = ([[0.0; NU]; NU], [0.0; NU]);
        solo12::mass_matrix_and_bias(&robot, q, &u, &mut m, &mut bias);
        Self {
            robot,
            // A translation of the base moves all bodies.
            mass: m[3][3],
            center: balance.center,
            rotation: balance.rotation,
            program: Program::default(),
            tau: [0.0; MOTORS],
            failures: 0,
        }
    }

    /// `τ`, N m; `solving` makes the call of the solver. Where no forces are found, it is what it was.
    pub fn torque(
        &mut self,
        q: &[Scalar; NQ],
        u: &[Scalar; NU],
        solving: impl FnOnce(&mut dyn FnMut()),
    ) -> [Scalar; MOTORS] {
        let (mut m, mut bias) = ([[0.0; NU]; NU], [0.0; NU]);
        solo12::mass_matrix_and_bias(&self.robot, q, u, &mut m, &mut bias);
        let (m, bias) = (Matrix::<NU, NU>::from(m), Vector::<NU>::from(bias));
        let standing = Standing::new(&self.robot, q, u);
        let found = standing.accelerations(&m, &bias).and_then(|u_dot| {
            let tau = standing.torques(&m, &bias, &u_dot);
            let missing = self.missing(&Balance::new(&self.robot, q, u), &u_dot);
            self.program.set(&missing, &tau);
            solving(&mut || self.program.solve());
            let forces = self.program.forces()?;
            Some(tau.at(&forces))
        });
        match found {
            Some(tau) => self.tau = tau.into(),
            None => self.failures += 1,
        }
        self.tau
    }

    /// The forces of the last call, N: of each foot along x, y and z.
    pub fn forces(&self) -> Option<[[Scalar; 3]; FEET]> {
        let forces = self.program.forces()?;
        Some(from_fn(|foot| from_fn(|i| forces[3 * foot + i])))
    }

    /// How many iterations the solver needed in the last call.
    pub fn iterations(&self) -> u32 {
        self.program.iterations()
    }

    /// What momentum's rate, N, and the base's angular acceleration, rad/s², have too much.
    fn missing(&self, balance: &Balance, u_dot: &Affine<NU>) -> Affine<6> {
        let (omega, m) = (BANDWIDTH, self.mass);
        let turn = rotation::error(&balance.rotation, &self.rotation);
        let wanted = Vector::<6>::from_fn(|i, _| {
            let j = i % 3;
            if i < 3 {
                let error = self.center[j] - balance.center[j];
                omega * (omega * m * error - 2.0 * balance.momentum[j])
            } else {
                omega * (omega * turn[j] - 2.0 * balance.angular_velocity[j])
            }
        });
        u_dot.through(&balance.rates, &(balance.drift - wanted))
    }
}

/// How the feet move.
struct Standing {
    /// `J`.
    jacobian: Matrix<FORCES, NU>,
    /// `J̇ u`, m/s².
    drift: Vector<FORCES>,
}

impl Standing {
    fn new(robot: &Prepared<Scalar>, q: &[Scalar; NQ], u: &[Scalar; NU]) -> Self {
        let (mut jacobians, mut drift) = ([[[0.0; NU]; 3]; FEET], [[0.0; 3]; FEET]);
        {
            let [fl, fr, hl, hr] = &mut jacobians;
            let [fl_a, fr_a, hl_a, hr_a] = &mut drift;
            feet(robot, q, u, fl, fr, hl, hr, fl_a, fr_a, hl_a, hr_a);
        }
        Self {
            jacobian: Matrix::from_fn(|i, j| jacobians[i / 3][i % 3][j]),
            drift: Vector::from_fn(|i, _| drift[i / 3][i % 3]),
        }
    }

    /// `u̇ = U f + u₀`; none where the joints cannot hold the feet, with a leg stretched out.
    fn accelerations(&self, m: &Matrix<NU, NU>, bias: &Vector<NU>) -> Option<Affine<NU>> {
        // Where the feet stay, the joints follow the base: u̇_J = F u̇_B + g.
        let of_joints = self
            .jacobian
            .fixed_columns::<MOTORS>(ROOT)
            .into_owned()
            .lu();
        let of_root = self.jacobian.fixed_columns::<ROOT>(0).into_owned();
        let follow = of_joints.solve(&-of_root)?;
        let drift = of_joints.solve(&-self.drift)?;
        // No motor acts in the base's rows: (M_BB + M_BJ F) u̇_B = J_Bᵀ f - b_B - M_BJ g.
        let coupling = m.fixed_view::<ROOT, MOTORS>(0, ROOT);
        let inertia = m.fixed_view::<ROOT, ROOT>(0, 0) + coupling * follow;
        let inertia = inertia.lu();
        let held = bias.fixed_rows::<ROOT>(0) + coupling * drift;
        let root = Affine {
            by_force: inertia.solve(&of_root.transpose())?,
            constant: inertia.solve(&-held)?,
        };
        let joints = root.through(&follow, &drift);
        Some(Affine {
            by_force: Matrix::from_fn(|i, j| {
                if i < ROOT {
                    root.by_force[(i, j)]
                } else {
                    joints.by_force[(i - ROOT, j)]
                }
            }),
            constant: Vector::from_fn(|i, _| {
                if i < ROOT {
                    root.constant[i]
                } else {
                    joints.constant[i - ROOT]
                }
            }),
        })
    }

    /// `τ`, the motors' rows of `M u̇ + b - Jᵀ f`.
    fn torques(&self, m: &Matrix<NU, NU>, bias: &Vector<NU>, u_dot: &Affine<NU>) -> Affine<MOTORS> {
        let rows = m.fixed_rows::<MOTORS>(ROOT).into_owned();
        let bias = bias.fixed_rows::<MOTORS>(ROOT).into_owned();
        let mut tau = u_dot.through(&rows, &bias);
        tau.by_force -= self
            .jacobian
            .fixed_columns::<MOTORS>(ROOT)
            .into_owned()
            .transpose();
        tau
    }
}

/// What is to be kept: the mass centre, and the base's orientation.
struct Balance {
    /// `c`, m.
    center: [Scalar; 3],
    rotation: [[Scalar; 3]; 3],
    /// `m ċ`, kg m/s.
    momentum: [Scalar; 3],
    /// rad/s.
    angular_velocity: [Scalar; 3],
    /// Times `u̇` the rates of `m ċ` and of the angular velocity, but for
    rates: Matrix<6, NU>,
    /// what they are for `u̇ = 0`.
    drift: Vector<6>,
}

impl Balance {
    fn new(robot: &Prepared<Scalar>, q: &[Scalar; NQ], u: &[Scalar; NU]) -> Self {
        let mut center = [0.0; 3];
        let (mut momentum, mut moment) = ([[0.0; NU]; 3], [[0.0; NU]; 3]);
        let (mut force, mut couple) = ([0.0; 3], [0.0; 3]);
        let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
        let (mut velocity, mut angular_velocity) = ([0.0; 3], [0.0; 3]);
        let (mut linear, mut angular) = ([[0.0; NU]; 3], [[0.0; NU]; 3]);
        let (mut drift, mut drift_angular) = ([0.0; 3], [0.0; 3]);
        balance(
            robot,
            q,
            u,
            &mut center,
            &mut momentum,
            &mut moment,
            &mut force,
            &mut couple,
            &mut rotation,
            &mut position,
            &mut velocity,
            &mut angular_velocity,
            &mut linear,
            &mut angular,
            &mut drift,
            &mut drift_angular,
        );
        Self {
            center,
            rotation,
            momentum: momentum.map(|row| (0..NU).map(|j| row[j] * u[j]).sum()),
            angular_velocity,
            rates: view::stacked(&momentum, &angular),
            drift: Vector::from_fn(|i, _| {
                if i < 3 {
                    force[i]
                } else {
                    drift_angular[i - 3]
                }
            }),
        }
    }
}
