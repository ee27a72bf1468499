//! What other tools call our functions, for those who look for a name that we do not have.

use super::{
    argument::Argument,
    function::{Function, Of},
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
    } else if let Some((frame, function)) = of_frame(name) {
        format!("did you mean `{function}({frame})`?")
    } else if let Some(request) = of_derivatives(name) {
        format!("did you mean `{request}`?")
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

/// The request for derivatives, of a name in which a function's own stands: `d_forward_dynamics`.
fn of_derivatives(name: &str) -> Option<String> {
    let functions = Function::all().filter(|function| {
        let before = name.strip_prefix("d_");
        let behind = before.and_then(|rest| rest.strip_prefix(function.name));
        let after = name.strip_prefix(function.name);
        behind.is_some_and(|rest| rest.is_empty() || rest.starts_with("_d"))
            || after.is_some_and(|rest| ["_derivatives", "_derivative"].contains(&rest))
    });
    let function = functions.max_by_key(|function| function.name.len())?;
    let by: Vec<&str> = function.variables().map(Argument::name).collect();
    let of = match function.of {
        Of::System => function.name.to_owned(),
        Of::Frame(_) | Of::Frames(_) => format!("{}(FRAME)", function.name),
    };
    let is_differentiable = !by.is_empty() && !function.is_compact();
    is_differentiable.then(|| format!("d({of})/d({})", by.join(", ")))
}
