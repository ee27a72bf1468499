//! Columns that go through one text four at a time, against columns one by one.

use std::fmt::Write as _;

use kane_codegen::{
    compile,
    description::{Base, Reading},
    expr::{Input, LANES},
    functions::{Derived, Formulation},
    program::{self, Instruction, Program, ValueId, VerifyError},
    recursive::{Plan, Technique},
    tree::Tree,
};
use kane_test_support::{
    compare::assert_within,
    dynamics::State,
    systems::{tree, trees},
};

use crate::{
    compiled::read,
    derivatives::INVERTED,
    evaluator::{hoisted, input},
    frames::{relative, request, system},
    hybrid::prescribing,
};

/// One set of columns, two of them in one function, columns without what the tree makes zero, those of the inverse, what has calls
/// beside a sweep that goes through none, and columns of the free speeds alone.
const REQUESTS: [&str; 7] = [
    "d(forward_dynamics)/d(q, u, tau)",
    "forward_dynamics+d(forward_dynamics)/d(u, q)+d(loaded_forward_dynamics)/d(q)",
    "packed(d(forward_dynamics)/d(q, u))",
    "d(inverse_dynamics)/d(q, u, u_dot)",
    "mass_matrix_inverse",
    "mass_matrix_inverse_packed+vjp(mass_matrix_inverse_packed; q)",
    "d(hybrid_dynamics)/d(q, u, u_dot, tau)",
];

fn derived(tree: &Tree, text: &str, plan: &Plan) -> Derived {
    compile::by_plan(tree, &request(tree, text), Formulation::Recursive, plan)
}

/// All one by one, and the ways in which columns go together: those that are solved for, and those that pass inward too.
fn plans(tree: &Tree) -> [Plan; 3] {
    let lockstep = Plan::full(tree);
    [
        lockstep.with(Technique::Lockstep, false),
        lockstep.clone(),
        lockstep.with_calls_twice(true),
    ]
}

/// What is emitted, and the values that were computed before.
fn emitted(tree: &Tree, derived: &Derived) -> (Program, Vec<f64>) {
    let (graph, roots, prepared) = hoisted(tree, &derived.graph, &derived.roots);
    (program::flatten(&graph, &roots), prepared)
}

fn n_calls(program: &Program) -> usize {
    let instructions = program.instructions.iter();
    let calls = instructions.filter(|own| matches!(own, Instruction::Call { .. }));
    calls.count()
}

#[test]
fn columns_in_lockstep_are_those_one_by_one() {
    let mut n_with_calls = [[0; REQUESTS.len()]; 2];
    for seed in trees::tried(561..=584) {
        let (_, tree) = system(seed);
        let tree = prescribing(&tree, |body| body % 4 == 3);
        let state = State::random(&tree, seed);
        let given = |own: Input| input(&tree, &state, own);
        let [one_by_one, together @ ..] = plans(&tree);
        for (place, text) in REQUESTS.into_iter().enumerate() {
            let one_by_one = derived(&tree, text, &one_by_one);
            let expected = one_by_one.graph.evaluate(&one_by_one.roots, given);
            for (way, plan) in together.iter().enumerate() {
                let lockstep = derived(&tree, text, plan);
                let found = lockstep.graph.evaluate(&lockstep.roots, given);
                let what = format!("{seed}, {text}, way {way}");
                // The same rows of factors, some of them before and some after what lies between was eliminated.
                assert_within(&what, relative(&found, &expected), INVERTED);
                let (program, prepared) = emitted(&tree, &lockstep);
                assert_eq!(
                    program.operations(),
                    compile::operations(&lockstep),
                    "{what}"
                );
                n_with_calls[way][place] += usize::from(n_calls(&program) > 0);
                for program in [program.clone(), program::fuse(program)] {
                    assert_eq!(program::verify(&program), Ok(()), "{what}");
                    let own = program.evaluate(|own| match own {
                        Input::Prepared(place) => prepared[place],
                        own => given(own),
                    });
                    assert_within(&what, relative(&own, &found), INVERTED);
                }
            }
        }
    }
    let mut all = n_with_calls.iter().flatten();
    assert!(
        all.all(|n| *n > 1),
        "functions with calls: {n_with_calls:?}"
    );
}

/// A floating arm of twelve hinges about different axes.
fn arm() -> Tree {
    let n_bodies = 13_u8;
    let lower: Vec<u8> = (0..n_bodies).collect();
    let mut text =
        format!("name = \"arm\"\ngravity = [0.1, 0.2, -9.81]\nlower_bodies = {lower:?}\n");
    for body in 1..=n_bodies {
        let [a, b, c, d] = [0.3, 0.35, 0.4, 0.01].map(|own| own + f64::from(body) / 1000.0);
        let axis = [
            "1.0, 0.0, 0.0",
            "0.0, 1.0, 0.0",
            "0.0, 0.0, 1.0",
            "0.6, 0.0, 0.8",
        ][usize::from(body % 4)];
        let joint = if body == 1 {
            "joint = \"free\"\nchart = \"quaternion\"".to_owned()
        } else {
            format!("joint = \"revolute\"\naxis = [{axis}]")
        };
        writeln!(
            text,
            "\n[[body]]\nname = \"b{body}\"\nmass = {a}\nmass_center = [{a}, {b}, {c}]\n\
            inertia = {{ xx = {a}, yy = {b}, zz = {c}, xy = {d}, xz = {d}, yz = {d} }}\n\
            attachment = [{b}, {c}, {a}]\n{joint}"
        )
        .expect("a String takes any text");
    }
    tree(&text).expect("a right description")
}

#[test]
fn hinges_that_begin_alike_are_those_one_by_one() {
    let tree = arm();
    let state = State::random(&tree, 7);
    let given = |own: Input| input(&tree, &state, own);
    let [one_by_one, _, twice] = plans(&tree);
    for text in ["d(inverse_dynamics)/d(q, u, u_dot)", REQUESTS[0]] {
        let one_by_one = derived(&tree, text, &one_by_one);
        let together = derived(&tree, text, &twice);
        let expected = one_by_one.graph.evaluate(&one_by_one.roots, given);
        let found = together.graph.evaluate(&together.roots, given);
        assert_within(text, relative(&found, &expected), INVERTED);
        let (program, _) = emitted(&tree, &together);
        assert_eq!(program::verify(&program), Ok(()), "{text}");
    }
    let (program, _) = emitted(
        &tree,
        &derived(&tree, "d(inverse_dynamics)/d(q, u, u_dot)", &twice),
    );
    let mut n_calls = vec![0; program.helpers.len()];
    for own in &program.instructions {
        if let Instruction::Call { helper, .. } = own {
            n_calls[*helper] += 1;
        }
    }
    // Eight of twelve are alike, whatever their axes; what passes inward from different links has helpers of its own.
    assert!(n_calls.contains(&2), "{n_calls:?}");
}

/// The humanoid: its legs, its arms and its trunk are columns of different helpers.
fn humanoid() -> Tree {
    let reading = Reading {
        base: Some(Base::Free),
        ..Reading::default()
    };
    read("tests/robots/talos/talos.urdf", &reading)
}

#[test]
fn calls_count_for_every_lane_and_their_text_once() {
    let tree = humanoid();
    let [flat, lockstep, twice] = plans(&tree).map(|plan| {
        let derived = derived(&tree, REQUESTS[0], &plan);
        emitted(&tree, &derived).0
    });
    let of_helpers = |own: &Instruction| match own {
        Instruction::Call { helper, .. } => {
            LANES * lockstep.helpers[*helper].program.operations().total()
        }
        _ => 0,
    };
    let in_calls: usize = lockstep.instructions.iter().map(of_helpers).sum();
    let operations = lockstep.operations().total();
    let own = lockstep.instructions.iter();
    let own = own.filter(|own| matches!(own, Instruction::Compute { .. }));
    // Signs are instructions too, and sines are not among these.
    assert!(operations <= in_calls + own.count() + 64);
    assert!(operations > in_calls);
    // At most a tenth more operations, for two thirds of the text.
    assert!(10 * operations < 11 * flat.operations().total());
    let text = |program: &Program| {
        let helpers = program
            .helpers
            .iter()
            .map(|own| own.program.instructions.len());
        program.instructions.len() + helpers.sum::<usize>()
    };
    assert!(3 * text(&lockstep) < 2 * text(&flat));
    assert!(n_calls(&lockstep) > lockstep.helpers.len());
    // Columns that pass inward together too need a tenth less text.
    assert!(operations < twice.operations().total());
    assert!(10 * text(&twice) < 9 * text(&lockstep));
}

#[test]
fn no_lane_of_the_calls_of_an_arm_stays_empty() {
    let tree = read("tests/robots/panda/panda.urdf", &Reading::default());
    let (program, _) = emitted(&tree, &derived(&tree, REQUESTS[0], &Plan::full(&tree)));
    let calls = program.instructions.iter().filter_map(|own| match own {
        Instruction::Call { results, .. } => Some(results),
        _ => None,
    });
    let is_used = |results: &[Vec<Option<ValueId>>], lane: usize| {
        let mut places = results.iter();
        places.any(|place| place[lane].is_some())
    };
    let lanes = calls.flat_map(|results| (0..LANES).map(|lane| is_used(results, lane)));
    let lanes: Vec<bool> = lanes.collect();
    // Six columns by coordinates and seven by speeds; the accelerations; and two of the inverse in lanes that are left.
    assert_eq!(lanes, [true; 16]);
}

/// A program with calls.
fn with_calls() -> Program {
    let (_, tree) = system(562);
    let (program, _) = emitted(&tree, &derived(&tree, REQUESTS[0], &Plan::full(&tree)));
    assert!(n_calls(&program) > 0);
    program
}

/// The same after a fault is planted in it.
fn planted(plant: impl Fn(&mut Vec<Instruction>)) -> Result<(), VerifyError> {
    let mut program = with_calls();
    plant(&mut program.instructions);
    program::verify(&program)
}

#[test]
fn calls_without_what_they_share_or_need_are_refused() {
    let fault = planted(|instructions| {
        instructions.retain(|own| !matches!(own, Instruction::Share { .. }));
    });
    assert!(matches!(fault, Err(VerifyError::Unfit(_))), "{fault:?}");
    let fault = planted(|instructions| {
        for instruction in instructions {
            if let Instruction::Call { sides, .. } = instruction {
                sides.pop();
            }
        }
    });
    assert!(matches!(fault, Err(VerifyError::Unfit(_))), "{fault:?}");
    let fault = planted(|instructions| {
        for instruction in instructions {
            if let Instruction::Call { helper, .. } = instruction {
                *helper += 1_000;
            }
        }
    });
    assert!(matches!(fault, Err(VerifyError::Unfit(_))), "{fault:?}");
}

#[test]
fn helpers_of_helpers_are_refused() {
    let mut program = with_calls();
    let inner = program.helpers[0].clone();
    program.helpers[0].program.helpers.push(inner);
    let fault = program::verify(&program);
    assert_eq!(fault, Err(VerifyError::Nested(0)));
}
