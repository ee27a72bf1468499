//! Jacobians of frames, in the way that the plan says.

use super::{columns, levers, own, reach::Contributions, steps};
use crate::{
    expr::{ExprGraph, Purpose, Vector},
    given::FrameMotion,
    id::SpeedId,
    recursive::{links::link, plan::Plan, technique::Technique},
    tree::{Motion, NamedFrame, Tree},
};

/// The motion of the frame for a unit value of each speed that moves it, as it is seen from another frame, or from the
/// inertial one, along its axes. A point that is given stands for the frame's origin.
pub fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    of: (NamedFrame, Option<Vector>),
    from: Option<NamedFrame>,
) -> Vec<(SpeedId, FrameMotion)> {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let columns = if plan.uses(Technique::Inward) {
        columns::seen(graph, tree, &links, of, from)
    } else if plan.uses(Technique::Levers) {
        levers::jacobian(graph, tree, &links, of, from)
    } else {
        steps::jacobian(graph, tree, &links, of, from)
    };
    of_speeds(graph, columns)
}

/// The same in the inertial frame, along the frame's own axes.
pub fn local_jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    of: (NamedFrame, Option<Vector>),
) -> Vec<(SpeedId, FrameMotion)> {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let columns = if plan.uses(Technique::Inward) {
        columns::local(graph, tree, &links, of)
    } else {
        own::jacobian(graph, tree, &links, of)
    };
    of_speeds(graph, columns)
}

/// An inertial vector along the frame's own axes, with what its Jacobian along them needs too.
pub fn along_frame(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
    inertial: Vector,
) -> Vector {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    if plan.uses(Technique::Inward) {
        columns::along_frame(graph, tree, &links, frame, inertial)
    } else {
        own::along_frame(graph, tree, &links, frame, inertial)
    }
}

/// What a unit value of each motion's speed contributes.
fn of_speeds(graph: &mut ExprGraph, columns: Contributions) -> Vec<(SpeedId, FrameMotion)> {
    let columns = columns.into_iter();
    let columns = columns.map(|(Motion { speed, factor }, motion)| {
        let factor = graph.number(factor);
        let [linear, angular] =
            [motion.linear, motion.angular].map(|vector| graph.scale(factor, vector));
        (speed, FrameMotion { linear, angular })
    });
    columns.collect()
}
