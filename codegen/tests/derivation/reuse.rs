//! Values that are made of others: what is found, what must not be, and that all functions keep their values.

use std::collections::BTreeSet;

use kane_codegen::{
    compile::{self, Plans},
    expr::{Binding, Expr, ExprGraph, Input},
    id::{BodyId, CoordinateId},
    number::{Number as _, Rounded},
    options,
    passes::{branches, reuse},
    program::{self, Operations},
    tree::Tree,
};
use kane_test_support::{compare::larger, dynamics::State, systems::trees};

use crate::{
    evaluator::{hoisted, input},
    frames::{request, system},
};

/// Four inputs.
fn inputs(graph: &mut ExprGraph) -> [Expr; 4] {
    [0, 1, 2, 3].map(|place| graph.input(Input::Q(CoordinateId::new(place))))
}

fn operations(graph: &ExprGraph, roots: &[Expr]) -> Operations {
    program::flatten(graph, roots).operations()
}

/// The bundled system, in which the second body is on the first, the third on the second, and the fourth on the first.
pub(crate) fn eight_bodies() -> Tree {
    let text = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/eight_body.toml");
    let text = std::fs::read_to_string(text).expect("the model is there");
    kane_test_support::systems::tree(&text).expect("a right description")
}

/// The operations that are left, of products and of sums.
fn left(graph: ExprGraph, roots: Vec<Expr>) -> [usize; 2] {
    left_of(&eight_bodies(), graph, roots)
}

fn left_of(tree: &Tree, graph: ExprGraph, roots: Vec<Expr>) -> [usize; 2] {
    let (graph, roots) = reuse::run(tree, graph, roots);
    let operations = operations(&graph, &roots);
    [operations.mul, operations.add]
}

#[test]
fn a_value_is_the_difference_of_two_that_are_computed_otherwise() {
    let mut graph = ExprGraph::default();
    let [a, b, ..] = inputs(&mut graph);
    let squares = [a, b].map(|one| graph.mul(one, one));
    let (sum, difference) = (graph.add(a, b), graph.sub(a, b));
    let product = graph.mul(sum, difference);
    let [a2, b2] = squares;
    assert_eq!(operations(&graph, &[a2, b2, product]).total(), 5);
    assert_eq!(left(graph, vec![a2, b2, product]), [2, 1]);
}

#[test]
fn a_value_is_made_of_those_of_bodies_on_its_path_and_not_of_those_beside() {
    for (body, expected) in [(0, [2, 1]), (1, [2, 1]), (2, [2, 1]), (3, [3, 2])] {
        let mut graph = ExprGraph::default();
        let mut square_of = |place: usize| {
            graph.enter(BodyId::new([body, 2][place]));
            let one = graph.input(Input::Q(CoordinateId::new(place)));
            [one, graph.mul(one, one)]
        };
        let [[a, a2], [b, b2]] = [0, 1].map(&mut square_of);
        let (sum, difference) = (graph.add(a, b), graph.sub(a, b));
        let product = graph.mul(sum, difference);
        assert_eq!(left(graph, vec![a2, b2, product]), expected, "{body}");
    }
}

#[test]
fn a_value_is_made_of_those_of_bodies_farther_out_and_not_of_those_beside() {
    for (body, expected) in [(1, [2, 1]), (2, [2, 1]), (3, [3, 2])] {
        let mut graph = ExprGraph::default();
        graph.enter(BodyId::new(body));
        let [a, b, ..] = inputs(&mut graph);
        let [a2, b2] = [a, b].map(|one| graph.mul(one, one));
        graph.enter(BodyId::new(1));
        let (sum, difference) = (graph.add(a, b), graph.sub(a, b));
        let product = graph.mul(sum, difference);
        assert_eq!(left(graph, vec![a2, b2, product]), expected, "{body}");
    }
}

/// What is known grows with each body on the path, so that chains of a thousand would take minutes.
#[test]
fn bodies_with_more_than_64_on_their_path_are_left_as_they_are() {
    let n_bodies = 70;
    let lower: Vec<String> = (0..n_bodies).map(|body| body.to_string()).collect();
    let lower = lower.join(", ");
    let bodies = (0..n_bodies).map(|body| {
        format!(
            "[[body]]\nname = \"b{body}\"\nmass = 1.5\nmass_center = [0.0, 0.0, 0.0]\n\
             inertia = {{ xx = 0.3, yy = 0.3, zz = 0.3, xy = 0.0, xz = 0.0, yz = 0.0 }}\n\
             attachment = [0.1, 0.0, 0.0]\njoint = [\"theta3\"]\n"
        )
    });
    let text = format!(
        "name = \"chain\"\ngravity = [0.0, 0.0, 0.0]\nlower_bodies = [{lower}]\n{}",
        bodies.collect::<String>()
    );
    let chain = kane_test_support::systems::tree(&text).expect("a right description");
    for (body, expected) in [(63, [2, 1]), (64, [3, 2])] {
        let mut graph = ExprGraph::default();
        graph.enter(BodyId::new(body));
        let [a, b, ..] = inputs(&mut graph);
        let [a2, b2] = [a, b].map(|one| graph.mul(one, one));
        let (sum, difference) = (graph.add(a, b), graph.sub(a, b));
        let product = graph.mul(sum, difference);
        let found = left_of(&chain, graph, vec![a2, b2, product]);
        assert_eq!(found, expected, "{body}");
    }
}

#[test]
fn a_value_that_is_the_same_as_another_needs_no_operation() {
    let mut graph = ExprGraph::default();
    let [a, b, c, ..] = inputs(&mut graph);
    let (sum, less) = (graph.add(a, b), graph.sub(c, a));
    let product = graph.mul(sum, less);
    let opposite = graph.sub(a, c);
    let other = graph.mul(b, opposite);
    let first = graph.mul(a, opposite);
    let both = graph.add(first, other);
    // `a (a - c) + b (a - c)` is the negative of the product.
    assert_eq!(left(graph, vec![product, both]), [1, 2]);
}

#[test]
fn squares_of_sine_and_cosine_add_up_to_one() {
    let mut graph = ExprGraph::default();
    let [angle, a, ..] = inputs(&mut graph);
    let [sine, cosine] = [graph.sin(angle), graph.cos(angle)];
    let [x, y] = [sine, cosine].map(|one| graph.mul(one, a));
    let [x_again, y_again] = [(sine, x), (cosine, y)].map(|(one, other)| graph.mul(one, other));
    // It is `a`.
    let sum = graph.add(x_again, y_again);
    assert_eq!(left(graph, vec![x, y, sum]), [2, 0]);
}

#[test]
fn a_value_is_made_of_one_that_is_derived_later() {
    let mut graph = ExprGraph::default();
    let [a, b, ..] = inputs(&mut graph);
    let (sum, difference) = (graph.add(a, b), graph.sub(a, b));
    let product = graph.mul(sum, difference);
    let squares = [a, b].map(|one| graph.mul(one, one));
    let [a2, b2] = squares;
    assert_eq!(left(graph, vec![product, a2, b2]), [2, 1]);
}

#[test]
fn a_value_is_made_of_three_others() {
    let mut graph = ExprGraph::default();
    let [a, b, c, d] = inputs(&mut graph);
    let products = [(a, c), (a, d), (b, c)].map(|(one, other)| graph.mul(one, other));
    let (first, second) = (graph.add(a, b), graph.add(c, d));
    let product = graph.mul(first, second);
    let bd = graph.mul(b, d);
    // What is left of the product without one of its terms.
    let rest = graph.sub(product, bd);
    let [ac, ad, bc] = products;
    assert_eq!(operations(&graph, &[ac, ad, bc, rest]).total(), 8);
    assert_eq!(left(graph, vec![ac, ad, bc, rest]), [3, 2]);
}

#[test]
fn a_term_that_is_small_where_others_are_large_is_not_lost() {
    for small in [1e-6, 1e-9, 1e-12] {
        let mut graph = ExprGraph::default();
        let [a, b, c, d] = inputs(&mut graph);
        let (ab, cd) = (graph.mul(a, b), graph.mul(c, d));
        // What the product would be without the small term: a difference of two.
        let whole = graph.add(ab, d);
        let small = graph.number(small);
        let small = graph.mul(small, cd);
        let sum = graph.add(ab, small);
        let roots = vec![whole, sum];
        let before = operations(&graph, &roots);
        assert_eq!(left(graph, roots), [before.mul, before.add]);
    }
}

#[test]
fn a_small_value_is_not_made_of_large_ones() {
    let mut graph = ExprGraph::default();
    let [a, b, c, d] = inputs(&mut graph);
    let part = graph.mul(b, c);
    let part = graph.mul(part, d);
    let million = graph.number(1e6);
    let large = graph.mul(million, a);
    let whole = graph.add(large, part);
    // The same part once more, by other operations.
    let again = graph.mul(c, d);
    let again = graph.mul(again, b);
    let roots = vec![large, whole, again];
    let before = operations(&graph, &roots);
    let after = left(graph, roots);
    // It is the first one times `d`, and not the difference of the others, which would lose digits.
    assert_eq!(after, [before.mul - 2, before.add]);
}

#[test]
fn the_square_of_a_cosine_is_not_made_what_a_sine_leaves_of_one() {
    let mut graph = ExprGraph::default();
    let [a, angle, ..] = inputs(&mut graph);
    let (sine, cosine) = (graph.sin(angle), graph.cos(angle));
    let [of_sine, of_cosine] = [sine, cosine].map(|one| {
        let square = graph.mul(one, one);
        graph.mul(square, a)
    });
    // The same as the one with the cosine, but where that is small it has lost digits.
    let rest = graph.sub(a, of_sine);
    assert_eq!(left(graph, vec![of_sine, of_cosine, rest]), [4, 0]);
}

#[test]
fn two_is_a_number_like_no_other() {
    let mut graph = ExprGraph::default();
    let [a, b, ..] = inputs(&mut graph);
    let sum = graph.add(a, b);
    let square = graph.mul(sum, sum);
    let [aa, ab, bb] = [(a, a), (a, b), (b, b)].map(|(one, other)| graph.mul(one, other));
    let two = graph.number(2.0);
    let twice = graph.mul(two, ab);
    let again = graph.add(aa, twice);
    let again = graph.add(again, bb);
    let other = graph.mul(again, a);
    assert_eq!(left(graph, vec![square, other]), [2, 1]);
}

/// Requires that no operation depends on parameters alone, which would be computed in the loop again and again.
fn assert_hoisted(what: &str, graph: &ExprGraph, roots: &[Expr]) {
    let needed = graph.reachable(roots);
    for id in graph.ids().filter(|id| needed[id.index()]) {
        let is_operation = graph.node(id).operands().next().is_some();
        let is_early = is_operation && graph.binding(id) == Binding::Parameters;
        assert!(!is_early, "{what}: an operation on parameters alone");
    }
}

#[test]
fn numbers_do_not_join_parameters_in_the_loop() {
    let mut graph = ExprGraph::default();
    let [a, b, ..] = inputs(&mut graph);
    let parameter = graph.input(Input::Prepared(0));
    let sum = graph.add(a, b);
    let product = graph.mul(parameter, sum);
    let [first, second] = [a, b].map(|one| graph.mul(parameter, one));
    // Once more the same product; of both together it is twice the first.
    let again = graph.add(first, second);
    let both = graph.add(product, again);
    let mut roots = vec![product];
    for number in [2.0, 0.3, 0.7] {
        let number = graph.number(number);
        roots.extend([graph.mul(number, a), graph.mul(number, both)]);
    }
    let (graph, roots) = reuse::run(&eight_bodies(), graph, roots);
    assert_hoisted("the sum", &graph, &roots);
}

/// How many times as large the bound on rounding may become, of the entries of a function together.
const MOST_ROUNDED: f64 = 2.0;

/// A function as it is before reuse, with its branches or without, and what it is given.
struct Function {
    graph: ExprGraph,
    roots: Vec<Expr>,
    prepared: Vec<f64>,
}

impl Function {
    fn of(plans: &Plans<'_>, tree: &Tree, text: &str, has_branches: bool) -> Self {
        let request = request(tree, text);
        let chosen = compile::choose(plans, &request, options::Formulation::Cheapest);
        let (graph, roots, prepared) = hoisted(tree, &chosen.derived.graph, &chosen.derived.roots);
        let arguments = request.arguments();
        let branches = has_branches.then(|| branches::run(tree, &arguments, &graph, &roots));
        let (graph, roots) = branches.flatten().unwrap_or((graph, roots));
        Self {
            graph,
            roots,
            prepared,
        }
    }

    /// Requires that it keeps its values and needs no more operations; true if it needs fewer.
    fn keeps_its_values(&self, what: &str, tree: &Tree, state: &State) -> bool {
        let (reused, roots) = reuse::run(tree, self.graph.clone(), self.roots.clone());
        let before = operations(&self.graph, &self.roots).total();
        let after = operations(&reused, &roots).total();
        assert!(after <= before, "{what}: {before} became {after}");
        assert_hoisted(what, &reused, &roots);
        let given = |own: Input| {
            Rounded::constant(match own {
                Input::Prepared(place) => self.prepared[place],
                own => input(tree, state, own),
            })
        };
        let expected = self.graph.evaluate(&self.roots, given);
        let found = reused.evaluate(&roots, given);
        let largest = |all: &[Rounded]| all.iter().map(|one| one.error).fold(0.0, larger);
        let bounds = [largest(&found), largest(&expected)];
        let [of_found, of_expected] = bounds;
        assert!(
            of_found <= MOST_ROUNDED * of_expected,
            "{what}: rounding takes up to {of_found:e}, not {of_expected:e}"
        );
        for (place, (found, expected)) in found.into_iter().zip(expected).enumerate() {
            let off = (found.value - expected.value).abs();
            let bound = found.error + expected.error;
            assert!(
                off <= bound,
                "{what}, {place}: off by {off:e}, bound {bound:e}"
            );
        }
        after < before
    }
}

/// Functions of all kinds.
const REQUESTS: [&str; 12] = [
    "inverse_dynamics",
    "forward_dynamics",
    "mass_matrix",
    "mass_matrix_inverse",
    "mass_matrix_dot",
    "coriolis_matrix",
    "regressor",
    "centroidal_momentum_matrix",
    "bias",
    "angular_velocity",
    "d(inverse_dynamics)/d(q, u)",
    "d(forward_dynamics)/d(q, u, tau)",
];

#[test]
fn all_functions_keep_their_values_and_need_no_more_operations() {
    let mut lowered = [0; REQUESTS.len()];
    for seed in trees::tried(901..=940) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        let none = BTreeSet::new();
        let plans = Plans::new(&tree, &none);
        for (place, text) in REQUESTS.into_iter().enumerate() {
            let what = format!("{seed}, {text}");
            let function = Function::of(&plans, &tree, text, false);
            let is_lower = function.keeps_its_values(&what, &tree, &state);
            lowered[place] += usize::from(is_lower);
        }
    }
    assert!(
        lowered.into_iter().filter(|n| *n > 0).count() > 6,
        "{lowered:?}"
    );
}

/// Functions whose columns go side by side.
const LONG: [&str; 9] = [
    "d(inverse_dynamics)/d(q, u, u_dot)",
    "d(forward_dynamics)/d(q, u)",
    "d(forward_dynamics)/d(q, u, tau)",
    "mass_matrix_inverse",
    "forward_dynamics",
    "jvp(forward_dynamics; q, u, tau)",
    "vjp(forward_dynamics; q, u, tau)",
    "jvp(forward_dynamics; q, u)",
    "forward_dynamics+jvp(forward_dynamics; q, u, tau)",
];

#[test]
fn long_functions_with_helpers_keep_their_values() {
    let tree = eight_bodies();
    let state = State::random(&tree, 7);
    let none = BTreeSet::new();
    let plans = Plans::new(&tree, &none);
    for text in LONG {
        for has_branches in [false, true] {
            let function = Function::of(&plans, &tree, text, has_branches);
            let what = format!("{text}, {has_branches}");
            function.keeps_its_values(&what, &tree, &state);
        }
    }
}
