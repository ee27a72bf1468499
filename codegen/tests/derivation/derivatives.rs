//! Derivatives: of every function by every variable against differences of order 12, and every way to them against each other.

use kane_codegen::{
    description::Reading,
    expr::{Expr, Input},
    functions::{Argument, Formulation, Function, Request},
    id::ParameterId,
    recursive::{Plan, Technique},
    tree::Tree,
};
use kane_test_support::{
    compare::{assert_within, larger, largest, relative_to},
    dynamics::State,
    numeric::derivative,
    systems::trees,
};

use crate::{
    compiled::read,
    evaluator::input,
    frames::{evaluate_by, relative, request, system},
    products::every_function,
};

/// How far two ways to one derivative may be apart, relative to its largest entry and to one.
pub(crate) const EXACT: f64 = 1e-12;

/// How far differences may be off, relative to the largest entry of the values and of the derivative: see
/// [`derivative`], of sums that are ten times as large as what is left of them.
pub(crate) const DIFFERENCED: f64 = 1e-11;

/// The same where the mass matrix is inverted, twice in a derivative, whose condition numbers here are below 1e4.
pub(crate) const INVERTED: f64 = 1e-9;

/// The variables of a function, in the order of its arguments.
pub(crate) fn variables(tree: &Tree, function: &Function) -> Vec<String> {
    let known = [
        Argument::Q,
        Argument::U,
        Argument::UDot,
        Argument::Tau,
        Argument::Loads,
    ];
    let arguments = known.into_iter();
    let arguments = arguments.filter(|argument| function.arguments.contains(argument));
    let names = arguments.map(|argument| argument.name().to_owned());
    let has_values = !tree.parameters.is_empty();
    names
        .chain(has_values.then(|| "parameters".to_owned()))
        .collect()
}

/// Coulomb friction jumps where a speed turns round, which lies within the differences' steps.
pub(crate) fn jumps(function: &str, variable: &str) -> bool {
    function == "joint_regressor" && variable == "u"
}

pub(crate) fn values(tree: &Tree, request: &Request, plan: &Plan, state: &State) -> Vec<f64> {
    evaluate_by(tree, request, Formulation::Recursive, plan, state)
}

/// Ways to differentiate by the notes' equations or the recursion.
pub(crate) fn ways(tree: &Tree) -> [(Formulation, Plan); 5] {
    let [sweep, reverse] = [false, true].map(|is_reverse| {
        let plan = Plan::full(tree).with(Technique::DirectDerivatives, false);
        plan.with(Technique::Reverse, is_reverse)
    });
    [
        (Formulation::Notes, sweep.clone()),
        (Formulation::Notes, reverse.clone()),
        (Formulation::Recursive, sweep),
        (Formulation::Recursive, reverse),
        (Formulation::Recursive, Plan::full(tree)),
    ]
}

#[test]
fn all_ways_give_the_same_derivatives() {
    for seed in trees::tried(501..=530) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        for text in [
            "d(inverse_dynamics)/d(q, u, u_dot)",
            "d(loaded_inverse_dynamics)/d(u_dot, u, q, loads)",
            "d(loaded_inverse_dynamics)/d(q, u)",
            "d(bias)/d(q, u)",
            "d(forward_dynamics)/d(q, u, tau)",
            "d(loaded_forward_dynamics)/d(q, u, tau)",
            "d(mass_matrix_product)/d(q, u_dot)",
            "d(mass_matrix_solve)/d(q, tau)",
            "d(inverse_dynamics)/d(u_dot)",
            "d(mass_matrix_product)/d(u_dot)",
            "d(loaded_forward_dynamics)/d(tau)",
            "packed(d(mass_matrix_solve)/d(tau))",
            "d(center_of_mass)/d(q)",
            "d(center_of_mass_velocity)/d(u)",
            "d(center_of_mass_jacobian)/d(q)",
            "centroidal_momentum_matrix+d(centroidal_momentum_matrix)/d(q)",
            "d(potential_energy)/d(q)",
            "d(kinetic_energy)/d(q, u)",
            "d(linear_momentum)/d(q, u)",
            "d(angular_momentum)/d(q, u)",
            "angular_momentum+d(angular_momentum)/d(u)",
            "linear_momentum+d(linear_momentum)/d(q, u)",
            "d(center_of_mass_velocity)/d(q, u)",
            "center_of_mass_jacobian_dot_u+d(center_of_mass_jacobian_dot_u)/d(q, u)",
            "d(centroidal_momentum_matrix_dot_u)/d(q, u)",
            "d(pose(\"marker one\"))/d(q)",
            "d(pose(turned, \"marker one\"))/d(q)",
            "d(pose(\"marker one\", turned))/d(q)",
            "packed(d(pose(turned))/d(q))",
            "d(jacobian(\"marker one\"))/d(q)",
            "d(jacobian(turned, local))/d(q)",
            "d(jacobian(turned, \"marker one\"))/d(q)",
            "d(jacobian_packed(\"marker one\"))/d(q)",
            "d(point_jacobian(turned))/d(q)",
            "d(velocity(\"marker one\"))/d(q, u)",
            "velocity(turned, local)+d(velocity(turned, local))/d(u, q)",
            "d(velocity(\"marker one\"))/d(u)",
            "d(acceleration(turned, local))/d(u_dot)",
            "acceleration(\"marker one\")+d(acceleration(\"marker one\"))/d(q, u, u_dot)",
            "d(acceleration(turned, local))/d(q, u, u_dot)",
            "imu(turned)+d(imu(turned))/d(q, u, u_dot)",
            "d(imu(\"marker one\"))/d(u_dot, q)",
            "d(jacobian_dot_u(turned))/d(u, q)",
            "d(jacobian_dot_u(\"marker one\", local))/d(q)",
            "d(position(turned))/d(q)",
            "d(position(turned, \"marker one\"))/d(q)",
            "linear_velocity(turned)+d(linear_velocity(turned))/d(q, u)",
            "d(linear_acceleration(\"marker one\"))/d(q, u, u_dot)",
            "d(linear_jacobian(\"marker one\", local))/d(q)",
            "d(linear_jacobian_packed(turned))/d(q)",
            "d(linear_jacobian_dot_u(turned))/d(q, u)",
        ] {
            let request = request(&tree, text);
            let all = ways(&tree).map(|(formulation, plan)| {
                evaluate_by(&tree, &request, formulation, &plan, &state)
            });
            for (way, found) in all.iter().enumerate().skip(1) {
                let what = format!("{seed}, {text}, way {way}");
                let allowed = if inverts(text) { INVERTED } else { EXACT };
                assert_within(what, relative(found, &all[0]), allowed);
            }
        }
    }
}

/// What a function, derived once, gives in the state that lies `t` away along an entry of a variable.
pub(crate) fn moved(
    tree: &Tree,
    request: &Request,
    state: &State,
    variable: &str,
) -> impl Fn(usize, f64) -> Vec<f64> {
    let derived = request.derive(tree, Formulation::Recursive, &Plan::full(tree));
    move |entry, t| {
        let mut state = state.clone();
        match variable {
            "q" => state = state.displaced(tree, entry, t),
            "u" => state.u[entry] += t,
            "u_dot" => state.u_dot[entry] += t,
            "tau" => state.tau[entry] += t,
            "loads" => state.loads[entry / 6][entry % 6] += t,
            _ => {}
        }
        let graph = &derived.graph;
        graph.evaluate(&derived.roots, |given| match given {
            Input::Parameter(id) if variable == "parameters" && id.index() == entry => {
                input(tree, &state, given) + t
            }
            given => input(tree, &state, given),
        })
    }
}

/// The entries of a variable, and a step along each for differences.
pub(crate) fn n_entries(tree: &Tree, variable: &str) -> usize {
    match variable {
        "loads" => 6 * tree.bodies.len(),
        "parameters" => tree.parameters.len(),
        _ => tree.n_speeds,
    }
}

pub(crate) fn inverts(name: &str) -> bool {
    let inverting = [
        "forward_dynamics",
        "factors",
        "pivots",
        "solve",
        "inverse_packed",
        "matrix_inverse",
        "hybrid",
    ];
    inverting.iter().any(|part| name.contains(part))
}

#[test]
fn every_function_changes_as_its_derivatives_say() {
    for seed in trees::tried(506..=508) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        for (function, name) in every_function(&tree) {
            let whole = request(&tree, &name);
            let at = values(&tree, &whole, &Plan::full(&tree), &state);
            for variable in variables(&tree, function) {
                if jumps(&name, &variable) {
                    continue;
                }
                let text = format!("d({name})/d({variable})");
                let found = values(&tree, &request(&tree, &text), &Plan::full(&tree), &state);
                let n = n_entries(&tree, &variable);
                assert_eq!(found.len(), at.len() * n, "{text}");
                let along = moved(&tree, &whole, &state, &variable);
                for entry in 0..n {
                    let expected = derivative(|t| along(entry, t));
                    let own: Vec<f64> = found.chunks(n).map(|row| row[entry]).collect();
                    let scale = larger(larger(largest(&at), largest(&expected)), 1.0);
                    let error = relative_to(scale, &own, &expected);
                    let allowed = if inverts(&name) {
                        INVERTED
                    } else {
                        DIFFERENCED
                    };
                    assert_within(format!("{seed}, {text}, {entry}"), error, allowed);
                }
            }
        }
    }
}

/// What each of several variables has of a function's derivatives by all of them.
fn shares(tree: &Tree, name: &str, variables: &[String], whole: &[f64]) -> Vec<Vec<f64>> {
    let request = request(tree, name);
    let mut shares = vec![Vec::new(); variables.len()];
    let mut rest = whole;
    for lengths in request.lengths(tree, 0) {
        let n_rows: usize = lengths.iter().product();
        for (share, variable) in shares.iter_mut().zip(variables) {
            let (own, others) = rest.split_at(n_rows * n_entries(tree, variable));
            share.extend_from_slice(own);
            rest = others;
        }
    }
    shares
}

/// A variable that is not asked for is a constant to a sweep, which may differentiate what has it in another way.
#[test]
fn by_several_variables_at_once_it_changes_as_by_each_alone() {
    for seed in trees::tried(501..=504) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        for (function, name) in every_function(&tree) {
            let variables = variables(&tree, function);
            if variables.len() < 2 {
                continue;
            }
            let by = |by: &str, plan: &Plan| {
                values(
                    &tree,
                    &request(&tree, &format!("d({name})/d({by})")),
                    plan,
                    &state,
                )
            };
            let recursive = ways(&tree).into_iter();
            let recursive =
                recursive.filter(|(formulation, _)| *formulation == Formulation::Recursive);
            for (way, (_, plan)) in recursive.enumerate() {
                let whole = by(&variables.join(", "), &plan);
                let shares = shares(&tree, &name, &variables, &whole);
                for (variable, share) in variables.iter().zip(shares) {
                    let error = relative(&share, &by(variable, &plan));
                    let allowed = if inverts(&name) { INVERTED } else { EXACT };
                    assert_within(
                        format!("{seed}, {name} by {variable}, way {way}"),
                        error,
                        allowed,
                    );
                }
            }
        }
    }
}

#[test]
fn a_named_parameter_has_the_column_of_all() {
    let (_, tree) = system(511);
    let state = State::random(&tree, 511);
    let all = request(&tree, "d(bias)/d(parameters)");
    let all = values(&tree, &all, &Plan::full(&tree), &state);
    let n = tree.parameters.len();
    assert!(n > 0);
    for place in 0..n {
        let name = &tree.parameters[ParameterId::new(place).index()].name;
        let one = request(&tree, &format!("d(bias)/d({name})"));
        let one = values(&tree, &one, &Plan::full(&tree), &state);
        let column: Vec<f64> = all.chunks(n).map(|row| row[place]).collect();
        assert_within(name, relative(&one, &column), EXACT);
    }
}

/// A number that single precision rounds to zero would divide by it.
#[expect(clippy::cast_possible_truncation, reason = "to see what is lost")]
#[test]
fn derivatives_of_sizes_have_no_number_that_single_precision_makes_zero() {
    let tree = read("models/eight_body.toml", &Reading::default());
    let request = request(&tree, "d(singularity)/d(q)");
    let derived = request.derive(&tree, Formulation::Notes, &Plan::full(&tree));
    let graph = &derived.graph;
    let numbers = graph.ids().filter_map(|id| graph.as_number(Expr::of(id)));
    let numbers: Vec<f64> = numbers.filter(|number| *number != 0.0).collect();
    assert!(numbers.iter().any(|number| *number < 1e-30));
    let zero = numbers.iter().find(|number| **number as f32 == 0.0);
    assert_eq!(zero, None);
}
