//! Shapes that lead from one point to another: `fromto`.

use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::placement::unit;
use crate::description::xml::Reader;
use crate::diagnostic::Diagnostic;
use crate::geometry::{Vector, difference, scaled, sum};

/// The two points, which are not the same.
#[derive(Clone, Copy, Debug)]
pub(in crate::description::mjcf) struct Segment {
    from: Vector,
    to: Vector,
}

impl Segment {
    /// Reads `fromto`, which a sphere cannot have.
    pub(in crate::description::mjcf) fn read(
        reader: &mut Reader,
        element: &Attributes<'_>,
        is_sphere: bool,
    ) -> Option<Self> {
        if is_sphere {
            let message = format!(
                "{} has `fromto`, but is a sphere; expected a capsule, cylinder, ellipsoid or box",
                element.owner
            );
            let fault = Diagnostic::error(message).at(element.place("fromto"), "no length");
            reader.faults.push(fault);
            return None;
        }
        let [x1, y1, z1, x2, y2, z2] = element.vector(reader, "fromto")?;
        let segment = Self {
            from: [x1, y1, z1],
            to: [x2, y2, z2],
        };
        if unit(segment.along()).is_none() {
            let message = format!(
                "{} leads nowhere: both ends are the same",
                element.what("fromto")
            );
            let fault =
                Diagnostic::error(message).at(element.place("fromto"), "expected two points");
            reader.faults.push(fault);
            return None;
        }
        Some(segment)
    }

    /// From the first point to the second.
    pub(in crate::description::mjcf) fn along(&self) -> Vector {
        difference(self.to, self.from)
    }

    /// From the second point to the first: along this MuJoCo has the z axis.
    pub(in crate::description::mjcf) fn back(&self) -> Vector {
        difference(self.from, self.to)
    }

    pub(in crate::description::mjcf) fn center(&self) -> Vector {
        scaled(sum(self.from, self.to), 0.5)
    }
}
