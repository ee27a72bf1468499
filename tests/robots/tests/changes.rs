//! Joints that follow others, are locked or removed: the equations are those of the robot where all are free, projected.
//!
//! With `q_full = G q + h`, `G` constant, is `u_full = G u` and `u_dot_full = G u_dot`, and equal power gives `tau = G^T tau_full`:
//! `M = G^T M_full G`, `bias = G^T bias_full`.

use kane_test_support::{
    compare::{distance, largest, relative},
    errors::Errors,
    numeric::{Matrix, condition},
    random::Random,
};

use crate::common::{placements, robot};
use kane_test_robots::{
    Dynamics, GRIPPER, GRIPPER_FREE, GRIPPER_FREE_NOTES, GRIPPER_NOTES, PANDA_HELD, Robot,
};

/// Relative to a quantity's largest entry: both sides sum some ten terms of each of some ten bodies, rounded to 1e-16 each.
const EXACT: f64 = 1e-13;
/// Rounding of a solution, relative to its largest entry and to the condition number of the mass matrix, which multiplies
/// that of the matrix and of the right-hand side.
const SOLUTION: f64 = 1e-14;
const STATES: u64 = 10;

/// For each coordinate of the full robot what it is: a multiple of one of the reduced robot's, if of any, plus a constant.
struct Projection {
    followed: Vec<Option<(usize, f64)>>,
    offset: Vec<f64>,
    n_reduced: usize,
}

impl Projection {
    fn new(n_reduced: usize, coordinates: &[(Option<(usize, f64)>, f64)]) -> Self {
        Self {
            followed: coordinates.iter().map(|(followed, _)| *followed).collect(),
            offset: coordinates.iter().map(|(_, offset)| *offset).collect(),
            n_reduced,
        }
    }

    /// `G u`.
    fn speeds(&self, reduced: &[f64]) -> Vec<f64> {
        let speed = |followed: &Option<(usize, f64)>| {
            followed.map_or(0.0, |(place, factor)| factor * reduced[place])
        };
        self.followed.iter().map(speed).collect()
    }

    /// `G q + h`.
    fn coordinates(&self, reduced: &[f64]) -> Vec<f64> {
        let scaled = self.speeds(reduced).into_iter();
        scaled.zip(&self.offset).map(|(q, h)| q + h).collect()
    }

    /// `G^T tau`.
    fn forces(&self, full: &[f64]) -> Vec<f64> {
        let mut forces = vec![0.0; self.n_reduced];
        for (followed, full) in self.followed.iter().zip(full) {
            if let Some((place, factor)) = followed {
                forces[*place] += factor * full;
            }
        }
        forces
    }

    /// `G^T M G`.
    fn matrix(&self, full: &[f64]) -> Matrix {
        let rows = full.chunks_exact(self.followed.len());
        let rows: Vec<Vec<f64>> = rows.map(|row| self.forces(row)).collect();
        let column = |j: usize| self.forces(&rows.iter().map(|row| row[j]).collect::<Vec<_>>());
        // Of a symmetric matrix columns are rows.
        let columns = (0..self.n_reduced).flat_map(column);
        Matrix::new(self.n_reduced, columns.collect())
    }
}

fn check_dynamics(
    reduced: &dyn Dynamics,
    full: &dyn Dynamics,
    projection: &Projection,
    errors: &mut Errors,
) {
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let [q, u, u_dot, tau] = [(); 4].map(|()| random.numbers(projection.n_reduced));
        let q_full = projection.coordinates(&q);
        let [u_full, u_dot_full] = [&u, &u_dot].map(|speeds| projection.speeds(speeds));

        let m = projection.matrix(&full.mass_matrix(&q_full));
        let error = relative(&reduced.mass_matrix(&q), &m.entries);
        errors.add("mass_matrix", error, EXACT);
        let bias = projection.forces(&full.bias(&q_full, &u_full));
        errors.add("bias", relative(&reduced.bias(&q, &u), &bias), EXACT);
        let expected = projection.forces(&full.inverse_dynamics(&q_full, &u_full, &u_dot_full));
        let found = reduced.inverse_dynamics(&q, &u, &u_dot);
        errors.add("inverse_dynamics", relative(&found, &expected), EXACT);
        let forcing: Vec<f64> = tau
            .iter()
            .zip(&bias)
            .map(|(tau, bias)| tau - bias)
            .collect();
        let cholesky = m.cholesky().expect("a mass matrix is positive definite");
        let found = reduced.forward_dynamics(&q, &u, &tau);
        let error = relative(&found, &cholesky.solve(&forcing));
        errors.add("forward_dynamics", error, SOLUTION * condition(&m));
    }
}

fn check_rest(reduced: &dyn Robot, full: &dyn Robot, projection: &Projection, errors: &mut Errors) {
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let [q, u] = [(); 2].map(|()| random.numbers(projection.n_reduced));
        let (q_full, u_full) = (projection.coordinates(&q), projection.speeds(&u));
        let mut compare = |what, found: &[f64], expected: &[f64]| {
            errors.add(what, relative(found, expected), EXACT);
        };
        compare(
            "kinetic_energy",
            &[reduced.kinetic_energy(&q, &u)],
            &[full.kinetic_energy(&q_full, &u_full)],
        );
        compare(
            "potential_energy",
            &[reduced.potential_energy(&q)],
            &[full.potential_energy(&q_full)],
        );
        compare(
            "linear_momentum",
            &reduced.linear_momentum(&q, &u),
            &full.linear_momentum(&q_full, &u_full),
        );
        compare(
            "angular_momentum",
            &reduced.angular_momentum(&q, &u),
            &full.angular_momentum(&q_full, &u_full),
        );
        // By name: what has become part of another body is a frame.
        let (found, expected) = (placements(reduced, &q), placements(full, &q_full));
        assert!(found.keys().eq(expected.keys()));
        for (found, expected) in found.values().zip(expected.values()) {
            let rotations = [found, expected].map(|at| at.rotation.as_flattened().to_vec());
            compare("link rotations", &rotations[0], &rotations[1]);
            compare("link origins", &found.origin, &expected.origin);
        }
    }
}

/// slide, wrist, `finger_a` = 0.03 - `finger_b`, `finger_b`, thumb = 0.3 + 0.5 `finger_a`, tip.
fn gripper() -> Projection {
    Projection::new(
        4,
        &[
            (Some((0, 1.0)), 0.0),
            (Some((1, 1.0)), 0.0),
            (Some((2, -1.0)), 0.03),
            (Some((2, 1.0)), 0.0),
            (Some((2, -0.5)), 0.3 + 0.5 * 0.03),
            (Some((3, 1.0)), 0.0),
        ],
    )
}

#[test]
fn joints_that_follow_have_no_coordinates() {
    assert_eq!(
        GRIPPER_FREE().coordinate_names(),
        ["slide", "wrist", "finger_a", "finger_b", "thumb", "tip"]
    );
    let reduced = GRIPPER();
    assert_eq!(
        reduced.coordinate_names(),
        ["slide", "wrist", "finger_b", "tip"]
    );
    assert_eq!(reduced.joints().len(), 6, "they still are joints");
    let followers = reduced.joints().iter().filter(|joint| joint.u == [None; 6]);
    let names: Vec<_> = followers.map(|joint| joint.name).collect();
    assert_eq!(names, ["finger_a", "thumb"]);
}

#[test]
fn joints_that_follow_project_the_equations() {
    let (reduced, full) = (GRIPPER(), GRIPPER_FREE());
    let mut errors = Errors::default();
    check_dynamics(&*reduced, &*full, &gripper(), &mut errors);
    check_rest(&*reduced, &*full, &gripper(), &mut errors);
    errors.show("gripper");
}

#[test]
fn joints_that_follow_project_the_equations_in_the_notes_formulation() {
    let (reduced, full) = (GRIPPER_NOTES(), GRIPPER_FREE_NOTES());
    let mut errors = Errors::default();
    check_dynamics(&*reduced, &*full, &gripper(), &mut errors);
    errors.show("gripper, the notes' formulation");
}

#[test]
fn both_formulations_of_the_gripper_agree() {
    let (notes, recursive) = (GRIPPER_NOTES(), GRIPPER());
    let same = Projection::new(4, &[0, 1, 2, 3].map(|place| (Some((place, 1.0)), 0.0)));
    let mut errors = Errors::default();
    check_dynamics(&*notes, &*recursive, &same, &mut errors);
    errors.show("gripper, both formulations");
}

/// Every joint of the gripper has a damper, and two that follow have one each, of 1.5 N s/m and 0.05 N m s.
#[test]
fn dampers_of_joints_that_follow_act_on_the_followed() {
    let gripper = GRIPPER();
    let (q, rest) = ([0.1, 0.2, 0.03, 0.4], [0.0; 4]);
    // The bias is quadratic in the speeds, but for dampers.
    let linear = |u: [f64; 4]| {
        let [ahead, behind] = [1.0, -1.0].map(|sign| gripper.bias(&q, &u.map(|u| sign * u)));
        let difference = ahead.iter().zip(behind).map(|(a, b)| (a - b) / 2.0);
        difference.collect::<Vec<f64>>()
    };
    let scale = largest(&gripper.bias(&q, &rest));
    for (place, damping) in [3.0, 0.2, 2.0 + 1.5 + 0.25 * 0.05, 0.0]
        .into_iter()
        .enumerate()
    {
        let mut u = rest;
        u[place] = 1.0;
        let expected = u.map(|u| u * damping);
        assert!(distance(&linear(u), &expected) <= EXACT * scale);
    }
}

#[test]
fn locked_and_removed_joints_are_rows_and_columns_taken_out() {
    let (reduced, full) = (PANDA_HELD(), (robot("panda").plain)());
    assert_eq!(
        reduced.body_names(),
        ["panda_link1", "panda_link2", "panda_link4", "panda_link7"],
        "bodies on locked and removed joints are part of others"
    );
    let free = |place| (Some((place, 1.0)), 0.0);
    let held = |at| (None, at);
    let projection = Projection::new(
        4,
        &[
            free(0),
            free(1),
            held(0.4),
            free(2),
            held(0.0),
            held(-0.7),
            free(3),
        ],
    );
    let mut errors = Errors::default();
    check_dynamics(&*reduced, &*full, &projection, &mut errors);
    check_rest(&*reduced, &*full, &projection, &mut errors);
    errors.show("panda, three joints held");
}
