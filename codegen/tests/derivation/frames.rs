//! Functions of frames: against the functions of bodies, against what other software computed, and by differences.

use std::{
    collections::{BTreeMap, BTreeSet},
    ops::RangeInclusive,
    path::Path,
};

use kane_codegen::{
    compile::{self, Plans},
    description::{self, Reading, no_includes},
    diagnostic::Source,
    expr::Input,
    functions::{Argument, Formulation, Function, OF_FRAMES, Of, Parsed, Request, View},
    id::ParameterId,
    options,
    recursive::{Plan, Technique},
    tree::{self, Changes, Tree},
};
use kane_test_support::{
    compare::{assert_within, distance, larger},
    dynamics::State,
    json::flat,
    systems::{RandomSystem, Sizes, Style, trees},
};

use crate::evaluator::input;

/// How far two ways to one number may be apart, relative to the largest there.
pub(crate) const EXACT: f64 = 1e-13;

/// The same where mass matrices are inverted, whose condition numbers here are below 1e4. Found: 5e-13.
pub(crate) const INVERTED: f64 = 5e-12;

/// How far two ways to what is asked for may be apart.
fn allowed(text: &str) -> f64 {
    if text.contains("operational") {
        INVERTED
    } else {
        EXACT
    }
}

/// How far differences of eighth order may be off: the step to the eighth power, and rounding over the step.
pub(crate) const DIFFERENCED: f64 = 1e-10;

pub(crate) const STEP: f64 = 4e-3;

/// Frames in bodies and in the inertial frame, beside those that a random tree has; `body` is one of its bodies.
fn frames(body: &str) -> String {
    format!(
        "\n[[frame]]\nname = \"marker one\"\nbody = \"{body}\"\nposition = [0.3, -0.2, {{ runtime = 0.7 }}]\n\
        rotation = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]\n\
        \n[[frame]]\nname = \"turned\"\nbody = \"{body}\"\nrotation = {{ runtime = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]] }}\n\
        \n[[frame]]\nname = \"stand\"\nposition = [1.0, 2.0, 3.0]\n"
    )
}

/// Those that are tried of thirty.
pub(crate) fn seeds() -> RangeInclusive<u64> {
    trees::tried(1..=30)
}

pub(crate) fn system(seed: u64) -> (RandomSystem, Tree) {
    let style = if seed.is_multiple_of(3) {
        Style::Plain
    } else {
        Style::Framed
    };
    let bodies = usize::try_from(seed % 9 + 1).expect("a few");
    let system = RandomSystem::new(seed, Sizes { bodies, speeds: 30 }, style);
    let plain = kane_test_support::systems::tree(&system.toml()).expect("a right description");
    let last = plain.bodies.last().expect("it has bodies").name.clone();
    let tree = kane_test_support::systems::tree(&(system.toml() + &frames(&last)));
    (system, tree.expect("a right description"))
}

pub(crate) fn request(tree: &Tree, text: &str) -> Request {
    let request = Parsed::read(text).and_then(|parsed| parsed.on(tree));
    request.unwrap_or_else(|faults| unreachable!("{text}: {faults:?}"))
}

pub(crate) fn evaluate(
    tree: &Tree,
    request: &Request,
    formulation: Formulation,
    state: &State,
) -> Vec<f64> {
    evaluate_by(tree, request, formulation, &Plan::full(tree), state)
}

/// What is evaluated in several states, and derived once.
pub(crate) fn of_states<'a>(
    tree: &'a Tree,
    request: &Request,
    formulation: Formulation,
) -> impl Fn(&State) -> Vec<f64> + use<'a> {
    let derived = request.derive(tree, formulation, &Plan::full(tree));
    move |state| {
        let graph = &derived.graph;
        graph.evaluate(&derived.roots, |given| input(tree, state, given))
    }
}

/// What a request gives by a plan.
pub(crate) fn evaluate_by(
    tree: &Tree,
    request: &Request,
    formulation: Formulation,
    plan: &Plan,
    state: &State,
) -> Vec<f64> {
    let derived = request.derive(tree, formulation, plan);
    let graph = &derived.graph;
    graph.evaluate(&derived.roots, |given| input(tree, state, given))
}

/// Every function of a frame, in every way in which it can be seen.
fn every_request(name: &str, other: &str) -> Vec<String> {
    let of = |function: &Function| {
        let (Of::Frame(views) | Of::Frames(views)) = function.of else {
            unreachable!("{} is of a frame", function.name)
        };
        let function = function.name;
        let views = views.iter().map(move |view| match view {
            View::Inertial => format!("{function}({name})"),
            View::Local => format!("{function}({name}, local)"),
            View::Other => format!("{function}({name}, {other})"),
        });
        views.collect::<Vec<_>>()
    };
    OF_FRAMES.iter().flat_map(of).collect()
}

/// The names of all frames, as requests write them.
pub(crate) fn names(tree: &Tree) -> Vec<String> {
    let frames = tree.named_frames();
    frames
        .map(|frame| format!("\"{}\"", tree.frame_name(frame)))
        .collect()
}

pub(crate) fn product(m: &[f64], v: &[f64]) -> Vec<f64> {
    let row = |row: &[f64]| row.iter().zip(v).map(|(a, b)| a * b).sum();
    m.chunks(3).map(row).collect()
}

pub(crate) fn transposed(m: &[f64]) -> Vec<f64> {
    (0..9).map(|place| m[place % 3 * 3 + place / 3]).collect()
}

pub(crate) fn relative(found: &[f64], expected: &[f64]) -> f64 {
    let largest = expected.iter().fold(1.0, |most, x| larger(most, x.abs()));
    distance(found, expected) / largest
}

#[test]
fn functions_of_frames_are_the_same_in_both_formulations() {
    for seed in seeds() {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        let names = names(&tree);
        for (place, name) in names.iter().enumerate() {
            let other = &names[(7 * place + 3) % names.len()];
            for text in every_request(name, other) {
                let request = request(&tree, &text);
                assert_eq!(request.formulations().len(), 2);
                let notes = evaluate(&tree, &request, Formulation::Notes, &state);
                let full = Plan::full(&tree);
                let turning = full.with_parallel(None, false);
                let levers = full.with(Technique::Inward, false);
                let steps = levers.with(Technique::Levers, false);
                for plan in [Plan::plain(&tree), full, turning, levers, steps] {
                    let by = Formulation::Recursive;
                    let recursive = evaluate_by(&tree, &request, by, &plan, &state);
                    let error = relative(&recursive, &notes);
                    assert_within(format!("{seed}, {text}, {plan:?}"), error, allowed(&text));
                }
            }
        }
    }
}

#[test]
fn poses_of_bodies_are_their_rotations_and_positions() {
    for seed in seeds() {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        let of_bodies = |name: &str| {
            let function = Function::find(name).expect("a function of the catalogue");
            evaluate(&tree, &Request::from(function), Formulation::Notes, &state)
        };
        let (rotations, origins) = (of_bodies("rotation"), of_bodies("origin_position"));
        let bodies = tree.bodies.iter();
        let bodies = bodies.zip(rotations.chunks(9).zip(origins.chunks(3)));
        for (body, (rotation, origin)) in bodies {
            let request = request(&tree, &format!("pose(\"{}\")", body.name));
            let pose = evaluate(&tree, &request, Formulation::Recursive, &state);
            let expected = [rotation.to_vec(), product(&transposed(rotation), origin)].concat();
            assert_within(
                format!("{seed}, {}", body.name),
                relative(&pose, &expected),
                EXACT,
            );
        }
    }
}

/// The derivative at 0 of a function of time, from its values at four steps on both sides.
pub(crate) fn rate(of: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut rate = vec![0.0; of(0.0).len()];
    for (weight, step) in WEIGHTS.into_iter().zip(1_u8..) {
        let t = f64::from(step) * STEP;
        let pairs = of(t).into_iter().zip(of(-t));
        for (rate, (after, before)) in rate.iter_mut().zip(pairs) {
            *rate += weight * (after - before) / STEP;
        }
    }
    rate
}

#[test]
fn velocities_are_rates_of_poses() {
    for seed in seeds() {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        let at_rest = State {
            u_dot: vec![0.0; tree.n_speeds],
            ..state.clone()
        };
        for name in names(&tree) {
            let pose = request(&tree, &format!("pose({name})"));
            let pose = of_states(&tree, &pose, Formulation::Recursive);
            let pose = |t: f64| pose(&at_rest.moved(&tree, t));
            let rate = rate(pose);
            // Of the matrix from the frame's components to inertial ones, A_dot A^T is the tilde of the angular velocity.
            let now = pose(0.0);
            let of_rows = |i: usize, j: usize| {
                (0..3)
                    .map(|k| rate[3 * k + i] * now[3 * k + j])
                    .sum::<f64>()
            };
            let angular = [of_rows(2, 1), of_rows(0, 2), of_rows(1, 0)];
            let expected = [&rate[9..], &angular].concat();
            let velocity = request(&tree, &format!("velocity({name})"));
            let velocity = evaluate(&tree, &velocity, Formulation::Recursive, &state);
            assert_within(
                format!("{seed}, {name}"),
                relative(&velocity, &expected),
                DIFFERENCED,
            );

            let local = request(&tree, &format!("velocity({name}, local)"));
            let local = evaluate(&tree, &local, Formulation::Notes, &state);
            let turned = velocity.chunks(3).flat_map(|v| product(&now[..9], v));
            let turned: Vec<f64> = turned.collect();
            assert_within(
                format!("{seed}, {name}, local"),
                relative(&local, &turned),
                EXACT,
            );
        }
    }
}

/// A pendulum of two bodies with a tool whose place is as the text says.
fn with_tool(tool: &str) -> Tree {
    let text = "name = \"arm\"\ngravity = [0.0, 0.0, -9.81]\nlower_bodies = [0, 1]\n".to_owned();
    let body = |name: &str, axis: &str| {
        format!(
            "\n[[body]]\nname = \"{name}\"\nmass = 1.0\nmass_center = [0.1, 0.2, 0.3]\n\
            inertia = {{ xx = 0.1, yy = 0.1, zz = 0.1, xy = 0.0, xz = 0.0, yz = 0.0 }}\n\
            attachment = [0.0, 0.0, 0.5]\njoint = [\"{axis}\"]\n"
        )
    };
    let text = text + &body("upper", "theta1") + &body("fore", "theta2");
    let text = format!("{text}\n[[frame]]\nname = \"tool0\"\nbody = \"fore\"\n{tool}\n");
    kane_test_support::systems::tree(&text).expect("a right description")
}

#[test]
fn a_frame_at_run_time_is_where_its_parameters_say() {
    let nominal = "position = [{ runtime = 0.1 }, 0.0, { runtime = 0.0 }]\n\
        rotation = { runtime = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] }";
    let changed = "position = [0.4, 0.0, -0.3]\n\
        rotation = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]";
    let (runtime, baked) = (with_tool(nominal), with_tool(changed));
    let names: Vec<&str> = runtime
        .parameters
        .iter()
        .map(|one| one.name.as_str())
        .collect();
    assert_eq!(
        names[..3],
        ["tool0_position_x", "tool0_position_z", "tool0_rotation_x_x"]
    );
    let values = [0.4, -0.3, 0.6, 0.8, 0.0, -0.8, 0.6, 0.0, 0.0, 0.0, 1.0];
    let state = State::random(&baked, 7);
    for text in every_request("tool0", "upper") {
        let text = text.as_str();
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            let expected = evaluate(&baked, &request(&baked, text), formulation, &state);
            let request = request(&runtime, text);
            let derived = request.derive(&runtime, formulation, &Plan::plain(&runtime));
            let found = derived.graph.evaluate(&derived.roots, |given| match given {
                Input::Parameter(place) => values[ParameterId::index(place)],
                given => input(&runtime, &state, given),
            });
            assert_within(text, relative(&found, &expected), allowed(text));
        }
    }
}

#[test]
fn robots_are_where_pinocchio_sees_them() {
    for name in ["panda", "ur5"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../tests/robots")
            .join(name);
        let text = |file: &str| {
            std::fs::read_to_string(folder.join(file)).expect("the file is in the repository")
        };
        let source = Source::new("robot.urdf", text(&format!("{name}.urdf")));
        let described = description::read(&source, &Reading::default(), &no_includes);
        // Right angles written with ten digits are taken as they are there, too.
        let changes = Changes {
            snap: 0.0,
            ..Changes::default()
        };
        let tree = tree::build_with(&described, &changes)
            .expect("a right description")
            .tree;
        let reference: serde_json::Value =
            serde_json::from_str(&text("reference.json")).expect("it is JSON");
        let links = reference["links"].as_array().expect("it lists links");
        let (mut n_poses, mut n_velocities) = (0, 0);
        let none = BTreeSet::new();
        let plans = Plans::new(&tree, &none);
        let mut chosen = BTreeMap::new();
        for sample in reference["samples"].as_array().expect("it lists samples") {
            let mut inputs = BTreeMap::new();
            let (q, v) = (flat(&sample["q"]), flat(&sample["v"]));
            inputs.extend(Argument::Q.inputs(&tree).zip(q));
            inputs.extend(Argument::U.inputs(&tree).zip(v.iter().copied()));
            let mut evaluate = |text: String| {
                let derived = chosen.entry(text).or_insert_with_key(|text: &String| {
                    let request = request(&tree, text);
                    compile::choose(&plans, &request, options::Formulation::Cheapest).derived
                });
                let graph = &derived.graph;
                graph.evaluate(&derived.roots, |given| inputs[&given])
            };
            // Some samples are of other quantities alone.
            let placements = sample["link_placements"].as_array();
            for (link, placement) in links.iter().zip(placements.into_iter().flatten()) {
                n_poses += 1;
                let link = link.as_str().expect("it is a name");
                let placement = flat(placement);
                let expected = [&transposed(&placement[..9])[..], &placement[9..]].concat();
                let found = evaluate(format!("pose({link})"));
                assert_within(
                    format!("{name}, {link}"),
                    distance(&found, &expected),
                    1e-12,
                );
            }
            let jacobians = sample["link_jacobians_local_world_aligned"].as_object();
            for (link, jacobian) in jacobians.into_iter().flatten() {
                n_velocities += 1;
                let rows = flat(jacobian);
                let rows = rows.chunks(v.len());
                let expected: Vec<f64> = rows
                    .map(|row| row.iter().zip(&v).map(|(a, b)| a * b).sum())
                    .collect();
                let found = evaluate(format!("jacobian({link})"));
                let error = distance(&found, &flat(jacobian));
                assert_within(format!("{name}, {link}, Jacobian"), error, 1e-12);
                let found = evaluate(format!("velocity({link})"));
                assert_within(
                    format!("{name}, {link}"),
                    distance(&found, &expected),
                    1e-12,
                );
            }
        }
        assert!(n_poses > 0, "no pose was compared");
        assert!(n_velocities > 0, "no velocity was compared");
    }
}
