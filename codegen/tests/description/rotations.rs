//! Constant rotations and axes: made orthonormal, and exact where they are nearly so.

use std::f64::consts::FRAC_PI_2;

use kane_codegen::geometry::{IDENTITY, Rotation, body_fixed_123, cross, length, then, transposed};
use kane_codegen::tree::{Alignment, orthonormal, snapped, snapped_sin_cos};
use kane_test_support::compare::largest;

/// Right angles as files have them: with ten digits, and with four.
const ROUNDED: [f64; 2] = [FRAC_PI_2 - 4.9e-12, FRAC_PI_2 + 3.7e-6];

#[test]
fn a_rounded_right_angle_becomes_exact() {
    let rounded = body_fixed_123([ROUNDED[0], 0.0, 0.3]);
    let (snapped, change) = snapped(&rounded, 1e-9);
    assert!(snapped[2] == [0.0, -1.0, 0.0] && snapped[0][1] == 0.0);
    assert!(change > 1e-12 && change < 1e-11);
}

#[test]
fn what_is_snapped_is_orthonormal_again() {
    let (snapped, _) = snapped(&body_fixed_123([ROUNDED[1], 0.2, -0.7]), 1e-5);
    assert_orthonormal(&snapped);
}

#[test]
fn a_product_of_what_is_not_exact_is_not_made_exact_alone() {
    // Sines and cosines of -4e-6 and 7e-6, whose product is within the tolerance: where that was zero, columns would not be normal to
    // one another by as much.
    let turns = [[ROUNDED[1], 0.0, 0.0], [0.0, 0.0, 7e-6]].map(body_fixed_123);
    for rotation in [then(&turns[0], &turns[1]), then(&turns[1], &turns[0])] {
        let (snapped, change) = snapped(&rotation, 1e-9);
        assert_orthonormal(&snapped);
        assert!(change < 1e-15, "{change}");
    }
    // A tolerance that takes both takes their product too.
    let (snapped, _) = snapped(&then(&turns[0], &turns[1]), 1e-5);
    assert_eq!(snapped, snapped.map(|row| row.map(f64::round)));
}

/// Within a few roundings of numbers below one.
fn assert_orthonormal(rotation: &Rotation) {
    for (i, row) in then(&transposed(rotation), rotation).iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            assert!((entry - IDENTITY[i][j]).abs() < 1e-15);
        }
    }
}

#[test]
fn a_coarse_tolerance_snaps_no_angle_that_is_farther() {
    // Its cosine is within the tolerance of one, its sine is not of zero.
    let rotation = body_fixed_123([0.0141, 0.0, 0.0]);
    assert_eq!(snapped(&rotation, 1e-4), (rotation, 0.0));
    assert_eq!(
        snapped_sin_cos(0.0141, 1e-4),
        (libm::sin(0.0141), libm::cos(0.0141))
    );
}

#[test]
fn a_rotation_of_few_digits_is_made_orthonormal() {
    let exact = body_fixed_123([0.3, -0.8, 1.2]);
    let rounded = exact.map(|row| row.map(|entry| (entry * 1e6).round() / 1e6));
    let found = orthonormal(&rounded);
    assert_orthonormal(&found);
    assert_eq!(orthonormal(&exact), exact);
}

#[test]
fn nothing_is_snapped_at_zero_tolerance() {
    let rounded = body_fixed_123([ROUNDED[0], 0.1, 0.3]);
    assert_eq!(snapped(&rounded, 0.0), (rounded, 0.0));
}

#[test]
fn an_axis_that_leans_keeps_its_lean() {
    // Its first entry is within 1e-9 of one, its second is not of zero.
    let (along, change) = Alignment::of([1.0, 4e-5, 0.0], 1e-9);
    assert!((along.rotation[along.place][1] - 4e-5).abs() < 1e-12 && change == 0.0);
    let (along, change) = Alignment::of([1.0, 4e-10, 0.0], 1e-9);
    assert!(along.rotation[along.place] == [1.0, 0.0, 0.0] && change == 4e-10);
}

#[test]
fn directions_across_an_axis_do_not_depend_on_the_tolerance() {
    // On either side of what counts as a coordinate axis, and its opposite.
    for axis in [
        [0.0, 3e-6, 1.0],
        [0.0, 5e-10, 1.0],
        [2e-6, 0.0, -1.0],
        [1.0, 0.0, -1e-10],
    ] {
        let (exact, change) = Alignment::with_directions(axis, 0.0);
        assert_eq!(change, 0.0);
        for tolerance in [1e-12, 1e-9, 1e-5] {
            let (snapped, change) = Alignment::with_directions(axis, tolerance);
            assert_eq!(snapped.place, exact.place);
            let pairs = snapped.rotation.as_flattened().iter();
            for (snapped, exact) in pairs.zip(exact.rotation.as_flattened()) {
                assert!((snapped - exact).abs() <= change + 1e-15, "{axis:?}");
            }
            assert_orthonormal(&snapped.rotation);
        }
        let (snapped, _) = Alignment::with_directions(axis, 1e-5);
        assert_eq!(
            snapped.rotation,
            snapped.rotation.map(|row| row.map(f64::round))
        );
    }
}

#[test]
fn the_frame_of_an_axis_is_right_handed_and_has_it() {
    for axis in [
        [0.0, 0.0, -2.0],
        [0.0, -1.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.3, -0.4, 0.5],
        [1e200, 1e200, 0.0],
    ] {
        let (along, _) = Alignment::of(axis, 1e-9);
        let frame = along.rotation;
        let largest = largest(&axis);
        let scaled = axis.map(|part| part / largest);
        let size = length(scaled);
        for (entry, part) in frame[along.place].iter().zip(scaled) {
            assert!((entry - part / size).abs() < 1e-15);
        }
        let third = cross(frame[0], frame[1]);
        for (entry, part) in frame[2].iter().zip(third) {
            assert!((entry - part).abs() < 1e-15);
        }
    }
}
