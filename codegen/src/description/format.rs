//! Which of the formats a file has, and the reading of it.

use std::path::Path;

use crate::description::reading::{Include, Reading};
use crate::description::size::too_large;
use crate::description::{Description, lfs, mjcf, toml, urdf};
use crate::diagnostic::{Diagnostic, Source};

/// The formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Urdf,
    Mjcf,
    Toml,
}

impl Format {
    /// That of a model: URDF where its name ends in `.urdf`, MJCF or URDF, by its root element, where it ends in `.xml` or `.mjcf`, else
    /// our own format. What `xacro` was to make a URDF of is read as one, and refused there.
    fn of(source: &Source) -> Self {
        match &*extension(source) {
            "urdf" | "xacro" => Self::Urdf,
            "xml" | "mjcf" if urdf::is_urdf(source) => Self::Urdf,
            "xml" | "mjcf" => Self::Mjcf,
            _ => Self::Toml,
        }
    }

    /// Why it leaves neither the base, nor the chart, nor what is left out to the user, where it does not.
    fn says_itself(self) -> [Option<&'static str>; 3] {
        match self {
            Self::Urdf => [
                None,
                None,
                Some("a URDF has no equalities, tendons or fluids"),
            ],
            Self::Mjcf => [
                Some("an MJCF says itself which of its bodies are free"),
                None,
                None,
            ],
            Self::Toml => [
                Some(
                    "this model says itself by which joints its bodies hang from the inertial frame; one \
                     that floats has `joint = \"free\"` and `chart = \"quaternion\"`",
                ),
                Some("each joint of this model says it itself, with the key `chart`"),
                Some("a model of this format has no equalities, tendons or fluids"),
            ],
        }
    }
}

fn extension(source: &Source) -> String {
    let extension = Path::new(source.name()).extension();
    let extension = extension.unwrap_or_default().to_string_lossy();
    extension.to_ascii_lowercase()
}

/// What of this the model's format leaves to the user.
pub fn left_open(source: &Source, reading: &Reading) -> Reading {
    let [base, chart, left_out] = Format::of(source).says_itself();
    let mut open = reading.clone();
    open.base = open.base.filter(|_| base.is_none());
    open.chart = open.chart.filter(|_| chart.is_none());
    if left_out.is_some() {
        open.leave_out.clear();
    }
    open
}

/// Reads a model, whose name tells its format; endings of other files are refused.
pub fn read(source: &Source, reading: &Reading, include: Include<'_>) -> Description {
    if let Some(fault) = too_large(source) {
        let empty = Source::new(source.name(), "");
        return Description::none(&empty, vec![fault]);
    }
    let format = Format::of(source);
    let mut description = match (format, &*extension(source)) {
        (Format::Urdf, _) => urdf::parse(source, reading),
        (Format::Mjcf, _) => mjcf::parse(source, reading, include),
        (Format::Toml, other) if other != "sdf" && source.text().trim_start().starts_with('<') => {
            let fault = "a model in XML is a URDF, in a file that ends in `.urdf`, or an MJCF, in one that ends in `.xml` or `.mjcf`";
            let fault = Diagnostic::error(fault).at((0..1).into(), "expected TOML");
            return Description::none(source, vec![fault]);
        }
        (Format::Toml, other) if !["toml", ""].contains(&other) => {
            let fault = format!(
                "`.{other}` is no model; a model ends in `.toml`, `.urdf`, `.mjcf`, or `.xml`"
            );
            return Description::none(source, vec![Diagnostic::error(fault)]);
        }
        (Format::Toml, _) => match lfs::pointer(source.text(), 0) {
            Some(fault) => return Description::none(source, vec![fault]),
            None => toml::parse(source),
        },
    };
    // What the model says itself is not asked for a second time.
    let [base, chart, left_out] = format.says_itself();
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
