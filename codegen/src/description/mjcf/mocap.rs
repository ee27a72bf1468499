//! Which bodies follow motion capture, and which sites stand on them.

use std::collections::BTreeSet;

use crate::description::mjcf::files::Files;
use crate::description::xml::Element;

/// Names of bodies that follow motion capture, and of the sites on them.
#[derive(Debug, Default)]
pub(super) struct Mocap<'d> {
    bodies: BTreeSet<&'d str>,
    sites: BTreeSet<&'d str>,
}

impl<'d> Mocap<'d> {
    /// Those below these elements.
    pub(super) fn of(files: &'d Files<'_>, worlds: &[Element<'d>]) -> Self {
        let mut mocap = Self::default();
        let mut open: Vec<(Element<'d>, bool)> = worlds.iter().map(|w| (*w, false)).collect();
        while let Some((element, follows)) = open.pop() {
            for child in files.children(element) {
                let name = child.attribute("name").map(|name| name.value);
                match child.name() {
                    "body" => {
                        let follows = child.attribute("mocap").is_some_and(|m| m.value == "true");
                        if follows {
                            mocap.bodies.extend(name);
                        }
                        open.push((child, follows));
                    }
                    "site" if follows => mocap.sites.extend(name),
                    "frame" | "replicate" => open.push((child, follows)),
                    _ => {}
                }
            }
        }
        mocap
    }

    /// True of a body that follows motion capture.
    pub(super) fn has_body(&self, name: &str) -> bool {
        self.bodies.contains(name)
    }

    /// True of a site that stands on such a body.
    pub(super) fn has_site(&self, name: &str) -> bool {
        self.sites.contains(name)
    }
}
