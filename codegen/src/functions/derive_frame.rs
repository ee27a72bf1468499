//! The root expressions of each function of a frame.

use super::subject::{Axes, Subject};
use crate::{
    expr::{Expr, ExprGraph},
    given::{FramePose, FrameVelocity},
    kane,
    recursive::{self, Plan},
    tree::Tree,
};

fn of_pose(FramePose { rotation, position }: FramePose) -> Vec<Expr> {
    let mut entries = rotation.concat();
    entries.extend(position);
    entries
}

fn of_velocity(FrameVelocity { linear, angular }: FrameVelocity) -> Vec<Expr> {
    [linear, angular].concat()
}

pub(super) fn pose(graph: &mut ExprGraph, tree: &Tree, subject: &Subject) -> Vec<Expr> {
    of_pose(kane::frame::pose(graph, tree, subject.frame))
}

pub(super) fn pose_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> Vec<Expr> {
    of_pose(recursive::frame::pose(graph, tree, plan, subject.frame))
}

pub(super) fn velocity(graph: &mut ExprGraph, tree: &Tree, subject: &Subject) -> Vec<Expr> {
    of_velocity(match subject.axes {
        Axes::Inertial => kane::frame::velocity(graph, tree, subject.frame),
        Axes::Local => kane::frame::local_velocity(graph, tree, subject.frame),
    })
}

pub(super) fn velocity_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> Vec<Expr> {
    of_velocity(match subject.axes {
        Axes::Inertial => recursive::frame::velocity(graph, tree, plan, subject.frame),
        Axes::Local => recursive::frame::local_velocity(graph, tree, plan, subject.frame),
    })
}
