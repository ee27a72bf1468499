//! Springs and rotors that a URDF has only for Gazebo, Drake and drives: they change the dynamics, and no joint of ours gets them.

use crate::description::xml::{Element, Reader};
use crate::diagnostic::{Diagnostic, shown};

/// The elements of the robot, and those in joints, that hold such elements.
const AROUND: [&str; 2] = ["gazebo", "transmission"];

/// What has an effect, what of ours it would be, and what many of them are called.
const LEFT_OUT: [(&str, &str, &str); 4] = [
    ("springStiffness", SPRING, "springs of Gazebo are left out"),
    ("rotorInertia", ARMATURE, ROTORS),
    ("motorInertia", ARMATURE, ROTORS),
    ("drake:rotor_inertia", ARMATURE, ROTORS),
];

const SPRING: &str = "`stiffness` and `rest` (`springReference`)";
const ARMATURE: &str = "`armature`, the rotor's inertia times the square of the gear ratio";
const ROTORS: &str = "inertias of rotors are left out";

/// Warns of each that is not zero.
pub(super) fn warn(reader: &mut Reader, robot: Element<'_>) {
    let joints = robot.children_named("joint");
    let around = std::iter::once(robot).chain(joints);
    let around = around.flat_map(Element::children);
    for element in around.filter(|element| AROUND.contains(&element.name())) {
        let mut open = vec![element];
        while let Some(next) = open.pop() {
            open.extend(next.children());
            one(reader, element, next);
        }
    }
}

fn one(reader: &mut Reader, around: Element<'_>, element: Element<'_>) {
    let known = LEFT_OUT.iter().find(|(name, ..)| *name == element.name());
    let Some((name, ours, plural)) = known else {
        return;
    };
    let value = element.attribute("value").map(|value| value.value);
    let value = value.or(element.content()).unwrap_or_default();
    // What is no number has no effect elsewhere either.
    let number: f64 = value.trim_ascii().parse().unwrap_or(0.0);
    if number == 0.0 {
        return;
    }
    let mut names = ["reference", "name"].into_iter();
    let of = names.find_map(|name| around.attribute(name));
    let owner = match of {
        Some(of) => format!("{} `{}`", around.name(), shown(of.value)),
        None => format!("a {}", around.name()),
    };
    let message = format!("`{name}` of {owner} is left out: a URDF has no such value");
    let warning = Diagnostic::warning(message)
        .at(element.span(), "ignored")
        .one_of(*plural, of.map_or(around.name(), |of| of.value))
        .help(format!(
            "`kane convert` writes the model in the format of kane, where a joint may have {ours}"
        ));
    reader.faults.push(warning);
}
