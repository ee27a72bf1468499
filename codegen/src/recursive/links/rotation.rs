//! Rotations about coordinate axes, of whatever passes through a joint.
//!
//! A vector is rotated about one axis by 4 products and 2 sums, and the component along that axis does not change: the
//! rate of an angle enters there, and the generalized force of the angle is read off there. A tensor is rotated by 8 more
//! products at most: in the plane across the axis its trace and its antisymmetric part do not change.

use super::inertia::Composite;
use crate::{
    expr::{Axis, Expr, ExprGraph, Matrix, Symmetric, Vector, transpose},
    geometry, given,
};

/// A rotation, of whatever has components before and after it.
pub(in crate::recursive) trait Turn {
    /// Components after the rotation of a vector given by its components before it.
    fn forward(&self, graph: &mut ExprGraph, v: Vector) -> Vector;

    /// Components before the rotation of a vector given by its components after it.
    fn backward(&self, graph: &mut ExprGraph, v: Vector) -> Vector;

    /// Components before the rotation of a symmetric tensor given by those after it.
    fn backward_symmetric(&self, graph: &mut ExprGraph, tensor: &Symmetric) -> Symmetric;

    /// Components before the rotation of any tensor given by those after it.
    fn backward_matrix(&self, graph: &mut ExprGraph, tensor: &Matrix) -> Matrix;

    /// Components before the rotation of a composite body given by those after it.
    fn backward_composite(&self, graph: &mut ExprGraph, composite: &Composite) -> Composite {
        Composite {
            mass: composite.mass,
            moment: self.backward(graph, composite.moment),
            inertia: self.backward_symmetric(graph, &composite.inertia),
        }
    }
}

impl Turn for Matrix {
    fn forward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        graph.mul_vector(self, v)
    }

    fn backward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        graph.mul_vector(&transpose(self), v)
    }

    fn backward_symmetric(&self, graph: &mut ExprGraph, tensor: &Symmetric) -> Symmetric {
        graph.turn_back_symmetric(self, tensor)
    }

    fn backward_matrix(&self, graph: &mut ExprGraph, tensor: &Matrix) -> Matrix {
        if *self == graph.identity() {
            return *tensor;
        }
        let right = graph.mul_matrices(tensor, self);
        graph.mul_matrices(&transpose(self), &right)
    }
}

/// A rotation about a coordinate axis, from the components before it to those after it.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct AxisRotation {
    pub(in crate::recursive) axis: Axis,
    pub(in crate::recursive) sine: Expr,
    pub(in crate::recursive) cosine: Expr,
}

impl Turn for AxisRotation {
    fn forward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        self.turn(graph, v, self.sine)
    }

    fn backward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        self.turn(graph, v, -self.sine)
    }

    /// With `t = s (I_bb - I_cc) + 2 c I_bc` the turned entries are `I_bb - s t`, `I_cc + s t`, `c t - I_bc`;
    /// the other two turn as a vector.
    fn backward_symmetric(&self, graph: &mut ExprGraph, tensor: &Symmetric) -> Symmetric {
        let (a, (b, c)) = (self.axis.index(), self.axis.others());
        let mut turned = *tensor;
        let difference = graph.sub(tensor.diagonal[b], tensor.diagonal[c]);
        let two = graph.number(2.0);
        let (straight, crossed) = (
            graph.mul(self.sine, difference),
            graph.mul(two, tensor.mixed[a]),
        );
        let crossed = graph.mul(self.cosine, crossed);
        let t = graph.add(straight, crossed);
        let (moved, along) = (graph.mul(self.sine, t), graph.mul(self.cosine, t));
        turned.diagonal[b] = graph.sub(tensor.diagonal[b], moved);
        turned.diagonal[c] = graph.add(tensor.diagonal[c], moved);
        // mixed[b] is I_ca and mixed[c] is I_ab: the vector (I_ab, I_ac) in the plane of b and c.
        let mut row = [tensor.mixed[a]; 3];
        (row[b], row[c]) = (tensor.mixed[c], tensor.mixed[b]);
        let row = self.backward(graph, row);
        (turned.mixed[c], turned.mixed[b]) = (row[b], row[c]);
        turned.mixed[a] = graph.sub(along, tensor.mixed[a]);
        turned
    }

    /// As [`Self::backward_symmetric`], with
    /// `t = s (H_bb - H_cc) + c (H_bc + H_cb)`.
    fn backward_matrix(&self, graph: &mut ExprGraph, tensor: &Matrix) -> Matrix {
        let (a, (b, c)) = (self.axis.index(), self.axis.others());
        let mut turned = *tensor;
        let difference = graph.sub(tensor[b][b], tensor[c][c]);
        let sum = graph.add(tensor[b][c], tensor[c][b]);
        let (straight, crossed) = (
            graph.mul(self.sine, difference),
            graph.mul(self.cosine, sum),
        );
        let t = graph.add(straight, crossed);
        let (moved, along) = (graph.mul(self.sine, t), graph.mul(self.cosine, t));
        turned[b][b] = graph.sub(tensor[b][b], moved);
        turned[c][c] = graph.add(tensor[c][c], moved);
        turned[b][c] = graph.sub(along, tensor[c][b]);
        turned[c][b] = graph.sub(along, tensor[b][c]);
        let row = self.backward(graph, tensor[a]);
        let column = self.backward(graph, [tensor[0][a], tensor[1][a], tensor[2][a]]);
        for other in [b, c] {
            turned[a][other] = row[other];
            turned[other][a] = column[other];
        }
        turned
    }
}

impl AxisRotation {
    /// By no angle.
    pub(in crate::recursive) fn none(graph: &mut ExprGraph, axis: Axis) -> Self {
        Self {
            axis,
            sine: graph.zero(),
            cosine: graph.one(),
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

/// A constant rotation, from the components before it to those after it.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct ConstantRotation {
    /// The whole.
    matrix: Matrix,
    /// Where it is one: a rotation about a coordinate axis after a permutation of the axes.
    split: Option<(Matrix, AxisRotation)>,
}

impl ConstantRotation {
    /// A rotation of these numbers.
    pub(in crate::recursive) fn new(graph: &mut ExprGraph, rotation: &geometry::Rotation) -> Self {
        let split = split(rotation).map(|(permutation, axis, sine, cosine)| {
            let rotation = AxisRotation {
                axis,
                sine: graph.number(sine),
                cosine: graph.number(cosine),
            };
            (given::constant(graph, &permutation), rotation)
        });
        Self {
            matrix: given::constant(graph, rotation),
            split,
        }
    }
}

impl Turn for ConstantRotation {
    fn forward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        self.matrix.forward(graph, v)
    }

    fn backward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        self.matrix.backward(graph, v)
    }

    fn backward_symmetric(&self, graph: &mut ExprGraph, tensor: &Symmetric) -> Symmetric {
        match &self.split {
            None => self.matrix.backward_symmetric(graph, tensor),
            Some((permutation, rotation)) => {
                let turned = rotation.backward_symmetric(graph, tensor);
                permutation.backward_symmetric(graph, &turned)
            }
        }
    }

    fn backward_matrix(&self, graph: &mut ExprGraph, tensor: &Matrix) -> Matrix {
        match &self.split {
            None => self.matrix.backward_matrix(graph, tensor),
            Some((permutation, rotation)) => {
                let turned = rotation.backward_matrix(graph, tensor);
                permutation.backward_matrix(graph, &turned)
            }
        }
    }
}

/// A permutation of the axes, then a rotation about one of them by an angle of this sine and cosine.
fn split(rotation: &geometry::Rotation) -> Option<(geometry::Rotation, Axis, f64, f64)> {
    // Alone in its row and in its column: a cosine rounds to one where the sine is still 1e-8.
    let column_of = |row: usize| {
        let is_alone = |&j: &usize| {
            (0..3).all(|other| {
                (other == j || rotation[row][other] == 0.0)
                    && (other == row || rotation[other][j] == 0.0)
            })
        };
        (0..3)
            .find(is_alone)
            .filter(|&j| rotation[row][j].abs() == 1.0)
    };
    let mut alone = Axis::ALL
        .into_iter()
        .filter_map(|axis| Some((axis, column_of(axis.index())?)));
    let (row, column) = alone.next()?;
    if alone.next().is_some() {
        return None;
    }
    let (b, c) = row.others();
    let mut permutation = [[0.0; 3]; 3];
    permutation[row.index()] = rotation[row.index()];
    permutation[b][(column + 1) % 3] = 1.0;
    permutation[c] = geometry::cross(permutation[row.index()], permutation[b]);
    let turn = geometry::then(&geometry::transposed(&permutation), rotation);
    Some((permutation, row, turn[b][c], turn[b][b]))
}
