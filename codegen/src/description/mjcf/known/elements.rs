//! Names of elements and attributes: those that are read, and those without influence on the dynamics of the tree.
//!
//! As in MuJoCo 4.0, with some of earlier versions. Of other names there is a warning.

use crate::description::xml::Known;

const fn known(
    attributes: &'static [&'static str],
    ignored_attributes: &'static [&'static str],
) -> Known<'static> {
    Known {
        attributes,
        ignored_attributes,
        ..Known::NONE
    }
}

/// Sections of the root.
pub(in crate::description::mjcf) const SECTIONS: [&str; 10] = [
    "compiler",
    "option",
    "default",
    "worldbody",
    "actuator",
    "contact",
    "deformable",
    "equality",
    "tendon",
    "include",
];

/// Sections that say nothing about the dynamics of the tree.
pub(in crate::description::mjcf) const IGNORED_SECTIONS: [&str; 8] = [
    "size",
    "statistic",
    "visual",
    "extension",
    "custom",
    "asset",
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
pub(in crate::description::mjcf) const EQUALITIES: [&str; 6] =
    ["connect", "weld", "joint", "tendon", "flex", "flexstrain"];

/// Elements that stand in a body.
pub(in crate::description::mjcf) const IN_BODY: [&str; 7] = [
    "body",
    "inertial",
    "joint",
    "freejoint",
    "geom",
    "frame",
    "include",
];

/// Elements in a body that only others than the dynamics look at.
pub(in crate::description::mjcf) const IGNORED_IN_BODY: [&str; 3] = ["site", "camera", "light"];

/// Elements in a body that make others, or forces of their own.
pub(in crate::description::mjcf) const UNSUPPORTED_IN_BODY: [&str; 5] =
    ["replicate", "attach", "composite", "flexcomp", "plugin"];

pub(in crate::description::mjcf) const COMPILER: Known<'static> = known(
    &[
        "angle",
        "eulerseq",
        "coordinate",
        "autolimits",
        "inertiafromgeom",
        "inertiagrouprange",
        "boundmass",
        "boundinertia",
        "balanceinertia",
        "settotalmass",
        "alignfree",
    ],
    &[
        "assetdir",
        "conflict",
        "convexhull",
        "discardvisual",
        "exactmeshinertia",
        "fitaabb",
        "fusestatic",
        "meshdir",
        "passthrough",
        "savecanonical",
        "savecompiled",
        "saveinertial",
        "strippath",
        "texturedir",
        "usethread",
    ],
);

pub(in crate::description::mjcf) const OPTION: Known<'static> = known(
    &["gravity", "density", "viscosity"],
    &[
        "actuatorgroupdisable",
        "apirate",
        "ccd_iterations",
        "ccd_tolerance",
        "collision",
        "cone",
        "impratio",
        "integrator",
        "iterations",
        "jacobian",
        "ls_iterations",
        "ls_tolerance",
        "magnetic",
        "mpr_iterations",
        "mpr_tolerance",
        "noslip_iterations",
        "noslip_tolerance",
        "o_friction",
        "o_margin",
        "o_solimp",
        "o_solref",
        "sdf_initpoints",
        "sdf_iterations",
        "sleep_tolerance",
        "solver",
        "timestep",
        "tolerance",
        // Without a density or a viscosity the air does nothing.
        "wind",
    ],
);

pub(in crate::description::mjcf) const FLAG: Known<'static> = known(
    &[
        "gravity",
        "spring",
        "damper",
        "passive",
        "equality",
        "constraint",
    ],
    &[
        "actuation",
        "autoreset",
        "clampctrl",
        "contact",
        "diagexact",
        "energy",
        "eulerdamp",
        "filterparent",
        "frictionloss",
        "fwdinv",
        "invdiscrete",
        "ipc",
        "island",
        "limit",
        "midphase",
        "multiccd",
        "nativeccd",
        "override",
        "refsafe",
        "sensor",
        "sensornoise",
        "sleep",
        "speculative",
        "warmstart",
    ],
);

pub(in crate::description::mjcf) const DEFAULT: Known<'static> = Known {
    attributes: &["class"],
    children: &["default", "joint", "geom", "tendon", "equality", "include"],
    ignored_attributes: &[],
    ignored_children: &[
        "mesh", "material", "texture", "site", "camera", "light", "pair", "skin",
    ],
};

pub(in crate::description::mjcf) const BODY: Known<'static> = known(
    &[
        "name",
        "childclass",
        "mocap",
        "pos",
        "quat",
        "axisangle",
        "xyaxes",
        "zaxis",
        "euler",
        "gravcomp",
    ],
    &["fuse", "simple", "sleep", "user"],
);

pub(in crate::description::mjcf) const FRAME: Known<'static> = known(
    &[
        "childclass",
        "pos",
        "quat",
        "axisangle",
        "xyaxes",
        "zaxis",
        "euler",
    ],
    &["name"],
);

pub(in crate::description::mjcf) const INERTIAL: Known<'static> = known(
    &[
        "pos",
        "quat",
        "axisangle",
        "xyaxes",
        "zaxis",
        "euler",
        "mass",
        "diaginertia",
        "fullinertia",
    ],
    &[],
);

pub(in crate::description::mjcf) const JOINT: Known<'static> = known(
    &[
        "name",
        "class",
        "type",
        "pos",
        "axis",
        "ref",
        "limited",
        "range",
        "actuatorfrclimited",
        "actuatorfrcrange",
        "stiffness",
        "springref",
        "springdamper",
        "springyield",
        "damping",
        "armature",
        "frictionloss",
    ],
    &[
        "actuatorgravcomp",
        "group",
        "margin",
        "solimpfriction",
        "solimplimit",
        "solreffriction",
        "solreflimit",
        "user",
    ],
);

pub(in crate::description::mjcf) const FREE_JOINT: Known<'static> =
    known(&["name", "align"], &["group"]);

pub(in crate::description::mjcf) const GEOM: Known<'static> = known(
    &[
        "name",
        "class",
        "type",
        "pos",
        "quat",
        "axisangle",
        "xyaxes",
        "zaxis",
        "euler",
        "fromto",
        "size",
        "mass",
        "density",
        "shellinertia",
        "group",
        "mesh",
    ],
    &[
        "adhesion",
        "castshadow",
        "conaffinity",
        "condim",
        "contype",
        "fitscale",
        "fluidcoef",
        "fluidshape",
        "friction",
        "gap",
        "hfield",
        "margin",
        "material",
        "priority",
        "rgba",
        "solimp",
        "solmix",
        "solref",
        "surfacevel",
        "user",
    ],
);

pub(in crate::description::mjcf) const TENDON: Known<'static> = known(
    &[
        "name",
        "class",
        "stiffness",
        "damping",
        "armature",
        "frictionloss",
    ],
    &[
        "actuatorfrclimited",
        "actuatorfrcrange",
        "group",
        "limited",
        "margin",
        "material",
        "range",
        "rgba",
        "solimpfriction",
        "solimplimit",
        "solreffriction",
        "solreflimit",
        "springlength",
        "springyield",
        "user",
        "width",
    ],
);

pub(in crate::description::mjcf) const EQUALITY: Known<'static> = known(
    &["name", "class", "active"],
    &[
        "anchor",
        "body1",
        "body2",
        "cell",
        "flex",
        "geom1",
        "geom2",
        "joint1",
        "joint2",
        "polycoef",
        "relpose",
        "site1",
        "site2",
        "solimp",
        "solref",
        "tendon1",
        "tendon2",
        "torquescale",
    ],
);

/// Of all actuators together: what one of them may have is not told apart.
pub(in crate::description::mjcf) const ACTUATOR: Known<'static> = known(
    &["name", "class", "armature", "damping"],
    &IGNORED_OF_ACTUATOR,
);

const IGNORED_OF_ACTUATOR: [&str; 66] = [
    "actdim",
    "actearly",
    "actlimited",
    "actrange",
    "area",
    "bias",
    "biasprm",
    "biastype",
    "body",
    "cogging",
    "controller",
    "cranklength",
    "cranksite",
    "ctrllimited",
    "ctrlrange",
    "dampratio",
    "delay",
    "diameter",
    "dynprm",
    "dyntype",
    "ffrange",
    "force",
    "forcelimited",
    "forcerange",
    "fpmax",
    "fvmax",
    "gain",
    "gainprm",
    "gaintype",
    "gear",
    "group",
    "imax",
    "inductance",
    "inheritrange",
    "input",
    "instance",
    "interp",
    "joint",
    "jointinparent",
    "ki",
    "kp",
    "kv",
    "lengthrange",
    "lmax",
    "lmin",
    "lugre",
    "motorconst",
    "nominal",
    "nsample",
    "plugin",
    "posrange",
    "range",
    "refsite",
    "resistance",
    "saturation",
    "scale",
    "site",
    "slewmax",
    "slidersite",
    "tausmooth",
    "tendon",
    "thermal",
    "timeconst",
    "user",
    "velrange",
    "vmax",
];
