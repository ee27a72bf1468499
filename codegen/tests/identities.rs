//! Mechanics' own identities on random trees, every function evaluated as the program that would be emitted.
//!
//! Forty trees of up to twenty bodies, `seed` 1 to 40, each in a state of the same seed; a failure names the seed. The same
//! identities are tried on compiled text in `tests/systems`.
#![allow(
    clippy::print_stdout,
    reason = "the largest errors found, shown with --nocapture"
)]

mod dynamics;

use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex, OnceLock},
};

use dynamics::{
    Model, State, identities, kinematics, numeric,
    random::{RandomSystem, Sizes, tree},
};
use identities::{DIFFERENTIATED, EXACT};
use kane_codegen::{
    expr::{Expr, ExprGraph, Input},
    functions::{Block, CATALOGUE, Formulation, Function, Shape},
    passes::{factor, hoist},
    program::{self, Program},
    tree::Tree,
};

const SEEDS: std::ops::RangeInclusive<u64> = 1..=40;

/// The sizes of a seed's tree: 1 to 20 bodies, each size twice.
fn sizes(seed: u64) -> Sizes {
    let bodies = usize::try_from((seed - 1) % 20 + 1).expect("at most 20");
    Sizes { bodies, speeds: 40 }
}

/// A system, evaluated through the programs of one formulation.
struct Evaluator {
    name: String,
    tree: Tree,
    formulation: Formulation,
    functions: Mutex<BTreeMap<&'static str, Arc<Flat>>>,
}

/// A function as it would be emitted.
struct Flat {
    program: Program,
    blocks: Vec<Block>,
    prepared: Vec<f64>,
}

impl Evaluator {
    fn new(system: &RandomSystem, formulation: Formulation) -> Self {
        let tree = tree(&system.toml()).expect("a random system is accepted");
        Self {
            name: format!("{} in formulation {}", system.name, formulation.name()),
            tree,
            formulation,
            functions: Mutex::default(),
        }
    }

    fn flat(&self, function: &str) -> Arc<Flat> {
        let function = Function::find(function).expect("a function of the catalogue");
        let mut functions = self.functions.lock().expect("no test panics in here");
        let flat = functions
            .entry(function.name)
            .or_insert_with(|| Arc::new(flat(&self.tree, function, self.formulation)));
        Arc::clone(flat)
    }
}

impl Model for Evaluator {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn tree(&self) -> &Tree {
        &self.tree
    }

    fn evaluate(&self, function: &str, state: &State) -> Vec<f64> {
        let flat = self.flat(function);
        let values = flat.program.evaluate(|given| match given {
            Input::Prepared(place) => flat.prepared[place],
            given => input(&self.tree, state, given),
        });
        if Function::find(function).is_some_and(|function| function.shape == Shape::Columns) {
            dense(&self.tree, &flat.blocks, &values)
        } else {
            values
        }
    }
}

/// Derives, factors, hoists and flattens.
fn flat(tree: &Tree, function: &Function, formulation: Formulation) -> Flat {
    let derived = function.derive(tree, formulation);
    let (graph, roots) = if function.shape == Shape::Columns {
        (derived.graph, derived.roots)
    } else {
        factor::run(&derived.graph, &derived.roots)
    };
    let (graph, roots, prepared) = hoisted(tree, &graph, &roots);
    Flat {
        program: program::flatten(&graph, &roots),
        blocks: derived.blocks,
        prepared,
    }
}

/// The graph inside the loop, and the values of what is outside.
fn hoisted(tree: &Tree, graph: &ExprGraph, roots: &[Expr]) -> (ExprGraph, Vec<Expr>, Vec<f64>) {
    let mut preparation = hoist::Preparation::default();
    let (graph, roots) = hoist::run(graph, roots, "f", &mut preparation);
    let prepared = preparation
        .graph
        .evaluate(&preparation.roots(), |given| match given {
            Input::Parameter(id) => tree.parameters[id.index()].nominal,
            other => unreachable!("{other:?} is no parameter"),
        });
    (graph, roots, prepared)
}

fn input(tree: &Tree, state: &State, given: Input) -> f64 {
    match given {
        Input::Q(id) => state.q[id.index()],
        Input::U(id) => state.u[id.index()],
        Input::UDot(id) => state.u_dot[id.index()],
        Input::Tau(id) => state.tau[id.index()],
        Input::Force(body, axis) => state.loads[body.index()][axis],
        Input::Moment(body, axis) => state.loads[body.index()][3 + axis],
        Input::RelativeAngularVelocity(body, axis) => state.w_rel[body.index()][axis],
        Input::Parameter(id) => tree.parameters[id.index()].nominal,
        Input::Prepared(_) => unreachable!("prepared values are hoisted"),
    }
}

fn dense(tree: &Tree, blocks: &[Block], columns: &[f64]) -> Vec<f64> {
    let width = tree.n_speeds;
    let mut dense = vec![0.0; tree.bodies.len() * 3 * width];
    for block in blocks {
        for column in 0..block.columns {
            for row in 0..3 {
                dense[(block.body * 3 + row) * width + block.speed + column] =
                    columns[3 * (block.first + column) + row];
            }
        }
    }
    dense
}

/// The random systems and their evaluators along the tree, shared by all tests.
fn systems() -> &'static [(u64, RandomSystem, Evaluator)] {
    static SYSTEMS: OnceLock<Vec<(u64, RandomSystem, Evaluator)>> = OnceLock::new();
    SYSTEMS.get_or_init(|| {
        SEEDS
            .map(|seed| {
                let system = RandomSystem::new(seed, sizes(seed));
                let evaluator = Evaluator::new(&system, Formulation::Recursive);
                (seed, system, evaluator)
            })
            .collect()
    })
}

/// Requires an identity of every tree.
fn hold(tolerance: f64, error: impl Fn(&dyn Model, &State) -> f64) {
    hold_of(tolerance, |_, model, state| error(model, state));
}

fn hold_of(tolerance: f64, error: impl Fn(&RandomSystem, &Evaluator, &State) -> f64) {
    let mut most = (0.0, 0);
    for (seed, system, model) in systems() {
        let state = State::random(model.tree(), *seed);
        let error = error(system, model, &state);
        if error > most.0 {
            most = (error, *seed);
        }
        assert!(
            error <= tolerance,
            "seed {seed}, {}: off by {error:e}, {tolerance:e} allowed",
            model.name()
        );
    }
    println!("largest error {:e}, seed {}", most.0, most.1);
}

#[test]
fn random_trees_have_many_bodies_roots_and_values() {
    let trees: Vec<&Tree> = systems().iter().map(|(_, _, model)| model.tree()).collect();
    let any =
        |property: &dyn Fn(&Tree) -> bool| trees.iter().filter(|tree| property(tree)).count() >= 4;
    assert!(any(&|tree| tree.bodies.len() >= 18));
    assert!(any(&|tree| tree
        .bodies
        .iter()
        .filter(|body| body.lower.is_none())
        .count()
        > 1));
    assert!(any(&|tree| !tree.parameters.is_empty()));
    assert!(any(&dynamics::floats));
    assert!(any(&|tree| tree
        .bodies
        .iter()
        .any(|body| body.user_number != 1 && body.lower.is_none())));
    assert!(any(&|tree| tree
        .bodies
        .iter()
        .any(|body| tree.nominal(body.parts[0].mass) == 0.0)));
    assert!(any(&|tree| tree
        .gravity
        .iter()
        .all(|&g| tree.nominal(g) == 0.0)));
}

macro_rules! identities {
    ($module:ident, $($name:ident: $tolerance:expr;)+) => {$(
        #[test]
        fn $name() {
            hold($tolerance, $module::$name);
        }
    )+};
}

identities! {
    identities,
    mass_matrix_is_symmetric: 0.0;
    mass_matrix_is_positive_definite: EXACT;
    inverse_dynamics_is_linear: EXACT;
    forward_dynamics_undoes_inverse_dynamics: EXACT;
    forcing_is_loads_less_bias: EXACT;
    generalized_forces_are_projected_loads: EXACT;
    inverse_dynamics_is_newton_euler: EXACT;
    power_is_the_rate_of_energy: DIFFERENTIATED;
    bias_follows_from_the_energies: DIFFERENTIATED;
    bias_at_rest_is_the_gradient_of_potential_energy: DIFFERENTIATED;
    energies_and_momenta_are_sums_over_bodies: EXACT;
    momenta_of_a_floating_tree_change_by_external_loads: DIFFERENTIATED;
}

identities! {
    kinematics,
    velocities_are_rates_of_positions: DIFFERENTIATED;
    accelerations_are_rates_of_velocities: DIFFERENTIATED;
    partial_velocities_make_velocities: DIFFERENTIATED;
    rotations_are_rotations: EXACT;
    angle_rates_undo_relative_angular_velocity: EXACT;
    singularity_is_the_cosine_of_the_second_angle: EXACT;
    rates_of_coordinates_are_speeds: 0.0;
}

/// True for a function that has both formulations.
fn has_both(function: &Function) -> bool {
    function.formulations().len() > 1
}

#[test]
fn both_formulations_agree() {
    hold_of(EXACT, |system, model, state| {
        let notes = Evaluator::new(system, Formulation::Notes);
        let (error, function) = identities::disagreement(model, &notes, has_both, state);
        assert!(error <= EXACT, "{}, {function}: {error:e}", system.name);
        error
    });
}

#[test]
fn numbering_of_bodies_does_not_matter() {
    hold_of(EXACT, |system, model, state| {
        let renumbered = Evaluator::new(
            &system.renumbered(model.tree().n_speeds as u64),
            Formulation::Recursive,
        );
        let (error, function) = identities::disagreement(model, &renumbered, |_| true, state);
        assert!(error <= EXACT, "{}, {function}: {error:e}", system.name);
        error
    });
}

#[test]
fn order_of_coordinates_does_not_matter() {
    hold_of(EXACT, |system, model, state| {
        let [body, notes] = ["body", "notes"]
            .map(|order| Evaluator::new(&system.ordered(order), Formulation::Recursive));
        let state = state.renumbered(model.tree(), body.tree());
        let (error, function) = identities::disagreement(&body, &notes, |_| true, &state);
        assert!(error <= EXACT, "{}, {function}: {error:e}", system.name);
        error
    });
}

#[test]
fn runtime_values_do_not_matter() {
    hold_of(EXACT, |system, model, state| {
        let [runtime, baked] = [true, false]
            .map(|runtime| Evaluator::new(&system.with_runtime(runtime), Formulation::Recursive));
        let (error, function) = identities::disagreement(&runtime, &baked, |_| true, state);
        assert!(error <= EXACT, "{}, {function}: {error:e}", system.name);
        assert!(runtime.tree().parameters.len() > baked.tree().parameters.len());
        assert_eq!(model.tree().n_speeds, baked.tree().n_speeds);
        error
    });
}

/// Factoring reassociates products, and nothing else does; hoisting and flattening keep every bit.
#[test]
fn passes_keep_the_values_of_every_function() {
    let mut most = 0.0_f64;
    for (seed, system, model) in systems() {
        let (tree, state) = (model.tree(), State::random(model.tree(), *seed));
        let m = identities::mass_matrix(model, &state);
        for function in &CATALOGUE {
            for &formulation in function.formulations() {
                let at = format!(
                    "seed {seed}, {} {} {}",
                    system.name,
                    function.name,
                    formulation.name()
                );
                let derived = function.derive(tree, formulation);
                let of = |graph: &ExprGraph, roots: &[Expr], prepared: &[f64]| {
                    graph.evaluate(roots, |given| match given {
                        Input::Prepared(place) => prepared[place],
                        given => input(tree, &state, given),
                    })
                };
                let plain = of(&derived.graph, &derived.roots, &[]);
                let (graph, roots) = factor::run(&derived.graph, &derived.roots);
                let factored = of(&graph, &roots, &[]);
                let error = match function.name {
                    "forward_dynamics_pivots" => identities::pivot_error(&m, &factored, &plain),
                    // Rounding of the matrix moves a solution by its condition.
                    "forward_dynamics" => {
                        numeric::relative(&factored, &plain) / numeric::condition(&m)
                    }
                    _ => numeric::relative_to(numeric::largest(&plain).max(1.0), &factored, &plain),
                };
                assert!(error <= EXACT, "{at}: factoring moves it by {error:e}");
                most = most.max(error);
                let (graph, roots, prepared) = hoisted(tree, &graph, &roots);
                let inside = of(&graph, &roots, &prepared);
                assert_same_bits(&inside, &factored, &format!("{at}, hoisted"));
                let program = program::flatten(&graph, &roots);
                let flat = program.evaluate(|given| match given {
                    Input::Prepared(place) => prepared[place],
                    given => input(tree, &state, given),
                });
                assert_same_bits(&flat, &inside, &format!("{at}, flattened"));
            }
        }
    }
    println!("largest error {most:e}");
}

/// The same bits, but for the sign of a zero.
fn assert_same_bits(found: &[f64], expected: &[f64], at: &str) {
    assert!(
        found == expected,
        "{at}: off by {:e}",
        numeric::distance(found, expected)
    );
}
