//! The checks beside generated modules: what is not finite passes none of them.

use kane::self_test::{has_values, mass_matrix_is_positive_definite};

use crate::common::CartPole;

const INF: f64 = f64::INFINITY;

#[test]
fn values_that_are_not_finite_are_no_values_on_either_side() {
    assert!(has_values("one", &[1.0], 1, &[(1.0, 0.0)]).is_ok());
    for bad in [f64::NAN, INF, -INF] {
        for (found, expected, tolerance) in [
            (bad, 1.0, 1e9),
            (1.0, bad, 1e9),
            (bad, bad, 1e9),
            (1.0, 1.0, bad.abs()),
            (bad, 1.0, INF),
            (1.0, bad, INF),
        ] {
            let result = has_values("one", &[found], 1, &[(expected, tolerance)]);
            assert!(result.is_err(), "{found} {expected} {tolerance}");
        }
    }
}

#[test]
fn values_too_many_and_too_few_are_told() {
    assert!(has_values("two", &[1.0, 1.0], 1, &[(1.0, 0.0)]).is_err());
    assert!(has_values("two", &[1.0], 1, &[(1.0, 0.0); 2]).is_err());
    assert!(has_values("none", &[], 1, &[]).is_ok());
}

#[test]
fn a_mass_matrix_is_finite() {
    let of = |mass| CartPole {
        mass,
        gravity: 9.81,
    };
    assert!(mass_matrix_is_positive_definite(&of(0.4), &[0.1, 0.2]).is_ok());
    for mass in [INF, f64::NAN, -1.5] {
        assert!(
            mass_matrix_is_positive_definite(&of(mass), &[0.1, 0.2]).is_err(),
            "{mass}"
        );
    }
}
