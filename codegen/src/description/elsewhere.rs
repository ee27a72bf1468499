//! What other formats call the keys and joints of ours.

/// Keys of ours, and what they are called elsewhere.
const KEYS: [(&str, &[&str]); 24] = [
    ("lower_bodies", &["parent", "parents", "parent_bodies"]),
    ("body", &["bodies", "link", "links"]),
    ("mass_center", &["com", "center_of_mass", "ipos"]),
    ("attachment", &["origin", "pos", "xyz"]),
    (
        "attachment_rotation",
        &["attachment_rpy", "attachment_euler", "attachment_quat"],
    ),
    ("position", &["origin", "pos", "xyz", "attachment"]),
    ("joint", &["joint_type", "type", "joints"]),
    ("armature", &["rotor_inertia"]),
    ("stiffness", &["spring", "spring_constant"]),
    ("rest", &["springref"]),
    ("friction", &["frictionloss"]),
    ("xx", &["ixx", "Ixx", "I_xx"]),
    ("yy", &["iyy", "Iyy", "I_yy"]),
    ("zz", &["izz", "Izz", "I_zz"]),
    ("xy", &["ixy", "Ixy", "I_xy"]),
    ("xz", &["ixz", "Ixz", "I_xz"]),
    ("yz", &["iyz", "Iyz", "I_yz"]),
    ("lower", &["min"]),
    ("upper", &["max"]),
    ("velocity", &["max_velocity", "speed"]),
    ("effort", &["max_effort", "force", "torque"]),
    ("model", &["input", "source", "urdf", "mjcf"]),
    ("output", &["out"]),
    ("abi", &["lang", "language"]),
];

/// Joints of ours, and what they are called elsewhere.
const JOINTS: [(&str, &[&str]); 5] = [
    ("revolute", &["hinge", "pin", "rotary"]),
    ("prismatic", &["slide", "slider", "linear"]),
    ("spherical", &["ball"]),
    ("free", &["floating", "freejoint", "freeflyer"]),
    ("fixed", &["weld", "rigid"]),
];

/// What to do without constraints.
const NO_CONSTRAINTS: &str = "closed loops and rolling are not supported: a model is a tree, of whose joints one may follow another, as `mimic` says";

/// What to do without a state.
const NO_STATE: &str = "a model has no state: it is an argument of the functions";

/// What to do without loads.
const NO_LOADS: &str = "a model has no loads: they are an argument of the functions";

/// Keys that stand elsewhere, and where.
const PLACES: [(&str, &str); 14] = [
    (
        "gravity",
        "gravity stands at the top of a model; `kane convert` makes a model in this format of another one",
    ),
    (
        "parent",
        "`lower_bodies`, at the top of a model, says which body carries which",
    ),
    ("frame", "frames stand in the model, as `[[frame]]`"),
    ("body", "bodies stand in the model, as `[[body]]`"),
    ("constraint", NO_CONSTRAINTS),
    ("constraints", NO_CONSTRAINTS),
    ("equality", NO_CONSTRAINTS),
    (
        "gear_ratio",
        "the inertia of a rotor behind a gear is `armature`: the rotor's own times the square of the gear ratio",
    ),
    ("initial", NO_STATE),
    ("initial_state", NO_STATE),
    ("load", NO_LOADS),
    ("loads", NO_LOADS),
    (
        "prescribed",
        "`--prescribed NAME`, or `prescribed` in `kane.toml`, says which joints have prescribed accelerations",
    ),
    (
        "inertia_point",
        "`inertia` is about the mass centre: `I = I_P - m (d·d 1 - d d^T)`, with `I_P` about a point and `d` from the mass centre to it",
    ),
];

/// Values of ours, by the words with which a message begins, and what to write where one has another type.
const VALUES: [(&str, &str); 3] = [
    ("`gravity`", "write for example `[0.0, 0.0, -9.81]`"),
    (
        "`body` of frame ",
        "write the name of the body: `body = \"hand\"`",
    ),
    (
        "`lower_bodies`",
        "bodies are numbered from 1, as they stand in the file; 0 is the inertial frame",
    ),
];

/// Where a key stands that is none here.
pub(super) fn place(key: &str) -> Option<&'static str> {
    let mut places = PLACES.into_iter();
    places.find(|(own, _)| *own == key).map(|(_, place)| place)
}

/// What to write for a value of another type, or for an entry of it; `what` is the words for it in messages.
pub(super) fn value(what: &str) -> Option<&'static str> {
    let entry_of = what
        .strip_prefix("entry ")
        .and_then(|entry| entry.split_once(" of "));
    let value = entry_of.map_or(what, |(_, value)| value);
    let mut values = VALUES.into_iter();
    values
        .find(|(begin, _)| value.starts_with(begin))
        .map(|(_, help)| help)
}

/// Of our keys that are absent, the one that is meant by a key of another format.
pub(super) fn key(name: &str, absent: &[&str]) -> Option<&'static str> {
    let keys = KEYS.iter().filter(|(own, _)| absent.contains(own));
    found(keys, name)
}

/// Our joint for one of another format.
pub(super) fn joint(name: &str) -> Option<&'static str> {
    found(JOINTS.iter(), name)
}

fn found<'t>(
    mut rows: impl Iterator<Item = &'t (&'static str, &'static [&'static str])>,
    name: &str,
) -> Option<&'static str> {
    let row = rows.find(|(_, names)| names.contains(&name));
    row.map(|(own, _)| *own)
}
