//! Hybrid dynamics: some joints' accelerations are prescribed, the others' forces.

use std::{collections::BTreeSet, fmt::Write as _};

use kane_codegen::{
    compile::{self, Options},
    description::{Base, Reading},
    expr::Input,
    functions::{Formulation, Function, Request},
    id::SpeedId,
    recursive::{Plan, Technique},
    tree::Tree,
};
use kane_test_support::{
    compare::{assert_within, larger, largest, relative_to, size_of},
    dynamics::State,
    numeric::Matrix,
    random::Random,
    systems::{RandomSystem, Sizes, Style, tree},
};

use crate::{compiled::read, evaluator::input};

/// How far two ways to one number may be apart, relative to the mass matrix and the numbers.
const EXACT: f64 = 1e-12;

const SEEDS: std::ops::RangeInclusive<u64> = 1..=60;

fn random_tree(seed: u64) -> Tree {
    let style = if seed.is_multiple_of(3) {
        Style::Plain
    } else {
        Style::Framed
    };
    let bodies = usize::try_from(seed % 12 + 1).expect("a few");
    let system = RandomSystem::new(seed, Sizes { bodies, speeds: 30 }, style);
    tree(&system.toml()).expect("a random system is accepted")
}

/// The tree with these joints prescribed, by the places of their bodies.
fn prescribing(tree: &Tree, is_prescribed: impl FnMut(&usize) -> bool) -> Tree {
    let bodies = (0..tree.bodies.len()).filter(is_prescribed);
    let speeds = bodies.flat_map(|body| tree.bodies[body].joint.speeds());
    Tree {
        prescribed: speeds.map(|(_, speed)| speed).collect(),
        ..tree.clone()
    }
}

fn all_speeds(tree: &Tree) -> BTreeSet<SpeedId> {
    (0..tree.n_speeds).map(SpeedId::new).collect()
}

/// Random trees with random joints prescribed: none, all, or some.
fn each(check: impl Fn(&str, &Tree, &State)) {
    for seed in SEEDS {
        let plain = random_tree(seed);
        let state = State::random(&plain, seed);
        let mut random = Random::new(seed);
        for chance in [0.0, 0.3, 0.5, 0.7, 1.0] {
            let tree = prescribing(&plain, |_| random.chance(chance));
            let prescribed = tree.prescribed.iter().map(|speed| speed.index());
            let prescribed: Vec<usize> = prescribed.collect();
            let what = format!("seed {seed}, {prescribed:?} of {}", tree.n_speeds);
            check(&what, &tree, &state);
        }
    }
}

fn function(name: &str) -> &'static Function {
    Function::find(name).expect("a function of the catalogue")
}

fn evaluate_by(
    tree: &Tree,
    name: &str,
    formulation: Formulation,
    plan: &Plan,
    state: &State,
) -> Vec<f64> {
    let derived = function(name).derive(tree, formulation, plan);
    let graph = &derived.graph;
    graph.evaluate(&derived.roots, |given| input(tree, state, given))
}

/// By the notes' equations.
fn noted(tree: &Tree, name: &str, state: &State) -> Vec<f64> {
    evaluate_by(tree, name, Formulation::Notes, &Plan::plain(tree), state)
}

/// `whole_u_dot` and `whole_tau`.
fn halves(tree: &Tree, found: &[f64]) -> [Vec<f64>; 2] {
    let (u_dot, tau) = found.split_at(tree.n_speeds);
    [u_dot.to_vec(), tau.to_vec()]
}

/// How far two results are apart: accelerations by the forces for what is between them, forces as they are; relative to the mass
/// matrix and all numbers.
fn apart(tree: &Tree, state: &State, found: &[f64], expected: &[f64]) -> f64 {
    let m = Matrix::new(tree.n_speeds, noted(tree, "mass_matrix", state));
    let bias = largest(&noted(tree, "bias", state));
    let ([a, f], [b, g]) = (halves(tree, found), halves(tree, expected));
    let scale = larger(
        m.norm() * larger(largest(&b), 1.0),
        larger(largest(&g), bias),
    );
    let left: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a - b).collect();
    larger(size_of(scale, &m.times(&left)), relative_to(scale, &f, &g))
}

#[test]
fn the_recursion_agrees_with_the_notes_whatever_is_prescribed() {
    each(|what, tree, state| {
        let expected = noted(tree, "hybrid_dynamics", state);
        let full = Plan::full(tree);
        let plans = [
            ("articulated bodies", full.clone()),
            ("factors", full.with(Technique::Articulated, false)),
            ("the speeds' axes", full.with(Technique::LinkAxes, false)),
            ("nothing", Plan::plain(tree)),
            (
                "articulated alone",
                Plan::plain(tree).with(Technique::Articulated, true),
            ),
        ];
        for (by, plan) in plans {
            let recursive = Formulation::Recursive;
            let found = evaluate_by(tree, "hybrid_dynamics", recursive, &plan, state);
            let error = apart(tree, state, &found, &expected);
            assert_within(format!("{what}, by {by}"), error, EXACT);
        }
    });
}

#[test]
fn what_is_given_is_copied() {
    each(|what, tree, state| {
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            let plan = Plan::full(tree);
            let found = evaluate_by(tree, "hybrid_dynamics", formulation, &plan, state);
            let [u_dot, tau] = halves(tree, &found);
            for speed in 0..tree.n_speeds {
                let (found, given) = if tree.prescribed.contains(&SpeedId::new(speed)) {
                    (u_dot[speed], state.u_dot[speed])
                } else {
                    (tau[speed], state.tau[speed])
                };
                assert_eq!(found.to_bits(), given.to_bits(), "{what}: speed {speed}");
            }
        }
    });
}

#[test]
fn inverse_dynamics_of_the_whole_accelerations_are_the_whole_forces() {
    each(|what, tree, state| {
        let found = noted(tree, "hybrid_dynamics", state);
        let [u_dot, tau] = halves(tree, &found);
        let moved = State {
            u_dot: u_dot.clone(),
            ..state.clone()
        };
        let needed = noted(tree, "inverse_dynamics", &moved);
        let error = apart(
            tree,
            state,
            &[u_dot, needed].concat(),
            &[found[..tree.n_speeds].to_vec(), tau].concat(),
        );
        assert_within(what, error, EXACT);
    });
}

#[test]
fn the_others_prescribed_undo_it() {
    each(|what, tree, state| {
        let expected = noted(tree, "hybrid_dynamics", state);
        let [u_dot, tau] = halves(tree, &expected);
        let other = Tree {
            prescribed: &all_speeds(tree) - &tree.prescribed,
            ..tree.clone()
        };
        let given = State {
            u_dot,
            tau,
            ..state.clone()
        };
        let (recursive, full) = (Formulation::Recursive, Plan::full(&other));
        let found = evaluate_by(&other, "hybrid_dynamics", recursive, &full, &given);
        assert_within(what, apart(tree, state, &found, &expected), EXACT);
    });
}

#[test]
fn all_prescribed_is_inverse_dynamics_and_none_is_forward_dynamics() {
    for seed in SEEDS {
        let plain = random_tree(seed);
        let state = State::random(&plain, seed);
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            let values = |tree: &Tree, name: &str| {
                evaluate_by(tree, name, formulation, &Plan::full(tree), &state)
            };
            let none = values(&plain, "hybrid_dynamics");
            let u_dot = values(&plain, "forward_dynamics");
            assert_eq!(none, [u_dot, state.tau.clone()].concat(), "seed {seed}");
            let all = Tree {
                prescribed: all_speeds(&plain),
                ..plain.clone()
            };
            let found = values(&all, "hybrid_dynamics");
            let tau = values(&plain, "inverse_dynamics");
            let expected = [state.u_dot.clone(), tau].concat();
            let error = apart(&plain, &state, &found, &expected);
            assert_within(format!("seed {seed}"), error, EXACT);
        }
    }
}

#[test]
fn accelerations_and_forces_that_are_found_are_not_read() {
    each(|what, tree, _| {
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            let plan = Plan::full(tree);
            let derived = function("hybrid_dynamics").derive(tree, formulation, &plan);
            let mut unread = BTreeSet::new();
            let all = vec![1.5; tree.n_speeds];
            // What an evaluation asks for is what the roots depend on, and what was built beside: read is what changes them.
            let values = |off: Option<Input>| {
                derived.graph.evaluate(&derived.roots, |given| match given {
                    given if Some(given) == off => f64::NAN,
                    Input::Parameter(id) => tree.parameters[id.index()].nominal,
                    _ => 0.7,
                })
            };
            for (place, _) in all.iter().enumerate() {
                let speed = SpeedId::new(place);
                let found = if tree.prescribed.contains(&speed) {
                    Input::Tau(speed)
                } else {
                    Input::UDot(speed)
                };
                if values(Some(found))
                    .iter()
                    .zip(values(None))
                    .all(|(a, b)| a.is_nan() == b.is_nan())
                {
                    unread.insert(place);
                }
            }
            assert_eq!(unread.len(), tree.n_speeds, "{what}");
        }
    });
}

/// The operations of a function as it is emitted.
fn count(tree: &Tree, name: &str) -> usize {
    let request = Request::from(function(name));
    let choice = compile::choose(tree, &request, &Options::default());
    compile::operations(&choice.derived).total()
}

#[test]
fn counts_with_none_and_with_all_prescribed_are_those_of_the_dynamics() {
    for seed in 1..=24 {
        let none = random_tree(seed);
        let all = prescribing(&none, |_| true);
        let forward = count(&none, "forward_dynamics");
        assert_eq!(count(&none, "hybrid_dynamics"), forward, "seed {seed}");
        let (hybrid, inverse) = (
            count(&all, "hybrid_dynamics"),
            count(&all, "inverse_dynamics"),
        );
        // The search starts from other plans.
        assert!(
            hybrid.abs_diff(inverse) * 100 <= inverse,
            "seed {seed}: {hybrid} with all prescribed, {inverse} of inverse dynamics"
        );
    }
}

#[test]
fn counts_of_robots() {
    let mut text = String::new();
    let mut robot = |name: &str, base: Option<Base>, sets: &[(&str, &dyn Fn(usize) -> bool)]| {
        let path = format!("tests/robots/{name}/{name}.urdf");
        let plain = read(&path, &Reading { base, chart: None });
        let forward = count(&plain, "forward_dynamics");
        writeln!(text, "{name}\n    forward dynamics: {forward}").unwrap();
        for (what, is_prescribed) in sets {
            let tree = prescribing(&plain, |body| is_prescribed(*body));
            let hybrid = count(&tree, "hybrid_dynamics");
            writeln!(text, "    {what} prescribed: {hybrid}").unwrap();
        }
        let inverse = count(&plain, "inverse_dynamics");
        writeln!(text, "    inverse dynamics: {inverse}").unwrap();
    };
    let arm: [(&str, &dyn Fn(usize) -> bool); 6] = [
        ("none", &|_| false),
        ("first joint", &|body| body == 0),
        ("every other joint", &|body| body % 2 == 1),
        ("inner half", &|body| body < 3),
        ("outer half", &|body| body >= 3),
        ("all", &|_| true),
    ];
    robot("ur5", None, &arm);
    robot("panda", None, &arm);
    let legs: [(&str, &dyn Fn(usize) -> bool); 5] = [
        ("none", &|_| false),
        ("base", &|body| body == 0),
        ("every other joint", &|body| body % 2 == 1),
        ("all but the base", &|body| body > 0),
        ("all", &|_| true),
    ];
    robot("solo12", Some(Base::Free), &legs);
    robot("talos", Some(Base::Free), &legs);
    insta::assert_snapshot!(text);
}
