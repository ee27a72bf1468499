//! What other tools call our functions, for those who look for a name that we do not have.

use super::{
    argument::Argument,
    function::{Function, Of},
    syntax::AT_SIN_COS,
    variable::PARAMETERS,
};
use crate::diagnostic::nearest;

/// Our requests, and the names that Pinocchio, MuJoCo, RBDL, Drake and textbooks have for the same, in small letters and digits.
const NAMES: [(&str, &[&str]); 17] = [
    (
        "inverse_dynamics",
        &[
            "rnea",
            "id",
            "newtoneuler",
            "mjinverse",
            "calcinversedynamics",
        ],
    ),
    (
        "mass_matrix",
        &[
            "crba",
            "compositerigidbodyalgorithm",
            "inertiamatrix",
            "jointspaceinertia",
            "mjfullm",
            "calcmassmatrix",
        ],
    ),
    (
        "forward_dynamics",
        &[
            "aba",
            "fd",
            "articulatedbodyalgorithm",
            "mjforward",
            "calcforwarddynamics",
        ],
    ),
    (
        "bias",
        &["nle", "nonlineareffects", "qfrcbias", "calcbiasterm"],
    ),
    (
        "gravity_forces",
        &[
            "gravity",
            "gravityterm",
            "generalizedgravity",
            "gravitycompensation",
            "gravityvector",
            "calcgravitygeneralizedforces",
        ],
    ),
    ("coriolis_matrix", &["coriolis", "christoffel"]),
    (
        "mass_matrix_inverse",
        &["minv", "minverse", "inversemassmatrix"],
    ),
    (
        "pose(FRAME)",
        &[
            "fk",
            "forwardkinematics",
            "framesforwardkinematics",
            "placement",
            "transform",
        ],
    ),
    ("velocity(FRAME)", &["framevelocity", "twist"]),
    (
        "jacobian(FRAME)",
        &[
            "jac",
            "framejacobian",
            "jointjacobian",
            "geometricjacobian",
            "mjjac",
            "calcpointjacobian",
        ],
    ),
    (
        "jacobian_dot_u(FRAME)",
        &[
            "jdotv",
            "jdotqdot",
            "jacobiandot",
            "framejacobiantimevariation",
        ],
    ),
    (
        "center_of_mass",
        &["com", "centerofmassposition", "calccenterofmass"],
    ),
    (
        "center_of_mass_jacobian",
        &["jcom", "jacobiancenterofmass", "comjacobian"],
    ),
    ("centroidal_momentum_matrix", &["cmm", "ccrba"]),
    ("regressor", &["jointtorqueregressor", "torqueregressor"]),
    (
        "d(inverse_dynamics)/d(q, u, u_dot)",
        &["rneaderivatives", "inversedynamicsderivatives"],
    ),
    (
        "d(forward_dynamics)/d(q, u, tau)",
        &["abaderivatives", "forwarddynamicsderivatives"],
    ),
];

/// Words with which other tools' names begin.
const BEFORE: [&str; 3] = ["compute", "get", "pinocchio"];

/// Our request for what other tools call so; letters' case and what is no letter or digit do not count.
pub fn elsewhere(name: &str) -> Option<&'static str> {
    let word = plain(name);
    let mut words = vec![&*word];
    words.extend(BEFORE.iter().filter_map(|before| word.strip_prefix(before)));
    let own = Function::names().into_iter();
    let mut own = own.filter(|own| words.contains(&&*plain(own)));
    let mut others = NAMES.iter();
    let others = others.find(|(_, names)| names.iter().any(|name| words.contains(name)));
    own.next().or(others.map(|(request, _)| *request))
}

fn plain(name: &str) -> String {
    let letters = name.chars().filter(char::is_ascii_alphanumeric);
    letters.map(|letter| letter.to_ascii_lowercase()).collect()
}

/// What to do about a name that is no function.
pub fn advice(name: &str) -> String {
    let known = Function::names();
    if let Some(request) = elsewhere(name) {
        format!("here it is called `{request}`")
    } else if let Some(request) = of_generated(name) {
        format!("did you mean `{request}`?")
    } else if ["all", "default"].contains(&name) {
        "it stands alone".to_owned()
    } else if let Some(near) = nearest(name, &known) {
        format!("did you mean `{near}`?")
    } else {
        format!("the functions are {}", known.join(", "))
    }
}

/// The frame and its function, of a name in which both stand as in generated code: `tool0_jacobian`.
fn of_frame(name: &str) -> Option<(&str, &'static str)> {
    let of_frames = Function::all().filter(|function| function.of != Of::System);
    let found = of_frames.filter_map(|function| {
        let frame = name.strip_suffix(function.name)?.strip_suffix('_')?;
        (!frame.is_empty()).then_some((frame, function.name))
    });
    found.max_by_key(|(_, function)| function.len())
}

/// What other tools call our variables.
const VARIABLES: [(&str, &[&str]); 5] = [
    ("q", &["qpos", "x"]),
    ("u", &["v", "qd", "dq", "qdot", "qvel"]),
    ("u_dot", &["a", "qdd", "ddq", "qddot", "qacc", "vdot"]),
    ("tau", &["torque", "torques", "forces", "ctrl"]),
    ("loads", &["load", "fext", "wrench", "wrenches"]),
];

/// Our variable for what other tools call so; letters' case and what is no letter or digit do not count.
pub fn variable_elsewhere(name: &str) -> Option<&'static str> {
    let word = plain(name);
    let mut variables = VARIABLES.iter();
    let found = variables.find(|(_, names)| names.contains(&&*word));
    found.map(|(own, _)| *own)
}

/// What to do about a name that is no variable.
pub(super) fn advice_on_variable(name: &str) -> String {
    match variable_elsewhere(name) {
        Some(own) => format!("here it is called `{own}`"),
        None => "a number of the model has to be `{ runtime = .. }`".to_owned(),
    }
}

/// The request of which a name is that of the generated function, or nearly so: `d_forward_dynamics`, `mass_matrix_and_bias`.
fn of_generated(name: &str) -> Option<String> {
    if let Some(name) = name.strip_suffix("_at_sin_cos") {
        return of_generated(name).map(|request| request + AT_SIN_COS);
    }
    let parts: Option<Vec<String>> = name.split("_and_").map(of_part).collect();
    parts.map(|parts| parts.join("+"))
}

fn of_part(name: &str) -> Option<String> {
    if Function::find(name).is_some() {
        return Some(name.to_owned());
    }
    if let Some((frame, function)) = of_frame(name) {
        return Some(format!("{function}({frame})"));
    }
    for suffix in ["_derivatives", "_derivative"] {
        if let Some((function, "")) = name.strip_suffix(suffix).and_then(split_function) {
            return derivative("d", function, "");
        }
    }
    let (kind, rest) = name.split_once('_')?;
    let (function, by) = split_function(rest)?;
    match kind {
        "d" => match by.strip_suffix("_packed") {
            Some(by) => derivative("d", function, by).map(|whole| format!("packed({whole})")),
            None => derivative("d", function, by),
        },
        "jvp" | "vjp" | "hessian" => derivative(kind, function, by),
        _ => None,
    }
}

/// The function with which a text begins, and what follows.
fn split_function(text: &str) -> Option<(&'static Function, &str)> {
    let functions = Function::all();
    let found = functions.filter_map(|own| Some((own, text.strip_prefix(own.name)?)));
    found.max_by_key(|(own, _)| own.name.len())
}

/// A request for derivatives by the variables of a generated name, or by all where it has none.
fn derivative(kind: &str, function: &Function, by: &str) -> Option<String> {
    let mut rest = by.strip_prefix("_d").unwrap_or(by);
    let mut variables: Vec<&str> = Vec::new();
    let known = function.variables().map(Argument::name);
    let known: Vec<&str> = known.chain([PARAMETERS]).collect();
    while let Some(text) = rest.strip_prefix('_') {
        let begins = |own: &&&str| {
            let rest = text.strip_prefix(**own);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
        };
        let found = known.iter().filter(begins);
        let Some(found) = found.max_by_key(|own| own.len()) else {
            break;
        };
        variables.push(found);
        rest = &text[found.len()..];
    }
    if variables.is_empty() {
        variables.extend(&known[..known.len() - 1]);
    }
    if variables.is_empty() || function.is_compact() {
        return None;
    }
    let of = match function.of {
        Of::System => function.name.to_owned(),
        Of::Frame(_) | Of::Frames(_) => format!("{}(FRAME)", function.name),
    };
    let by = variables.join(", ");
    Some(match kind {
        "d" => format!("d({of})/d({by})"),
        kind => format!("{kind}({of}; {by})"),
    })
}
