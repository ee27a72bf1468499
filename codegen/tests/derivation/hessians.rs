//! Second derivatives: against differences of gradients, and of values along motions at constant speeds.

use kane_codegen::{
    compile,
    description::{Base, Reading},
    functions::{Formulation, Request},
    options::Options,
    recursive::{Plan, Technique},
    tree::{ChartCoordinates, Orientation, Tree},
};
use kane_test_support::{
    compare::{assert_within, larger, largest, relative_to},
    dynamics::State,
    numeric::{Matrix, derivative, dot, second_derivative},
    random::Random,
    systems::trees,
};

use crate::{
    compiled::read,
    derivatives::{DIFFERENCED, EXACT, INVERTED, inverts, moved, n_entries, values},
    frames::{evaluate_by, of_states, relative, request, system},
    products::{third, weights},
};

/// How far second differences may be off, relative to the largest of the values and of what is differentiated: see
/// [`second_derivative`]; a mixed one is a difference of two.
const TWICE: f64 = 1e-10;

/// The same where mass matrices are inverted, three times in a second derivative, whose condition numbers here are below 1e4.
const TWICE_INVERTED: f64 = 1e-8;

/// The whole of a packed second derivative, row after row.
fn whole(tree: &Tree, request: &Request, entries: &[f64], n: usize) -> Vec<f64> {
    let sparsity = request.parts()[0].sparsity(tree).expect("it is packed");
    assert_eq!(sparsity.places.len(), entries.len());
    let mut all = vec![0.0; n * n];
    for (&[row, column], &entry) in sparsity.places.iter().zip(entries) {
        assert!(column <= row);
        all[row * n + column] = entry;
        all[column * n + row] = entry;
    }
    all
}

/// How the gradient changes with each entry: of two that are taken one after the other the mean of both orders.
fn differenced(tree: &Tree, name: &str, variable: &str, state: &State) -> Vec<f64> {
    let n = n_entries(tree, variable);
    let gradient = request(tree, &format!("vjp({name}; {variable})"));
    // Inverses are of sums of masses that may be little larger than a whole step.
    let size = if variable == "parameters" { 0.1 } else { 1.0 };
    let along = moved(tree, &gradient, state, variable);
    let columns = (0..n).map(|entry| {
        let column = derivative(|t| along(entry, size * t)).into_iter();
        column.map(|entry| entry / size).collect()
    });
    let columns: Vec<Vec<f64>> = columns.collect();
    let pairs = (0..n * n).map(|place| [place / n, place % n]);
    pairs
        .map(|[a, b]| 0.5 * (columns[a][b] + columns[b][a]))
        .collect()
}

#[test]
fn every_function_has_the_second_derivatives_of_its_gradient() {
    for seed in trees::tried(561..=569) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        let full = Plan::full(&tree);
        for (name, variable) in third(&tree, seed) {
            let n = n_entries(&tree, &variable);
            let hessian = request(&tree, &format!("hessian({name}; {variable})"));
            let found = values(&tree, &hessian, &full, &state);
            let found = whole(&tree, &hessian, &found, n);
            let expected = differenced(&tree, &name, &variable, &state);
            let gradient = request(&tree, &format!("vjp({name}; {variable})"));
            let gradient = largest(&values(&tree, &gradient, &full, &state));
            let scale = larger(larger(gradient, largest(&expected)), 1.0);
            let error = relative_to(scale, &found, &expected);
            let allowed = if inverts(&name) {
                INVERTED
            } else {
                DIFFERENCED
            };
            assert_within(format!("{seed}, {name}, {variable}"), error, allowed);
        }
    }
}

/// Directions of several variables, by their names.
type Directions = Vec<(&'static str, Vec<f64>)>;

/// The sum of the outputs' entries, each times its weight, `t` away along directions at constant speeds.
fn along(
    tree: &Tree,
    name: &str,
    weights: &[f64],
    (state, directions): (&State, &Directions),
) -> f64 {
    let of = of_states(tree, &request(tree, name), Formulation::Recursive);
    let at = |t: f64| {
        let mut moved = state.clone();
        for (variable, d) in directions {
            let steps: Vec<f64> = d.iter().map(|d| t * d).collect();
            let sum = |own: &mut [f64]| own.iter_mut().zip(&steps).for_each(|(own, d)| *own += d);
            match *variable {
                "q" => moved.q = state.after(tree, &steps).q,
                "u" => sum(&mut moved.u),
                "u_dot" => sum(&mut moved.u_dot),
                "tau" => sum(&mut moved.tau),
                _ => sum(moved.loads.as_flattened_mut()),
            }
        }
        dot(&of(&moved), weights)
    };
    second_derivative(at)
}

const CASES: [(&str, &[&str]); 8] = [
    ("inverse_dynamics", &["q", "u", "u_dot"]),
    ("loaded_inverse_dynamics", &["u", "q", "loads"]),
    ("forward_dynamics", &["q", "u", "tau"]),
    ("loaded_forward_dynamics", &["loads", "q"]),
    ("mass_matrix_solve", &["tau", "q"]),
    ("mass_matrix", &["q"]),
    ("kinetic_energy", &["u", "q"]),
    ("center_of_mass_jacobian_dot_u", &["q", "u"]),
];

#[test]
fn second_derivatives_are_those_along_motions_at_constant_speeds() {
    let mut charts = [false; 2];
    for seed in trees::tried(580..=588) {
        let (_, tree) = system(seed);
        for body in &tree.bodies {
            if let Orientation::AngularVelocity { chart, .. } = body.joint.orientation {
                let is_angles = matches!(chart, ChartCoordinates::Angles(_));
                charts[usize::from(is_angles)] = true;
            }
        }
        let (state, mut random) = (State::random(&tree, seed), Random::new(seed));
        for (name, by) in CASES {
            let text = format!("hessian({name}; {})", by.join(", "));
            let hessian = request(&tree, &text);
            let weights = weights(&tree, &hessian);
            let n: usize = by.iter().map(|variable| n_entries(&tree, variable)).sum();
            let found = values(&tree, &hessian, &Plan::full(&tree), &state);
            let found = Matrix::new(n, whole(&tree, &hessian, &found, n));
            for _ in 0..3 {
                let mut drawn = || -> Directions {
                    // So that all joints together move as one does.
                    let size = 1.0 / (n as f64).sqrt();
                    let of = by.iter().map(|variable| {
                        let numbers = random.numbers(n_entries(&tree, variable));
                        (*variable, numbers.iter().map(|own| size * own).collect())
                    });
                    of.collect()
                };
                let (a, b) = (drawn(), drawn());
                let both = |sign: f64| -> Directions {
                    let pairs = a.iter().zip(&b).map(|((variable, a), (_, b))| {
                        let sum = a.iter().zip(b).map(|(a, b)| a + sign * b);
                        (*variable, sum.collect())
                    });
                    pairs.collect()
                };
                let at =
                    |directions: &Directions| along(&tree, name, &weights, (&state, directions));
                let expected = (at(&both(1.0)) - at(&both(-1.0))) / 4.0;
                let flat = |own: &Directions| -> Vec<f64> {
                    own.iter().flat_map(|(_, own)| own.clone()).collect()
                };
                let own = dot(&flat(&a), &found.times(&flat(&b)));
                let value = dot(
                    &values(&tree, &request(&tree, name), &Plan::full(&tree), &state),
                    &weights,
                );
                let scale = larger(larger(value.abs(), expected.abs()), 1.0);
                let error = relative_to(scale, &[own], &[expected]);
                let allowed = if inverts(name) { TWICE_INVERTED } else { TWICE };
                assert_within(format!("{seed}, {text}"), error, allowed);
            }
        }
    }
    // Where turns about several axes do not commute.
    assert_eq!(
        charts, [true; 2],
        "quaternions, and angles with angular velocities"
    );
}

#[test]
fn all_ways_give_the_same_second_derivatives() {
    for seed in trees::tried(581..=586) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        for text in [
            "hessian(inverse_dynamics; q, u, u_dot)",
            "hessian(forward_dynamics; q, u, tau)",
            "hessian(forward_dynamics; u)",
            "hessian(forward_dynamics; parameters, q)",
            "hessian(loaded_forward_dynamics; q, loads, tau)",
            "hessian(mass_matrix_solve; q, tau)",
            "hessian(mass_matrix_solve; q, parameters)",
        ] {
            let request = request(&tree, text);
            let plan = Plan::full(&tree);
            let swept = plan.with(Technique::DirectDerivatives, false);
            let ways = [
                (Formulation::Notes, plan.with(Technique::Reverse, false)),
                (Formulation::Notes, plan.with(Technique::Reverse, true)),
                (Formulation::Recursive, plan.with(Technique::Reverse, false)),
                (Formulation::Recursive, plan.with(Technique::Reverse, true)),
                (Formulation::Recursive, plan.with(Technique::Lockstep, true)),
                (Formulation::Recursive, swept),
            ];
            let all = ways.map(|(formulation, plan)| {
                evaluate_by(&tree, &request, formulation, &plan, &state)
            });
            for found in &all[1..] {
                let allowed = if inverts(text) { INVERTED } else { EXACT };
                assert_within(format!("{seed}, {text}"), relative(found, &all[0]), allowed);
            }
        }
    }
}

#[test]
fn joined_parts_are_what_each_is_alone() {
    for seed in trees::tried(581..=584) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        for parts in [
            &[
                "inverse_dynamics",
                "vjp(inverse_dynamics; q, u)",
                "hessian(inverse_dynamics; q, u)",
            ][..],
            &[
                "hessian(forward_dynamics; q, u, tau)",
                "forward_dynamics",
                "d(forward_dynamics)/d(q, tau)",
            ],
        ] {
            let of = |text: &str| values(&tree, &request(&tree, text), &Plan::full(&tree), &state);
            let alone: Vec<f64> = parts.iter().flat_map(|part| of(part)).collect();
            let joined = of(&parts.join("+"));
            let allowed = if inverts(parts[0]) { INVERTED } else { EXACT };
            assert_within(
                format!("{seed}, {parts:?}"),
                relative(&joined, &alone),
                allowed,
            );
        }
    }
}

#[test]
fn what_would_be_large_is_refused_with_its_size() {
    let base = Some(Base::Free);
    let path = "tests/robots/talos/talos.urdf";
    let tree = read(
        path,
        &Reading {
            base,
            ..Reading::default()
        },
    );
    let refused = |text: &str, without: &[Technique]| {
        let requests = [request(&tree, text)];
        let options = Options {
            without: without.iter().copied().collect(),
            ..Options::default()
        };
        let checked = compile::check_size(&tree, &requests, &options);
        checked.err().map(|error| error.to_string())
    };
    let swept = &[Technique::DirectDerivatives];
    assert_eq!(refused("hessian(inverse_dynamics; q, u)", swept), None);
    assert_eq!(refused("hessian(forward_dynamics; q, u, tau)", &[]), None);
    let told = refused("hessian(forward_dynamics; q, u, tau)", swept).expect("it is refused");
    let start = "`hessian(forward_dynamics; q, u, tau)`, by 114 variables, builds about ";
    let found = told.strip_prefix(start).expect(&told);
    assert!(
        found.ends_with(
            " operations; expected at most 4000000; ask for fewer variables, or for `vjp` and its differences"
        ),
        "{told}"
    );
}
