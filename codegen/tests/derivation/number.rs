//! Numbers that know what rounding did to them.

use kane_codegen::number::{Number, Rounded, one_digit};

/// What rounding takes of a number, at most.
const UNIT: f64 = f64::EPSILON / 2.0;

fn exact(value: f64) -> Rounded {
    Rounded::exact(value)
}

#[test]
fn what_cancels_keeps_the_errors_of_its_terms() {
    let product = exact(1.0 + f64::EPSILON) * exact(1.0 - f64::EPSILON / 2.0);
    let rest = product + exact(-1.0);
    let exact = f64::EPSILON / 2.0 - f64::EPSILON * f64::EPSILON / 2.0;
    assert!((rest.value - exact).abs() <= rest.error);
    assert!(rest.error < 3.0 * UNIT);
}

#[test]
fn a_division_by_what_is_nearly_nothing_multiplies_its_error() {
    let divisor = (exact(1.0) * exact(3.0) + exact(-3.0 + 1e-9)).error / 1e-9;
    let quotient = exact(1.0) / (exact(1.0) * exact(3.0) + exact(-3.0 + 1e-9));
    assert!(quotient.error > divisor * quotient.value.abs() / 2.0);
}

#[test]
fn sines_have_the_error_of_their_angle_where_they_rise() {
    let angle = Rounded {
        value: 0.5,
        error: 1e-3,
    };
    let (sin, cos) = angle.sin_cos();
    assert!((sin.error - 1e-3 * libm::cos(0.5)).abs() < 1e-9);
    assert!((cos.error - 1e-3 * libm::sin(0.5)).abs() < 1e-9);
}

#[test]
fn tolerances_grow_by_less_than_one_of_their_digit() {
    for (tolerance, digit) in [
        (0.0, 0.0),
        (3e-14, 3e-14),
        (2.4e-14, 3e-14),
        (2.6e-14, 3e-14),
        (9.4e-14, 1e-13),
        (9.6e-14, 1e-13),
        (f64::from_bits(1), f64::from_bits(1)),
    ] {
        assert_eq!(one_digit(tolerance), digit, "{tolerance}");
    }
}
