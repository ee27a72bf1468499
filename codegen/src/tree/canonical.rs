//! One text for a tree, however its description was written: what a hash is taken of.
//!
//! In: a tree. Out: text that holds all that can influence generated code, and nothing else: no paths, no spans,
//! no formatting. Floats stand in their shortest text that reads back bit for bit.

use std::fmt::Write as _;

use crate::tree::{Coordinate, Order, Tree, Value};

/// The canonical text of a tree.
pub fn canonical(tree: &Tree) -> String {
    let mut text = String::new();
    let order = match tree.order {
        Order::Body => "body",
        Order::Notes => "notes",
    };
    // Strings are quoted with their escapes, so that no name can imitate another line.
    line(
        &mut text,
        format_args!("system {:?} order {order}", tree.name),
    );
    line(
        &mut text,
        format_args!("gravity{}", values(tree, &tree.gravity)),
    );
    for (index, body) in tree.bodies.iter().enumerate() {
        let lower = body.lower.map_or(0, |lower| lower.index() + 1);
        let number = index + 1;
        line(
            &mut text,
            format_args!(
                "body {number} on {lower} {:?} as {}",
                body.name, body.identifier
            ),
        );
        line(
            &mut text,
            format_args!("mass{}", values(tree, &[body.mass])),
        );
        line(
            &mut text,
            format_args!("mass_center{}", values(tree, &body.mass_center)),
        );
        let inertia = body.inertia;
        let components = [
            inertia.xx, inertia.yy, inertia.zz, inertia.xy, inertia.xz, inertia.yz,
        ];
        line(
            &mut text,
            format_args!("inertia{}", values(tree, &components)),
        );
        line(
            &mut text,
            format_args!("attachment{}", values(tree, &body.attachment)),
        );
        let joint: String = body.joint.coordinates().iter().map(coordinate).collect();
        line(&mut text, format_args!("joint{joint}"));
    }
    text
}

fn line(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("writing to a string cannot fail");
}

fn values(tree: &Tree, values: &[Value]) -> String {
    let value = |value: &Value| match value {
        Value::Baked(number) => format!(" {number:?}"),
        Value::Runtime(_) => format!(" runtime {:?}", tree.nominal(*value)),
    };
    values.iter().map(value).collect()
}

fn coordinate(coordinate: &Coordinate) -> String {
    match coordinate {
        Coordinate::Free { coordinate, speed } => {
            format!(" q{} u{}", coordinate.index(), speed.index())
        }
        Coordinate::Locked(value) => format!(" {value:?}"),
    }
}
