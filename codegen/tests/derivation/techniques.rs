//! What each technique of the recursion is worth: limits that counts stay below, the gain of each technique on each system,
//! and on random trees that none costs more than it saves.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::{collections::BTreeSet, fmt::Write as _, thread};

use crate::{compiled::read, pages};
use kane_codegen::{
    compile::{self, Plans},
    description::{Base, Reading, toml},
    diagnostic::Source,
    expr::Input,
    functions::{Formulation, Request},
    geometry,
    program::Operations,
    recursive::{Plan, Technique},
    tree::{self, CoordinateKind, Tree},
};
use kane_test_support::compare::{Tolerance, assert_close};
use kane_test_support::systems::{self, RandomSystem, Sizes, Style, trees::share};

const FUNCTIONS: [&str; 3] = ["inverse_dynamics", "mass_matrix", "forward_dynamics"];

fn robot(name: &str, base: Base) -> Tree {
    read(
        &format!("tests/robots/{name}/{name}.urdf"),
        &Reading {
            base: Some(base),
            ..Reading::default()
        },
    )
}

fn eight_bodies() -> Tree {
    read("models/eight_body.toml", &Reading::default())
}

/// A row of modified Denavit-Hartenberg parameters: alpha, d, r of `Rx(alpha) Tx(d) Rz(theta) Tz(r)`, rad, m.
type Row = [f64; 3];

const RIGHT: f64 = std::f64::consts::FRAC_PI_2;

const RX_90: [Row; 6] = [
    [0.0, 0.0, 0.0],
    [RIGHT, 0.0, 0.0],
    [0.0, 0.45, 0.0],
    [-RIGHT, 0.0, 0.45],
    [RIGHT, 0.0, 0.0],
    [-RIGHT, 0.0, 0.0],
];

const PUMA_560: [Row; 6] = [
    [0.0, 0.0, 0.0],
    [-RIGHT, 0.0, 0.2435],
    [0.0, 0.4318, -0.0934],
    [RIGHT, -0.0203, 0.4331],
    [-RIGHT, 0.0, 0.0],
    [RIGHT, 0.0, 0.0],
];

fn generic_6r() -> [Row; 6] {
    [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(|i| [0.3 + 0.1 * i, 0.2 + 0.01 * i, 0.3])
}

/// Neighbouring axes at right angles to one another, and none in one point.
fn chain_of_64() -> Vec<Row> {
    let row = |k: u32| {
        let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        [sign * RIGHT, 0.2 + 0.01 * f64::from(k), 0.3]
    };
    let first = [[0.0; 3]];
    first.into_iter().chain((1..64).map(row)).collect()
}

/// Revolute bodies of ten inertial parameters each, no two alike.
fn arm(rows: &[Row]) -> Tree {
    let lower: Vec<String> = (0..rows.len()).map(|k| k.to_string()).collect();
    let mut text = format!(
        "name = \"arm\"\ngravity = [0.0, 0.0, -9.81]\nlower_bodies = [{}]\n",
        lower.join(", ")
    );
    for (k, [alpha, d, r]) in rows.iter().enumerate() {
        let axes = geometry::body_fixed_123([*alpha, 0.0, 0.0]);
        let [x, y, z] = axes[2].map(|along| along * r);
        let attachment = [x + d, y, z];
        let vary = |base: f64, step: f64| base + step * ((k * 7 + 3) % 11) as f64;
        write!(
            text,
            "[[body]]\nname = \"b{k}\"\nmass = {:?}\nmass_center = {:?}\n\
             inertia = {{ xx = {:?}, yy = {:?}, zz = {:?}, xy = {:?}, xz = {:?}, yz = {:?} }}\n\
             attachment = {attachment:?}\nattachment_rotation = {axes:?}\njoint = [\"theta3\"]\n",
            vary(1.5, 0.13),
            [vary(0.05, 0.007), vary(-0.08, 0.011), vary(0.11, -0.004)],
            vary(0.31, 0.017),
            vary(0.37, 0.013),
            vary(0.29, 0.019),
            vary(0.021, 0.001),
            vary(-0.017, 0.0015),
            vary(0.013, -0.0011),
        )
        .unwrap();
    }
    tree::build(&toml::parse(&Source::new("arm.toml", text)))
        .unwrap()
        .tree
}

fn request(name: &str) -> Request {
    Request::parse(name).unwrap()
}

fn count(tree: &Tree, function: &str, without: &[Technique]) -> Operations {
    let without: BTreeSet<Technique> = without.iter().copied().collect();
    let formulation = Formulation::Recursive;
    let (plans, request) = (Plans::new(tree, &without), request(function));
    let choice = compile::of_formulation(&plans, &request, formulation);
    compile::emitted(plans.tree, &request, &choice.derived, plans.without)
}

#[test]
fn the_comparison_has_the_counts_of_arms() {
    let page = pages::comparison();
    for (name, rows) in [
        ("RX-90", RX_90),
        ("PUMA 560", PUMA_560),
        ("generic 6R", generic_6r()),
    ] {
        let tree = arm(&rows);
        let counted = FUNCTIONS.map(|function| count(&tree, function, &[]));
        let [inverse, mass, forward] = counted.map(|own| format!("{}m {}a", own.mul, own.add));
        page.says(&format!(
            "| {name} | {inverse} | {mass} | {forward}, {} divisions |",
            counted[2].div
        ));
    }
    let of = |rows: &[Row]| count(&arm(rows), "inverse_dynamics", &[]);
    let [rx, generic] = [of(&RX_90), of(&generic_6r())];
    pages::performance().says(&format!(
        "`kane` needs {} and {}, and {} and {}.",
        rx.mul, rx.add, generic.mul, generic.add
    ));
}

#[test]
fn the_page_of_performance_has_what_ways_to_derivatives_are_worth() {
    let of = |name: &str, base: Base, function: &str, without: &[Technique]| {
        count(&robot(name, base), function, without).total()
    };
    let columns = "d(forward_dynamics)/d(q, u, tau)";
    let written_out = [Technique::Lockstep];
    let [panda, solo12, talos] = [
        ("panda", Base::Fixed),
        ("solo12", Base::Free),
        ("talos", Base::Free),
    ]
    .map(|(name, base)| of(name, base, columns, &written_out));
    pages::performance().says(&format!(
        "Written out one by one, panda needs {panda} operations, solo12 {solo12} and talos {talos}, but"
    ));
    let fewer = |function: &str| {
        let [with, without] = [&[][..], &[Technique::DirectDerivatives]]
            .map(|without| of("panda", Base::Fixed, function, without) as f64);
        format!("{:.0}", 100.0 * (1.0 - with / without))
    };
    let [along, gradient, second] = ["jvp", "vjp", "hessian"]
        .map(|kind| fewer(&format!("{kind}(forward_dynamics; q, u, tau)")));
    assert_eq!(along, gradient);
    pages::performance().says(&format!(
        "for a Panda, {along} % fewer operations in products and {second} % fewer in second derivatives."
    ));
    let forces = "d(inverse_dynamics)/d(q, u, u_dot)";
    pages::performance().says(&format!(
        "Solo12's `{forces}` takes {} operations",
        of("solo12", Base::Free, forces, &[])
    ));
    let mut times = [
        ("ur5", Base::Fixed),
        ("panda", Base::Fixed),
        ("solo12", Base::Free),
        ("talos", Base::Free),
    ]
    .map(|(name, base)| {
        let with = "inverse_dynamics+vjp(inverse_dynamics; q, u, u_dot)";
        let [with, alone] = [with, "inverse_dynamics"].map(|own| of(name, base, own, &[]));
        with as f64 / alone as f64
    });
    times.sort_by(f64::total_cmp);
    let [least, .., most] = times;
    pages::performance().says(&format!(
        "which needs {least:.1} to {most:.1} times the operations of inverse dynamics alone"
    ));
}

/// What grows faster than linearly with a chain shows here first.
#[test]
fn a_chain_of_64_revolute_bodies() {
    let chain = arm(&chain_of_64());
    let mut text = String::new();
    for function in FUNCTIONS {
        writeln!(text, "{function}: {}", count(&chain, function, &[])).unwrap();
    }
    insta::assert_snapshot!(text, @"
    inverse_dynamics: 7321 = 3696 mul + 3499 add + 0 div + 126 trig
    mass_matrix: 40771 = 23937 mul + 16708 add + 0 div + 126 trig
    forward_dynamics: 17849 = 8936 mul + 8724 add + 63 div + 126 trig
    ");
}

/// How many per cent more operations there are without each technique.
#[test]
fn every_technique_of_dynamics_has_its_gain() {
    let systems = [
        ("RX-90", arm(&RX_90)),
        ("PUMA 560", arm(&PUMA_560)),
        ("generic 6R", arm(&generic_6r())),
        ("ur5", robot("ur5", Base::Fixed)),
        ("panda", robot("panda", Base::Fixed)),
        ("solo12", robot("solo12", Base::Free)),
        ("talos", robot("talos", Base::Free)),
        ("eight_body", eight_bodies()),
    ];
    let mut text = String::new();
    for function in FUNCTIONS {
        let rows: Vec<String> = thread::scope(|scope| {
            let counted = systems.iter().map(|(name, tree)| {
                scope.spawn(move || format!("| {name} {}", gains(tree, function)))
            });
            let counted: Vec<_> = counted.collect();
            counted.into_iter().map(|row| row.join().unwrap()).collect()
        });
        let names: Vec<&str> = of_dynamics().map(|(name, _)| name).collect();
        writeln!(
            text,
            "{function}\n\n| | all | none | {} |\n|---|---|---|{}\n{}\n",
            names.join(" | "),
            "---|".repeat(names.len()),
            rows.join("\n")
        )
        .unwrap();
    }
    for (column, (name, _)) in of_dynamics().enumerate() {
        let cells = text
            .lines()
            .filter_map(|row| row.split('|').nth(4 + column));
        assert!(cells.into_iter().any(|cell| cell.contains('+')), "{name}");
    }
    insta::assert_snapshot!(text);
    let page = pages::performance();
    for row in text.lines().filter(|line| line.starts_with("| ")) {
        page.says(row);
    }
    for (name, tree) in &systems {
        let counts = FUNCTIONS.map(|function| count(tree, function, &[]).total().to_string());
        // Ours stand before each of CasADi's.
        let own = [2, 4, 6].into_iter().zip(counts.iter().map(String::as_str));
        page.has_row(name, 9, &own.collect::<Vec<_>>());
        if ["ur5", "panda", "solo12", "talos"].contains(name) {
            let own = (2..).zip(counts.iter().map(String::as_str));
            pages::comparison().has_row(name, 6, &own.collect::<Vec<_>>());
        }
    }
}

/// The techniques but those that concern frames, weights, derivatives or the inverse of the mass matrix alone.
fn of_dynamics() -> impl Iterator<Item = (&'static str, Technique)> {
    let others = [
        Technique::Inward,
        Technique::Levers,
        Technique::Weights,
        Technique::Rates,
        Technique::DirectDerivatives,
        Technique::Reverse,
        Technique::Carriers,
        Technique::Lockstep,
    ];
    let all = Technique::ALL.into_iter();
    all.filter(move |(_, technique)| !others.contains(technique))
}

fn gains(tree: &Tree, function: &str) -> String {
    let all = count(tree, function, &[]).total();
    let every: Vec<Technique> = of_dynamics().map(|(_, technique)| technique).collect();
    let none = count(tree, function, &every).total();
    let mut row = format!("| {all} | {none} ");
    for technique in every {
        let more = count(tree, function, &[technique]).total() as f64 / all as f64 - 1.0;
        let shown = if more == 0.0 {
            String::new()
        } else {
            format!("{:+.1} %", 100.0 * more)
        };
        write!(row, "| {shown} ").unwrap();
    }
    row + "|"
}

/// Angles so small, beside a right one or alone, that their cosine rounds to one and their sine does not vanish.
#[test]
fn axes_that_lean_by_less_than_a_cosine_shows_are_not_taken_for_upright() {
    for lean in [5e-9, 4.9e-12] {
        let around = [
            geometry::body_fixed_123([0.7, 0.0, RIGHT - lean]),
            geometry::body_fixed_123([lean, 0.0, 0.0]),
            geometry::body_fixed_123([0.0, lean, 0.0]),
        ];
        for (rotation, joint) in around.into_iter().zip(["s2", "theta3", "theta3"]) {
            let mut text = String::from(
                "name = \"leaning\"\ngravity = [0.3, 0.0, -9.81]\nlower_bodies = [0, 1, 2]\n",
            );
            for (k, joint) in ["theta3", joint, "theta3"].into_iter().enumerate() {
                write!(
                    text,
                    "[[body]]\nname = \"b{k}\"\nmass = 1.5\nmass_center = [0.1, 0.2, 0.3]\n\
                     inertia = {{ xx = 0.15, yy = 0.06, zz = 0.17, xy = 0.01, xz = 0.02, yz = 0.0 }}\n\
                     attachment = [0.3, 0.1, 0.2]\nattachment_rotation = {rotation:?}\njoint = [\"{joint}\"]\n"
                )
                .unwrap();
            }
            let description = toml::parse(&Source::new("leaning.toml", text));
            let changes = tree::Changes {
                snap: 0.0,
                ..tree::Changes::default()
            };
            let tree = tree::build_with(&description, &changes).unwrap().tree;
            agrees_with_the_notes(&tree);
        }
    }
}

fn agrees_with_the_notes(tree: &Tree) {
    for function in ["mass_matrix", "bias", "forward_dynamics", "gravity_forces"] {
        let request = request(function);
        let state = |input: Input| match input {
            Input::Q(id) => 0.3 + 0.4 * id.index() as f64,
            Input::U(id) => 1.0 - 0.3 * id.index() as f64,
            Input::Tau(id) => 0.2 + 0.5 * id.index() as f64,
            other => unreachable!("{other:?} is no input of these"),
        };
        let values = |formulation, plan: &Plan| {
            let derived = request.derive(tree, formulation, plan);
            derived.graph.evaluate(&derived.roots, state)
        };
        let expected = values(Formulation::Notes, &Plan::plain(tree));
        for plan in [Plan::plain(tree), Plan::full(tree)] {
            let found = values(Formulation::Recursive, &plan);
            // Some hundred roundings, and a condition below a thousand.
            assert_close(function, &found, &expected, Tolerance::relative(1e-12));
        }
    }
}

#[test]
fn what_momenta_and_weights_may_choose_leaves_their_values() {
    let upward = |gravity: &str, seed: u64| {
        let sizes = Sizes {
            bodies: 5,
            speeds: 9,
        };
        let style = if seed.is_multiple_of(2) {
            Style::Plain
        } else {
            Style::Framed
        };
        let text = RandomSystem::new(500 + seed, sizes, style).toml();
        let lines = text.lines().map(|line| match line.split_once(" = ") {
            Some(("gravity", _)) => format!("gravity = {gravity}\n"),
            _ => format!("{line}\n"),
        });
        systems::tree(&lines.collect::<String>()).unwrap()
    };
    let mut trees = vec![robot("solo12", Base::Free), robot("gripper", Base::Fixed)];
    trees.extend((0..6).map(|seed| upward("[0.0, 0.0, -9.81]", seed)));
    trees.extend((6..12).map(|seed| upward("[0.0, 9.81, 0.0]", seed)));
    for tree in &trees {
        let mut q = vec![0.0; tree.coordinate_names().len()];
        for (kind, id) in tree.bodies.iter().flat_map(|body| body.joint.coordinates()) {
            q[id.index()] = match kind {
                CoordinateKind::EulerParameter(place) => [0.1, -0.7, 0.5, 0.5][place],
                _ => 0.3 + 0.4 * id.index() as f64,
            };
        }
        for function in [
            "gravity_forces",
            "potential_energy",
            "center_of_mass_jacobian",
            "centroidal_momentum_matrix",
        ] {
            let request = request(function);
            let state = |input: Input| match input {
                Input::Q(id) => q[id.index()],
                _ => 0.7,
            };
            let values = |formulation, plan: &Plan| {
                let derived = request.derive(tree, formulation, plan);
                derived.graph.evaluate(&derived.roots, state)
            };
            let expected = values(Formulation::Notes, &Plan::plain(tree));
            for choice in 0..8 {
                let mut plan = Plan::full(tree);
                plan.set(Technique::Shortcut, choice & 1 == 0);
                plan.set(Technique::Levers, choice & 2 == 0);
                plan.set(Technique::Weights, choice & 4 == 0);
                let found = values(Formulation::Recursive, &plan);
                let at = format!("{} {function} {choice}", tree.name);
                // Some hundred roundings.
                assert_close(&at, &found, &expected, Tolerance::relative(1e-12));
            }
        }
    }
}

/// Of two hundred trees; in an ordinary run of the first third.
#[test]
fn no_technique_raises_a_count_that_it_is_meant_to_lower() {
    let none = BTreeSet::new();
    let check = |seed: u64| {
        let sizes = Sizes {
            bodies: usize::try_from(seed % 5 + 1).unwrap(),
            speeds: 10,
        };
        let style = if seed.is_multiple_of(2) {
            Style::Plain
        } else {
            Style::Framed
        };
        let system = RandomSystem::new(1000 + seed, sizes, style);
        let tree = systems::tree(&system.toml()).unwrap();
        let plans = Plans::new(&tree, &none);
        for function in FUNCTIONS {
            let request = request(function);
            let best = compile::cheapest(&plans, &request);
            let best = best.arrangement.plan(0);
            let count = |plan: &Plan| {
                let derived = compile::by_plan(&tree, &request, Formulation::Recursive, plan);
                compile::operations(&derived).total()
            };
            let least = count(best);
            for (name, technique) in of_dynamics() {
                if best.uses(technique) {
                    let without = count(&best.with(technique, false));
                    assert!(
                        least <= without,
                        "seed {seed}, {function}: {least} with `{name}`, {without} without"
                    );
                }
            }
            let plain = count(&Plan::plain(&tree));
            assert!(
                least <= plain,
                "seed {seed}, {function}: {least}, plain {plain}"
            );
        }
    };
    thread::scope(|scope| {
        for first in 0..4 {
            scope.spawn(move || (first..share(200)).step_by(4).for_each(check));
        }
    });
}
