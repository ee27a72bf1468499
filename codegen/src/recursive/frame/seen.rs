//! Poses and Jacobians: links one after the other, as they are seen from where the walk begins.
//!
//! The walk begins in the inertial frame and goes outward; or in another frame, and goes inward as far as both have a link in
//! common. What it keeps of a link are its axes, along those of the beginning: a rotation turns three vectors there. Every motion
//! leaves its direction, every offset a step; from the end back, the steps add up to levers.

use super::reach::{Reach, path};
use crate::{
    expr::{ExprGraph, Matrix, Purpose, Vector, negated, transpose},
    given::{FrameMotion, FramePose},
    id::{BodyId, BodyMap, SpeedId},
    recursive::{
        links::{
            link::{self, Link},
            passage::{Drive, Passage, Passenger},
            root,
            rotation::Turn,
        },
        plan::Plan,
    },
    tree::{Motion, NamedFrame, Tree},
};

/// The frame as it is seen from another, or from the inertial one.
pub(super) fn pose(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
    from: Option<NamedFrame>,
) -> FramePose {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let Seen { axes, way } = Seen::of(graph, tree, &links, frame, from);
    FramePose {
        rotation: axes,
        position: way.levers(graph).position,
    }
}

/// The motion of the frame for a unit value of each speed that moves it, as it is seen from another frame, or from the
/// inertial one, along its axes. A point that is given stands for the frame's origin.
pub fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    (frame, point): (NamedFrame, Option<Vector>),
    from: Option<NamedFrame>,
) -> Vec<(SpeedId, FrameMotion)> {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let Seen { axes, mut way } = Seen::of(graph, tree, &links, frame, from);
    if let Some(point) = point {
        graph.enter(tree.frame_body(frame));
        let step = graph.mul_vector(&transpose(&axes), point);
        way.marks.push(Mark::Step(step));
    }
    let columns = way.levers(graph).columns;
    of_speeds(graph, columns)
}

/// The motion of the frame in the inertial one for a unit value of each speed that moves it, along its own axes: the walk begins
/// in it, and goes inward.
pub fn local_jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    (frame, point): (NamedFrame, Option<Vector>),
) -> Vec<(SpeedId, FrameMotion)> {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let mut walk = Walk::begin(graph, tree, &links, Some(frame));
    for body in path(tree, frame) {
        graph.enter(body);
        walk.inward(graph, tree, body, &links[body]);
    }
    let mut apart = point.map_or_else(|| graph.zero_vector(), negated);
    let mut columns = Vec::new();
    for mark in walk.way.marks {
        // What is behind moves the other way than what is ahead.
        let (motion, linear, angular) = match mark {
            Mark::Step(step) => {
                apart = graph.add_vectors(apart, step);
                continue;
            }
            Mark::About(body, motion, direction) => {
                graph.enter(body);
                let linear = graph.cross(direction, apart);
                (motion, linear, negated(direction))
            }
            Mark::Along(motion, direction) => (motion, negated(direction), graph.zero_vector()),
        };
        columns.push((motion, FrameMotion { linear, angular }));
    }
    of_speeds(graph, columns)
}

/// What a unit value of each motion's speed contributes.
fn of_speeds(
    graph: &mut ExprGraph,
    columns: Vec<(Motion, FrameMotion)>,
) -> Vec<(SpeedId, FrameMotion)> {
    let columns = columns.into_iter();
    let columns = columns.map(|(Motion { speed, factor }, motion)| {
        let factor = graph.number(factor);
        let [linear, angular] =
            [motion.linear, motion.angular].map(|vector| graph.scale(factor, vector));
        (speed, FrameMotion { linear, angular })
    });
    columns.collect()
}

/// The frame at the end of a walk.
struct Seen {
    /// From components along the axes of the beginning to those along the frame's, by rows.
    axes: Matrix,
    way: Way,
}

impl Seen {
    fn of(
        graph: &mut ExprGraph,
        tree: &Tree,
        links: &BodyMap<Link>,
        frame: NamedFrame,
        from: Option<NamedFrame>,
    ) -> Self {
        let (mut inward, mut outward) = (
            from.map_or_else(Vec::new, |from| path(tree, from)),
            path(tree, frame),
        );
        while inward.last().is_some() && inward.last() == outward.last() {
            inward.pop();
            outward.pop();
        }
        let mut walk = Walk::begin(graph, tree, links, from);
        for body in inward {
            graph.enter(body);
            walk.inward(graph, tree, body, &links[body]);
        }
        let mut reach = Reach::of(graph, tree, links, frame);
        let last = outward.first().copied();
        for body in outward.into_iter().rev() {
            graph.enter(body);
            let mut passage = links[body].passage.clone();
            if let Some(phased) = links[body]
                .phased(graph, &reach.axes)
                .filter(|_| last == Some(body))
            {
                passage = phased.passage;
                reach = Reach {
                    axes: phased.axes,
                    position: phased.turn.forward(graph, reach.position),
                };
            }
            walk.outward(graph, tree, (body, &links[body]), &passage);
        }
        graph.enter(tree.frame_body(frame));
        walk.reach(graph, tree, last, reach.position);
        Self {
            axes: graph.mul_matrices(&reach.axes, &transpose(&walk.basis)),
            way: walk.way,
        }
    }
}

/// What a walk leaves, from its beginning to its end, along the axes of the beginning.
#[derive(Debug, Default)]
struct Way {
    marks: Vec<Mark>,
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

/// The end of a way as its beginning sees it.
struct Levers {
    position: Vector,
    columns: Vec<(Motion, FrameMotion)>,
}

impl Way {
    fn levers(&self, graph: &mut ExprGraph) -> Levers {
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
        Levers { position, columns }
    }
}

/// A link as it is seen from the beginning of a walk.
struct Walk {
    /// From components along the link's axes to those along the axes of the beginning, by rows.
    basis: Matrix,
    way: Way,
    body: Option<BodyId>,
    goes_inward: bool,
}

impl Walk {
    fn begin(
        graph: &mut ExprGraph,
        tree: &Tree,
        links: &BodyMap<Link>,
        from: Option<NamedFrame>,
    ) -> Self {
        let mut walk = Self {
            basis: graph.identity(),
            way: Way::default(),
            body: None,
            goes_inward: true,
        };
        if let Some(from) = from {
            let reach = Reach::of(graph, tree, links, from);
            walk.basis = reach.axes;
            walk.step(graph, negated(reach.position));
        }
        walk
    }

    fn inward(&mut self, graph: &mut ExprGraph, tree: &Tree, body: BodyId, link: &Link) {
        self.goes_inward = true;
        self.body = Some(body);
        link.passage.inward(graph, self);
        if tree.lower(body).is_none() {
            let origin = root::origin(graph, tree, link, body);
            self.step(graph, negated(origin));
        }
        graph.name_matrix(&self.basis, "seen");
    }

    fn outward(
        &mut self,
        graph: &mut ExprGraph,
        tree: &Tree,
        (body, link): (BodyId, &Link),
        passage: &Passage,
    ) {
        self.goes_inward = false;
        self.body = Some(body);
        if tree.lower(body).is_none() {
            let origin = root::origin(graph, tree, link, body);
            self.step(graph, origin);
        }
        passage.outward(graph, self);
        graph.name_matrix(&self.basis, "seen");
    }

    fn step(&mut self, graph: &mut ExprGraph, step: Vector) {
        let step = graph.mul_vector(&self.basis, step);
        self.way.marks.push(Mark::Step(step));
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
        let turned = self.way.marks.pop_if(|mark| is_on_axis && turns(mark));
        self.step(graph, position);
        self.way.marks.extend(turned);
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
            self.way.marks.extend(mark);
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
            self.way.marks.extend(mark);
        }
    }
}
