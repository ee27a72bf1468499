//! The checks beside generated modules: what is not finite passes none of them, nor what is wrong by a thousandth.

use kane::self_test::{
    bias_follows_the_mass_matrix, forward_undoes_inverse, has_values, inverse_dynamics_is_linear,
    mass_matrix_is_positive_definite, power_is_the_rate_of_energy, weight,
};

use crate::common::{CartPole, Faulty, Wrong, arrays};

mod tolerances;

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
fn two_entries_of_a_sum_that_are_exchanged_are_told() {
    let entries: Vec<f64> = (0..200).map(f64::from).collect();
    let sum = |entries: &[f64]| -> f64 {
        let terms = entries.iter().enumerate();
        terms.map(|(place, entry)| weight(place) * entry).sum()
    };
    let expected = [(sum(&entries), 1e-9)];
    assert!(has_values("sum", &entries, 200, &expected).is_ok());
    for first in 0..200 {
        for second in 0..first {
            let mut exchanged = entries.clone();
            exchanged.swap(first, second);
            assert!(has_values("sum", &exchanged, 200, &expected).is_err());
        }
    }
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

#[test]
fn each_check_finds_a_term_that_is_wrong_by_a_thousandth() {
    let (q, u, u_dot) = ([0.1, 0.7], [0.4, 1.3], [-0.6, 0.9]);
    let checks = |wrong| {
        let of = |mass| Faulty {
            mass,
            wrong,
            part: 1e-3,
        };
        let at = of(0.4);
        [
            forward_undoes_inverse(&at, &q, &u, &u_dot),
            power_is_the_rate_of_energy(&at, &q, &u, &u_dot),
            bias_follows_the_mass_matrix(&at, &q, &u),
            inverse_dynamics_is_linear([&of(0.3), &at, &of(0.5)], &q, &u, &u_dot),
        ]
        .map(|result| result.is_ok())
    };
    assert_eq!(checks(None), [true; 4]);
    for (wrong, expected) in [
        (Wrong::Accelerations, [false, true, true, true]),
        (Wrong::Energy, [true, false, true, true]),
        (Wrong::Weight, [false, false, true, true]),
        (Wrong::Coriolis, [false, false, false, true]),
        (Wrong::Linearity, [false, false, true, false]),
        (Wrong::Mass, [false, false, false, true]),
    ] {
        assert_eq!(checks(Some(wrong)), expected, "{wrong:?}");
    }
}

#[test]
fn a_pivot_that_is_not_positive_is_told_as_one() {
    let of = |mass| CartPole {
        mass,
        gravity: 9.81,
    };
    let fault = mass_matrix_is_positive_definite(&of(-1.5), &[0.1, 0.2]).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "mass matrix, pivot, which is to be positive, 1: found -1.5e0, expected 1.5e0 within 1.5e0"
    );
}

/// Three speeds whose mass matrix a test chooses.
struct Chosen([[f64; 3]; 3]);

impl kane::System<f64> for Chosen {
    arrays!(f64; 3, 3, 1);

    const NAME: &'static str = "chosen";
    const BODY_NAMES: &'static [&'static str] = &["body"];
    const COORDINATE_NAMES: &'static [&'static str] = &["x", "y", "z"];
    const SPEED_NAMES: &'static [&'static str] = &["x_dot", "y_dot", "z_dot"];
    const LOWER_BODIES: &'static [usize] = &[0];
    const SPEED_BODIES: &'static [usize] = &[0, 0, 0];

    fn q_dot(&self, _: &[f64; 3], u: &[f64; 3], q_dot: &mut [f64; 3]) {
        *q_dot = *u;
    }
}

impl kane::functions::MassMatrix<f64> for Chosen {
    fn mass_matrix(&self, _: &[f64; 3], m: &mut [[f64; 3]; 3]) {
        *m = self.0;
    }
}

#[test]
fn a_pivot_that_cancels_passes_only_where_its_speed_moves_nothing_else() {
    let is_definite = |m| mass_matrix_is_positive_definite(&Chosen(m), &[0.0; 3]).is_ok();
    assert!(is_definite([
        [2.0, 1.0, 0.0],
        [1.0, 2.0, 1.0],
        [0.0, 1.0, 2.0]
    ]));
    // Of two speeds that move the same mass one has nothing left, to rounding.
    assert!(is_definite([
        [2.0, 0.0, 0.0],
        [0.0, 0.1, 0.1],
        [0.0, 0.1, 0.1]
    ]));
    assert!(!is_definite([
        [1.0, 2.0, 0.0],
        [2.0, 1.0, 1.0],
        [0.0, 1.0, 1.0]
    ]));
    assert!(!is_definite([
        [1.0, 0.0, 1e-3],
        [0.0, 1.0, 0.0],
        [1e-3, 0.0, 0.0]
    ]));
}
