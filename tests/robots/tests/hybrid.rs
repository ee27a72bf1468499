//! Robots of which some joints are prescribed, against the partitioned system of Pinocchio's mass matrix and bias.

use kane_test_support::{
    compare::{larger, relative},
    errors::Errors,
    numeric::{Matrix, condition},
};

use crate::common::{
    motion::Motion,
    reference::{Reference, Sample},
};
use kane_test_robots::{HYBRIDS, Hybrid};

/// Relative to the largest entry, where the mass matrix of the free speeds has a condition number up to 1e4; times that of a
/// larger one over this.
const SOLVED: f64 = 1e-12;

/// The speeds of Pinocchio that are prescribed.
fn prescribed(robot: &dyn Hybrid, motion: &Motion) -> Vec<bool> {
    let own = robot.prescribed();
    let is_prescribed = |place: usize| {
        // A speed of Pinocchio belongs to one joint, of which all speeds are prescribed or none.
        let mut speeds = (0..own.len()).filter(|own| motion.t.at(*own, place) != 0.0);
        own[speeds.next().expect("it moves something")]
    };
    (0..own.len()).map(is_prescribed).collect()
}

/// The whole accelerations and forces, from the sample's own at the places where each is given; with the condition number of
/// what is solved.
fn partitioned(sample: Sample<'_>, prescribed: &[bool]) -> ([Vec<f64>; 2], f64) {
    let (m, bias) = (sample.numbers("M"), sample.numbers("bias"));
    let m = Matrix::new(bias.len(), m);
    let (mut a, mut tau) = (sample.numbers("a"), sample.numbers("tau"));
    let places = |wanted: bool| -> Vec<usize> {
        let places = 0..prescribed.len();
        places
            .filter(|place| prescribed[*place] == wanted)
            .collect()
    };
    let (free, held) = (places(false), places(true));
    let right = free.iter().map(|&row| {
        let moved = held.iter().map(|&column| m.at(row, column) * a[column]);
        tau[row] - bias[row] - moved.sum::<f64>()
    });
    let right: Vec<f64> = right.collect();
    let entries = free
        .iter()
        .flat_map(|&row| free.iter().map(move |&column| (row, column)));
    let block = entries.map(|(row, column)| m.at(row, column)).collect();
    let block = Matrix::new(free.len(), block);
    let cholesky = block
        .cholesky()
        .expect("a block of a positive definite matrix");
    for (&place, solved) in free.iter().zip(cholesky.solve(&right)) {
        a[place] = solved;
    }
    let needed = m.times(&a);
    for place in held {
        tau[place] = needed[place] + bias[place];
    }
    ([a, tau], condition(&block))
}

#[test]
fn prescribed_joints_need_and_others_do_what_pinocchio_s_mass_matrix_and_bias_say() {
    for (place, (name, make)) in HYBRIDS.into_iter().enumerate() {
        let (reference, robot) = (Reference::new(name), make());
        let mut errors = Errors::default();
        let with_values = |sample: &Sample<'_>| {
            ["M", "bias", "a", "tau"]
                .iter()
                .all(|key| sample.optional(key).is_some())
        };
        assert!(reference.samples().any(|sample| with_values(&sample)));
        for sample in reference.samples().filter(with_values) {
            let v = sample.numbers("v");
            let motion = Motion::new(robot.joints(), reference.joints(), sample, &v);
            let ([a, tau], condition) = partitioned(sample, &prescribed(&*robot, &motion));
            let (mut u_dot, mut force) = (motion.u_dot(&a), motion.tau(&tau));
            // What is found is not read.
            for (speed, is_prescribed) in robot.prescribed().iter().enumerate() {
                let unread = if *is_prescribed {
                    &mut force
                } else {
                    &mut u_dot
                };
                unread[speed] = f64::NAN;
            }
            let [u_dot, force] = robot.hybrid_dynamics(&motion.q, &motion.u, &u_dot, &force);
            let tolerance = SOLVED * larger(condition / 1e4, 1.0);
            errors.add(
                "accelerations",
                relative(&motion.pinocchio_a(&u_dot), &a),
                tolerance,
            );
            errors.add(
                "forces",
                relative(&motion.pinocchio_tau(&force), &tau),
                tolerance,
            );
        }
        errors.show(format!("{name}, the prescribed {place}"));
    }
}
