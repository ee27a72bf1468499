//! The keys of a whole file.

use crate::description::toml::{body, frame, value};
use crate::description::toml_reader::{Item, Reader, span};
use crate::description::{Description, Given, Order, Scalar};
use crate::diagnostic::{Diagnostic, Source, Span, Spanned};

const ROOT_KEYS: [&str; 6] = ["name", "gravity", "lower_bodies", "order", "body", "frame"];

/// Reads a description; what is wrong stands in [`Description::faults`].
pub fn parse(source: &Source) -> Description {
    let mut reader = Reader::default();
    let document = reader.document(source);
    // A file that is not TOML has lost its keys; that they are missing would be no news.
    let description = if document.is_empty() && reader.has_faults() {
        Description {
            gravity: no_gravity(),
            ..Description::none(source, Vec::new())
        }
    } else {
        read(&mut reader, &document, source)
    };
    Description {
        faults: reader.faults.into_told(),
        ..description
    }
}

/// The description in a table, but for the faults.
fn read(reader: &mut Reader, document: &::toml::de::DeTable<'_>, source: &Source) -> Description {
    if let Some((key, _)) = document.get_key_value("system") {
        let fault = "this file lists systems, as kane.toml does, and is no model";
        let fault = Diagnostic::error(fault).at(key.span().into(), "expected a model");
        let help = "`kane generate --config FILE` generates what it lists";
        reader.faults.push(fault.help(help));
        return Description {
            gravity: no_gravity(),
            ..Description::none(source, Vec::new())
        };
    }
    let root = reader.root(document, &ROOT_KEYS);
    let name = reader.required(&root, "name", "name = \"pendulum\"");
    let name = name.and_then(|item| reader.string(item, "`name`"));
    let gravity = root.get("gravity");
    if let (None, Some(name)) = (gravity, &name) {
        let note = Diagnostic::note("the model has no `gravity`: none acts");
        let note = note.at(name.span, "no gravity");
        reader
            .faults
            .push(note.help("write for example `gravity = [0.0, 0.0, -9.81]`, or `gravity = [0.0, 0.0, 0.0]` if that is meant"));
    }
    let gravity = gravity.map_or_else(no_gravity, |item| value::vector(reader, item, "`gravity`"));
    let lower = reader.required(&root, "lower_bodies", "lower_bodies = [0, 1, 1]");
    let lower_bodies = lower.and_then(|item| lower_bodies(reader, item));
    let order = match root.get("order") {
        Some(item) => reader.choice(item, "`order`", &Order::NAMED, "unknown order"),
        None => Some(Spanned::new(Order::Body, START)),
    };
    let items = reader
        .required(&root, "body", "[[body]]")
        .and_then(|item| reader.list(item, "`body`", "tables, `[[body]]`"));
    let bodies = items.unwrap_or_default().into_iter().enumerate();
    let bodies = bodies.map(|(index, item)| body::read(reader, item, index + 1));
    let bodies = bodies.collect();
    let items = root
        .get("frame")
        .and_then(|item| reader.list(item, "`frame`", "tables, `[[frame]]`"));
    let frames = items.unwrap_or_default().into_iter().enumerate();
    let frames = frames.map(|(index, item)| frame::read(reader, item, index + 1));
    let frames = frames.collect();
    Description {
        name,
        gravity,
        lower_bodies,
        order,
        bodies,
        frames,
        ..Description::none(source, Vec::new())
    }
}

/// The place of what a file does not say.
const START: Span = Span { start: 0, end: 0 };

fn no_gravity() -> [Given<Scalar>; 3] {
    [Some(Spanned::new(Scalar::Baked(0.0), START)); 3]
}

fn lower_bodies(reader: &mut Reader, item: &Item<'_>) -> Given<Vec<Given<i64>>> {
    let entries = reader.list(item, "`lower_bodies`", "whole numbers")?;
    let numbers = entries.iter().enumerate();
    let numbers = numbers.map(|(index, entry)| {
        reader.integer(entry, &format!("entry {} of `lower_bodies`", index + 1))
    });
    Some(Spanned::new(numbers.collect(), span(item)))
}
