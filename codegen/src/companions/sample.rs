//! States at which functions are tested: each term of the equations has a part in what comes out, whatever a model's masses and
//! lengths are.

use std::collections::BTreeMap;

use crate::{
    emit::Sample,
    expr::Input,
    functions::{Formulation, Function, Request},
    id::{BodyId, CoordinateId, ParameterId, SpeedId},
    number::Rounded,
    recursive::Plan,
    tree::{Chart, Orientation, Tree},
};

/// All that the equations are given in a state.
pub(super) type Inputs = BTreeMap<Input, Rounded>;

/// Powers of ten, each as exact as it is written.
const POWERS: [f64; 25] = [
    1e12, 1e11, 1e10, 1e9, 1e8, 1e7, 1e6, 1e5, 1e4, 1e3, 1e2, 1e1, 1.0, 1e-1, 1e-2, 1e-3, 1e-4,
    1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12,
];

/// A state in which nothing is zero, equal, or singular.
pub(super) fn draw(tree: &Tree, parameters: Vec<f64>, seed: u64) -> Sample {
    let mut random = Random::new(seed);
    let mut numbers = |count: usize| (0..count).map(|_| random.number()).collect::<Vec<f64>>();
    let (n_bodies, n_speeds) = (tree.bodies.len(), tree.n_speeds);
    let mut sample = Sample {
        parameters,
        q: numbers(tree.n_coordinates),
        u: numbers(n_speeds),
        u_dot: numbers(n_speeds),
        tau: vec![0.0; n_speeds],
        loads: numbers(6 * n_bodies),
        w_rel: numbers(3 * n_bodies),
    };
    let factors = numbers(n_speeds);
    normalize(tree, &mut sample.q);
    let length = length(tree, &sample);
    scale(tree, &mut sample, length);
    // Forces that would be nothing beside those of the motion, or everything, would show nothing of one of them.
    let forces = evaluated(tree, "inverse_dynamics", &sample);
    let pairs = forces.iter().zip(factors);
    sample.tau = pairs.map(|(force, factor)| factor * force).collect();
    sample
}

fn normalize(tree: &Tree, q: &mut [f64]) {
    for body in &tree.bodies {
        if let Orientation::AngularVelocity {
            chart: Chart::EulerParameters(parameters),
            ..
        } = body.joint.orientation
        {
            let places = parameters.map(CoordinateId::index);
            let square: f64 = places.iter().map(|&place| q[place] * q[place]).sum();
            for place in places {
                q[place] /= libm::sqrt(square);
            }
        }
    }
}

/// The power of ten next to the largest distance in a tree at rest; at most a metre.
fn length(tree: &Tree, sample: &Sample) -> f64 {
    let mut resting = sample.clone();
    for body in &tree.bodies {
        for (kind, coordinate) in body.joint.coordinates() {
            if is_translation(kind) {
                resting.q[coordinate.index()] = 0.0;
            }
        }
    }
    let positions = evaluated(tree, "mass_center_position", &resting);
    let largest = positions.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    power_of_ten(largest).min(1.0)
}

fn is_translation(kind: &str) -> bool {
    kind.starts_with('s')
}

/// The least power of ten that is no less; one where there is none.
fn power_of_ten(number: f64) -> f64 {
    let powers = POWERS.into_iter();
    let least = powers.take_while(|&power| power >= number).last();
    least.filter(|_| number > 0.0).unwrap_or(1.0)
}

/// Scales translations to a length, and loads to it and to the mass of what they act on.
fn scale(tree: &Tree, sample: &mut Sample, length: f64) {
    for body in &tree.bodies {
        for (kind, coordinate) in body.joint.coordinates() {
            if is_translation(kind) {
                sample.q[coordinate.index()] *= length;
            }
        }
        for (motion, speed) in body.joint.speeds() {
            if motion >= 3 {
                sample.u[speed.index()] *= length;
                sample.u_dot[speed.index()] *= length;
            }
        }
    }
    for (body, load) in tree.bodies.iter().zip(sample.loads.chunks_mut(6)) {
        let masses = body.parts.iter().map(|part| tree.nominal(part.mass));
        let mass = power_of_ten(masses.sum());
        for (axis, number) in load.iter_mut().enumerate() {
            *number *= if axis < 3 { mass } else { mass * length };
        }
    }
}

/// What a function of the catalogue gives by the notes' equations.
fn evaluated(tree: &Tree, function: &str, sample: &Sample) -> Vec<f64> {
    let function = Function::find(function).expect("a function of the catalogue");
    let derived = Request::from(function).derive(tree, Formulation::Notes, &Plan::full(tree));
    let inputs = inputs(tree, sample);
    let graph = &derived.graph;
    graph.evaluate(&derived.roots, |input| inputs[&input].value)
}

/// What a sample is to the equations.
pub(super) fn inputs(tree: &Tree, sample: &Sample) -> Inputs {
    let mut inputs = BTreeMap::new();
    let mut insert = |input, value| inputs.insert(input, Rounded::exact(value));
    for (place, &value) in sample.q.iter().enumerate() {
        insert(Input::Q(CoordinateId::new(place)), value);
    }
    for (place, (&u, &u_dot)) in sample.u.iter().zip(&sample.u_dot).enumerate() {
        let speed = SpeedId::new(place);
        insert(Input::U(speed), u);
        insert(Input::UDot(speed), u_dot);
        insert(Input::Tau(speed), sample.tau[place]);
    }
    for (place, &value) in sample.parameters.iter().enumerate() {
        insert(Input::Parameter(ParameterId::new(place)), value);
    }
    for body in tree.body_ids() {
        for axis in 0..3 {
            let load = 6 * BodyId::index(body) + axis;
            insert(Input::Force(body, axis), sample.loads[load]);
            insert(Input::Moment(body, axis), sample.loads[load + 3]);
            let rate = sample.w_rel[3 * BodyId::index(body) + axis];
            insert(Input::RelativeAngularVelocity(body, axis), rate);
        }
    }
    inputs
}

/// `SplitMix64`: the same numbers everywhere.
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.0;
        word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        word ^ (word >> 31)
    }

    /// Between a tenth and 1.2 in magnitude, with three digits: angles stay away from the singularity.
    fn number(&mut self) -> f64 {
        let word = self.next();
        let magnitude = thousandths(100 + (word >> 1) % 1101);
        if word & 1 == 0 { magnitude } else { -magnitude }
    }

    /// Between a tenth and 0.4, with three digits: a value that changes by this part of it is another, and near.
    pub(super) fn part(&mut self) -> f64 {
        thousandths(100 + self.next() % 301)
    }
}

fn thousandths(count: u64) -> f64 {
    f64::from(u32::try_from(count).expect("a remainder is small")) / 1000.0
}
