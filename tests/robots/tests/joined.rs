//! Functions in one, and functions that are given sines and cosines, compiled: the numbers of the separate ones.

#![expect(
    clippy::disallowed_methods,
    reason = "the platform's sines are what ours are held against"
)]

use kane_test_support::compare::{Tolerance, assert_close};

/// Entries between -1 and 1 without a pattern.
fn numbers<const N: usize>(kind: u16, seed: u16) -> [f64; N] {
    std::array::from_fn(|place| {
        let place = u16::try_from(place).expect("robots have few joints");
        let number = 12.9 * f64::from(place) + 7.3 * f64::from(kind) + 0.61 * f64::from(seed);
        number.sin()
    })
}

/// Sums of some hundred products in another order.
#[track_caller]
fn assert_same(found: &[f64], expected: &[f64]) {
    let tolerance = Tolerance::relative_beyond(1.0, 1e-13);
    assert_close("in another order", found, expected, tolerance);
}

macro_rules! robots {
    ($($robot:ident)+) => {$(
        mod $robot {
            use super::{assert_same, numbers};
            use kane::functions::{MassMatrixPacked, unpack};
            use kane_test_robots::$robot::{
                ANGLE_NAMES, COORDINATE_NAMES, MASS_MATRIX_PACKED_LEN, NA, NQ, NU, Prepared, SinCos, bias, gravity_forces, inverse_dynamics,
                inverse_dynamics_at_sin_cos, mass_matrix, mass_matrix_and_bias_and_gravity_forces,
                mass_matrix_and_bias_at_sin_cos, sin_cos,
            };

            fn given(system: &Prepared<f64>, q: &[f64; NQ]) -> SinCos<f64> {
                let mut given = SinCos { sines: [f64::NAN; NA], cosines: [f64::NAN; NA] };
                sin_cos(system, q, &mut given);
                given
            }

            #[test]
            fn functions_in_one_write_what_the_separate_ones_do() {
                let system = Prepared::<f64>::nominal();
                for seed in 0..10 {
                    let (q, u) = (numbers(1, seed), numbers(2, seed));
                    let mut expected = ([[f64::NAN; NU]; NU], [f64::NAN; NU], [f64::NAN; NU]);
                    mass_matrix(&system, &q, &mut expected.0);
                    bias(&system, &q, &u, &mut expected.1);
                    gravity_forces(&system, &q, &mut expected.2);
                    let mut found = ([[f64::NAN; NU]; NU], [f64::NAN; NU], [f64::NAN; NU]);
                    mass_matrix_and_bias_and_gravity_forces(&system, &q, &u, &mut found.0, &mut found.1, &mut found.2);
                    assert_same(found.0.as_flattened(), expected.0.as_flattened());
                    assert_same(&found.1, &expected.1);
                    assert_same(&found.2, &expected.2);
                    let mut found = ([[f64::NAN; NU]; NU], [f64::NAN; NU]);
                    mass_matrix_and_bias_at_sin_cos(&system, &q, &given(&system, &q), &u, &mut found.0, &mut found.1);
                    assert_same(found.0.as_flattened(), expected.0.as_flattened());
                    assert_same(&found.1, &expected.1);
                }
            }

            #[test]
            fn a_packed_mass_matrix_unpacks_to_the_whole() {
                let system = Prepared::<f64>::nominal();
                for seed in 0..10 {
                    let q = numbers(1, seed);
                    let (mut expected, mut found) = ([[f64::NAN; NU]; NU], [[f64::NAN; NU]; NU]);
                    mass_matrix(&system, &q, &mut expected);
                    let mut entries = [f64::NAN; MASS_MATRIX_PACKED_LEN];
                    system.mass_matrix_packed(&q, &mut entries);
                    unpack(&entries, Prepared::<f64>::PLACES, &mut found);
                    assert_same(found.as_flattened(), expected.as_flattened());
                }
            }

            #[test]
            fn sines_and_cosines_that_are_given_give_the_same() {
                let system = Prepared::<f64>::nominal();
                for seed in 0..10 {
                    let (q, u, u_dot) = (numbers(1, seed), numbers(2, seed), numbers(3, seed));
                    let (mut expected, mut found) = ([f64::NAN; NU], [f64::NAN; NU]);
                    inverse_dynamics(&system, &q, &u, &u_dot, &mut expected);
                    inverse_dynamics_at_sin_cos(&system, &q, &given(&system, &q), &u, &u_dot, &mut found);
                    assert_same(&found, &expected);
                }
            }

            #[test]
            fn angles_are_coordinates_in_their_order() {
                let angles = COORDINATE_NAMES.iter().filter(|name| ANGLE_NAMES.contains(name));
                assert!(angles.eq(&ANGLE_NAMES));
                let system = Prepared::<f64>::nominal();
                let q = numbers(1, 0);
                let given = given(&system, &q);
                for (place, name) in ANGLE_NAMES.iter().enumerate() {
                    let coordinate = COORDINATE_NAMES.iter().position(|known| known == name);
                    let angle: f64 = q[coordinate.expect("an angle is a coordinate")];
                    assert!((given.sines[place] - angle.sin()).abs() < 1e-15);
                    assert!((given.cosines[place] - angle.cos()).abs() < 1e-15);
                }
            }
        }
    )+};
}

robots! {
    panda_joined
    solo12_joined
    gripper_joined
}
