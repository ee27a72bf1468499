//! `fusestatic`: bodies without joints that MuJoCo makes parts of those that carry them, where masses depend on that.

use crate::description::mjcf::chain::{Bodies, ChainedBody};
use crate::description::mjcf::mass::weight::Weight;
use crate::description::mjcf::model::Model;
use crate::description::mjcf::model::models::Models;
use crate::description::mjcf::model::settings::FromGeoms;
use crate::description::xml::{Element, Reader};
use crate::diagnostic::Diagnostic;

/// Sections in which a body can be named, which MuJoCo then does not fuse.
const NAMING: [&str; 5] = ["actuator", "contact", "custom", "equality", "sensor"];

/// Weighs bodies as MuJoCo does where it fuses them. Where something may keep it from that, which masses change is not known.
pub(super) fn settle(reader: &mut Reader, models: &Models<'_>, bodies: &mut Bodies) {
    let settings = &models.main().settings;
    let Some(place) = settings.fuse else {
        return;
    };
    let drops = settings.from_geoms == FromGeoms::Always && bodies.weigh_geoms_of_fused();
    let leaves_out = settings.total_mass.is_some() && bodies.has_mass_in_the_world();
    let mut others = models.list.iter().map(|model| model.settings.from_geoms);
    let differ = others.any(|other| other != settings.from_geoms);
    let cause = (drops || leaves_out || differ).then(|| doubt(models, bodies));
    if let Some(cause) = cause.flatten() {
        let message = format!("which masses `fusestatic` changes is not known: {cause}");
        let fault = Diagnostic::error(message).at(place, "not supported");
        reader.faults.push(fault.help("leave out `fusestatic`"));
    }
}

impl Bodies {
    /// Takes the weights of bodies that MuJoCo fuses where it weighs geoms alone: of those that are fused with one another the geoms
    /// count, or else the `inertial` of the first. True where that changes a mass.
    fn weigh_geoms_of_fused(&mut self) -> bool {
        let (first, mut is_changed) = (self.first_of_fused(), false);
        let mut has_geoms = vec![false; self.list.len()];
        for (body, first) in self.list.iter().zip(&first) {
            has_geoms[*first] |= body.weight.is_of_geoms();
        }
        for (place, (body, first)) in self.list.iter_mut().zip(first).enumerate() {
            let counts = body.weight.is_of_geoms() || place == first && !has_geoms[first];
            if !counts && body.mass().is_some_and(|mass| mass != 0.0) {
                body.weight = Weight::zero(body.span);
                is_changed = true;
            }
        }
        is_changed
    }

    /// True where something that is fused with the world has a mass.
    fn has_mass_in_the_world(&self) -> bool {
        let total: f64 = self.list.iter().filter_map(ChainedBody::mass).sum();
        self.total_mass() != total
    }

    /// For each body the first, by its place, of those with which it is fused: itself where it is not.
    fn first_of_fused(&self) -> Vec<usize> {
        let mut first: Vec<usize> = Vec::new();
        for (place, body) in self.list.iter().enumerate() {
            let lower = body.lower.checked_sub(1).filter(|_| body.is_fused);
            first.push(lower.map_or(place, |lower| first[lower]));
        }
        first
    }

    /// The mass of all bodies; of none that is fused with the world.
    pub(super) fn total_mass(&self) -> f64 {
        let first = self.first_of_fused().into_iter();
        let bodies = self.list.iter().zip(first);
        let counted = bodies.filter(|(_, first)| {
            let first = &self.list[*first];
            !(first.is_fused && first.lower == 0)
        });
        counted.filter_map(|(body, _)| body.mass()).sum()
    }
}

/// Why MuJoCo may not fuse what it could.
fn doubt(models: &Models<'_>, bodies: &Bodies) -> Option<&'static str> {
    let main = models.main();
    let settings = &main.settings;
    let is_named = || NAMING.iter().any(|name| !main.named(name).is_empty());
    let is_bounded = settings.least_mass.is_some() || settings.least_inertia.is_some();
    let has_target = || {
        let mut worlds = main.named("worldbody").into_iter();
        worlds.any(|world| aims(main, world))
    };
    if models.list.len() > 1 {
        Some("models are attached")
    } else if is_named() {
        Some("elements of other sections may name a body, which MuJoCo then does not fuse")
    } else if is_bounded {
        Some("`boundmass` and `boundinertia` may keep MuJoCo from fusing")
    } else if bodies.lifts_any() || has_target() {
        Some("`gravcomp` and `target` keep MuJoCo from fusing")
    } else {
        None
    }
}

/// True where a camera or a light in an element follows a body.
fn aims<'d>(model: &Model<'d>, element: Element<'d>) -> bool {
    let mut open = vec![element];
    while let Some(element) = open.pop() {
        if element.attribute("target").is_some() {
            return true;
        }
        open.extend(model.files.children(element));
    }
    false
}
