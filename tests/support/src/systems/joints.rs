//! Joints of every kind, between frames of every kind, in place of lists of free coordinates.

use super::body::{Body, Joint, Kind, Mimic, Number, Quantity};
use crate::{
    random::Random,
    rotation::{self, Rotation},
};

/// Changes most joints; no more than `most` speeds are left.
pub(super) fn frame(bodies: &mut [Body], random: &mut Random, most: usize) {
    let mut n_speeds = 0;
    for body in bodies.iter_mut() {
        if random.chance(0.4) {
            body.inertia_rotation = Some(frame_rotation(random));
        }
        let is_root = body.lower.is_none();
        let joint = &mut body.joint;
        joint.kind = kind(random, joint.kind, is_root);
        if n_speeds + joint.kind.n_motions() > most {
            joint.kind = Kind::Named("fixed");
        }
        n_speeds += joint.kind.n_motions();
        joint.has_name = random.chance(0.3);
        if random.chance(0.6) {
            joint.attachment_rotation = Some(frame_rotation(random));
        }
        if random.chance(0.6) {
            joint.body_rotation = Some(frame_rotation(random));
        }
        if random.chance(0.5) {
            let zero = random.chance(0.2);
            joint.body_attachment = Some([0; 3].map(|_| {
                let written = random.written(-0.5, 0.5);
                Number::baked(if zero { 0.0 } else { written })
            }));
        }
        if joint.kind.is_ball() {
            (joint.chart, joint.speeds) = [
                (None, None),
                (Some("angles"), Some("rates")),
                (None, Some("angular_velocity")),
                (Some("quaternion"), None),
                (Some("quaternion"), Some("angular_velocity")),
            ][random.below(5)];
        }
        if !joint.is_fixed() {
            mechanics(random, joint, is_root);
        }
    }
    mimics(bodies, random);
}

fn frame_rotation(random: &mut Random) -> Rotation {
    if random.chance(0.4) {
        rotation::quarters(random)
    } else {
        rotation::any(random)
    }
}

fn kind(random: &mut Random, plain: Kind, is_root: bool) -> Kind {
    let axis = axis(random);
    let draw = random.between(0.0, 1.0);
    let limits = if is_root {
        [0.08, 0.12, 0.2, 0.26, 0.3, 0.34, 0.38, 0.42, 0.5, 0.85]
    } else {
        [0.07, 0.14, 0.36, 0.46, 0.52, 0.58, 0.63, 0.7, 0.8, 0.85]
    };
    let kinds = [
        Kind::Named("fixed"),
        Kind::List([false; 6]),
        Kind::Along("revolute", axis),
        Kind::Along("prismatic", axis),
        Kind::Along("continuous", axis),
        Kind::Along("cylindrical", axis),
        Kind::Along("planar", axis),
        Kind::Named("universal"),
        Kind::Named("spherical"),
        Kind::Named("free"),
    ];
    let mut choices = kinds.into_iter().zip(limits);
    choices
        .find(|(_, limit)| draw < *limit)
        .map_or(plain, |(kind, _)| kind)
}

/// Along a coordinate axis or against it, or skew; of any length.
fn axis(random: &mut Random) -> [f64; 3] {
    let mut axis = [0.0; 3];
    let place = random.below(3);
    axis[place] = [1.0, -1.0, 2.5][random.below(3)];
    let digits = [0; 3].map(|_| random.written(-1.0, 1.0));
    let any = [0; 3].map(|_| random.symmetric());
    match random.below(4) {
        0 if digits != [0.0; 3] => digits,
        1 => any,
        _ => axis,
    }
}

fn mechanics(random: &mut Random, joint: &mut Joint, is_root: bool) {
    let free = joint.kind.free();
    let has_angular_velocity = joint.kind.is_ball() && joint.has_angular_velocity();
    // Stiffness, rest, damping, armature: what a tree floats on is no part of it, so roots often have none of it.
    for (quantity, most) in [20.0, 0.5, 2.0, 0.3].into_iter().enumerate() {
        let chance = if is_root { 0.15 } else { 0.35 };
        if !random.chance(chance) {
            continue;
        }
        let number = |random: &mut Random| Number::baked(random.written(0.1 * most, most));
        let is_spring = quantity < 2;
        let each = free != [false; 6] && random.chance(0.5);
        joint.mechanics[quantity] = if each || (has_angular_velocity && is_spring) {
            let one = number(random);
            let mut numbers = free.map(|free| {
                let number = number(random);
                (free && random.chance(0.7)).then_some(number)
            });
            if has_angular_velocity && is_spring {
                numbers[..3].fill(None);
            } else if has_angular_velocity && quantity == 3 && numbers[..3] != [None; 3] {
                // Of a rotor that turns in every direction.
                numbers[..3].fill(Some(one));
            }
            if numbers == [None; 6] {
                Quantity::Absent
            } else {
                Quantity::Each(numbers)
            }
        } else {
            Quantity::Same(number(random))
        };
    }
}

/// Joints with one coordinate that follow others, in chains; leaders stand anywhere.
fn mimics(bodies: &mut [Body], random: &mut Random) {
    let order: Vec<usize> = random
        .order(bodies.len())
        .into_iter()
        .filter(|&body| bodies[body].joint.kind.n_motions() == 1)
        .collect();
    for (place, &body) in order.iter().enumerate().skip(1) {
        if random.chance(0.35) {
            let leader = order[random.below(place)];
            // One that follows at a multiple of zero is held.
            let sign = match random.between(0.0, 1.0) {
                draw if draw < 0.05 => 0.0,
                draw if draw < 0.5 => -1.0,
                _ => 1.0,
            };
            bodies[body].joint.mimic = Some(Mimic {
                leader,
                multiplier: sign * random.written(0.3, 1.5),
                offset: random.written(-0.5, 0.5),
            });
        }
    }
}
