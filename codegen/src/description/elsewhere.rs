//! What other formats call the keys and joints of ours.

/// Keys of ours, and what they are called elsewhere.
const KEYS: [(&str, &[&str]); 7] = [
    ("lower_bodies", &["parent", "parents", "parent_bodies"]),
    ("body", &["bodies", "link", "links"]),
    ("mass_center", &["com", "center_of_mass", "ipos"]),
    ("attachment", &["origin", "pos", "xyz"]),
    ("joint", &["joint_type", "type", "joints"]),
    ("armature", &["rotor_inertia"]),
    ("rest", &["springref"]),
];

/// Joints of ours, and what they are called elsewhere.
const JOINTS: [(&str, &[&str]); 5] = [
    ("revolute", &["hinge", "pin", "rotary"]),
    ("prismatic", &["slide", "slider", "linear"]),
    ("spherical", &["ball"]),
    ("free", &["floating", "freejoint", "freeflyer"]),
    ("fixed", &["weld", "rigid"]),
];

/// Keys that stand elsewhere, and where.
const PLACES: [(&str, &str); 3] = [
    (
        "gravity",
        "gravity stands in the model; `kane convert` makes a model in this format of another one",
    ),
    ("frame", "frames stand in the model, as `[[frame]]`"),
    ("body", "bodies stand in the model, as `[[body]]`"),
];

/// Where a key stands that is none here.
pub(super) fn place(key: &str) -> Option<&'static str> {
    let mut places = PLACES.into_iter();
    places.find(|(own, _)| *own == key).map(|(_, place)| place)
}

/// Our key for one of another format.
pub(super) fn key(name: &str) -> Option<&'static str> {
    found(&KEYS, name)
}

/// Our joint for one of another format.
pub(super) fn joint(name: &str) -> Option<&'static str> {
    found(&JOINTS, name)
}

fn found(table: &[(&'static str, &[&str])], name: &str) -> Option<&'static str> {
    let mut rows = table.iter();
    let row = rows.find(|(_, names)| names.contains(&name));
    row.map(|(own, _)| *own)
}
