//! Vectors that a function is given for a body, from the user's axes to internal ones.

use super::numbers::constant_back;
use crate::{
    expr::{ExprGraph, Input, Vector},
    id::BodyId,
    tree::Tree,
};

/// The loads with which forces are evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loads {
    /// `loads` as an argument.
    Given,
    /// None.
    Absent,
}

/// A load's force at the mass centre, internal axes.
pub fn force(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Vector {
    let force = [0, 1, 2].map(|i| graph.input(Input::Force(body, i)));
    constant_back(graph, &tree.body(body).pose.rotation, force)
}

/// A load's moment, internal axes.
pub fn moment(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Vector {
    let moment = [0, 1, 2].map(|i| graph.input(Input::Moment(body, i)));
    constant_back(graph, &tree.body(body).pose.rotation, moment)
}

/// A relative angular velocity that the function is given, internal axes.
pub fn relative_angular_velocity(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Vector {
    let w = [0, 1, 2].map(|i| graph.input(Input::RelativeAngularVelocity(body, i)));
    constant_back(graph, &tree.body(body).pose.rotation, w)
}
