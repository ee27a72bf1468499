//! `kane eval`.

use kane_test_support::{
    compare::{Tolerance, assert_close},
    json::flat,
};
use serde_json::{Value, json};

use super::project::{Project, Ran, model, repository};

/// Relative to the largest entry; see `derivation/reference.rs`.
const TOLERANCE: Tolerance = Tolerance::relative(1e-12);

const SYSTEMS: [&str; 3] = ["eight_body", "two_roots", "tree12"];

fn reference(name: &str) -> (String, Value) {
    let model = match name {
        "eight_body" => repository("models/eight_body.toml"),
        _ => repository(&format!("tests/reference/{name}.toml")),
    };
    let path = repository(&format!("tests/reference/{name}.json"));
    let values: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    (
        model.to_str().unwrap().to_owned(),
        values["cases"][0].clone(),
    )
}

/// The reference's state in the order of Eq. (1).
fn state(case: &Value) -> Value {
    let both = |angles: &str, translations: &str| {
        [
            flat(&case["state"][angles]),
            flat(&case["state"][translations]),
        ]
        .concat()
    };
    let (forces, moments) = (&case["state"]["F"], &case["state"]["M"]);
    let loads = forces
        .as_array()
        .unwrap()
        .iter()
        .zip(moments.as_array().unwrap());
    let loads: Value = loads
        .map(|(force, moment)| json!({ "force": force, "moment": moment }))
        .collect();
    json!({ "q": both("theta", "s"), "u": both("theta_dot", "s_dot"), "loads": loads })
}

fn evaluated(model: &str, function: &str, formulation: &str, state: &Value) -> Value {
    evaluated_with(model, function, &["--formulation", formulation], state)
}

fn evaluated_with(model: &str, function: &str, options: &[&str], state: &Value) -> Value {
    let arguments = ["eval", model, "--function", function, "--state", "-"];
    let arguments = [&arguments, options].concat();
    let ran = Project::empty().kane_given(&arguments, &state.to_string());
    assert_eq!(ran.code, 0, "{ran:?}");
    serde_json::from_str(&ran.out).unwrap()
}

#[test]
fn mass_matrix_and_forcing_are_those_of_the_reference() {
    for name in SYSTEMS {
        let (model, case) = reference(name);
        for formulation in ["notes", "recursive", "cheapest"] {
            let matrix = evaluated(&model, "mass_matrix", formulation, &state(&case));
            assert_eq!(
                matrix.as_array().unwrap().len(),
                matrix[0].as_array().unwrap().len()
            );
            assert_close(
                "output",
                &flat(&matrix),
                &flat(&case["expect"]["A"]),
                TOLERANCE,
            );
            let forcing = evaluated(&model, "forcing", formulation, &state(&case));
            assert_close(
                "output",
                &flat(&forcing),
                &flat(&case["expect"]["f"]),
                TOLERANCE,
            );
        }
    }
}

#[test]
fn techniques_are_left_out_and_the_values_stay() {
    let model = repository("tests/robots/ur5/ur5.urdf");
    let numbers = [0.3, -0.7, 1.1, 0.4, -0.2, 0.9];
    let state = json!({ "q": numbers, "u": numbers });
    let bias = |without: &[&str]| {
        let options = [&["--base", "fixed"], without].concat();
        flat(&evaluated_with(
            model.to_str().unwrap(),
            "bias",
            &options,
            &state,
        ))
    };
    let (all, some) = (bias(&[]), bias(&["--without", "turn,slide,regroup"]));
    assert_close("output", &some, &all, TOLERANCE);
    // Other operations round otherwise.
    assert_ne!(some, all);
}

#[test]
fn functions_that_are_given_sines_have_the_values_of_those_that_compute_them() {
    let state = r#"{"q": [0.3, -0.7, 1.1], "u": [0.5, 0.2, -0.4]}"#;
    for function in ["bias", "mass_matrix"] {
        let [plain, given] = ["", "(sin_cos)"].map(|suffix| {
            let ran = arm(&format!("{function}{suffix}"), state);
            assert_eq!(ran.code, 0, "{ran:?}");
            flat(&serde_json::from_str(&ran.out).unwrap())
        });
        assert_close("output", &given, &plain, TOLERANCE);
    }
}

#[test]
fn partial_velocity_is_that_of_the_reference() {
    for name in SYSTEMS {
        let (model, case) = reference(name);
        let found = evaluated(&model, "partial_velocity", "cheapest", &state(&case));
        let bodies = case["expect"]["bodies"].as_array().unwrap();
        let mut dense: Vec<Vec<f64>> = bodies
            .iter()
            .map(|body| vec![0.0; flat(&body["v_G_y"]).len()])
            .collect();
        for block in found["blocks"].as_array().unwrap() {
            let at = |key: &str| usize::try_from(block[key].as_u64().unwrap()).unwrap();
            let row = &mut dense[at("body")];
            let width = row.len() / 3;
            for column in 0..at("columns") {
                let entries = flat(&found["columns"][at("first") + column]);
                for (component, entry) in entries.into_iter().enumerate() {
                    row[component * width + at("speed") + column] = entry;
                }
            }
        }
        for (found, body) in dense.iter().zip(bodies) {
            assert_close("output", found, &flat(&body["v_G_y"]), TOLERANCE);
        }
    }
}

#[test]
fn numbers_are_nested_as_the_output_is() {
    let shape = |function: &str| {
        let ran = arm(function, r#"{"q": [0, 0, 0], "u": [0, 0, 0]}"#);
        assert_eq!(ran.code, 0, "{ran:?}");
        let mut value: &Value = &serde_json::from_str(&ran.out).unwrap();
        let mut lengths = Vec::new();
        while let Value::Array(items) = value {
            lengths.push(items.len());
            value = &items[0];
        }
        lengths
    };
    assert_eq!(shape("kinetic_energy"), Vec::<usize>::new());
    assert_eq!(shape("linear_momentum"), [3]);
    assert_eq!(shape("bias"), [3]);
    assert_eq!(shape("singularity"), [2]);
    assert_eq!(shape("mass_matrix"), [3, 3]);
    assert_eq!(shape("angular_velocity"), [2, 3]);
    assert_eq!(shape("rotation"), [2, 3, 3]);
}

pub(crate) fn arm(function: &str, state: &str) -> Ran {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "{ runtime = 2.0 }"));
    project.write("state.json", state);
    project.kane(&[
        "eval",
        "arm.toml",
        "--function",
        function,
        "--state",
        "state.json",
    ])
}

#[test]
fn matrix_is_printed_by_rows() {
    let ran = arm("rotation", r#"{"q": [0, 0, 0]}"#);
    insta::assert_snapshot!(ran.out, @"
    [
      [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0]
      ],
      [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0]
      ]
    ]
    ");
}

#[test]
fn functions_in_one_are_printed_as_an_object_of_outputs() {
    let state = r#"{"q": [0, 0, 0], "u": [1, 0, 0]}"#;
    let alone = |function: &str| serde_json::from_str::<Value>(&arm(function, state).out).unwrap();
    let joined = alone("kinetic_energy+mass_matrix");
    assert_eq!(joined.as_object().unwrap().len(), 2);
    assert_eq!(joined["energy"], alone("kinetic_energy"));
    assert_eq!(joined["m"], alone("mass_matrix"));
}

#[test]
fn functions_in_one_need_what_any_of_them_needs() {
    let ran = arm("mass_matrix+bias", r#"{"q": [0, 0, 0]}"#);
    assert_eq!(ran.code, 2);
    let fault = "`mass_matrix+bias` needs `u`, which is missing; expected a list of 3 numbers";
    assert!(ran.err.contains(fault), "{}", ran.err);
}

#[test]
fn parameters_are_nominal_unless_the_state_says_otherwise() {
    // Only the slider moves: its kinetic energy is that of both masses, 2.0 and 1.5 kg, at 2 m/s.
    let energy = |parameters: &str| {
        let ran = arm(
            "kinetic_energy",
            &format!(r#"{{"q": [0, 0, 0], "u": [0, 2, 0]{parameters}}}"#),
        );
        ran.out.trim().parse::<f64>().unwrap()
    };
    assert!((energy("") - 7.0).abs() < 1e-12);
    assert!((energy(r#", "parameters": {"upper_mass": 3.0}"#) - 9.0).abs() < 1e-12);
}

#[test]
fn directions_of_parameters_are_given_by_names_or_in_order() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "{ runtime = 2.0 }"));
    let along = |direction: &str| {
        let state = format!(r#"{{"q": [0.3, 0, 0], "parameters_direction": {direction}}}"#);
        let request = "jvp(potential_energy; parameters)";
        let arguments = ["eval", "arm.toml", "--function", request, "--state", "-"];
        project.kane_given(&arguments, &state)
    };
    let named = along(r#"{"upper_mass": 3.0}"#);
    assert_eq!(named.code, 0, "{named:?}");
    assert_eq!(named.out, along("[3.0]").out);
    let unknown = along(r#"{"lower_mass": 3.0}"#);
    assert!(
        unknown
            .err
            .contains("names none of the values set at run time"),
        "{unknown:?}"
    );
}

#[test]
fn rates_of_angles_are_taken_from_relative_angular_velocities() {
    let project = Project::empty();
    project.write(
        "arm.toml",
        &model("arm", "2.0").replace(r#"["theta1", "s2"]"#, "\"free\""),
    );
    let state = r#"{"q": [0, 0, 0, 0, 0, 0, 0], "w_rel": [[1, 2, 3], [0, 0, 0]]}"#;
    let ran = project.kane_given(
        &[
            "eval",
            "arm.toml",
            "--function",
            "angle_rates",
            "--state",
            "-",
        ],
        state,
    );
    assert_eq!(ran.code, 0, "{ran:?}");
    let rates: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(flat(&rates[0]), [1.0, 2.0, 3.0]);
}

#[test]
fn number_that_is_not_finite_is_null_and_told() {
    // The square of the speed is more than f64 holds.
    let ran = arm("kinetic_energy", r#"{"q": [0, 0, 0], "u": [0, 1e308, 0]}"#);
    assert_eq!((ran.code, ran.out.as_str()), (0, "null\n"));
    assert_eq!(
        ran.err,
        "warning: 1 of 1 numbers are not finite; they are shown as null\n"
    );
}

#[test]
fn unknown_function_is_answered_with_what_was_meant() {
    let ran = arm("mass_matrx", "{}");
    assert_eq!(ran.code, 2);
    assert_eq!(
        ran.err,
        "error: `mass_matrx` is no function; did you mean `mass_matrix`?\n"
    );
}

#[test]
fn faults_of_function_model_and_state_are_reported_together() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "-2.0"));
    let ran = project.kane(&[
        "eval",
        "arm.toml",
        "--function",
        "biass",
        "--state",
        "gone.json",
    ]);
    assert_eq!(ran.code, 2);
    for part in [
        "`biass` is no function",
        "arm.toml:7:8",
        "cannot access `gone.json`",
    ] {
        assert!(ran.err.contains(part), "no {part} in\n{}", ran.err);
    }
}

#[test]
fn keys_that_are_no_multipliers_are_unknown() {
    let model = repository("models/cart_pole.toml");
    let state = json!({ "q": [0.1, 0.3], "u": [0.5, -0.4], "u_dot": [0.1, 0.2], "tua_multiplier": [0.0, 1.0] });
    let arguments = [
        "eval",
        model.to_str().unwrap(),
        "--function",
        "inverse_dynamics",
        "--state",
        "-",
    ];
    let ran = Project::empty().kane_given(&arguments, &state.to_string());
    assert_eq!(ran.code, 2, "{ran:?}");
    assert!(ran.err.contains("`tua_multiplier`"), "{ran:?}");
}

#[test]
fn products_are_given_directions_and_multipliers() {
    let model = repository("models/cart_pole.toml");
    let model = model.to_str().unwrap();
    // Of a multiplier that a function does not take nothing is said.
    let state = json!({
        "q": [0.1, 0.3], "u": [0.5, -0.4], "u_dot": [0.1, 0.2], "q_direction": [0.0, 1.0], "multiplier": [0.0, 1.0],
    });
    let numbers = |function: &str| flat(&evaluated(model, function, "recursive", &state));
    let all = numbers("d(inverse_dynamics)/d(q)");
    assert_eq!(all.len(), 4);
    let along = numbers("jvp(inverse_dynamics; q)");
    assert_close("jvp", &along, &[all[1], all[3]], TOLERANCE);
    let back = numbers("vjp(inverse_dynamics; q)");
    assert_close("vjp", &back, &[all[2], all[3]], TOLERANCE);
    let missing = json!({ "q": [0.1, 0.3], "u": [0.5, -0.4], "u_dot": [0.1, 0.2] }).to_string();
    let arguments = [
        "eval",
        model,
        "--function",
        "jvp(inverse_dynamics; q)",
        "--state",
        "-",
    ];
    let ran = Project::empty().kane_given(&arguments, &missing);
    assert_eq!(ran.code, 2, "{ran:?}");
    assert!(
        ran.err.contains("`q_direction`, which is missing"),
        "{ran:?}"
    );
}

#[test]
fn what_has_no_entries_need_not_be_given() {
    let model = repository("models/arm.urdf");
    let state = json!({ "q": [0.1, 0.3, 0.2], "u": [0.5, -0.4, 0.1] });
    let product = evaluated(
        model.to_str().unwrap(),
        "jvp(bias; parameters)",
        "recursive",
        &state,
    );
    assert_eq!(flat(&product), [0.0; 3]);
}

#[test]
fn packed_derivatives_come_with_their_places() {
    let model = repository("models/cart_pole.toml");
    let model = model.to_str().unwrap();
    let state = json!({
        "q": [0.1, 0.3], "u": [0.5, -0.4], "u_dot": [0.1, 0.2], "multiplier": [2.0, 1.0],
    });
    let at = |function: &str| evaluated(model, function, "recursive", &state);
    let all = at("d(inverse_dynamics)/d(q, u)");
    let all = ["dtau_dq", "dtau_du"].map(|name| flat(&all[name]));
    let packed = at("packed(d(inverse_dynamics)/d(q, u))");
    // Columns 0 and 1 are those of `q`, 2 and 3 those of `u`. A spring or damper may act along each coordinate.
    let places = [[0, 0], [0, 1], [0, 2], [0, 3], [1, 1], [1, 3]];
    assert_eq!(packed["places"], json!(places));
    let whole = |[row, column]: [usize; 2]| all[column / 2][row * 2 + column % 2];
    let expected = places.map(whole);
    assert_close(
        "packed",
        &flat(&packed["derivatives"]),
        &expected,
        TOLERANCE,
    );
    assert_eq!(packed["colors"], json!([2, 0, 3, 1]));
    let second = at("hessian(inverse_dynamics; q, u)");
    assert_eq!(
        second["places"].as_array().unwrap().len(),
        flat(&second["hessian"]).len()
    );
    // Two lists of places are each called as what they belong to.
    let of_packed = at("packed(d(mass_matrix_packed)/d(q))");
    let of_packed = of_packed.as_object().unwrap();
    assert!(!of_packed.contains_key("places"));
    let n_places = |name: &str| of_packed[name].as_array().unwrap().len();
    let n_derivatives = flat(&of_packed["derivatives"]).len();
    assert_eq!(
        n_places("d_mass_matrix_packed_d_q_packed_places"),
        n_derivatives
    );
    assert_eq!(n_places("mass_matrix_packed_places"), 3);
}

#[test]
fn what_cannot_be_differentiated_is_told_why() {
    let model = repository("models/cart_pole.toml");
    let model = model.to_str().unwrap();
    for (function, why) in [
        (
            "d(mass_matrix)/d(u)",
            "`mass_matrix` is not given `u`; it can be differentiated by `q`, and by values set at run time",
        ),
        (
            "d(bias)/d(pole_maas)",
            "`pole_maas` is no variable of `bias`; did you mean `pole_mass`? It can be differentiated by `q`, `u`, `parameters`, `pole_mass`",
        ),
        (
            "d(bias)/d(cart_s1)",
            "`cart_s1` is no variable of `bias`; it is an entry of `q`; it can be differentiated by `q`, `u`, `parameters`, `pole_mass`",
        ),
        (
            "d(bias)/d(pole_mass, parameters)",
            "`d(bias)/d(pole_mass, parameters)` names `pole_mass` twice",
        ),
        (
            "jvp(bias; pole_mass)",
            "`pole_mass` alone is no direction; expected `parameters`, of which it is one",
        ),
        (
            "hessian(mass_matrix; u)",
            "`mass_matrix` is not given `u`; it can be differentiated by `q`, and by values set at run time",
        ),
        (
            "hessian(vjp(bias; q); q)",
            "`vjp(bias; q)` is a derivative itself (second ones are `hessian(F; X)`), and cannot be differentiated",
        ),
        (
            "packed(bias)",
            "`packed(bias)` is no request: expected `d(PART)/d(VARIABLES)`",
        ),
        (
            "vjp(bias; q)+vjp(mass_matrix; q)",
            "`vjp(mass_matrix; q)` and another part of `vjp(bias; q)+vjp(mass_matrix; q)` are each given a point, force, moment or multiplier of their own; ask for them apart",
        ),
        (
            "d(partial_velocity)/d(q)",
            "`partial_velocity` has a compact output, and cannot be differentiated",
        ),
    ] {
        let arguments = ["eval", model, "--function", function, "--state", "-"];
        let ran = Project::empty().kane_given(&arguments, "{}");
        assert_eq!(ran.code, 2, "{ran:?}");
        assert_eq!(
            ran.err.lines().next(),
            Some(&*format!("error: {why}")),
            "{ran:?}"
        );
    }
}

#[test]
fn values_of_base_parameters_stay_beside_others_of_one_name() {
    let model = repository("models/cart_pole.toml");
    let evaluated = |function: &str| -> Value {
        let arguments = ["eval", model.to_str().unwrap(), "--function", function];
        serde_json::from_str(&Project::empty().kane(&arguments).out).unwrap()
    };
    let alone = evaluated("base_parameters");
    let joined = evaluated("base_parameters+inertial_parameters");
    assert_eq!(joined["base_parameters"], alone["pi"]);
    assert_eq!(joined["base_parameter_names"], alone["base_parameters"]);
}
