//! Snapping of the constant rotations of a description, with a record of what was changed.

use crate::description::Rotation;
use crate::diagnostic::Diagnostic;
use crate::tree::rotations::snap as rotation;

/// Makes entries of constant rotations exact, and remembers where.
pub(crate) struct Snapping {
    tolerance: f64,
    changed: Vec<String>,
    most: f64,
}

impl Snapping {
    pub(crate) fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            changed: Vec::new(),
            most: 0.0,
        }
    }

    /// A rotation that the user wrote.
    pub(crate) fn of(&mut self, rotation: &Rotation, what: String) -> Rotation {
        let (snapped, change) = rotation::snapped(&rotation::orthonormal(rotation), self.tolerance);
        if change > 0.0 {
            self.changed.push(what);
            self.most = self.most.max(change);
        }
        snapped
    }

    /// An axis that was changed by this much.
    pub(crate) fn axis(&mut self, change: f64, what: String) {
        if change > 0.0 {
            self.changed.push(what);
            self.most = self.most.max(change);
        }
    }

    /// A product of rotations, which rounding may have left near exact.
    pub(crate) fn quietly(&self, rotation: &Rotation) -> Rotation {
        rotation::snapped(rotation, self.tolerance).0
    }

    pub(crate) fn report(&self, findings: &mut Vec<Diagnostic>) {
        if !self.changed.is_empty() {
            findings.push(Diagnostic::note(format!(
                "entries of constant rotations and axes nearer than {:?} to 0, 1 or -1 were made exact, which changed none by more than {:.1e}: {}",
                self.tolerance,
                self.most,
                self.changed.join(", ")
            )));
        }
    }
}
