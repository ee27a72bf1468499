//! The axes of all motions, along inertial axes: rotations pass outward, and each motion finds its axis where it enters.

use super::stands::turned;
use crate::{
    expr::{ExprGraph, Matrix, Purpose, Vector},
    id::{BodyId, BodyMap},
    recursive::links::{
        linkage::Linkage,
        passage::{Drive, Passenger},
        rotation::Turn,
    },
    tree::Motion,
};

/// The angular velocity of what moves for a unit value of each speed, one a speed; zero for translations. Each speed moves one joint.
pub(super) fn turning(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> Vec<Vector> {
    let Linkage { tree, passages, .. } = linkage;
    graph.begin(Purpose::Outward);
    let mut axes = vec![graph.zero_vector(); tree.n_speeds];
    let identity = graph.identity();
    BodyMap::outward(tree.bodies.len(), |body, stands: &BodyMap<Matrix>| {
        graph.enter(body);
        let mut stand = Turned {
            rotation: tree.lower(body).map_or(identity, |lower| stands[lower]),
            axes: &mut axes,
        };
        passages[body].outward(graph, &mut stand);
        let rotation = stand.rotation;
        graph.name_matrix(&rotation, "rot");
        rotation
    });
    axes
}

/// From inertial components to those along the axes that have been reached.
struct Turned<'a> {
    rotation: Matrix,
    axes: &'a mut [Vector],
}

impl Passenger for Turned<'_> {
    fn shift(&mut self, _: &mut ExprGraph, _: BodyId, _: Vector) {}

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.rotation = turned(graph, &self.rotation, rotation);
        for (axis, motion) in drive.motions().into_iter().enumerate() {
            if let Some(motion) = motion {
                self.axes[motion.speed.index()] = self.rotation[axis];
            }
        }
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}
