//! The steps that C has of the runtime crate.

use std::{fmt::Write as _, path::Path};

use serde_json::Value;

use super::headers;

/// What a step's name ends with, and how Rust calls it: of `SYSTEM`, by `SCHEME`. A `NAME` is that in C.
const WAYS: [(&str, &str); 7] = [
    (
        "_step",
        "SCHEME::step(&SYSTEM, &tau, dt, &mut state.0, &mut state.1); show(NAME, &state);",
    ),
    (
        "_linearized",
        "let mut derivatives = StepDerivatives::filled([[zero; NU]; NU]);
        SCHEME::linearized(&SYSTEM, &tau, dt, (&mut state.0, &mut state.1), &mut derivatives);
        show(NAME, &state);
        matrices(NAME, &derivatives);",
    ),
    (
        "_forward",
        "SCHEME::forward(&SYSTEM, &tau, dt, (&mut state.0, &mut state.1), (&mut change, &tau_direction));
        show(NAME, &state);
        pair(NAME, [\"q_direction_after\", \"u_direction_after\"], &change);",
    ),
    (
        "_adjoint",
        "let mut gradient: [R; NU] = entries(0);
        SCHEME::adjoint(&SYSTEM, &tau, dt, (&state.0, &state.1), (&mut multiplier, &mut gradient));
        pair(NAME, [\"q_gradient\", \"u_gradient\"], &multiplier);
        print!(\"{}.tau_gradient\", NAME); gradient.print(); println!();",
    ),
    (
        "_by_parameters",
        "let mut by = kane::discrete::StepByParameters::filled([[zero; claw::PARAMETERS_LEN]; NU]);
        SCHEME::by_parameters(&SYSTEM, &tau, dt, (&state.0, &state.1), &mut by);
        print!(\"{}.q_by_parameters\", NAME); by.q.print(); println!();
        print!(\"{}.u_by_parameters\", NAME); by.u.print(); println!();",
    ),
    (
        "_forward_with_parameters",
        "let changes = (&mut change, &tau_direction, &parameters_direction);
        SCHEME::forward_with_parameters(&SYSTEM, &tau, dt, (&mut state.0, &mut state.1), changes);
        show(NAME, &state);
        pair(NAME, [\"q_direction_after\", \"u_direction_after\"], &change);",
    ),
    (
        "_adjoint_with_parameters",
        "let (mut gradient, mut of_parameters): ([R; NU], [R; claw::PARAMETERS_LEN]) = (entries(0), entries(0));
        let gradients = (&mut multiplier, &mut gradient, &mut of_parameters);
        SCHEME::adjoint_with_parameters(&SYSTEM, &tau, dt, (&state.0, &state.1), gradients);
        pair(NAME, [\"q_gradient\", \"u_gradient\"], &multiplier);
        print!(\"{}.tau_gradient\", NAME); gradient.print(); println!();
        print!(\"{}.parameters_gradient\", NAME); of_parameters.print(); println!();",
    ),
];

/// The steps among what C has of the runtime crate.
pub(super) fn called_from_rust(runtime: &[&str]) -> String {
    let mut steps = String::new();
    for name in runtime {
        let Some((way, call)) = WAYS.iter().find(|(way, _)| name.ends_with(way)) else {
            continue;
        };
        let before = name.strip_suffix(way).unwrap();
        let (system, scheme) = match before.split_once('_') {
            Some((system, scheme)) => (system, scheme),
            None => ("p", before),
        };
        let call = call.replace("SYSTEM", system).replace("SCHEME", scheme);
        let call = call.replace("NAME", &format!("{name:?}"));
        let begin = "let mut state = (q, u); let _ = &mut state;
        let mut change = Change { q: q_direction, u: u_direction }; let _ = &mut change;
        let mut multiplier = Change { q: q_multiplier, u: u_multiplier }; let _ = &mut multiplier;";
        writeln!(steps, "    {{ {begin}\n        {call} }}").unwrap();
    }
    steps
}

#[test]
fn c_has_every_step_whose_requests_there_are() {
    let generated = headers::module("claw", headers::CLAW);
    let files = generated.files(Path::new("claw.rs"));
    let manifest = files.iter().find(|(path, _)| path.ends_with("claw.json"));
    let manifest: Value = serde_json::from_str(manifest.unwrap().1).unwrap();
    let runtime = manifest["c"]["runtime"].as_array().unwrap().iter();
    let found: Vec<&str> = runtime.map(|one| one["name"].as_str().unwrap()).collect();
    let mut expected = ["q_plus", "q_minus", "scale_quaternions"]
        .map(str::to_owned)
        .to_vec();
    for condition in ["", "loaded_", "driven_"] {
        for (way, _) in WAYS {
            if condition.is_empty() || !way.contains("parameters") {
                expected.extend(["euler", "rk4"].map(|scheme| format!("{condition}{scheme}{way}")));
            }
        }
    }
    assert_eq!(found, expected);
}
