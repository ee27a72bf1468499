//! Mechanics' own identities on random trees, every function evaluated as the program that would be emitted.
//!
//! Sixty trees of up to twenty bodies, in an ordinary run the first twenty of them, each in a state of the same seed; a
//! failure names the seed. Every third has plain joints, the others all that joints can be. The same identities are tried on compiled text in `tests/systems`.
#![allow(
    clippy::print_stdout,
    reason = "the largest errors found, shown with --nocapture"
)]

use std::{collections::BTreeSet, sync::OnceLock};

use kane_codegen::{
    expr::{Expr, ExprGraph, Input},
    functions::{CATALOGUE, Formulation, Function},
    geometry::IDENTITY,
    passes::factor,
    program::{self, Operations},
    recursive::{Plan, Regroup, Technique},
    tree::{Body, ChartCoordinates, Coordinate, Mechanics, Orientation, Tree, Value},
};
use kane_test_support::{
    compare::{assert_within, distance, larger, largest, relative, relative_to},
    dynamics::{
        Model, State,
        agreement::{disagreement, pivot_error},
        quantities::{self, DIFFERENTIATED, EXACT, FITTED},
        topology,
    },
    models::{build, system},
    numeric::condition,
    systems::{RandomSystem, Sizes, Style, trees},
    test_every_identity,
};

use crate::evaluator::{Evaluator, hoisted, input};

const SEEDS: std::ops::RangeInclusive<u64> = 1..=60;

fn style(seed: u64) -> Style {
    if seed.is_multiple_of(3) {
        Style::Plain
    } else {
        Style::Framed
    }
}

/// The sizes of a seed's tree: 1 to 20 bodies, one after the other.
fn sizes(seed: u64) -> Sizes {
    let bodies = usize::try_from((seed - 1) % 20 + 1).expect("at most 20");
    Sizes { bodies, speeds: 40 }
}

/// All random systems and their evaluators along the tree, shared by all tests.
fn systems() -> &'static [(u64, RandomSystem, Evaluator)] {
    static SYSTEMS: OnceLock<Vec<(u64, RandomSystem, Evaluator)>> = OnceLock::new();
    SYSTEMS.get_or_init(|| {
        SEEDS
            .map(|seed| {
                let system = RandomSystem::new(seed, sizes(seed), style(seed));
                let evaluator = Evaluator::new(&system, Formulation::Recursive);
                (seed, system, evaluator)
            })
            .collect()
    })
}

/// The systems that are tried.
fn tried() -> impl Iterator<Item = &'static (u64, RandomSystem, Evaluator)> {
    let seeds = trees::tried(SEEDS);
    let systems = systems().iter();
    systems.filter(move |(seed, ..)| seeds.contains(seed))
}

/// Requires an identity of every tree.
fn hold(tolerance: f64, error: impl Fn(&dyn Model, &State) -> f64) {
    hold_of(tolerance, |_, model, state| error(model, state));
}

fn hold_of(tolerance: f64, error: impl Fn(&RandomSystem, &Evaluator, &State) -> f64) {
    let mut most = (0.0, 0);
    for (seed, system, model) in tried() {
        let state = State::random(model.tree(), *seed);
        let error = error(system, model, &state);
        assert_within(format!("seed {seed}, {}", model.name()), error, tolerance);
        if error > most.0 {
            most = (error, *seed);
        }
    }
    println!("largest error {:e}, seed {}", most.0, most.1);
}

#[test]
fn random_trees_have_many_bodies_roots_and_values() {
    let at_least = |least: usize, what: &str, property: &dyn Fn(&Evaluator) -> bool| {
        let systems = systems().iter();
        let n = systems.filter(|(_, _, model)| property(model)).count();
        println!("{n} {what}");
        assert!(n >= least, "{n} {what}");
    };
    let has_body = |model: &Evaluator, property: &dyn Fn(&Tree, &Body) -> bool| {
        let tree = model.tree();
        tree.bodies.iter().any(|body| property(tree, body))
    };
    at_least(4, "large trees", &|model| model.tree().bodies.len() >= 15);
    at_least(20, "trees of several roots", &|model| {
        let bodies = model.tree().bodies.iter();
        bodies.filter(|body| body.lower.is_none()).count() > 1
    });
    at_least(20, "trees with runtime values", &|model| {
        !model.tree().parameters.is_empty()
    });
    at_least(4, "trees that float", &|model| {
        topology::floats(model.composition())
    });
    at_least(20, "renumbered trees", &|model| {
        has_body(model, &|_, body| {
            body.user_number != 1 && body.lower.is_none()
        })
    });
    at_least(8, "trees with massless bodies", &|model| {
        has_body(model, &|tree, body| tree.nominal(body.parts[0].mass) == 0.0)
    });
    at_least(8, "trees without weight", &|model| {
        let tree = model.tree();
        tree.gravity.iter().all(|&g| tree.nominal(g) == 0.0)
    });
}

/// So many of all systems that each identity says something of every feature.
#[test]
fn random_joints_are_of_every_kind() {
    let count = |what: &str, property: &dyn Fn(&Tree, &Body) -> bool| {
        let systems = systems().iter();
        let has = |tree: &Tree| tree.bodies.iter().any(|body| property(tree, body));
        let n = systems.filter(|(_, _, model)| has(model.tree())).count();
        println!("{n} systems with {what}");
        assert!(n >= 8, "{n} systems with {what}");
    };
    let chart = |body: &Body| match body.joint.orientation {
        Orientation::AngularVelocity { chart, .. } => Some(chart),
        Orientation::Rates(_) => None,
    };
    let mechanics = |body: &Body, of: fn(&Mechanics) -> Value| {
        let zero = Value::Baked(0.0);
        body.joint.mechanics.iter().any(|one| of(one) != zero)
    };
    let is_runtime = |value: &Value| matches!(value, Value::Runtime(_));
    count("turned frames", &|_, body| {
        body.joint.rotation != IDENTITY && body.pose.rotation != IDENTITY
    });
    count("joints off the origin", &|_, body| {
        !body.pose.origin.steps().is_empty()
    });
    count("joints off the origin, at run time", &|_, body| {
        let mut steps = body.pose.origin.steps().iter();
        steps.any(|step| step.vector.iter().any(is_runtime))
    });
    count("turned inertias", &|_, body| {
        body.parts.iter().any(|part| part.axes != IDENTITY)
    });
    count("quaternions", &|_, body| {
        matches!(chart(body), Some(ChartCoordinates::EulerParameters(_)))
    });
    count("angles with angular velocities", &|_, body| {
        matches!(chart(body), Some(ChartCoordinates::Angles(_)))
    });
    count("mimics", &|_, body| {
        (0..6).any(|motion| {
            matches!(
                body.joint.coordinate_of(motion),
                Some(Coordinate::Mimic { .. })
            )
        })
    });
    count("fixed bodies", &|_, body| body.parts.len() > 1);
    count("bodies fixed to the inertial frame", &|tree, _| {
        tree.frames.iter().any(|frame| frame.body.is_none())
    });
    count("fixed bodies with runtime values", &|_, body| {
        body.parts.len() > 1 && body.parts.iter().any(|part| is_runtime(&part.mass))
    });
    count("springs", &|_, body| mechanics(body, |one| one.stiffness));
    count("springs off zero", &|_, body| {
        mechanics(body, |one| one.rest)
    });
    count("dampers", &|_, body| mechanics(body, |one| one.damping));
    count("rotors", &|_, body| mechanics(body, |one| one.armature));
    count("mechanics at run time", &|_, body| {
        let mut all = body.joint.mechanics.iter();
        all.any(|one| is_runtime(&one.damping) || is_runtime(&one.armature))
    });
}

test_every_identity!();

/// True for a function that has both formulations.
fn has_both(function: &Function) -> bool {
    function.formulations().len() > 1
}

#[test]
fn both_formulations_agree() {
    hold_of(EXACT, |system, model, state| {
        let notes = model.otherwise(Formulation::Notes, Plan::full(model.tree()));
        let (error, function) = disagreement(model, &notes, has_both, state);
        assert_within(format!("{}, {function}", system.name), error, EXACT);
        error
    });
}

/// Techniques that change nothing of how this file derives functions, and the tests that try them.
const ELSEWHERE: [Technique; 5] = [
    // Of frames: `frames.rs`.
    Technique::Inward,
    // Of derivatives: `derivatives.rs`, `products.rs`.
    Technique::DirectDerivatives,
    Technique::Reverse,
    // Passes: `passes.rs`, `reuse.rs`.
    Technique::Factor,
    Technique::Reuse,
];

/// Each technique alone, and all but each: in turn, one for every tree.
#[test]
fn techniques_do_not_matter() {
    let mut known = BTreeSet::new();
    let techniques = Technique::ALL.map(|(_, technique)| technique).into_iter();
    let techniques = techniques.filter(|technique| !ELSEWHERE.contains(technique));
    let techniques: Vec<Technique> = techniques.collect();
    for (number, (seed, system, model)) in tried().enumerate() {
        let state = State::random(model.tree(), *seed);
        let technique = techniques[number % techniques.len()];
        known.insert(technique);
        for base in [Plan::plain, Plan::full] {
            let regroup = Regroup::ALL[number % Regroup::ALL.len()];
            let plan = base(model.tree()).with_regroup(None, regroup);
            let plan = plan.with(technique, !plan.uses(technique));
            let other = model.otherwise(Formulation::Recursive, plan);
            let (error, function) = disagreement(model, &other, has_both, &state);
            assert_within(format!("{}, {function}", system.name), error, EXACT);
        }
    }
    assert_eq!(known.len(), techniques.len());
}

#[test]
fn numbering_of_bodies_does_not_matter() {
    hold_of(EXACT, |system, model, state| {
        let renumbered = Evaluator::new(
            &system.renumbered(model.tree().n_speeds as u64),
            Formulation::Recursive,
        );
        let (error, function) = disagreement(model, &renumbered, |_| true, state);
        assert_within(format!("{}, {function}", system.name), error, EXACT);
        error
    });
}

#[test]
fn order_of_coordinates_does_not_matter() {
    hold_of(EXACT, |system, model, state| {
        let [body, notes] = ["body", "notes"]
            .map(|order| Evaluator::new(&system.ordered(order), Formulation::Recursive));
        let state = state.renumbered(model.tree(), body.tree());
        let (error, function) = disagreement(&body, &notes, |_| true, &state);
        assert_within(format!("{}, {function}", system.name), error, EXACT);
        error
    });
}

#[test]
fn runtime_values_do_not_matter() {
    hold_of(EXACT, |system, model, state| {
        let [runtime, baked] = [true, false]
            .map(|runtime| Evaluator::new(&system.with_runtime(runtime), Formulation::Recursive));
        let (error, function) = disagreement(&runtime, &baked, |_| true, state);
        assert_within(format!("{}, {function}", system.name), error, EXACT);
        assert!(runtime.tree().parameters.len() > baked.tree().parameters.len());
        assert_eq!(model.tree().n_speeds, baked.tree().n_speeds);
        error
    });
}

/// Factoring reassociates products, and nothing else does; hoisting and flattening keep every bit.
#[test]
fn factoring_hoisting_and_flattening_keep_the_values_of_the_catalogue() {
    let mut most = 0.0_f64;
    for (seed, system, model) in tried() {
        let (tree, state) = (model.tree(), State::random(model.tree(), *seed));
        let m = quantities::mass_matrix(model, &state);
        for function in &CATALOGUE {
            for &formulation in function.formulations() {
                let at = format!(
                    "seed {seed}, {} {} {}",
                    system.name,
                    function.name,
                    formulation.name()
                );
                let derived = function.derive(tree, formulation, &Plan::full(tree));
                let of = |graph: &ExprGraph, roots: &[Expr], prepared: &[f64]| {
                    graph.evaluate(roots, |given| match given {
                        Input::Prepared(place) => prepared[place],
                        given => input(tree, &state, given),
                    })
                };
                let plain = of(&derived.graph, &derived.roots, &[]);
                let (graph, roots) = factor::run(derived.graph.clone(), derived.roots.clone());
                let factored = of(&graph, &roots, &[]);
                let error = match function.name {
                    "forward_dynamics_pivots" => pivot_error(&m, &factored, &plain),
                    // Rounding of the matrix moves a solution and its inverse by its condition.
                    "forward_dynamics"
                    | "loaded_forward_dynamics"
                    | "hybrid_dynamics"
                    | "mass_matrix_inverse"
                    | "mass_matrix_inverse_packed"
                    | "mass_matrix_solve" => relative(&factored, &plain) / condition(&m),
                    _ => relative_to(larger(largest(&plain), 1.0), &factored, &plain),
                };
                most = larger(most, assert_within(format!("{at}, factored"), error, EXACT));
                let counted = Operations::of(&graph, &roots);
                let (graph, roots, prepared) = hoisted(tree, &graph, &roots);
                let inside = of(&graph, &roots, &prepared);
                assert_same_bits(&inside, &factored, &format!("{at}, hoisted"));
                let program = program::flatten(&graph, &roots);
                assert_eq!(program.operations(), counted, "{at}");
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
        distance(found, expected)
    );
}

#[test]
fn friction_has_the_sign_of_its_speed_without_a_dead_band() {
    let text = system("[0]", &[("arm", "[\"theta1\"]")]);
    let tree = build(&text).expect("a sound description").tree;
    let function = Function::find("joint_regressor").expect("a function of the catalogue");
    let derived = function.derive(&tree, Formulation::Notes, &Plan::full(&tree));
    let sign = |speed: f64| {
        let given = |input| match input {
            Input::U(_) => speed,
            _ => 1.0,
        };
        derived.graph.evaluate(&derived.roots, given)[1]
    };
    for (speed, expected) in [(0.0, 0.0), (1e-30, 0.5), (1e-13, 1.0), (1e300, 1.0)] {
        assert_eq!(sign(speed), expected, "{speed:e}");
        assert_eq!(sign(-speed), -expected, "-{speed:e}");
    }
}
