//! Sections beside the bodies: what of them would change the dynamics is refused, the rest is left out.

use crate::description::LeftOut;
use crate::description::mjcf::known;
use crate::description::mjcf::left_out::{self, advice};
use crate::description::mjcf::model::Model;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::defaults::{Class, ElementKind};
use crate::description::xml::{Element, Reader};
use crate::diagnostic::{Diagnostic, Spanned, shown};

/// Looks through the sections of a root that make no bodies.
pub(super) fn read(reader: &mut Reader, model: &Model<'_>) {
    for section in &model.sections {
        let children = model.files.children(*section);
        match section.name() {
            "actuator" => actuators(reader, model, *section, &children),
            "tendon" => tendons(reader, model, *section, &children),
            "contact" => contacts(reader, *section, &children),
            "deformable" => deformables(reader, &children),
            _ => {}
        }
    }
}

/// The words for an element.
fn owner(element: Element<'_>, kind: &str) -> String {
    match element.attribute("name") {
        Some(name) => format!("{kind} `{}`", shown(name.value)),
        None => format!("a {kind}"),
    }
}

/// A section that is left out as a whole.
fn left_out(reader: &mut Reader, section: Element<'_>, message: &str) {
    let warning = Diagnostic::warning(message).at(section.span(), "left out");
    let warning = warning.one_of("sections are left out", format!("`{}`", section.name()));
    reader.faults.push(warning);
}

/// Refuses an element of which one of these coefficients is not zero.
fn refuse_coefficients(reader: &mut Reader, given: &Attributes<'_>, names: &[&str]) {
    for (name, bad) in coefficients(reader, given, names) {
        let fault = Diagnostic::error(not_supported(given, name, bad));
        let fault = fault.at(bad.span, "expected 0");
        reader.faults.push(fault.help(format!(
            "write `{name}` at the joint on which it acts, in the joint's units"
        )));
    }
}

/// Those of these coefficients that are not zero.
fn coefficients<'n>(
    reader: &mut Reader,
    given: &Attributes<'_>,
    names: &[&'n str],
) -> Vec<(&'n str, Spanned<f64>)> {
    let mut found = Vec::new();
    for name in names {
        let coefficients = given.up_to(reader, name, 3).unwrap_or_default();
        let bad = coefficients.into_iter().find(|c| c.value != 0.0);
        found.extend(bad.map(|bad| (*name, bad)));
    }
    found
}

fn not_supported(given: &Attributes<'_>, name: &str, bad: Spanned<f64>) -> String {
    format!(
        "{} has `{}` {}, which acts on the joints and is not supported",
        given.owner, name, bad.value
    )
}

fn actuators<'d>(
    reader: &mut Reader,
    model: &Model<'d>,
    section: Element<'d>,
    children: &[Element<'d>],
) {
    for element in children {
        reader.unknown_child(*element, "`actuator`", &known::ACTUATORS);
        if known::ACTUATORS.contains(&element.name()) {
            let owner = owner(*element, element.name());
            let given = model.defaults.attributes(
                reader,
                *element,
                &owner,
                ElementKind::Actuator,
                Class::MAIN,
            );
            refuse_coefficients(reader, &given, &["damping", "armature"]);
        }
    }
    if !children.is_empty() {
        // Nothing is lost: what they do is given in their place.
        let message = "actuators are left out: forces of the joints are arguments of the functions";
        let note = Diagnostic::note(message).at(section.span(), "left out");
        reader.faults.push(note);
    }
}

fn tendons<'d>(
    reader: &mut Reader,
    model: &Model<'d>,
    section: Element<'d>,
    children: &[Element<'d>],
) {
    for element in children {
        reader.unknown_child(*element, "`tendon`", &["spatial", "fixed"]);
        if matches!(element.name(), "spatial" | "fixed") {
            let owner = owner(*element, &format!("{} tendon", element.name()));
            let given = model.defaults.attributes(
                reader,
                *element,
                &owner,
                ElementKind::Tendon,
                Class::MAIN,
            );
            let names = ["stiffness", "damping", "armature", "frictionloss"];
            for (name, bad) in coefficients(reader, &given, &names) {
                if model.reading.leaves_out(LeftOut::Tendons) {
                    let message = format!("`{name}` of {} is left out", given.owner);
                    let kind = ("forces of tendons that are left out", &*given.owner);
                    left_out::left_out(reader, message, bad.span, kind);
                } else {
                    let fault = Diagnostic::error(not_supported(&given, name, bad));
                    let fault = fault.at(bad.span, "expected 0");
                    reader
                        .faults
                        .push(fault.help(advice(LeftOut::Tendons.name())));
                }
            }
        }
    }
    if !children.is_empty() {
        left_out(reader, section, "tendons are left out, with their limits");
    }
}

fn contacts(reader: &mut Reader, section: Element<'_>, children: &[Element<'_>]) {
    for element in children {
        reader.unknown_child(*element, "`contact`", &["pair", "exclude"]);
    }
    if children.iter().any(|child| child.name() == "pair") {
        left_out(reader, section, "contact pairs are left out");
    }
}

/// A skin only shows how bodies move.
fn deformables(reader: &mut Reader, children: &[Element<'_>]) {
    for element in children {
        reader.unknown_child(*element, "`deformable`", &["flex", "skin"]);
        if element.name() == "flex" {
            let message = format!(
                "{} is not supported: bodies are rigid",
                owner(*element, "flex")
            );
            let fault = Diagnostic::error(message).at(element.span(), "not supported");
            reader.faults.push(fault);
        }
    }
}
