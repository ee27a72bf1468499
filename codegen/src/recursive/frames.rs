//! The way from a lower body to a body, step by step: an offset, then rotations about x, y, z.
//!
//! A vector is rotated about one axis by 4 products and 2 sums, and the component along that axis does not
//! change: the rate of an angle enters there, and the generalized force of the angle is read off there.

use crate::{
    expr::{Axis, Expr, ExprGraph, Vector},
    id::{BodyId, BodyMap},
    kane::{given, orientation},
    recursive::inertia::Composite,
    tree::{Coordinate, Tree},
};

/// A rotation about a coordinate axis, from the components before it to those after it.
#[derive(Clone, Copy, Debug)]
pub struct Rotation {
    /// The axis.
    pub axis: Axis,
    /// The angle's coordinate.
    pub coordinate: Coordinate,
    sine: Expr,
    cosine: Expr,
}

/// The frames of a body.
#[derive(Clone, Debug)]
pub struct Frame {
    /// q'_K + s'_K, lower-body components.
    pub offset: Vector,
    /// The 1-2-3 body-fixed rotations, in order from the lower body's axes to the body's.
    pub rotations: [Rotation; 3],
}

/// The frames of every body.
pub fn frames(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Frame> {
    BodyMap::outward(tree.bodies.len(), |body, _| frame(graph, tree, body))
}

fn frame(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Frame {
    graph.enter(body);
    let joint = &tree.body(body).joint;
    let trigonometry = orientation::trigonometry(graph, joint);
    let rotations = Axis::ALL.map(|axis| Rotation {
        axis,
        coordinate: joint.angles[axis.index()],
        sine: trigonometry.sines[axis.index()],
        cosine: trigonometry.cosines[axis.index()],
    });
    Frame {
        offset: given::offset(graph, tree.body(body)),
        rotations,
    }
}

impl Rotation {
    /// Components after the rotation of a vector given by its components before it.
    pub fn forward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        self.turn(graph, v, self.sine)
    }

    /// Components before the rotation of a vector given by its components after it.
    pub fn backward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        self.turn(graph, v, -self.sine)
    }

    /// Components before the rotation of a composite body given by those after it.
    ///
    /// With `t = s (I_bb - I_cc) + 2 c I_bc` the turned entries are `I_bb - s t`, `I_cc + s t`, `c t - I_bc`;
    /// the other two turn as a vector.
    pub fn backward_composite(&self, graph: &mut ExprGraph, composite: &Composite) -> Composite {
        let (a, (b, c)) = (self.axis.index(), self.axis.others());
        let mut inertia = composite.inertia;
        let difference = graph.sub(inertia.diagonal[b], inertia.diagonal[c]);
        let two = graph.number(2.0);
        let (straight, crossed) = (
            graph.mul(self.sine, difference),
            graph.mul(two, inertia.mixed[a]),
        );
        let crossed = graph.mul(self.cosine, crossed);
        let t = graph.add(straight, crossed);
        let moved = graph.mul(self.sine, t);
        let turned = graph.mul(self.cosine, t);
        inertia.diagonal[b] = graph.sub(inertia.diagonal[b], moved);
        inertia.diagonal[c] = graph.add(inertia.diagonal[c], moved);
        // mixed[b] is I_ca and mixed[c] is I_ab: the vector (I_ab, I_ac) in the plane of b and c.
        let mut row = [inertia.mixed[a]; 3];
        (row[b], row[c]) = (inertia.mixed[c], inertia.mixed[b]);
        let row = self.backward(graph, row);
        (inertia.mixed[c], inertia.mixed[b]) = (row[b], row[c]);
        inertia.mixed[a] = graph.sub(turned, inertia.mixed[a]);
        Composite {
            mass: composite.mass,
            moment: self.backward(graph, composite.moment),
            inertia,
        }
    }

    fn turn(&self, graph: &mut ExprGraph, v: Vector, sine: Expr) -> Vector {
        let (b, c) = self.axis.others();
        let mut turned = v;
        let (straight, crossed) = (graph.mul(self.cosine, v[b]), graph.mul(sine, v[c]));
        turned[b] = graph.add(straight, crossed);
        let (straight, crossed) = (graph.mul(self.cosine, v[c]), graph.mul(sine, v[b]));
        turned[c] = graph.sub(straight, crossed);
        turned
    }
}
