//! What a joint's parts have to do with one another: free and locked coordinates, and charts.

use std::collections::BTreeMap;

use crate::description::{
    Chart, CoordinateName, Description, JointKind, Speeds, WrittenBody, mjcf, urdf,
};
use crate::diagnostic::{Diagnostic, Escaped, Span};
use crate::tree::changes::Changes;
use crate::tree::joints::mechanics_rules::mechanics;
use crate::tree::joints::resolved::{Freedom, ResolvedJoint};
use crate::tree::names::{shown, shown_by_joint};

/// |cos(theta2)| below which theta1 and theta3 turn about one axis.
const SINGULAR: f64 = 1e-9;
/// |cos(theta2)| below which they nearly do: such as theta2 = 1.5708, a rounded right angle.
const NEARLY_SINGULAR: f64 = 1e-4;

/// Reports joints that contradict themselves.
pub(crate) fn check(
    description: &Description,
    joints: &[Option<ResolvedJoint>],
    findings: &mut Vec<Diagnostic>,
) {
    names_twice(description, findings);
    for (index, (body, joint)) in description.bodies.iter().zip(joints).enumerate() {
        let Some(joint) = joint else { continue };
        let name = shown_by_joint(description, index);
        findings.extend(order(body, &name));
        locked(body, joint, &name, findings);
        orientation(body, joint, &name, findings);
        mechanics(body, joint, &name, findings);
    }
}

/// Reports motions that cannot be, once all that is held is held.
pub(crate) fn check_motions(
    description: &Description,
    joints: &[ResolvedJoint],
    changes: &Changes,
    findings: &mut Vec<Diagnostic>,
) {
    let bodies = &description.bodies;
    for (index, (body, joint)) in bodies.iter().zip(joints).enumerate() {
        let name = shown(description, index);
        findings.extend(singular(body, joint, &name));
    }
    // Whatever is wrong with the file may be why nothing moves.
    let is_readable = !description.faults.iter().any(Diagnostic::is_error);
    if is_readable && !bodies.is_empty() && joints.iter().all(ResolvedJoint::is_fixed) {
        let fault = Diagnostic::error("no body has a free coordinate, so nothing can move");
        let joints = bodies
            .iter()
            .take(3)
            .filter_map(|body| body.joint.kind.as_ref());
        let fault = joints.fold(fault, |fault, joint| {
            fault.at(joint.span, "no free coordinate")
        });
        let equality = mjcf::holding(description);
        let fault = fault.at_if(equality, "an equality holds its joint");
        let is_held = !(changes.lock.is_empty() && changes.remove.is_empty());
        // A TOML says itself how its first body hangs, and so does an MJCF.
        findings.push(if is_held {
            fault.help("`lock` and `remove` hold all that could move")
        } else if urdf::is_urdf(&description.source) {
            fault.help("with `--base free`, or `base = \"free\"` in `kane.toml`, the root link is free to move")
        } else {
            fault
        });
    }
}

/// Two joints with one name, their own or their bodies': which of them is meant elsewhere could not be told.
fn names_twice(description: &Description, findings: &mut Vec<Diagnostic>) {
    let mut first: BTreeMap<&str, (bool, Span)> = BTreeMap::new();
    for body in &description.bodies {
        let own = body.joint.name.as_ref();
        let Some(name) = body.joint_name() else {
            continue;
        };
        let Some((is_own, span)) = first.get(name.value.as_str()) else {
            first.insert(&name.value, (own.is_some(), name.span));
            continue;
        };
        // Two bodies of one name are told elsewhere.
        if own.is_some() || *is_own {
            let shown = name.value.escaped();
            let fault = Diagnostic::error(format!("two joints have the name `{shown}`"))
                .at(name.span, "the second one")
                .at(*span, "the first one");
            let are_both_own = own.is_some() && *is_own;
            findings.push(if are_both_own {
                fault
            } else {
                fault.help("a joint without a name of its own has its body's")
            });
        }
    }
}

/// Rotations that a list names in an order that is not theirs.
fn order(body: &WrittenBody, name: &str) -> Option<Diagnostic> {
    let JointKind::List(coordinates) = &body.joint.kind.as_ref()?.value else {
        return None;
    };
    let turns = coordinates.iter().filter(|one| one.value.is_angle());
    let mut pairs = turns.clone().zip(turns.skip(1));
    let (first, second) = pairs.find(|(one, next)| one.value > next.value)?;
    let message = format!(
        "`joint` of {name} lists `{}` before `{}`; the order means nothing: rotations are about x, then y, then z",
        first.value.name(),
        second.value.name()
    );
    let warning = Diagnostic::warning(message)
        .at(first.span, "listed first")
        .at(second.span, "turns first")
        .one_of("joints list rotations in an order that means nothing", name);
    Some(warning.help("for another order use a chain of bodies, all but the last one massless"))
}

fn locked(body: &WrittenBody, joint: &ResolvedJoint, name: &str, findings: &mut Vec<Diagnostic>) {
    let Some(kind) = &body.joint.kind else { return };
    for (locked, _) in &body.joint.locked {
        if kind.value.has_axis() {
            let fault = format!(
                "`locked` of {name} holds `{}`, but the joint is about or along an axis of its own",
                locked.value.name()
            );
            let help = "give the joint as a list of free coordinates, or turn its frames by constant rotations";
            findings.push(
                Diagnostic::error(fault)
                    .at(locked.span, "no coordinate of this joint")
                    .help(help),
            );
        } else if let Freedom::Free(free) = joint.motions[locked.value.index()] {
            let fault = format!(
                "`locked` of {name} holds `{}`, which the joint leaves free",
                locked.value.name()
            );
            findings.push(
                Diagnostic::error(fault)
                    .at(locked.span, "locked here")
                    .at(free, "free here"),
            );
        }
    }
}

/// A quaternion or an angular velocity where not all angles are free, or rates of a quaternion.
fn orientation(
    body: &WrittenBody,
    joint: &ResolvedJoint,
    name: &str,
    findings: &mut Vec<Diagnostic>,
) {
    let turns = joint.free().filter(|motion| *motion < 3).count();
    if turns < 3 {
        let chart = body
            .joint
            .chart
            .filter(|own| own.value == Chart::Quaternion);
        let chart = chart.map(|own| ("`chart`", own.span));
        let speeds = body.joint.speeds;
        let speeds = speeds.filter(|own| own.value == Speeds::AngularVelocity);
        let speeds = speeds.map(|own| ("`speeds`", own.span));
        for (what, span) in chart.into_iter().chain(speeds) {
            let fault = format!("{what} of {name} needs a joint whose three angles are free");
            let free = [
                "none of them is free",
                "one of them is free",
                "two of them are free",
            ];
            findings.push(Diagnostic::error(fault).at(span, free[turns]));
        }
    } else if let (Chart::Quaternion, Speeds::Rates, Some(speeds)) =
        (joint.chart, joint.speeds, body.joint.speeds)
    {
        let fault = format!("{name} has a quaternion, whose rates are no speeds");
        let fault = Diagnostic::error(fault).at(speeds.span, "expected `angular_velocity`");
        findings.push(fault.help("leave `speeds` out"));
    }
}

/// A `theta2` locked at a right angle between free `theta1` and `theta3`, an error; near one, a warning.
fn singular(body: &WrittenBody, joint: &ResolvedJoint, name: &str) -> Option<Diagnostic> {
    let (Freedom::Free(first), Freedom::Locked(value), Freedom::Free(third)) =
        (joint.motions[0], joint.motions[1], joint.motions[2])
    else {
        return None;
    };
    let cos = libm::cos(value).abs();
    let (fault, there) = if cos < SINGULAR {
        (
            Diagnostic::error(format!(
                "`theta2` of {name} is locked where cos(theta2) = 0, between free `theta1` and `theta3`"
            )),
            "there",
        )
    } else if cos < NEARLY_SINGULAR {
        (
            Diagnostic::warning(format!(
                "`theta2` of {name} is locked near cos(theta2) = 0, between free `theta1` and `theta3`"
            ))
            .one_of("joints are nearly singular: `theta2` is locked near cos(theta2) = 0", name),
            "nearly",
        )
    } else {
        return None;
    };
    let written = body
        .joint
        .locked
        .iter()
        .find(|(coordinate, _)| coordinate.value == CoordinateName::Theta2)
        .and_then(|(_, value)| value.as_ref());
    let label = format!("`theta1` and `theta3` turn about one axis {there}");
    let fault = fault.at_if(written.map(|written| written.span), label);
    let fault = fault.at(first, "free here").at(third, "free here");
    Some(
        fault.help(
            "leave out one of `theta1` and `theta3`: only their sum or difference would matter",
        ),
    )
}
