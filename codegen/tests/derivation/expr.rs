//! The expression graph: what its constructors promise.

use kane_codegen::{
    expr::{Binding, Expr, ExprGraph, Input},
    id::{CoordinateId, ParameterId},
};

fn q(graph: &mut ExprGraph, index: usize) -> Expr {
    graph.input(Input::Q(CoordinateId::new(index)))
}

fn parameter(graph: &mut ExprGraph, index: usize) -> Expr {
    graph.input(Input::Parameter(ParameterId::new(index)))
}

#[test]
fn equal_expressions_are_one_node() {
    let mut graph = ExprGraph::default();
    let (a, b) = (q(&mut graph, 0), q(&mut graph, 1));
    assert_eq!(graph.add(a, b), graph.add(b, a));
    assert_eq!(graph.mul(a, b), graph.mul(b, a));
    assert_eq!(graph.sub(a, b), -graph.sub(b, a));
}

#[test]
fn every_node_of_a_long_graph_is_found_again() {
    let mut graph = ExprGraph::default();
    let build = |graph: &mut ExprGraph| {
        let mut pool = vec![q(graph, 0), q(graph, 1)];
        for place in 0..5_000 {
            let [last, other] = [pool[pool.len() - 1], pool[place / 2]];
            let (product, sum) = (graph.mul(last, other), graph.add(last, -other));
            let (quotient, number) = (graph.div(sum, product), graph.number(0.1 + place as f64));
            pool.extend([product, sum, quotient, number]);
        }
        pool
    };
    let first = build(&mut graph);
    let n_nodes = graph.len();
    assert!(n_nodes > 15_000, "{n_nodes} nodes");
    assert_eq!(build(&mut graph), first);
    assert_eq!(graph.len(), n_nodes);
}

#[test]
fn signs_stand_on_references() {
    let mut graph = ExprGraph::default();
    let (a, b) = (q(&mut graph, 0), q(&mut graph, 1));
    assert_eq!(graph.mul(-a, b), -graph.mul(a, b));
    assert_eq!(graph.mul(-a, -b), graph.mul(a, b));
    assert_eq!(graph.add(-a, -b), -graph.add(a, b));
    assert_eq!(graph.div(-a, b), -graph.div(a, b));
    assert_eq!(graph.sin(-a), -graph.sin(a));
    assert_eq!(graph.cos(-a), graph.cos(a));
    assert_eq!(graph.abs(-a), graph.abs(a));
}

#[test]
fn zeros_and_ones_vanish() {
    let mut graph = ExprGraph::default();
    let a = q(&mut graph, 0);
    let (zero, one) = (graph.zero(), graph.one());
    assert_eq!(graph.add(a, zero), a);
    assert_eq!(graph.sub(zero, a), -a);
    assert_eq!(graph.mul(a, zero), zero);
    assert_eq!(graph.mul(one, a), a);
    assert_eq!(graph.mul(a, -one), -a);
    assert_eq!(graph.div(zero, a), zero);
    assert_eq!(graph.div(a, one), a);
    assert_eq!(graph.sub(a, a), zero);
    assert_eq!(graph.div(a, a), one);
    assert_eq!(graph.number(-0.0), zero);
}

#[test]
fn zero_times_infinity_is_no_zero() {
    let mut graph = ExprGraph::default();
    let (zero, infinite) = (graph.zero(), graph.number(f64::INFINITY));
    for product in [graph.mul(zero, infinite), graph.mul(infinite, zero)] {
        assert!(graph.as_number(product).is_some_and(f64::is_nan));
    }
    let sum = graph.add(zero, infinite);
    assert_eq!(graph.as_number(sum), Some(f64::INFINITY));
}

#[test]
fn numbers_are_folded() {
    let mut graph = ExprGraph::default();
    let a = q(&mut graph, 0);
    let (two, three) = (graph.number(2.0), graph.number(3.0));
    assert_eq!(graph.mul(two, -three), graph.number(-6.0));
    let product = graph.mul(three, a);
    assert_eq!(graph.dump(product), "3.0 * Q(CoordinateId(0))");
    let product = graph.mul(product, two);
    assert_eq!(graph.dump(product), "6.0 * Q(CoordinateId(0))");
    let half = graph.div(product, two);
    assert_eq!(graph.dump(half), "3.0 * Q(CoordinateId(0))");
}

#[test]
fn multiples_of_one_value_are_added_at_generation() {
    let mut graph = ExprGraph::default();
    let a = q(&mut graph, 0);
    let (two, three) = (graph.number(2.0), graph.number(3.0));
    let (double, triple) = (graph.mul(two, a), graph.mul(three, a));
    assert_eq!(graph.add(a, a), double);
    assert_eq!(graph.add(double, a), triple);
    assert_eq!(graph.sub(triple, double), a);
    assert_eq!(graph.sub(double, triple), -a);
}

#[test]
fn factors_known_before_the_loop_gather() {
    let mut graph = ExprGraph::default();
    let a = q(&mut graph, 0);
    let (mass, length) = (parameter(&mut graph, 0), parameter(&mut graph, 1));
    let inner = graph.mul(length, a);
    let gathered = graph.mul(mass, inner);
    let constant = graph.mul(mass, length);
    assert_eq!(graph.binding(constant.node()), Binding::Parameters);
    assert_eq!(gathered, graph.mul(constant, a));
}

#[test]
fn a_division_by_zero_is_left_to_ieee_arithmetic() {
    let mut graph = ExprGraph::default();
    let (a, zero) = (q(&mut graph, 0), graph.zero());
    let quotient = graph.div(a, zero);
    assert_eq!(graph.evaluate(&[quotient], |_| 1.0), [f64::INFINITY]);
}

#[test]
fn evaluation_follows_the_operations() {
    let mut graph = ExprGraph::default();
    let (a, b) = (q(&mut graph, 0), q(&mut graph, 1));
    let (sine, cosine) = (graph.sin(a), graph.cos(b));
    let product = graph.mul(sine, cosine);
    let quotient = graph.div(product, b);
    let difference = graph.sub(quotient, a);
    let root = graph.abs(difference);
    let (x, y) = (0.7, -0.4);
    let values = graph.evaluate(&[root, -root], |input| match input {
        Input::Q(id) => [x, y][id.index()],
        _ => unreachable!(),
    });
    let expected = (libm::sin(x) * libm::cos(y) / y - x).abs();
    // The graph performs the same operations in the same order: the same bits.
    assert_eq!(values, [expected, -expected]);
}

#[test]
fn a_label_keeps_the_sign_of_what_it_names() {
    let mut graph = ExprGraph::default();
    let (a, b) = (q(&mut graph, 0), q(&mut graph, 1));
    let difference = graph.sub(b, a);
    graph.name(difference, "w_x");
    let label = graph.label(difference.node()).unwrap();
    assert_eq!(
        (label.text.as_str(), label.negative),
        ("w_x", difference.is_negative())
    );
    graph.name(difference, "other");
    assert_eq!(graph.label(difference.node()).unwrap().text, "w_x");
    graph.name(a, "alias");
    assert!(
        graph.label(a.node()).is_none(),
        "an input keeps its own name"
    );
}
