//! Poses and Jacobians as they are seen from the inertial frame, or from another.
//!
//! The lever to the frame passes from the frame to who sees it; the axes, as who sees it has them, pass the other way. Where they
//! meet at a motion, what it contributes is known: the lever has few entries near the frame, the axes near who sees it.

use super::{
    between::Between,
    reach::{Contributions, Reach},
};
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
    let (way, reach) = Between::aligned(graph, tree, links, frame, from);
    let lever = Lever::all_the_way(graph, &way, reach.position);
    let view = way.view(graph, from);
    let position = graph.sub_vectors(lever.position, view.position);
    let axes = Axes::all_the_way(graph, &way, view.axes, lever.at_turns);
    FramePose {
        rotation: graph.mul_matrices(&reach.axes, &transpose(&axes.basis)),
        position: graph.mul_vector(&view.axes, position),
    }
}

/// The columns of the frame, or of a point that it is given.
pub(super) fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    (frame, point): (NamedFrame, Option<Vector>),
    from: Option<NamedFrame>,
) -> Contributions {
    let way = Between::new(tree, links, frame, from);
    let position = Reach::of(graph, tree, links, frame).of_point(graph, point);
    let lever = Lever::all_the_way(graph, &way, position);
    let view = way.view(graph, from);
    Axes::all_the_way(graph, &way, view.axes, lever.at_turns).columns
}

/// Where the frame is, from the origin that has been reached.
struct Lever {
    position: Vector,
    goes_inward: bool,
    /// The same where motions meet it, rotation by rotation.
    at_turns: Vec<Vector>,
}

impl Lever {
    /// From this position in the frame's link to who sees it.
    fn all_the_way(graph: &mut ExprGraph, way: &Between<'_>, position: Vector) -> Self {
        let mut lever = Self {
            position,
            goes_inward: true,
            at_turns: Vec::new(),
        };
        for &body in &way.ahead {
            way.inward(graph, body, &mut lever);
            graph.name_vector(lever.position, "lever");
        }
        lever.goes_inward = false;
        for &body in way.behind.iter().rev() {
            way.outward(graph, body, &mut lever);
            graph.name_vector(lever.position, "lever");
        }
        lever
    }
}

impl Passenger for Lever {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.position = if self.goes_inward {
            graph.add_vectors(self.position, offset)
        } else {
            graph.sub_vectors(self.position, offset)
        };
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let from = self.position;
        let at_turn = if self.goes_inward {
            self.position = rotation.backward(graph, from);
            drive.met(self.position, from)
        } else {
            self.position = rotation.forward(graph, from);
            drive.met(from, self.position)
        };
        self.at_turns.push(at_turn);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}

/// The axes that have been reached.
struct Axes {
    /// From components along them to those that who sees the frame has, by rows.
    basis: Matrix,
    /// Inward, motions move who sees the frame, and not the frame.
    goes_inward: bool,
    /// The levers of the rest of the way.
    levers: Vec<Vector>,
    columns: Contributions,
}

impl Axes {
    /// Back to the frame's link, where they meet these levers.
    fn all_the_way(
        graph: &mut ExprGraph,
        way: &Between<'_>,
        basis: Matrix,
        levers: Vec<Vector>,
    ) -> Self {
        let mut axes = Self {
            basis,
            goes_inward: true,
            levers,
            columns: Vec::new(),
        };
        for &body in &way.behind {
            way.inward(graph, body, &mut axes);
            graph.name_matrix(&axes.basis, "seen");
        }
        axes.goes_inward = false;
        for &body in way.ahead.iter().rev() {
            way.outward(graph, body, &mut axes);
            graph.name_matrix(&axes.basis, "seen");
        }
        axes
    }

    fn add(&mut self, motion: Motion, FrameMotion { linear, angular }: FrameMotion) {
        let moved = |v| if self.goes_inward { negated(v) } else { v };
        let (linear, angular) = (moved(linear), moved(angular));
        self.columns.push((motion, FrameMotion { linear, angular }));
    }
}

impl Passenger for Axes {
    fn shift(&mut self, _: &mut ExprGraph, _: BodyId, _: Vector) {}

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let from = self.basis;
        let basis = if self.goes_inward {
            self.basis = from.map(|row| rotation.backward(graph, row));
            drive.met(self.basis, from)
        } else {
            self.basis = from.map(|row| rotation.forward(graph, row));
            drive.met(from, self.basis)
        };
        let lever = self.levers.pop();
        let lever = lever.expect("frames: axes turn wherever the lever has turned");
        for (axis, motion) in drive.motions().into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let unit = graph.unit_vector(axis);
            let linear = graph.cross(unit, lever);
            let linear = graph.mul_vector(&basis, linear);
            let angular = basis.map(|row| row[axis]);
            self.add(motion, FrameMotion { linear, angular });
        }
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let linear = self.basis.map(|row| row[axis]);
            let angular = graph.zero_vector();
            self.add(motion, FrameMotion { linear, angular });
        }
    }
}
