//! The tree as text.

use std::ops::Range;

use crate::{
    geometry::{IDENTITY, apply},
    id::BodyId,
    tree::{Body, Coordinate, Joint, Tree},
};

/// A line for the inertial frame and for each body, with its number, joint and, where it differs, the user's number.
///
/// ```text
/// 0 inertial frame
/// `-- 1 hub: theta1 theta2 theta3 s1 s2 s3
///     |-- 2 shoulder (3 in the model): theta1; theta3 = 0.5
///     `-- 3 panel (2 in the model): s2
/// ```
/// Where that is wider than `width` columns, a body that alone is carried by another one stands right below it:
///
/// ```text
/// 0 inertial frame
/// 1 hub: theta1 theta2 theta3 s1 s2 s3
/// |-- 2 shoulder (3 in the model): theta1; theta3 = 0.5
/// `-- 3 panel (2 in the model): s2
/// ```
pub fn picture(tree: &Tree, width: usize) -> String {
    let picture = lines(tree, false);
    if picture.lines().all(|line| line.chars().count() <= width) {
        picture
    } else {
        lines(tree, true)
    }
}

/// The picture; where it is narrow, only what branches goes further in.
fn lines(tree: &Tree, is_narrow: bool) -> String {
    let coordinates = tree.coordinate_names();
    let mut text = String::from("0 inertial frame\n");
    let mut bodies_on = vec![Vec::new(); tree.bodies.len() + 1];
    for body in tree.body_ids() {
        bodies_on[number(tree.lower(body))].push(body);
    }
    // A stack, not a recursion: a chain may be as long as its description.
    let mut open: Vec<(BodyId, String)> = Vec::new();
    let mut indent = String::new();
    let mut lower = None;
    loop {
        let bodies: &[BodyId] = &bodies_on[number(lower)];
        open.extend(bodies.iter().rev().map(|&body| (body, indent.clone())));
        let Some((body, own_indent)) = open.pop() else {
            return text;
        };
        let beside = &bodies_on[number(tree.lower(body))];
        let (branch, below) = if is_narrow && beside.len() == 1 {
            ("", "")
        } else if beside.last() == Some(&body) {
            ("`-- ", "    ")
        } else {
            ("|-- ", "|   ")
        };
        let line = line(tree, body, &coordinates);
        text.extend([&own_indent, branch, &line, "\n"]);
        indent = own_indent + below;
        lower = Some(body);
    }
}

/// The only motion of a joint among these, along an axis that its body keeps.
fn single(joint: &Joint, mut motions: Range<usize>) -> Option<usize> {
    let moves = |motion: &usize| match joint.coordinate_of(*motion) {
        Some(Coordinate::Locked(value)) => value != 0.0,
        Some(_) => true,
        None => false,
    };
    let is_turned = joint.angular_velocity().is_some();
    let single = motions.find(moves).filter(|_| !is_turned);
    single.filter(|_| !motions.any(|motion| moves(&motion)))
}

/// About or along what a body moves, in its own axes.
fn direction(body: &Body, motion: usize) -> String {
    let mut axis = [0.0; 3];
    axis[motion % 3] = 1.0;
    let axis = apply(&body.pose.rotation, axis);
    let [x, y, z] = axis.map(|entry| (entry * 1000.0).round() / 1000.0 + 0.0);
    let word = if motion < 3 { "about" } else { "along" };
    format!("{word} ({x}, {y}, {z})")
}

/// The body's number in the body-connection array, from 1; 0 is the inertial frame.
fn number(body: Option<BodyId>) -> usize {
    body.map_or(0, |body| body.index() + 1)
}

fn line(tree: &Tree, id: BodyId, coordinates: &[String]) -> String {
    let (body, number) = (tree.body(id), number(Some(id)));
    // Where bodies are part of others, all numbers beyond them differ, which is no news as long as they stand in the same order.
    let is_in_order = tree.bodies.is_sorted_by_key(|body| body.user_number);
    let renumbered = if body.user_number == number || is_in_order {
        String::new()
    } else {
        format!(" ({} in the model)", body.user_number)
    };
    let joint = &body.joint;
    let names = joint.motion_names();
    let mut free: Vec<String> = Vec::new();
    let mut locked = Vec::new();
    if joint.angular_velocity().is_some() {
        let own = joint.coordinates().into_iter().map(|(kind, _)| kind);
        let turning = own.filter(|kind| !kind.is_translation());
        free.extend(turning.map(|kind| kind.name().to_owned()));
    }
    let (single, turning) = (single(joint, 0..6), single(joint, 0..3));
    for (motion, name) in names.into_iter().enumerate() {
        let is_single = single == Some(motion);
        let is_turned = body.pose.rotation != IDENTITY;
        let has_axis = (is_single || turning == Some(motion)) && is_turned;
        let axis = if is_single && joint.is_named {
            // A coordinate is called as its joint: what it is called within would say nothing.
            direction(body, motion)
        } else if has_axis {
            format!("{name} {}", direction(body, motion))
        } else {
            name.to_owned()
        };
        match joint.coordinate_of(motion) {
            Some(Coordinate::Free { .. }) => free.push(axis),
            Some(Coordinate::Mimic {
                coordinate,
                multiplier,
                offset,
                ..
            }) => {
                let other = &coordinates[coordinate.index()];
                let plus = if offset == 0.0 {
                    String::new()
                } else {
                    let sign = if offset < 0.0 { '-' } else { '+' };
                    format!(" {sign} {:?}", offset.abs())
                };
                let is = if is_single { ", as" } else { " =" };
                free.push(format!("{axis}{is} {multiplier:?} {other}{plus}"));
            }
            Some(Coordinate::Locked(value)) if value != 0.0 => {
                locked.push(format!("; {axis} = {value:?}"));
            }
            Some(Coordinate::Locked(_)) | None => {}
        }
    }
    let named = if joint.is_named {
        format!(" by {}", joint.name)
    } else {
        String::new()
    };
    let (name, free, locked) = (&body.name, free.join(" "), locked.concat());
    format!("{number} {name}{renumbered}{named}: {free}{locked}")
}
