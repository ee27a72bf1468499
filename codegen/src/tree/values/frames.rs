//! The values of a frame that only marks a place.

use crate::description::{FrameRotation, Scalar, WrittenFrame};
use crate::diagnostic::Spanned;
use crate::geometry::{IDENTITY, Rotation};
use crate::id::BodyId;
use crate::tree::value::Value;
use crate::tree::values::parameters::Parameters;

/// The values of a written frame, along the axes of the body in which it is fixed.
pub(crate) struct FrameValues {
    /// From the body's origin, m.
    pub(crate) position: [Value; 3],
    /// To the frame's axes, as written; the identity where they are turned at run time.
    pub(crate) rotation: Rotation,
    /// A rotation that is set at run time.
    pub(crate) turn: Option<[[Value; 3]; 3]>,
}

/// A written frame and what is known of it already.
pub(crate) struct KnownFrame<'a> {
    pub(crate) written: &'a WrittenFrame,
    pub(crate) identifier: &'a str,
    /// The body of the tree in which it is; `None` is the inertial frame.
    pub(crate) host: Option<BodyId>,
}

pub(super) fn of_frame(parameters: &mut Parameters, frame: &KnownFrame<'_>) -> Option<FrameValues> {
    let &KnownFrame {
        written,
        identifier,
        host,
    } = frame;
    let name = format!("{identifier}_position");
    let position = parameters.vector(&written.position, &name, host, "m")?;
    let (rotation, rows) = match written.rotation?.value {
        FrameRotation::Baked(rotation) => (rotation, None),
        FrameRotation::Runtime(rows) => (IDENTITY, Some(rows)),
    };
    let mut turn = None;
    if let Some(rows) = rows {
        let mut values = [[Value::Baked(0.0); 3]; 3];
        for (row, (axis, numbers)) in values.iter_mut().zip(["x", "y", "z"].iter().zip(rows)) {
            let given =
                numbers.map(|number| Some(Spanned::new(Scalar::Runtime(number), written.span)));
            let name = format!("{identifier}_rotation_{axis}");
            *row = parameters.vector(&given, &name, host, "1")?;
        }
        turn = Some(values);
    }
    Some(FrameValues {
        position,
        rotation,
        turn,
    })
}
