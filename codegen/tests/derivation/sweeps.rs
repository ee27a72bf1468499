//! Sweeps for derivatives, forward and back, on graphs of their own, beside derivatives in numbers.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use kane_codegen::{
    differentiate::{Row, Seeds, forward, reverse, tangents},
    expr::{Expr, ExprGraph, Input},
    id::{CoordinateId, ParameterId, SpeedId},
    program,
};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    random::Random,
};

/// `q[0]`, `q[1]`, four of `u`, and a value set at run time.
fn variables() -> [Input; 7] {
    let [first, second] = [0, 1].map(|i| Input::Q(CoordinateId::new(i)));
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| Input::U(SpeedId::new(i)));
    let parameter = Input::Parameter(ParameterId::new(0));
    [first, second, a, b, c, d, parameter]
}

const VALUES: [f64; 7] = [0.3, -1.1, 0.8, -0.7, 1.2, 0.4, 0.9];

fn value(input: Input) -> f64 {
    let place = variables().iter().position(|variable| *variable == input);
    VALUES[place.unwrap()]
}

/// What mechanics is made of: things turned once and twice, with and without their partners, squares, and sums of all these.
fn random_graph(seed: u64) -> (ExprGraph, Vec<Expr>) {
    let mut random = Random::new(seed);
    let mut graph = ExprGraph::default();
    let [first, second, others @ .., parameter] = variables().map(|input| graph.input(input));
    let sum = graph.add(first, second);
    let mut pool = others.to_vec();
    for _ in 0..12 {
        let angle = [first, second, sum][random.below(3)];
        let (sine, cosine) = (graph.sin(angle), graph.cos(angle));
        let [a, b, c] = [(); 3].map(|()| {
            let negative = random.below(2) == 0;
            pool[random.below(pool.len())].signed(negative)
        });
        let number = graph.number(0.25 + f64::from(u8::try_from(random.below(8)).unwrap()) / 8.0);
        let constant = if random.below(3) == 0 {
            graph.mul(number, parameter)
        } else {
            number
        };
        let [of_sine, of_cosine] = [sine, cosine].map(|entry| graph.mul(constant, entry));
        let once = [(cosine, a), (sine, -b), (sine, a), (cosine, b)];
        let once = once.map(|(entry, other)| graph.mul(entry, other));
        let twice = [
            (sine, of_sine),
            (cosine, of_sine),
            (sine, of_cosine),
            (cosine, of_cosine),
        ];
        let twice = twice.map(|(entry, other)| graph.mul(entry, other));
        let squares = [a, b, c].map(|of| graph.mul(of, of));
        let found = match random.below(5) {
            0 => vec![graph.add(once[0], once[1]), graph.add(once[2], once[3])],
            1 => vec![graph.add(once[0], once[1])],
            2 => vec![graph.mul(of_sine, a), graph.mul(of_cosine, b)],
            3 => {
                let first = random.below(3);
                vec![graph.mul(twice[first], a), graph.mul(twice[first + 1], b)]
            }
            _ => {
                let sums = [
                    graph.add(squares[0], squares[1]),
                    graph.add(squares[1], squares[2]),
                ];
                let scaled = graph.mul(constant, sums[0]);
                vec![
                    graph.add(scaled, c),
                    graph.mul(sums[random.below(2)], constant),
                ]
            }
        };
        for expr in found {
            let term = graph.mul(constant, expr);
            let total = graph.add(term, c);
            pool.push(if random.below(2) == 0 { total } else { expr });
        }
    }
    let mut weighted = graph.zero();
    for (place, expr) in pool.iter().rev().take(5).enumerate() {
        let factor = if place == 2 {
            graph.one()
        } else {
            others[place % 4]
        };
        let term = graph.mul(*expr, factor);
        weighted = graph.add(weighted, term);
    }
    let last = pool[pool.len() - 1];
    (graph, vec![weighted, last, -pool[pool.len() - 2]])
}

type Sweep = fn(&mut ExprGraph, &[Expr], &Seeds) -> Vec<Row>;

/// The rows in numbers, with their zeros.
fn numbers(graph: &ExprGraph, rows: &[Row]) -> Vec<f64> {
    let mut numbers = Vec::new();
    for row in rows {
        let mut dense = [0.0; VALUES.len()];
        let exprs: Vec<Expr> = row.iter().map(|(_, entry)| *entry).collect();
        for ((place, _), value) in row.iter().zip(graph.evaluate(&exprs, value)) {
            dense[*place] = value;
        }
        numbers.extend(dense);
    }
    numbers
}

#[test]
fn sweeps_forward_and_back_give_the_derivatives_in_numbers() {
    let of_numbers = variables().into_iter().enumerate();
    let of_numbers = of_numbers
        .map(|(place, input)| (input, vec![(place, 1.0)]))
        .collect();
    for seed in 0..400 {
        let (mut graph, roots) = random_graph(seed);
        let one = graph.one();
        let seeds = variables().into_iter().enumerate();
        let seeds: Seeds = seeds
            .map(|(place, input)| (input, vec![(place, one)]))
            .collect();
        let mut expected = Vec::new();
        for row in tangents(&graph, &roots, value, &of_numbers) {
            let mut dense = [0.0; VALUES.len()];
            for (place, entry) in row {
                dense[place] = entry;
            }
            expected.extend(dense);
        }
        // Some hundred operations of sums whose terms are at most a few hundred times as large.
        let tolerance = Tolerance::relative_beyond(1.0, 1e-11);
        for (way, sweep) in [("forward", forward as Sweep), ("back", reverse)] {
            let mut graph = graph.clone();
            let rows = sweep(&mut graph, &roots, &seeds);
            let found = numbers(&graph, &rows);
            assert_close(format!("{way}, {seed}"), &found, &expected, tolerance);
        }
    }
}

/// The operations of a gradient by all variables together with the values.
fn operations(graph: &mut ExprGraph, root: Expr) -> usize {
    let one = graph.one();
    let seeds = variables().into_iter().enumerate();
    let seeds = seeds
        .map(|(place, input)| (input, vec![(place, one)]))
        .collect();
    let rows = reverse(graph, &[root], &seeds);
    let roots: Vec<Expr> = [root]
        .into_iter()
        .chain(rows[0].iter().map(|(_, entry)| *entry))
        .collect();
    program::flatten(graph, &roots).operations().total()
}

#[test]
fn an_entry_whose_partner_the_sweep_has_met_takes_a_product_and_a_sum() {
    let mut graph = ExprGraph::default();
    let [angle, _, a, b, factor, ..] = variables().map(|input| graph.input(input));
    let (sine, cosine) = (graph.sin(angle), graph.cos(angle));
    let (first, second) = (graph.mul(cosine, a), graph.mul(sine, b));
    let component = graph.sub(first, second);
    let root = graph.mul(factor, component);
    // Two entries; value: 4; by a and b: 2; by the factor: none; by the angle: -(f c) b - (f s) a, 3.
    assert_eq!(operations(&mut graph, root), 2 + 4 + 2 + 3);
}

#[test]
fn squares_take_their_two_from_constants() {
    let mut graph = ExprGraph::default();
    let [_, _, a, b, factor, ..] = variables().map(|input| graph.input(input));
    let number = graph.number(0.3);
    let (first, second) = (graph.mul(a, a), graph.mul(b, b));
    let sum = graph.add(first, second);
    let scaled = graph.mul(number, sum);
    let root = graph.mul(factor, scaled);
    // Value: 5; by the factor: none; 0.6 f, and a and b times that.
    assert_eq!(operations(&mut graph, root), 5 + 3);
}
