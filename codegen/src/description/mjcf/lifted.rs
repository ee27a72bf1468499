//! `gravcomp`: forces against the weights of bodies.

use crate::description::mjcf::chain::Bodies;
use crate::description::mjcf::left_out::{advice, left_out};
use crate::description::mjcf::model::Model;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::settings::Switch;
use crate::description::xml::Reader;
use crate::description::{LeftOut, Optional, Scalar};
use crate::diagnostic::{Diagnostic, Span, Spanned};

/// The share of a body's weight that is lifted; `None` where nothing is. What the main model says of forces holds for all.
pub(super) fn of_body(
    reader: &mut Reader,
    main: &Model<'_>,
    body: &Attributes<'_>,
) -> Optional<Scalar> {
    let share = body.number(reader, "gravcomp")?;
    let settings = &main.settings;
    // Without springs and dampers MuJoCo computes no passive forces at all.
    let has_passive = settings.springs == Switch::On || settings.dampers == Switch::On;
    if share.value == 0.0 || !has_passive {
        return None;
    }
    if main.reading.leaves_out(LeftOut::Gravcomp) {
        let message = format!("`gravcomp` of {} is left out", body.owner);
        let kind = ("bodies whose `gravcomp` is left out", &*body.owner);
        left_out(reader, message, share.span, kind);
        return None;
    }
    Some(Spanned::new(Scalar::Baked(share.value), share.span))
}

/// Settles what all bodies together decide. As in MuJoCo nothing is lifted where no share is positive; else none may be left to
/// actuators, as joints in these places say.
pub(super) fn settle(reader: &mut Reader, bodies: &mut Bodies, by_actuators: &[Span]) {
    if !bodies.lifts_upward() {
        bodies.lift_nothing();
        return;
    }
    for span in by_actuators {
        let message =
            "`actuatorgravcomp` leaves it to an actuator to lift weights, which is not supported";
        let fault = Diagnostic::error(message).at(*span, "expected `false`");
        let help = advice(LeftOut::Gravcomp.name());
        reader.faults.push(fault.help(help));
    }
}
