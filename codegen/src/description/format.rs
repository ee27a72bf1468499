//! Which of the formats a file has, and the reading of it.

use crate::description::reading::{Include, Reading};
use crate::description::size::too_large;
use crate::description::{Description, mjcf, toml, urdf};
use crate::diagnostic::{Diagnostic, Source};

/// Reads a model: URDF where its name ends in `.urdf`, MJCF or URDF, by its root element, where it ends in `.xml` or
/// `.mjcf`, our own format otherwise.
pub fn read(source: &Source, reading: &Reading, include: Include<'_>) -> Description {
    if let Some(fault) = too_large(source) {
        let empty = Source::new(source.name(), "");
        return Description::none(&empty, vec![fault]);
    }
    let extension = source.name().rsplit_once('.').map_or("", |(_, end)| end);
    let (mut description, base, chart) = match extension.to_ascii_lowercase().as_str() {
        "urdf" => (urdf::parse(source, reading), None, None),
        "xml" | "mjcf" if urdf::is_urdf(source) => (urdf::parse(source, reading), None, None),
        "xml" | "mjcf" => {
            let base = "an MJCF says itself which of its bodies are free";
            (mjcf::parse(source, reading, include), Some(base), None)
        }
        _ => {
            let base =
                "this model says itself by which joints its bodies hang from the inertial frame";
            let chart = "each joint of this model says it itself, with the key `chart`";
            (toml::parse(source), Some(base), Some(chart))
        }
    };
    // What the model says itself is not asked for a second time.
    let base = base
        .filter(|_| reading.base.is_some())
        .map(|why| ("base", "a URDF", why));
    let chart = chart
        .filter(|_| reading.chart.is_some())
        .map(|why| ("chart", "a URDF or MJCF", why));
    for (option, of, why) in base.into_iter().chain(chart) {
        let fault = format!("the {option} can be chosen for {of} alone: {why}");
        description.faults.push(Diagnostic::error(fault));
    }
    description
}
