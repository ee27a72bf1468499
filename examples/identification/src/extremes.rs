//! The largest and the least of several numbers, where one that is no number counts: `f64::max`, `f64::min` and nalgebra's
//! `amax`, `max` and `min` take another one in its place, with which no comparison fails.

use std::borrow::Borrow;

/// The largest magnitude, zero of none; NaN if there is one.
pub fn largest(values: impl IntoIterator<Item: Borrow<f64>>) -> f64 {
    let magnitudes = values.into_iter().map(|value| value.borrow().abs());
    magnitudes.fold(0.0, |largest, value| {
        // What is not a number stays.
        let stays = largest.is_nan() || value <= largest;
        if stays { largest } else { value }
    })
}

/// The least value, infinity of none; NaN if there is one.
pub fn least(values: impl IntoIterator<Item: Borrow<f64>>) -> f64 {
    let values = values.into_iter().map(|value| *value.borrow());
    values.fold(f64::INFINITY, |least, value| {
        let stays = least.is_nan() || value >= least;
        if stays { least } else { value }
    })
}
