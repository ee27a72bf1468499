//! `link`: a body's name and inertia.

use crate::description::urdf::named::{IGNORED, Named};
use crate::description::urdf::origin;
use crate::description::xml::{Element, Known, Reader};
use crate::description::{
    Given, INERTIA_COMPONENTS, Optional, Rotation, Scalar, WrittenBody, WrittenJoint,
};
use crate::diagnostic::{Diagnostic, Span, Spanned};

/// A link: a body but for its joint.
pub(super) struct LinkElement<'d> {
    /// The name.
    pub(super) name: Given<&'d str>,
    /// Where it is written.
    element: Span,
    inertial: Inertial,
}

/// What a link weighs.
struct Inertial {
    mass: Given<Scalar>,
    mass_center: [Given<Scalar>; 3],
    inertia: [Given<Scalar>; 6],
    rotation: Optional<Rotation>,
}

impl LinkElement<'_> {
    /// The place of the name, or of the whole link.
    pub(super) fn span(&self) -> Span {
        self.name.map_or(self.element, |name| name.span)
    }

    /// The body that hangs by this joint.
    pub(super) fn body(&self, joint: WrittenJoint) -> WrittenBody {
        let inertial = &self.inertial;
        WrittenBody {
            span: self.element,
            name: self
                .name
                .map(|name| Spanned::new(name.value.to_owned(), name.span)),
            mass: inertial.mass,
            mass_center: inertial.mass_center,
            inertia: inertial.inertia,
            inertia_rotation: inertial.rotation,
            gravity_compensation: None,
            joint,
        }
    }
}

/// Reads a `link`.
pub(super) fn read<'d>(
    reader: &mut Reader,
    element: Element<'d>,
    Named { name, words }: Named<'d>,
) -> LinkElement<'d> {
    let known = Known {
        attributes: &["name"],
        children: &["inertial"],
        ignored_children: &IGNORED,
        ..Known::NONE
    };
    reader.unknown(element, &words, &known);
    let inertial = reader.child(element, &words, "inertial");
    LinkElement {
        name,
        element: element.span(),
        inertial: match inertial {
            Some(inertial) => read_inertial(reader, inertial, &words, name),
            None => massless(element.span()),
        },
    }
}

fn massless(span: Span) -> Inertial {
    let zero = Some(Spanned::new(Scalar::Baked(0.0), span));
    Inertial {
        mass: zero,
        mass_center: [zero; 3],
        inertia: [zero; 6],
        rotation: None,
    }
}

fn read_inertial(
    reader: &mut Reader,
    inertial: Element<'_>,
    link: &str,
    name: Given<&str>,
) -> Inertial {
    let owner = format!("`inertial` of {link}");
    let known = Known {
        children: &["origin", "mass", "inertia"],
        ..Known::NONE
    };
    reader.unknown(inertial, &owner, &known);
    let origin = origin::read(reader, inertial, &owner);
    let Some(mass) = reader.child(inertial, &owner, "mass") else {
        return without_mass(reader, inertial, &owner, name);
    };
    let mass = read_mass(reader, mass, link);
    let inertia = reader
        .required_child(inertial, &owner, "inertia")
        .map_or([None; 6], |inertia| read_inertia(reader, inertia, link));
    Inertial {
        mass,
        mass_center: origin.position,
        inertia,
        rotation: origin.rotation,
    }
}

/// An `inertial` without `mass` counts for nothing, its inertia included, as with urdfdom and all that stands on it.
fn without_mass(
    reader: &mut Reader,
    inertial: Element<'_>,
    owner: &str,
    name: Given<&str>,
) -> Inertial {
    let fault = format!("{owner} has no `mass`: mass and inertia count as zero");
    let fault = Diagnostic::warning(fault)
        .at(inertial.span(), "`mass` is missing")
        .one_of(
            "`inertial` without `mass`, whose inertia counts as zero too",
            name.map_or("", |name| name.value),
        );
    reader.faults.push(fault);
    massless(inertial.span())
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
