//! Sites: frames that only mark places.
//!
//! A site without a name is left out, for nothing can ask for it. Its shape does not matter, but where that leads from one
//! point to another (`fromto`): the site is then in their middle.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::mjcf::contents::Inside;
use crate::description::mjcf::mass::inertial::baked;
use crate::description::mjcf::mass::segment::Segment;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::defaults::ElementKind;
use crate::description::mjcf::model::models::Models;
use crate::description::mjcf::orientation::{placement, z_axis};
use crate::description::mjcf::placement::Placement;
use crate::description::xml::Reader;
use crate::description::{Carrier, FrameRotation, WrittenBody, WrittenFrame, too_many};
use crate::diagnostic::{Diagnostic, Spanned, shown};

/// The shapes of sites, and whether they can lead from one point to another. A site is a sphere where it does not say.
const TYPES: [(&str, bool); 5] = [
    ("sphere", false),
    ("capsule", true),
    ("cylinder", true),
    ("ellipsoid", true),
    ("box", true),
];

/// A site, and the number of its body, from 1, or 0 for the world.
pub(super) struct Site<'d> {
    pub(super) inside: Inside<'d>,
    pub(super) body: usize,
}

/// The sites as a description has them. One that is called as a body is gives way to that.
pub(super) fn written<'d>(
    reader: &mut Reader,
    models: &Models<'d>,
    sites: &[Site<'d>],
    bodies: &[WrittenBody],
) -> Vec<WrittenFrame> {
    let mut names = Names::of(sites, bodies);
    let mut written = Vec::new();
    for site in sites {
        let Some(frame) = frame(reader, models, site, bodies) else {
            continue;
        };
        if let Some(fault) = too_many(
            "the number of sites with names is at least",
            written.len() + 1,
        ) {
            reader.faults.push(fault.at(frame.span, "one too many"));
            break;
        }
        let name = frame.name.map(|name| Spanned {
            value: names.of_site(reader, &name),
            span: name.span,
        });
        written.push(WrittenFrame { name, ..frame });
    }
    written
}

/// What sites are called, whose names bodies may have.
struct Names<'b> {
    bodies: BTreeSet<&'b str>,
    sites: BTreeSet<String>,
    /// Of sites that gave way.
    others: BTreeMap<String, String>,
}

impl<'b> Names<'b> {
    fn of(sites: &[Site<'_>], bodies: &'b [WrittenBody]) -> Self {
        let bodies = bodies.iter().filter_map(|body| body.name.as_ref());
        let sites = sites.iter().filter_map(|site| site.inside.name());
        Self {
            bodies: bodies.map(|name| name.value.as_str()).collect(),
            sites: sites.map(|name| name.value).collect(),
            others: BTreeMap::new(),
        }
    }

    /// The name, or another one that nothing has where a body has it.
    fn of_site(&mut self, reader: &mut Reader, name: &Spanned<String>) -> String {
        let Spanned { value: name, span } = name;
        if !self.bodies.contains(name.as_str()) {
            return name.clone();
        }
        if let Some(other) = self.others.get(name) {
            return other.clone();
        }
        let mut other = name.clone();
        while self.bodies.contains(other.as_str()) || self.sites.contains(&other) {
            other.push_str("_site");
        }
        let note = format!(
            "site `{}` is called `{}`: a body has its name",
            shown(name),
            shown(&other)
        );
        let note = Diagnostic::note(note).one_of(
            "sites with names of bodies are called otherwise",
            format!("`{}`", shown(&other)),
        );
        reader.faults.push(note.at(*span, "a body is called this"));
        self.sites.insert(other.clone());
        self.others.insert(name.clone(), other.clone());
        other
    }
}

fn frame<'d>(
    reader: &mut Reader,
    models: &Models<'d>,
    site: &Site<'d>,
    bodies: &[WrittenBody],
) -> Option<WrittenFrame> {
    let Site { inside, body } = site;
    let model = &models.list[inside.around.model];
    let element = inside.element;
    let name = inside.name()?;
    let owner = format!("site `{}`", shown(&name.value));
    let defaults = &model.defaults;
    let given = defaults.attributes(
        reader,
        element,
        &owner,
        ElementKind::Site,
        inside.around.class,
    );
    let own = if given.has("fromto") {
        middle(reader, &given)?
    } else {
        placement(reader, &given, &model.settings)
    };
    let place = inside.around.frame.then(&own);
    let carrier = match body.checked_sub(1) {
        None => Carrier::Inertial,
        Some(body) => Carrier::Body(bodies.get(body)?.name.clone()),
    };
    let span = element.span();
    Some(WrittenFrame {
        body: carrier,
        position: place.position.map(|entry| {
            let entry = baked(Spanned::new(entry, span));
            Some(entry)
        }),
        rotation: Some(Spanned::new(FrameRotation::Baked(place.rotation), span)),
        ..WrittenFrame::new(span, Some(name))
    })
}

/// Half way between two points; whatever else says where the site is does not count.
fn middle(reader: &mut Reader, site: &Attributes<'_>) -> Option<Placement> {
    let has_length = match site.keyword(reader, "type", &TYPES) {
        Some(kind) => kind.value,
        // One that cannot be read is told already, and whatever is meant leads from one point to another.
        None => site.has("type"),
    };
    let segment = Segment::read(reader, site, !has_length)?;
    Some(Placement {
        position: segment.center(),
        rotation: z_axis(segment.back())?,
    })
}
