//! States at which functions are tested: each term of the equations has a part in what comes out, whatever a model's masses and
//! lengths are.

use std::collections::{BTreeMap, BTreeSet};

use super::sample::Sample;
use crate::{
    drawn::with_unit_quaternions,
    expr::Input,
    functions::{Argument, Derived, Formulation, Function, Request},
    id::{BodyId, ParameterId},
    number::Rounded,
    options::companion::SCALES,
    random::Random,
    recursive::Plan,
    tree::Tree,
};

/// All that the equations are given in a state.
pub(super) type Inputs = BTreeMap<Input, Rounded>;

/// Numbers for what the equations are given, or for some of it.
type Numbers = BTreeMap<Input, f64>;

/// Powers of ten, each as exact as it is written.
const POWERS: [f64; 25] = [
    1e12, 1e11, 1e10, 1e9, 1e8, 1e7, 1e6, 1e5, 1e4, 1e3, 1e2, 1e1, 1.0, 1e-1, 1e-2, 1e-3, 1e-4,
    1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12,
];

/// What draws samples of a tree.
pub(super) struct Sampler<'a> {
    tree: &'a Tree,
    drawn: BTreeSet<Argument>,
    /// [`SCALES`], by the notes' equations.
    positions: Derived,
    forces: Derived,
}

impl<'a> Sampler<'a> {
    /// Of directions and multipliers those that are asked for have numbers: of a matrix there are many.
    pub(super) fn new(tree: &'a Tree, asked: &BTreeSet<Argument>) -> Self {
        let plain = Argument::ALL.into_iter();
        let plain = plain.filter(|one| !one.is_of_product());
        let [positions, forces] = SCALES.map(|name| {
            let function = Function::find(name).expect("a function of the catalogue");
            Request::from(function).derive(tree, Formulation::Notes, &Plan::full(tree))
        });
        Self {
            tree,
            drawn: plain.chain(asked.iter().copied()).collect(),
            positions,
            forces,
        }
    }

    /// A state in which nothing is zero, equal, or singular.
    pub(super) fn draw(&self, parameters: Vec<f64>, seed: u64) -> Sample {
        let tree = self.tree;
        let mut random = Random::new(seed);
        let mut drawn = |argument: Argument| -> Vec<(Input, f64)> {
            let inputs = argument.inputs(tree);
            inputs.map(|input| (input, random.number())).collect()
        };
        let all = self.drawn.iter().copied();
        let (of_products, others): (Vec<_>, Vec<_>) =
            all.partition(|argument| argument.is_of_product());
        let (of_frames, others): (Vec<_>, Vec<_>) = others
            .into_iter()
            .partition(|argument| argument.is_of_frame());
        let all_but_forces = others
            .into_iter()
            .filter(|&argument| argument != Argument::Tau);
        let given: Vec<(Input, f64)> = all_but_forces.flat_map(&mut drawn).collect();
        let factors = drawn(Argument::Tau);
        let of_frames: Vec<(Input, f64)> = of_frames.into_iter().flat_map(&mut drawn).collect();
        let of_products = of_products.into_iter().flat_map(&mut drawn);
        let of_products: Vec<(Input, f64)> = of_products.collect();
        let given = of_parameters(&parameters)
            .chain(given)
            .chain(of_frames)
            .chain(of_products)
            .collect();
        let given = with_unit_quaternions(tree, given);
        let scales = scales(tree, self.length(&given));
        let given = scaled(given, &scales);
        // Forces that would be nothing beside those of the motion, or everything, would show nothing of one of them.
        let forces = evaluated(&self.forces, &given);
        let forces = forces.iter().zip(factors);
        let forces = forces.map(|(force, (input, factor))| (input, factor * force));
        let all: Numbers = given.into_iter().chain(forces).collect();
        let arguments = self.drawn.iter().map(|&argument| {
            let numbers = argument.inputs(tree).map(|input| all[&input]);
            (argument, numbers.collect())
        });
        Sample {
            parameters,
            arguments: arguments.collect(),
        }
    }

    /// The power of ten next to the largest distance in the tree at rest; at most a metre.
    fn length(&self, numbers: &Numbers) -> f64 {
        let mut resting = numbers.clone();
        resting.extend(translations(self.tree).map(|translation| (translation, 0.0)));
        let positions = evaluated(&self.positions, &resting);
        let largest = positions.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        power_of_ten(largest).min(1.0)
    }
}

/// The coordinates along axes.
fn translations(tree: &Tree) -> impl Iterator<Item = Input> + '_ {
    let coordinates = tree.bodies.iter().flat_map(|body| body.joint.coordinates());
    coordinates
        .filter(|&(kind, _)| kind.is_translation())
        .map(|(_, coordinate)| Input::Q(coordinate))
}

/// The least power of ten that is no less; one where there is none.
fn power_of_ten(number: f64) -> f64 {
    let powers = POWERS.into_iter();
    let least = powers.take_while(|&power| power >= number).last();
    least.filter(|_| number > 0.0).unwrap_or(1.0)
}

/// By what numbers are scaled that are not about one: translations by a length, loads by it and the mass of what they act on.
fn scales(tree: &Tree, length: f64) -> Numbers {
    let mut scales: Numbers = translations(tree).map(|input| (input, length)).collect();
    for (place, body) in tree.bodies.iter().enumerate() {
        for (motion, speed) in body.joint.speeds() {
            if motion >= 3 {
                scales.extend([Input::U(speed), Input::UDot(speed)].map(|input| (input, length)));
            }
        }
        let id = BodyId::new(place);
        let masses = body.parts.iter().map(|part| tree.nominal(part.mass));
        let mass = power_of_ten(masses.sum());
        for axis in 0..3 {
            scales.insert(Input::Force(id, axis), mass);
            scales.insert(Input::Moment(id, axis), mass * length);
        }
    }
    for axis in 0..3 {
        scales.extend([Input::Point(axis), Input::FrameMoment(axis)].map(|input| (input, length)));
    }
    scales
}

fn scaled(numbers: Numbers, scales: &Numbers) -> Numbers {
    let scaled = numbers.into_iter();
    let scaled = scaled.map(|(input, number)| match scales.get(&input) {
        Some(scale) => (input, number * scale),
        None => (input, number),
    });
    scaled.collect()
}

fn evaluated(derived: &Derived, numbers: &Numbers) -> Vec<f64> {
    let graph = &derived.graph;
    graph.evaluate(&derived.roots, |input| numbers[&input])
}

fn of_parameters(values: &[f64]) -> impl Iterator<Item = (Input, f64)> + '_ {
    let values = values.iter().enumerate();
    values.map(|(place, &value)| (Input::Parameter(ParameterId::new(place)), value))
}

/// What a sample is to the equations.
pub(super) fn inputs(tree: &Tree, sample: &Sample) -> Inputs {
    let arguments = sample
        .arguments
        .iter()
        .flat_map(|(argument, numbers)| argument.inputs(tree).zip(numbers.iter().copied()));
    let all = arguments.chain(of_parameters(&sample.parameters));
    all.map(|(input, value)| (input, Rounded::exact(value)))
        .collect()
}
