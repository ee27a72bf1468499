//! Attributes of what bodies refer to.

use crate::description::xml::Known;

pub(in crate::description::mjcf) const MESH: Known<'static> = Known {
    attributes: &[
        "name",
        "class",
        "file",
        "content_type",
        "scale",
        "inertia",
        "refpos",
        "refquat",
        "vertex",
        "face",
        "maxhullvert",
        "builtin",
    ],
    children: &[],
    ignored_attributes: &[
        "convexhull",
        "material",
        "normal",
        "octree_maxdepth",
        "params",
        "smoothnormal",
        "texcoord",
    ],
    ignored_children: &["plugin"],
};
