//! Several functions in one: the same numbers, with the work that they share done once.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::{
    collections::BTreeMap,
    fmt::Write as _,
    fs,
    sync::{Arc, LazyLock, Mutex, OnceLock},
};

use kane_codegen::{
    compile::{self, Emittable},
    config::{self, Functions},
    description::{Base, Reading, no_includes},
    diagnostic::Source,
    functions::{Formulation, Parsed, Request, RequestError},
    generate::generate,
    options::Options,
    program::Operations,
    tree::Tree,
};
use kane_test_support::compare::{Tolerance, assert_close};

use crate::{
    compiled::{compiled, input, read},
    pages,
};

/// What control loops ask for together.
const JOINED: [&str; 6] = [
    "mass_matrix+bias",
    "mass_matrix+bias+gravity_forces",
    "inverse_dynamics+forward_dynamics",
    "rotation+mass_center_position+mass_matrix+bias",
    "kinetic_energy+potential_energy",
    "mass_center_position+coriolis_matrix",
];

/// Of these one part finds what others need.
const TOLD: [&str; 6] = [
    "mass_matrix+coriolis_matrix+gravity_forces",
    "mass_matrix_packed+mass_matrix_dot+coriolis_matrix+bias",
    "d(inverse_dynamics)/d(q, u)+mass_matrix",
    "mass_matrix_packed+d(bias)/d(q, u)",
    "mass_matrix_inverse+d(forward_dynamics)/d(q, u)+mass_matrix",
    "loaded_forward_dynamics+d(loaded_forward_dynamics)/d(q, u)+mass_matrix_inverse_packed",
];

/// A model of this repository, and what of it was compiled, which several tests look at.
struct Model {
    path: &'static str,
    tree: Tree,
    alone: Mutex<BTreeMap<String, Compiled>>,
}

/// One function alone in its module, with its values, once it is compiled.
type Compiled = Arc<OnceLock<(Emittable, Vec<f64>)>>;

impl Model {
    fn new(path: &'static str, base: Option<Base>) -> Self {
        let reading = Reading {
            base,
            ..Reading::default()
        };
        let (tree, alone) = (read(path, &reading), Mutex::default());
        Self { path, tree, alone }
    }

    /// What is found of a function that is alone in its module.
    fn alone<T>(&self, name: &str, of: impl FnOnce(&Emittable, &[f64]) -> T) -> T {
        let mut known = self.alone.lock().unwrap();
        let own = known.entry(name.to_owned()).or_default().clone();
        drop(known);
        let compile = || compiled(&self.tree, &[name]).remove(name).unwrap();
        let (emittable, values) = own.get_or_init(compile);
        of(emittable, values)
    }

    fn operations(&self, name: &str) -> Operations {
        self.alone(name, |own, _| own.operations)
    }

    fn values(&self, name: &str) -> Vec<f64> {
        self.alone(name, |_, values| values.to_vec())
    }
}

/// Models with hinges and sliders, joints of several angles, quaternions, followers, runtime values.
static MODELS: LazyLock<[Model; 6]> = LazyLock::new(|| {
    [
        Model::new("codegen/tests/models/cart_pole.toml", None),
        Model::new("codegen/tests/models/pendulum.toml", None),
        Model::new("models/eight_body.toml", None),
        Model::new("tests/robots/gripper/gripper.urdf", None),
        Model::new("tests/robots/panda/panda.urdf", Some(Base::Fixed)),
        Model::new("tests/robots/solo12/solo12.urdf", Some(Base::Free)),
    ]
});

/// The one with that file.
fn model(path: &str) -> &'static Model {
    MODELS
        .iter()
        .find(|model| model.path.ends_with(path))
        .unwrap()
}

#[test]
fn outputs_are_those_of_the_separate_functions_in_the_order_asked_for() {
    for model in &*MODELS {
        for joined in JOINED.into_iter().chain(TOLD) {
            let found = model.values(joined);
            let parts = joined.split('+');
            let expected: Vec<f64> = parts.flat_map(|part| model.values(part)).collect();
            let at = format!("{} {joined}", model.path);
            assert_close(
                at,
                &found,
                &expected,
                Tolerance::relative_beyond(1.0, 1e-12),
            );
        }
    }
}

#[test]
fn expressions_of_one_formulation_have_the_bits_of_the_separate_ones() {
    for Model { path, tree, .. } in &*MODELS {
        for formulation in [Formulation::Notes, Formulation::Recursive] {
            for joined in JOINED {
                let evaluated = |text: &str| {
                    let derived = Request::parse(text).unwrap().derive(
                        tree,
                        formulation,
                        &kane_codegen::recursive::Plan::full(tree),
                    );
                    derived
                        .graph
                        .evaluate(&derived.roots, |given| input(tree, given))
                };
                let expected: Vec<f64> = joined.split('+').flat_map(evaluated).collect();
                assert_eq!(evaluated(joined), expected, "{path} {joined}");
            }
        }
    }
}

#[test]
fn shared_work_is_done_once() {
    for model in &*MODELS {
        let path = model.path;
        for joined in JOINED.into_iter().chain(TOLD) {
            let request = model.alone(joined, |own, _| own.request.clone());
            let whole = model.operations(joined);
            // A sine costs more than another operation; alone, a part may take one more to save others.
            let cost = |operations: Operations| compile::cost(&request, operations);
            let parts = joined.split('+');
            let parts: Vec<Operations> = parts.map(|part| model.operations(part)).collect();
            let apart: usize = parts.iter().map(|part| cost(*part)).sum();
            let sines = parts.iter().map(|part| part.trig);
            let most = sines.clone().max().expect("a part at least");
            let shares = sines.sum::<usize>() > most;
            assert!(
                cost(whole) < apart || !shares,
                "{path} {joined}: {whole}, apart at a cost of {apart}"
            );
            assert!(cost(whole) <= apart, "{path} {joined}");
            assert_eq!(whole.trig, most, "{path} {joined}: one sine an angle");
        }
    }
}

#[test]
fn parts_that_want_other_plans_get_them() {
    for (path, joined) in [
        (
            "solo12.urdf",
            "mass_matrix_factors+d(hybrid_dynamics)/d(q, u)",
        ),
        (
            "panda.urdf",
            "hessian(mass_matrix_solve; q, tau)+jvp(bias; q, u)",
        ),
    ] {
        let count = |text: &str| model(path).operations(text).total();
        let apart: usize = joined.split('+').map(count).sum();
        let whole = count(joined);
        assert!(whole < apart, "{joined}: {whole} of {apart}");
    }
}

#[test]
fn operations_of_robots() {
    let mut text = String::new();
    for model in &MODELS[2..] {
        for joined in JOINED.into_iter().chain(TOLD) {
            let whole = model.operations(joined);
            let parts = joined.split('+');
            let separate: usize = parts.map(|part| model.operations(part).total()).sum();
            let name = model.path.rsplit('/').next().unwrap();
            writeln!(text, "{name} {joined}: {whole}; apart {separate}").unwrap();
        }
    }
    insta::assert_snapshot!(text);
}

#[test]
fn derivatives_of_one_function_asked_for_apart_cost_no_more_than_together() {
    let arm = Model::new("tests/robots/ur5/ur5.urdf", Some(Base::Fixed));
    for model in [&arm, model("solo12.urdf")] {
        let path = model.path;
        let count = |text: &str| model.operations(text).total();
        for (function, first, second) in [
            ("inverse_dynamics", "q, u", "u_dot"),
            ("forward_dynamics", "q, u", "tau"),
            ("mass_matrix_solve", "q", "tau"),
            ("kinetic_energy", "q", "u"),
        ] {
            let apart = count(&format!(
                "d({function})/d({first})+d({function})/d({second})"
            ));
            let together = count(&format!("d({function})/d({first}, {second})"));
            assert!(
                apart <= together,
                "{path} {function}: {apart} of {together}"
            );
        }
    }
}

#[test]
fn each_derivative_of_a_joined_function_is_swept_for_in_its_own_way() {
    let count = |name: &str| model("panda.urdf").operations(name).total();
    for parts in [
        ["vjp(inverse_dynamics; q, u)", "jvp(inverse_dynamics; q, u)"],
        ["jvp(inverse_dynamics; q, u)", "d(kinetic_energy)/d(q, u)"],
    ] {
        let joined = count(&parts.join("+"));
        let apart: usize = parts.iter().map(|part| count(part)).sum();
        assert!(joined < apart, "{parts:?}: {joined} of {apart}");
    }
}

#[test]
fn the_page_of_functions_has_the_counts_of_what_is_read_off_the_coriolis_matrix() {
    let count = |name: &str| model("panda.urdf").operations(name).total();
    let joined = "mass_matrix+coriolis_matrix+gravity_forces";
    let (all, one) = (count(joined), count("coriolis_matrix"));
    pages::functions().says(&format!(
        "`{joined}` takes {all} operations, of which the Coriolis matrix alone takes {one}."
    ));
}

#[test]
fn a_cart_pole_s_mass_matrix_and_bias_in_one() {
    let path = format!("{}/tests/models/cart_pole.toml", env!("CARGO_MANIFEST_DIR"));
    let source = Source::new("cart_pole.toml", fs::read_to_string(path).unwrap());
    let options = Options {
        functions: Functions::Named(vec!["mass_matrix+bias".to_owned()]),
        ..Options::default()
    };
    let module = generate(&source, "models/cart_pole.toml", &options, &no_includes).unwrap();
    let names: Vec<&str> = module.functions.iter().map(|(name, _)| &**name).collect();
    assert_eq!(names, ["q_dot", "mass_matrix_and_bias"]);
    assert!(module.source.contains("functions: mass_matrix+bias;"));
    let start = module.source.find("/// `mass_matrix`").unwrap();
    insta::assert_snapshot!(module.source[start..]);
}

#[test]
fn outputs_that_share_a_name_with_one_another_or_an_argument_go_by_their_functions() {
    let names = |text: &str| -> Vec<String> {
        let outputs = Request::parse(text).unwrap().outputs();
        outputs
            .into_iter()
            .map(|output| output.name.into_owned())
            .collect()
    };
    assert_eq!(names("mass_matrix+bias"), ["m", "bias"]);
    assert_eq!(
        names("kinetic_energy+potential_energy"),
        ["kinetic_energy", "potential_energy"]
    );
    assert_eq!(
        names("inverse_dynamics+forward_dynamics"),
        ["inverse_dynamics", "forward_dynamics"]
    );
    assert_eq!(
        names("q_dot+bias+gravity_forces+generalized_forces"),
        ["q_dot", "bias", "gravity_forces", "generalized_forces"]
    );
}

#[test]
fn arguments_are_those_of_all_parts_in_the_order_of_every_function() {
    let request = Request::parse("forward_dynamics+inverse_dynamics+forcing").unwrap();
    let names: Vec<&str> = request.arguments().iter().map(|a| a.name()).collect();
    assert_eq!(names, ["q", "u", "u_dot", "tau", "loads"]);
}

#[test]
fn what_cannot_be_joined_is_refused() {
    let error = |text: &str| Request::parse(text).unwrap_err();
    assert!(matches!(error("mass+bias"), RequestError::Unknown { name } if name == "mass"));
    let expected = "expected the name of a function";
    assert!(
        matches!(error("bias+"), RequestError::Syntax { expected: own, .. } if own == expected)
    );
    assert!(matches!(error("bias+bias"), RequestError::Repeated { name, .. } if name == "bias"));
    let compact = error("bias+partial_velocity");
    assert!(matches!(compact, RequestError::Compact { name, .. } if name == "partial_velocity"));
    let options = Options {
        functions: Functions::Named(vec!["bias+bias".to_owned()]),
        ..Options::default()
    };
    let tree = read("models/cart_pole.toml", &Reading::default());
    let error = compile::compile(&tree, &options).unwrap_err();
    assert_eq!(error.to_string(), "`bias+bias` names `bias` twice");
}

#[test]
fn the_order_in_which_functions_are_listed_does_not_matter() {
    let names = |list: &[&str]| -> Vec<String> {
        let functions = Functions::Named(list.iter().map(ToString::to_string).collect());
        functions.requests().iter().map(Parsed::text).collect()
    };
    let expected = [
        "mass_matrix",
        "bias",
        "mass_matrix+bias",
        "bias+mass_matrix",
    ];
    let reversed: Vec<&str> = expected.into_iter().rev().collect();
    assert_eq!(names(&reversed), expected);
    assert_eq!(names(&expected), expected);
    assert!(config::Functions::default().requests().is_empty());
}
