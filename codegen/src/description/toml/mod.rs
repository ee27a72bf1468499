//! Our own format, TOML.
//!
//! `name`, `lower_bodies` and of every `[[body]]` the `name`, `mass`, `mass_center`, `inertia`, `attachment` and
//! `joint` must be written, also where they are zero: physics has no hidden defaults. What else there is may be
//! absent, but for the `axis` of a joint that needs one.

mod body;
mod joint;
mod value;
mod write;

pub use write::write;

use crate::description::toml_reader::{Item, Reader, span};
use crate::description::{Description, Given, Order, Scalar};
use crate::diagnostic::{Source, Span, Spanned};

const ROOT_KEYS: [&str; 5] = ["name", "gravity", "lower_bodies", "order", "body"];

/// Reads a description; what is wrong stands in [`Description::faults`].
pub fn parse(source: &Source) -> Description {
    let mut reader = Reader::default();
    let document = reader.document(source);
    let start = Span { start: 0, end: 0 };
    let mut description = Description {
        gravity: [Some(Spanned::new(Scalar::Baked(0.0), start)); 3],
        ..Description::none(source, Vec::new())
    };
    // A file that is not TOML has lost its keys; that they are missing would be no news.
    if !(document.is_empty() && reader.has_faults()) {
        read(&mut reader, &document, &mut description);
    }
    description.faults = reader.faults.into_told();
    description
}

fn read(reader: &mut Reader, document: &::toml::de::DeTable<'_>, description: &mut Description) {
    let root = reader.root(document, &ROOT_KEYS);
    let name = reader.required(&root, "name", "name = \"pendulum\"");
    description.name = name.and_then(|item| reader.string(item, "`name`"));
    if let Some(item) = root.get("gravity") {
        description.gravity = value::vector(reader, item, "`gravity`");
    }
    let lower = reader.required(&root, "lower_bodies", "lower_bodies = [0, 1, 1]");
    description.lower_bodies = lower.and_then(|item| lower_bodies(reader, item));
    if let Some(item) = root.get("order") {
        description.order = reader.choice(item, "`order`", &Order::NAMED, "unknown order");
    }
    if let Some(item) = reader.required(&root, "body", "[[body]]") {
        let items = reader
            .list(item, "`body`", "tables, `[[body]]`")
            .unwrap_or_default();
        description.bodies = items
            .iter()
            .enumerate()
            .map(|(index, item)| body::read(reader, item, index + 1))
            .collect();
    }
}

fn lower_bodies(reader: &mut Reader, item: &Item<'_>) -> Given<Vec<Given<i64>>> {
    let entries = reader.list(item, "`lower_bodies`", "whole numbers")?;
    let numbers = entries.iter().enumerate();
    let numbers = numbers.map(|(index, entry)| {
        reader.integer(entry, &format!("entry {} of `lower_bodies`", index + 1))
    });
    Some(Spanned::new(numbers.collect(), span(item)))
}
