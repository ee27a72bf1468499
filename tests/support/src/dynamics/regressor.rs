//! Identities of regressors: forces are linear in what bodies weigh and in what acts in joints.

use kane_codegen::tree::regressor_places;

use super::{forces::lifting_forces, model::Model, quantities::mass_matrix, state::State};
use crate::{
    compare::{larger, largest, relative, relative_to},
    rotation::{dot, scaled},
};

/// The ten parameters of each body.
fn parameters(model: &dyn Model) -> Vec<[f64; 10]> {
    let solids = model.composition().solids();
    let of = |solid: &super::solids::Solid| {
        let (m, c) = (solid.mass, solid.center);
        let h = scaled(m, c);
        let i = |row: usize, column: usize| {
            let around = if row == column { dot(c, c) } else { 0.0 };
            solid.inertia[row][column] + m * (around - c[row] * c[column])
        };
        let inertia = [i(0, 0), i(0, 1), i(1, 1), i(0, 2), i(1, 2), i(2, 2)];
        let [xx, xy, yy, xz, yz, zz] = inertia;
        [m, h[0], h[1], h[2], xx, xy, yy, xz, yz, zz]
    };
    solids.iter().map(of).collect()
}

/// They are those of the description, body by body.
pub fn inertial_parameters_are_those_of_the_description(model: &dyn Model, state: &State) -> f64 {
    let found = model.evaluate("inertial_parameters", state);
    let expected = parameters(model);
    let errors = found
        .chunks_exact(10)
        .zip(&expected)
        .map(|(found, expected)| {
            let (mass, others) = (&found[..1], &found[1..]);
            larger(
                relative(mass, &expected[..1]),
                relative(others, &expected[1..]),
            )
        });
    assert_eq!(found.len(), 10 * expected.len());
    errors.fold(0.0, larger)
}

/// Both regressors times their parameters are the same forces.
pub fn base_parameters_make_the_forces_of_inertial_ones(model: &dyn Model, state: &State) -> f64 {
    let forces = |regressor: &str, parameters: &str| {
        let y = model.evaluate(regressor, state);
        let parameters = model.evaluate(parameters, state);
        let mut most = 0.0;
        let rows = (0..state.u.len()).map(|row| {
            let row = &y[row * parameters.len()..][..parameters.len()];
            let terms: Vec<f64> = row.iter().zip(&parameters).map(|(y, pi)| y * pi).collect();
            most = larger(most, largest(&terms));
            terms.iter().sum()
        });
        let forces: Vec<f64> = rows.collect();
        (forces, most)
    };
    let (expected, most) = forces("regressor", "inertial_parameters");
    let (found, of_base) = forces("base_regressor", "base_parameters");
    relative_to(larger(larger(most, of_base), 1e-300), &found, &expected)
}

/// The packed entries are those of the regressor, and what has no place among them is zero.
pub fn the_packed_regressor_has_all_that_is_not_zero(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let mut y = model.evaluate("regressor", state);
    let packed = model.evaluate("regressor_packed", state);
    let places: Vec<usize> = regressor_places(tree)
        .into_iter()
        .map(|[row, column]| row * 10 * tree.bodies.len() + column)
        .collect();
    assert_eq!(packed.len(), places.len());
    let expected: Vec<f64> = places.iter().map(|place| y[*place]).collect();
    for place in places {
        y[place] = 0.0;
    }
    assert!(y.iter().all(|entry| *entry == 0.0), "{}", tree.name);
    relative(&packed, &expected)
}

/// `Y pi` and what rotors, dampers and springs need, less what lifts bodies, is `inverse_dynamics`.
pub fn the_regressor_is_linear_in_inertial_parameters(model: &dyn Model, state: &State) -> f64 {
    let y = model.evaluate("regressor", state);
    let parameters = parameters(model);
    let parameters = parameters.as_flattened();
    let mut most = mass_matrix(model, state).norm();
    let mut found: Vec<f64> = y
        .chunks_exact(parameters.len())
        .map(|row| {
            let terms: Vec<f64> = row.iter().zip(parameters).map(|(y, pi)| y * pi).collect();
            most = larger(most, largest(&terms));
            terms.iter().sum()
        })
        .collect();
    for acting in model.composition().acting() {
        let (speed, forces) = acting.needed(state);
        found[speed] += forces.iter().sum::<f64>();
    }
    for (found, lift) in found.iter_mut().zip(lifting_forces(model, state)) {
        *found -= lift;
        most = larger(most, lift.abs());
    }
    relative_to(most, &found, &model.evaluate("inverse_dynamics", state))
}

/// Times what each speed feels of dampers and rotors it gives their forces; its signs are those of the speeds.
pub fn the_joint_regressor_is_linear_in_dampers_and_rotors(
    model: &dyn Model,
    state: &State,
) -> f64 {
    let y = model.evaluate("joint_regressor", state);
    let n_speeds = state.u.len();
    let mut coefficients = vec![[0.0; 3]; n_speeds];
    let mut expected = vec![0.0; n_speeds];
    for acting in model.composition().acting() {
        let (speed, [rotor, damper, _]) = acting.needed(state);
        let [damping, armature] = acting.felt();
        coefficients[speed][0] += damping;
        coefficients[speed][2] += armature;
        expected[speed] += rotor + damper;
    }
    let rows = y.chunks_exact(3);
    let found: Vec<f64> = rows
        .clone()
        .zip(&coefficients)
        .map(|(row, own)| row.iter().zip(own).map(|(y, c)| y * c).sum())
        .collect();
    let signs: Vec<f64> = rows.map(|row| row[1]).collect();
    let expected_signs: Vec<f64> = state.u.iter().map(|u| u.signum()).collect();
    larger(
        relative_to(1.0 + largest(&expected), &found, &expected),
        relative_to(1.0, &signs, &expected_signs),
    )
}
