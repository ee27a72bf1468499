//! From Pinocchio's coordinates to those of a module, and back.
//!
//! Of a floating base Pinocchio has the twist `v = (v_O, w)`, both in the base's axes; we have `u = (w, s_dot)`, the second
//! in inertial axes, or with angles `u = (theta_dot, s_dot)`, `w = P(theta) theta_dot`, Eq. (8). So with the base's rotation
//! `R`, base to inertial,
//!
//! ```text
//! u = T v               T = [ 0  1 ] or [ 0  P^-1 ]     T^-1 = [ 0  R^T ] or [ 0  R^T ]
//!                           [ R  0 ]    [ R  0    ]            [ 1  0   ]    [ P  0   ]
//! u_dot = T v_dot + c   c = T_dot v = (0 or -P^-1 P_dot theta_dot, R (w x v_O))
//! ```
//!
//! Power is the same in both, `tau_P · v = tau · u`, hence `tau_P = T^T tau`; and `tau = M u_dot + bias` becomes
//! `M_P = T^T M T`, `bias_P = T^T (bias + M c)`. For all other joints `T` is one and `c` zero.

use kane::{Chart, Joint, Real, chart::Turning};

use kane_test_support::numeric::{Matrix, dot};

use super::{
    cross,
    reference::{Sample, index},
    times, transposed,
};

/// A state of a sample in a module's coordinates.
pub(crate) struct Motion {
    pub(crate) q: Vec<f64>,
    pub(crate) u: Vec<f64>,
    /// How near the base's angles are to their singularity, `|cos(theta_2)|`; 1 without angles.
    pub(crate) distance: f64,
    pub(crate) t: Matrix,
    pub(crate) t_inverse: Matrix,
    /// Its rate; of a base with angles it is not made.
    pub(crate) t_dot: Option<Matrix>,
    /// `T_dot v`.
    rest: Vec<f64>,
}

impl Motion {
    /// The sample's state, with the velocities `v`, of a module with these joints; `references` are Pinocchio's.
    pub(crate) fn new(
        joints: &[Joint],
        references: &[serde_json::Value],
        sample: Sample<'_>,
        v: &[f64],
    ) -> Self {
        let n = v.len();
        let zero = || Matrix::new(n, vec![0.0; n * n]);
        let n_coordinates = joints.iter().flat_map(|joint| joint.q).flatten().count();
        let mut motion = Self {
            q: vec![f64::NAN; n_coordinates],
            u: Vec::new(),
            distance: 1.0,
            t: zero(),
            t_inverse: zero(),
            t_dot: Some(zero()),
            rest: vec![0.0; n],
        };
        let given = sample.numbers("q");
        assert_eq!(joints.len(), references.len());
        for (joint, reference) in joints.iter().zip(references) {
            let (from_q, from_v) = (index(&reference["q_index"]), index(&reference["v_index"]));
            if reference["type"] == "floating" {
                assert_eq!([from_q, from_v], [0, 0], "the base comes first");
                motion.float(joint, sample, v);
                continue;
            }
            let (place, speed) = (only(&joint.q), only(&joint.u));
            motion.q[place] = given[from_q];
            set(&mut motion.t, speed, from_v, 1.0);
            set(&mut motion.t_inverse, from_v, speed, 1.0);
        }
        motion.u = motion.t.times(v);
        motion
    }

    /// Fills in what belongs to the floating base.
    fn float(&mut self, joint: &Joint, sample: Sample<'_>, v: &[f64]) {
        let q = sample.numbers("q");
        let rotation = sample.base("rotation_base_to_world");
        let r = [0, 1, 2].map(|i| [0, 1, 2].map(|j| rotation[3 * i + j]));
        let (v_o, w) = ([v[0], v[1], v[2]], [v[3], v[4], v[5]]);
        let all = |places: &[Option<usize>], from: usize| {
            [0, 1, 2].map(|i| places[from + i].expect("the base is free"))
        };
        let turning = Turning {
            e: [q[6], q[3], q[4], q[5]],
            w,
        };
        let (p, p_inverse, turn_rest) = match joint.chart {
            Chart::EulerParameters => {
                for (e, place) in turning.e.iter().zip(&joint.q) {
                    self.q[place.expect("it has four")] = *e;
                }
                (IDENTITY, IDENTITY, [0.0; 3])
            }
            Chart::AngleRates => {
                let theta = turning.angles();
                for (theta, place) in theta.iter().zip(all(&joint.q, 0)) {
                    self.q[place] = *theta;
                }
                let rates = Rates::new(theta);
                self.distance = rates.c2.abs();
                let p_dot_d = rates.p_dot_times(times(&rates.p_inverse(), w));
                let turn_rest = times(&rates.p_inverse(), p_dot_d).map(|entry| -entry);
                (rates.p(), rates.p_inverse(), turn_rest)
            }
            Chart::Angles => unreachable!("a floating base of a URDF has no such chart"),
        };
        if joint.chart != Chart::EulerParameters {
            self.t_dot = None;
        }
        let shift_rest = times(&r, cross(w, v_o));
        let (turns, shifts) = (all(&joint.u, 0), all(&joint.u, 3));
        for (i, place) in all(&joint.q, 4).into_iter().enumerate() {
            self.q[place] = q[i];
            self.rest[turns[i]] = turn_rest[i];
            self.rest[shifts[i]] = shift_rest[i];
            for j in 0..3 {
                if let Some(t_dot) = &mut self.t_dot {
                    // R_dot = R tilde(w).
                    let mut unit = [0.0; 3];
                    unit[j] = 1.0;
                    set(t_dot, shifts[i], j, dot(&r[i], &cross(w, unit)));
                }
                set(&mut self.t, turns[i], 3 + j, p_inverse[i][j]);
                set(&mut self.t, shifts[i], j, r[i][j]);
                set(&mut self.t_inverse, 3 + i, turns[j], p[i][j]);
                set(&mut self.t_inverse, i, shifts[j], transposed(&r)[i][j]);
            }
        }
    }

    /// Our accelerations.
    pub(crate) fn u_dot(&self, a: &[f64]) -> Vec<f64> {
        sum(&self.t.times(a), &self.rest, 1.0)
    }

    /// Our generalized forces.
    pub(crate) fn tau(&self, pinocchio: &[f64]) -> Vec<f64> {
        times_transposed(&self.t_inverse, pinocchio)
    }

    /// Pinocchio's accelerations.
    pub(crate) fn pinocchio_a(&self, u_dot: &[f64]) -> Vec<f64> {
        self.t_inverse.times(&sum(u_dot, &self.rest, -1.0))
    }

    /// Pinocchio's generalized forces.
    pub(crate) fn pinocchio_tau(&self, tau: &[f64]) -> Vec<f64> {
        times_transposed(&self.t, tau)
    }

    /// Pinocchio's mass matrix.
    pub(crate) fn pinocchio_mass_matrix(&self, m: &Matrix) -> Matrix {
        congruent(&self.t, m)
    }

    /// Pinocchio's bias.
    pub(crate) fn pinocchio_bias(&self, m: &Matrix, bias: &[f64]) -> Vec<f64> {
        self.pinocchio_tau(&sum(bias, &m.times(&self.rest), 1.0))
    }
}

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Sines and cosines of the second and third angle, on which `P` depends.
struct Rates {
    s2: f64,
    c2: f64,
    s3: f64,
    c3: f64,
}

impl Rates {
    fn new(theta: [f64; 3]) -> Self {
        let ((s2, c2), (s3, c3)) = (Real::sin_cos(theta[1]), Real::sin_cos(theta[2]));
        Self { s2, c2, s3, c3 }
    }

    /// `w = P theta_dot`.
    fn p(&self) -> [[f64; 3]; 3] {
        let Self { s2, c2, s3, c3 } = *self;
        [[c2 * c3, s3, 0.0], [-c2 * s3, c3, 0.0], [s2, 0.0, 1.0]]
    }

    fn p_inverse(&self) -> [[f64; 3]; 3] {
        let Self { s2, c2, s3, c3 } = *self;
        [
            [c3 / c2, -s3 / c2, 0.0],
            [s3, c3, 0.0],
            [-s2 * c3 / c2, s2 * s3 / c2, 1.0],
        ]
    }

    /// `P_dot d` for the rates `d`, of which `P_dot` is made too.
    fn p_dot_times(&self, d: [f64; 3]) -> [f64; 3] {
        let Self { s2, c2, s3, c3 } = *self;
        let [d1, d2, d3] = d;
        [
            (-s2 * c3 * d2 - c2 * s3 * d3) * d1 + c3 * d3 * d2,
            (s2 * s3 * d2 - c2 * c3 * d3) * d1 - s3 * d3 * d2,
            c2 * d2 * d1,
        ]
    }
}

/// `g^T m g`.
pub(crate) fn congruent(g: &Matrix, m: &Matrix) -> Matrix {
    let n = g.n;
    let column = |j: usize| (0..n).map(|i| g.at(i, j)).collect::<Vec<_>>();
    let columns: Vec<_> = (0..n).map(column).collect();
    let products: Vec<_> = columns.iter().map(|column| m.times(column)).collect();
    let entries = columns
        .iter()
        .flat_map(|left| products.iter().map(|right| dot(left, right)));
    Matrix::new(n, entries.collect())
}

fn times_transposed(m: &Matrix, x: &[f64]) -> Vec<f64> {
    let entry = |j: usize| (0..m.n).map(|i| m.at(i, j) * x[i]).sum();
    (0..m.n).map(entry).collect()
}

fn sum(a: &[f64], b: &[f64], factor: f64) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + factor * b).collect()
}

fn set(m: &mut Matrix, row: usize, column: usize, entry: f64) {
    m.entries[row * m.n + column] = entry;
}

/// The only place of a joint that has one.
fn only(places: &[Option<usize>]) -> usize {
    let mut places = places.iter().flatten();
    let place = *places.next().expect("the joint moves");
    assert!(places.next().is_none(), "in one way");
    place
}
