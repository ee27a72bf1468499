//! Hybrid dynamics: some joints' accelerations are prescribed, the others' forces.

use std::{collections::BTreeSet, fmt::Write as _};

use kane_codegen::{
    compile::{self, Plans},
    description::{Base, Reading},
    expr::Input,
    functions::{Formulation, Function},
    id::SpeedId,
    options,
    recursive::{Plan, Technique},
    tree::Tree,
};
use kane_test_support::{
    compare::{assert_within, larger, largest, relative_to, size_of},
    dynamics::State,
    numeric::Matrix,
    random::Random,
    systems::{RandomSystem, Sizes, Style, tree, trees},
};

use crate::{
    compiled::read,
    derivatives::{INVERTED, ways},
    evaluator::input,
    frames::{self, relative},
    pages,
};

/// How far two ways to one number may be apart, relative to the mass matrix and the numbers.
const EXACT: f64 = 1e-12;

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
pub(crate) fn prescribing(tree: &Tree, is_prescribed: impl FnMut(&usize) -> bool) -> Tree {
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

/// A tree of which some joints are prescribed, in a state.
struct Case<'a> {
    what: String,
    tree: Tree,
    state: &'a State,
    m: &'a Matrix,
    /// The largest entry of the bias.
    bias: f64,
}

/// Those that are tried of thirty random trees, with random joints prescribed: none, all, or some.
fn each(check: impl Fn(&Case<'_>)) {
    for seed in trees::tried(1..=30) {
        let plain = random_tree(seed);
        let state = &State::random(&plain, seed);
        let m = &Matrix::new(plain.n_speeds, noted(&plain, "mass_matrix", state));
        let bias = largest(&noted(&plain, "bias", state));
        let mut random = Random::new(seed);
        for chance in [0.0, 0.3, 0.5, 0.7, 1.0] {
            let tree = prescribing(&plain, |_| random.chance(chance));
            let prescribed = tree.prescribed.iter().map(|speed| speed.index());
            let prescribed: Vec<usize> = prescribed.collect();
            let what = format!("seed {seed}, {prescribed:?} of {}", tree.n_speeds);
            check(&Case {
                what,
                tree,
                state,
                m,
                bias,
            });
        }
    }
}

impl Case<'_> {
    /// How far two results are apart: accelerations by the forces for what is between them, forces as they are; relative to
    /// the mass matrix and all numbers.
    fn apart(&self, found: &[f64], expected: &[f64]) -> f64 {
        let ([a, f], [b, g]) = (halves(&self.tree, found), halves(&self.tree, expected));
        let scale = larger(
            self.m.norm() * larger(largest(&b), 1.0),
            larger(largest(&g), self.bias),
        );
        let left: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a - b).collect();
        larger(
            size_of(scale, &self.m.times(&left)),
            relative_to(scale, &f, &g),
        )
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

#[test]
fn all_ways_give_the_same_derivatives_whatever_is_prescribed() {
    each(|case| {
        let Case { tree, state, .. } = case;
        let has_values = !tree.parameters.is_empty();
        let by_parameters = [
            "d(hybrid_dynamics)/d(u, parameters, tau)",
            "packed(d(hybrid_dynamics)/d(parameters))",
            "jvp(hybrid_dynamics; parameters, u_dot)",
            "vjp(hybrid_dynamics; tau, parameters)",
            "hessian(hybrid_dynamics; u_dot, parameters)",
        ];
        let texts = [
            "d(hybrid_dynamics)/d(q, u, u_dot, tau)",
            "packed(d(hybrid_dynamics)/d(tau, q))",
            "mass_matrix+hybrid_dynamics+d(hybrid_dynamics)/d(u_dot)",
            "jvp(hybrid_dynamics; q, u, u_dot, tau)",
            "vjp(hybrid_dynamics; q, u, u_dot, tau)",
            "hybrid_dynamics+hessian(hybrid_dynamics; q, u, u_dot, tau)",
        ];
        let by_parameters = by_parameters.into_iter().filter(|_| has_values);
        for text in texts.into_iter().chain(by_parameters) {
            let request = frames::request(tree, text);
            let all = ways(tree).map(|(formulation, plan)| {
                frames::evaluate_by(tree, &request, formulation, &plan, state)
            });
            for (way, found) in all.iter().enumerate().skip(1) {
                let what = format!("{}, {text}, way {way}", case.what);
                assert_within(what, relative(found, &all[0]), INVERTED);
            }
        }
    });
}

#[test]
fn derivatives_with_none_and_with_all_prescribed_cost_what_those_of_the_dynamics_do() {
    for (robot, base) in [("panda", Base::Fixed), ("solo12", Base::Free)] {
        let reading = Reading {
            base: Some(base),
            ..Reading::default()
        };
        let plain = read(&format!("tests/robots/{robot}/{robot}.urdf"), &reading);
        let count = |tree: &Tree, text: &str| {
            let plan = Plan::full(tree).with(Technique::Lockstep, false);
            let plan = plan.with(Technique::Reverse, !text.starts_with("jvp"));
            let request = frames::request(tree, text);
            let derived = compile::by_plan(tree, &request, Formulation::Recursive, &plan);
            compile::operations(&derived).total()
        };
        let [none, all] = [false, true].map(|is_it| prescribing(&plain, |_| is_it));
        for text in [
            "d(hybrid_dynamics)/d(q, u)",
            "jvp(hybrid_dynamics; q, u)",
            "vjp(hybrid_dynamics; q, u)",
            "hessian(hybrid_dynamics; q)",
        ] {
            let of = |function| text.replace("hybrid_dynamics", function);
            let forward = count(&plain, &of("forward_dynamics"));
            assert_eq!(count(&none, text), forward, "{robot}, {text}");
            let (found, inverse) = (count(&all, text), count(&plain, &of("inverse_dynamics")));
            // What is lacking has the other sign than what is needed, by which second derivatives share a little less.
            let most = if text.starts_with("hessian") {
                inverse / 1000
            } else {
                0
            };
            assert!(
                found.abs_diff(inverse) <= most,
                "{robot}, {text}: {found}, {inverse}"
            );
        }
    }
}

#[test]
fn derivatives_hold_where_joints_follow_a_prescribed_one() {
    let reading = Reading::default();
    let gripper = read("tests/robots/gripper/gripper.urdf", &reading);
    assert!(gripper.has_followers());
    let state = &State::random(&gripper, 7);
    for place in 0..gripper.bodies.len() {
        let tree = prescribing(&gripper, |body| *body == place);
        let request = frames::request(&tree, "d(hybrid_dynamics)/d(q, u, u_dot, tau)");
        let all = ways(&tree).map(|(formulation, plan)| {
            frames::evaluate_by(&tree, &request, formulation, &plan, state)
        });
        for found in &all[1..] {
            assert_within(format!("body {place}"), relative(found, &all[0]), INVERTED);
        }
    }
}

#[test]
fn the_recursion_agrees_with_the_notes_whatever_is_prescribed() {
    each(|case| {
        let (tree, state) = (&case.tree, case.state);
        let expected = noted(tree, "hybrid_dynamics", state);
        let full = Plan::full(tree);
        let plain = Plan::plain(tree);
        let plans = [
            ("articulated bodies", full.clone()),
            ("factors", full.with(Technique::Articulated, false)),
            ("the speeds' axes", full.with(Technique::LinkAxes, false)),
            ("nothing", plain.clone()),
            ("these alone", plain.with(Technique::Articulated, true)),
        ];
        for (by, plan) in plans {
            let recursive = Formulation::Recursive;
            let found = evaluate_by(tree, "hybrid_dynamics", recursive, &plan, state);
            let error = case.apart(&found, &expected);
            assert_within(format!("{}, by {by}", case.what), error, EXACT);
        }
    });
}

#[test]
fn what_is_given_is_copied() {
    each(|case| {
        let (tree, state) = (&case.tree, case.state);
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
                assert_eq!(found.to_bits(), given.to_bits(), "{}: {speed}", case.what);
            }
        }
    });
}

#[test]
fn inverse_dynamics_of_the_whole_accelerations_are_the_whole_forces() {
    each(|case| {
        let found = noted(&case.tree, "hybrid_dynamics", case.state);
        let [u_dot, _] = halves(&case.tree, &found);
        let moved = State {
            u_dot: u_dot.clone(),
            ..case.state.clone()
        };
        let tau = noted(&case.tree, "inverse_dynamics", &moved);
        let error = case.apart(&found, &[u_dot, tau].concat());
        assert_within(&case.what, error, EXACT);
    });
}

#[test]
fn the_others_prescribed_undo_it() {
    each(|case| {
        let expected = noted(&case.tree, "hybrid_dynamics", case.state);
        let [u_dot, tau] = halves(&case.tree, &expected);
        let other = Tree {
            prescribed: &all_speeds(&case.tree) - &case.tree.prescribed,
            ..case.tree.clone()
        };
        let given = State {
            u_dot,
            tau,
            ..case.state.clone()
        };
        let (recursive, full) = (Formulation::Recursive, Plan::full(&other));
        let found = evaluate_by(&other, "hybrid_dynamics", recursive, &full, &given);
        assert_within(&case.what, case.apart(&found, &expected), EXACT);
    });
}

#[test]
fn all_prescribed_is_inverse_dynamics_and_none_is_forward_dynamics() {
    each(|case| {
        let (tree, state) = (&case.tree, case.state);
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            let value = |name| evaluate_by(tree, name, formulation, &Plan::full(tree), state);
            let expected = if tree.prescribed.is_empty() {
                [value("forward_dynamics"), state.tau.clone()]
            } else if tree.prescribed == all_speeds(tree) {
                [state.u_dot.clone(), value("inverse_dynamics")]
            } else {
                continue;
            };
            let error = case.apart(&value("hybrid_dynamics"), &expected.concat());
            assert_within(&case.what, error, EXACT);
        }
    });
}

#[test]
fn accelerations_and_forces_that_are_found_are_not_read() {
    each(|case| {
        let tree = &case.tree;
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            let derived = function("hybrid_dynamics").derive(tree, formulation, &Plan::full(tree));
            let found = |speed: usize| {
                let speed = SpeedId::new(speed);
                if tree.prescribed.contains(&speed) {
                    Input::Tau(speed)
                } else {
                    Input::UDot(speed)
                }
            };
            let unread: Vec<Input> = (0..tree.n_speeds).map(found).collect();
            let values = derived.graph.evaluate(&derived.roots, |given| {
                if unread.contains(&given) {
                    f64::NAN
                } else {
                    input(tree, case.state, given)
                }
            });
            assert!(values.iter().all(|value| !value.is_nan()), "{}", case.what);
        }
    });
}

/// The operations of a function as it is emitted.
fn count(tree: &Tree, name: &str) -> usize {
    let request = frames::request(tree, name);
    let none = BTreeSet::new();
    let plans = Plans::new(tree, &none);
    let choice = compile::choose(&plans, &request, options::Formulation::Cheapest);
    compile::emitted(plans.tree, &request, &choice.derived, plans.without).total()
}

#[test]
fn counts_with_none_and_with_all_prescribed_are_those_of_the_dynamics() {
    for seed in 1..=12 {
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
fn the_page_of_functions_has_the_counts_of_derivatives() {
    let reading = Reading {
        base: Some(Base::Fixed),
        ..Reading::default()
    };
    let arm = read("tests/robots/panda/panda.urdf", &reading);
    let up_to = |most: usize| {
        let tree = prescribing(&arm, |body| *body < most);
        count(&tree, "d(hybrid_dynamics)/d(q, u)")
    };
    pages::functions().says(&format!(
        "For a Panda, `d(hybrid_dynamics)/d(q, u)` needs {} with no prescribed joint, {} with the first, and {} with all.",
        up_to(0),
        up_to(1),
        up_to(arm.bodies.len())
    ));
}

#[test]
fn the_page_of_functions_has_the_counts_of_an_arm() {
    let arm = read("tests/robots/ur5/ur5.urdf", &Reading::default());
    let of = |is_prescribed: &dyn Fn(usize) -> bool| {
        let tree = prescribing(&arm, |body| is_prescribed(*body));
        count(&tree, "hybrid_dynamics")
    };
    let up_to = |most: usize| of(&|body| body < most);
    let [none, first, inner, all] = [0, 1, 3, arm.bodies.len()].map(up_to);
    let elbow = of(&|body| arm.bodies[body].joint.name == "elbow_joint");
    assert!(elbow > none);
    pages::functions().says(&format!(
        "For a UR5 it needs {none} with no prescribed joint, {first} with the first, {inner} with the inner three, and {all} with all. \
         In rare cases it needs more than forward dynamics, {elbow} with the elbow of the UR5"
    ));
}

#[test]
fn counts_of_robots() {
    let mut text = String::new();
    let mut robot = |name: &str, base: Option<Base>, sets: &[(&str, &dyn Fn(usize) -> bool)]| {
        let path = format!("tests/robots/{name}/{name}.urdf");
        let plain = read(
            &path,
            &Reading {
                base,
                ..Reading::default()
            },
        );
        let forward = count(&plain, "forward_dynamics");
        writeln!(text, "{name}\n    forward dynamics: {forward}").unwrap();
        for (what, is_prescribed) in sets {
            let tree = prescribing(&plain, |body| is_prescribed(*body));
            let hybrid = count(&tree, "hybrid_dynamics");
            let derivatives = count(&tree, "d(hybrid_dynamics)/d(q, u)");
            writeln!(
                text,
                "    {what} prescribed: {hybrid}, derivatives {derivatives}"
            )
            .unwrap();
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
    insta::assert_snapshot!(text);
}
