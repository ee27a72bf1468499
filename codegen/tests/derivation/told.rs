//! What one part of a joined function tells another, against the notes' equations of each.

use kane_codegen::{
    description::Reading,
    functions::{Arrangement, Formulation, Request},
    recursive::{Plan, Technique},
    tree::Tree,
};
use kane_test_support::{compare::assert_within, dynamics::State, systems::trees};

use crate::{
    compiled::read,
    derivatives::{EXACT, INVERTED, inverts},
    evaluator::input,
    frames::{evaluate_by, relative, request, system},
};

/// Parts of which one finds what others need.
const TOLD: [&[&str]; 9] = [
    &[
        "mass_matrix",
        "bias",
        "coriolis_matrix",
        "mass_matrix_dot",
        "mass_matrix_packed",
    ],
    &["d(inverse_dynamics)/d(u_dot, q)", "mass_matrix"],
    &["mass_matrix_packed", "d(forcing)/d(u)"],
    &["mass_matrix", "d(mass_matrix_product)/d(q)"],
    &["mass_matrix_inverse", "d(mass_matrix_solve)/d(q)"],
    &[
        "mass_matrix_inverse_packed",
        "hessian(forward_dynamics; q, u)",
        "forward_dynamics",
    ],
    &["coriolis_matrix", "d(bias)/d(u, q)", "mass_matrix"],
    &["mass_matrix", "packed(d(bias)/d(q))"],
    &[
        "mass_matrix_inverse",
        "d(forward_dynamics)/d(q)",
        "mass_matrix_packed",
        "mass_matrix_inverse_packed",
    ],
];

/// By one plan, each part in its own way.
fn apart(request: &Request, tree: &Tree, plan: &Plan) -> Arrangement {
    let together = request.arranged_by(tree, plan);
    let places = 0..request.parts().len();
    places.fold(together, |all, place| all.with_read_off(place, false))
}

/// Each part by another plan, every second one in its own way.
fn mixed(request: &Request, tree: &Tree) -> Arrangement {
    let (plain, full) = (Plan::plain(tree), Plan::full(tree));
    let plans = (0..request.parts().len()).map(|place| match place % 3 {
        0 => full.clone(),
        1 => plain.with(Technique::DirectDerivatives, true),
        _ => full.with(Technique::Articulated, false),
    });
    let own = Arrangement::new(plans);
    let places = (0..request.parts().len()).step_by(2);
    places.fold(own, |all, place| all.with_read_off(place, false))
}

/// By one plan, the parts from this one on every second one by the notes.
fn by_both(request: &Request, tree: &Tree, plan: &Plan, first: usize) -> Arrangement {
    let recursive = request.arranged_by(tree, plan);
    let notes = recursive.clone().with_formulation(Formulation::Notes);
    let places = (first..request.parts().len()).step_by(2);
    places.fold(recursive, |all, place| all.with_part(place, &notes))
}

fn operations(tree: &Tree, request: &Request, arrangement: &Arrangement) -> usize {
    let derived = request.derive_arranged(tree, arrangement);
    derived.graph.n_operations(&derived.roots)
}

#[test]
fn what_is_told_saves_operations() {
    let reading = Reading::default();
    let tree = read("tests/robots/panda/panda.urdf", &reading);
    let told = Plan::full(&tree).with(Technique::Lockstep, false);
    for parts in TOLD {
        let text = parts.join("+");
        let request = request(&tree, &text);
        let ways = [
            request.arranged_by(&tree, &told),
            apart(&request, &tree, &told),
        ];
        let [together, apart] = ways.map(|way| operations(&tree, &request, &way));
        // There the inverse is the same, node by node.
        let least_saved = usize::from(!text.contains("mass_matrix_solve"));
        assert!(
            together + least_saved <= apart,
            "{text}: {together} of {apart}"
        );
    }
}

#[test]
fn the_order_of_parts_does_not_matter() {
    let reading = Reading::default();
    let tree = read("tests/robots/panda/panda.urdf", &reading);
    let told = Plan::full(&tree).with(Technique::Lockstep, false);
    let orders = [
        "coriolis_matrix+d(inverse_dynamics)/d(u_dot)+mass_matrix",
        "mass_matrix+d(inverse_dynamics)/d(u_dot)+coriolis_matrix",
        "d(inverse_dynamics)/d(u_dot)+coriolis_matrix+mass_matrix",
    ];
    let [first, second, third] = orders.map(|text| {
        let request = request(&tree, text);
        operations(&tree, &request, &request.arranged_by(&tree, &told))
    });
    assert_eq!([first, first], [second, third]);
    let orders = [
        "gravity_forces+d(gravity_forces)/d(q)",
        "d(gravity_forces)/d(q)+gravity_forces",
    ];
    let [first, second] = orders.map(|text| {
        let request = request(&tree, text);
        operations(&tree, &request, &request.arranged_by(&tree, &told))
    });
    assert_eq!(first, second);
}

#[test]
fn the_rate_of_the_mass_matrix_has_its_zeros_beside_the_coriolis_matrix() {
    for seed in trees::tried(571..=594) {
        let (_, tree) = system(seed);
        let zeros = |text: &str| {
            let request = request(&tree, text);
            let derived = request.derive(&tree, Formulation::Recursive, &Plan::full(&tree));
            let roots = derived.roots.iter();
            let rate = roots.take(tree.n_speeds * tree.n_speeds);
            rate.map(|root| derived.graph.is_zero(*root))
                .collect::<Vec<bool>>()
        };
        let alone = zeros("mass_matrix_dot");
        assert_eq!(zeros("mass_matrix_dot+coriolis_matrix"), alone, "{seed}");
    }
}

#[test]
fn what_is_told_is_what_the_notes_say() {
    for seed in trees::tried(571..=594) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        for parts in TOLD {
            let alone = parts.iter().flat_map(|part| {
                let alone = request(&tree, part);
                evaluate_by(
                    &tree,
                    &alone,
                    Formulation::Notes,
                    &Plan::plain(&tree),
                    &state,
                )
            });
            let expected: Vec<f64> = alone.collect();
            let text = parts.join("+");
            let joined = request(&tree, &text);
            let full = Plan::full(&tree);
            let one_by_one = full.with(Technique::Lockstep, false);
            let ways = [
                joined.arranged_by(&tree, &full),
                joined.arranged_by(&tree, &one_by_one),
                apart(&joined, &tree, &full),
                mixed(&joined, &tree),
                by_both(&joined, &tree, &one_by_one, 0),
                by_both(&joined, &tree, &one_by_one, 1),
            ];
            for way in ways {
                let derived = joined.derive_arranged(&tree, &way);
                let graph = &derived.graph;
                let found = graph.evaluate(&derived.roots, |given| input(&tree, &state, given));
                let allowed = if inverts(&text) { INVERTED } else { EXACT };
                assert_within(
                    format!("{seed}, {text}"),
                    relative(&found, &expected),
                    allowed,
                );
            }
        }
    }
}
