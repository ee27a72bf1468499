//! `link`: a body's name and inertia.

use crate::description::urdf::{IGNORED, named, origin};
use crate::description::xml::{Element, Known, Reader};
use crate::description::{Given, INERTIA_COMPONENTS, Scalar, WrittenBody, WrittenJoint};
use crate::diagnostic::{Diagnostic, Span, Spanned};

/// A link, with a joint of which nothing is known yet.
pub(super) struct Link<'d> {
    /// The name.
    pub(super) name: Given<&'d str>,
    /// All but the joint.
    pub(super) body: WrittenBody,
}

impl Link<'_> {
    /// The place of the name, or of the whole link.
    pub(super) fn span(&self) -> Span {
        self.name.map_or(self.body.span, |name| name.span)
    }
}

/// Reads a `link`, the `number`-th of the file.
pub(super) fn read<'d>(reader: &mut Reader, element: Element<'d>, number: usize) -> Link<'d> {
    let (name, owner) = named(reader, element, "link", number);
    let known = Known {
        attributes: &["name"],
        children: &["inertial"],
        ignored_children: &IGNORED,
        ..Known::NONE
    };
    reader.unknown(element, &owner, &known);
    let zero = Some(Spanned::new(Scalar::Baked(0.0), element.span()));
    let mut body = WrittenBody {
        span: element.span(),
        name: name.map(|name| Spanned::new(name.value.to_owned(), name.span)),
        mass: zero,
        mass_center: [zero; 3],
        inertia: [zero; 6],
        inertia_rotation: None,
        joint: WrittenJoint::unknown(),
    };
    if let Some(inertial) = reader.child(element, &owner, "inertial") {
        read_inertial(reader, inertial, &owner, &mut body);
    }
    Link { name, body }
}

fn read_inertial(reader: &mut Reader, inertial: Element<'_>, link: &str, body: &mut WrittenBody) {
    let owner = format!("`inertial` of {link}");
    let known = Known {
        children: &["origin", "mass", "inertia"],
        ..Known::NONE
    };
    reader.unknown(inertial, &owner, &known);
    let origin = origin::read(reader, inertial, &owner);
    body.mass_center = origin.position;
    body.inertia_rotation = origin.rotation;
    body.mass = reader
        .required_child(inertial, &owner, "mass")
        .and_then(|mass| read_mass(reader, mass, link));
    body.inertia = reader
        .required_child(inertial, &owner, "inertia")
        .map_or([None; 6], |inertia| read_inertia(reader, inertia, link));
}

fn read_mass(reader: &mut Reader, mass: Element<'_>, link: &str) -> Given<Scalar> {
    let owner = format!("`mass` of {link}");
    let known = Known {
        attributes: &["value"],
        ..Known::NONE
    };
    reader.unknown(mass, &owner, &known);
    let value = reader.required(mass, &owner, "value")?;
    let mass = reader.number(value, &format!("`value` of {owner}"))?;
    Some(Spanned::new(Scalar::Baked(mass.value), mass.span))
}

fn read_inertia(reader: &mut Reader, inertia: Element<'_>, link: &str) -> [Given<Scalar>; 6] {
    let owner = format!("`inertia` of {link}");
    let names = INERTIA_COMPONENTS.map(|component| format!("i{component}"));
    let known = Known {
        attributes: &names.each_ref().map(String::as_str),
        ..Known::NONE
    };
    reader.unknown(inertia, &owner, &known);
    let missing: Vec<String> = names
        .iter()
        .filter(|name| inertia.attribute(name).is_none())
        .map(|name| format!("`{name}`"))
        .collect();
    if !missing.is_empty() {
        let missing = missing.join(", ");
        let fault = Diagnostic::error(format!("{owner} has no {missing}"));
        reader
            .faults
            .push(fault.at(inertia.span(), format!("{missing} missing")));
    }
    names.map(|name| {
        let number = reader.optional_number(inertia, &owner, &name)?;
        Some(Spanned::new(Scalar::Baked(number.value), number.span))
    })
}
