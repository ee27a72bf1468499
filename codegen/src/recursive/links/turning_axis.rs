//! What the recursion asks of a joint: whether it moves about or along one axis alone.

use crate::{
    expr::Axis,
    tree::{Coordinate, Joint},
};

impl Joint {
    /// The axis of a joint that turns about one alone, and translates along that at most.
    pub(in crate::recursive) fn turning_axis(&self) -> Option<Axis> {
        let angles = self.angles_with_rates()?;
        let mut turning = Axis::ALL
            .into_iter()
            .filter(|axis| angles[axis.index()].motion().is_some());
        let axis = turning.next()?;
        let (b, c) = axis.others();
        let is_plain = [angles[b], angles[c]] == [Coordinate::Locked(0.0); 2];
        let is_still = [self.translations[b], self.translations[c]] == [Coordinate::Locked(0.0); 2];
        (is_plain && is_still).then_some(axis)
    }

    /// The axis of a joint that turns about one alone, and does nothing else.
    pub(in crate::recursive) fn hinge_axis(&self) -> Option<Axis> {
        let is_still = self.shifts().iter().all(Option::is_none);
        self.turning_axis().filter(|_| is_still)
    }

    /// True for a joint that never turns its body.
    pub(in crate::recursive) fn only_translates(&self) -> bool {
        self.angles_with_rates() == Some([Coordinate::Locked(0.0); 3])
    }
}
