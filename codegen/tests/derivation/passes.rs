//! Passes and flattening, by meaning: on seeded random graphs every root keeps its value, and no pass raises a count.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use kane_codegen::{
    expr::{Binding, Expr, ExprGraph, Input, Node, NodeId},
    id::{BodyId, CoordinateId, ParameterId, SpeedId},
    passes::{
        factor,
        hoist::{self, Preparation},
        reuse,
    },
    program::{self, Operand, Operation, Operations, Program},
};
use kane_test_support::random::Random;

use crate::reuse::eight_bodies;

/// A random graph, rich in sums of products with common factors, with labels and scopes, and some of its nodes as roots.
fn random_graph(seed: u64) -> (ExprGraph, Vec<Expr>) {
    let mut random = Random::new(seed);
    let mut graph = ExprGraph::default();
    let mut pool: Vec<Expr> = Vec::new();
    for i in 0..4 {
        pool.push(graph.input(Input::Q(CoordinateId::new(i))));
        pool.push(graph.input(Input::U(SpeedId::new(i))));
        pool.push(graph.input(Input::Parameter(ParameterId::new(i))));
        pool.push(graph.number(0.25 + f64::from(u32::try_from(i).unwrap())));
    }
    for step in 0..120 {
        graph.enter(BodyId::new(random.below(3)));
        let mut pick = || {
            // Recent values are used more: sums grow long.
            let place = if random.below(2) == 0 {
                random.below(pool.len())
            } else {
                pool.len() - 1 - random.below(8)
            };
            pool[place].signed(random.below(3) == 0)
        };
        let (a, b, c) = (pick(), pick(), pick());
        let expr = match random.below(12) {
            0..4 => graph.add(a, b),
            4..7 => graph.mul(a, b),
            7..10 => {
                let (first, second) = (graph.mul(a, b), graph.mul(a, c));
                graph.add(first, second)
            }
            10 => graph.cos(a),
            _ => graph.abs(a),
        };
        // Now and then something small, or the products would outgrow f64.
        let expr = if step % 3 == 2 { graph.sin(expr) } else { expr };
        if random.below(10) == 0 {
            graph.name(expr, format!("v{step}"));
        }
        pool.push(expr);
    }
    let roots = (0..6)
        .map(|_| pool[pool.len() - 1 - random.below(40)])
        .collect();
    (graph, roots)
}

fn input(given: Input) -> f64 {
    match given {
        Input::Q(id) => [0.3, -1.1, 0.8, 2.0][id.index()],
        Input::U(id) => [-0.7, 0.2, 1.3, -0.4][id.index()],
        Input::Parameter(id) => [1.5, 0.6, -0.9, 0.35][id.index()],
        _ => unreachable!("the graphs have no other inputs"),
    }
}

fn operations(graph: &ExprGraph, roots: &[Expr]) -> Operations {
    program::flatten(graph, roots).operations()
}

/// The value of an expression and a bound on its rounding error, by running error analysis (Higham 2002, section 3.3).
fn bounded(graph: &ExprGraph, expr: Expr, given: impl Fn(Input) -> f64) -> (f64, f64) {
    let mut known: Vec<(f64, f64)> = Vec::new();
    for id in graph.ids() {
        let of = |id: NodeId| known[id.index()];
        let signed = |expr: Expr| (sign(expr) * of(expr.node()).0, of(expr.node()).1);
        let (value, carried) = match graph.node(id) {
            Node::Number(bits) => (f64::from_bits(bits), 0.0),
            Node::Input(input) => (given(input), 0.0),
            Node::Sin(a) => (libm::sin(of(a).0), of(a).1),
            Node::Cos(a) => (libm::cos(of(a).0), of(a).1),
            Node::Abs(a) => (of(a).0.abs(), of(a).1),
            Node::Add(a, b) => (signed(a).0 + signed(b).0, signed(a).1 + signed(b).1),
            Node::Mul(a, b) => {
                let ((x, dx), (y, dy)) = (of(a), of(b));
                (x * y, x.abs() * dy + y.abs() * dx + dx * dy)
            }
            Node::Div(..) => unreachable!("the graphs have no quotients"),
        };
        // One unit in the last place a step covers the rounding of any operation, libm's sines with it.
        known.push((value, carried + value.abs() * f64::EPSILON));
    }
    let (value, error) = known[expr.node().index()];
    (sign(expr) * value, error)
}

fn sign(expr: Expr) -> f64 {
    if expr.is_negative() { -1.0 } else { 1.0 }
}

/// Two graphs for the same value differ at most by the rounding errors of both.
fn assert_same(seed: u64, new: (f64, f64), old: (f64, f64)) {
    let (error, bound) = ((new.0 - old.0).abs(), new.1 + old.1);
    assert!(
        error <= bound,
        "seed {seed}: {} is not {}: off by {error:e}, bound {bound:e}",
        new.0,
        old.0
    );
}

const SEEDS: std::ops::Range<u64> = 0..300;

/// Requires that a pass keeps the value of every root and raises no count, and that it lowers this many.
fn hold(least: usize, pass: impl Fn(ExprGraph, Vec<Expr>) -> (ExprGraph, Vec<Expr>)) {
    let mut lowered = 0;
    for seed in SEEDS {
        let (graph, roots) = random_graph(seed);
        let (changed, new_roots) = pass(graph.clone(), roots.clone());
        for (&new, &old) in new_roots.iter().zip(&roots) {
            assert_same(
                seed,
                bounded(&changed, new, input),
                bounded(&graph, old, input),
            );
        }
        let (before, after) = (
            operations(&graph, &roots).total(),
            operations(&changed, &new_roots).total(),
        );
        assert!(
            after <= before,
            "seed {seed}: {before} operations became {after}"
        );
        lowered += usize::from(after < before);
    }
    assert!(
        lowered > least,
        "only {lowered} graphs had anything to change: the test proves too little"
    );
}

#[test]
fn factoring_keeps_the_value_of_every_root_and_never_raises_the_count() {
    hold(100, factor::run);
}

#[test]
fn reusing_keeps_the_value_of_every_root_and_never_raises_the_count() {
    let tree = eight_bodies();
    hold(20, |graph, roots| reuse::run(&tree, graph, roots));
}

#[test]
fn hoisting_keeps_the_value_of_every_root_and_leaves_no_parameter_in_the_loop() {
    for seed in SEEDS {
        let (graph, roots) = random_graph(seed);
        let mut preparation = Preparation::default();
        let (hoisted, new_roots) = hoist::run(&graph, &roots, "f", &mut preparation);
        let prepared = preparation.graph.evaluate(&preparation.roots(), input);
        let given = |given| match given {
            Input::Prepared(place) => prepared[place],
            Input::Parameter(_) => panic!("seed {seed}: a parameter is left in the loop"),
            other => input(other),
        };
        // Nothing is reordered: the same bits.
        assert_eq!(
            hoisted.evaluate(&new_roots, given),
            graph.evaluate(&roots, input),
            "seed {seed}"
        );
        let needed = hoisted.reachable(&new_roots);
        for id in hoisted.ids().filter(|id| needed[id.index()]) {
            let in_loop = hoisted.binding(id) != Binding::Parameters
                || hoisted.node(id).operands().next().is_none();
            assert!(
                in_loop,
                "seed {seed}: an operation on parameters alone is left in the loop"
            );
        }
    }
}

#[test]
fn flattening_gives_a_verified_program_of_the_same_values() {
    for seed in SEEDS {
        let (graph, roots) = random_graph(seed);
        let program = program::flatten(&graph, &roots);
        program::verify(&program).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        // The same operations in the same order, signs aside: the same bits.
        let (found, expected) = (program.evaluate(input), graph.evaluate(&roots, input));
        assert_eq!(found, expected, "seed {seed}");
    }
}

#[test]
fn fusing_gives_a_verified_program_of_the_same_values_with_as_many_operations() {
    for seed in SEEDS {
        let (graph, roots) = random_graph(seed);
        let plain = program::flatten(&graph, &roots);
        let fused = program::fuse(plain.clone());
        program::verify(&fused).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        assert_eq!(plain.operations(), fused.operations(), "seed {seed}");
        for (&root, found) in roots.iter().zip(fused.evaluate(input)) {
            let old = bounded(&graph, root, input);
            assert_same(seed, (found, old.1), old);
        }
    }
}

#[test]
fn a_common_factor_is_pulled_out_of_a_long_sum() {
    let mut graph = ExprGraph::default();
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| graph.input(Input::Q(CoordinateId::new(i))));
    let mut sum = graph.zero();
    for (x, y) in [(a, b), (c, c), (a, d), (b, d)] {
        let product = graph.mul(x, y);
        sum = graph.add(sum, product);
    }
    let (factored, roots) = factor::run(graph, vec![sum]);
    let mut text = factored.dump(roots[0]);
    for (i, name) in ["a", "b", "c", "d"].into_iter().enumerate() {
        text = text.replace(&format!("Q(CoordinateId({i}))"), name);
    }
    assert_eq!(text, "(b * d + (c * c + a * (b + d)))");
}

#[test]
fn numbers_of_a_long_sum_are_added_up() {
    let mut graph = ExprGraph::default();
    let [a, b] = [0, 1].map(|i| graph.input(Input::Q(CoordinateId::new(i))));
    let [one, two] = [1.0, 2.0].map(|number| graph.number(number));
    let mut sum = graph.zero();
    for term in [a, one, b, two] {
        sum = graph.add(sum, term);
    }
    let (gathered, roots) = factor::run(graph.clone(), vec![sum]);
    assert_eq!(operations(&gathered, &roots).add, 2);
    // Part of the sum is used elsewhere, and stays.
    let inner = graph.add(a, one);
    let (gathered, roots) = factor::run(graph, vec![sum, inner]);
    assert_eq!(operations(&gathered, &roots).add, 3);
}

#[test]
fn a_sum_of_parameters_stays() {
    let mut graph = ExprGraph::default();
    let parameters = [0, 1, 2].map(|i| graph.input(Input::Parameter(ParameterId::new(i))));
    let position = graph.input(Input::Q(CoordinateId::new(0)));
    let mut sum = graph.zero();
    for term in parameters {
        sum = graph.add(sum, term);
    }
    let product = graph.mul(sum, position);
    let (same, roots) = factor::run(graph, vec![product]);
    assert_eq!(operations(&same, &roots).add, 2);
}

#[test]
fn a_product_that_is_used_elsewhere_is_not_factored() {
    let mut graph = ExprGraph::default();
    let [a, b, c] = [0, 1, 2].map(|i| graph.input(Input::Q(CoordinateId::new(i))));
    let (first, second) = (graph.mul(a, b), graph.mul(a, c));
    let sum = graph.add(first, second);
    let (factored, roots) = factor::run(graph, vec![sum, first]);
    assert_eq!(
        operations(&factored, &roots),
        Operations {
            mul: 2,
            add: 1,
            ..Operations::default()
        }
    );
}

#[test]
fn a_value_is_computed_with_the_sign_that_its_label_means() {
    let mut graph = ExprGraph::default();
    let [a, b] = [0, 1].map(|i| graph.input(Input::Q(CoordinateId::new(i))));
    let difference = graph.sub(b, a);
    graph.name(difference, "rise");
    let double = graph.mul(difference, difference);
    let program = program::flatten(&graph, &[double, difference]);
    assert!(
        !program.stores[1].is_negative(),
        "the label's own sign needs no minus in the store"
    );
    let labels: Vec<_> = program
        .values
        .iter()
        .filter_map(|value| value.label.as_deref())
        .collect();
    assert_eq!(labels, ["rise"]);
}

#[test]
fn the_verifier_refuses_a_number_that_f64_does_not_hold() {
    let mut graph = ExprGraph::default();
    let (huge, a) = (
        graph.number(1e300),
        graph.input(Input::Q(CoordinateId::new(0))),
    );
    let squared = graph.mul(huge, huge);
    let product = graph.mul(squared, a);
    let program = program::flatten(&graph, &[product]);
    assert_eq!(
        program::verify(&program),
        Err(program::VerifyError::NotFinite)
    );
}

#[test]
fn the_verifier_sees_each_broken_promise() {
    let good = || {
        let mut graph = ExprGraph::default();
        let [a, b] = [0, 1].map(|i| graph.input(Input::Q(CoordinateId::new(i))));
        let sum = graph.add(a, b);
        let product = graph.mul(sum, a);
        program::flatten(&graph, &[product])
    };
    let broken = |break_it: fn(&mut Program)| {
        let mut program = good();
        break_it(&mut program);
        program::verify(&program)
    };
    assert_eq!(broken(|_| {}), Ok(()));
    assert!(matches!(
        broken(|p| p.instructions.swap(0, 1)),
        Err(program::VerifyError::Unassigned(_))
    ));
    assert!(matches!(
        broken(|p| p.instructions.push(p.instructions[0].clone())),
        Err(program::VerifyError::AssignedTwice(_))
    ));
    assert!(matches!(
        broken(|p| p.stores.clear()),
        Err(program::VerifyError::Dead(_))
    ));
    // A sum, of which the second operand may have a sign, then a product, of which none may.
    let with = |place: usize, change: &dyn Fn([Operand; 2]) -> Operation| {
        let mut program = good();
        let program::Instruction::Compute { operation, .. } = &mut program.instructions[place]
        else {
            panic!("the program has two operations")
        };
        let (Operation::Add(a, b) | Operation::Mul(a, b)) = *operation else {
            panic!("a sum and a product")
        };
        *operation = change([a, b]);
        program::verify(&program)
    };
    let minus = |operand| match operand {
        Operand::Value { id, .. } => Operand::Value { id, negative: true },
        Operand::Number(number) => Operand::Number(-number),
    };
    assert_eq!(with(0, &|[a, b]| Operation::Add(a, minus(b))), Ok(()));
    for misplaced in [
        with(0, &|[a, b]| Operation::Add(minus(a), b)),
        with(1, &|[a, b]| Operation::Mul(minus(a), b)),
        with(1, &|[a, b]| Operation::Mul(a, minus(b))),
        with(1, &|[a, b]| Operation::Div(a, minus(b))),
        with(1, &|[a, _]| Operation::Abs(minus(a))),
    ] {
        assert!(matches!(
            misplaced,
            Err(program::VerifyError::MisplacedSign(_))
        ));
    }
    let unfolded = with(1, &|_| {
        Operation::Mul(Operand::Number(0.5), Operand::Number(3.0))
    });
    assert!(matches!(unfolded, Err(program::VerifyError::Unfolded(_))));
    let none = || program::Instruction::SinCos {
        angles: vec![program::Operand::Number(0.5); 2],
        sines: vec![None; 2],
        cosines: vec![None; 2],
    };
    let mut twice = good();
    twice.instructions.extend([none(), none()]);
    assert_eq!(
        program::verify(&twice),
        Err(program::VerifyError::SinesApart(2))
    );
}

#[test]
fn sines_of_all_angles_that_are_known_at_the_start_are_taken_together_in_the_order_of_bodies() {
    let mut graph = ExprGraph::default();
    let q = [0, 0, 1].into_iter().enumerate().map(|(i, body)| {
        graph.enter(BodyId::new(body));
        graph.input(Input::Q(CoordinateId::new(i)))
    });
    let q: Vec<Expr> = q.collect();
    graph.enter(BodyId::new(1));
    let half = graph.number(0.5);
    let scaled = graph.mul(half, q[0]);
    let outer = [graph.sin(scaled), graph.cos(q[2])];
    graph.enter(BodyId::new(0));
    let product = graph.mul(outer[0], outer[1]);
    let sum = graph.add(q[0], q[1]);
    let inner = [graph.cos(sum), graph.sin(sum)];
    let late = graph.sin(product);
    let all = graph.mul(inner[0], inner[1]);
    let root = graph.add(all, late);
    let program = program::flatten(&graph, &[root]);
    program::verify(&program).unwrap();
    let angles = |instruction: &program::Instruction| match instruction {
        program::Instruction::SinCos { angles, .. } => Some(angles.len()),
        _ => None,
    };
    let found: Vec<_> = program.instructions.iter().map(angles).collect();
    // The two operations of the angles, the three angles, then the rest with the sine of what holds sines.
    assert_eq!(found[..3], [None, None, Some(3)]);
    assert_eq!(found.iter().flatten().collect::<Vec<_>>(), [&3, &1]);
    let scopes = program.instructions[2].results();
    let scopes: Vec<_> = scopes.map(|id| program.value(id).scope).collect();
    let [inner, outer] = [0, 1].map(|body| Some(BodyId::new(body)));
    // Sines, then cosines.
    assert_eq!(scopes, [inner, outer, inner, outer]);
    assert_eq!(program.operations().trig, 8);
}
