//! The orientation error against rotations about known axes.

use std::f64::consts::PI;

use kane::rotation::error;
use kane_test_support::{
    compare::{Tolerance, assert_close},
    random::Random,
    rotation::{about, product, scaled, times, transposed, unit},
};

/// Of vectors no longer than 2, each from some thirty operations.
const TOLERANCE: Tolerance = Tolerance::absolute(1e-14);

#[test]
fn error_is_about_the_axis_of_the_shorter_way_and_twice_the_sine_of_half_the_angle() {
    let mut random = Random::new(7);
    let mut vector = || unit([0, 1, 2].map(|_| random.symmetric()));
    for angle in [0.0, 1e-9, 0.3, 1.5, 3.0, PI - 1e-3, PI - 1e-7] {
        for _ in 0..100 {
            let (from, axis) = (about(vector(), 2.0 * angle + 0.5), vector());
            let to = product(&about(axis, angle), &from);
            let inertial = times(&transposed(&from), axis);
            let expected = scaled(2.0 * libm::sin(0.5 * angle), inertial);
            assert_close(
                format_args!("{angle}"),
                &error(&from, &to),
                &expected,
                TOLERANCE,
            );
            // The other way round.
            let back = scaled(-1.0, expected);
            assert_close(
                format_args!("{angle}, back"),
                &error(&to, &from),
                &back,
                TOLERANCE,
            );
        }
    }
}

#[test]
fn error_of_the_same_orientation_is_zero() {
    let same = about(unit([1.0, -2.0, 0.5]), 2.5);
    assert_close("the same", &error(&same, &same), &[0.0; 3], TOLERANCE);
}
