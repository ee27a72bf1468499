//! Ways to fewer operations. Each can be left out, and no value depends on which are used.

use crate::tree::Tree;

/// A way to fewer operations, which can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Technique {
    // Where links are, what they hold, and what that needs.
    /// Links have their origins where their joints' axes are nearest to the lower link's origin, so that offsets have no part
    /// along the axis; a link that only translates has its lower link's.
    Slide,
    /// Links are turned about their joints' axes until the constant rotations between them are sparse (modified
    /// Denavit-Hartenberg frames where that is possible), and those that carry none until their first moment is.
    Turn,
    /// Of a link's inertia its lower link is given what the joint does not move: base inertial parameters.
    Regroup,
    /// Of the mass given to a lower link so much is kept on the axis that the lower link's first moment has no part along the
    /// way to it.
    Balance,
    /// Links on which all axes are parallel to their own do not turn.
    Parallel,
    /// Moments of inertia forces are `U S - S U^T` where second moments are zero.
    SecondMoments,
    // How quantities pass from link to link.
    /// What the inertial frame feels of a joint's motion is taken there at once, past joints at the same point, or left out where
    /// it feels nothing of it.
    Shortcut,
    /// Where a frame is, and its Jacobian's columns, pass inward from it, and not outward from the inertial frame.
    Inward,
    /// Where they do not, levers pass inward beside axes that pass outward, and are not added up from steps along these axes. With
    /// `Shortcut`, two columns of all bodies' momentum leave a link for inertial axes at once, and not three alone.
    Levers,
    /// Where nothing but weight counts and gravity is constant along an axis, weights pass inward, and not masses.
    Weights,
    /// How fast the mass matrix changes passes inward beside what becomes its entries, and is not differentiated from these.
    Rates,
    // How accelerations are solved for.
    /// Accelerations are solved for by articulated bodies.
    Articulated,
    /// Accelerations of joints that move freely about or along all axes are solved for along the link's axes.
    LinkAxes,
    /// The inverse of the mass matrix comes row by row from its factors, those of articulated bodies too, and what branches of a
    /// floating tree feel of one another passes through the acceleration of the body that carries them.
    Carriers,
    /// Where accelerations are solved for, bodies that nothing holds are taken to fall, and gravity is added to the result.
    Fall,
    // Of derivatives: `functions` derives them by these, `compile` chooses.
    /// Derivatives come in ways of their own: those of dynamics from composite bodies, products with those of accelerations from forces and
    /// one more solution, those of frames from the columns of their Jacobians; and not from the values' own operations.
    DirectDerivatives,
    /// Derivatives are carried from the outputs to what they depend on, and not outward from that.
    Reverse,
    /// Columns of long derivatives of dynamics, and of long inverses, go four at a time, by helpers that are called. Beside any plan,
    /// branches that are alike go side by side in every long function.
    Lockstep,
    // Passes over what was derived, which `compile` runs.
    /// Common factors are taken out of sums.
    Factor,
    /// Beside any plan: values that are sums, differences or products of others are made of these.
    Reuse,
}

impl Technique {
    /// All of them, with the names that they have in `kane.toml`.
    pub const ALL: [(&str, Self); 20] = [
        ("slide", Self::Slide),
        ("turn", Self::Turn),
        ("regroup", Self::Regroup),
        ("balance", Self::Balance),
        ("parallel", Self::Parallel),
        ("second_moments", Self::SecondMoments),
        ("shortcut", Self::Shortcut),
        ("inward", Self::Inward),
        ("levers", Self::Levers),
        ("weights", Self::Weights),
        ("rates", Self::Rates),
        ("articulated", Self::Articulated),
        ("link_axes", Self::LinkAxes),
        ("carriers", Self::Carriers),
        ("fall", Self::Fall),
        ("composite", Self::DirectDerivatives),
        ("reverse", Self::Reverse),
        ("lockstep", Self::Lockstep),
        ("factor", Self::Factor),
        ("reuse", Self::Reuse),
    ];

    /// False where one speed moves several joints, of what takes a speed's motion for the one of its own joint: that could
    /// not be eliminated where it enters, nor taken along other axes, nor fall.
    pub fn is_possible(self, tree: &Tree) -> bool {
        let is_by_joint = matches!(
            self,
            Self::Articulated | Self::LinkAxes | Self::Carriers | Self::Fall
        );
        !is_by_joint || !tree.has_followers()
    }
}
