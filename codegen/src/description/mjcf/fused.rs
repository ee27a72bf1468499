//! `fusestatic`: bodies without joints that MuJoCo makes parts of those that carry them, where masses depend on that.

use crate::description::mjcf::chain::Bodies;
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
