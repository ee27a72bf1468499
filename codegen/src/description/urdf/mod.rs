//! URDF.
//!
//! Links are bodies; the root link hangs from the inertial frame by a joint of our own, fixed or free. The bodies
//! stand depth first from the root, those on one link in the order of their joints' names: the order of urdfdom and
//! of all that is built on it. A URDF has no gravity: it is that of the earth, against z.

mod joint;
mod link;
mod origin;
mod structure;

use std::collections::BTreeSet;

use crate::description::xml::{Document, Element, Known, Reader, root_name, shown};
use crate::description::{
    Base, Chart, Description, Given, JointKind, Optional, Reading, Scalar, WrittenBody,
    WrittenJoint, too_many,
};
use crate::diagnostic::{Diagnostic, Source, Span, Spanned};

/// Gravity, m/s², against z.
const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
/// The name of the joint by which the root link hangs from the inertial frame, as Pinocchio has it.
const ROOT_JOINT: &str = "root_joint";
/// Elements without influence on the dynamics, wherever they stand.
const IGNORED: [&str; 8] = [
    "visual",
    "collision",
    "material",
    "transmission",
    "gazebo",
    "safety_controller",
    "calibration",
    "sensor",
];

/// True for a file whose root element is `robot`.
pub fn is_urdf(source: &Source) -> bool {
    root_name(source.text()) == Some("robot")
}

/// Reads a description; what is wrong stands in [`Description::faults`].
pub fn parse(source: &Source, reading: &Reading) -> Description {
    let start = Span { start: 0, end: 0 };
    let mut description = Description {
        gravity: GRAVITY.map(|g| Some(Spanned::new(Scalar::Baked(g), start))),
        ..Description::none(source, Vec::new())
    };
    let mut reader = Reader::default();
    match Document::parse(source.text(), 0) {
        Ok(document) => read(&mut reader, document.root(), reading, &mut description),
        Err(fault) => reader.faults.push(fault),
    }
    description.faults = reader.faults.into_told();
    description
}

fn read(reader: &mut Reader, robot: Element<'_>, reading: &Reading, description: &mut Description) {
    if robot.name() != "robot" {
        let found = shown(robot.name());
        let fault = format!("the root element is `{found}`; expected `robot`");
        let fault = Diagnostic::error(fault).at(robot.span(), "expected `robot`");
        reader.faults.push(fault);
        return;
    }
    for (name, what) in [
        ("link", "the number of links is"),
        ("joint", "the number of joints is"),
    ] {
        if let Some(fault) = too_many(what, robot.children_named(name).count()) {
            reader.faults.push(fault.at(robot.span(), "too many"));
            return;
        }
    }
    let known = Known {
        attributes: &["name"],
        children: &["link", "joint"],
        ignored_attributes: &["version"],
        ignored_children: &IGNORED,
    };
    reader.unknown(robot, "the robot", &known);
    let name = reader.required(robot, "the robot", "name");
    description.name = name.map(|name| Spanned::new(name.value.to_owned(), name.span));
    description.gravity = GRAVITY.map(|g| Some(Spanned::new(Scalar::Baked(g), robot.span())));
    let note = "a URDF has no gravity: it is taken as (0, 0, -9.81) m/s²";
    let note = Diagnostic::note(note).at(robot.span(), "gravity along -z");
    reader.faults.push(note);

    let chart = reading.chart.unwrap_or(Chart::Quaternion);
    let mut links: Vec<link::Link<'_>> = Vec::new();
    let mut joints: Vec<joint::JointElement<'_>> = Vec::new();
    for element in robot.children() {
        match element.name() {
            "link" => links.push(link::read(reader, element, links.len() + 1)),
            "joint" => joints.push(joint::read(reader, element, joints.len() + 1, chart)),
            _ => {}
        }
    }
    structure::unique_names(reader, &mut links, &mut joints);
    if links.is_empty() {
        let fault = Diagnostic::error("the robot has no link");
        let fault = fault.at(robot.span(), "expected at least one `link`");
        reader.faults.push(fault);
    }
    let hung = structure::hang(reader, &links, &joints);
    let root = Root {
        name: root_joint_name(&joints),
        base: reading.base.unwrap_or(Base::Fixed),
        chart,
    };
    assemble(description, &hung, links, joints, &root);
}

/// The joint by which the root link hangs from the inertial frame.
struct Root {
    name: String,
    base: Base,
    chart: Chart,
}

impl Root {
    fn joint(&self, span: Span) -> WrittenJoint {
        let (kind, chart): (_, Optional<Chart>) = match self.base {
            Base::Fixed => (JointKind::Fixed, None),
            Base::Free => (JointKind::Free, Some(Spanned::new(self.chart, span))),
        };
        WrittenJoint {
            kind: Some(Spanned::new(kind, span)),
            name: Some(Spanned::new(self.name.clone(), span)),
            attachment: [Some(Spanned::new(Scalar::Baked(0.0), span)); 3],
            chart,
            ..WrittenJoint::unknown()
        }
    }
}

/// `root_joint`, or with the first number that no joint of the file has.
fn root_joint_name(joints: &[joint::JointElement<'_>]) -> String {
    let names = joints.iter().filter_map(|joint| joint.name);
    let taken: BTreeSet<&str> = names.map(|name| name.value).collect();
    let numbered = (2_usize..).map(|number| format!("{ROOT_JOINT}_{number}"));
    std::iter::once(ROOT_JOINT.to_owned())
        .chain(numbered)
        .find(|name| !taken.contains(name.as_str()))
        .unwrap_or_default()
}

/// Bodies in order, or in that of the file where the links do not form a tree.
fn assemble(
    description: &mut Description,
    hung: &structure::Hung,
    links: Vec<link::Link<'_>>,
    joints: Vec<joint::JointElement<'_>>,
    root: &Root,
) {
    let mut parents: Vec<Option<Span>> = Vec::with_capacity(links.len());
    let mut joints: Vec<Option<joint::JointElement<'_>>> = joints.into_iter().map(Some).collect();
    let bodies = links.into_iter().zip(&hung.joint_of).map(|(link, joint)| {
        let joint = joint.and_then(|joint| joints[joint].take());
        parents.push(joint.as_ref().and_then(|j| Some(j.parent?.span)));
        let joint = joint.map_or_else(|| root.joint(link.span()), |joint| joint.joint);
        WrittenBody { joint, ..link.body }
    });
    let mut bodies: Vec<Option<WrittenBody>> = bodies.map(Some).collect();
    let Some(order) = &hung.order else {
        description.bodies = bodies.into_iter().flatten().collect();
        return;
    };
    let mut lower_bodies: Vec<Given<i64>> = Vec::with_capacity(order.len());
    for place in order {
        let Some(body) = bodies[place.link].take() else {
            continue;
        };
        let span = parents[place.link].unwrap_or(body.span);
        // Fewer links than bytes of a file.
        let lower = i64::try_from(place.lower).unwrap_or(i64::MAX);
        lower_bodies.push(Some(Spanned::new(lower, span)));
        description.bodies.push(body);
    }
    let span = description.bodies.first().map(|body| body.span);
    description.lower_bodies = span.map(|span| Spanned::new(lower_bodies, span));
}

/// An element's name where it has one, and the words for the element in messages: "link `hub`", or "link 3" without.
fn named<'d>(
    reader: &mut Reader,
    element: Element<'d>,
    what: &str,
    number: usize,
) -> (Given<&'d str>, String) {
    let name = element.attribute("name");
    if let Some(name) = name.filter(|name| !name.value.is_empty()) {
        return (Some(name), format!("{what} `{}`", shown(name.value)));
    }
    let words = format!("{what} {number}");
    if let Some(name) = reader.required(element, &words, "name") {
        let fault = Diagnostic::error(format!("the name of {words} is empty"));
        reader.faults.push(fault.at(name.span, "expected a name"));
    }
    (None, words)
}
