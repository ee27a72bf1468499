//! Poses and Jacobians by steps: links one after the other, as they are seen from where the walk begins.
//!
//! The walk begins in the inertial frame and goes outward; or in another frame, and goes inward as far as both have a link in
//! common. What it keeps of a link are its axes, along those of the beginning: a rotation turns three vectors there. Every motion
//! leaves its direction, every offset a step; from the end back, the steps add up to levers.

use super::{between::Between, reach::Contributions};
use crate::{
    expr::{ExprGraph, Matrix, Vector, negated, transpose},
    given::{FrameMotion, FramePose},
    id::{BodyId, BodyMap},
    recursive::links::{
        link::Link,
        passage::{Drive, Passenger},
        rotation::Turn,
    },
    tree::{Motion, NamedFrame, Tree},
};

/// The frame as it is seen.
pub(super) fn pose(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    frame: NamedFrame,
    from: Option<NamedFrame>,
) -> FramePose {
    let (walk, axes) = walk(graph, tree, links, (frame, None), from);
    FramePose {
        rotation: graph.mul_matrices(&axes, &transpose(&walk.basis)),
        position: walk.levers(graph).0,
    }
}

/// The columns of the frame, or of a point that it is given.
pub(super) fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    of: (NamedFrame, Option<Vector>),
    from: Option<NamedFrame>,
) -> Contributions {
    let (walk, _) = walk(graph, tree, links, of, from);
    walk.levers(graph).1
}

/// The walk from who sees the frame to it, and the frame's axes in its link.
fn walk(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    (frame, point): (NamedFrame, Option<Vector>),
    from: Option<NamedFrame>,
) -> (Walk, Matrix) {
    let (way, reach) = Between::aligned(graph, tree, links, frame, from);
    let view = way.view(graph, from);
    let mut walk = Walk {
        basis: view.axes,
        goes_inward: true,
        body: None,
        marks: Vec::new(),
    };
    walk.step(graph, negated(view.position));
    for &body in &way.behind {
        walk.body = Some(body);
        way.inward(graph, body, &mut walk);
        graph.name_matrix(&walk.basis, "seen");
    }
    walk.goes_inward = false;
    for &body in way.ahead.iter().rev() {
        walk.body = Some(body);
        way.outward(graph, body, &mut walk);
        graph.name_matrix(&walk.basis, "seen");
    }
    graph.enter(tree.frame_body(frame));
    let position = reach.of_point(graph, point);
    walk.reach(graph, tree, way.ahead.first().copied(), position);
    (walk, reach.axes)
}

#[derive(Clone, Copy, Debug)]
enum Mark {
    /// From one origin to the next.
    Step(Vector),
    /// What is ahead turns about a direction.
    About(BodyId, Motion, Vector),
    /// What is ahead is shifted along a direction.
    Along(Motion, Vector),
}

/// A link as it is seen from the beginning of the walk, and what the walk has left, along the axes there.
struct Walk {
    /// From components along the link's axes to those along the axes of the beginning, by rows.
    basis: Matrix,
    goes_inward: bool,
    /// The body whose joint is passed.
    body: Option<BodyId>,
    marks: Vec<Mark>,
}

impl Walk {
    fn step(&mut self, graph: &mut ExprGraph, step: Vector) {
        let step = graph.mul_vector(&self.basis, step);
        self.marks.push(Mark::Step(step));
    }

    /// The last step, to the frame's origin. A point on the axis of the last joint is met before the joint turns, which does not
    /// move it.
    fn reach(
        &mut self,
        graph: &mut ExprGraph,
        tree: &Tree,
        last: Option<BodyId>,
        position: Vector,
    ) {
        let hinge = last.and_then(|body| tree.body(body).joint.hinge_axis());
        let is_on_axis = hinge.is_some_and(|axis| {
            let (b, c) = axis.others();
            graph.is_zero(position[b]) && graph.is_zero(position[c])
        });
        let turns = |mark: &mut Mark| matches!(mark, Mark::About(body, ..) if Some(*body) == last);
        let turned = self.marks.pop_if(|mark| is_on_axis && turns(mark));
        self.step(graph, position);
        self.marks.extend(turned);
    }

    /// The position of the end, and what each motion contributes there.
    fn levers(&self, graph: &mut ExprGraph) -> (Vector, Contributions) {
        let mut position = graph.zero_vector();
        let mut columns = Vec::new();
        for mark in self.marks.iter().rev() {
            match *mark {
                Mark::Step(step) => position = graph.add_vectors(step, position),
                Mark::About(body, motion, angular) => {
                    graph.enter(body);
                    let linear = graph.cross(angular, position);
                    columns.push((motion, FrameMotion { linear, angular }));
                }
                Mark::Along(motion, linear) => {
                    let angular = graph.zero_vector();
                    columns.push((motion, FrameMotion { linear, angular }));
                }
            }
        }
        columns.reverse();
        (position, columns)
    }

    /// The direction of an axis, for what is ahead; inward the lower link moves the other way.
    fn direction(&self, axis: usize) -> Vector {
        let direction = self.basis.map(|row| row[axis]);
        if self.goes_inward {
            negated(direction)
        } else {
            direction
        }
    }

    fn about(&mut self, drive: Drive) {
        for (axis, motion) in drive.motions().into_iter().enumerate() {
            let direction = self.direction(axis);
            let body = self.body.expect("frames: a motion is one of a body");
            let mark = motion.map(|motion| Mark::About(body, motion, direction));
            self.marks.extend(mark);
        }
    }
}

impl Passenger for Walk {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let step = if self.goes_inward {
            negated(offset)
        } else {
            offset
        };
        self.step(graph, step);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        if self.goes_inward {
            self.about(drive);
            self.basis = self.basis.map(|row| rotation.backward(graph, row));
        } else {
            self.basis = self.basis.map(|row| rotation.forward(graph, row));
            self.about(drive);
        }
    }

    fn along(&mut self, _: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        for (axis, motion) in motions.into_iter().enumerate() {
            let direction = self.direction(axis);
            let mark = motion.map(|motion| Mark::Along(motion, direction));
            self.marks.extend(mark);
        }
    }
}
