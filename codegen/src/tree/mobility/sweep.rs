//! The sweeps: mass-weighted velocities, from the tips inward and back.

use crate::description::Axis;
use crate::geometry::{self, cross};
use crate::id::{BodyId, SpeedId};
use crate::random::Random;
use crate::tree::mobility::rows::{Twist, dot, join, project_out, triangle};
use crate::tree::principal::principal;
use crate::tree::{Coordinate, Orientation, Part, Tree};

/// Part of what a column could move at most, below which it moves nothing.
pub(crate) const IDLE: f64 = 1e-10;
/// Part of a motion's largest share, below which a coordinate has no share.
pub(crate) const SHARE: f64 = 1e-6;

/// What the inward sweep found at the joint of a body.
pub(crate) struct Joint {
    /// The free coordinates.
    pub(super) axes: Vec<Axis>,
    /// For each the twist that its unit rate gives the body.
    pub(super) columns: Vec<Twist>,
    /// For each the root of twice the energy of what turns or shifts with its unit rate alone: a rotor.
    pub(super) rotors: Vec<f64>,
    /// For each the most that its unit rate could move: root of twice the energy.
    pub(super) bounds: Vec<f64>,
    /// The twist of the body where that of the lower body is a unit: `carried[i]` for component `i`.
    pub(super) carried: [Twist; 6],
    /// Places in `axes` of the pivots, in their order.
    pub(super) pivots: Vec<usize>,
    /// Qᵀ B, pivot by pivot: `upper[i][c]` for the coordinate at place `c`, in units of its bound.
    pub(super) upper: Vec<Vec<f64>>,
    /// Qᵀ K, pivot by pivot, on the lower body's twist.
    pub(super) pulled: Vec<Twist>,
    /// Places in `axes` of the coordinates without pivot: they move no mass.
    pub(super) idle: Vec<usize>,
}

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

/// What lies beyond a joint: rows K whose squares on the twist sum to twice the energy, and bounds of them.
#[derive(Clone, Default)]
pub(crate) struct Beyond {
    pub(crate) rows: Vec<Twist>,
    mass: f64,
    /// The most that a unit angular velocity about the origin could move.
    turning: f64,
}

/// All joints at a state that `random` chooses, from the tips inward.
pub(crate) fn inward(tree: &Tree, units: &Units, random: &mut Random) -> Vec<Joint> {
    let mut beyond: Vec<Beyond> = tree.body_ids().map(|body| own(tree, units, body)).collect();
    let mut joints: Vec<Joint> = Vec::with_capacity(beyond.len());
    for body in tree.body_ids().rev() {
        let here = std::mem::take(&mut beyond[body.index()]);
        let (joint, lever) = place(tree, units, body, &here, random);
        let (joint, passed) = eliminate(joint, &here.rows);
        if let Some(lower) = tree.lower(body) {
            let lower = &mut beyond[lower.index()];
            lower.rows = triangle(lower.rows.iter().copied().chain(passed).collect());
            lower.mass += here.mass;
            let turning = here.turning + here.mass.sqrt() * lever;
            lower.turning = (lower.turning * lower.turning + turning * turning).sqrt();
        }
        joints.push(joint);
    }
    joints.reverse();
    joints
}

/// The rows of a body's own mass and inertia.
pub(crate) fn own(tree: &Tree, units: &Units, body: BodyId) -> Beyond {
    let mut all = Beyond::default();
    for part in &tree.body(body).parts {
        let one = own_part(tree, units, part);
        all.rows.extend(one.rows);
        all.mass += one.mass;
        all.turning = (all.turning * all.turning + one.turning * one.turning).sqrt();
    }
    all
}

fn own_part(tree: &Tree, units: &Units, part: &Part) -> Beyond {
    let mass = tree.nominal(part.mass) / units.mass;
    let center = part
        .mass_center
        .nominal(&tree.parameters)
        .map(|part| part / units.length);
    let tensor = part.inertia;
    let tensor = [
        tensor.xx, tensor.yy, tensor.zz, tensor.xy, tensor.xz, tensor.yz,
    ];
    let tensor = tensor.map(|value| tree.nominal(value) / units.mass / units.length / units.length);
    let mut rows = Vec::with_capacity(6);
    for axis in 0..3 {
        // Component `axis` of v + w x r, which is v + r . (axis x w).
        let mut unit = [0.0; 3];
        unit[axis] = mass.sqrt();
        let [wx, wy, wz] = cross(center, unit);
        rows.push([wx, wy, wz, unit[0], unit[1], unit[2]]);
    }
    let (moments, axes) = principal(tensor);
    let back = geometry::transposed(&part.axes);
    for (moment, axis) in moments.into_iter().zip(axes) {
        let [x, y, z] = geometry::apply(&back, axis);
        let root = moment.max(0.0).sqrt();
        rows.push([root * x, root * y, root * z, 0.0, 0.0, 0.0]);
    }
    let trace: f64 = moments.iter().map(|moment| moment.max(0.0)).sum();
    Beyond {
        rows,
        mass,
        turning: (trace + mass * dot(&center, &center)).sqrt(),
    }
}

/// A joint at a state: lengths in units.
pub(crate) struct Geometry {
    /// The twist of the body that a unit rate of each of the six motions gives it.
    pub(crate) columns: [Twist; 6],
    /// The twist of the body where that of the lower body is a unit: `carried[i]` for component `i`.
    pub(crate) carried: [Twist; 6],
    /// The distance between the two origins.
    pub(crate) lever: f64,
}

/// The joint of a body at a state; `value` gives angles in rad, and translations in units.
pub(crate) fn geometry(
    tree: &Tree,
    units: &Units,
    body: BodyId,
    mut value: impl FnMut(Coordinate, bool) -> f64,
) -> Geometry {
    let joint = &tree.body(body).joint;
    // Whatever describes an orientation, some angles lead to it.
    let angles = joint.angles().unwrap_or_else(|| {
        let [coordinates @ .., _] = joint.euler_parameters();
        let speed = SpeedId::new(0);
        coordinates.map(|coordinate| Coordinate::Free { coordinate, speed })
    });
    let angles = angles.map(|angle| value(angle, true));
    let shift = joint.translations.map(|shift| value(shift, false));
    let turned = geometry::body_fixed_123(angles);
    let whole = geometry::then(&joint.rotation, &turned);
    let [_, (s2, c2), (s3, c3)] = angles.map(|angle| (libm::sin(angle), libm::cos(angle)));
    // P_K by columns, Eq. (17).
    let turns = match joint.orientation {
        Orientation::Rates(_) => [[c2 * c3, -c2 * s3, s2], [s3, c3, 0.0], [0.0, 0.0, 1.0]],
        Orientation::AngularVelocity { .. } => geometry::IDENTITY,
    };
    let columns = std::array::from_fn(|motion| match motion {
        0..3 => join(turns[motion], [0.0; 3]),
        _ => join([0.0; 3], turned.map(|row| row[motion - 3])),
    });
    let attachment = joint.attachment.nominal(&tree.parameters);
    let shift = geometry::apply(&geometry::transposed(&joint.rotation), shift);
    let lever = std::array::from_fn(|i| attachment[i] / units.length + shift[i]);
    let mut carried = [[0.0; 6]; 6];
    for component in 0..3 {
        let mut unit = [0.0; 3];
        unit[component] = 1.0;
        let arm = geometry::apply(&whole, cross(unit, lever));
        let unit = geometry::apply(&whole, unit);
        carried[component] = join(unit, arm);
        carried[component + 3] = join([0.0; 3], unit);
    }
    Geometry {
        columns,
        carried,
        lever: dot(&lever, &lever).sqrt(),
    }
}

/// The joint of a body before elimination, and the distance between the two origins.
fn place(
    tree: &Tree,
    units: &Units,
    body: BodyId,
    here: &Beyond,
    random: &mut Random,
) -> (Joint, f64) {
    let geometry = geometry(tree, units, body, |coordinate, is_angle| {
        let (free, unit) = if is_angle {
            (3.0, 1.0)
        } else {
            (1.0, units.length)
        };
        match coordinate {
            Coordinate::Free { .. } => free * random.signed(),
            Coordinate::Mimic { offset, .. } => offset / unit,
            Coordinate::Locked(value) => value / unit,
        }
    });
    let joint = &tree.body(body).joint;
    let mut columns = Vec::new();
    let mut bounds = Vec::new();
    let mut rotors = Vec::new();
    let mut axes = Vec::new();
    for (motion, _) in joint.speeds() {
        let axis = Axis::ALL[motion];
        let bound = if axis.is_angle() {
            here.turning
        } else {
            here.mass.sqrt()
        };
        let rotor = rotor(tree, units, joint, motion);
        axes.push(axis);
        columns.push(geometry.columns[motion]);
        rotors.push(rotor.sqrt());
        bounds.push((bound * bound + rotor).sqrt());
    }
    let joint = Joint {
        axes,
        columns,
        bounds,
        rotors,
        carried: geometry.carried,
        pivots: vec![],
        upper: vec![],
        pulled: vec![],
        idle: vec![],
    };
    (joint, geometry.lever)
}

/// The inertia of a motion's rotor.
pub(crate) fn rotor(tree: &Tree, units: &Units, joint: &crate::tree::Joint, motion: usize) -> f64 {
    let armature = tree.nominal(joint.mechanics[motion].armature) / units.mass;
    if motion < 3 {
        armature / units.length / units.length
    } else {
        armature
    }
}

/// Finds the joint's pivots, and what of the rows is left for the lower body's twist.
fn eliminate(mut joint: Joint, rows: &[Twist]) -> (Joint, Vec<Twist>) {
    let on = |twist: &Twist| -> Vec<f64> { rows.iter().map(|row| dot(row, twist)).collect() };
    // Below the rows of what lies beyond, one for each rotor, which the lower body's twist does not move.
    let n_rows = rows.len() + joint.rotors.len();
    let mut columns: Vec<Vec<f64>> = joint
        .columns
        .iter()
        .enumerate()
        .map(|(place, column)| {
            let bound = joint.bounds[place];
            let scale = if bound > 0.0 { 1.0 / bound } else { 0.0 };
            let mut column = on(column);
            column.resize(n_rows, 0.0);
            column[rows.len() + place] = joint.rotors[place];
            column.into_iter().map(|entry| entry * scale).collect()
        })
        .collect();
    let mut lower: Vec<Vec<f64>> = joint
        .carried
        .iter()
        .map(|twist| {
            let mut column = on(twist);
            column.resize(n_rows, 0.0);
            column
        })
        .collect();
    joint.idle = (0..columns.len()).collect();
    let norm = |column: &[f64]| dot(column, column).sqrt();
    while let Some(at) = (0..joint.idle.len())
        .max_by(|a, b| norm(&columns[joint.idle[*a]]).total_cmp(&norm(&columns[joint.idle[*b]])))
    {
        let length = norm(&columns[joint.idle[at]]);
        if length <= IDLE {
            break;
        }
        let pivot = joint.idle.remove(at);
        let unit: Vec<f64> = columns[pivot].iter().map(|entry| entry / length).collect();
        let mut upper = vec![0.0; columns.len()];
        upper[pivot] = length;
        for other in &joint.idle {
            upper[*other] = project_out(&mut columns[*other], &unit);
        }
        let mut pulled = [0.0; 6];
        for (component, column) in pulled.iter_mut().zip(&mut lower) {
            *component = project_out(column, &unit);
        }
        joint.pivots.push(pivot);
        joint.upper.push(upper);
        joint.pulled.push(pulled);
    }
    let passed = (0..n_rows)
        .map(|row| std::array::from_fn(|component| lower[component][row]))
        .collect();
    (joint, passed)
}

/// The coordinates that move when the idle coordinate at place `idle` does, each with a share worth naming.
pub(crate) fn moved_along(
    tree: &Tree,
    joints: &[Joint],
    body: BodyId,
    idle: usize,
) -> Vec<(BodyId, Axis)> {
    let joint = &joints[body.index()];
    let idle = joint.idle[idle];
    // Its column by itself, which the pivots' columns then cancel; in units of bounds.
    let sides = joint.upper.iter().map(|upper| upper[idle]);
    let mut rates = respond(joint, sides.collect());
    rates[idle] = 1.0;
    let mut shares = Vec::new();
    let mut twists: Vec<Option<Twist>> = vec![None; joints.len()];
    for other in tree.body_ids().skip(body.index()) {
        let joint = &joints[other.index()];
        let carried = if other == body {
            [0.0; 6]
        } else {
            let Some(lower) = tree.lower(other).and_then(|lower| twists[lower.index()]) else {
                continue;
            };
            rates = respond(
                joint,
                joint
                    .pulled
                    .iter()
                    .map(|pulled| dot(pulled, &lower))
                    .collect(),
            );
            std::array::from_fn(|row| {
                (0..6)
                    .map(|component| joint.carried[component][row] * lower[component])
                    .sum()
            })
        };
        let mut twist = carried;
        for (place, rate) in rates.iter().enumerate() {
            // A rate in units of its bound; where the bound is zero the coordinate is idle by itself.
            let bound = if joint.bounds[place] > 0.0 {
                joint.bounds[place]
            } else {
                1.0
            };
            twist
                .iter_mut()
                .zip(&joint.columns[place])
                .for_each(|(entry, column)| *entry += column * rate / bound);
            shares.push((other, joint.axes[place], rate.abs()));
        }
        twists[other.index()] = Some(twist);
    }
    let most = shares
        .iter()
        .fold(0.0, |most: f64, share| most.max(share.2));
    shares
        .into_iter()
        .filter(|share| share.2 > SHARE * most)
        .map(|(body, axis, _)| (body, axis))
        .collect()
}

/// The rates of the pivots, in units of their bounds, that cancel these components along Q; the others stand still.
fn respond(joint: &Joint, mut sides: Vec<f64>) -> Vec<f64> {
    let mut rates = vec![0.0; joint.axes.len()];
    for row in (0..joint.pivots.len()).rev() {
        let pivot = joint.pivots[row];
        rates[pivot] = -sides[row] / joint.upper[row][pivot];
        for (side, upper) in sides.iter_mut().zip(&joint.upper).take(row) {
            *side += upper[pivot] * rates[pivot];
        }
    }
    rates
}
