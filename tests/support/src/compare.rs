//! Comparisons of numbers that are computed in two ways.
//!
//! In: numbers that were found, numbers that are expected, and how far apart they may be. Out: how far apart they are, or
//! the [`Mismatch`] that says where. Afterwards every number was compared and is finite: what is not a number, infinite or
//! missing is as wrong as can be, on either side. What is meant to be infinite or NaN is no matter for these.

use std::fmt::{self, Display};

/// How far apart numbers may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    relative: f64,
    scale: Scale,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    /// The largest magnitude of what is expected, but no less than this.
    Expected {
        least: f64,
    },
    Given(f64),
}

impl Tolerance {
    /// A distance in the numbers' own unit.
    pub const fn absolute(distance: f64) -> Self {
        Self::of(1.0, distance)
    }

    /// A part of the largest magnitude of what is expected.
    pub const fn relative(part: f64) -> Self {
        Self::relative_beyond(0.0, part)
    }

    /// A part of the largest magnitude of what is expected, or of `least` where all that is expected is smaller.
    pub const fn relative_beyond(least: f64, part: f64) -> Self {
        Self {
            relative: part,
            scale: Scale::Expected { least },
        }
    }

    /// A part of a scale, which says how large the terms are of which the numbers are sums.
    pub const fn of(scale: f64, part: f64) -> Self {
        Self {
            relative: part,
            scale: Scale::Given(scale),
        }
    }

    /// The distance that it allows; NaN, which allows none, unless it is finite.
    fn distance(self, expected: &[f64]) -> f64 {
        let scale = match self.scale {
            Scale::Expected { least } => larger(least, largest(expected)),
            Scale::Given(scale) => scale,
        };
        finite(self.relative * scale)
    }
}

/// Where two lists of numbers differ.
#[derive(Clone, Debug, PartialEq)]
pub enum Mismatch {
    /// They are of different lengths.
    Length { found: usize, expected: usize },
    /// The number that is farthest off.
    Number {
        place: usize,
        found: f64,
        expected: f64,
        error: f64,
        tolerance: f64,
    },
}

impl Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { found, expected } => {
                write!(f, "found {found} numbers, expected {expected}")
            }
            Self::Number {
                place,
                found,
                expected,
                error,
                tolerance,
            } => write!(
                f,
                "entry {place}: found {found:e}, expected {expected:e}: off by {error:e}, {tolerance:e} allowed"
            ),
        }
    }
}

/// The largest distance between two lists of numbers that are near each other.
///
/// # Errors
/// The lengths, or the number that is farthest off, where they are not.
pub fn compare(found: &[f64], expected: &[f64], tolerance: Tolerance) -> Result<f64, Mismatch> {
    if found.len() != expected.len() {
        return Err(Mismatch::Length {
            found: found.len(),
            expected: expected.len(),
        });
    }
    let tolerance = tolerance.distance(expected);
    let errors: Vec<f64> = found
        .iter()
        .zip(expected)
        .map(|(a, b)| error(*a, *b))
        .collect();
    let most = largest(&errors);
    // Nothing is compared where there is nothing.
    if most <= tolerance || errors.is_empty() {
        return Ok(most);
    }
    let is_worst = |error: &f64| error.is_nan() || *error == most;
    let place = errors
        .iter()
        .position(is_worst)
        .expect("the largest is one of them");
    Err(Mismatch::Number {
        place,
        found: found[place],
        expected: expected[place],
        error: errors[place],
        tolerance,
    })
}

/// Asserts that numbers are near those that are expected; returns the largest distance.
///
/// # Panics
/// If they are not, with what they are, where, and by how much.
#[track_caller]
pub fn assert_close(
    what: impl Display,
    found: &[f64],
    expected: &[f64],
    tolerance: Tolerance,
) -> f64 {
    match compare(found, expected, tolerance) {
        Ok(error) => error,
        #[expect(clippy::panic, reason = "an assertion")]
        Err(mismatch) => panic!("{what}: {mismatch}"),
    }
}

/// Asserts that an error that was computed lies within its tolerance; returns it.
///
/// # Panics
/// If it does not, or is no number.
#[track_caller]
pub fn assert_within(what: impl Display, error: f64, tolerance: f64) -> f64 {
    assert!(
        error.abs() <= finite(tolerance),
        "{what}: off by {error:e}, {tolerance:e} allowed"
    );
    error
}

/// The distance between two numbers; NaN unless both are finite.
pub fn error(found: f64, expected: f64) -> f64 {
    finite((found - expected).abs())
}

/// The larger of two; NaN if one is. `f64::max` takes the other one, with which a comparison cannot fail.
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// The largest magnitude, zero of none; NaN if there is one.
pub fn largest<'n>(values: impl IntoIterator<Item = &'n f64>) -> f64 {
    let magnitudes = values.into_iter().map(|value| value.abs());
    magnitudes.fold(0.0, larger)
}

/// The largest difference; NaN unless all numbers are finite.
///
/// # Panics
/// If there are not as many on both sides.
#[track_caller]
pub fn distance(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len(), "as many entries");
    let errors = found.iter().zip(expected).map(|(a, b)| error(*a, *b));
    errors.fold(0.0, larger)
}

/// The largest difference, relative to the largest entry of the second; zero where both are zero.
#[track_caller]
pub fn relative(found: &[f64], expected: &[f64]) -> f64 {
    relative_to(largest(expected), found, expected)
}

/// The largest difference, relative to `scale`; zero where there is none; NaN unless all are finite.
#[track_caller]
pub fn relative_to(scale: f64, found: &[f64], expected: &[f64]) -> f64 {
    let distance = distance(found, expected);
    if distance == 0.0 && scale.is_finite() {
        0.0
    } else {
        distance / finite(scale)
    }
}

/// The largest magnitude of what should be zero, relative to `scale`; NaN unless all are finite.
pub fn size_of(scale: f64, values: &[f64]) -> f64 {
    relative_to(scale, values, &vec![0.0; values.len()])
}

fn finite(number: f64) -> f64 {
    if number.is_finite() { number } else { f64::NAN }
}

#[cfg(test)]
mod tests {
    use super::{
        Mismatch, Tolerance, assert_close, assert_within, compare, distance, larger, largest,
        relative, relative_to,
    };

    const INF: f64 = f64::INFINITY;
    const NAN: f64 = f64::NAN;
    /// All tolerances that are wide beside the numbers of these tests.
    const WIDE: [Tolerance; 4] = [
        Tolerance::absolute(1e3),
        Tolerance::relative(1e3),
        Tolerance::relative_beyond(1.0, 1e3),
        Tolerance::of(1e3, 1.0),
    ];

    #[test]
    fn numbers_within_the_tolerance_are_near() {
        for tolerance in WIDE {
            assert_eq!(compare(&[1.0, 2.5], &[1.0, 2.0], tolerance), Ok(0.5));
        }
        assert_eq!(
            assert_close("speed", &[1.5], &[1.0], Tolerance::absolute(0.5)),
            0.5
        );
    }

    #[test]
    fn what_is_not_finite_is_near_nothing_on_either_side_or_both() {
        for bad in [NAN, INF, -INF] {
            for tolerance in WIDE {
                for (found, expected) in [(bad, 1.0), (1.0, bad), (bad, bad), (bad, -bad)] {
                    for (found, expected) in [
                        ([found, 1.0], [expected, 1.0]),
                        ([1.0, found], [1.0, expected]),
                    ] {
                        assert!(
                            compare(&found, &expected, tolerance).is_err(),
                            "{found:?} {expected:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn a_tolerance_that_is_not_finite_allows_nothing() {
        for bad in [NAN, INF] {
            for tolerance in [
                Tolerance::absolute(bad),
                Tolerance::relative(bad),
                Tolerance::of(bad, 1.0),
            ] {
                assert!(compare(&[1.0], &[1.0], tolerance).is_err());
            }
        }
    }

    #[test]
    fn lengths_are_compared() {
        let lengths = |found, expected| Err(Mismatch::Length { found, expected });
        assert_eq!(compare(&[], &[1.0], WIDE[0]), lengths(0, 1));
        assert_eq!(compare(&[1.0], &[], WIDE[0]), lengths(1, 0));
        assert_eq!(compare(&[1.0, 2.0], &[1.0], WIDE[0]), lengths(2, 1));
        assert_eq!(compare(&[], &[], Tolerance::relative(0.0)), Ok(0.0));
    }

    #[test]
    fn relative_tolerances_go_with_the_largest_number_expected() {
        let (found, expected) = ([1000.0, 1.5], [1000.0, 1.0]);
        assert!(compare(&found, &expected, Tolerance::relative(1e-3)).is_ok());
        assert!(compare(&found, &expected, Tolerance::relative(1e-4)).is_err());
        // Of what is found nothing follows.
        assert!(compare(&[1e9], &[1.0], Tolerance::relative(0.5)).is_err());
        // Zeros have no part, unless there is a least scale.
        assert!(compare(&[1e-9], &[0.0], Tolerance::relative(1e-3)).is_err());
        assert!(compare(&[1e-9], &[0.0], Tolerance::relative_beyond(1.0, 1e-3)).is_ok());
        assert!(compare(&[0.0], &[0.0], Tolerance::relative(1e-3)).is_ok());
    }

    #[test]
    fn absolute_tolerances_go_with_nothing() {
        assert!(compare(&[1000.5], &[1000.0], Tolerance::absolute(1e-3)).is_err());
        assert!(compare(&[1e-4], &[0.0], Tolerance::absolute(1e-3)).is_ok());
    }

    #[test]
    fn the_number_farthest_off_is_told() {
        let mismatch = compare(
            &[1.0, 2.5, 4.0],
            &[1.25, 2.0, 4.0],
            Tolerance::of(0.5, 0.25),
        );
        let text = "entry 1: found 2.5e0, expected 2e0: off by 5e-1, 1.25e-1 allowed";
        assert_eq!(mismatch.unwrap_err().to_string(), text);
    }

    #[test]
    #[should_panic(
        expected = "bias of a tree: entry 2: found NaN, expected 1e0: off by NaN, 1e-1 allowed"
    )]
    fn a_failure_says_of_what() {
        let found = [2.0, 1.0, NAN];
        assert_close(
            "bias of a tree",
            &found,
            &[1.0; 3],
            Tolerance::absolute(0.1),
        );
    }

    #[test]
    #[should_panic(expected = "off by NaN")]
    fn an_error_that_is_no_number_lies_within_nothing() {
        assert_within("energy", NAN, INF);
    }

    #[test]
    #[should_panic(expected = "inf allowed")]
    fn nothing_lies_within_infinity() {
        assert_within("energy", 1.0, INF);
    }

    #[test]
    fn errors_keep_what_is_no_number() {
        assert!(larger(NAN, 1.0).is_nan() && larger(1.0, NAN).is_nan());
        assert_eq!((larger(1.0, 2.0), larger(2.0, 1.0)), (2.0, 2.0));
        assert!(largest(&[1.0, NAN, 2.0]).is_nan());
        assert_eq!(largest(&[1.0, -3.0, 2.0]), 3.0);
        assert!(distance(&[INF], &[INF]).is_nan() && distance(&[1.0], &[INF]).is_nan());
        assert!(relative(&[1.0], &[INF]).is_nan() && relative(&[NAN, 1.0], &[1.0, 1.0]).is_nan());
        assert!(
            relative_to(INF, &[1.0], &[2.0]).is_nan() && relative_to(NAN, &[1.0], &[1.0]).is_nan()
        );
        assert_eq!(relative(&[0.0], &[0.0]), 0.0);
        assert_eq!(relative(&[1.0], &[0.0]), INF);
    }
}
