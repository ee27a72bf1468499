//! One sine an angle: what is a sum of angles whose sines are taken follows from these.

use std::{
    collections::BTreeSet,
    time::{Duration, Instant},
};

use kane_codegen::{
    expr::{Binding, Expr, ExprGraph, Input, Node, NodeId},
    id::{CoordinateId, ParameterId},
    passes::angles,
};
use kane_test_support::random::Random;

const N_COORDINATES: usize = 4;

/// Coordinates, a parameter and a number.
fn terms(graph: &mut ExprGraph) -> Vec<Expr> {
    let coordinates = (0..N_COORDINATES).map(|place| Input::Q(CoordinateId::new(place)));
    let inputs = coordinates.chain([Input::Parameter(ParameterId::new(0))]);
    let mut terms: Vec<Expr> = inputs.map(|input| graph.input(input)).collect();
    terms.push(graph.number(0.3));
    terms
}

fn evaluated(graph: &ExprGraph, roots: &[Expr]) -> Vec<f64> {
    graph.evaluate(roots, |input| match input {
        Input::Q(id) => [0.7, -1.9, 2.3, 0.4][id.index()],
        Input::Parameter(_) => 0.9,
        other => unreachable!("{other:?}"),
    })
}

/// The angles in the loop whose sines or cosines are needed.
fn needed(graph: &ExprGraph, roots: &[Expr]) -> BTreeSet<NodeId> {
    let needed = graph.reachable(roots);
    let ids = graph.ids().filter(|id| needed[id.index()]);
    let angles = ids.filter_map(|id| match graph.node(id) {
        Node::Sin(angle) | Node::Cos(angle) => Some(angle),
        _ => None,
    });
    angles
        .filter(|angle| graph.binding(*angle) == Binding::State)
        .collect()
}

fn pair(graph: &mut ExprGraph, angle: Expr) -> [Expr; 2] {
    [graph.sin(angle), graph.cos(angle)]
}

#[test]
fn what_is_a_sum_of_angles_follows_from_them_and_keeps_its_value() {
    let mut n_fewer = 0;
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let mut graph = ExprGraph::default();
        let terms = terms(&mut graph);
        let mut roots = Vec::new();
        for _ in 0..12 {
            let mut angle = graph.zero();
            for _ in 0..=random.below(4) {
                let term = terms[random.below(terms.len())].signed(random.below(2) == 0);
                angle = graph.add(angle, term);
            }
            let both = pair(&mut graph, angle);
            roots.push(both[random.below(2)]);
        }
        let expected = evaluated(&graph, &roots);
        let before = needed(&graph, &roots);
        let (graph, roots) = angles::run(graph, roots);
        let found = evaluated(&graph, &roots);
        for (place, (found, expected)) in found.iter().zip(&expected).enumerate() {
            // A theorem for each term, of numbers up to one.
            let is_near = (found - expected).abs() < 16.0 * f64::EPSILON;
            assert!(is_near, "{seed} {place}: {found} {expected}");
        }
        let after = needed(&graph, &roots);
        assert!(after.len() <= before.len(), "{seed}");
        n_fewer += usize::from(after.len() < before.len());
    }
    assert!(n_fewer > 150, "{n_fewer}");
}

#[test]
fn where_each_coordinate_has_a_sine_no_sum_of_them_has_one() {
    let mut graph = ExprGraph::default();
    let terms = terms(&mut graph);
    let (coordinates, known) = terms.split_at(N_COORDINATES);
    let mut angles = coordinates.to_vec();
    for first in 0..N_COORDINATES {
        for second in 0..N_COORDINATES {
            let sum = graph.add(coordinates[first], coordinates[second].signed(true));
            let more = graph.add(sum, known[0]);
            let most = graph.sub(known[1], more);
            angles.extend([more, most]);
        }
    }
    let twice = graph.add(coordinates[0], coordinates[0]);
    angles.push(twice);
    let roots: Vec<Expr> = angles
        .iter()
        .flat_map(|angle| pair(&mut graph, *angle))
        .collect();
    let (graph, roots) = angles::run(graph, roots);
    let left = needed(&graph, &roots);
    let is_coordinate = |id: &NodeId| matches!(graph.node(*id), Node::Input(Input::Q(_)));
    assert!(left.iter().all(is_coordinate), "{left:?}");
    assert_eq!(left.len(), N_COORDINATES);
}

#[test]
fn sums_that_continue_one_another_and_have_no_angle_in_common_with_others_stay() {
    let mut graph = ExprGraph::default();
    let q = terms(&mut graph);
    let two = graph.add(q[0], q[1]);
    let three = graph.add(two, q[2]);
    let product = graph.mul(q[2], q[3]);
    let roots: Vec<Expr> = [q[0], two, three, product]
        .into_iter()
        .flat_map(|angle| pair(&mut graph, angle))
        .collect();
    let n_nodes = graph.len();
    let (graph, found) = angles::run(graph, roots.clone());
    assert_eq!((graph.len(), found), (n_nodes, roots));
}

#[test]
fn an_offset_of_the_same_angle_needs_one_theorem() {
    let mut graph = ExprGraph::default();
    let terms = terms(&mut graph);
    let offset = graph.add(terms[0], terms[5]);
    let [one, other] = [terms[0], offset].map(|angle| pair(&mut graph, angle));
    let roots = [one, other].concat();
    let (graph, roots) = angles::run(graph, roots);
    assert_eq!(needed(&graph, &roots).len(), 1);
    // Two sines, four products by numbers, two sums.
    assert_eq!(graph.n_operations(&roots), 8);
    let found = evaluated(&graph, &roots);
    let expected = [0.7, 1.0].map(|angle| [libm::sin(angle), libm::cos(angle)]);
    let both = found.iter().zip(expected.concat());
    assert!(both.into_iter().all(|(a, b)| (a - b).abs() < 1e-15));
}

#[test]
fn sums_that_overlap_have_as_many_sines_as_none_of_them_follows_from_the_others() {
    let cases: [(&[[i8; 4]], usize); 5] = [
        // a, b, b + c, a + b, a + b + c
        (
            &[
                [1, 0, 0, 0],
                [0, 1, 0, 0],
                [0, 1, 1, 0],
                [1, 1, 0, 0],
                [1, 1, 1, 0],
            ],
            3,
        ),
        // a + b, c + b, a - c
        (&[[1, 1, 0, 0], [0, 1, 1, 0], [1, 0, -1, 0]], 2),
        // a + b, a + 2 b + c, b + c
        (&[[1, 1, 0, 0], [1, 2, 1, 0], [0, 1, 1, 0]], 2),
        // a + b, b + c, a + c, a + b + c: half of a sum is no theorem's
        (&[[1, 1, 0, 0], [0, 1, 1, 0], [1, 0, 1, 0], [1, 1, 1, 0]], 4),
        // a, 3 a, 8 a: a multiple that takes many theorems has a sine
        (&[[1, 0, 0, 0], [3, 0, 0, 0], [8, 0, 0, 0]], 2),
    ];
    for (angles, expected) in cases {
        let mut graph = ExprGraph::default();
        let terms = terms(&mut graph);
        let mut roots = Vec::new();
        for angle in angles {
            let mut sum = graph.zero();
            for (term, times) in terms.iter().zip(angle) {
                let times = graph.number(f64::from(*times));
                let term = graph.mul(times, *term);
                sum = graph.add(sum, term);
            }
            roots.extend(pair(&mut graph, sum));
        }
        let values = evaluated(&graph, &roots);
        let (graph, roots) = angles::run(graph, roots);
        assert_eq!(needed(&graph, &roots).len(), expected, "{angles:?}");
        let found = evaluated(&graph, &roots);
        let both = found.iter().zip(&values);
        assert!(both.into_iter().all(|(a, b)| (a - b).abs() < 1e-14));
    }
}

#[test]
fn of_several_ways_that_with_the_fewest_theorems_is_taken() {
    let mut graph = ExprGraph::default();
    let terms = terms(&mut graph);
    let offset = graph.add(terms[0], terms[5]);
    let sum = graph.add(terms[0], terms[1]);
    let angles = [terms[0], offset, terms[1], sum];
    let roots: Vec<Expr> = angles
        .into_iter()
        .flat_map(|angle| pair(&mut graph, angle))
        .collect();
    let (graph, roots) = angles::run(graph, roots);
    // Four sines and two theorems; not a third, from the angle with the offset.
    assert_eq!(graph.n_operations(&roots), 16);
}

/// How long sums of one more coordinate each take, and the coordinates themselves.
#[expect(clippy::disallowed_methods, reason = "the test is of the time")]
fn time_of_chain(n: usize) -> Duration {
    let mut graph = ExprGraph::default();
    let mut roots = Vec::new();
    let mut angle = graph.zero();
    for place in 0..n {
        let coordinate = graph.input(Input::Q(CoordinateId::new(place)));
        angle = graph.add(angle, coordinate);
        roots.extend(pair(&mut graph, angle));
        roots.extend(pair(&mut graph, coordinate));
    }
    let start = Instant::now();
    let (graph, roots) = angles::run(graph, roots);
    let time = start.elapsed();
    assert_eq!(needed(&graph, &roots).len(), n);
    time
}

#[test]
fn long_chains_take_a_time_that_does_not_grow_with_their_cube() {
    // Four times the length takes by the square 16 times as long, by the cube 64. Others may have the processor meanwhile, so as many short
    // ones are timed as take as long.
    let mut tries = (0..5).map(|_| {
        let short: Duration = (0..16).map(|_| time_of_chain(700)).sum();
        [time_of_chain(2_800), short]
    });
    assert!(tries.any(|[long, short]| 2 * long < 5 * short));
}
