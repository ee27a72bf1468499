//! A description in our own format.
//!
//! In: a description, however it was read. Out: text that [`parse`](super::parse) reads as that description. What is
//! absent or has its default is left out, but for what must be written. Does not: check what the values mean.

use std::fmt::Write as _;

use crate::description::toml::text::{
    EMPTY, binding, by_coordinate, joint_kind, limits, list, matrix, mimic_table, name, number,
    scalar, string, table, vector,
};
use crate::description::{
    Carrier, Chart, Description, FrameRotation, Given, INERTIA_COMPONENTS, Order, PerCoordinate,
    Scalar, Speeds, WrittenBody, WrittenFrame, WrittenJoint,
};
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::geometry::IDENTITY;

/// Writes a description, the same one always as the same text.
///
/// ```
/// use kane_codegen::description::toml;
/// use kane_codegen::diagnostic::Source;
///
/// let text = "\
/// name = \"pendulum\"
/// gravity = [0.0, 0.0, -9.81]
/// lower_bodies = [0]
///
/// [[body]]
/// name = \"bob\"
/// mass = { runtime = 2.0 }
/// mass_center = [0.0, 0.0, -0.5]
/// inertia = { xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0 }
/// attachment = [0.0, 0.0, 0.0]
/// joint = \"revolute\"
/// axis = [1.0, 0.0, 0.0]
/// damping = 0.1
/// ";
/// let description = toml::parse(&Source::new("pendulum.toml", text));
/// assert_eq!(toml::write(&description).unwrap(), text);
/// ```
///
/// # Errors
/// What was wrong already while reading the description, and what it lacks.
pub fn write(description: &Description) -> Result<String, Diagnostics> {
    let is_error = |fault: &Diagnostic| fault.severity == Severity::Error;
    let mut faults = description.faults.clone();
    if !faults.iter().any(is_error) {
        let mut writer = Writer::default();
        writer.system(description);
        if writer.faults.is_empty() {
            return Ok(writer.text);
        }
        faults.extend(writer.faults);
    }
    Err(Diagnostics::new(description.source.clone(), faults))
}

#[derive(Default)]
struct Writer {
    text: String,
    /// Whose keys are being written: " of body 3"; empty for the system's.
    owner: String,
    faults: Vec<Diagnostic>,
}

impl Writer {
    /// A key and its value; a value that there is not cannot be written.
    fn line(&mut self, key: &str, value: Option<String>) {
        match value {
            Some(value) => writeln!(self.text, "{key} = {value}").expect("a string takes any text"),
            None => self.faults.push(Diagnostic::error(format!(
                "`{key}`{} is missing or not finite, so the description cannot be written",
                self.owner
            ))),
        }
    }

    fn system(&mut self, description: &Description) {
        self.line("name", description.name.as_ref().map(string));
        self.line("gravity", vector(&description.gravity));
        let lower_bodies = description.lower_bodies.as_ref();
        let lower_bodies = lower_bodies.and_then(|numbers| {
            list(
                numbers
                    .value
                    .iter()
                    .map(|number| Some(number.as_ref()?.value.to_string())),
            )
        });
        self.line("lower_bodies", lower_bodies);
        match description.order {
            Some(order) if order.value == Order::Body => {}
            order => self.line(
                "order",
                order.and_then(|order| name(&order.value, &Order::NAMED)),
            ),
        }
        for (body, number) in description.bodies.iter().zip(1..) {
            self.owner = format!(" of body {number}");
            self.text.push_str("\n[[body]]\n");
            self.body(body);
        }
        for (frame, number) in description.frames.iter().zip(1..) {
            self.owner = format!(" of frame {number}");
            self.text.push_str("\n[[frame]]\n");
            self.frame(frame);
        }
    }

    fn frame(&mut self, frame: &WrittenFrame) {
        self.line("name", frame.name.as_ref().map(string));
        if let Carrier::Body(body) = &frame.body {
            self.line("body", body.as_ref().map(string));
        }
        let zero = |component: &Given<Scalar>| {
            component.is_some_and(|component| component.value == Scalar::Baked(0.0))
        };
        if !frame.position.iter().all(zero) {
            self.line("position", vector(&frame.position));
        }
        match frame.rotation.map(|rotation| rotation.value) {
            Some(FrameRotation::Baked(IDENTITY)) => {}
            Some(FrameRotation::Baked(rotation)) => self.line("rotation", matrix(&rotation)),
            Some(FrameRotation::Runtime(rows)) => {
                let rows = list(rows.map(|row| list(row.map(number))));
                self.line("rotation", table([("runtime", rows)]));
            }
            None => self.line("rotation", None),
        }
    }

    fn body(&mut self, body: &WrittenBody) {
        self.line("name", body.name.as_ref().map(string));
        self.line("mass", scalar(body.mass));
        self.line("mass_center", vector(&body.mass_center));
        let components = body.inertia.into_iter().map(scalar);
        self.line(
            "inertia",
            table(INERTIA_COMPONENTS.into_iter().zip(components)),
        );
        if let Some(rotation) = &body.inertia_rotation {
            self.line("inertia_rotation", matrix(&rotation.value));
        }
        if body.gravity_compensation.is_some() {
            self.line("gravity_compensation", scalar(body.gravity_compensation));
        }
        self.joint(&body.joint);
    }

    fn joint(&mut self, joint: &WrittenJoint) {
        self.line("attachment", vector(&joint.attachment));
        if let Some(rotation) = &joint.attachment_rotation {
            self.line("attachment_rotation", matrix(&rotation.value));
        }
        if let Some(attachment) = &joint.body_attachment {
            self.line("body_attachment", vector(attachment));
        }
        if let Some(rotation) = &joint.body_rotation {
            self.line("body_rotation", matrix(&rotation.value));
        }
        self.line(
            "joint",
            joint.kind.as_ref().and_then(|kind| joint_kind(&kind.value)),
        );
        if let Some(name) = &joint.name {
            self.line("joint_name", Some(string(name)));
        }
        if let Some(axis) = &joint.axis {
            self.line("axis", list(axis.value.map(number)));
        }
        if !joint.locked.is_empty() {
            let locked = joint.locked.iter();
            let locked = locked.map(|(coordinate, value)| {
                Some((coordinate.value, number(value.as_ref()?.value)?))
            });
            self.line("locked", by_coordinate(locked));
        }
        if let Some(chart) = joint.chart {
            self.line("chart", name(&chart.value, &Chart::NAMED));
        }
        if let Some(speeds) = joint.speeds {
            self.line("speeds", name(&speeds.value, &Speeds::NAMED));
        }
        self.per_coordinate("stiffness", &joint.stiffness, binding);
        self.per_coordinate("rest", &joint.rest, binding);
        self.per_coordinate("damping", &joint.damping, binding);
        self.per_coordinate("armature", &joint.armature, binding);
        self.per_coordinate("friction", &joint.friction, |value| number(*value));
        self.per_coordinate("limits", &joint.limits, limits);
        if let Some(mimic) = &joint.mimic {
            self.line("mimic", mimic_table(&mimic.value));
        }
    }

    fn per_coordinate<T>(
        &mut self,
        key: &str,
        quantity: &PerCoordinate<T>,
        one: impl Fn(&T) -> Option<String>,
    ) {
        let value = match quantity {
            PerCoordinate::Absent => return,
            PerCoordinate::Same(value) => one(&value.value),
            PerCoordinate::Each(values) => {
                let values = values.iter();
                by_coordinate(
                    values.map(|(coordinate, value)| Some((coordinate.value, one(&value.value)?))),
                )
            }
        };
        // A table that holds nothing says nothing.
        if value.as_deref() != Some(EMPTY) {
            self.line(key, value);
        }
    }
}
