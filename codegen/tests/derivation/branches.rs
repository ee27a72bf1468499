//! What branches that are alike go through side by side, against each by itself.

use std::collections::BTreeSet;

use kane_codegen::{
    compile,
    config::Functions,
    expr::{Expr, ExprGraph, Input},
    functions::{Formulation, Request},
    options::Options,
    passes::branches,
    program::{self, Program},
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
    compiled::robot,
    evaluator::{hoisted, input},
    frames::{INVERTED, relative, request},
};

/// Values, matrices, derivatives by columns in lockstep, products with directions and multipliers, sines as arguments.
const REQUESTS: [&str; 9] = [
    "inverse_dynamics",
    "forward_dynamics",
    "mass_matrix_inverse",
    "regressor_packed",
    "inverse_dynamics(sin_cos)",
    "d(inverse_dynamics)/d(q, u, u_dot)",
    "d(forward_dynamics)/d(q, u, tau)",
    "jvp(forward_dynamics; q, u, tau)",
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

/// Which branches a model has.
struct Shape {
    /// How many are alike, on a trunk or on the ground.
    n_branches: usize,
    is_on_ground: bool,
    /// Every other one is a mirror image; else each has numbers of its own.
    is_mirrored: bool,
    /// The last joint of each mimics another.
    is_following: bool,
    /// How many fingers are alike at the end of each.
    n_fingers: usize,
    /// How many branches of another kind there are.
    n_others: usize,
}

impl Shape {
    fn random(random: &mut Random) -> Self {
        Self {
            n_branches: [3, 5, 6, 9, 11][random.below(5)],
            is_on_ground: random.chance(0.2),
            is_mirrored: random.chance(0.5),
            is_following: random.chance(0.2),
            n_fingers: if random.chance(0.2) { 3 } else { 0 },
            n_others: [0, 1, 4][random.below(3)],
        }
    }
}

/// Bodies as they are added.
struct Bodies {
    random: Random,
    lowers: Vec<usize>,
    text: String,
}

impl Bodies {
    fn new(random: Random) -> Self {
        Self {
            random,
            lowers: Vec::new(),
            text: String::new(),
        }
    }

    fn model(&self, order: &str) -> String {
        let Self { lowers, text, .. } = self;
        format!(
            "name = \"branches\"\ngravity = [0.3, -0.2, -9.81]\norder = \"{order}\"\nlower_bodies = {lowers:?}\n{text}"
        )
    }

    /// A body on this one; its number.
    fn add(&mut self, lower: usize, side: f64, joint: &str) -> usize {
        self.lowers.push(lower);
        let number = self.lowers.len();
        self.text += &body(&mut self.random, &format!("b{number}"), side, joint);
        number
    }

    /// A branch with these joints.
    fn branch(&mut self, lower: usize, side: f64, joints: &[&str], shape: &Shape) {
        let mut last = lower;
        for joint in joints {
            last = self.add(last, side, joint);
        }
        if shape.is_following {
            let leader = self.add(last, side, JOINTS[0]);
            let mimic = format!(
                "{}mimic = {{ joint = \"b{leader}\", multiplier = 0.8, offset = 0.1 }}\n",
                JOINTS[1]
            );
            last = self.add(leader, side, &mimic);
        }
        for _ in 0..shape.n_fingers {
            self.add(last, side, JOINTS[2]);
        }
    }
}

fn model(seed: u64, shape: &Shape) -> String {
    let mut random = Random::new(seed);
    let n_joints = 1 + random.below(if shape.n_branches > 6 { 2 } else { 3 });
    let joints: Vec<&str> = (0..n_joints).map(|_| JOINTS[random.below(6)]).collect();
    let base = if random.chance(0.3) {
        "joint = \"revolute\"\naxis = [0.0, 1.0, 0.0]\n"
    } else {
        "joint = \"free\"\n"
    };
    let mut bodies = Bodies::new(random);
    let trunk = bodies.add(0, 1.0, base);
    let lower = if shape.is_on_ground { 0 } else { trunk };
    let first = bodies.random.clone();
    for branch in 0..shape.n_branches {
        let side = if branch % 2 == 0 { 1.0 } else { -1.0 };
        if shape.is_mirrored {
            bodies.random = first.clone();
        }
        bodies.branch(lower, side, &joints, shape);
    }
    for _ in 0..shape.n_others {
        bodies.add(lower, 1.0, "joint = [\"theta2\", \"s3\"]\n");
    }
    let order = if seed.is_multiple_of(2) {
        "notes"
    } else {
        "body"
    };
    bodies.model(order)
}

/// A function before the pass, and the values that were computed before.
struct Function {
    request: Request,
    graph: ExprGraph,
    roots: Vec<Expr>,
    prepared: Vec<f64>,
}

impl Function {
    fn of(tree: &Tree, text: &str) -> Self {
        Self::by(tree, text, &Plan::full(tree))
    }

    fn by(tree: &Tree, text: &str, plan: &Plan) -> Self {
        let request = request(tree, text);
        let derived = compile::by_plan(tree, &request, Formulation::Recursive, plan);
        let (graph, roots, prepared) = hoisted(tree, &derived.graph, &derived.roots);
        Self {
            request,
            graph,
            roots,
            prepared,
        }
    }

    fn beside(&self, tree: &Tree) -> Option<(ExprGraph, Vec<Expr>)> {
        let arguments = self.request.arguments();
        branches::run(tree, &arguments, &self.graph, &self.roots)
    }

    fn given(&self, tree: &Tree, state: &State, own: Input) -> f64 {
        match own {
            Input::Prepared(place) => self.prepared[place],
            own => input(tree, state, own),
        }
    }
}

/// A program with every branch by itself, and with those that are alike side by side.
fn both(tree: &Tree, function: &Function) -> [Program; 2] {
    let apart = program::flatten(&function.graph, &function.roots);
    let beside = match function.beside(tree) {
        Some((graph, roots)) => program::flatten(&graph, &roots),
        None => apart.clone(),
    };
    [apart, beside]
}

#[test]
fn branches_side_by_side_compute_the_same_bits() {
    let mut n_with_calls = [0; REQUESTS.len()];
    for seed in trees::tried(701..=740) {
        let shape = Shape::random(&mut Random::new(seed));
        let tree = tree(&model(seed, &shape)).expect("it is accepted");
        let state = State::random(&tree, seed);
        for (place, text) in REQUESTS.into_iter().enumerate() {
            let function = Function::of(&tree, text);
            let [apart, beside] = both(&tree, &function);
            let given = |own: Input| function.given(&tree, &state, own);
            let what = format!("{seed}, {text}");
            assert_eq!(program::verify(&beside), Ok(()), "{what}");
            assert_eq!(beside.operations(), apart.operations(), "{what}");
            let [expected, found] = [&apart, &beside].map(|own| own.evaluate(given));
            assert!(expected.iter().all(|number| number.is_finite()), "{what}");
            // All but the sign of a zero.
            assert_eq!(found, expected, "{what}");
            let is_shorter = beside.written() < apart.written();
            let is_called = beside.helpers.len() > apart.helpers.len();
            assert_eq!(is_called, is_shorter, "{what}");
            n_with_calls[place] += usize::from(is_called);
            let fused = program::fuse(beside);
            assert_eq!(program::verify(&fused), Ok(()), "{what}");
            // Rounded once where the others round twice.
            let fused = fused.evaluate(given);
            assert_within(&what, relative(&fused, &expected), INVERTED);
        }
    }
    for (text, n) in REQUESTS.into_iter().zip(n_with_calls) {
        let n = u64::try_from(n).unwrap();
        assert!(n > trees::least(20), "{text}: {n} have calls");
    }
}

#[test]
fn many_branches_and_those_within_branches_go_in_teams() {
    let shape = Shape {
        n_branches: 11,
        is_on_ground: false,
        is_mirrored: false,
        is_following: true,
        n_fingers: 3,
        n_others: 4,
    };
    let lanes = |shape: &Shape| {
        let tree = tree(&model(5, shape)).expect("it is accepted");
        let [_, beside] = both(&tree, &Function::of(&tree, "inverse_dynamics"));
        let helpers = beside.helpers.iter();
        helpers.map(|helper| helper.lanes).collect::<BTreeSet<_>>()
    };
    // Eleven are five and six, with their fingers; the others are four.
    assert_eq!(lanes(&shape), BTreeSet::from([4, 5, 6]));
    // Two are a team, and so are their fingers: those of both go together.
    let two = Shape {
        n_branches: 2,
        ..shape
    };
    assert_eq!(lanes(&two), BTreeSet::from([2, 4]));
}

#[test]
fn children_of_the_same_kinds_are_alike_in_any_order() {
    let hinge = "joint = \"revolute\"\naxis = [0.6, 0.0, 0.8]\n";
    let slide = "joint = \"prismatic\"\naxis = [0.6, 0.0, 0.8]\n";
    let written = |turned: [bool; 4]| {
        let mut bodies = Bodies::new(Random::new(3));
        let trunk = bodies.add(0, 1.0, "joint = \"free\"\n");
        for is_turned in turned {
            let hip = bodies.add(trunk, 1.0, hinge);
            let (one, other) = if is_turned {
                (slide, hinge)
            } else {
                (hinge, slide)
            };
            bodies.add(hip, 1.0, one);
            bodies.add(hip, 1.0, other);
        }
        let tree = tree(&bodies.model("body")).expect("it is accepted");
        let [apart, beside] = both(&tree, &Function::of(&tree, "inverse_dynamics"));
        assert!(beside.written() < apart.written());
        beside.helpers.len()
    };
    assert_eq!(written([false; 4]), written([false, true, false, true]));
}

/// Six chains of so many hinges on a body that floats.
fn chains(n_bodies: usize) -> Tree {
    let mut bodies = Bodies::new(Random::new(3));
    let trunk = bodies.add(0, 1.0, "joint = \"free\"\n");
    for _ in 0..6 {
        let mut last = trunk;
        for place in 0..n_bodies {
            last = bodies.add(last, 1.0, JOINTS[place % 3]);
        }
    }
    tree(&bodies.model("body")).expect("it is accepted")
}

#[test]
fn branches_of_more_than_32_bodies_stay_apart() {
    let is_beside = |n_bodies| {
        let tree = chains(n_bodies);
        let function = Function::of(&tree, "inverse_dynamics");
        function.beside(&tree).is_some()
    };
    assert!(is_beside(32));
    assert!(!is_beside(33));
}

#[test]
fn all_that_long_branches_go_through_is_one_call() {
    let tree = chains(32);
    let state = State::random(&tree, 3);
    let function = Function::of(&tree, "inverse_dynamics");
    let (graph, roots) = function.beside(&tree).expect("they are alike");
    let given = |own: Input| function.given(&tree, &state, own);
    let expected: Vec<f64> = function.graph.evaluate(&function.roots, given);
    let found: Vec<f64> = graph.evaluate(&roots, given);
    assert!(expected.iter().all(|number| number.is_finite()));
    assert_eq!(found, expected);
    assert_eq!(graph.next_lockstep(), 1);
}

#[test]
fn branches_of_other_joints_stay_as_they_are() {
    let shape = Shape {
        n_branches: 2,
        is_on_ground: false,
        is_mirrored: true,
        is_following: false,
        n_fingers: 0,
        n_others: 1,
    };
    let alike = model(5, &shape);
    // The last branch ends in a joint of another kind.
    let ends: Vec<usize> = alike.match_indices("joint = ").map(|(at, _)| at).collect();
    let [.., joint, _] = ends[..] else {
        panic!("it has bodies")
    };
    let rest = joint + alike[joint..].find("\n[[body]]").unwrap();
    let text = format!(
        "{}joint = [\"theta2\"]\n{}",
        &alike[..joint],
        &alike[rest..]
    );
    let n_helpers = |text: &str, request| {
        let tree = tree(text).expect("it is accepted");
        both(&tree, &Function::of(&tree, request)).map(|own| own.helpers.len())
    };
    for request in REQUESTS {
        let [apart, beside] = n_helpers(&text, request);
        assert_eq!(beside, apart, "{request}");
        let [apart, beside] = n_helpers(&alike, request);
        assert!(beside > apart, "{request}");
    }
}

#[test]
fn a_quadruped_s_legs_are_written_once() {
    let tree = robot("solo12");
    let [lockstep, one_by_one] =
        [true, false].map(|own| Plan::full(&tree).with(Technique::Lockstep, own));
    let by = |text, plan| {
        let [apart, beside] = both(&tree, &Function::by(&tree, text, plan));
        format!("{} of {}", beside.written(), apart.written())
    };
    let written = |text| by(text, &one_by_one);
    // Legs on both sides, mirror images of one another: all but what they give the trunk and take from it.
    insta::assert_snapshot!(written("inverse_dynamics"), @"406 of 1189");
    insta::assert_snapshot!(written("d(inverse_dynamics)/d(q, u, u_dot)"), @"1484 of 4727");
    // Behind the calls that solve for accelerations legs go on side by side.
    insta::assert_snapshot!(by("d(forward_dynamics)/d(q, u, tau)", &lockstep), @"5099 of 8981");
    insta::assert_snapshot!(written("regressor_packed"), @"878 of 2831");
}

#[test]
fn long_functions_alone_have_branches_side_by_side() {
    let tree = robot("solo12");
    let helpers = |without: &[Technique]| {
        let options = Options {
            functions: Functions::Named(vec![
                "inverse_dynamics".to_owned(),
                "d(inverse_dynamics)/d(q, u, u_dot)".to_owned(),
            ]),
            without: without.iter().copied().collect(),
            ..Options::default()
        };
        let compiled = compile::compile(&tree, &options).unwrap();
        let functions = compiled.functions.into_iter();
        let asked_for = functions.filter(|own| own.request.text().contains("inverse_dynamics"));
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
