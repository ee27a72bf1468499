//! States at which functions are tested: each term of the equations has a part in what comes out, whatever a model's masses and
//! lengths are.

use std::collections::BTreeMap;

use super::sample::Sample;
use crate::{
    expr::Input,
    functions::{Argument, Derived, Formulation, Function, Request},
    id::{CoordinateId, ParameterId},
    number::Rounded,
    options::companion::SCALES,
    random::Random,
    recursive::Plan,
    tree::{ChartCoordinates, Orientation, Tree, is_translation},
};

/// All that the equations are given in a state.
pub(super) type Inputs = BTreeMap<Input, Rounded>;

/// Powers of ten, each as exact as it is written.
const POWERS: [f64; 25] = [
    1e12, 1e11, 1e10, 1e9, 1e8, 1e7, 1e6, 1e5, 1e4, 1e3, 1e2, 1e1, 1.0, 1e-1, 1e-2, 1e-3, 1e-4,
    1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12,
];

/// What draws samples of a tree.
pub(super) struct Sampler<'a> {
    tree: &'a Tree,
    /// [`SCALES`], by the notes' equations.
    positions: Derived,
    forces: Derived,
}

impl<'a> Sampler<'a> {
    pub(super) fn new(tree: &'a Tree) -> Self {
        let [positions, forces] = SCALES.map(|name| {
            let function = Function::find(name).expect("a function of the catalogue");
            Request::from(function).derive(tree, Formulation::Notes, &Plan::full(tree))
        });
        Self {
            tree,
            positions,
            forces,
        }
    }

    /// A state in which nothing is zero, equal, or singular.
    pub(super) fn draw(&self, parameters: Vec<f64>, seed: u64) -> Sample {
        let tree = self.tree;
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
        let length = self.length(&sample);
        scale(tree, &mut sample, length);
        // Forces that would be nothing beside those of the motion, or everything, would show nothing of one of them.
        let forces = evaluated(tree, &self.forces, &sample);
        let pairs = forces.iter().zip(factors);
        sample.tau = pairs.map(|(force, factor)| factor * force).collect();
        sample
    }

    /// The power of ten next to the largest distance in the tree at rest; at most a metre.
    fn length(&self, sample: &Sample) -> f64 {
        let mut resting = sample.clone();
        for body in &self.tree.bodies {
            for (kind, coordinate) in body.joint.coordinates() {
                if is_translation(kind) {
                    resting.q[coordinate.index()] = 0.0;
                }
            }
        }
        let positions = evaluated(self.tree, &self.positions, &resting);
        let largest = positions.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        power_of_ten(largest).min(1.0)
    }
}

fn normalize(tree: &Tree, q: &mut [f64]) {
    for body in &tree.bodies {
        if let Orientation::AngularVelocity {
            chart: ChartCoordinates::EulerParameters(parameters),
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

fn evaluated(tree: &Tree, derived: &Derived, sample: &Sample) -> Vec<f64> {
    let inputs = inputs(tree, sample);
    let graph = &derived.graph;
    graph.evaluate(&derived.roots, |input| inputs[&input].value)
}

/// What a sample is to the equations.
pub(super) fn inputs(tree: &Tree, sample: &Sample) -> Inputs {
    let mut inputs = BTreeMap::new();
    for argument in Argument::ALL {
        let values = argument.inputs(tree).zip(sample.of(argument));
        inputs.extend(values.map(|(input, &value)| (input, Rounded::exact(value))));
    }
    for (place, &value) in sample.parameters.iter().enumerate() {
        let parameter = Input::Parameter(ParameterId::new(place));
        inputs.insert(parameter, Rounded::exact(value));
    }
    inputs
}
