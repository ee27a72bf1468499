//! What a manifest says to programs that call the module through C.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::project::Project;

mod geometry;
mod units;

/// A floating base with an arm that slides within limits and has a tool fixed to it; two values are set at run time.
const ROBOT: &str = r#"
name = "robot"
gravity = [0.0, 0.0, { runtime = -9.81 }]
lower_bodies = [0, 1, 2]

[[body]]
name = "base"
mass = { runtime = 12.0 }
mass_center = [0.0, 0.02, 0.1]
inertia = { xx = 0.3, yy = 0.2, zz = 0.25, xy = 0.01, xz = 0.0, yz = 0.02 }
attachment = [0.0, 0.0, 0.0]
joint = "free"
chart = "quaternion"

[[body]]
name = "arm"
mass = 1.5
mass_center = [0.1, 0.02, -0.4]
inertia = { xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.0, xz = 0.01, yz = 0.0 }
attachment = [0.2, 0.0, -1.0]
joint = ["theta2", "s1"]
friction = { theta2 = 0.25 }
limits = { theta2 = { lower = -1.5, upper = 2.0, velocity = 3.0, effort = 40.0 }, s1 = { upper = 0.125 } }

[[body]]
name = "tool"
mass = 0.5
mass_center = [0.0, 0.0, 0.1]
inertia = { xx = 0.01, yy = 0.01, zz = 0.01, xy = 0.0, xz = 0.0, yz = 0.0 }
attachment = [0.0, 0.0, -0.75]
joint = "fixed"
"#;

/// A model in a file of this name, generated to this module with these lines in `kane.toml`; and its manifest.
fn generated([name, model]: [&str; 2], module: &str, lines: &str) -> (Project, Value) {
    let project = Project::empty();
    project.write(name, model);
    let config = format!(
        "[[system]]\nmodel = \"{name}\"\noutput = \"{module}.rs\"\nmanifest = true\n{lines}"
    );
    project.write("kane.toml", &config);
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let manifest = serde_json::from_str(&project.read(&format!("{module}.json"))).unwrap();
    (project, manifest)
}

/// The robot with these functions, and with more lines in its `kane.toml`, generated.
fn robot(functions: &str, more: &str) -> Project {
    let lines = format!("functions = {functions}\n{more}");
    generated(["robot.toml", ROBOT], "legged", &lines).0
}

fn manifest(project: &Project) -> Value {
    serde_json::from_str(&project.read("legged.json")).unwrap()
}

#[test]
fn coordinates_and_speeds_have_units_and_parameters_nominal_values() {
    let manifest = manifest(&robot(r#"["bias"]"#, ""));
    assert_eq!(
        manifest["coordinate_units"],
        json!(["1", "1", "1", "1", "m", "m", "m", "rad", "m"])
    );
    let (angular, linear) = ("rad/s", "m/s");
    assert_eq!(
        manifest["speed_units"],
        json!([
            angular, angular, angular, linear, linear, linear, angular, linear
        ])
    );
    assert_eq!(
        manifest["force_units"],
        json!(["N m", "N m", "N m", "N", "N", "N", "N m", "N"])
    );
    assert_eq!(
        manifest["parameters"],
        json!([
            { "name": "gravity_z", "nominal": -9.81, "unit": "m/s^2" },
            { "name": "base_mass", "nominal": 12.0, "unit": "kg" },
        ])
    );
}

#[test]
fn tree_and_limits_are_those_of_the_module() {
    let manifest = manifest(&robot(r#"["bias"]"#, ""));
    let constants = &manifest["constants"];
    let expected = json!({
        "LOWER_BODIES": [0, 1],
        "SPEED_BODIES": [0, 0, 0, 0, 0, 0, 1, 1],
        "LOWER_LIMITS": [null, null, null, null, null, null, null, -1.5, null],
        "UPPER_LIMITS": [null, null, null, null, null, null, null, 2.0, 0.125],
        "VELOCITY_LIMITS": [null, null, null, null, null, null, 3.0, null],
        "EFFORT_LIMITS": [null, null, null, null, null, null, 40.0, null],
        "FRICTION": [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.25, 0.0],
    });
    for (name, value) in expected.as_object().unwrap() {
        assert_eq!(&constants[name], value, "{name}");
    }
}

#[test]
fn every_constant_of_the_module_is_in_it_or_is_a_size() {
    let functions = r#"["mass_matrix_packed", "mass_matrix_factors", "partial_velocity", "bias(sin_cos)", "base_regressor", "jacobian_packed(tool)", "packed(d(bias)/d(q))", "hybrid_dynamics"]"#;
    let project = robot(functions, "prescribed = [\"arm\"]\n");
    let (manifest, module) = (manifest(&project), project.read("legged.rs"));
    let constants = module.split("\npub const ").skip(1);
    let constants: BTreeSet<&str> = constants
        .filter_map(|rest| rest.split_once(": "))
        .filter(|(_, rest)| !rest.starts_with("usize = "))
        .map(|(name, _)| name)
        .collect();
    let keys = [
        ("NAME", "name"),
        ("BODY_NAMES", "bodies"),
        ("COORDINATE_NAMES", "coordinates"),
        ("SPEED_NAMES", "speeds"),
        ("JOINTS", "joints"),
        ("FRAMES", "frames"),
        ("PARAMETER_NAMES", "parameters"),
        ("PRESCRIBED", "prescribed"),
        ("FINGERPRINT", "fingerprint"),
        ("OPERATIONS", "functions"),
    ];
    assert!(keys.iter().all(|(_, key)| !manifest[key].is_null()));
    let elsewhere = keys.iter().map(|(name, _)| *name);
    let own = manifest["constants"].as_object().unwrap();
    let known: BTreeSet<&str> = own.keys().map(String::as_str).chain(elsewhere).collect();
    assert_eq!(known, constants);
    let block = &own["PARTIAL_VELOCITY_BLOCKS"][0];
    assert_eq!(
        *block,
        json!({ "body": 0, "partition": 0, "speed": 0, "columns": 3, "first": 0 })
    );
}

#[test]
fn packed_outputs_say_how_they_are_read() {
    let functions = r#"["mass_matrix_packed", "jacobian_packed(tool)", "step = bias+packed(d(bias)/d(q, u))", "hessian(bias; q, u)"]"#;
    let manifest = manifest(&robot(functions, ""));
    let constants = &manifest["constants"];
    let output = |function: &str, place: usize| {
        let mut functions = manifest["functions"].as_array().unwrap().iter();
        let function = functions.find(|own| own["name"] == function).unwrap();
        function["outputs"][place].clone()
    };
    let named = |output: &Value, key: &str| constants[output[key].as_str().unwrap()].clone();
    let n = manifest["NU"].as_u64().unwrap();

    let mass = output("mass_matrix_packed", 0);
    let places = named(&mass, "places");
    assert_eq!(places.as_array().unwrap().len() as u64, mass["shape"][0]);
    assert!(mass.get("rows").is_none());

    let jacobian = output("tool_jacobian_packed", 1);
    let speeds = named(&jacobian, "columns_of");
    assert_eq!(
        speeds.as_array().unwrap().len() as u64,
        jacobian["shape"][1]
    );

    let derivative = output("step", 1);
    let columns = json!([
        { "by": "q", "first": 0, "length": n },
        { "by": "u", "first": n, "length": n },
    ]);
    assert_eq!(
        (&derivative["rows"], &derivative["columns"]),
        (&json!(n), &columns)
    );
    let places = named(&derivative, "places");
    assert_eq!(
        places.as_array().unwrap().len() as u64,
        derivative["shape"][0]
    );
    assert_eq!(
        named(&derivative, "colors").as_array().unwrap().len() as u64,
        2 * n
    );
    assert!(output("step", 0).get("places").is_none());

    let second = output("hessian_bias_q_u", 0);
    assert_eq!(second["rows"], json!(2 * n));
    assert!(second.get("colors").is_none());
    let places = named(&second, "places");
    assert_eq!(places.as_array().unwrap().len() as u64, second["shape"][0]);
}

#[test]
fn shapes_of_arguments_are_those_of_their_numbers_in_memory() {
    let functions = r#"["loaded_forward_dynamics", "bias(sin_cos)"]"#;
    let manifest = manifest(&robot(functions, ""));
    let argument = |name: &str, shape: Value| json!({ "name": name, "shape": shape });
    let arguments = |name: &str| {
        let mut functions = manifest["functions"].as_array().unwrap().iter();
        let function = functions.find(|function| function["name"] == name);
        let arguments = function.unwrap()["arguments"].as_array().unwrap().iter();
        let shapes = arguments.map(|own| match own.get("shape") {
            Some(shape) => argument(own["name"].as_str().unwrap(), shape.clone()),
            None => json!({ "name": own["name"] }),
        });
        Value::Array(shapes.collect())
    };
    let [q, u, tau] = [("q", 9), ("u", 8), ("tau", 8)].map(|(name, n)| argument(name, json!([n])));
    let p = json!({ "name": "p" });
    assert_eq!(
        arguments("loaded_forward_dynamics"),
        json!([p, q, u, tau, argument("loads", json!([2, 2, 3]))])
    );
    assert_eq!(
        arguments("bias_at_sin_cos"),
        json!([p, q, argument("sin_cos", json!([2, 1])), u])
    );
}

#[test]
fn names_in_c_are_those_of_the_header() {
    let functions = r#"["mass_matrix", "bias(sin_cos)", "velocity(tool)"]"#;
    let project = robot(functions, "abi = \"c\"\n");
    let (manifest, header) = (manifest(&project), project.read("legged.h"));
    let c = &manifest["c"];
    assert_eq!(c["header"], "legged.h");
    assert_eq!(c["scalars"], json!({ "f64": "double", "f32": "float" }));
    let listed = [&manifest["functions"], &c["runtime"]].into_iter();
    let listed = listed.flat_map(|functions| functions.as_array().unwrap());
    let symbols = ["nominal", "prepare", "sin_cos"].map(|name| &c[name]);
    let symbols = symbols
        .into_iter()
        .chain(listed.map(|function| &function["symbols"]));
    let symbols: BTreeSet<&str> = symbols
        .flat_map(|symbols| ["f64", "f32"].map(|scalar| symbols[scalar].as_str().unwrap()))
        .collect();
    let declared = header.split("\nvoid ").skip(1);
    let declared: BTreeSet<&str> = declared
        .map(|rest| rest.split_once('(').unwrap().0)
        .collect();
    assert_eq!(symbols, declared);
    let input = format!("#define LEGGED_INPUT {}\n", manifest["input"]);
    assert!(header.contains(&input), "{input}");
    let told = format!("const char *{}(void);", c["input"].as_str().unwrap());
    assert!(header.contains(&told), "{told}");
    let prepared = format!("double values[{}];", manifest["prepared"]);
    assert!(header.contains(&prepared), "{prepared}");
    let plain = robot(functions, "");
    let text = plain.read("legged.json");
    assert!(!text.contains("\"c\":") && !text.contains("\"symbols\":"));
}

#[test]
fn parameter_joint_and_frame_are_a_line_each() {
    let text = robot(r#"["bias"]"#, "").read("legged.json");
    for line in [
        r#"    { "name": "base_mass", "nominal": 12.0, "unit": "kg" }"#,
        r#"    { "name": "arm", "kind": null, "chart": "AngleRates", "q": [null, 7, null, null, 8, null, null], "u": [null, 6, null, 7, null, null], "axes": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], "body_axes": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], "position": [0.2, 0.0, -1.0], "body_position": [0.0, 0.0, 0.0] }"#,
        r#"    { "name": "tool", "identifier": "tool", "body": 1, "rotation": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], "position": [0.0, 0.0, -0.75] }"#,
        r#"    "UPPER_LIMITS": [null, null, null, null, null, null, null, 2.0, 0.125],"#,
    ] {
        assert!(text.lines().any(|own| own == line), "{line}\n{text}");
    }
}
