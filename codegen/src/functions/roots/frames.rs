//! The root expressions of each function of frames.

use super::dynamics;
use crate::{
    expr::{Expr, ExprGraph, Vector},
    functions::{
        formulation::Way,
        subject::{Subject, View},
    },
    given::{Accelerations, FrameMotion, FramePose, FrameWrench, frame_point, frame_wrench},
    id::SpeedId,
    kane::frame as notes,
    recursive::frame as recursive,
    tree::{NamedFrame, Tree},
};

/// What a unit value of each speed contributes to a frame's motion; of one speed there may be several.
type Columns = Vec<(SpeedId, FrameMotion)>;

pub(in crate::functions) fn pose(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    let frame = subject.frame();
    let FramePose { rotation, position } = match (way, subject.other()) {
        (Way::Recursive(plan), from) => recursive::pose(graph, tree, plan, frame, from),
        (Way::Notes, Some(from)) => notes::seen_pose(graph, tree, frame, from),
        (Way::Notes, None) => notes::pose(graph, tree, frame),
    };
    [rotation.concat(), position.to_vec()].concat()
}

pub(in crate::functions) fn velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    let frame = subject.frame();
    of_motion(match (way, subject.view) {
        (Way::Recursive(plan), View::Local) => recursive::local_velocity(graph, tree, plan, frame),
        (Way::Recursive(plan), _) => recursive::velocity(graph, tree, plan, frame),
        (Way::Notes, View::Local) => notes::local_velocity(graph, tree, frame),
        (Way::Notes, _) => notes::velocity(graph, tree, frame),
    })
}

pub(in crate::functions) fn acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    accelerated(graph, tree, way, subject, Accelerations::Given)
}

pub(in crate::functions) fn jacobian_dot_u(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    accelerated(graph, tree, way, subject, Accelerations::Zero)
}

pub(super) fn accelerated(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
    given: Accelerations<'static>,
) -> Vec<Expr> {
    let frame = subject.frame();
    of_motion(match (way, subject.view) {
        (Way::Recursive(plan), View::Local) => {
            recursive::local_acceleration(graph, tree, plan, frame, given)
        }
        (Way::Recursive(plan), _) => recursive::acceleration(graph, tree, plan, frame, given),
        (Way::Notes, View::Local) => notes::local_acceleration(graph, tree, frame, given),
        (Way::Notes, _) => notes::acceleration(graph, tree, frame, given),
    })
}

pub(in crate::functions) fn imu(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    of_motion(match way {
        Way::Recursive(plan) => recursive::imu(graph, tree, plan, subject.frame()),
        Way::Notes => notes::imu(graph, tree, subject.frame()),
    })
}

pub(in crate::functions) fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    let columns = columns(graph, tree, way, subject, (subject.frame(), None));
    whole(graph, tree, subject, columns)
}

pub(in crate::functions) fn jacobian_packed(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    let columns = columns(graph, tree, way, subject, (subject.frame(), None));
    let packed = packed(graph, &subject.speeds(tree), columns);
    by_rows(&packed)
}

pub(in crate::functions) fn point_jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    let point = Some(frame_point(graph));
    let columns = columns(graph, tree, way, subject, (subject.frame(), point));
    whole(graph, tree, subject, columns)
}

pub(in crate::functions) fn generalized_force(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    let wrench = frame_wrench(graph);
    of_wrench(graph, tree, way, subject, wrench)
}

pub(super) fn of_wrench(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
    wrench: FrameWrench,
) -> Vec<Expr> {
    let frame = subject.frame();
    match (way, subject.view) {
        (Way::Recursive(plan), View::Local) => {
            recursive::local_generalized_force(graph, tree, plan, frame, wrench)
        }
        (Way::Recursive(plan), _) => recursive::generalized_force(graph, tree, plan, frame, wrench),
        (Way::Notes, View::Local) => notes::local_generalized_force(graph, tree, frame, wrench),
        (Way::Notes, _) => notes::generalized_force(graph, tree, frame, wrench),
    }
}

pub(in crate::functions) fn operational_inverse_inertia(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    projected(graph, tree, way, subject, 6)
}

/// `J M^-1 J^T` of the first rows of each frame's Jacobian.
pub(super) fn projected(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
    rows_per_frame: usize,
) -> Vec<Expr> {
    let factors = dynamics::factors(graph, tree, way);
    let mut rows = Vec::with_capacity(rows_per_frame * subject.frames.len());
    for frame in &subject.frames {
        let columns = columns(graph, tree, way, subject, (frame.frame, None));
        let entries = whole(graph, tree, subject, columns);
        // No speed, no motion: rows of nothing.
        let row = |row: usize| entries[row * tree.n_speeds..][..tree.n_speeds].to_vec();
        rows.extend((0..rows_per_frame).map(row));
    }
    factors.projected(graph, rows).concat()
}

fn of_motion(FrameMotion { linear, angular }: FrameMotion) -> Vec<Expr> {
    [linear, angular].concat()
}

fn columns(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
    of: (NamedFrame, Option<Vector>),
) -> Columns {
    let (frame, point) = of;
    match (way, subject.view, subject.other()) {
        (Way::Recursive(plan), View::Local, _) => recursive::local_jacobian(graph, tree, plan, of),
        (Way::Recursive(plan), _, from) => recursive::jacobian(graph, tree, plan, of, from),
        (Way::Notes, View::Local, _) => notes::local_jacobian(graph, tree, frame, point),
        (Way::Notes, _, Some(from)) => notes::seen_jacobian(graph, tree, of, from),
        (Way::Notes, _, None) => notes::jacobian(graph, tree, frame, point),
    }
}

/// A column for each of these speeds, linear and angular.
fn packed(graph: &mut ExprGraph, speeds: &[SpeedId], columns: Columns) -> Vec<[Vector; 2]> {
    let mut sums = vec![[graph.zero_vector(); 2]; speeds.len()];
    for (speed, FrameMotion { linear, angular }) in columns {
        // What moves neither of two frames against the other has columns that cancel.
        let Ok(place) = speeds.binary_search(&speed) else {
            continue;
        };
        for (sum, part) in sums[place].iter_mut().zip([linear, angular]) {
            *sum = graph.add_vectors(*sum, part);
        }
    }
    sums
}

/// The entries of a column for every speed, by rows; those of speeds that move no frame are zero.
fn whole(graph: &mut ExprGraph, tree: &Tree, subject: &Subject, columns: Columns) -> Vec<Expr> {
    let speeds = subject.speeds(tree);
    let packed = packed(graph, &speeds, columns);
    let mut all = vec![[graph.zero_vector(); 2]; tree.n_speeds];
    for (speed, column) in speeds.into_iter().zip(packed) {
        all[speed.index()] = column;
    }
    by_rows(&all)
}

/// The linear rows, then the angular ones.
fn by_rows(columns: &[[Vector; 2]]) -> Vec<Expr> {
    let rows = (0..6).flat_map(|row| columns.iter().map(move |column| column[row / 3][row % 3]));
    rows.collect()
}
