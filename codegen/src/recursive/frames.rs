//! The way from a lower body to a body, step by step: an offset, then rotations about x, y, z.
//!
//! A vector is rotated about one axis by 4 products and 2 sums, and the component along that axis does not
//! change: the rate of an angle enters there, and the generalized force of the angle is read off there.

use crate::{
    expr::{Axis, Expr, ExprGraph, Matrix, Vector, transpose},
    id::{BodyId, BodyMap},
    kane::{given, orientation},
    recursive::inertia::Composite,
    tree::{Joint, Motion, Orientation, Tree},
};

/// A rotation about a coordinate axis, from the components before it to those after it.
#[derive(Clone, Copy, Debug)]
pub struct Rotation {
    /// The axis.
    pub axis: Axis,
    /// The speed that is the angle's rate.
    pub motion: Option<Motion>,
    sine: Expr,
    cosine: Expr,
}

/// The frames of a body.
#[derive(Clone, Debug)]
pub struct Frame {
    /// q'_K + s'_K, lower-body components.
    pub offset: Vector,
    /// The directions of the three translations by rows, lower-body components: from the lower body's axes to the joint's.
    pub constant: Matrix,
    /// How the body is turned from the joint's axes.
    pub turning: Turning,
}

/// How a body is turned from its joint's axes in the lower body.
#[derive(Clone, Debug)]
pub enum Turning {
    /// By the 1-2-3 body-fixed rotations, in order; each may have a coordinate that moves.
    Angles([Rotation; 3]),
    /// By a matrix.
    Matrix(Matrix),
}

/// The frames of every body.
pub fn frames(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Frame> {
    BodyMap::outward(tree.bodies.len(), |body, _| frame(graph, tree, body))
}

fn frame(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Frame {
    graph.enter(body);
    let joint = &tree.body(body).joint;
    let turning = match joint.angles() {
        None => {
            let matrix = orientation::of_joint(graph, tree, joint);
            graph.name_matrix(&matrix, "rel");
            Turning::Matrix(matrix)
        }
        Some(angles) => {
            let trigonometry = orientation::trigonometry(graph, tree, angles);
            let rates = match joint.orientation {
                Orientation::Rates(_) => joint.turns(),
                Orientation::AngularVelocity { .. } => [None; 3],
            };
            Turning::Angles(Axis::ALL.map(|axis| Rotation {
                axis,
                motion: rates[axis.index()],
                sine: trigonometry.sines[axis.index()],
                cosine: trigonometry.cosines[axis.index()],
            }))
        }
    };
    Frame {
        offset: given::offset(graph, tree.body(body)),
        constant: given::shift_directions(graph, joint),
        turning,
    }
}

/// The motions of a joint that are components of its angular velocity: they enter in the body's axes, all at once.
pub fn angular_velocity(joint: &Joint) -> Option<[Motion; 3]> {
    match joint.orientation {
        Orientation::Rates(_) => None,
        Orientation::AngularVelocity { speeds, .. } => {
            Some(speeds.map(|speed| Motion { speed, factor: 1.0 }))
        }
    }
}

impl Frame {
    /// Components in the body's axes of a vector given by those in the lower body's.
    pub fn forward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        let v = graph.mul_vector(&self.constant, v);
        match &self.turning {
            Turning::Matrix(matrix) => graph.mul_vector(matrix, v),
            Turning::Angles(rotations) => rotations
                .iter()
                .fold(v, |v, rotation| rotation.forward(graph, v)),
        }
    }

    /// Components before the constant rotation of a vector given by those after it.
    pub fn before_constant(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        graph.mul_vector(&transpose(&self.constant), v)
    }

    /// As [`Self::before_constant`], of a composite body.
    pub fn composite_before_constant(
        &self,
        graph: &mut ExprGraph,
        composite: &Composite,
    ) -> Composite {
        turned_back(graph, &self.constant, composite)
    }
}

/// Components before a rotation of a composite body given by those after it.
pub fn turned_back(graph: &mut ExprGraph, matrix: &Matrix, composite: &Composite) -> Composite {
    Composite {
        mass: composite.mass,
        moment: graph.mul_vector(&transpose(matrix), composite.moment),
        inertia: graph.turn_back_symmetric(matrix, &composite.inertia),
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
