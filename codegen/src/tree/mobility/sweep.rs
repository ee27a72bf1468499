//! The inward sweep: joint by joint from the tips, which of its free motions move mass.

use crate::description::CoordinateName;
use crate::id::BodyId;
use crate::random::Random;
use crate::tree::joint::Coordinate;
use crate::tree::mobility::kinematics::{kinematics, rotor};
use crate::tree::mobility::masses::{Masses, own};
use crate::tree::mobility::rows::{Twist, dot, project_out, triangle};
use crate::tree::mobility::units::Units;
use crate::tree::system::Tree;

/// Part of what a column could move at most, below which it moves nothing.
pub(crate) const IDLE: f64 = 1e-10;
/// Part of a motion's largest share, below which a coordinate has no share.
pub(crate) const SHARE: f64 = 1e-6;

/// The free motions of the joint of a body at a state.
pub(super) struct FreeMotions {
    /// Which they are.
    pub(super) coordinates: Vec<CoordinateName>,
    /// For each the twist that its unit rate gives the body.
    pub(super) columns: Vec<Twist>,
    /// For each the root of twice the energy of what turns or shifts with its unit rate alone: a rotor.
    pub(super) rotors: Vec<f64>,
    /// For each the most that its unit rate could move: root of twice the energy.
    pub(super) bounds: Vec<f64>,
    /// The twist of the body where that of the lower body is a unit: `carried[i]` for component `i`.
    pub(super) carried: [Twist; 6],
}

/// What the inward sweep found at the joint of a body.
pub(super) struct SweptJoint {
    /// Its free motions.
    pub(super) free: FreeMotions,
    /// Places among the free motions of the pivots, in their order.
    pub(super) pivots: Vec<usize>,
    /// Qᵀ B, pivot by pivot: `upper[i][c]` for the motion at place `c`, in units of its bound.
    pub(super) upper: Vec<Vec<f64>>,
    /// Qᵀ K, pivot by pivot, on the lower body's twist.
    pub(super) pulled: Vec<Twist>,
    /// Places among the free motions of those without pivot: they move no mass.
    pub(super) idle: Vec<usize>,
}

/// All joints at a state that `random` chooses, from the tips inward.
pub(crate) fn inward(tree: &Tree, units: &Units, random: &mut Random) -> Vec<SweptJoint> {
    let mut beyond: Vec<Masses> = tree.body_ids().map(|body| own(tree, units, body)).collect();
    let mut joints: Vec<SweptJoint> = Vec::with_capacity(beyond.len());
    for body in tree.body_ids().rev() {
        let here = std::mem::take(&mut beyond[body.index()]);
        let (free, lever) = place(tree, units, body, &here, random);
        let (joint, passed) = eliminate(free, &here.rows);
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

/// The free motions of the joint of a body, and the distance between the two origins.
fn place(
    tree: &Tree,
    units: &Units,
    body: BodyId,
    here: &Masses,
    random: &mut Random,
) -> (FreeMotions, f64) {
    let kinematics = kinematics(tree, units, body, |coordinate, is_angle| {
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
    let mut coordinates = Vec::new();
    for (motion, _) in joint.speeds() {
        let coordinate = CoordinateName::ALL[motion];
        let bound = if coordinate.is_angle() {
            here.turning
        } else {
            here.mass.sqrt()
        };
        let rotor = rotor(tree, units, joint, motion);
        coordinates.push(coordinate);
        columns.push(kinematics.columns[motion]);
        rotors.push(rotor.sqrt());
        bounds.push((bound * bound + rotor).sqrt());
    }
    let free = FreeMotions {
        coordinates,
        columns,
        rotors,
        bounds,
        carried: kinematics.carried,
    };
    (free, kinematics.lever)
}

/// Finds the joint's pivots, and what of the rows is left for the lower body's twist.
fn eliminate(free: FreeMotions, rows: &[Twist]) -> (SweptJoint, Vec<Twist>) {
    let n_rows = rows.len() + free.rotors.len();
    let mut columns = scaled_columns(&free, rows, n_rows);
    let mut lower = free.carried.map(|twist| {
        let mut column = on(rows, &twist);
        column.resize(n_rows, 0.0);
        column
    });
    let mut idle: Vec<usize> = (0..columns.len()).collect();
    let (mut pivots, mut upper, mut pulled) = (Vec::new(), Vec::new(), Vec::new());
    let norm = |column: &[f64]| dot(column, column).sqrt();
    while let Some(at) =
        (0..idle.len()).max_by(|a, b| norm(&columns[idle[*a]]).total_cmp(&norm(&columns[idle[*b]])))
    {
        let length = norm(&columns[idle[at]]);
        if length <= IDLE {
            break;
        }
        let pivot = idle.remove(at);
        let unit: Vec<f64> = columns[pivot].iter().map(|entry| entry / length).collect();
        let mut row = vec![0.0; columns.len()];
        row[pivot] = length;
        for other in &idle {
            row[*other] = project_out(&mut columns[*other], &unit);
        }
        let mut pull = [0.0; 6];
        for (component, column) in pull.iter_mut().zip(&mut lower) {
            *component = project_out(column, &unit);
        }
        pivots.push(pivot);
        upper.push(row);
        pulled.push(pull);
    }
    let swept = SweptJoint {
        free,
        pivots,
        upper,
        pulled,
        idle,
    };
    let passed = (0..n_rows)
        .map(|row| std::array::from_fn(|component| lower[component][row]))
        .collect();
    (swept, passed)
}

/// What the rows make of a twist.
fn on(rows: &[Twist], twist: &Twist) -> Vec<f64> {
    rows.iter().map(|row| dot(row, twist)).collect()
}

/// What the rows make of each free motion, in units of its bound. Below the rows of what lies beyond stands one for each
/// rotor, which the lower body's twist does not move.
fn scaled_columns(free: &FreeMotions, rows: &[Twist], n_rows: usize) -> Vec<Vec<f64>> {
    let columns = free.columns.iter().enumerate();
    let columns = columns.map(|(place, column)| {
        let bound = free.bounds[place];
        let scale = if bound > 0.0 { 1.0 / bound } else { 0.0 };
        let mut column = on(rows, column);
        column.resize(n_rows, 0.0);
        column[rows.len() + place] = free.rotors[place];
        column.into_iter().map(|entry| entry * scale).collect()
    });
    columns.collect()
}
