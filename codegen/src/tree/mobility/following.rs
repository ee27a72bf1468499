//! Whether every coordinate moves mass where some follow others: what one speed moves is then all over the tree, and no
//! sweep from joint to joint can tell. Here all velocities are written down, speed by speed, and projected out one after
//! another: cubic in the speeds, which are few in such trees.

use std::collections::BTreeMap;

use crate::description::CoordinateName;
use crate::id::{BodyId, SpeedId};
use crate::random::Random;
use crate::tree::mobility::kinematics::{Kinematics, kinematics, rotor};
use crate::tree::mobility::masses::{debts, own};
use crate::tree::mobility::rows::{Twist, dot, project_out};
use crate::tree::mobility::sweep::{IDLE, SHARE};
use crate::tree::mobility::units::Units;
use crate::tree::{Coordinate, Tree};

/// The motions that move no mass at a state that `random` chooses: for each the coordinates that take part.
pub(crate) fn idle(
    tree: &Tree,
    units: &Units,
    random: &mut Random,
) -> Vec<Vec<(BodyId, CoordinateName)>> {
    let q = state(tree, units, random);
    let Velocities { columns, bounds } = velocities(tree, units, &q, Weighed::Masses);
    let mut columns: Vec<Vec<f64>> = columns
        .into_iter()
        .zip(&bounds)
        .map(|(column, bound)| {
            let scale = if *bound > 0.0 { 1.0 / bound } else { 0.0 };
            column.into_iter().map(|entry| entry * scale).collect()
        })
        .collect();
    let norm = |column: &[f64]| dot(column, column).sqrt();
    let mut open: Vec<usize> = (0..columns.len()).collect();
    let mut pivots: Vec<usize> = Vec::new();
    let mut upper: Vec<Vec<f64>> = Vec::new();
    while let Some(place) =
        (0..open.len()).max_by(|a, b| norm(&columns[open[*a]]).total_cmp(&norm(&columns[open[*b]])))
    {
        let length = norm(&columns[open[place]]);
        if length <= IDLE {
            break;
        }
        let pivot = open.remove(place);
        let unit: Vec<f64> = columns[pivot].iter().map(|entry| entry / length).collect();
        let mut row = vec![0.0; columns.len()];
        row[pivot] = length;
        for other in &open {
            row[*other] = project_out(&mut columns[*other], &unit);
        }
        pivots.push(pivot);
        upper.push(row);
    }
    let places = places(tree);
    open.iter()
        .map(|&idle| {
            let shares = shares(idle, &pivots, &upper);
            let most = shares
                .values()
                .fold(0.0, |most: f64, share| most.max(share.abs()));
            let taking_part = shares
                .iter()
                .filter(|(_, share)| share.abs() > SHARE * most);
            taking_part.map(|(speed, _)| places[*speed]).collect()
        })
        .collect()
}

/// The rates, in units of their bounds, with which pivots cancel what an idle speed moves; its own is one.
fn shares(idle: usize, pivots: &[usize], upper: &[Vec<f64>]) -> BTreeMap<usize, f64> {
    let mut sides: Vec<f64> = upper.iter().map(|row| row[idle]).collect();
    let mut shares = BTreeMap::from([(idle, 1.0)]);
    for row in (0..pivots.len()).rev() {
        let pivot = pivots[row];
        let rate = -sides[row] / upper[row][pivot];
        shares.insert(pivot, rate);
        for (side, upper) in sides.iter_mut().zip(upper).take(row) {
            *side += upper[pivot] * rate;
        }
    }
    shares
}

/// The joint and the motion of each speed.
pub(super) fn places(tree: &Tree) -> Vec<(BodyId, CoordinateName)> {
    let mut places = vec![(BodyId::new(0), CoordinateName::Theta1); tree.n_speeds];
    for body in tree.body_ids() {
        for (motion, speed) in tree.body(body).joint.speeds() {
            places[speed.index()] = (body, CoordinateName::ALL[motion]);
        }
    }
    places
}

/// What is weighed of what moves.
#[derive(Clone, Copy)]
pub(super) enum Weighed {
    /// Masses, principal moments above zero, and rotors.
    Masses,
    /// Principal moments below zero.
    Debts,
}

/// For each speed what its unit moves, root of mass times velocity, and the most that it could be.
pub(super) struct Velocities {
    pub(super) columns: Vec<Vec<f64>>,
    bounds: Vec<f64>,
}

/// What a unit of one speed gives a body: its twist, and what the parts of that could add up to, turning and shifting.
#[derive(Clone, Copy, Default)]
struct Moved {
    twist: Twist,
    turning: f64,
    shifting: f64,
}

/// Coordinates that `random` chooses: angles all around, translations of the tree's size.
pub(super) fn state(tree: &Tree, units: &Units, random: &mut Random) -> Vec<f64> {
    let mut q = vec![0.0; tree.n_coordinates];
    for body in &tree.bodies {
        for (kind, place) in body.joint.coordinates() {
            let size = if kind.is_translation() {
                units.length
            } else {
                3.0
            };
            q[place.index()] = size * random.signed();
        }
    }
    q
}

/// What each speed moves in this state, of what `weighed` says.
pub(super) fn velocities(tree: &Tree, units: &Units, q: &[f64], weighed: Weighed) -> Velocities {
    let mut columns = vec![Vec::new(); tree.n_speeds];
    let mut bounds = vec![0.0; tree.n_speeds];
    let mut n_rows = 0;
    let mut moved: Vec<BTreeMap<SpeedId, Moved>> = Vec::with_capacity(tree.bodies.len());
    for body in tree.body_ids() {
        let joint = &tree.body(body).joint;
        let kinematics = kinematics(tree, units, body, |coordinate, is_angle| {
            let unit = if is_angle { 1.0 } else { units.length };
            let value = match coordinate {
                Coordinate::Free { coordinate, .. } => q[coordinate.index()],
                Coordinate::Mimic {
                    coordinate,
                    multiplier,
                    offset,
                    ..
                } => multiplier * q[coordinate.index()] + offset,
                Coordinate::Locked(value) => value,
            };
            value / unit
        });
        let lower = tree.lower(body).map(|lower| &moved[lower.index()]);
        let mut here = carried(&kinematics, lower);
        for (motion, speed) in joint.motions().into_iter().enumerate() {
            let Some(speed_of) = speed else { continue };
            let unit = if motion < 3 { 1.0 } else { units.length };
            let rate = speed_of.factor / unit;
            let entry = here.entry(speed_of.speed).or_default();
            for (entry, column) in entry.twist.iter_mut().zip(kinematics.columns[motion]) {
                *entry += rate * column;
            }
            let size = dot(&kinematics.columns[motion], &kinematics.columns[motion]).sqrt();
            if motion < 3 {
                entry.turning += (rate * size).abs();
            } else {
                entry.shifting += (rate * size).abs();
            }
            let rotor = match weighed {
                Weighed::Masses => rotor(tree, units, joint, motion).sqrt() * rate,
                Weighed::Debts => 0.0,
            };
            let column = &mut columns[speed_of.speed.index()];
            column.resize(n_rows, 0.0);
            column.push(rotor);
            n_rows += 1;
            bounds[speed_of.speed.index()] += rotor * rotor;
        }
        let rows = match weighed {
            Weighed::Masses => own(tree, units, body).rows,
            Weighed::Debts => debts(tree, units, body),
        };
        for row in rows {
            let [wx, wy, wz, vx, vy, vz] = row;
            let (turning, shifting) = (
                dot(&[wx, wy, wz], &[wx, wy, wz]).sqrt(),
                dot(&[vx, vy, vz], &[vx, vy, vz]).sqrt(),
            );
            for (speed, moved) in &here {
                let column = &mut columns[speed.index()];
                column.resize(n_rows, 0.0);
                column.push(dot(&row, &moved.twist));
                let bound = turning * moved.turning + shifting * moved.shifting;
                bounds[speed.index()] += bound * bound;
            }
            n_rows += 1;
        }
        moved.push(here);
    }
    for column in &mut columns {
        column.resize(n_rows, 0.0);
    }
    Velocities {
        columns,
        bounds: bounds.into_iter().map(f64::sqrt).collect(),
    }
}

/// What the lower body's motion gives the body.
fn carried(
    kinematics: &Kinematics,
    lower: Option<&BTreeMap<SpeedId, Moved>>,
) -> BTreeMap<SpeedId, Moved> {
    let carry = |(speed, moved): (&SpeedId, &Moved)| {
        let twist = std::array::from_fn(|row| {
            (0..6)
                .map(|component| kinematics.carried[component][row] * moved.twist[component])
                .sum()
        });
        let moved = Moved {
            twist,
            turning: moved.turning,
            shifting: moved.shifting + kinematics.lever * moved.turning,
        };
        (*speed, moved)
    };
    lower.into_iter().flatten().map(carry).collect()
}
