//! `gravcomp`: forces against the weights of bodies.
//!
//! Where each body that moves has the same share of its weight lifted, all forces are those of a smaller gravity.

use crate::description::LeftOut;
use crate::description::mjcf::leaving::{advice, left_out};
use crate::description::mjcf::model::Model;
use crate::description::mjcf::settings::Switch;
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Span};

/// How much of its weight is lifted off a body.
#[derive(Clone, Debug)]
pub(super) struct Lifted {
    /// The words for the body.
    pub(super) owner: String,
    /// One for all of it.
    pub(super) share: f64,
    pub(super) span: Span,
    /// True for a body that moves and has mass.
    pub(super) matters: bool,
}

/// The part of gravity that remains for all bodies.
pub(super) fn remaining(reader: &mut Reader, model: &Model<'_>, bodies: &[Lifted]) -> f64 {
    let settings = &model.settings;
    // MuJoCo then computes no passive forces at all; and nothing is lifted where nothing weighs.
    let has_passive = settings.springs == Switch::On || settings.dampers == Switch::On;
    if !has_passive || settings.gravity.iter().all(|entry| entry.value == 0.0) {
        return 1.0;
    }
    let lifted = || bodies.iter().filter(|body| body.share != 0.0);
    if model.reading.leaves_out(LeftOut::Gravcomp) {
        for body in lifted() {
            let message = format!("`gravcomp` of {} is left out", body.owner);
            let kind = ("bodies whose `gravcomp` is left out", &*body.owner);
            left_out(reader, message, body.span, kind);
        }
        return 1.0;
    }
    let mut moved = bodies.iter().filter(|body| body.matters);
    let Some(first) = moved.next() else {
        return 1.0;
    };
    if moved.all(|body| body.share == first.share) {
        if first.share != 0.0 {
            reader.faults.push(smaller(first));
        }
        return 1.0 - first.share;
    }
    let at_rest = bodies.iter().find(|body| body.matters && body.share == 0.0);
    for body in lifted().filter(|body| body.matters) {
        let message = format!(
            "`gravcomp` of {} is {}; a force against the weight of some bodies only is not supported",
            body.owner, body.share
        );
        let mut fault = Diagnostic::error(message).at(body.span, "expected the same of all bodies");
        if let Some(other) = at_rest {
            fault = fault.at(other.span, "no `gravcomp`");
        }
        let help = advice(LeftOut::Gravcomp.name());
        reader.faults.push(fault.help(help));
    }
    1.0
}

fn smaller(body: &Lifted) -> Diagnostic {
    let message = format!(
        "all bodies that move have `gravcomp` {share}: all functions take {rest} times the gravity, `imu` and energies among them",
        share = body.share,
        rest = 1.0 - body.share,
    );
    Diagnostic::warning(message).at(body.span, "forces are as in MuJoCo")
}
