//! Orientation errors and rotation vectors against rotations about known axes, and their derivatives against differences of order 12.

use std::f64::consts::PI;

use kane::rotation::{difference, error, error_and_jacobian, exp, exp_jacobian, log, log_jacobian};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    numeric::derivative,
    random::Random,
    rotation::{Rotation, Vector, about, dot, product, scaled, sum, times, transposed, unit},
};

/// Of vectors no longer than 2, each from some thirty operations.
const TOLERANCE: Tolerance = Tolerance::absolute(1e-14);

/// The same in single precision.
const SINGLE: Tolerance = Tolerance::absolute(2e-6);

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

/// Differences lose a digit and a half to the sums that they are of, and the inverse Jacobian grows to two toward half a turn.
const DIFFERENCED: Tolerance = Tolerance::absolute(1e-11);

fn axis(random: &mut Random) -> Vector {
    unit([0, 1, 2].map(|_| random.symmetric()))
}

fn rows(matrix: &Rotation) -> &[f64] {
    matrix.as_flattened()
}

/// The product of two matrices in single precision.
fn product_of(a: &[[f32; 3]; 3], b: &[[f32; 3]; 3]) -> Rotation {
    let [a, b] = [a, b].map(|matrix| matrix.map(|row| row.map(f64::from)));
    product(&a, &b)
}

/// A matrix whose columns are these derivatives along the three axes.
fn by_axes(along: impl Fn(Vector) -> Vec<f64>) -> Rotation {
    let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(along);
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| columns[j][i]))
}

/// The frame after it has turned about an inertial axis.
fn turned(rotation: &Rotation, inertial: Vector, angle: f64) -> Rotation {
    product(rotation, &about(inertial, angle))
}

#[test]
fn exp_is_the_matrix_of_a_turn_about_the_vector() {
    let mut random = Random::new(11);
    for angle in [0.0, 1e-300, 1e-9, 0.3, 2.0, PI, 5.0, 40.0] {
        let axis = axis(&mut random);
        let found = exp(&scaled(angle, axis));
        assert_close(angle, rows(&found), rows(&about(axis, angle)), TOLERANCE);
    }
}

#[test]
fn log_is_the_vector_of_which_exp_is_the_matrix() {
    let mut random = Random::new(12);
    for angle in [
        0.0,
        1e-30,
        1e-9,
        1e-4,
        0.3,
        1.5,
        2.5,
        3.1,
        PI - 1e-7,
        PI - 1e-12,
    ] {
        for _ in 0..100 {
            let vector = scaled(angle, axis(&mut random));
            // Of small turns relative: the entries beside the diagonal are sines, which have all their digits.
            let part = if angle < 1e-3 { 1e-15 * angle } else { 2e-15 };
            let tolerance = Tolerance::absolute(part);
            assert_close(angle, &log(&exp(&vector)), &vector, tolerance);
        }
    }
    // Quarter and half turns about the axes, where entries of the quaternion vanish or are equal.
    for i in 0..3 {
        for angle in [0.5 * PI, PI, -0.5 * PI] {
            let mut vector = [0.0; 3];
            vector[i] = angle;
            let found = log(&exp(&vector));
            let size = dot(found, found).sqrt();
            assert_close(angle, &[size], &[angle.abs()], TOLERANCE);
            assert_close(angle, rows(&exp(&found)), rows(&exp(&vector)), TOLERANCE);
        }
    }
}

#[test]
fn difference_is_along_the_inertial_axes_and_of_the_frames_local_to_both() {
    let mut random = Random::new(13);
    for angle in [0.0, 1e-9, 0.3, 1.5, 3.0, PI - 1e-7] {
        let (from, axis) = (about(axis(&mut random), 2.0), axis(&mut random));
        let to = turned(&from, axis, angle);
        assert_close(
            angle,
            &difference(&from, &to),
            &scaled(angle, axis),
            TOLERANCE,
        );
        // Seen from the first frame, whose axes the components are then along.
        let seen = log(&product(&to, &transposed(&from)));
        assert_close(angle, &seen, &times(&from, scaled(angle, axis)), TOLERANCE);
    }
}

#[test]
fn jacobians_are_the_rates_for_angular_velocities() {
    let mut random = Random::new(14);
    for angle in [1e-9, 1e-3, 0.3, 1.5, 2.5, 3.0] {
        let vector = scaled(angle, axis(&mut random));
        let rotation = exp(&vector);
        let inertial = by_axes(|w| derivative(|t| log(&turned(&rotation, w, t)).to_vec()));
        let by_w = log_jacobian(&vector);
        assert_close(angle, rows(&by_w), rows(&inertial), DIFFERENCED);
        // About the frame's own axes.
        let own = by_axes(|w| derivative(|t| log(&product(&about(w, t), &rotation)).to_vec()));
        assert_close(angle, rows(&transposed(&by_w)), rows(&own), DIFFERENCED);
        let identity = product(&exp_jacobian(&vector), &by_w);
        assert_close(angle, rows(&identity), rows(&exp(&[0.0; 3])), TOLERANCE);
        let velocity = by_axes(|rate| {
            let at = |t: f64| exp(&sum(vector, scaled(t, rate)));
            derivative(|t| difference(&rotation, &at(t)).to_vec())
        });
        assert_close(
            angle,
            rows(&exp_jacobian(&vector)),
            rows(&velocity),
            DIFFERENCED,
        );
    }
}

#[test]
fn errors_and_differences_change_with_both_orientations() {
    let mut random = Random::new(15);
    for angle in [0.0, 1e-9, 0.3, 1.5, 2.9] {
        let (from, axis) = (about(axis(&mut random), 1.0), axis(&mut random));
        let to = turned(&from, axis, angle);
        let (found, by_to) = error_and_jacobian(&from, &to);
        assert_eq!(found, error(&from, &to));
        let vector = difference(&from, &to);
        for (what, by_to, of) in [
            ("error", by_to, error as fn(&Rotation, &Rotation) -> Vector),
            ("difference", log_jacobian(&vector), difference),
        ] {
            let what = format!("{what}, {angle}");
            let along = by_axes(|w| derivative(|t| of(&from, &turned(&to, w, t)).to_vec()));
            assert_close(&what, rows(&by_to), rows(&along), DIFFERENCED);
            let back = by_axes(|w| derivative(|t| of(&turned(&from, w, t), &to).to_vec()));
            let by_from = transposed(&by_to).map(|row| row.map(|entry| -entry));
            assert_close(&what, rows(&by_from), rows(&back), DIFFERENCED);
        }
    }
}

#[test]
fn vectors_in_single_precision_come_back_near_none_and_half_a_turn() {
    let single = |entries: [f64; 3]| entries.map(<f32 as kane::Real>::from_f64);
    let mut random = Random::new(17);
    for angle in [
        0.0,
        1e-30,
        1e-9,
        1e-4,
        1e-2,
        1.5,
        PI - 1e-2,
        PI - 1e-4,
        PI - 1e-6,
    ] {
        for _ in 0..100 {
            let vector = single(scaled(angle, axis(&mut random)));
            let rotation = exp(&vector);
            let expected = about(unit(vector.map(f64::from)), angle);
            let entries: Vec<f64> = rotation
                .as_flattened()
                .iter()
                .copied()
                .map(f64::from)
                .collect();
            if angle > 0.0 {
                assert_close(angle, &entries, rows(&expected), SINGLE);
            }
            let part = if angle < 1e-3 { 1e-6 * angle } else { 1e-6 };
            let found = log(&rotation).map(f64::from);
            // So near half a turn both ways are the same.
            let back = vector.map(f64::from);
            let ahead = dot(found, back) >= 0.0 || angle < PI - 1e-5;
            let expected = if ahead {
                back
            } else {
                scaled(1.0 - 2.0 * PI / angle, back)
            };
            assert_close(angle, &found, &expected, Tolerance::absolute(part));
            let product = product_of(&exp_jacobian(&vector), &log_jacobian(&vector));
            assert_close(angle, rows(&product), rows(&exp(&[0.0; 3])), SINGLE);
        }
    }
}

#[cfg(feature = "wide")]
#[test]
fn each_lane_of_a_rotation_has_the_bits_of_its_own() {
    use kane::Lanes;
    use kane::wide::f64x4;
    let mut random = Random::new(16);
    let vectors = [0.0, 1e-9, 1.5, PI].map(|angle| scaled(angle, axis(&mut random)));
    let lanes: [f64x4; 3] = [0, 1, 2].map(|i| Lanes::load(&vectors.map(|vector| vector[i])));
    let back = log(&exp(&lanes));
    let by_w = log_jacobian(&back);
    for (lane, vector) in vectors.iter().enumerate() {
        let own = log(&exp(vector));
        let bits = |found: [f64x4; 3]| found.map(|entry| entry.to_array()[lane].to_bits());
        assert_eq!(bits(back), own.map(f64::to_bits));
        let own = log_jacobian(&own);
        assert_eq!(by_w.map(bits), own.map(|row| row.map(f64::to_bits)));
    }
}
