//! Base parameters of random trees and of robots: as many as the rank of the regressor, with the same forces.
#![allow(
    clippy::print_stdout,
    reason = "the largest errors found, shown with --nocapture"
)]

use kane_codegen::{
    base_parameters,
    functions::Formulation,
    tree::{BaseParameter, N_INERTIAL, Tree},
};
use kane_test_support::{
    compare::{assert_within, larger, largest, relative_to},
    dynamics::{Model, State},
    models::{body, build},
    numeric::rank,
    random::Random,
    systems::{RandomSystem, Sizes, Style, trees},
};

use crate::{
    compiled::{robot, written},
    evaluator::Evaluator,
};

/// Factors come from least squares over columns of unit length, whose condition multiplies rounding. Found: 3e-13 here, 5e-12
/// once in 400 other trees.
const PREDICTED: f64 = 1e-12;

/// What is left of a column that others give, beside its length, and what of one that none gives: found are 3e-15 at most, and 2e-4 at
/// least.
const NOTHING: f64 = 1e-8;

/// Those that are tried of sixty random systems.
fn systems() -> impl Iterator<Item = (u64, RandomSystem)> {
    trees::tried(1..=60).map(|seed| {
        let style = if seed % 3 == 0 {
            Style::Plain
        } else {
            Style::Framed
        };
        let bodies = usize::try_from((seed - 1) % 12 + 1).expect("at most 12");
        let sizes = Sizes { bodies, speeds: 24 };
        (seed, RandomSystem::new(seed, sizes, style))
    })
}

/// The function in several states, row below row.
fn rows(model: &Evaluator, function: &str, width: usize) -> Vec<Vec<f64>> {
    let tree = model.tree();
    let n_states = 4 + 2 * N_INERTIAL * tree.bodies.len() / tree.n_speeds;
    let states = (0..n_states as u64).map(|state| State::random(tree, 1000 + state));
    let numbers = states.map(|state| model.evaluate(function, &state));
    let rows = numbers.flat_map(|numbers| {
        let rows: Vec<Vec<f64>> = numbers.chunks_exact(width).map(<[f64]>::to_vec).collect();
        rows
    });
    rows.collect()
}

/// Of arms and of legged robots the numbers that are known: a body adds seven, or ten to a floating base; of an arm on the ground
/// the first ones add fewer.
#[test]
fn robots_have_as_many_base_parameters_as_are_known() {
    for (name, n_base) in [
        ("double_pendulum", 6),
        ("ur5", 36),
        ("panda", 43),
        ("solo12", 10 + 12 * 7),
        ("talos", 10 + 32 * 7),
    ] {
        let tree = robot(name);
        assert_eq!(base_parameters::of(&tree).len(), n_base, "{name}");
    }
}

#[test]
fn base_parameters_of_an_arm_can_be_read() {
    let tree = robot("ur5");
    let texts = base_parameters::of(&tree).iter();
    let texts: Vec<String> = texts
        .map(|base| base_parameters::text(&tree, base))
        .collect();
    insta::assert_snapshot!(texts.join("\n"));
}

/// A double pendulum in the plane across this gravity, its root about the inertial z.
fn pendulum(gravity: &str) -> Vec<String> {
    let bodies = [("arm", "[0.0, 0.0, 0.0]"), ("fore", "[0.7, 0.0, 0.0]")];
    let bodies = bodies.map(|(name, attachment)| {
        body(name, "[\"theta3\"]").replace("[0.0, 0.1, 0.3]", attachment)
    });
    let text = format!(
        "name = \"pendulum\"\ngravity = [{gravity}]\nlower_bodies = [0, 1]\n{}",
        bodies.concat()
    );
    let tree = build(&text).expect("a sound description").tree;
    let base = base_parameters::of(&tree).iter();
    base.map(|base| base_parameters::text(&tree, base))
        .collect()
}

#[test]
fn factors_hold_whatever_gravity_is_set_to() {
    let baked = pendulum("0.0, -9.81, 0.0");
    assert!(baked.contains(&"mcx(arm) + 0.7 m(fore)".to_owned()));
    for gravity in [
        "0.0, { runtime = 0.0 }, 0.0",
        "{ runtime = 0.0 }, { runtime = 0.0 }, { runtime = -9.81 }",
    ] {
        assert_eq!(pendulum(gravity), baked, "{gravity}");
    }
}

/// Three bodies on hinges, the first and the last about this axis: their base parameters.
fn arm(axis: &str) -> Vec<BaseParameter> {
    let lean = format!("\"revolute\"\naxis = {axis}");
    let bodies = [("a", &*lean), ("b", "[\"theta3\"]"), ("c", &*lean)];
    let bodies = bodies.map(|(name, joint)| {
        let turn =
            "attachment_rotation = [[0.6, 0.8, 0.0], [-0.64, 0.48, 0.6], [0.48, -0.36, 0.8]]\n";
        format!("{}{turn}", body(name, joint))
    });
    let text = format!(
        "name = \"arm\"\nlower_bodies = [0, 1, 2]\n{}",
        bodies.concat()
    );
    base_parameters::of(&build(&text).expect("a sound description").tree).to_vec()
}

#[test]
fn rounded_axes_add_no_base_parameters_and_no_huge_factors() {
    let exact = arm("[1.0, 0.0, 0.0]");
    for axis in ["[1.0, 7e-8, 0.0]", "[1.0, -3e-7, 2e-8]", "[1.0, 4e-6, 0.0]"] {
        let leaned = arm(axis);
        assert_eq!(leaned.len(), exact.len(), "{axis}");
        for (_, factor) in leaned.iter().flat_map(|base| &base.terms) {
            assert!(factor.abs() < 10.0, "{axis}: {factor}");
        }
    }
}

/// Those robots whose regressors are small, for the seconds of elimination.
fn robots(formulation: Formulation) -> impl Iterator<Item = Evaluator> {
    let names = ["double_pendulum", "ur5", "panda"].into_iter();
    names.map(move |name| Evaluator::of(name, &written(name), formulation))
}

/// Hinges of which two follow the first, which leans by so little that some columns are a hundred millionth of others.
fn leaned() -> String {
    let follows = |times: f64, axis: &str| {
        format!("\"revolute\"\naxis = {axis}\nmimic = {{ joint = \"a\", multiplier = {times} }}")
    };
    let bodies = [
        ("a", "\"revolute\"\naxis = [0.0, -4e-9, 1.0]".to_owned()),
        (
            "b",
            follows(
                -0.836_090_559_820_408_7,
                "[0.45393777246291744, 0.10975304070087111, 0.061075548214905684]",
            ),
        ),
        ("c", follows(-1.0, "[1.0, 0.0, 0.9]")),
    ];
    let bodies = bodies.iter().zip(TURNS);
    let bodies = bodies.map(|((name, joint), turn)| {
        let own = body(name, joint).replace("[0.0, 0.1, 0.3]", "[0.0, 0.0, 0.0]");
        own + turn
    });
    let bodies: Vec<String> = bodies.collect();
    format!(
        "name = \"leaned\"\ngravity = [0.0, 0.0, -9.81]\nlower_bodies = [0, 1, 2]\n{}",
        bodies.concat()
    )
}

/// A right angle about x and 1.751e-6 rad about z, as exporters write them; and some angle about z.
const TURNS: [&str; 3] = [
    "",
    "attachment_rotation = [[1.0, 1.751e-6, 0.0], [0.0, 0.0, 1.0], [1.751e-6, -1.0, 0.0]]\n",
    "attachment_rotation = [[0.9948425122390266, -0.10143163136784415, 0.0], [0.10143163136784415, 0.9948425122390266, 0.0], [0.0, 0.0, 1.0]]\n",
];

/// The columns that are not zero, over their lengths.
fn unit_columns(rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let n_columns = rows.first().map_or(0, Vec::len);
    let columns = (0..n_columns).map(|column| rows.iter().map(|row| row[column]).collect());
    let most = rows
        .iter()
        .map(Vec::as_slice)
        .map(largest)
        .fold(0.0, larger);
    let columns: Vec<Vec<f64>> = columns.collect();
    let columns = columns.into_iter().map(|column| (largest(&column), column));
    let columns = columns.filter(|(length, _)| *length > 1e-12 * most);
    columns
        .map(|(length, column)| column.iter().map(|entry| entry / length).collect())
        .collect()
}

#[test]
fn base_parameters_are_as_many_as_the_regressor_has_rank() {
    // Values at run time count as any: their nominal ones may be special.
    let baked =
        |system: RandomSystem| Evaluator::new(&system.with_runtime(false), Formulation::Recursive);
    let random = systems().map(|(_, system)| baked(system));
    for model in random.chain(robots(Formulation::Recursive)) {
        let (tree, name) = (model.tree(), model.name());
        let n_base = base_parameters::of(tree).len();
        let whole = unit_columns(&rows(&model, "regressor", N_INERTIAL * tree.bodies.len()));
        assert_eq!(rank(whole, NOTHING), n_base, "{name}, of the regressor");
        if n_base > 0 {
            let base = unit_columns(&rows(&model, "base_regressor", n_base));
            assert_eq!(base.len(), n_base, "{name}");
            assert_eq!(rank(base, NOTHING), n_base, "{name}, of the base regressor");
        }
    }
}

#[test]
fn base_parameters_predict_the_same_forces() {
    let mut most = 0.0;
    for formulation in [Formulation::Notes, Formulation::Recursive] {
        let random = systems().map(|(seed, system)| (seed, Evaluator::new(&system, formulation)));
        let leaned = Evaluator::of("leaned", &leaned(), formulation);
        let others = robots(formulation).chain([leaned]);
        for (seed, model) in random.chain((1..).zip(others)) {
            let tree = model.tree();
            let mut random = Random::new(seed);
            let n_parameters = N_INERTIAL * tree.bodies.len();
            let parameters = random.numbers(n_parameters);
            let base = combined(tree, &parameters);
            let state = State::random(tree, seed);
            let whole = model.evaluate("regressor", &state);
            let own = model.evaluate("base_regressor", &state);
            let (expected, size) = product(&whole, &parameters, tree.n_speeds);
            let (found, _) = product(&own, &base, tree.n_speeds);
            let error = relative_to(size, &found, &expected);
            most = larger(most, assert_within(model.name(), error, PREDICTED));
        }
    }
    println!("largest error {most:e}");
}

fn combined(tree: &Tree, parameters: &[f64]) -> Vec<f64> {
    let base = base_parameters::of(tree).iter();
    let of = |(own, factor): &(kane_codegen::tree::InertialParameter, f64)| {
        factor * parameters[own.column()]
    };
    base.map(|base| base.terms.iter().map(of).sum()).collect()
}

/// The product, and its largest term.
fn product(rows: &[f64], v: &[f64], n_rows: usize) -> (Vec<f64>, f64) {
    if v.is_empty() {
        return (vec![0.0; n_rows], 1.0);
    }
    let mut most = 0.0;
    let products = rows.chunks_exact(v.len()).map(|row| {
        let terms: Vec<f64> = row.iter().zip(v).map(|(a, b)| a * b).collect();
        most = larger(most, largest(&terms));
        terms.iter().sum()
    });
    let products = products.collect();
    (products, if most > 0.0 { most } else { 1.0 })
}
