//! What other tools call our functions and variables, for those who look for a name that we do not have.

use super::{function::Function, generated_name};
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
    } else if let Some(request) = generated_name::request(name) {
        format!("did you mean `{request}`?")
    } else if ["all", "default"].contains(&name) {
        "it stands alone".to_owned()
    } else if let Some(near) = nearest(name, &known) {
        format!("did you mean `{near}`?")
    } else if name.contains(['(', '+']) {
        "quotes stand around one name, not around a request".to_owned()
    } else {
        format!("the functions are {}", known.join(", "))
    }
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

/// What to do about a name that is no frame, if it is another tool's word for the axes along which vectors are written.
pub(super) fn advice_on_frame(name: &str) -> Option<&'static str> {
    match &*plain(name) {
        "local" => Some("for the frame's own axes write `local`"),
        "localworldaligned" => Some("vectors are so without any word behind the frame"),
        _ => None,
    }
}

/// What to do about a name that is no variable.
pub(super) fn advice_on_variable(name: &str) -> String {
    match variable_elsewhere(name) {
        Some(own) => format!("here it is called `{own}`"),
        None => "a number of the model has to be `{ runtime = .. }`".to_owned(),
    }
}
