//! `origin`: where a frame stands in another.

use crate::description::xml::{Element, Known, Reader};
use crate::description::{Given, Optional, Rotation, Scalar};
use crate::diagnostic::{Diagnostic, Spanned};
use crate::geometry;

/// Nobody writes more, rad; beyond `2 pi` for those who round up.
const ONE_TURN: f64 = 6.3;

/// A frame in another one.
pub(super) struct OriginElement {
    /// Its origin, in components of the other, m.
    pub(super) position: [Given<Scalar>; 3],
    /// From the other's axes to its own; absent: the same.
    pub(super) rotation: Optional<Rotation>,
}

/// The `origin` of an element, at zero where there is none; `owner` is the words for the element.
pub(super) fn read(reader: &mut Reader, element: Element<'_>, owner: &str) -> OriginElement {
    let mut origin = OriginElement {
        position: [Some(Spanned::new(Scalar::Baked(0.0), element.span())); 3],
        rotation: None,
    };
    let Some(element) = reader.child(element, owner, "origin") else {
        return origin;
    };
    let owner = format!("`origin` of {owner}");
    let known = Known {
        attributes: &["xyz", "rpy", "quat_xyzw"],
        ..Known::NONE
    };
    reader.unknown(element, &owner, &known);
    if let Some(xyz) = element.attribute("xyz") {
        let numbers: Option<[_; 3]> = reader.numbers(xyz, &format!("`xyz` of {owner}"));
        origin.position = numbers.map_or([None; 3], |numbers| {
            numbers.map(|x| Some(Spanned::new(Scalar::Baked(x.value), x.span)))
        });
    }
    let quaternion = element.attribute("quat_xyzw");
    if let (Some(quaternion), Some(rpy)) = (quaternion, element.attribute("rpy")) {
        let fault = Diagnostic::error(format!("{owner} has `rpy` and `quat_xyzw`"));
        let fault = fault.at(quaternion.span, "expected one of them");
        reader.faults.push(fault.at(rpy.span, "the other one"));
    } else if let Some(quaternion) = quaternion {
        let numbers: Option<[_; 4]> =
            reader.numbers(quaternion, &format!("`quat_xyzw` of {owner}"));
        origin.rotation = numbers.and_then(|numbers| {
            let rotation = of_quaternion(numbers.map(|number| number.value));
            if rotation.is_none() {
                let fault = format!("`quat_xyzw` of {owner} has no length");
                reader
                    .faults
                    .push(Diagnostic::error(fault).at(quaternion.span, "expected a rotation"));
            }
            Some(Spanned::new(rotation?, quaternion.span))
        });
    } else if let Some(rpy) = element.attribute("rpy") {
        let angles: Option<[_; 3]> = reader.numbers(rpy, &format!("`rpy` of {owner}"));
        let angles = angles.map(|angles| angles.map(|angle| angle.value));
        if angles.is_some_and(|angles| angles.iter().any(|angle| angle.abs() > ONE_TURN)) {
            let message =
                format!("an angle in `rpy` of {owner} is more than a turn; is it in degrees?");
            let warning = Diagnostic::warning(message).at(rpy.span, "expected radians");
            let warning = warning.one_of(
                "`rpy` attributes have angles of more than a turn, as if in degrees, not radians",
                owner.clone(),
            );
            reader.faults.push(warning);
        }
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

/// The turned axes as rows; the quaternion, scalar last, is made a unit one.
fn of_quaternion(xyzw: [f64; 4]) -> Option<Rotation> {
    let largest = xyzw
        .iter()
        .fold(0.0, |most: f64, part| most.max(part.abs()));
    if largest == 0.0 {
        return None;
    }
    let [x, y, z, w] = xyzw.map(|part| part / largest);
    geometry::of_quaternion([w, x, y, z])
}
