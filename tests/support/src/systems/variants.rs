//! The same motions, described otherwise: what two descriptions of one system must agree on needs no reference.

use super::{
    body::{Body, Kind, Number, Quantity},
    system::RandomSystem,
};
use crate::{
    random::Random,
    rotation::{
        self, IDENTITY, Rotation, Vector, angles_123, dot, product, scaled, sum, times, transposed,
    },
};

/// A frame fixed in a body, or in the inertial frame.
#[derive(Clone, Copy)]
struct Fixed {
    host: Option<usize>,
    rotation: Rotation,
    /// The host's axes.
    origin: Vector,
}

impl RandomSystem {
    /// The same with nothing acting in joints that turn in every direction: what acts there depends on their charts.
    #[must_use]
    pub fn with_free_balls(&self) -> Self {
        self.with_bodies(|body| {
            if body.joint.kind.is_ball() {
                body.joint.mechanics = [Quantity::Absent; 4];
            }
        })
    }

    /// The same, every orientation that is free in every direction described so.
    #[must_use]
    pub fn in_chart(&self, chart: &'static str, speeds: &'static str) -> Self {
        self.with_bodies(|body| {
            let joint = &mut body.joint;
            if joint.kind.is_ball() {
                (joint.chart, joint.speeds) = (Some(chart), Some(speeds));
            }
        })
    }

    /// The same, no follower held by a multiple of zero.
    #[must_use]
    pub fn with_moving_followers(&self) -> Self {
        self.with_bodies(|body| {
            if let Some(mimic) = body
                .joint
                .mimic
                .as_mut()
                .filter(|mimic| mimic.multiplier == 0.0)
            {
                mimic.multiplier = 0.7;
            }
        })
    }

    /// The same tree, nothing lifting anything.
    #[must_use]
    pub fn unlifted(&self) -> Self {
        self.with_bodies(|body| body.lifted = None)
    }

    /// The same tree, nothing following anything.
    #[must_use]
    pub fn without_followers(&self) -> Self {
        self.with_bodies(|body| body.joint.mimic = None)
    }

    /// True where a body has no joint to move in.
    pub fn has_fixed(&self) -> bool {
        self.bodies.iter().any(|body| body.joint.is_fixed())
    }

    /// The same motions with the frames on both sides of joints turned, the one as the other: joints along axes keep their
    /// coordinates, those of joints that turn in every direction turn with the frames. Each joint's turn, if it has one.
    pub fn turned(&self, seed: u64) -> (Self, Vec<Option<Rotation>>) {
        let mut random = Random::new(seed);
        let mut turns = Vec::new();
        let turned = self.with_bodies(|body| {
            let joint = &mut body.joint;
            let turn = rotation::any(&mut random);
            let free = joint.kind.free();
            let is_turned = match &mut joint.kind {
                Kind::Along("planar", _) => false,
                Kind::Along(_, axis) => {
                    *axis = times(&turn, *axis);
                    true
                }
                kind => {
                    let shifts = [[true; 3], [false; 3]];
                    kind.is_ball() && joint.speeds != Some("rates") && {
                        let shifts = shifts.iter().any(|shifts| free[3..] == *shifts);
                        shifts && (joint.chart == Some("quaternion") || joint.speeds.is_some())
                    }
                }
            };
            turns.push(is_turned.then_some(turn));
            if is_turned {
                let [_, _, _, x, y, z] = joint.locked;
                joint.locked[3..].copy_from_slice(&times(&turn, [x, y, z]));
                let to_joint = joint.attachment_rotation.unwrap_or(IDENTITY);
                joint.attachment_rotation = Some(product(&turn, &to_joint));
                let to_body = joint.body_rotation.unwrap_or(IDENTITY);
                joint.body_rotation = Some(product(&to_body, &transposed(&turn)));
            }
        });
        (turned, turns)
    }

    /// The same without the bodies that are fixed, whose masses and joints are those of what they are fixed to: by hand, and
    /// without runtime values.
    #[must_use]
    pub fn merged(&self) -> Self {
        let mut frames: Vec<Fixed> = Vec::new();
        let mut bodies = self.with_runtime(false).bodies;
        for place in 0..bodies.len() {
            let body = &mut bodies[place];
            if let Some(lower) = body.lower.map(|lower| frames[lower]) {
                let joint = &mut body.joint;
                let step = times(&transposed(&lower.rotation), values(&joint.attachment));
                joint.attachment = sum(lower.origin, step).map(Number::baked);
                let to_joint = joint.attachment_rotation.unwrap_or(IDENTITY);
                joint.attachment_rotation = Some(product(&to_joint, &lower.rotation));
                body.lower = lower.host;
            }
            let body = bodies[place].clone();
            if !body.joint.is_fixed() {
                frames.push(Fixed {
                    host: Some(place),
                    rotation: IDENTITY,
                    origin: [0.0; 3],
                });
                continue;
            }
            let frame = fixed(&body);
            if let Some(host) = frame.host {
                add(&mut bodies[host], &body, &frame);
            }
            frames.push(frame);
        }
        self.without_fixed(&bodies)
    }

    /// The system of those bodies of a list as long as its own that have a joint.
    fn without_fixed(&self, bodies: &[Body]) -> Self {
        let is_kept: Vec<bool> = bodies.iter().map(|body| !body.joint.is_fixed()).collect();
        let kept_before = |place: usize| is_kept[..place].iter().filter(|kept| **kept).count();
        let place_in_file = |place: usize| {
            let earlier =
                (0..bodies.len()).filter(|&other| self.places[other] < self.places[place]);
            earlier.filter(|&other| is_kept[other]).count()
        };
        let kept = || (0..is_kept.len()).filter(|&place| is_kept[place]);
        let mut merged = Self {
            places: kept().map(place_in_file).collect(),
            bodies: kept().map(|place| bodies[place].clone()).collect(),
            ..self.clone()
        };
        for body in &mut merged.bodies {
            body.lower = body.lower.map(kept_before);
            if let Some(mimic) = &mut body.joint.mimic {
                mimic.leader = kept_before(mimic.leader);
            }
        }
        // Gravity is no part of a body.
        merged.gravity = merged.gravity.map(|number| Number::baked(number.value));
        merged
    }

    fn with_bodies(&self, change: impl FnMut(&mut Body)) -> Self {
        let mut changed = self.clone();
        changed.bodies.iter_mut().for_each(change);
        changed
    }
}

fn values(numbers: &[Number; 3]) -> Vector {
    numbers.map(|number| number.value)
}

/// The frame of a body whose joint holds it.
fn fixed(body: &Body) -> Fixed {
    let joint = &body.joint;
    let to_joint = joint.attachment_rotation.unwrap_or(IDENTITY);
    let to_body = joint.body_rotation.unwrap_or(IDENTITY);
    let [a, b, c, x, y, z] = joint.locked;
    let rotation = product(&to_body, &product(&angles_123([a, b, c]), &to_joint));
    let out = sum(
        values(&joint.attachment),
        times(&transposed(&to_joint), [x, y, z]),
    );
    let back = joint.body_attachment.as_ref().map_or([0.0; 3], values);
    Fixed {
        host: body.lower,
        rotation,
        origin: sum(out, times(&transposed(&rotation), scaled(-1.0, back))),
    }
}

/// Adds the mass and inertia of a body in a frame of the other.
fn add(body: &mut Body, added: &Body, frame: &Fixed) {
    let back = transposed(&frame.rotation);
    let masses = [body.mass.value, added.mass.value];
    let centers = [
        values(&body.mass_center),
        sum(frame.origin, times(&back, values(&added.mass_center))),
    ];
    let mass = masses[0] + masses[1];
    let mut center = centers[0];
    if mass > 0.0 {
        let moment = sum(scaled(masses[0], centers[0]), scaled(masses[1], centers[1]));
        center = scaled(1.0 / mass, moment);
    }
    let tensors = [tensor(body, &IDENTITY), tensor(added, &frame.rotation)];
    let mut whole = [[0.0; 3]; 3];
    for ((mass, own_center), tensor) in masses.into_iter().zip(centers).zip(tensors) {
        let d = sum(own_center, scaled(-1.0, center));
        for i in 0..3 {
            for j in 0..3 {
                let around = if i == j { dot(d, d) } else { 0.0 };
                whole[i][j] += tensor[i][j] + mass * (around - d[i] * d[j]);
            }
        }
    }
    body.mass = Number::baked(mass);
    body.mass_center = center.map(Number::baked);
    let places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
    body.inertia = places.map(|(i, j)| Number::baked(whole[i][j]));
    body.inertia_rotation = None;
}

/// The inertia of a body about its mass centre, in axes from which a rotation leads to its own.
fn tensor(body: &Body, rotation: &Rotation) -> Rotation {
    let [xx, yy, zz, xy, xz, yz] = body.inertia.map(|number| number.value);
    let own = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let to_own = product(&body.inertia_rotation.unwrap_or(IDENTITY), rotation);
    product(&transposed(&to_own), &product(&own, &to_own))
}
