//! What functions give in states that are drawn.
//!
//! Values are those of the notes' formulation, evaluated as a graph: they share neither the recursion, nor the passes, nor the
//! emission with what they test. How far a function may be from them is what rounding can do, to them and to the program
//! that was emitted.

use super::{
    draw::{self, Inputs, Sampler},
    sample::{Sample, Sampled},
};
use crate::{
    compile::{Compiled, Emittable},
    drawn::parameters,
    error::Error,
    expr::Input,
    functions::Formulation,
    listing::{Facts, Function, Module},
    number::{Number, Rounded},
    recursive::Plan,
    threads,
    tree::Tree,
};

/// How many states are tried.
const STATES: u64 = 2;

/// The most numbers that are compared one by one; those of larger outputs are summed, to as many or a few more.
const MOST_NUMBERS: usize = 64;

/// The most numbers of a sum: their weights differ.
const MOST_SUMMED: usize = 1021;

/// How many times the bound on rounding a value may be off. The bound is of first order, and knows nothing of the digits that
/// constants lost where they were folded: that came to four times the bound.
const ROUNDINGS: f64 = 10.0;

/// A number that may be off by more shows nothing.
const MOST_TOLERANCE: f64 = 1e300;

/// What of the largest number of a row any other one may be off, and what of that of an output a zero: the cosine of a right
/// angle that folding made of constants is no zero, and the bound takes it for a number with all its digits.
const CRUMBS: f64 = 8.0 * f64::EPSILON;

/// States, and what each function of the module gives there, or which function has a value in it that f64 does not hold.
pub(crate) fn of(
    tree: &Tree,
    compiled: &Compiled,
    module: &Module,
) -> Result<(Vec<Sample>, Vec<Sampled>), Error> {
    let asked = compiled.functions.iter();
    let asked = asked.flat_map(|one| one.request.arguments()).collect();
    let sampler = Sampler::new(tree, &asked);
    // The first state has the nominal parameters, each other one its own.
    let samples = (0..STATES).map(|seed| {
        let parameters = match seed {
            0 => parameters::nominal(tree),
            seed => parameters::changed(tree, seed),
        };
        sampler.draw(parameters, seed)
    });
    let samples: Vec<Sample> = samples.collect();
    drop(sampler);
    let inputs = samples.iter().map(|sample| inputs(tree, compiled, sample));
    let inputs: Vec<Inputs> = inputs.collect();
    let both: Vec<_> = compiled.functions.iter().zip(&module.functions).collect();
    let functions = threads::map(&both, |(emittable, function)| {
        let lengths = lengths(&module.facts, function);
        sampled(tree, emittable, lengths, &inputs)
    });
    for (emittable, sampled) in compiled.functions.iter().zip(&functions) {
        let mut numbers = sampled.values.iter().flatten().flatten();
        if numbers.any(|(number, tolerance)| !(number.is_finite() && *tolerance < MOST_TOLERANCE)) {
            return Err(Error::Unrepresentable {
                what: format!("the tests of {}", emittable.request.name()),
            });
        }
    }
    Ok((samples, functions))
}

/// The lengths of every output's nested arrays.
fn lengths(facts: &Facts, function: &Function) -> Vec<Vec<usize>> {
    let outputs = function.outputs();
    outputs
        .map(|output| facts.extent(output).lengths().to_vec())
        .collect()
}

/// What a function writes in every state.
fn sampled(
    tree: &Tree,
    emittable: &Emittable,
    lengths: Vec<Vec<usize>>,
    states: &[Inputs],
) -> Sampled {
    let (notes, plan) = (Formulation::Notes, Plan::full(tree));
    let derived = emittable.request.derive(tree, notes, &plan);
    let entries = |lengths: &Vec<usize>| {
        let count: usize = lengths.iter().product();
        count.div_ceil(MOST_NUMBERS).clamp(1, MOST_SUMMED)
    };
    let entries: Vec<usize> = lengths.iter().map(entries).collect();
    let values = states.iter().map(|inputs| {
        let graph = &derived.graph;
        let numbers = graph.evaluate(&derived.roots, |input| inputs[&input]);
        let emitted = emittable.program.evaluate(|input| inputs[&input]);
        let mut rest = tolerated(&numbers, &emitted);
        let outputs = lengths.iter().zip(&entries).map(|(lengths, &entries)| {
            let others = rest.split_off(lengths.iter().product());
            let own = std::mem::replace(&mut rest, others);
            // In an array of several dimensions what is small has rows of its own.
            let row = lengths.last().map_or(1, |&row| row.max(1));
            let largest = largest(&own);
            let rows = own.chunks(row);
            let own: Vec<Rounded> = rows.flat_map(|row| with_crumbs(row, largest)).collect();
            let sums = own.chunks(entries).map(sum);
            sums.map(|sum| (sum.value, sum.error)).collect()
        });
        outputs.collect()
    });
    Sampled {
        values: values.collect(),
        lengths,
        entries,
    }
}

/// Values, and how far those that the emitted program computes may be from them.
fn tolerated(numbers: &[Rounded], emitted: &[Rounded]) -> Vec<Rounded> {
    assert_eq!(numbers.len(), emitted.len(), "functions have one layout");
    let pairs = numbers.iter().zip(emitted);
    let tolerated = pairs.map(|(number, emitted)| Rounded {
        error: ROUNDINGS * (number.error + emitted.error),
        ..*number
    });
    tolerated.collect()
}

fn with_crumbs(row: &[Rounded], largest_of_all: f64) -> Vec<Rounded> {
    let largest_of_row = largest(row);
    let with_crumbs = row.iter().map(|number| {
        let largest = if number.value == 0.0 {
            largest_of_all
        } else {
            largest_of_row
        };
        Rounded {
            error: number.error + CRUMBS * largest,
            ..*number
        }
    });
    with_crumbs.collect()
}

fn largest(numbers: &[Rounded]) -> f64 {
    let magnitudes = numbers.iter().map(|number| number.value.abs());
    magnitudes.fold(0.0, f64::max)
}

/// As `kane::self_test` sums: one number is itself.
fn sum(entries: &[Rounded]) -> Rounded {
    match entries {
        [entry] => *entry,
        entries => {
            let weight = |place: usize| ((place * 397) % 1021 + 1) as f64 / 1024.0;
            let terms = entries.iter().enumerate();
            terms
                .map(|(place, &entry)| Rounded::exact(weight(place)) * entry)
                .fold(Rounded::exact(0.0), |sum, term| sum + term)
        }
    }
}

/// All that a program of the module reads.
fn inputs(tree: &Tree, compiled: &Compiled, sample: &Sample) -> Inputs {
    let mut inputs = draw::inputs(tree, sample);
    for (place, angle) in tree.angles().iter().enumerate() {
        let (sine, cosine) = inputs[&Input::Q(angle.coordinate)].sin_cos();
        inputs.insert(Input::Sine(place), sine);
        inputs.insert(Input::Cosine(place), cosine);
    }
    let prepared = compiled.preparation.evaluate(|input| inputs[&input]);
    for (place, value) in prepared.into_iter().enumerate() {
        inputs.insert(Input::Prepared(place), value);
    }
    inputs
}
