//! The values of every body, and of every frame, in the order in which parameters are listed.

use crate::description::{Description, WrittenBody};
use crate::diagnostic::{Diagnostic, Span};
use crate::id::BodyId;
use crate::limits::PARAMETERS;
use crate::tree::body::Inertia;
use crate::tree::joints::ResolvedJoint;
use crate::tree::mechanics::Mechanics;
use crate::tree::negligible::Negligible;
use crate::tree::value::{Parameter, Value};
use crate::tree::values::frames::{FrameValues, KnownFrame, of_frame};
use crate::tree::values::mechanics;
use crate::tree::values::parameters::Parameters;

/// The values of a system.
pub(crate) struct Values {
    /// Inertial components, m/s².
    pub(crate) gravity: [Value; 3],
    /// Of the written bodies, in the order in which they were given.
    pub(crate) bodies: Vec<BodyValues>,
    /// Of the written frames, in the order in which they were given.
    pub(crate) frames: Vec<FrameValues>,
    /// Those that are set at run time.
    pub(crate) parameters: Vec<Parameter>,
}

/// The values of a written body, in its own axes.
pub(crate) struct BodyValues {
    /// kg.
    pub(crate) mass: Value,
    /// m.
    pub(crate) mass_center: [Value; 3],
    /// About the mass centre.
    pub(crate) inertia: Inertia,
    /// Share of the weight.
    pub(crate) lifted: Value,
    /// From the lower body's origin to where the joint sits, lower-body components, m.
    pub(crate) attachment: [Value; 3],
    /// From the body's origin to where the joint sits in it, m, if not in its origin.
    pub(crate) body_attachment: Option<[Value; 3]>,
    /// Of the joint's six motions.
    pub(crate) mechanics: [Mechanics; 6],
}

/// A written body and what is known of it already.
pub(crate) struct HostedBody<'a> {
    pub(crate) written: &'a WrittenBody,
    pub(crate) joint: &'a ResolvedJoint,
    pub(crate) identifier: &'a str,
    /// The body of the tree in which it is; `None` is the inertial frame.
    pub(crate) host: Option<BodyId>,
}

/// The values of all bodies; `None` where one is missing, or where there are too many parameters.
pub(crate) fn values<'a>(
    description: &Description,
    bodies: impl Iterator<Item = HostedBody<'a>>,
    frames: impl Iterator<Item = KnownFrame<'a>>,
    findings: &mut Vec<Diagnostic>,
) -> Option<Values> {
    let mut parameters = Parameters::default();
    let gravity = parameters.vector(&description.gravity, "gravity", None, "m/s^2")?;
    let mut of_bodies = Vec::with_capacity(description.bodies.len());
    let negligible = Negligible::of(description);
    for body in bodies {
        of_bodies.push(of_body(&mut parameters, &body, negligible)?);
        check_count(&parameters, body.written.span, findings)?;
    }
    let mut of_frames = Vec::with_capacity(description.frames.len());
    for frame in frames {
        of_frames.push(of_frame(&mut parameters, &frame)?);
        check_count(&parameters, frame.written.span, findings)?;
    }
    Some(Values {
        gravity,
        bodies: of_bodies,
        frames: of_frames,
        parameters: parameters.list,
    })
}

/// Whether the parameters that were met up to this place are few enough.
fn check_count(parameters: &Parameters, place: Span, findings: &mut Vec<Diagnostic>) -> Option<()> {
    let n_parameters = parameters.list.len();
    if n_parameters <= PARAMETERS {
        return Some(());
    }
    let fault = format!(
        "the model has at least {n_parameters} values that are set at run time; expected at most {PARAMETERS}"
    );
    findings.push(Diagnostic::error(fault).at(place, "too many"));
    None
}

fn of_body(
    parameters: &mut Parameters,
    body: &HostedBody<'_>,
    negligible: Negligible,
) -> Option<BodyValues> {
    let &HostedBody {
        written,
        joint,
        identifier,
        host,
    } = body;
    let name = |quantity: &str| format!("{identifier}_{quantity}");
    let at = &written.joint;
    let mass = parameters.value(negligible.mass(written.mass), name("mass"), host, "kg")?;
    let mass_center = parameters.vector(&written.mass_center, &name("mass_center"), host, "m")?;
    let inertia = negligible.inertia(written.inertia);
    let inertia = parameters.inertia(&inertia, &name("inertia"), host)?;
    let lifted = match written.gravity_compensation {
        Some(given) => {
            let name = name("gravity_compensation");
            parameters.value(Some(given), name, host, "1")?
        }
        None => Value::Baked(0.0),
    };
    let attachment = parameters.vector(&at.attachment, &name("attachment"), host, "m")?;
    let body_attachment = match &at.body_attachment {
        Some(given) => Some(parameters.vector(given, &name("body_attachment"), host, "m")?),
        None => None,
    };
    let moving = host.filter(|_| !joint.is_fixed());
    let mechanics = moving.map_or([Mechanics::default(); 6], |body| {
        mechanics::of(parameters, at, joint, body)
    });
    Some(BodyValues {
        mass,
        mass_center,
        inertia,
        lifted,
        attachment,
        body_attachment,
        mechanics,
    })
}
