//! Where a joint sits and how it moves: its coordinates, speeds and accelerations, and the way that they make.

use std::collections::BTreeSet;

use super::numbers::{constant, constant_back, fixed};
use crate::{
    expr::{Expr, ExprGraph, Input, Matrix, Vector},
    id::SpeedId,
    tree::{Body, Coordinate, Joint, Motion},
};

/// The accelerations with which a right-hand side is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accelerations<'a> {
    /// `u_dot` as an argument.
    Given,
    /// The same of these speeds, zero of the others.
    GivenOf(&'a BTreeSet<SpeedId>),
    /// These, by speeds.
    Values(&'a [Expr]),
    /// Zero: what is left is the bias.
    Zero,
}

/// A relative coordinate: an entry of `q`, the value at which it is locked, or that of another which it follows.
pub fn coordinate(graph: &mut ExprGraph, coordinate: Coordinate) -> Expr {
    match coordinate {
        Coordinate::Free { coordinate, .. } => graph.input(Input::Q(coordinate)),
        Coordinate::Locked(at) => graph.number(at),
        Coordinate::Mimic {
            coordinate,
            multiplier,
            offset,
            ..
        } => {
            let other = graph.input(Input::Q(coordinate));
            let (multiplier, offset) = (graph.number(multiplier), graph.number(offset));
            let scaled = graph.mul(multiplier, other);
            graph.add(scaled, offset)
        }
    }
}

/// The speed of a relative motion: an entry of `u`, or a multiple of one that it follows; zero where held.
pub fn speed(graph: &mut ExprGraph, motion: Option<Motion>) -> Expr {
    of_motion(graph, motion, |graph, speed| graph.input(Input::U(speed)))
}

/// The derivative of the speed of a relative motion.
pub fn acceleration(
    graph: &mut ExprGraph,
    motion: Option<Motion>,
    accelerations: Accelerations<'_>,
) -> Expr {
    let given = match accelerations {
        Accelerations::Values(values) => {
            return of_motion(graph, motion, |_, speed| values[speed.index()]);
        }
        Accelerations::Given => motion,
        Accelerations::GivenOf(speeds) => motion.filter(|own| speeds.contains(&own.speed)),
        Accelerations::Zero => None,
    };
    of_motion(graph, given, |graph, speed| graph.input(Input::UDot(speed)))
}

fn of_motion(
    graph: &mut ExprGraph,
    motion: Option<Motion>,
    value: impl Fn(&mut ExprGraph, SpeedId) -> Expr,
) -> Expr {
    let Some(Motion { speed, factor }) = motion else {
        return graph.zero();
    };
    let (speed, factor) = (value(graph, speed), graph.number(factor));
    graph.mul(factor, speed)
}

/// The speeds of the three translations, along the joint's axes.
pub fn shift_speeds(graph: &mut ExprGraph, joint: &Joint) -> Vector {
    joint.shifts().map(|shift| speed(graph, shift))
}

/// The directions of the three translations, lower-body components: `A_K` by rows.
pub fn shift_directions(graph: &mut ExprGraph, joint: &Joint) -> Matrix {
    constant(graph, &joint.rotation)
}

/// `q_K`: from the lower body's origin to where the joint sits, lower-body components.
pub fn attachment(graph: &mut ExprGraph, joint: &Joint) -> Vector {
    fixed(graph, &joint.attachment)
}

/// `q_K + s_K`: from the lower body's origin to the body's, lower-body components.
pub fn offset(graph: &mut ExprGraph, body: &Body) -> Vector {
    let attachment = attachment(graph, &body.joint);
    let translation = body.joint.translations.map(|s| coordinate(graph, s));
    let translation = constant_back(graph, &body.joint.rotation, translation);
    let offset = graph.add_vectors(attachment, translation);
    graph.name_vector(offset, "offset");
    offset
}
