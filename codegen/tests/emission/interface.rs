//! What stands beside a module for C: its text, whole, for a small system.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::{fs, path::Path};

use kane_codegen::{
    companions::{Abi, CompanionKind, can_be_beside},
    config::Functions,
    description::no_includes,
    diagnostic::Source,
    error::Error,
    generate::{Generated, generate},
    options::Options,
};
use kane_test_support::models::{body, system};

/// The pendulum's mass matrix under this name.
fn generated(name: &str) -> Result<Generated, Error> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models/pendulum.toml");
    generated_of(fs::read_to_string(path).unwrap(), name, "mass_matrix")
}

fn generated_of(model: String, name: &str, function: &str) -> Result<Generated, Error> {
    let source = Source::new("pendulum.toml", model);
    let options = Options {
        functions: Functions::Named(vec![function.to_owned()]),
        companions: [CompanionKind::Abi(Abi::C)].into(),
        module: name.to_owned(),
        ..Options::default()
    };
    generate(&source, "models/pendulum.toml", &options, &no_includes)
}

fn text(ending: &str) -> String {
    text_of(generated("pendulum").unwrap(), ending)
}

fn text_of(generated: Generated, ending: &str) -> String {
    let companions = generated.companions.into_iter();
    let mut texts = companions.filter(|companion| companion.ending == ending);
    texts.next().unwrap().text
}

#[test]
fn a_header() {
    insta::assert_snapshot!(text(".h"));
}

#[test]
fn functions_of_a_header() {
    insta::assert_snapshot!(text("_c.rs"));
}

#[test]
fn names_begin_with_the_module_s_so_that_two_of_one_model_can_be_linked() {
    let [left, right] = ["left", "right"].map(|name| generated(name).unwrap().companions);
    let renamed = |text: &str| text.replace("left", "right").replace("LEFT", "RIGHT");
    for (left, right) in left.iter().zip(&right) {
        assert_eq!(renamed(&left.text), right.text);
        let declared = |word: &str| left.text.matches(word).count();
        assert_eq!(declared("mass_matrix_f"), declared("left_mass_matrix_f"));
    }
}

#[test]
fn array_without_entries_is_a_pointer() {
    let model = system("[0]", &[("one", "[\"theta1\"]")]);
    let generated = generated_of(model, "pendulum", "d(bias)/d(parameters)").unwrap();
    let header = text_of(generated, ".h");
    assert!(
        header.contains("    double *dbias_dparameters);"),
        "{header}"
    );
}

#[test]
fn name_that_cannot_begin_names_of_c_is_refused() {
    let kinds = [CompanionKind::Abi(Abi::C)].into();
    for name in [
        "", "2dof", "_arm", "my-arm", "träger", "fn", "gen", "Self", "arm v2",
    ] {
        assert!(!can_be_beside(&kinds, name), "{name}");
        assert!(matches!(generated(name), Err(Error::ModuleName { .. })));
    }
    for name in ["arm", "Arm_2", "int", "double"] {
        assert!(can_be_beside(&kinds, name), "{name}");
        assert!(generated(name).is_ok());
    }
}

#[test]
fn multipliers_of_base_parameters_have_the_length_of_these() {
    for request in ["vjp(base_regressor; q)", "hessian(base_regressor; q)"] {
        let model = system("[0]", &[("fore", "[\"theta1\"]")]);
        let module = generated_of(model, "arm", request).unwrap();
        let length = "pub const BASE_PARAMETERS_LEN: usize = ";
        assert!(module.source.contains(length), "{request}");
    }
}

#[test]
fn a_header_has_the_axis_of_each_coordinate_that_has_one() {
    let axes = [0.0, -1.0, 0.0];
    let planar = format!("joint = \"planar\"\naxis = {axes:?}");
    let held = "joint = [\"theta3\", \"s1\"]\nlocked = { theta1 = 0.5 }".to_owned();
    let bodies = [planar, "joint = \"spherical\"".to_owned(), held];
    let bodies = bodies.iter().zip(["base", "ball", "held"]);
    let bodies = bodies.map(|(joint, name)| body(name, "[]").replace("joint = []", joint));
    let text = format!(
        "name = \"s\"\nlower_bodies = [0, 1, 2]\n{}",
        bodies.collect::<String>()
    );
    let header = text_of(generated_of(text, "s", "mass_matrix").unwrap(), ".h");
    for line in [
        "S_Q_BASE_THETA2 = 0, // rad, about (0, -1, 0)\n",
        "S_Q_BASE_S1 = 1, // m, along (-1, 0, 0)\n",
        "S_Q_BASE_S3 = 2, // m, along (0, 0, 1)\n",
        "S_Q_BALL_THETA1 = 3, // rad\n",
        // The angle that is held turns its axis.
        "S_Q_HELD_THETA3 = 6, // rad\n",
        "S_Q_HELD_S1 = 7 // m, along (1, 0, 0)\n",
    ] {
        assert!(header.contains(line), "{header}");
    }
}
