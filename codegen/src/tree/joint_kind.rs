//! What a joint is called, from what it leaves free after all changes.

use crate::tree::joint::Joint;
use crate::tree::joints;

impl Joint {
    /// The name of the kind of joint that leaves the same motions free, those that follow others among them; `None` where no kind
    /// does. A rotation without limits is `continuous`, whatever the user called it.
    pub fn kind(&self) -> Option<&'static str> {
        let moving = self.motions().map(|motion| motion.is_some());
        let mut limits = self.mechanics.iter().zip(moving);
        let has_limits = limits.any(|(mechanics, moves)| {
            moves && mechanics.range.iter().any(|limit| limit.is_finite())
        });
        joints::kind_of(moving, has_limits)
    }
}
