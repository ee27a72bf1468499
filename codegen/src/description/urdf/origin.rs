//! `origin`: where a frame stands in another.

use crate::description::xml::{Element, Known, Reader};
use crate::description::{Given, Optional, Rotation, Scalar};
use crate::diagnostic::Spanned;

/// A frame in another one.
pub(super) struct Origin {
    /// Its origin, in components of the other, m.
    pub(super) position: [Given<Scalar>; 3],
    /// From the other's axes to its own; absent: the same.
    pub(super) rotation: Optional<Rotation>,
}

/// The `origin` of an element, at zero where there is none; `owner` is the words for the element.
pub(super) fn read(reader: &mut Reader, element: Element<'_>, owner: &str) -> Origin {
    let mut origin = Origin {
        position: [Some(Spanned::new(Scalar::Baked(0.0), element.span())); 3],
        rotation: None,
    };
    let Some(element) = reader.child(element, owner, "origin") else {
        return origin;
    };
    let owner = format!("`origin` of {owner}");
    let known = Known {
        attributes: &["xyz", "rpy"],
        ..Known::NONE
    };
    reader.unknown(element, &owner, &known);
    if let Some(xyz) = element.attribute("xyz") {
        let numbers: Option<[_; 3]> = reader.numbers(xyz, &format!("`xyz` of {owner}"));
        origin.position = numbers.map_or([None; 3], |numbers| {
            numbers.map(|x| Some(Spanned::new(Scalar::Baked(x.value), x.span)))
        });
    }
    if let Some(rpy) = element.attribute("rpy") {
        let angles: Option<[_; 3]> = reader.numbers(rpy, &format!("`rpy` of {owner}"));
        let angles = angles.map(|angles| angles.map(|angle| angle.value));
        origin.rotation = angles
            .filter(|angles| *angles != [0.0; 3])
            .map(|angles| Spanned::new(rotation(angles), rpy.span));
    }
    origin
}

/// (Rz(yaw) Ry(pitch) Rx(roll))ᵀ: the turned axes as rows, for the product's columns are these axes.
fn rotation([roll, pitch, yaw]: [f64; 3]) -> Rotation {
    // Not std's, which differ from platform to platform.
    let (sr, cr) = libm::sincos(roll);
    let (sp, cp) = libm::sincos(pitch);
    let (sy, cy) = libm::sincos(yaw);
    let rows = [
        [cy * cp, sy * cp, -sp],
        [cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr],
        [cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr],
    ];
    // No minus zero.
    rows.map(|row| row.map(|entry| entry + 0.0))
}
