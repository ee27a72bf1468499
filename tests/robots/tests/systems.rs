//! Functions of whole systems against Pinocchio's values for the same files in the same states.

use kane_test_support::{compare::relative, errors::Errors};

use crate::common::{
    motion::Motion,
    reference::{Reference, Sample},
};
use kane_test_robots::{CENTERS, IDENTIFIED};

/// Relative to a quantity's largest entry: sums of some hundred products, each rounded to 1e-16, on both sides.
const EXACT: f64 = 1e-13;

/// `A v`, row by row.
fn product(rows: &[f64], v: &[f64]) -> Vec<f64> {
    let rows = rows.chunks_exact(v.len());
    let of_row = |row: &[f64]| row.iter().zip(v).map(|(a, b)| a * b).sum();
    rows.map(of_row).collect()
}

#[test]
fn mass_centers_and_momenta_about_them_are_those_of_pinocchio() {
    for (name, make) in CENTERS {
        let (reference, robot) = (Reference::new(name), make());
        let mut errors = Errors::default();
        for sample in reference.samples() {
            let v = sample.numbers("v");
            let motion = Motion::new(robot.joints(), reference.joints(), sample, &v);
            let (q, u) = (&motion.q, &motion.u);
            let mut compare = |key: &'static str, found: &[f64]| {
                errors.add(key, relative(found, &sample.numbers(key)), EXACT);
            };
            compare("com", &robot.position(q));
            compare("com_velocity", &robot.velocity(q, u));
            compare("com_velocity", &product(&robot.jacobian(q), u));
            compare(
                "centroidal_momentum",
                &product(&robot.momentum_matrix(q), u),
            );
        }
        errors.show(format!("{name}, mass centre"));
    }
}

#[test]
fn regressors_are_those_of_pinocchio() {
    for (name, make) in IDENTIFIED {
        let (reference, robot) = (Reference::new(name), make());
        let mut errors = Errors::default();
        let with_values = |sample: &Sample<'_>| sample.optional("torque_regressor").is_some();
        assert!(reference.samples().any(|sample| with_values(&sample)));
        for sample in reference.samples().filter(with_values) {
            let v = sample.numbers("v");
            let motion = Motion::new(robot.joints(), reference.joints(), sample, &v);
            let u_dot = motion.u_dot(&sample.numbers("a"));
            let found = robot.regressor(&motion.q, &motion.u, &u_dot);
            let expected = sample.numbers("torque_regressor");
            errors.add("torque_regressor", relative(&found, &expected), EXACT);
        }
        errors.show(format!("{name}, regressor"));
    }
}
