//! The outward way back: which coordinates move together with an idle one, so that all in all no mass moves.

use crate::description::CoordinateName;
use crate::id::BodyId;
use crate::tree::mobility::rows::{Twist, dot};
use crate::tree::mobility::sweep::{SHARE, SweptJoint};
use crate::tree::system::Tree;

/// The coordinates that move when the idle coordinate at place `idle` does, each with a share worth naming.
pub(crate) fn moved_along(
    tree: &Tree,
    joints: &[SweptJoint],
    body: BodyId,
    idle: usize,
) -> Vec<(BodyId, CoordinateName)> {
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
                    .map(|component| joint.free.carried[component][row] * lower[component])
                    .sum()
            })
        };
        let mut twist = carried;
        for (place, rate) in rates.iter().enumerate() {
            // A rate in units of its bound; where the bound is zero the coordinate is idle by itself.
            let bound = if joint.free.bounds[place] > 0.0 {
                joint.free.bounds[place]
            } else {
                1.0
            };
            twist
                .iter_mut()
                .zip(&joint.free.columns[place])
                .for_each(|(entry, column)| *entry += column * rate / bound);
            shares.push((other, joint.free.coordinates[place], rate.abs()));
        }
        twists[other.index()] = Some(twist);
    }
    let most = shares
        .iter()
        .fold(0.0, |most: f64, share| most.max(share.2));
    shares
        .into_iter()
        .filter(|share| share.2 > SHARE * most)
        .map(|(body, coordinate, _)| (body, coordinate))
        .collect()
}

/// The rates of the pivots, in units of their bounds, that cancel these components along Q; the others stand still.
fn respond(joint: &SweptJoint, mut sides: Vec<f64>) -> Vec<f64> {
    let mut rates = vec![0.0; joint.free.coordinates.len()];
    for row in (0..joint.pivots.len()).rev() {
        let pivot = joint.pivots[row];
        rates[pivot] = -sides[row] / joint.upper[row][pivot];
        for (side, upper) in sides.iter_mut().zip(&joint.upper).take(row) {
            *side += upper[pivot] * rates[pivot];
        }
    }
    rates
}
