//! The tests beside a module: states, and what the equations give there.
//!
//! Values are those of the notes' formulation, evaluated as a graph: they share neither the recursion, nor the passes, nor the
//! emission with what they test.

use std::collections::BTreeMap;

use crate::{
    emit::{self, Module, Sample, Sampled},
    expr::Input,
    functions::{Formulation, Request},
    id::{BodyId, CoordinateId, ParameterId, SpeedId},
    recursive::Plan,
    threads,
    tree::{Chart, Orientation, Tree},
};

/// How many states are tried.
const STATES: u64 = 2;

/// The most numbers that are compared one by one; those of larger outputs are summed.
const MOST_NUMBERS: usize = 64;

pub(super) fn text(module: &Module<'_>) -> String {
    let tree = module.tree;
    let samples: Vec<Sample> = (0..STATES).map(|seed| sample(tree, seed)).collect();
    let functions = threads::map(&module.functions, |emittable| {
        sampled(tree, &emittable.function, &samples)
    });
    emit::self_tests(module, &samples, &functions)
}

/// A state in which nothing is zero, equal, or singular.
fn sample(tree: &Tree, seed: u64) -> Sample {
    let mut random = Random(seed);
    let mut numbers = |count: usize| (0..count).map(|_| random.number()).collect::<Vec<f64>>();
    let (n_bodies, n_speeds) = (tree.bodies.len(), tree.n_speeds);
    let mut q = numbers(tree.n_coordinates);
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
    Sample {
        q,
        u: numbers(n_speeds),
        u_dot: numbers(n_speeds),
        loads: numbers(6 * n_bodies),
        w_rel: numbers(3 * n_bodies),
    }
}

/// What a function writes in every state.
fn sampled(tree: &Tree, function: &Request, samples: &[Sample]) -> Sampled {
    let derived = function.derive(tree, Formulation::Notes, &Plan::full(tree));
    let n_columns = derived.roots.len() / 3;
    let outputs = function.outputs().into_iter();
    let lengths: Vec<Vec<usize>> = outputs
        .map(|output| output.shape.lengths(tree, n_columns))
        .collect();
    let entries = |lengths: &Vec<usize>| {
        let count: usize = lengths.iter().product();
        count.div_ceil(MOST_NUMBERS).max(1)
    };
    let entries: Vec<usize> = lengths.iter().map(entries).collect();
    let values = samples.iter().map(|sample| {
        let inputs = inputs(tree, sample);
        let numbers = derived
            .graph
            .evaluate(&derived.roots, |input| inputs[&input]);
        let mut rest = &numbers[..];
        let mut outputs = Vec::new();
        for (lengths, &entries) in lengths.iter().zip(&entries) {
            let (own, others) = rest.split_at(lengths.iter().product());
            outputs.push(own.chunks(entries).map(sum).collect());
            rest = others;
        }
        outputs
    });
    Sampled {
        values: values.collect(),
        lengths,
        entries,
    }
}

/// As `kane::self_test` sums: one number is itself.
fn sum(entries: &[f64]) -> f64 {
    match entries {
        [entry] => *entry,
        entries => {
            let weight = |place: usize| f64::from([1, 2, 3, 4, 5, 6, 7][place % 7]) / 8.0;
            let terms = entries.iter().enumerate();
            terms.map(|(place, entry)| weight(place) * entry).sum()
        }
    }
}

fn inputs(tree: &Tree, sample: &Sample) -> BTreeMap<Input, f64> {
    let mut inputs = BTreeMap::new();
    for (place, &value) in sample.q.iter().enumerate() {
        inputs.insert(Input::Q(CoordinateId::new(place)), value);
    }
    for (place, (&u, &u_dot)) in sample.u.iter().zip(&sample.u_dot).enumerate() {
        let speed = SpeedId::new(place);
        inputs.insert(Input::U(speed), u);
        inputs.insert(Input::UDot(speed), u_dot);
        inputs.insert(Input::Tau(speed), u_dot);
    }
    for (place, parameter) in tree.parameters.iter().enumerate() {
        inputs.insert(Input::Parameter(ParameterId::new(place)), parameter.nominal);
    }
    for body in tree.body_ids() {
        for axis in 0..3 {
            let load = 6 * BodyId::index(body) + axis;
            inputs.insert(Input::Force(body, axis), sample.loads[load]);
            inputs.insert(Input::Moment(body, axis), sample.loads[load + 3]);
            let rate = sample.w_rel[3 * BodyId::index(body) + axis];
            inputs.insert(Input::RelativeAngularVelocity(body, axis), rate);
        }
    }
    inputs
}

/// `SplitMix64`: the same numbers everywhere.
struct Random(u64);

impl Random {
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
        let thousandths = u32::try_from(100 + (word >> 1) % 1101);
        let magnitude = f64::from(thousandths.expect("a remainder is small")) / 1000.0;
        if word & 1 == 0 { magnitude } else { -magnitude }
    }
}
