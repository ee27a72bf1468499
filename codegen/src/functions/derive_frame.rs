//! The root expressions of each function of a frame.

use super::subject::{Axes, Subject};
use crate::{
    expr::{Expr, ExprGraph},
    kane::{
        self,
        frame::{Pose, Twist},
    },
    recursive,
    tree::Tree,
};

fn of_pose(Pose { rotation, position }: Pose) -> Vec<Expr> {
    let mut entries = rotation.concat();
    entries.extend(position);
    entries
}

fn of_twist(Twist { linear, angular }: Twist) -> Vec<Expr> {
    [linear, angular].concat()
}

pub(super) fn pose(graph: &mut ExprGraph, tree: &Tree, subject: &Subject) -> Vec<Expr> {
    of_pose(kane::frame::pose(graph, tree, subject.frame))
}

pub(super) fn pose_recursive(graph: &mut ExprGraph, tree: &Tree, subject: &Subject) -> Vec<Expr> {
    of_pose(recursive::frame::pose(graph, tree, subject.frame))
}

pub(super) fn velocity(graph: &mut ExprGraph, tree: &Tree, subject: &Subject) -> Vec<Expr> {
    of_twist(match subject.axes {
        Axes::Inertial => kane::frame::velocity(graph, tree, subject.frame),
        Axes::Local => kane::frame::local_velocity(graph, tree, subject.frame),
    })
}

pub(super) fn velocity_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    subject: &Subject,
) -> Vec<Expr> {
    of_twist(match subject.axes {
        Axes::Inertial => recursive::frame::velocity(graph, tree, subject.frame),
        Axes::Local => recursive::frame::local_velocity(graph, tree, subject.frame),
    })
}
