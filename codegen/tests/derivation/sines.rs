//! Functions that are given the sines and cosines of the angles among the coordinates.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::{collections::BTreeSet, fs};

use kane_codegen::{
    config::Functions,
    description::{Base, Chart, Reading, no_includes},
    diagnostic::Source,
    expr::{ExprGraph, Input, Node},
    functions::Request,
    generate::{Generated, generate},
    id::{BodyId, CoordinateId, ParameterId},
    options::Options,
    passes::{
        hoist::{self, Preparation},
        sines,
    },
    report,
    tree::{Angle, Tree},
};
use kane_test_support::compare::{Tolerance, assert_close};

use crate::compiled::{built, compiled, read};

const FUNCTIONS: [&str; 10] = [
    "rotation",
    "mass_matrix",
    "bias",
    "inverse_dynamics",
    "forward_dynamics",
    "gravity_forces",
    "mass_matrix+bias",
    "partial_velocity_dot",
    "d(rotation)/d(q)",
    "d(linear_momentum)/d(q)",
];

/// A hinge, one that follows it the other way round with an offset, one that follows it twice as fast.
const FOLLOWERS: &str = r#"
name = "followers"
gravity = [0.3, -0.2, -9.81]
lower_bodies = [0, 1, 2]

[[body]]
name = "first"
mass = 1.5
mass_center = [0.1, 0.2, 0.3]
inertia = { xx = 0.4, yy = 0.5, zz = 0.6, xy = 0.01, xz = 0.02, yz = -0.03 }
attachment = [0.0, 0.1, 0.2]
joint = ["theta2"]

[[body]]
name = "second"
mass = 1.2
mass_center = [-0.1, 0.15, 0.25]
inertia = { xx = 0.3, yy = 0.4, zz = 0.5, xy = 0.02, xz = 0.01, yz = 0.03 }
attachment = [0.2, 0.0, 0.3]
joint = ["theta1"]
mimic = { joint = "first", multiplier = MULTIPLIER, offset = OFFSET }

[[body]]
name = "third"
mass = 0.7
mass_center = [0.05, -0.15, 0.2]
inertia = { xx = 0.2, yy = 0.25, zz = 0.3, xy = 0.0, xz = 0.01, yz = 0.02 }
attachment = [0.1, 0.3, -0.1]
joint = ["theta1", "theta3", "s2"]
"#;

fn followers(multiplier: f64, offset: f64) -> Tree {
    let text = FOLLOWERS
        .replace("MULTIPLIER", &format!("{multiplier:?}"))
        .replace("OFFSET", &format!("{offset:?}"));
    built("followers.toml", text, &Reading::default())
}

fn own(path: &str) -> Tree {
    read(path, &Reading::default())
}

/// Models in which no angle is a sum or multiple of others.
fn plain_models() -> Vec<Tree> {
    let robot = |name: &str, base, chart| {
        let path = format!("tests/robots/{name}/{name}.urdf");
        read(
            &path,
            &Reading {
                base: Some(base),
                chart,
                ..Reading::default()
            },
        )
    };
    vec![
        own("codegen/tests/models/cart_pole.toml"),
        own("codegen/tests/models/pendulum.toml"),
        own("models/eight_body.toml"),
        robot("panda", Base::Fixed, None),
        robot("ur5", Base::Fixed, None),
        robot("solo12", Base::Free, None),
        robot("solo12", Base::Free, Some(Chart::Angles)),
    ]
}

fn both(function: &str) -> [String; 2] {
    [function.to_owned(), format!("{function}(sin_cos)")]
}

#[test]
fn values_have_the_bits_of_the_function_that_computes_its_sines() {
    let mut n_same = 0;
    for tree in plain_models() {
        for function in FUNCTIONS {
            let [plain, given] = both(function);
            let found = compiled(&tree, &[&plain, &given]);
            let (values, expected) = (&found[&given].1, &found[&plain].1);
            let (given, plain) = (found[&given].0.operations, found[&plain].0.operations);
            assert_eq!(given.trig, 0, "{} {function}", tree.name);
            // Sums of angles may make another plan the cheaper one.
            if given.total() == plain.total() - plain.trig {
                n_same += 1;
                assert_eq!(values, expected, "{} {function}", tree.name);
            } else {
                assert!(given.total() > plain.total() - plain.trig, "{function}");
                // Where axes are parallel, sines of sums were computed.
                let most = plain.total() + plain.total() / 4;
                let at = format!("{} {function}: {plain:?}, {given:?}", tree.name);
                assert!(given.total() <= most, "{at}");
                assert_close(at, values, expected, Tolerance::relative(1e-12));
            }
        }
    }
    assert!(n_same > 2, "{n_same} have the same plan");
}

#[test]
fn angles_that_follow_others_one_to_one_are_taken_apart_by_the_addition_theorems() {
    let right = std::f64::consts::FRAC_PI_2;
    for (multiplier, offset) in [(1.0, 0.4), (-1.0, -0.7), (-1.0, 0.0), (1.0, right)] {
        let tree = followers(multiplier, offset);
        for function in FUNCTIONS {
            let [plain, given] = both(function);
            let found = compiled(&tree, &[&plain, &given]);
            assert_eq!(found[&given].0.operations.trig, 0, "{function}");
            let (values, expected) = (&found[&given].1, &found[&plain].1);
            let at = format!("{multiplier} {offset} {function}");
            assert_close(at, values, expected, Tolerance::relative_beyond(1.0, 1e-13));
        }
    }
}

#[test]
fn an_angle_that_follows_another_with_a_ratio_is_computed_from_q() {
    let tree = followers(2.0, 0.4);
    for function in FUNCTIONS {
        let [plain, given] = both(function);
        let found = compiled(&tree, &[&plain, &given]);
        assert_eq!(found[&given].0.operations.trig, 2, "{function}");
        let (values, expected) = (&found[&given].1, &found[&plain].1);
        // A joined function makes it of the sine and cosine of the other, and where sines are inputs other values are reused.
        assert_close(function, values, expected, Tolerance::relative(1e-13));
    }
}

#[test]
fn sums_of_angles_and_parameters_keep_their_values_and_parameters_leave_the_loop() {
    let mut graph = ExprGraph::default();
    let coordinate = CoordinateId::new;
    let q = [0, 1, 2].map(|place| graph.input(Input::Q(coordinate(place))));
    let parameter = graph.input(Input::Parameter(ParameterId::new(0)));
    let number = graph.number(0.3);
    let both = graph.sub(q[0], q[1]);
    let with_number = graph.add(both, number);
    let with_parameter = graph.sub(parameter, with_number);
    let product = graph.mul(q[0], q[1]);
    let beside_other = graph.add(q[0], q[2]);
    let angles = [both, with_number, with_parameter, product, beside_other];
    let roots: Vec<_> = angles
        .into_iter()
        .flat_map(|angle| [graph.sin(angle), graph.cos(angle)])
        .collect();
    // The third coordinate is no angle.
    let known = [0, 1].map(|place| Angle {
        coordinate: coordinate(place),
        body: BodyId::new(0),
        axis: 0,
    });
    let (given, given_roots) = sines::run(&graph, &roots, &known);
    let q = [0.7, -1.9, 2.3];
    let value = |input: Input| match input {
        Input::Q(id) => q[id.index()],
        Input::Sine(place) => libm::sin(q[place]),
        Input::Cosine(place) => libm::cos(q[place]),
        Input::Parameter(_) => 0.9,
        other => unreachable!("{other:?}"),
    };
    let (found, expected) = (
        given.evaluate(&given_roots, value),
        graph.evaluate(&roots, value),
    );
    for (place, (found, expected)) in found.iter().zip(&expected).enumerate() {
        assert!((found - expected).abs() < 4.0 * f64::EPSILON, "{place}");
    }
    let (hoisted, hoisted_roots) =
        hoist::run(&given, &given_roots, "f", &mut Preparation::default());
    let needed = hoisted.reachable(&hoisted_roots);
    let nodes = hoisted.ids().filter(|id| needed[id.index()]);
    let nodes: Vec<Node> = nodes.map(|id| hoisted.node(id)).collect();
    let is_sine = |node: &&Node| matches!(node, Node::Sin(_) | Node::Cos(_));
    // Those of the product, and those beside what is no angle.
    assert_eq!(nodes.iter().filter(is_sine).count(), 4);
    let is_parameter = |node: &Node| matches!(node, Node::Input(Input::Parameter(_)));
    assert!(!nodes.iter().any(is_parameter));
}

fn module(model: &str, functions: &[&str]) -> Generated {
    let path = format!("{}/tests/models/{model}.toml", env!("CARGO_MANIFEST_DIR"));
    let source = Source::new("model.toml", fs::read_to_string(path).unwrap());
    let options = Options {
        functions: Functions::Named(functions.iter().map(ToString::to_string).collect()),
        ..Options::default()
    };
    generate(&source, "models/model.toml", &options, &no_includes).unwrap()
}

#[test]
fn a_cart_pole_s_bias_at_sines_and_cosines() {
    let text = module("cart_pole", &["bias(sin_cos)"]).source;
    let start = text.find("/// Number of angles").unwrap();
    let (items, rest) = text[start..]
        .split_once("/// Rates of the coordinates")
        .unwrap();
    let (_, bias) = rest.split_once("\n}\n\n").unwrap();
    insta::assert_snapshot!(format!("{items}{bias}"));
}

#[test]
fn a_pattern_of_partitions_stands_once_beside_both_functions_that_write_its_columns() {
    for functions in [
        &["partial_velocity(sin_cos)"][..],
        &["partial_velocity", "partial_velocity(sin_cos)"],
    ] {
        let text = module("cart_pole", functions).source;
        let constant = "pub const PARTIAL_VELOCITY_COLUMNS: usize";
        assert_eq!(text.matches(constant).count(), 1, "{functions:?}");
    }
}

#[test]
fn the_type_of_sines_and_cosines_stands_only_where_a_function_is_given_them() {
    let text = module("cart_pole", &["bias", "mass_matrix+bias"]).source;
    assert!(!text.contains("SinCos"), "{text}");
    let text = module("cart_pole", &["bias(sin_cos)", "mass_matrix+bias(sin_cos)"]).source;
    assert_eq!(text.matches("pub struct SinCos<R>").count(), 1);
    let functions = text.lines().filter_map(|line| line.strip_prefix("pub fn "));
    let names: Vec<&str> = functions
        .map(|line| line.split('<').next().unwrap())
        .collect();
    let expected = [
        "sin_cos",
        "q_dot",
        "mass_matrix_and_bias_at_sin_cos",
        "bias_at_sin_cos",
    ];
    assert_eq!(names, expected);
}

#[test]
fn counts_are_those_of_what_is_generated() {
    for tree in [followers(-1.0, 0.3), own("models/cart_pole.toml")] {
        for function in FUNCTIONS {
            let [_, given] = both(function);
            let counted = [Request::parse(&given).unwrap()];
            let counts = &report::count(&tree, &counted, &BTreeSet::new())[0];
            let found = &compiled(&tree, &[&given])[&given].0;
            let stated = counts.formulations.iter();
            let (_, stated) = stated
                .clone()
                .find(|(f, _)| *f == found.formulation)
                .unwrap();
            assert_eq!(counts.cheapest, Some(found.formulation), "{function}");
            let totals = counts.formulations.iter().map(|(_, o)| o.total());
            assert_eq!(totals.min(), Some(found.operations.total()), "{function}");
            assert_eq!(*stated, found.operations, "{function}");
        }
    }
}
