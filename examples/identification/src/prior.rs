//! What is believed of an arm before anything is measured, and is wrong.

use nalgebra::{Matrix4, Vector3};

use crate::Physical;

/// By which part masses are wrong: too heavy and too light in turn.
const MASS: f64 = 0.3;
/// How far along each axis mass centres are from where they are believed, m.
const SHIFT: f64 = 0.02;
/// The part of the drives' coefficients that is believed in.
const DRIVE: f64 = 0.5;

/// The prior for an arm that is so in truth.
pub fn wrong(truth: &Physical) -> Physical {
    let shift = Matrix4::new_translation(&Vector3::repeat(SHIFT));
    let bodies = truth
        .bodies
        .iter()
        .zip([1.0 + MASS, 1.0 - MASS].into_iter().cycle());
    Physical {
        bodies: bodies
            .map(|(p, factor)| shift * p * shift.transpose() * factor)
            .collect(),
        drives: truth
            .drives
            .iter()
            .map(|of_joint| of_joint.map(|coefficient| DRIVE * coefficient))
            .collect(),
    }
}
