//! Reading MJCF for tests, and matrices.
#![allow(
    clippy::unwrap_used,
    reason = "functions of tests, which clippy takes for others"
)]

use std::collections::BTreeMap;
use std::io;

use kane_codegen::description::{
    Description, Limits, PerCoordinate, Reading, Rotation, Scalar, WrittenBody, WrittenJoint, mjcf,
};
use kane_codegen::diagnostic::{Diagnostics, Source, Spanned};
use kane_test_support::compare::{Tolerance, assert_close};

/// Three components.
pub(crate) type Vector = [f64; 3];

/// No rotation.
pub(crate) const SAME: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Reads a model with the files that it includes.
pub(crate) fn parse(text: &str, files: &[(&str, &str)]) -> Description {
    let files: BTreeMap<&str, &str> = files.iter().copied().collect();
    let include = |path: &str| {
        let text = files.get(path).map(|text| text.as_bytes().to_vec());
        text.ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "there is no such file"))
    };
    mjcf::parse(
        &Source::new("model.xml", text),
        &Reading::default(),
        &include,
    )
}

/// What is wrong with a model.
pub(crate) fn faults(description: &Description) -> Diagnostics {
    Diagnostics::new(description.source.clone(), description.faults.clone())
}

/// A model without an error.
pub(crate) fn read(text: &str) -> Description {
    let description = parse(text, &[]);
    let faults = faults(&description);
    assert!(!faults.has_error(), "{faults}");
    description
}

/// The only body, of a model with these sections before the bodies.
pub(crate) fn only(before: &str, body: &str) -> WrittenBody {
    let mut description = read(&format!(
        "<mujoco>{before}<worldbody>{body}</worldbody></mujoco>"
    ));
    assert_eq!(description.bodies.len(), 1);
    description.bodies.remove(0)
}

/// A number of a description.
pub(crate) fn number(given: Option<Spanned<Scalar>>) -> f64 {
    let Scalar::Baked(number) = given.unwrap().value else {
        unreachable!("MJCF has no numbers of the run time")
    };
    number
}

/// Three numbers of a description.
pub(crate) fn vector(given: [Option<Spanned<Scalar>>; 3]) -> Vector {
    given.map(number)
}

/// What all free coordinates of a joint have.
pub(crate) fn same<T: Copy>(quantity: &PerCoordinate<T>) -> Option<T> {
    match quantity {
        PerCoordinate::Same(value) => Some(value.value),
        _ => None,
    }
}

/// The number that all free coordinates of a joint have.
pub(crate) fn baked(quantity: &PerCoordinate<Scalar>) -> Option<f64> {
    same(quantity).map(Scalar::nominal)
}

/// Lower and upper limit, and the greatest force.
pub(crate) fn limits(joint: &WrittenJoint) -> [Option<f64>; 3] {
    let limits: Limits = same(&joint.limits).unwrap_or_default();
    [limits.lower, limits.upper, limits.effort].map(|limit| limit.map(|limit| limit.value))
}

/// The rotation from the lower body to the joint.
pub(crate) fn attachment_rotation(body: &WrittenBody) -> Rotation {
    body.joint.attachment_rotation.map_or(SAME, |r| r.value)
}

/// The product of two matrices.
pub(crate) fn product(a: &Rotation, b: &Rotation) -> Rotation {
    a.map(|row| [0, 1, 2].map(|j| (0..3).map(|k| row[k] * b[k][j]).sum()))
}

/// The transpose of a matrix.
pub(crate) fn transposed(a: &Rotation) -> Rotation {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| a[j][i]))
}

/// MuJoCo's matrix, which turns a body's components into its parent's, about x, y or z.
pub(crate) fn elementary(axis: char, angle: f64) -> Rotation {
    let (s, c) = libm::sincos(angle);
    match axis {
        'x' => [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
        'y' => [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
        _ => [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
    }
}

/// The same numbers, but for rounding.
pub(crate) fn close(found: &[f64], expected: &[f64]) {
    let tolerance = Tolerance::relative_beyond(1.0, 1e-13);
    assert_close("of a model", found, expected, tolerance);
}

/// The rows are MuJoCo's columns.
pub(crate) fn oriented(body: &WrittenBody, expected: &Rotation) {
    let found = attachment_rotation(body);
    close(found.as_flattened(), transposed(expected).as_flattened());
}
