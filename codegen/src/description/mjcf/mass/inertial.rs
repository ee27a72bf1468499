//! Mass properties of a body: from `inertial`, or from its geoms, as the settings change them.

use crate::description::mjcf::mass::solid::{Solid, Tensor, is_positive, turned};
use crate::description::mjcf::model::attributes::{Attributes, ORIENTATION};
use crate::description::mjcf::model::settings::{Settings, Switch};
use crate::description::mjcf::orientation::rotation;
use crate::description::mjcf::placement::Placement;
use crate::description::xml::Reader;
use crate::description::{Given, Optional, Rotation, Scalar};
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::geometry::{IDENTITY, Vector, then};
use crate::principal::principal;

/// Mass, mass centre and inertia, with their places.
#[derive(Clone, Copy, Debug)]
pub(in crate::description::mjcf) struct MassProperties {
    mass: Spanned<f64>,
    center: [Spanned<f64>; 3],
    inertia: [Spanned<f64>; 6],
    /// From the body's axes to those of the inertia.
    rotation: Spanned<Rotation>,
}

/// Mass, mass centre and inertia as a description has them.
#[derive(Debug, Default)]
pub(in crate::description::mjcf) struct WrittenMass {
    pub(in crate::description::mjcf) mass: Given<Scalar>,
    pub(in crate::description::mjcf) center: [Given<Scalar>; 3],
    pub(in crate::description::mjcf) inertia: [Given<Scalar>; 6],
    pub(in crate::description::mjcf) rotation: Optional<Rotation>,
}

impl MassProperties {
    /// Those of a body without mass.
    pub(in crate::description::mjcf) fn massless(span: Span) -> Self {
        let zero = Spanned::new(0.0, span);
        Self {
            mass: zero,
            center: [zero; 3],
            inertia: [zero; 6],
            rotation: Spanned::new(IDENTITY, span),
        }
    }

    /// Those that `boundmass` raises of a body without any: MuJoCo takes where the body stands in what it is written in for its mass
    /// centre and axes.
    pub(in crate::description::mjcf) fn bounded(
        reader: &mut Reader,
        settings: &Settings,
        owner: &str,
        place: &Placement,
        span: Span,
    ) -> Self {
        let none = Self::massless(span);
        let Some(least) = settings.least_mass else {
            return none;
        };
        let message = format!(
            "`boundmass` of `compiler` gives {owner} a mass; as in MuJoCo its mass centre is at the body's own `pos`, measured from the body's origin"
        );
        let warning =
            Diagnostic::warning(message).at(span, "no `inertial`, and no geom with a mass");
        let warning = warning.at(least.span, "least mass");
        reader
            .faults
            .push(warning.one_of("bodies to which `boundmass` gives a mass", owner));
        Self {
            center: place.position.map(|entry| Spanned::new(entry, span)),
            rotation: Spanned::new(place.rotation, span),
            ..none
        }
    }

    /// Those of geoms together.
    pub(in crate::description::mjcf) fn of(solid: &Solid, span: Span) -> Self {
        let at = |value: f64| Spanned::new(value + 0.0, span);
        Self {
            mass: at(solid.mass),
            center: solid.center.map(at),
            inertia: solid.inertia.map(at),
            rotation: Spanned::new(IDENTITY, span),
        }
    }

    /// In the form of a description.
    pub(in crate::description::mjcf) fn written(&self) -> WrittenMass {
        WrittenMass {
            mass: Some(baked(self.mass)),
            center: self.center.map(|entry| Some(baked(entry))),
            inertia: self.inertia.map(|entry| Some(baked(entry))),
            rotation: (self.rotation.value != IDENTITY).then_some(self.rotation),
        }
    }

    /// In the body's axes.
    pub(in crate::description::mjcf) fn solid(&self) -> Solid {
        Solid {
            mass: self.mass.value,
            center: self.center.map(|entry| entry.value),
            inertia: turned(self.tensor(), &self.rotation.value),
        }
    }

    /// The mass, kg.
    pub(in crate::description::mjcf) fn mass(&self) -> f64 {
        self.mass.value
    }

    /// The same shape with another density.
    #[must_use]
    pub(in crate::description::mjcf) fn scaled(mut self, factor: f64) -> Self {
        self.mass.value *= factor;
        for entry in &mut self.inertia {
            entry.value *= factor;
        }
        self
    }

    /// Raises the mass and the moments, and evens out the moments, where the settings ask for it.
    pub(in crate::description::mjcf) fn adjust(&mut self, settings: &Settings) {
        self.mass.value = self
            .mass
            .value
            .max(settings.least_mass.map_or(0.0, |least| least.value));
        if let Some(least) = settings.least_inertia {
            self.raise(least.value);
        }
        let tensor = self.tensor();
        let half = (tensor[0] + tensor[1] + tensor[2]) / 2.0;
        // A moment is at most the sum of the two others: no more than half the trace.
        let rest = shifted(tensor.map(|entry| -entry), half);
        if settings.balance == Switch::On && !is_positive(rest) {
            for (entry, value) in self.inertia.iter_mut().zip([half / 1.5; 3]) {
                entry.value = value;
            }
            for entry in &mut self.inertia[3..] {
                entry.value = 0.0;
            }
        }
    }

    fn raise(&mut self, least: f64) {
        let tensor = self.tensor();
        if tensor[3..] != [0.0; 3] && !is_positive(shifted(tensor, -least)) {
            let (moments, axes) = principal(tensor);
            let moments = [moments[0], moments[1], moments[2], 0.0, 0.0, 0.0];
            for (entry, moment) in self.inertia.iter_mut().zip(moments) {
                entry.value = moment;
            }
            self.rotation.value = then(&self.rotation.value, &axes);
        }
        if self.tensor()[3..] == [0.0; 3] {
            for entry in &mut self.inertia[..3] {
                entry.value = entry.value.max(least);
            }
        }
    }

    fn tensor(&self) -> Tensor {
        self.inertia.map(|entry| entry.value)
    }
}

fn shifted([xx, yy, zz, xy, xz, yz]: Tensor, by: f64) -> Tensor {
    [xx + by, yy + by, zz + by, xy, xz, yz]
}

/// A number as it stands in a description.
pub(in crate::description::mjcf) fn baked(number: Spanned<f64>) -> Spanned<Scalar> {
    Spanned::new(Scalar::Baked(number.value), number.span)
}

/// Reads `inertial`; `None` where it is faulty. One that may lack the inertia has none then.
pub(in crate::description::mjcf) fn read(
    reader: &mut Reader,
    inertial: &Attributes<'_>,
    settings: &Settings,
    around: &Placement,
    may_lack: bool,
) -> Option<MassProperties> {
    for name in ["pos", "mass"] {
        if !inertial.has(name) {
            let fault = Diagnostic::error(format!("{} has no attribute `{name}`", inertial.owner));
            let fault = fault.at(inertial.span, format!("`{name}` is missing"));
            reader.faults.push(fault);
        }
    }
    let mass = inertial.number(reader, "mass");
    let center = inertial.numbers(reader, "pos");
    let axes = rotation(reader, inertial, settings);
    let inertia = moments(reader, inertial, may_lack)?;
    let center: [Spanned<f64>; 3] = center?;
    let moved: Vector = around.point(center.map(|entry| entry.value));
    let span = ORIENTATION.into_iter().find(|name| inertial.has(name));
    let span = span.map_or(inertial.span, |name| inertial.place(name));
    Some(MassProperties {
        mass: mass?,
        center: [0, 1, 2].map(|i| Spanned::new(moved[i], center[i].span)),
        inertia,
        rotation: Spanned::new(then(&around.rotation, &axes), span),
    })
}

fn moments(
    reader: &mut Reader,
    inertial: &Attributes<'_>,
    may_lack: bool,
) -> Option<[Spanned<f64>; 6]> {
    let owner = &inertial.owner;
    if inertial.has("fullinertia") {
        let mut beside = std::iter::once("diaginertia").chain(ORIENTATION);
        if let Some(name) = beside.find(|name| inertial.has(name)) {
            let message = format!("{owner} has `{name}` beside `fullinertia`");
            let fault = Diagnostic::error(message)
                .at(inertial.place(name), "expected one of the two")
                .at(inertial.place("fullinertia"), "the full inertia");
            reader.faults.push(fault);
        }
        return inertial.numbers(reader, "fullinertia");
    }
    if !inertial.has("diaginertia") && may_lack {
        return Some([Spanned::new(0.0, inertial.span); 6]);
    }
    if !inertial.has("diaginertia") {
        let message = format!("{owner} has neither `diaginertia` nor `fullinertia`");
        let fault = Diagnostic::error(message).at(inertial.span, "the inertia is missing");
        reader.faults.push(fault);
    }
    let [x, y, z] = inertial.numbers(reader, "diaginertia")?;
    let zero = Spanned::new(0.0, inertial.place("diaginertia"));
    Some([x, y, z, zero, zero, zero])
}
