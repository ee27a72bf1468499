//! Masses and inertias of shapes, and of shapes together.

use crate::description::Rotation;
use crate::description::mjcf::placement::Placement;
use crate::geometry::{Vector, difference, of_unit_mass, symmetric};

/// A symmetric matrix: xx, yy, zz, xy, xz, yz.
pub(in crate::description::mjcf) type Tensor = [f64; 6];

/// A rigid body's mass.
#[derive(Clone, Copy, Debug)]
pub(in crate::description::mjcf) struct Solid {
    /// kg.
    pub(in crate::description::mjcf) mass: f64,
    /// The mass centre, body components, m.
    pub(in crate::description::mjcf) center: Vector,
    /// About the mass centre, kg m².
    pub(in crate::description::mjcf) inertia: Tensor,
}

/// A shape of uniform density about its own origin and along its own axes; half the lengths, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::description::mjcf) enum Primitive {
    Sphere {
        radius: f64,
    },
    /// Along z; half the length between the centres of the caps.
    Capsule {
        radius: f64,
        half: f64,
    },
    /// Along z.
    Cylinder {
        radius: f64,
        half: f64,
    },
    Ellipsoid(Vector),
    Box(Vector),
}

/// How much mass a shape has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::description::mjcf) enum Amount {
    /// kg.
    Mass(f64),
    /// kg/m³.
    Density(f64),
}

impl Primitive {
    /// m³.
    pub(in crate::description::mjcf) fn volume(self) -> f64 {
        let pi = std::f64::consts::PI;
        match self {
            Self::Sphere { radius } => 4.0 / 3.0 * pi * radius * radius * radius,
            Self::Capsule { radius, half } => {
                pi * radius * radius * (2.0 * half + 4.0 / 3.0 * radius)
            }
            Self::Cylinder { radius, half } => pi * radius * radius * 2.0 * half,
            Self::Ellipsoid([a, b, c]) => 4.0 / 3.0 * pi * a * b * c,
            Self::Box([a, b, c]) => 8.0 * a * b * c,
        }
    }

    /// Moments about the shape's axes for a mass of one, m².
    fn moments(self) -> Vector {
        match self {
            Self::Sphere { radius } => [0.4 * radius * radius; 3],
            Self::Capsule { radius, half } => {
                let square = radius * radius;
                // The caps' part of the mass: (4/3 r) / (2 h + 4/3 r).
                let caps = 2.0 * radius / (3.0 * half + 2.0 * radius);
                let middle = 1.0 - caps;
                let across = middle * (3.0 * square + 4.0 * half * half) / 12.0
                    + caps * (0.4 * square + half * half + 0.75 * half * radius);
                let along = middle * 0.5 * square + caps * 0.4 * square;
                [across, across, along]
            }
            Self::Cylinder { radius, half } => {
                let across = (3.0 * radius * radius + 4.0 * half * half) / 12.0;
                [across, across, 0.5 * radius * radius]
            }
            Self::Ellipsoid(half) => squares(half).map(|moment| moment / 5.0),
            Self::Box(half) => squares(half).map(|moment| moment / 3.0),
        }
    }

    /// The shape where it stands in a body.
    pub(in crate::description::mjcf) fn solid(
        self,
        amount: Amount,
        placement: &Placement,
    ) -> Solid {
        let [xx, yy, zz] = self.moments();
        uniform(
            self.volume(),
            [xx, yy, zz, 0.0, 0.0, 0.0],
            amount,
            placement,
        )
    }
}

/// A shape of uniform density with this volume, and this inertia for a mass of one about the origin and along the axes of its
/// placement.
pub(in crate::description::mjcf) fn uniform(
    volume: f64,
    inertia: Tensor,
    amount: Amount,
    placement: &Placement,
) -> Solid {
    let mass = match amount {
        Amount::Mass(mass) => mass,
        Amount::Density(density) => density * volume,
    };
    Solid {
        mass,
        center: placement.position,
        inertia: turned(inertia.map(|entry| mass * entry), &placement.rotation),
    }
}

/// For each component the sum of the squares of the two others.
fn squares([a, b, c]: Vector) -> Vector {
    [b * b + c * c, a * a + c * c, a * a + b * b]
}

/// A tensor, given in the axes that the rotation leads to, in those that it leads from: `CᵀTC`.
pub(in crate::description::mjcf) fn turned(tensor: Tensor, rotation: &Rotation) -> Tensor {
    let rows = symmetric(tensor);
    let entry = |i: usize, j: usize| {
        let mut sum = 0.0;
        for (k, row) in rows.iter().enumerate() {
            for (l, value) in row.iter().enumerate() {
                sum += rotation[k][i] * value * rotation[l][j];
            }
        }
        sum
    };
    [
        entry(0, 0),
        entry(1, 1),
        entry(2, 2),
        entry(0, 1),
        entry(0, 2),
        entry(1, 2),
    ]
}

/// Several solids as one; `None` where they have no mass.
pub(in crate::description::mjcf) fn together(solids: &[Solid]) -> Option<Solid> {
    let mass: f64 = solids.iter().map(|solid| solid.mass).sum();
    if let [solid] = solids
        && mass != 0.0
    {
        return Some(*solid);
    }
    if mass == 0.0 {
        return None;
    }
    let center = [0, 1, 2].map(|i| {
        let moment: f64 = solids
            .iter()
            .map(|solid| solid.mass * solid.center[i])
            .sum();
        moment / mass + 0.0
    });
    let mut inertia = [0.0; 6];
    for solid in solids {
        let shift = of_unit_mass(difference(solid.center, center));
        for (index, sum) in inertia.iter_mut().enumerate() {
            *sum += solid.inertia[index] + solid.mass * shift[index];
        }
    }
    Some(Solid {
        mass,
        center,
        inertia,
    })
}

/// True for a tensor without a moment below zero about any axis, but for rounding.
pub(in crate::description::mjcf) fn is_positive(tensor: Tensor) -> bool {
    let largest = tensor.iter().fold(0.0, |most, entry| entry.abs().max(most));
    if largest == 0.0 {
        return true;
    }
    let [xx, yy, zz, xy, xz, yz] = tensor.map(|entry| entry / largest);
    let minors = [
        xx,
        yy,
        zz,
        xx * yy - xy * xy,
        xx * zz - xz * xz,
        yy * zz - yz * yz,
        xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz),
    ];
    minors.iter().all(|minor| *minor >= -1e-12)
}
