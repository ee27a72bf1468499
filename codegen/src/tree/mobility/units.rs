//! Units in which a tree's masses and lengths are near 1.

use crate::tree::system::Tree;

/// Units in which masses and lengths are near 1, so that squares neither overflow nor vanish.
pub(crate) struct Units {
    pub(crate) mass: f64,
    pub(crate) length: f64,
}

impl Units {
    /// The largest mass and length of a tree.
    pub(crate) fn of(tree: &Tree) -> Self {
        let largest = |numbers: &mut dyn Iterator<Item = f64>| {
            numbers.fold(0.0, |most: f64, number| most.max(number.abs()))
        };
        let or_one = |unit: f64| if unit > 0.0 { unit } else { 1.0 };
        let parts = || tree.bodies.iter().flat_map(|body| &body.parts);
        let attachments = tree.bodies.iter().map(|body| &body.joint.attachment);
        let lengths = attachments.chain(parts().map(|part| &part.mass_center));
        let length = or_one(largest(
            &mut lengths.flat_map(|offset| offset.nominal(&tree.parameters)),
        ));
        let masses = largest(&mut parts().map(|part| tree.nominal(part.mass)));
        let inertias = parts().flat_map(|part| [part.inertia.xx, part.inertia.yy, part.inertia.zz]);
        let inertias = largest(&mut inertias.map(|value| tree.nominal(value)));
        // Lengths too short to weigh the inertias with are no measure of the tree.
        let from_inertias = inertias / length / length;
        let (mass, length) = if from_inertias.is_finite() {
            (masses.max(from_inertias), length)
        } else {
            (masses.max(inertias), 1.0)
        };
        Self {
            mass: or_one(mass),
            length,
        }
    }
}
