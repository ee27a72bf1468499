//! Jacobians along a frame's own axes: links one after the other inward, as they are seen from the frame. Axes and the lever are known
//! at each motion, so that nothing is left to add up.

use super::reach::{Contributions, Reach, path};
use crate::{
    expr::{ExprGraph, Matrix, Vector},
    given::FrameMotion,
    id::{BodyId, BodyMap},
    recursive::links::{
        link::Link,
        passage::{Drive, Passenger},
        rotation::Turn,
    },
    tree::{Motion, NamedFrame, Tree},
};

/// The columns of the frame, or of a point that it is given.
pub(super) fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    of: (NamedFrame, Option<Vector>),
) -> Contributions {
    inertial_axes(graph, tree, links, of).columns
}

/// An inertial vector along the frame's axes.
pub(super) fn along_frame(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    frame: NamedFrame,
    inertial: Vector,
) -> Vector {
    let seen = inertial_axes(graph, tree, links, (frame, None));
    graph.mul_vector(&seen.basis, inertial)
}

/// What is seen where the way inward ends.
fn inertial_axes(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    (frame, point): (NamedFrame, Option<Vector>),
) -> Seen {
    let Reach { axes, position } = Reach::of(graph, tree, links, frame);
    let to_origin = graph.mul_vector(&axes, position);
    let mut seen = Seen {
        basis: axes,
        lever: match point {
            Some(point) => graph.add_vectors(to_origin, point),
            None => to_origin,
        },
        columns: Vec::new(),
    };
    for body in path(tree, frame) {
        graph.enter(body);
        links[body].passage.inward(graph, &mut seen);
        graph.name_matrix(&seen.basis, "seen");
        graph.name_vector(seen.lever, "lever");
    }
    seen
}

/// A link as the frame sees it.
struct Seen {
    /// From components along the link's axes to those along the frame's, by rows.
    basis: Matrix,
    /// From the link's origin to the point, along the frame's axes.
    lever: Vector,
    columns: Contributions,
}

impl Passenger for Seen {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let step = graph.mul_vector(&self.basis, offset);
        self.lever = graph.add_vectors(self.lever, step);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        for (axis, motion) in drive.motions().into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let angular = self.basis.map(|row| row[axis]);
            let linear = graph.cross(angular, self.lever);
            self.columns.push((motion, FrameMotion { linear, angular }));
        }
        self.basis = self.basis.map(|row| rotation.backward(graph, row));
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let linear = self.basis.map(|row| row[axis]);
            let angular = graph.zero_vector();
            self.columns.push((motion, FrameMotion { linear, angular }));
        }
    }
}
