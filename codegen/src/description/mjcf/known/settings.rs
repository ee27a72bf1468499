//! Attributes of what holds for the whole model.

use crate::description::xml::Known;

pub(in crate::description::mjcf) const COMPILER: Known<'static> = Known::attributes(
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

pub(in crate::description::mjcf) const OPTION: Known<'static> = Known::attributes(
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

pub(in crate::description::mjcf) const FLAG: Known<'static> = Known::attributes(
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
    children: &[
        "default", "joint", "geom", "site", "tendon", "equality", "include",
    ],
    ignored_attributes: &[],
    ignored_children: &[
        "mesh", "material", "texture", "camera", "light", "pair", "skin",
    ],
};
