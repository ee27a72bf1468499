//! Attributes of bodies, and of what stands in them.

use crate::description::xml::Known;

pub(in crate::description::mjcf) const BODY: Known<'static> = Known::attributes(
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
        "fuse",
    ],
    &["simple", "sleep", "user"],
);

pub(in crate::description::mjcf) const FRAME: Known<'static> = Known::attributes(
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

pub(in crate::description::mjcf) const REPLICATE: Known<'static> =
    Known::attributes(&["count", "euler", "offset", "sep", "childclass"], &[]);

pub(in crate::description::mjcf) const ATTACH: Known<'static> =
    Known::attributes(&["model", "body", "frame", "prefix"], &[]);

pub(in crate::description::mjcf) const INERTIAL: Known<'static> = Known::attributes(
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

pub(in crate::description::mjcf) const JOINT: Known<'static> = Known::attributes(
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
        "actuatorgravcomp",
    ],
    &[
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
    Known::attributes(&["name", "align"], &["group"]);

pub(in crate::description::mjcf) const SITE: Known<'static> = Known::attributes(
    &[
        "name",
        "class",
        "pos",
        "quat",
        "axisangle",
        "xyaxes",
        "zaxis",
        "euler",
        "type",
        "fromto",
    ],
    &["group", "material", "size", "rgba", "user"],
);

pub(in crate::description::mjcf) const GEOM: Known<'static> = Known::attributes(
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
        "fitscale",
    ],
    &[
        "adhesion",
        "castshadow",
        "conaffinity",
        "condim",
        "contype",
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
