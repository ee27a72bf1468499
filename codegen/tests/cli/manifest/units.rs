//! Units and meanings in a manifest: the numbers of functions change with the units of length, mass and time as it says.

use kane_codegen::functions::{CATALOGUE, OF_FRAMES};
use kane_test_support::json::flat;
use serde_json::{Map, Value, json};

use super::super::project::Project;

/// The units of length, mass and time, in another system of units: no two products of small powers are the same.
const LENGTH: f64 = 2.0;
const MASS: f64 = 3.0;
const TIME: f64 = 5.0;

/// A floating base with an arm that turns every way and slides: every number is set at run time.
const ROBOT: &str = r#"
name = "robot"
gravity = [{ runtime = 0.5 }, { runtime = -0.25 }, { runtime = -9.81 }]
lower_bodies = [0, 1]

[[body]]
name = "base"
mass = { runtime = 12.0 }
mass_center = [{ runtime = 0.01 }, { runtime = 0.02 }, { runtime = 0.1 }]
inertia = { xx = { runtime = 0.3 }, yy = { runtime = 0.2 }, zz = { runtime = 0.25 }, xy = { runtime = 0.01 }, xz = { runtime = 0.02 }, yz = { runtime = 0.03 } }
attachment = [{ runtime = 0.3 }, { runtime = 0.1 }, { runtime = 0.2 }]
joint = "free"
chart = "quaternion"

[[body]]
name = "arm"
mass = { runtime = 1.5 }
mass_center = [{ runtime = 0.1 }, { runtime = 0.02 }, { runtime = -0.4 }]
inertia = { xx = { runtime = 0.1 }, yy = { runtime = 0.1 }, zz = { runtime = 0.02 }, xy = { runtime = 0.01 }, xz = { runtime = 0.01 }, yz = { runtime = 0.01 } }
attachment = [{ runtime = 0.2 }, { runtime = 0.1 }, { runtime = -1.0 }]
joint = ["theta1", "theta2", "theta3", "s1"]
stiffness = { theta2 = { runtime = 3.0 }, s1 = { runtime = 4.0 } }
rest = { theta2 = { runtime = 0.1 }, s1 = { runtime = 0.2 } }
damping = { theta2 = { runtime = 0.3 }, s1 = { runtime = 0.4 } }
armature = { theta2 = { runtime = 0.05 }, s1 = { runtime = 0.06 } }

[[frame]]
name = "tool"
body = "arm"
position = [{ runtime = 0.1 }, { runtime = 0.2 }, { runtime = 0.3 }]
rotation = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]
"#;

/// Derivatives, of which some outputs have many units.
const DERIVATIVES: [&str; 6] = [
    "d(bias)/d(q, u)",
    "packed(d(forward_dynamics)/d(q, tau))",
    "d(velocity(tool))/d(q)",
    "d(bias)/d(arm_mass)",
    "jvp(bias; q, u)",
    "d(loaded_inverse_dynamics)/d(loads)",
];

/// How large a unit is in the other system: units stand beside one another, above or below a fraction bar.
fn scale(unit: &str) -> f64 {
    if let Some(inner) = unit
        .strip_prefix('(')
        .and_then(|rest| rest.strip_suffix(')'))
        && !inner.contains('(')
    {
        return scale(inner);
    }
    let mut depth = 0;
    let bar = unit.rfind(|character| {
        depth += match character {
            ')' => 1,
            '(' => -1,
            _ => 0,
        };
        depth == 0 && character == '/'
    });
    if let Some(bar) = bar {
        return scale(&unit[..bar]) / scale(&unit[bar + 1..]);
    }
    unit.split(' ').map(factor).product()
}

fn factor(unit: &str) -> f64 {
    let (unit, power) = unit.split_once('^').unwrap_or((unit, "1"));
    let newton = MASS * LENGTH / (TIME * TIME);
    let size = match unit {
        "1" | "rad" => 1.0,
        "m" => LENGTH,
        "kg" => MASS,
        "s" => TIME,
        "N" => newton,
        "J" => newton * LENGTH,
        _ => unreachable!("unit `{unit}`"),
    };
    size.powi(power.parse().unwrap())
}

fn texts(value: &Value) -> Vec<&str> {
    match value {
        Value::Array(all) => all.iter().map(|one| one.as_str().unwrap()).collect(),
        one => one.as_str().into_iter().collect(),
    }
}

/// A state, and the same in the other units.
fn states(manifest: &Value, arguments: &Value) -> [Value; 2] {
    let mut states = [Map::new(), Map::new()];
    for argument in arguments.as_array().unwrap().iter().skip(1) {
        let name = argument["name"].as_str().unwrap();
        let units = texts(&argument["unit"]);
        let shape = argument["shape"].as_array().unwrap().iter();
        let n: u64 = shape.map(|length| length.as_u64().unwrap()).product();
        let kinds = match name {
            "q" => texts(&manifest["coordinate_units"]),
            _ => texts(&manifest["speed_units"]),
        };
        let of_unit = |place: usize| match (name, units.len()) {
            (_, 1) => units[0],
            ("loads", _) => units[place / 3 % 2],
            ("q", _) => units
                .iter()
                .copied()
                .find(|unit| *unit == kinds[place])
                .unwrap(),
            _ => units[usize::from(kinds[place] == "m/s")],
        };
        let number = |place: usize| 0.25 + 0.125 * ((place * 7 + name.len()) % 5) as f64;
        let values: Vec<f64> = (0..usize::try_from(n).unwrap()).map(number).collect();
        let scaled = values
            .iter()
            .enumerate()
            .map(|(i, value)| value * scale(of_unit(i)));
        for (state, values) in states.iter_mut().zip([values.clone(), scaled.collect()]) {
            state.insert(name.to_owned(), given(name, &values));
        }
    }
    let parameters = manifest["parameters"].as_array().unwrap().iter();
    let scaled = parameters.map(|one| {
        let value = one["nominal"].as_f64().unwrap() * scale(one["unit"].as_str().unwrap());
        (one["name"].as_str().unwrap().to_owned(), json!(value))
    });
    states[1].insert("parameters".to_owned(), Value::Object(scaled.collect()));
    states.map(Value::Object)
}

/// Numbers as a state has them.
fn given(name: &str, values: &[f64]) -> Value {
    match name {
        "loads" | "loads_direction" => values
            .chunks(6)
            .map(|load| json!({ "force": load[..3], "moment": load[3..] }))
            .collect(),
        "w_rel" => values.chunks(3).map(|vector| json!(vector)).collect(),
        _ => json!(values),
    }
}

fn project(functions: &[String]) -> (Project, Value) {
    let lines =
        format!("prescribed = [\"arm\"]\nformulation = \"notes\"\nfunctions = {functions:?}\n");
    super::generated(["robot.toml", ROBOT], "robot", &lines)
}

/// Every function of the catalogue, and derivatives.
fn all() -> Vec<String> {
    let system = CATALOGUE.iter().map(|function| function.name.to_owned());
    let frames = OF_FRAMES.iter();
    let frames = frames.map(|function| format!("{}(tool)", function.name));
    let derivatives = DERIVATIVES.iter().map(|one| (*one).to_owned());
    system.chain(frames).chain(derivatives).collect()
}

#[test]
fn numbers_change_with_the_units_that_are_said() {
    let (project, manifest) = project(&all());
    for function in manifest["functions"].as_array().unwrap() {
        let request = function["request"].as_str().unwrap();
        let [own, scaled] = states(&manifest, &function["arguments"]).map(|state| {
            let arguments = ["eval", "robot.toml", "--function", request, "--state", "-"];
            let ran = project.kane_given(&arguments, &state.to_string());
            assert_eq!(ran.code, 0, "{request}: {}", ran.err);
            serde_json::from_str::<Value>(&ran.out).unwrap()
        });
        let outputs = function["outputs"].as_array().unwrap();
        for output in outputs {
            let name = output["name"].as_str().unwrap();
            let of = |result: &Value| {
                let found = if result.get(name).is_some() {
                    &result[name]
                } else {
                    result
                };
                let entries = ["entries", "columns"].map(|key| found.get(key));
                let found = entries.into_iter().flatten().next().unwrap_or(found);
                flat(found)
            };
            if request.starts_with("base_") {
                continue; // Factors of base parameters are numbers of the nominal lengths.
            }
            let units = texts(&output["unit"]);
            let (own, scaled) = (of(&own), of(&scaled));
            let shape = flat(&output["shape"]);
            assert_eq!(own.len() as f64, shape.iter().product::<f64>(), "{request}");
            assert!(
                own.iter().any(|entry| entry.abs() > 1e-9),
                "{request}: `{name}`"
            );
            for (own, scaled) in own.into_iter().zip(scaled) {
                let is_of = |unit: &&str| (scaled - own * scale(unit)).abs() <= 1e-9 * scaled.abs();
                let is_zero = own.abs() < 1e-14 && scaled.abs() < 1e-12;
                assert!(
                    is_zero || units.iter().any(is_of),
                    "{request}: `{name}` has {units:?}, but {own} becomes {scaled}"
                );
            }
        }
    }
}

#[test]
fn every_argument_has_a_unit_and_a_meaning() {
    let more = [
        "vjp(bias; q)",
        "hessian(bias; q)",
        "packed(d(bias)/d(q, u))",
        "bias(sin_cos)",
    ];
    let functions: Vec<String> = all().into_iter().chain(more.map(str::to_owned)).collect();
    let (_, manifest) = project(&functions);
    for function in manifest["functions"].as_array().unwrap() {
        let lists = ["arguments", "outputs"].map(|key| function[key].as_array().unwrap());
        for argument in lists.into_iter().flatten() {
            let meaning = argument["meaning"].as_str().unwrap();
            assert!(
                !meaning.is_empty() && !meaning.contains(['{', '}', '\n']),
                "{argument}"
            );
            let unit = argument.get("unit");
            assert_eq!(
                unit.is_some(),
                argument.get("shape").is_some(),
                "{argument}"
            );
            // Whoever calls gives multipliers their units.
            let is_weighted = ["multiplier", "q_gradient", "hessian"]
                .contains(&argument["name"].as_str().unwrap());
            assert_eq!(unit == Some(&Value::Null), is_weighted, "{argument}");
        }
    }
}
