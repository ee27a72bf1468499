//! What a force at one joint feels in the reference pose, while all other joints are free.

use crate::description::mjcf::joints::JointElement;
use crate::description::mjcf::joints::joint_type::JointType;
use crate::description::mjcf::mass::solid::{Solid, Tensor, turned};
use crate::description::mjcf::placement::Placement;
use crate::geometry::{Vector, cross, dot, of_unit_mass, scaled, sum, symmetric};
use crate::limits::SPRING_UPDATES;

/// A pivot below this part of its diagonal entry is rounding: the speeds beyond it move the same alike.
const ROUNDING: f64 = 1e-12;

/// A body in the reference pose, `qpos0` of MuJoCo, behind its lower body in the list.
pub(in crate::description::mjcf) struct PosedBody<'b> {
    /// Its lower body's number, from 1, or 0 for the world.
    pub(in crate::description::mjcf) lower: usize,
    /// Where it stands in its lower body.
    pub(in crate::description::mjcf) place: &'b Placement,
    pub(in crate::description::mjcf) joint: Option<&'b JointElement>,
    pub(in crate::description::mjcf) mass: Option<Solid>,
}

/// A speed: a velocity of the point at the world's origin, and an angular velocity.
#[derive(Clone, Copy)]
struct Axis {
    linear: Vector,
    angular: Vector,
}

/// Mass, first and second moments about the world's origin and along its axes.
#[derive(Clone, Copy)]
struct Inertia {
    mass: f64,
    moment: Vector,
    tensor: Tensor,
}

/// A speed, which is a row of the mass matrix.
struct Row {
    body: usize,
    axis: Axis,
    armature: f64,
    /// The rows of the speeds below, the nearest first.
    below: Vec<usize>,
}

/// The inertia of each body's joint, if that has one speed; kg m² or kg. `None` where that takes too many steps.
pub(in crate::description::mjcf) fn inertias(bodies: &[PosedBody<'_>]) -> Option<Vec<Option<f64>>> {
    let mut places = vec![Placement::SAME];
    let mut composites = vec![Inertia::NONE];
    let mut rows: Vec<Row> = Vec::new();
    let mut updates = 0;
    // The last speed of each body, or of the nearest below that has one.
    let mut last: Vec<Option<usize>> = vec![None];
    for (index, body) in bodies.iter().enumerate() {
        let place = places[body.lower].then(body.place);
        composites.push(Inertia::of(body.mass.as_ref(), &place));
        let mut below = last[body.lower];
        let joint = body.joint.into_iter();
        for (axis, armature) in joint.flat_map(|joint| axes(joint, &place)) {
            let mut chain: Vec<usize> = Vec::new();
            if let Some(nearest) = below {
                chain.push(nearest);
                chain.extend(&rows[nearest].below);
            }
            updates += chain.len() * chain.len();
            if updates > SPRING_UPDATES {
                return None;
            }
            below = Some(rows.len());
            let body = index + 1;
            rows.push(Row {
                body,
                axis,
                armature,
                below: chain,
            });
        }
        last.push(below);
        places.push(place);
    }
    for (index, body) in bodies.iter().enumerate().rev() {
        let composite = composites[index + 1];
        composites[body.lower].add(&composite);
    }
    let factors = factors(&rows, &composites);
    let mut inertias = vec![None; bodies.len()];
    for (row, own) in rows.iter().enumerate() {
        let joint = bodies[own.body - 1].joint;
        let has_one = joint.is_some_and(|joint| joint.axis.is_some());
        inertias[own.body - 1] = has_one.then(|| 1.0 / inverse_entry(&rows, &factors, row));
    }
    Some(inertias)
}

/// `L` below the diagonal, along each row's speeds below, and `D`: the mass matrix is `Lᵀ D L`. A pivot that vanishes is zero, and so is
/// its row of `L`.
struct Factors {
    lower: Vec<Vec<f64>>,
    diagonal: Vec<f64>,
}

fn factors(rows: &[Row], composites: &[Inertia]) -> Factors {
    let mut lower = Vec::with_capacity(rows.len());
    let mut diagonal = Vec::with_capacity(rows.len());
    for row in rows {
        let momentum = composites[row.body].times(&row.axis);
        let entry =
            |axis: &Axis| dot(axis.linear, momentum.linear) + dot(axis.angular, momentum.angular);
        let below = row.below.iter().map(|other| entry(&rows[*other].axis));
        lower.push(below.collect::<Vec<f64>>());
        diagonal.push(entry(&row.axis) + row.armature);
    }
    let whole = diagonal.clone();
    for k in (0..rows.len()).rev() {
        let below = &rows[k].below;
        let entries = std::mem::take(&mut lower[k]);
        if diagonal[k] <= ROUNDING * whole[k] {
            diagonal[k] = 0.0;
            lower[k] = vec![0.0; entries.len()];
            continue;
        }
        let scaled: Vec<f64> = entries.iter().map(|entry| entry / diagonal[k]).collect();
        for (place, row) in below.iter().enumerate() {
            diagonal[*row] -= scaled[place] * entries[place];
            // What is below that speed stands behind it in both lists.
            for (entry, further) in lower[*row].iter_mut().zip(&entries[place + 1..]) {
                *entry -= scaled[place] * further;
            }
        }
        lower[k] = scaled;
    }
    Factors { lower, diagonal }
}

/// The entry of the inverse mass matrix in the diagonal.
fn inverse_entry(rows: &[Row], factors: &Factors, row: usize) -> f64 {
    // y = L⁻ᵀ e, which has entries at the speed and those below; the entry is yᵀ D⁻¹ y.
    let chain: Vec<usize> = std::iter::once(row)
        .chain(rows[row].below.iter().copied())
        .collect();
    let mut y = vec![0.0; chain.len()];
    y[0] = 1.0;
    let mut entry = 0.0;
    for (place, at) in chain.iter().enumerate() {
        let own = y[place];
        if own != 0.0 {
            entry += own * own / factors.diagonal[*at];
        }
        for (later, factor) in y[place + 1..].iter_mut().zip(&factors.lower[*at]) {
            *later -= factor * own;
        }
    }
    entry
}

/// The speeds of a joint, and their rotors.
fn axes(joint: &JointElement, place: &Placement) -> Vec<(Axis, f64)> {
    let anchor = place.point(joint.anchor);
    let armature = joint.armature();
    let turn = |axis: Vector| Axis {
        linear: cross(anchor, axis),
        angular: axis,
    };
    let shift = |axis: Vector| Axis {
        linear: axis,
        angular: [0.0; 3],
    };
    let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let turns = units.map(|axis| turn(place.vector(axis)));
    let axes: Vec<Axis> = match (joint.kind, joint.axis) {
        (JointType::Hinge, Some(axis)) => vec![turn(place.vector(axis))],
        (JointType::Slide, Some(axis)) => vec![shift(place.vector(axis))],
        (JointType::Hinge | JointType::Slide, None) => Vec::new(),
        (JointType::Ball, _) => turns.to_vec(),
        (JointType::Free, _) => turns.into_iter().chain(units.map(shift)).collect(),
    };
    axes.into_iter().map(|axis| (axis, armature)).collect()
}

impl Inertia {
    const NONE: Self = Self {
        mass: 0.0,
        moment: [0.0; 3],
        tensor: [0.0; 6],
    };

    fn of(mass: Option<&Solid>, place: &Placement) -> Self {
        let Some(solid) = mass else {
            return Self::NONE;
        };
        let center = place.point(solid.center);
        let shift = of_unit_mass(center);
        let mut tensor = turned(solid.inertia, &place.rotation);
        for (entry, shift) in tensor.iter_mut().zip(shift) {
            *entry += solid.mass * shift;
        }
        Self {
            mass: solid.mass,
            moment: scaled(center, solid.mass),
            tensor,
        }
    }

    fn add(&mut self, other: &Self) {
        self.mass += other.mass;
        self.moment = sum(self.moment, other.moment);
        for (entry, other) in self.tensor.iter_mut().zip(other.tensor) {
            *entry += other;
        }
    }

    /// Momentum and angular momentum about the world's origin.
    fn times(&self, axis: &Axis) -> Axis {
        let spin = symmetric(self.tensor).map(|row| dot(row, axis.angular));
        Axis {
            linear: sum(
                scaled(axis.linear, self.mass),
                cross(axis.angular, self.moment),
            ),
            angular: sum(spin, cross(self.moment, axis.linear)),
        }
    }
}
