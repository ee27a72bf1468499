//! One text for a tree, however its description was written: what a hash is taken of.
//!
//! In: a tree. Out: text that holds all that can influence generated code, and nothing else: no paths, no spans,
//! no formatting. Which speeds are prescribed the options say. Floats stand in their shortest text that reads back bit for bit.

use std::fmt::Write as _;

use crate::geometry::{IDENTITY, Rotation};
use crate::tree::{Coordinate, Joint, Mechanics, NamedFrame, Offset, Order, Step, Tree, Value};

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
    if tree.lifted != 0.0 {
        line(&mut text, format_args!("lifted {:?}", tree.lifted));
    }
    for parameter in &tree.parameters {
        let (name, nominal) = (&parameter.name, parameter.nominal);
        line(&mut text, format_args!("parameter {name} {nominal:?}"));
    }
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
        for part in &body.parts {
            line(
                &mut text,
                format_args!("mass{}", values(tree, &[part.mass])),
            );
            line(
                &mut text,
                format_args!("mass_center{}", offset(tree, &part.mass_center)),
            );
            let inertia = part.inertia;
            let components = [
                inertia.xx, inertia.yy, inertia.zz, inertia.xy, inertia.xz, inertia.yz,
            ];
            let (components, axes) = (values(tree, &components), rotation(&part.axes));
            line(&mut text, format_args!("inertia{components}{axes}"));
            if part.is_lifted() {
                let lifted = values(tree, &[part.lifted]);
                line(&mut text, format_args!("lifted{lifted}"));
            }
        }
        let (axes, origin) = (
            rotation(&body.pose.rotation),
            offset(tree, &body.pose.origin),
        );
        line(&mut text, format_args!("pose{axes}{origin}"));
        joint(&mut text, tree, &body.joint);
    }
    for frame in &tree.frames {
        let body = frame.body.map_or(0, |body| body.index() + 1);
        let (axes, position) = (rotation(&frame.rotation), frame.position);
        let (name, identifier) = (&frame.name, &frame.identifier);
        line(
            &mut text,
            format_args!("frame {name:?} as {identifier} of {body}{axes} {position:?}"),
        );
    }
    text
}

/// The canonical text of a frame that only marks a place, for those that depend on it; of any other frame the tree's says
/// everything.
pub fn canonical_frame(tree: &Tree, frame: NamedFrame) -> Option<String> {
    let NamedFrame::Marker(place) = frame else {
        return None;
    };
    let frame = &tree.markers[place];
    let body = frame.body.map_or(0, |body| body.index() + 1);
    let (axes, origin) = (
        rotation(&frame.pose.rotation),
        offset(tree, &frame.pose.origin),
    );
    let turn = frame.turn.as_ref().map(|turn| values(tree, &turn.concat()));
    let (name, identifier) = (&frame.name, &frame.identifier);
    let turn = turn.unwrap_or_default();
    let mut text = String::new();
    line(
        &mut text,
        format_args!("marker {name:?} as {identifier} of {body}{axes}{origin} turned{turn}"),
    );
    Some(text)
}

fn joint(text: &mut String, tree: &Tree, joint: &Joint) {
    let own = if joint.is_named { "own" } else { "body's" };
    let attachment = offset(tree, &joint.attachment);
    line(
        text,
        format_args!(
            "joint {:?} {own} as {}{}{attachment}",
            joint.name,
            joint.identifier,
            rotation(&joint.rotation)
        ),
    );
    let mut coordinates: Vec<String> = Vec::new();
    if let Some(speeds) = joint.angular_velocity() {
        let speeds = speeds.map(|speed| format!(" u{}", speed.index()));
        coordinates.push(format!(" angular velocity{}", speeds.concat()));
        let places = joint.coordinates();
        let turning = places.iter().filter(|(kind, _)| !kind.is_translation());
        coordinates
            .extend(turning.map(|(kind, place)| format!(" {} q{}", kind.name(), place.index())));
    }
    coordinates.extend((0..6).filter_map(|motion| Some(coordinate(joint.coordinate_of(motion)?))));
    line(text, format_args!("coordinates{}", coordinates.concat()));
    for (motion, mechanics) in joint.mechanics.iter().enumerate() {
        if *mechanics == Mechanics::default() {
            continue;
        }
        let Mechanics {
            stiffness,
            rest,
            damping,
            armature,
            friction,
            range,
            velocity,
            effort,
        } = *mechanics;
        let values = values(tree, &[stiffness, rest, damping, armature]);
        line(
            text,
            format_args!(
                "mechanics {motion}{values} {friction:?} {range:?} {velocity:?} {effort:?}"
            ),
        );
    }
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

/// A rotation, where it is one.
fn rotation(rotation: &Rotation) -> String {
    if *rotation == IDENTITY {
        String::new()
    } else {
        format!(" turned {rotation:?}")
    }
}

fn offset(tree: &Tree, offset: &Offset) -> String {
    let step = |step: &Step| {
        let sign = if step.negative { " back" } else { "" };
        format!(
            "{}{sign}{}",
            rotation(&step.rotation),
            values(tree, &step.vector)
        )
    };
    offset.steps().iter().map(step).collect()
}

fn coordinate(coordinate: Coordinate) -> String {
    match coordinate {
        Coordinate::Free { coordinate, speed } => {
            format!(" q{} u{}", coordinate.index(), speed.index())
        }
        Coordinate::Mimic {
            coordinate,
            speed,
            multiplier,
            offset,
        } => {
            let (q, u) = (coordinate.index(), speed.index());
            format!(" mimic q{q} u{u} {multiplier:?} {offset:?}")
        }
        Coordinate::Locked(value) => format!(" {value:?}"),
    }
}
