//! Mechanics' own identities on random systems, compiled by rustc; two states each, seeds 1 and 2.
//!
//! The same identities are tried on more and larger trees, without rustc, in `codegen/tests/derivation/identities.rs`.
#![allow(
    clippy::print_stdout,
    reason = "the largest errors found, shown with --nocapture"
)]

use kane_codegen::{
    functions::{CATALOGUE, Function},
    geometry::IDENTITY,
    tree::{Body, ChartCoordinates, Orientation},
};
use kane_test_support::{
    compare::assert_within,
    dynamics::{
        Model, State,
        agreement::disagreement,
        quantities::{DIFFERENTIATED, EXACT, FITTED},
        topology,
    },
    test_every_identity,
};
use kane_test_systems::{
    BAKED_RUNTIME_CHANGED, Compiled, FRAMED, FRAMED_LIBM, RANDOM, RENUMBERED_LIBM,
    RENUMBERED_NOTES, RENUMBERED_NOTES_LIBM, RUNTIME_LIBM, TWINS,
};

use crate::common::CompiledModel;

/// The systems that have every function.
fn systems() -> impl Iterator<Item = Compiled> {
    RANDOM
        .iter()
        .copied()
        .chain(FRAMED)
        .chain(TWINS)
        .chain(BAKED_RUNTIME_CHANGED)
}

/// Requires an identity of every system.
fn hold(tolerance: f64, error: impl Fn(&dyn Model, &State) -> f64) {
    let mut most = (0.0, "no system");
    for compiled in systems() {
        let model = CompiledModel::new(compiled);
        for seed in [1, 2] {
            let state = State::random(model.tree(), seed);
            let error = error(&model, &state);
            let at = format!("{}, state of seed {seed}", compiled.name);
            assert_within(at, error, tolerance);
            if error > most.0 {
                most = (error, compiled.name);
            }
        }
    }
    println!("largest error {:e}, {}", most.0, most.1);
}

test_every_identity!();

#[test]
fn random_systems_are_of_many_kinds() {
    let models: Vec<CompiledModel> = RANDOM.iter().copied().map(CompiledModel::new).collect();
    let any = |property: &dyn Fn(&CompiledModel) -> bool| models.iter().any(property);
    for model in &models {
        println!(
            "{}: {} bodies, {} speeds, {} parameters, {:?} order, {} roots",
            model.name,
            model.tree().bodies.len(),
            model.tree().n_speeds,
            model.tree().parameters.len(),
            model.tree().order,
            model
                .tree()
                .bodies
                .iter()
                .filter(|body| body.lower.is_none())
                .count()
        );
    }
    assert!(any(&|model| model.tree().n_speeds >= 20));
    assert!(any(&|model| model.tree().parameters.is_empty()));
    assert!(any(&|model| !model.tree().parameters.is_empty()));
    assert!(any(&|model| topology::floats(&model.composition)));
    assert!(any(&|model| model
        .tree()
        .bodies
        .iter()
        .filter(|body| body.lower.is_none())
        .count()
        > 1));
    let renumbered = |(place, number): (usize, usize)| number != place + 1;
    assert!(any(&|model| {
        model
            .tree()
            .bodies
            .iter()
            .map(|body| body.user_number)
            .enumerate()
            .any(renumbered)
    }));
}

#[test]
fn framed_systems_have_joints_of_every_kind() {
    let models: Vec<CompiledModel> = FRAMED.into_iter().map(CompiledModel::new).collect();
    let mut most = [0; 6];
    for model in &models {
        let tree = model.tree();
        let has = |property: &dyn Fn(&Body) -> bool| tree.bodies.iter().any(property);
        let has_of = [
            tree.has_quaternions(),
            has(&|body| {
                let chart = body.joint.orientation;
                matches!(
                    chart,
                    Orientation::AngularVelocity {
                        chart: ChartCoordinates::Angles(_),
                        ..
                    }
                )
            }),
            topology::has_mimics(tree),
            !tree.frames.is_empty(),
            has(&|body| body.pose.rotation != IDENTITY && body.joint.rotation != IDENTITY),
            (1..tree.n_speeds).contains(&tree.prescribed.len()),
        ];
        println!(
            "{}: {} bodies, {} speeds, {} parameters, {has_of:?}",
            model.name,
            tree.bodies.len(),
            tree.n_speeds,
            tree.parameters.len()
        );
        for (most, has) in most.iter_mut().zip(has_of) {
            *most += usize::from(has);
        }
    }
    assert!(most.iter().all(|most| *most > 0), "{most:?}");
}

/// Requires that two compiled models of one system agree on the functions that both have.
fn agree(a: &CompiledModel, b: &CompiledModel, both: impl Fn(&Function) -> bool + Copy) {
    for seed in 1..=5 {
        let state = State::random(a.tree(), seed);
        let (error, function) = disagreement(a, b, both, &state);
        let at = format!(
            "{} and {}, {function}, state of seed {seed}",
            a.name, b.name
        );
        assert_within(at, error, EXACT);
        println!("{} and {}: {error:e} in {function}", a.name, b.name);
    }
}

#[test]
fn order_of_coordinates_does_not_matter() {
    let [body, notes, _] = TWINS.map(CompiledModel::new);
    agree(&body, &notes, |_| true);
}

#[test]
fn numbering_of_bodies_does_not_matter() {
    let [body, _, renumbered] = TWINS.map(CompiledModel::new);
    let numbers = |model: &CompiledModel| {
        model
            .tree()
            .bodies
            .iter()
            .map(|body| body.name.clone())
            .collect::<Vec<_>>()
    };
    assert_ne!(numbers(&body), numbers(&renumbered));
    agree(&body, &renumbered, |_| true);
}

#[test]
fn both_formulations_agree() {
    let [_, _, renumbered] = TWINS.map(CompiledModel::new);
    agree(
        &renumbered,
        &renumbered.called(RENUMBERED_NOTES),
        |function| function.formulations().len() > 1,
    );
}

/// The compiled text against the programs it was written from: the same operations in the same order give the same bits, with
/// the sines of the same library. So no parenthesis, sign, name or index was lost in emission.
mod bits {
    use kane_codegen::{
        compile,
        config::{Formulation, Functions},
        expr::Input,
        options::Options,
        tree::Tree,
    };

    use super::{CATALOGUE, CompiledModel, Model, State};

    fn input(tree: &Tree, state: &State, given: Input) -> f64 {
        match given {
            Input::Q(id) => state.q[id.index()],
            Input::U(id) => state.u[id.index()],
            Input::UDot(id) => state.u_dot[id.index()],
            Input::Tau(id) => state.tau[id.index()],
            Input::Force(body, axis) => state.loads[body.index()][axis],
            Input::Moment(body, axis) => state.loads[body.index()][3 + axis],
            Input::RelativeAngularVelocity(body, axis) => state.w_rel[body.index()][axis],
            Input::Shared(_) | Input::Side(_) | Input::CallResult(_) => {
                unreachable!("no function here has calls")
            }
            Input::Point(_) | Input::FrameForce(_) | Input::FrameMoment(_) | Input::Product(..) => {
                unreachable!("no function here is of a frame")
            }
            Input::Parameter(id) => tree.parameters[id.index()].nominal,
            Input::Sine(_) | Input::Cosine(_) => unreachable!("no function is given them here"),
            Input::Prepared(_) => unreachable!("prepared values are looked up"),
        }
    }

    /// Requires the same bits, but for the sign of a zero, of every function of a model.
    pub(super) fn same(model: &CompiledModel, formulation: Formulation) {
        let only_both = formulation == Formulation::Notes;
        let both = CATALOGUE
            .iter()
            .filter(|function| function.formulations().len() > 1);
        let functions = if only_both {
            Functions::Named(both.map(|function| function.name.to_owned()).collect())
        } else {
            Functions::All(Vec::new())
        };
        let options = Options {
            functions,
            formulation,
            ..Options::default()
        };
        let compiled = compile::compile(model.tree(), &options).expect("it was generated before");
        let mut n_compared = 0;
        for seed in 1..=3 {
            let state = State::random(model.tree(), seed);
            let given = |given: Input| input(model.tree(), &state, given);
            let prepared = compiled.preparation.evaluate(given);
            for emittable in &compiled.functions {
                let name = emittable.request.name();
                if only_both && emittable.request.formulations().len() == 1 {
                    continue;
                }
                let values = emittable.program.evaluate(|input| match input {
                    Input::Prepared(place) => prepared[place],
                    input => given(input),
                });
                let expected = if emittable.request.compact().is_some() {
                    dense(model.tree(), &emittable.blocks, &values)
                } else {
                    values
                };
                let found = model.evaluate(&name, &state);
                assert!(
                    found == expected,
                    "{} {name}, state of seed {seed}:\n{found:?}\n{expected:?}",
                    model.name
                );
                n_compared += 1;
            }
        }
        assert!(n_compared >= 21, "{n_compared} comparisons");
    }

    fn dense(
        tree: &Tree,
        blocks: &[kane_codegen::functions::CompactBlock],
        columns: &[f64],
    ) -> Vec<f64> {
        let width = tree.n_speeds;
        let mut dense = vec![0.0; tree.bodies.len() * 3 * width];
        for block in blocks {
            for (offset, column) in columns
                .chunks_exact(3)
                .skip(block.first)
                .take(block.columns)
                .enumerate()
            {
                for (row, value) in column.iter().enumerate() {
                    dense[(block.body * 3 + row) * width + block.speed + offset] += *value;
                }
            }
        }
        dense
    }
}

#[test]
fn compiled_text_gives_the_bits_of_its_programs() {
    use kane_codegen::config::Formulation;
    let [_, _, renumbered] = TWINS.map(CompiledModel::new);
    bits::same(&renumbered.called(RENUMBERED_LIBM), Formulation::Cheapest);
    bits::same(
        &renumbered.called(RENUMBERED_NOTES_LIBM),
        Formulation::Notes,
    );
    let [_, runtime, _] = BAKED_RUNTIME_CHANGED.map(CompiledModel::new);
    bits::same(&runtime.called(RUNTIME_LIBM), Formulation::Recursive);
    for (framed, libm) in FRAMED.into_iter().zip(FRAMED_LIBM) {
        bits::same(
            &CompiledModel::new(framed).called(libm),
            Formulation::Cheapest,
        );
    }
}

/// With our own sines and cosines, each below one unit in the last place from libm's.
#[test]
fn sines_make_no_difference_beyond_rounding() {
    let [_, _, renumbered] = TWINS.map(CompiledModel::new);
    agree(&renumbered.called(RENUMBERED_LIBM), &renumbered, |_| true);
}
