//! Which of the formats a file has, and the reading of it.

use crate::description::reading::{Include, Reading};
use crate::description::size::too_large;
use crate::description::{Description, mjcf, toml, urdf};
use crate::diagnostic::{Diagnostic, Source};

/// Endings of what is at times taken for a model, or is one of another format.
const NO_MODELS: [&str; 7] = ["json", "pdf", "rs", "sdf", "step", "usd", "usda"];

/// Reads a model: URDF where its name ends in `.urdf`, MJCF or URDF, by its root element, where it ends in `.xml` or
/// `.mjcf`, our own format otherwise, but for endings of other files. What `xacro` was to make a URDF of is read as one, and refused there.
pub fn read(source: &Source, reading: &Reading, include: Include<'_>) -> Description {
    if let Some(fault) = too_large(source) {
        let empty = Source::new(source.name(), "");
        return Description::none(&empty, vec![fault]);
    }
    let extension = source.name().rsplit_once('.').map_or("", |(_, end)| end);
    let no_equalities = Some("a URDF has no equalities, tendons or fluids");
    let (mut description, base, chart, left_out) = match extension.to_ascii_lowercase().as_str() {
        "urdf" | "xacro" => (urdf::parse(source, reading), None, None, no_equalities),
        "xml" | "mjcf" if urdf::is_urdf(source) => {
            (urdf::parse(source, reading), None, None, no_equalities)
        }
        "xml" | "mjcf" => {
            let base = "an MJCF says itself which of its bodies are free";
            let description = mjcf::parse(source, reading, include);
            (description, Some(base), None, None)
        }
        other if NO_MODELS.contains(&other) => {
            let fault = format!(
                "`.{other}` is no model; a model ends in `.toml`, `.urdf`, `.mjcf`, or `.xml`"
            );
            return Description::none(source, vec![Diagnostic::error(fault)]);
        }
        _ if source.text().trim_start().starts_with('<') => {
            let fault = "a model in XML is a URDF, in a file that ends in `.urdf`, or an MJCF, in one that ends in `.xml` or `.mjcf`";
            let fault = Diagnostic::error(fault).at((0..1).into(), "expected TOML");
            return Description::none(source, vec![fault]);
        }
        _ => {
            let base = "this model says itself by which joints its bodies hang from the inertial frame; one \
                        that floats has `joint = \"free\"` and `chart = \"quaternion\"`";
            let chart = "each joint of this model says it itself, with the key `chart`";
            let description = toml::parse(source);
            let none = "a model of this format has no equalities, tendons or fluids";
            (description, Some(base), Some(chart), Some(none))
        }
    };
    // What the model says itself is not asked for a second time.
    let base = base
        .filter(|_| reading.base.is_some())
        .map(|why| (Reading::BASE, "the base", "a URDF", why));
    let chart = chart
        .filter(|_| reading.chart.is_some())
        .map(|why| (Reading::CHART, "the chart", "a URDF or MJCF", why));
    let left_out = left_out
        .filter(|_| !reading.leave_out.is_empty())
        .map(|why| (Reading::LEAVE_OUT, "what is left out", "an MJCF", why));
    for (key, option, of, why) in base.into_iter().chain(chart).chain(left_out) {
        let fault = format!("{option} can be chosen for {of} alone: {why}");
        let fault = Diagnostic::error(fault).of_entry(key, "");
        description.faults.push(fault);
    }
    description
}
