//! The six relative coordinates of a body, by name.

/// The name of one of the six relative coordinates of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CoordinateName {
    /// The first of the 1-2-3 body-fixed angles, about x.
    Theta1,
    /// The second angle, about y.
    Theta2,
    /// The third angle, about z.
    Theta3,
    /// Translation along the x of the joint's axes in the lower body.
    S1,
    /// Translation along the y of the joint's axes in the lower body.
    S2,
    /// Translation along the z of the joint's axes in the lower body.
    S3,
}

impl CoordinateName {
    /// All six, angles first.
    pub const ALL: [Self; 6] = [
        Self::Theta1,
        Self::Theta2,
        Self::Theta3,
        Self::S1,
        Self::S2,
        Self::S3,
    ];
    /// Their names, in the same order.
    pub const NAMES: [&str; 6] = ["theta1", "theta2", "theta3", "s1", "s2", "s3"];

    /// The place in [`CoordinateName::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }

    /// The name in a description.
    pub fn name(self) -> &'static str {
        Self::NAMES[self.index()]
    }

    /// The coordinate with this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|known| known.name() == name)
    }

    /// True for an angle.
    pub fn is_angle(self) -> bool {
        self.index() < 3
    }
}
