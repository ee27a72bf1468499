//! A whole file: links and joints, and the bodies that they become.

use std::path::Path;

use crate::description::urdf::joint::{self, JointElement};
use crate::description::urdf::left_out;
use crate::description::urdf::link::{self, LinkElement};
use crate::description::urdf::named::{IGNORED, Names};
use crate::description::urdf::structure;
use crate::description::urdf::unexpanded::unexpanded;
use crate::description::xml::{Document, Element, Known, Mended, Reader, root_name};
use crate::description::{
    Base, Chart, Description, Given, JointKind, Optional, Reading, Scalar, WrittenBody,
    WrittenJoint, too_many,
};
use crate::diagnostic::{Diagnostic, Source, Span, Spanned, shown};

/// Gravity, m/s², against z.
const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
/// The name of the joint by which the root link hangs from the inertial frame, as Pinocchio has it.
const ROOT_JOINT: &str = "root_joint";

/// True for a file whose root element is `robot`.
pub fn is_urdf(source: &Source) -> bool {
    root_name(Mended::of(source.text(), 0).text()) == Some("robot")
}

/// Reads a description; what is wrong stands in [`Description::faults`].
pub fn parse(source: &Source, reading: &Reading) -> Description {
    let mut reader = Reader::default();
    let mut mended = Mended::of(source.text(), 0);
    for warning in mended.warnings.drain(..) {
        reader.faults.push(warning);
    }
    let description = match Document::parse(&mended, 0) {
        Ok(document) => read(&mut reader, document.root(), source, reading),
        Err(fault) => {
            reader.faults.push(fault);
            None
        }
    };
    let nothing = || Description {
        gravity: gravity(Span { start: 0, end: 0 }),
        ..Description::none(source, Vec::new())
    };
    Description {
        faults: reader.faults.into_told(),
        ..description.unwrap_or_else(nothing)
    }
}

fn gravity(span: Span) -> [Given<Scalar>; 3] {
    GRAVITY.map(|g| Some(Spanned::new(Scalar::Baked(g), span)))
}

/// The description in an element, but for the faults; `None` where it is no robot.
fn read(
    reader: &mut Reader,
    robot: Element<'_>,
    source: &Source,
    reading: &Reading,
) -> Option<Description> {
    if robot.name() != "robot" {
        let found = shown(robot.name());
        let fault = format!("the root element is `{found}`; expected `robot`");
        let mut fault = Diagnostic::error(fault).at(robot.span(), "expected `robot`");
        if robot.name() == "mujoco" {
            fault = fault.help("this is an MJCF; end the file's name in `.xml`");
        }
        reader.faults.push(fault);
        return None;
    }
    for (name, what) in [
        ("link", "the number of links is"),
        ("joint", "the number of joints is"),
    ] {
        if let Some(fault) = too_many(what, robot.children_named(name).count()) {
            reader.faults.push(fault.at(robot.span(), "too many"));
            return None;
        }
    }
    if let Some(fault) = unexpanded(robot, source) {
        reader.faults.push(fault);
        return None;
    }
    let known = Known {
        attributes: &["name"],
        children: &["link", "joint"],
        ignored_attributes: &["version"],
        ignored_children: &IGNORED,
    };
    reader.unknown(robot, "the robot", &known);
    let name = reader.required(robot, "the robot", "name");
    let note = "a URDF has no gravity: it is taken as (0, 0, -9.81) m/s^2";
    let note = Diagnostic::note(note).at(robot.span(), "gravity along -z");
    reader.faults.push(note);
    left_out::warn(reader, robot);
    let bodies = bodies(reader, robot, reading);
    Some(Description {
        name: name.map(|name| named(reader, name, source)),
        gravity: gravity(robot.span()),
        lower_bodies: bodies.lower,
        bodies: bodies.list,
        ..Description::none(source, Vec::new())
    })
}

/// The robot's name; that of its file where it is empty.
fn named(reader: &mut Reader, name: Spanned<&str>, source: &Source) -> Spanned<String> {
    let own = if name.value.is_empty() {
        let stem = Path::new(source.name()).file_stem();
        let stem = stem.map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        let warning = format!(
            "the name of the robot is empty: it is called `{}`, as its file",
            shown(&stem)
        );
        let warning = Diagnostic::warning(warning).at(name.span, "expected a name");
        let kind = "robots without a name, called as their files";
        reader.faults.push(warning.one_of(kind, &stem));
        stem
    } else {
        name.value.to_owned()
    };
    Spanned::new(own, name.span)
}

/// The bodies of a robot.
struct WrittenBodies {
    list: Vec<WrittenBody>,
    lower: Given<Vec<Given<i64>>>,
}

fn bodies(reader: &mut Reader, robot: Element<'_>, reading: &Reading) -> WrittenBodies {
    let chart = reading.chart.unwrap_or(Chart::Quaternion);
    let (mut link_names, mut joint_names) = (Names::of("link"), Names::of("joint"));
    let mut links: Vec<LinkElement<'_>> = Vec::new();
    let mut joints: Vec<JointElement<'_>> = Vec::new();
    for element in robot.children() {
        match element.name() {
            "link" => {
                let named = link_names.next(reader, element);
                links.push(link::read(reader, element, named));
            }
            "joint" => {
                let named = joint_names.next(reader, element);
                joints.push(joint::read(reader, element, named, chart));
            }
            _ => {}
        }
    }
    if links.is_empty() {
        let fault = Diagnostic::error("the robot has no link");
        let fault = fault.at(robot.span(), "expected at least one `link`");
        reader.faults.push(fault);
    }
    let hung = structure::hang(reader, &links, &joints);
    let n_roots = hung.joint_of.iter().filter(|joint| joint.is_none()).count();
    let root = Root {
        names: root_joint_names(&joint_names, n_roots),
        base: reading.base.unwrap_or(Base::Fixed),
        chart,
    };
    assemble(&hung, &links, &joints, &root)
}

/// The joint by which a root link hangs from the inertial frame.
struct Root {
    /// As many as there are links that hang by none: more than one only where the links form no tree.
    names: Vec<String>,
    base: Base,
    chart: Chart,
}

impl Root {
    /// Of the root link of this number.
    fn joint(&self, number: usize, span: Span) -> WrittenJoint {
        let (kind, chart): (_, Optional<Chart>) = match self.base {
            Base::Fixed => (JointKind::Fixed, None),
            Base::Free => (JointKind::Free, Some(Spanned::new(self.chart, span))),
        };
        let kind = Some(Spanned::new(kind, span));
        WrittenJoint {
            name: self
                .names
                .get(number)
                .map(|name| Spanned::new(name.clone(), span)),
            chart,
            ..WrittenJoint::new(kind, [Some(Spanned::new(Scalar::Baked(0.0), span)); 3])
        }
    }
}

/// `root_joint`, and with the first numbers, but for names that joints of the file have.
fn root_joint_names(names: &Names<'_>, count: usize) -> Vec<String> {
    let numbered = (2_usize..).map(|number| format!("{ROOT_JOINT}_{number}"));
    std::iter::once(ROOT_JOINT.to_owned())
        .chain(numbered)
        .filter(|name| !names.has(name))
        .take(count)
        .collect()
}

/// Bodies in order, or in that of the file where the links do not form a tree.
fn assemble(
    hung: &structure::Hung,
    links: &[LinkElement<'_>],
    joints: &[JointElement<'_>],
    root: &Root,
) -> WrittenBodies {
    let joint_of = |link: usize| hung.joint_of[link].map(|joint| &joints[joint]);
    let mut n_roots = 0;
    let mut body = |link: usize| {
        let joint = joint_of(link).map(|joint| joint.joint.clone());
        let joint = joint.unwrap_or_else(|| {
            n_roots += 1;
            root.joint(n_roots - 1, links[link].span())
        });
        links[link].body(joint)
    };
    let Some(order) = &hung.order else {
        return WrittenBodies {
            list: (0..links.len()).map(body).collect(),
            lower: None,
        };
    };
    let list: Vec<WrittenBody> = order.iter().map(|hung| body(hung.link)).collect();
    let numbers = order.iter().zip(&list).map(|(hung, body)| {
        let parent = joint_of(hung.link).and_then(|joint| joint.parent);
        let span = parent.map_or(body.span, |parent| parent.span);
        // Fewer links than bytes of a file.
        let lower = i64::try_from(hung.lower).unwrap_or(i64::MAX);
        Some(Spanned::new(lower, span))
    });
    let numbers = numbers.collect();
    let lower = list.first().map(|body| Spanned::new(numbers, body.span));
    WrittenBodies { list, lower }
}
