//! What branches that are alike go through side by side, against each by itself.

use kane_codegen::{
    compile::{self, Options},
    config::Functions,
    description::{Base, Reading},
    expr::Input,
    functions::Formulation,
    passes::branches,
    program::{self, Instruction, Program},
    recursive::{Plan, Technique},
    tree::Tree,
};
use kane_test_support::{
    compare::assert_within,
    dynamics::State,
    random::Random,
    systems::{tree, trees},
};

use crate::{
    compiled::read,
    evaluator::{hoisted, input},
    frames::{INVERTED, relative, request},
};

/// Values, matrices, derivatives by columns in lockstep, and products with a multiplier.
const REQUESTS: [&str; 7] = [
    "inverse_dynamics",
    "forward_dynamics",
    "mass_matrix_inverse",
    "regressor_packed",
    "d(inverse_dynamics)/d(q, u, u_dot)",
    "d(forward_dynamics)/d(q, u, tau)",
    "vjp(inverse_dynamics; q, u, u_dot)",
];

const JOINTS: [&str; 6] = [
    "joint = \"revolute\"\naxis = [0.0, 0.0, 1.0]\n",
    "joint = \"revolute\"\naxis = [1.0, 0.0, 0.0]\n",
    "joint = \"revolute\"\naxis = [0.6, 0.0, 0.8]\n",
    "joint = \"prismatic\"\naxis = [0.0, 1.0, 0.0]\n",
    "joint = \"spherical\"\nchart = \"quaternion\"\n",
    "joint = [\"theta1\", \"theta3\", \"s2\"]\n",
];

/// One number for each axis, of which a branch on the other side may have the mirror image.
fn numbers(random: &mut Random, mirrored: &[f64; 3], scale: f64) -> [f64; 3] {
    mirrored.map(|side| side * random.written(0.2, 1.0) * scale)
}

fn body(random: &mut Random, name: &str, side: f64, joint: &str) -> String {
    let [x, y, z] = numbers(random, &[1.0, side, 1.0], 0.2);
    let [a, b, c] = numbers(random, &[1.0, side, 1.0], 0.4);
    let [xy, yz, xz] = numbers(random, &[side, side, 1.0], 0.02);
    let mass = if random.chance(0.2) {
        "{ runtime = 1.3 }".to_owned()
    } else {
        random.written(0.5, 2.0).to_string()
    };
    format!(
        "\n[[body]]\nname = \"{name}\"\nmass = {mass}\nmass_center = [{x}, {y}, {z}]\n\
         inertia = {{ xx = 0.41, yy = 0.43, zz = 0.47, xy = {xy}, xz = {xz}, yz = {yz} }}\n\
         attachment = [{a}, {b}, {c}]\n{joint}"
    )
}

/// A trunk with so many branches that are alike, every other one a mirror image or with numbers of its own, and one that is not.
fn model(seed: u64, n_branches: usize) -> String {
    let mut random = Random::new(seed);
    let n_bodies = 1 + random.below(3);
    let joints: Vec<&str> = (0..n_bodies).map(|_| JOINTS[random.below(6)]).collect();
    let is_mirrored = random.chance(0.5);
    let mut lowers = vec![0];
    let base = if random.chance(0.3) {
        "joint = \"revolute\"\naxis = [0.0, 1.0, 0.0]\n"
    } else {
        "joint = \"free\"\n"
    };
    let mut bodies = body(&mut random, "trunk", 1.0, base);
    let first = random.clone();
    for branch in 0..n_branches {
        let side = if branch % 2 == 0 { 1.0 } else { -1.0 };
        if is_mirrored {
            random = first.clone();
        }
        for (place, joint) in joints.iter().enumerate() {
            lowers.push(if place == 0 { 1 } else { lowers.len() });
            bodies += &body(&mut random, &format!("b{branch}_{place}"), side, joint);
        }
    }
    lowers.push(1);
    bodies += &body(&mut random, "tail", 1.0, "joint = [\"theta2\", \"s3\"]\n");
    let order = if seed.is_multiple_of(2) {
        "notes"
    } else {
        "body"
    };
    format!(
        "name = \"branches\"\ngravity = [0.3, -0.2, -9.81]\norder = \"{order}\"\nlower_bodies = {lowers:?}\n{bodies}"
    )
}

/// A program with every branch by itself, and with those that are alike side by side; the values that were computed before.
fn both(tree: &Tree, text: &str) -> ([Program; 2], Vec<f64>) {
    let plan = Plan::full(tree);
    let derived = compile::candidate(tree, &request(tree, text), Formulation::Recursive, &plan);
    let (graph, roots, prepared) = hoisted(tree, &derived.graph, &derived.roots);
    let apart = program::flatten(&graph, &roots);
    let (graph, roots) = branches::side_by_side(tree, graph, roots);
    ([apart, program::flatten(&graph, &roots)], prepared)
}

/// How many calls take so many columns.
fn n_calls(program: &Program, n_lanes: usize) -> usize {
    let instructions = program.instructions.iter();
    let calls = instructions.filter(|own| match own {
        Instruction::Call { helper, .. } => program.helpers[*helper].lanes == n_lanes,
        _ => false,
    });
    calls.count()
}

#[test]
fn branches_side_by_side_compute_the_same_bits() {
    let mut n_with_calls = 0;
    for seed in trees::tried(701..=740) {
        // Columns go four at a time.
        let n_branches = [3, 5, 6][Random::new(seed).below(3)];
        let tree = tree(&model(seed, n_branches)).expect("it is accepted");
        let state = State::random(&tree, seed);
        for text in REQUESTS {
            let ([apart, beside], prepared) = both(&tree, text);
            let given = |own: Input| match own {
                Input::Prepared(place) => prepared[place],
                own => input(&tree, &state, own),
            };
            let what = format!("{seed}, {text}");
            assert_eq!(program::verify(&beside), Ok(()), "{what}");
            assert_eq!(beside.operations(), apart.operations(), "{what}");
            let [expected, found] = [&apart, &beside].map(|own| own.evaluate(given));
            assert!(expected.iter().all(|number| number.is_finite()), "{what}");
            // All but the sign of a zero.
            assert_eq!(found, expected, "{what}");
            let is_called = n_calls(&beside, n_branches) > 0;
            assert_eq!(is_called, beside.written() < apart.written(), "{what}");
            n_with_calls += usize::from(is_called);
            let fused = program::fuse(beside);
            assert_eq!(program::verify(&fused), Ok(()), "{what}");
            // Rounded once where the others round twice.
            let fused = fused.evaluate(given);
            assert_within(&what, relative(&fused, &expected), INVERTED);
        }
    }
    let least = trees::least(150);
    assert!(
        u64::try_from(n_with_calls).unwrap() > least,
        "{n_with_calls} functions have calls"
    );
}

#[test]
fn two_branches_and_those_of_other_joints_stay_as_they_are() {
    let two = tree(&model(3, 2)).expect("it is accepted");
    let three = model(5, 3);
    // The last branch has a joint of another kind.
    let last = three.rfind("\n[[body]]\nname = \"b2_").unwrap();
    let joint = last + three[last..].find("joint = ").unwrap();
    let tail = three.rfind("\n[[body]]\nname = \"tail\"").unwrap();
    let text = format!(
        "{}joint = [\"theta2\"]\n{}",
        &three[..joint],
        &three[tail..]
    );
    let unlike = tree(&text).expect("it is accepted");
    for tree in [two, unlike] {
        for text in REQUESTS {
            let ([apart, beside], _) = both(&tree, text);
            assert_eq!(beside.helpers.len(), apart.helpers.len(), "{text}");
            assert_eq!(beside.written(), apart.written(), "{text}");
        }
    }
}

#[test]
fn a_quadruped_s_legs_are_written_once() {
    let reading = Reading {
        base: Some(Base::Free),
        ..Reading::default()
    };
    let tree = read("tests/robots/solo12/solo12.urdf", &reading);
    let written = |text| {
        let ([apart, beside], _) = both(&tree, text);
        format!("{} of {}", beside.written(), apart.written())
    };
    // Legs on both sides, mirror images of one another: all but what they give the trunk and take from it.
    insta::assert_snapshot!(written("inverse_dynamics"), @"406 of 1189");
    insta::assert_snapshot!(written("d(inverse_dynamics)/d(q, u, u_dot)"), @"1541 of 4490");
    insta::assert_snapshot!(written("regressor_packed"), @"878 of 2831");
}

#[test]
fn long_functions_alone_have_branches_side_by_side() {
    let reading = Reading {
        base: Some(Base::Free),
        ..Reading::default()
    };
    let tree = read("tests/robots/solo12/solo12.urdf", &reading);
    let helpers = |without: &[Technique]| {
        let options = Options {
            functions: Functions::Named(vec![REQUESTS[0].to_owned(), REQUESTS[4].to_owned()]),
            without: without.iter().copied().collect(),
            ..Options::default()
        };
        let compiled = compile::compile(&tree, &options).unwrap();
        let functions = compiled.functions.into_iter();
        // The rates of coordinates are always there.
        let asked_for = functions.filter(|own| own.operations.total() > 100);
        asked_for
            .map(|own| own.program.helpers.len())
            .collect::<Vec<_>>()
    };
    let [short, long] = helpers(&[])[..] else {
        panic!("two functions are asked for");
    };
    assert_eq!(short, 0);
    assert!(long > 0);
    assert_eq!(helpers(&[Technique::Lockstep]), [0, 0]);
}
