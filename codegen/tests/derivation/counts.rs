//! Operation counts, pinned: a change that raises one explains itself.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::{collections::BTreeSet, fmt::Write as _, fs};

use crate::{compiled::read, pages};
use kane_codegen::{
    compile,
    config::{Formulation, Functions},
    description::{Base, Chart, Reading},
    expr::SINE,
    functions::{CATALOGUE, Function},
    options::Options,
    program::Operations,
    tree::Tree,
};
use kane_test_support::{
    models,
    systems::{RandomSystem, Sizes, Style},
};

const NAMED: [&str; 6] = [
    "generalized_forces",
    "mass_matrix",
    "forcing",
    "bias",
    "inverse_dynamics",
    "forward_dynamics",
];

fn model(path: &str) -> Tree {
    read(path, &Reading::default())
}

pub(crate) fn counts(
    tree: &Tree,
    functions: Functions,
    formulation: Formulation,
) -> Vec<(String, Operations)> {
    let compiled = compile::compile(
        tree,
        &Options {
            functions,
            formulation,
            ..Options::default()
        },
    )
    .unwrap();
    compiled
        .functions
        .iter()
        .map(|emittable| (emittable.request.name(), emittable.operations))
        .collect()
}

/// The counts of these alone, each in the cheapest way: what every module has beside them is left out.
pub(crate) fn counts_of<R: ToString>(tree: &Tree, requests: &[R]) -> Vec<(String, Operations)> {
    let names = requests.iter().map(ToString::to_string).collect();
    let mut counts = counts(tree, Functions::Named(names), Formulation::Cheapest);
    counts.retain(|(name, _)| !["q_dot", "normalize"].contains(&name.as_str()));
    counts
}

fn dynamics(tree: &Tree, formulation: Formulation) -> Vec<(String, Operations)> {
    let names = NAMED.iter().map(ToString::to_string).collect();
    let mut counts = counts(tree, Functions::Named(names), formulation);
    counts.retain(|(name, _)| name != "q_dot");
    counts
}

pub(crate) fn table(counts: &[(String, Operations)]) -> String {
    counts
        .iter()
        .fold(String::new(), |mut text, (name, operations)| {
            writeln!(text, "{name}: {operations}").unwrap();
            text
        })
}

#[test]
fn robots() {
    let mut text = String::new();
    let mut robot = |name: &str, base: Option<Base>, chart: Option<Chart>| {
        let path = format!("tests/robots/{name}/{name}.urdf");
        let tree = read(
            &path,
            &Reading {
                base,
                chart,
                ..Reading::default()
            },
        );
        let chart = match chart {
            Some(Chart::Angles) => ", floating by angles",
            Some(Chart::Quaternion) => ", floating by a quaternion",
            None => "",
        };
        let counts = dynamics(&tree, Formulation::Cheapest);
        write!(text, "{name}{chart}\n{}", table(&counts)).unwrap();
    };
    for name in ["double_pendulum", "ur5", "panda"] {
        robot(name, None, None);
    }
    for name in ["solo12", "talos"] {
        for chart in [Chart::Quaternion, Chart::Angles] {
            robot(name, Some(Base::Free), Some(chart));
        }
    }
    insta::assert_snapshot!(text);
}

const OF_SYSTEMS: [&str; 14] = [
    "loaded_inverse_dynamics",
    "loaded_forward_dynamics",
    "kinetic_energies",
    "potential_energies",
    "joint_wrenches",
    "center_of_mass",
    "center_of_mass_velocity",
    "center_of_mass_jacobian",
    "center_of_mass_jacobian_dot_u",
    "centroidal_momentum_matrix",
    "centroidal_momentum_matrix_dot_u",
    "regressor",
    "regressor_packed",
    "base_regressor",
];

const MATRICES: [&str; 8] = [
    "mass_matrix_product",
    "mass_matrix_solve",
    "mass_matrix_inverse",
    "mass_matrix_factors",
    "coriolis_matrix",
    "mass_matrix_dot",
    "mass_matrix+mass_matrix_dot",
    "jvp(mass_matrix_dot; q, u)",
];

/// The counts of functions of the robots, those with legs on a free base.
fn of_robots(names: &[&str]) -> String {
    let mut text = String::new();
    for robot in ["ur5", "panda", "solo12", "talos"] {
        let path = format!("tests/robots/{robot}/{robot}.urdf");
        let base = ["solo12", "talos"].contains(&robot).then_some(Base::Free);
        let tree = read(
            &path,
            &Reading {
                base,
                ..Reading::default()
            },
        );
        write!(text, "{robot}\n{}", table(&counts_of(&tree, names))).unwrap();
    }
    text
}

#[test]
fn matrices_of_robots() {
    let text = of_robots(&MATRICES);
    insta::assert_snapshot!(text);
    let functions = [(3, "coriolis_matrix"), (4, "mass_matrix_inverse")];
    pages::comparison().has_robots(&text, 7, &functions);
}

/// Of all derivatives of forces, of those that an integrator needs, and of accelerations.
const DERIVATIVES: [&str; 5] = [
    "d(inverse_dynamics)/d(q, u, u_dot)",
    "inverse_dynamics+d(inverse_dynamics)/d(q, u)",
    "d(forward_dynamics)/d(q, u, tau)",
    "d(mass_matrix_product)/d(q, u_dot)",
    "d(mass_matrix_solve)/d(q, tau)",
];

#[test]
fn derivatives_of_robots() {
    let text = of_robots(&DERIVATIVES);
    let forces = "d_inverse_dynamics_d_q_u_u_dot";
    let accelerations = "d_forward_dynamics_d_q_u_tau";
    insta::assert_snapshot!(text);
    pages::performance().has_robots(&text, 7, &[(2, forces), (4, accelerations)]);
    pages::comparison().has_robots(&text, 5, &[(2, forces), (3, accelerations)]);
}

/// The derivatives need the accelerations themselves.
#[test]
fn accelerations_beside_their_derivatives_cost_nothing() {
    for robot in ["ur5", "panda"] {
        let tree = model(&format!("tests/robots/{robot}/{robot}.urdf"));
        for function in ["forward_dynamics", "loaded_forward_dynamics"] {
            let derivatives = format!("d({function})/d(q, u, tau)");
            let total = |request: &str| counts_of(&tree, &[request])[0].1.total();
            let together = total(&format!("{function} + {derivatives}"));
            assert_eq!(together, total(&derivatives), "{robot}, {function}");
        }
    }
}

/// A gradient with its value, a directional derivative, and a gradient of accelerations.
const PRODUCTS: [&str; 3] = [
    "inverse_dynamics+vjp(inverse_dynamics; q, u, u_dot)",
    "jvp(inverse_dynamics; q, u, u_dot)",
    "vjp(forward_dynamics; q, u, tau)",
];

#[test]
fn products_with_derivatives_of_robots() {
    let text = of_robots(&PRODUCTS);
    let with_value = "inverse_dynamics_and_vjp_inverse_dynamics_q_u_u_dot";
    let accelerations = "vjp_forward_dynamics_q_u_tau";
    insta::assert_snapshot!(text);
    pages::performance().has_robots(&text, 5, &[(2, with_value), (3, accelerations)]);
}

#[test]
fn derivatives_by_loads_and_parameters_beside_others() {
    let mut text = String::new();
    for (path, inner, by) in [
        ("tests/robots/ur5/ur5.urdf", "loaded_", "loads"),
        ("tests/robots/panda/panda.urdf", "loaded_", "loads"),
        ("models/cart_pole.toml", "", "parameters"),
    ] {
        let tree = model(path);
        let requests = [
            format!("d({inner}inverse_dynamics)/d(q, u, u_dot, {by})"),
            format!("d({inner}forward_dynamics)/d({by})"),
            format!("d({inner}forward_dynamics)/d(q, {by})"),
            format!("d({inner}forward_dynamics)/d(q, u, tau, {by})"),
        ];
        write!(text, "{path}\n{}", table(&counts_of(&tree, &requests))).unwrap();
    }
    insta::assert_snapshot!(text);
}

#[test]
fn second_derivatives_of_robots() {
    let mut text = String::new();
    for robot in ["ur5", "panda"] {
        let tree = model(&format!("tests/robots/{robot}/{robot}.urdf"));
        let requests = [
            "hessian(inverse_dynamics; q, u)",
            "inverse_dynamics+vjp(inverse_dynamics; q, u)+hessian(inverse_dynamics; q, u)",
            "hessian(forward_dynamics; q, u, tau)",
        ];
        write!(text, "{robot}\n{}", table(&counts_of(&tree, &requests))).unwrap();
    }
    let [together, alone] = [
        "ur5\ninverse_dynamics_and_vjp_inverse_dynamics_q_u_and_hessian_inverse_dynamics_q_u: ",
        "\nhessian_inverse_dynamics_q_u: ",
    ]
    .map(|function| {
        let count = text.split_once(function).unwrap().1;
        let (count, _) = count.split_once(' ').unwrap();
        format!("{},{}", &count[..1], &count[1..])
    });
    insta::assert_snapshot!(text);
    pages::functions().says(&format!(
        "takes {together} operations, of which the second derivatives alone take {alone}."
    ));
}

#[test]
fn accelerations_and_first_derivatives_are_free_beside_second_ones() {
    let second = "hessian(forward_dynamics; q, u, tau)";
    let all = format!("forward_dynamics+d(forward_dynamics)/d(q, u, tau)+{second}");
    for robot in ["ur5", "panda"] {
        let tree = model(&format!("tests/robots/{robot}/{robot}.urdf"));
        let [alone, joined] = [second, &all].map(|request| {
            let counts = counts_of(&tree, &[request]);
            assert_eq!(counts.len(), 1);
            counts[0].1
        });
        assert_eq!(joined, alone, "{robot}");
    }
}

#[test]
fn systems_of_robots() {
    let text = of_robots(&OF_SYSTEMS);
    insta::assert_snapshot!(text);
    pages::comparison().has_robots(&text, 7, &[(5, "regressor")]);
}

const ENERGIES: [&str; 18] = [
    "kinetic_energy",
    "potential_energy",
    "linear_momentum",
    "angular_momentum",
    "d(kinetic_energy)/d(q, u)",
    "d(kinetic_energy)/d(u)",
    "d(angular_momentum)/d(q, u)",
    "d(angular_momentum)/d(u)",
    "d(centroidal_momentum_matrix_dot_u)/d(q, u)",
    "d(center_of_mass)/d(q)",
    "d(center_of_mass_velocity)/d(q, u)",
    "d(center_of_mass_jacobian)/d(q)",
    "d(centroidal_momentum_matrix)/d(q)",
    "d(potential_energy)/d(q)",
    "vjp(angular_momentum; q, u)",
    "d(gravity_forces)/d(q)",
    "hessian(potential_energy; q)",
    "vjp(center_of_mass; q)",
];

#[test]
fn energies_and_momenta_of_robots() {
    insta::assert_snapshot!(of_robots(&ENERGIES));
}

#[test]
fn eight_free_bodies_literally() {
    insta::assert_snapshot!(table(&dynamics(
        &model("models/eight_body.toml"),
        Formulation::Notes
    )));
}

#[test]
fn eight_free_bodies_along_the_tree() {
    insta::assert_snapshot!(table(&dynamics(
        &model("models/eight_body.toml"),
        Formulation::Recursive
    )));
}

#[test]
fn eight_free_bodies_every_function() {
    insta::assert_snapshot!(table(&counts(
        &model("models/eight_body.toml"),
        Functions::All(Vec::new()),
        Formulation::Cheapest
    )));
}

#[test]
fn the_smallest_systems() {
    for name in ["pendulum", "cart_pole"] {
        let tree = model(&format!("codegen/tests/models/{name}.toml"));
        insta::assert_snapshot!(name, table(&dynamics(&tree, Formulation::Cheapest)));
    }
}

#[test]
fn the_cheapest_is_never_dearer_than_either_formulation() {
    let derivatives = [
        "d(bias)/d(q)",
        "d(kinetic_energy)/d(q, u)",
        "d(kinetic_energy)/d(u)",
        "d(angular_momentum)/d(q, u)",
        "d(angular_momentum)/d(u)",
        "d(center_of_mass)/d(q)",
        "d(center_of_mass_jacobian)/d(q)",
        "vjp(inverse_dynamics; q, u, u_dot)",
    ];
    for path in [
        "models/eight_body.toml",
        "codegen/tests/models/pendulum.toml",
        "codegen/tests/models/cart_pole.toml",
    ] {
        let tree = model(path);
        let of = |formulation| {
            let names = NAMED.iter().chain(&derivatives).map(ToString::to_string);
            counts(&tree, Functions::Named(names.collect()), formulation)
        };
        let cheapest = of(Formulation::Cheapest);
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            for ((name, best), (_, other)) in cheapest.iter().zip(of(formulation)) {
                assert!(
                    best.total() <= other.total(),
                    "{path} {name}: {best} against {other}"
                );
            }
        }
    }
}

#[test]
fn runtime_parameters_leave_the_loop_nearly_as_it_is() {
    let text = fs::read_to_string(format!(
        "{}/../models/eight_body.toml",
        env!("CARGO_MANIFEST_DIR")
    ))
    .unwrap();
    let tree = models::build(&models::at_run_time(&text)).unwrap().tree;
    assert_eq!(tree.parameters.len(), 8 * (1 + 3 + 6 + 3));
    insta::assert_snapshot!(table(&dynamics(&tree, Formulation::Recursive)));
}

/// Two hinges across each other: the notes need more operations than the recursion as they are derived, and fewer once their values are
/// made of others (`passes::reuse`).
const ACROSS: &str = r#"
name = "across"
gravity = [0.0, 0.0, -9.81]
lower_bodies = [0, 1]

[[body]]
name = "a"
mass = 2.0
mass_center = [0.0, 0.0, 0.1]
inertia = { xx = 0.1, yy = 0.1, zz = 0.1, xy = 0.0, xz = 0.0, yz = 0.0 }
attachment = [0.0, 0.0, 0.0]
joint = ["theta1"]

[[body]]
name = "b"
mass = 1.0
mass_center = [0.0, 0.0, 0.1]
inertia = { xx = 0.1, yy = 0.1, zz = 0.1, xy = 0.0, xz = 0.0, yz = 0.0 }
attachment = [0.0, 0.0, 0.5]
joint = ["theta2"]
damping = 0.1
"#;

#[test]
fn the_formulation_of_a_small_system_costs_least_as_it_is_written() {
    let cost = |operations: &Operations| operations.total() + (SINE - 1) * operations.trig;
    let random = (900..920).map(|seed| {
        let sizes = Sizes {
            bodies: 1 + usize::try_from(seed % 4).unwrap(),
            speeds: 6,
        };
        RandomSystem::new(seed, sizes, Style::Plain).toml()
    });
    for text in std::iter::once(ACROSS.to_owned()).chain(random) {
        let tree = models::build(&text).unwrap().tree;
        let [notes, recursive] = [Formulation::Notes, Formulation::Recursive]
            .map(|formulation| dynamics(&tree, formulation));
        let chosen = dynamics(&tree, Formulation::Cheapest);
        let both = notes.iter().zip(&recursive);
        for ((name, chosen), ((_, notes), (_, recursive))) in chosen.iter().zip(both) {
            let least = cost(notes).min(cost(recursive));
            assert_eq!(cost(chosen), least, "{name} of\n{text}");
        }
    }
}

#[test]
fn the_catalogue_names_each_function_once() {
    let names = Function::names();
    let different: BTreeSet<&str> = names.iter().copied().collect();
    assert_eq!(names.len(), different.len());
    assert!(names.len() > CATALOGUE.len(), "functions of frames too");
}
