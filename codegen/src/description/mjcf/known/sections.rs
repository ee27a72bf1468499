//! Elements, by where they stand.

/// Sections of the root.
pub(in crate::description::mjcf) const SECTIONS: [&str; 11] = [
    "compiler",
    "option",
    "default",
    "asset",
    "worldbody",
    "actuator",
    "contact",
    "deformable",
    "equality",
    "tendon",
    "include",
];

/// Sections that say nothing about the dynamics of the tree.
pub(in crate::description::mjcf) const IGNORED_SECTIONS: [&str; 7] = [
    "size",
    "statistic",
    "visual",
    "extension",
    "custom",
    "sensor",
    "keyframe",
];

/// Elements of `actuator`.
pub(in crate::description::mjcf) const ACTUATORS: [&str; 13] = [
    "general",
    "motor",
    "position",
    "velocity",
    "intvelocity",
    "orientation",
    "pid",
    "damper",
    "cylinder",
    "muscle",
    "adhesion",
    "dcmotor",
    "plugin",
];

/// Elements of `equality`.
pub(in crate::description::mjcf) const EQUALITIES: [&str; 7] = [
    "connect",
    "weld",
    "joint",
    "tendon",
    "flex",
    "flexvert",
    "flexstrain",
];

/// Elements that stand in a body.
pub(in crate::description::mjcf) const IN_BODY: [&str; 10] = [
    "body",
    "inertial",
    "joint",
    "freejoint",
    "geom",
    "site",
    "frame",
    "replicate",
    "attach",
    "include",
];

/// Elements in a body that only others than the dynamics look at.
pub(in crate::description::mjcf) const IGNORED_IN_BODY: [&str; 2] = ["camera", "light"];

/// Elements in a body that make others, or forces of their own.
pub(in crate::description::mjcf) const UNSUPPORTED_IN_BODY: [&str; 3] =
    ["composite", "flexcomp", "plugin"];
