//! Articulated inertias: how a link with all that it carries resists, when some of what it carries can move.

use crate::{
    expr::{Expr, ExprGraph, Matrix, Symmetric, Vector, transpose},
    recursive::links::{
        inertia::{self, Composite},
        rotation::Turn,
    },
};

/// What relates a link's acceleration to the wrench it needs, about its origin: for a rigid body ten numbers, in general 21.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) enum Inertia {
    /// Of a rigid body.
    Rigid(Composite),
    /// Of a link from which motions were eliminated.
    Articulated(ArticulatedInertia),
}

/// `n = I alpha + H a`, `f = H^T alpha + M a`.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct ArticulatedInertia {
    pub(in crate::recursive) angular: Symmetric,
    pub(in crate::recursive) coupling: Matrix,
    pub(in crate::recursive) linear: Symmetric,
}

impl Inertia {
    /// Components before a rotation of what is given by those after it.
    pub(in crate::recursive) fn turned_back(&self, graph: &mut ExprGraph, turn: &dyn Turn) -> Self {
        match self {
            Self::Rigid(composite) => Self::Rigid(turn.backward_composite(graph, composite)),
            Self::Articulated(own) => Self::Articulated(ArticulatedInertia {
                angular: turn.backward_symmetric(graph, &own.angular),
                coupling: turn.backward_matrix(graph, &own.coupling),
                linear: turn.backward_symmetric(graph, &own.linear),
            }),
        }
    }

    /// Labels the components, with what tells where it has come.
    pub(in crate::recursive) fn name(&self, graph: &mut ExprGraph, at: &str) {
        match self {
            Self::Rigid(composite) => {
                inertia::name(graph, &composite.inertia, &format!("composite{at}"));
            }
            Self::Articulated(own) => {
                inertia::name(graph, &own.angular, &format!("articulated{at}"));
                graph.name_matrix(&own.coupling, &format!("coupling{at}"));
                inertia::name(graph, &own.linear, &format!("carried{at}"));
            }
        }
    }

    /// About a point from which this one's point lies at `d`.
    pub(in crate::recursive) fn moved(&self, graph: &mut ExprGraph, d: Vector) -> Self {
        match self {
            Self::Rigid(composite) => Self::Rigid(composite.moved(graph, d)),
            Self::Articulated(own) => Self::Articulated(own.moved(graph, d)),
        }
    }

    fn articulated(&self, graph: &mut ExprGraph) -> ArticulatedInertia {
        match self {
            Self::Articulated(own) => *own,
            Self::Rigid(Composite {
                mass,
                moment: [x, y, z],
                inertia,
            }) => {
                let zero = graph.zero();
                ArticulatedInertia {
                    angular: *inertia,
                    coupling: [[zero, -*z, *y], [*z, zero, -*x], [-*y, *x, zero]],
                    linear: Symmetric {
                        diagonal: [*mass; 3],
                        mixed: [zero; 3],
                    },
                }
            }
        }
    }

    /// The whole, for the moment and force of an angular and a linear acceleration.
    pub(in crate::recursive) fn rows(&self, graph: &mut ExprGraph) -> [[Expr; 6]; 6] {
        let ArticulatedInertia {
            angular,
            coupling,
            linear,
        } = self.articulated(graph);
        std::array::from_fn(|i| {
            std::array::from_fn(|j| match (i < 3, j < 3) {
                (true, true) => angular.entry(i, j),
                (true, false) => coupling[i][j - 3],
                (false, true) => coupling[j][i - 3],
                (false, false) => linear.entry(i - 3, j - 3),
            })
        })
    }

    /// Nothing at all counts as rigid.
    pub(in crate::recursive) fn of_rows(graph: &mut ExprGraph, rows: &[[Expr; 6]; 6]) -> Self {
        let zero = graph.zero();
        if rows.iter().flatten().all(|entry| *entry == zero) {
            return Self::Rigid(Composite::zero(graph));
        }
        let symmetric = |first: usize| Symmetric {
            diagonal: [0, 1, 2].map(|i| rows[first + i][first + i]),
            mixed: [(1, 2), (0, 2), (0, 1)].map(|(i, j)| rows[first + i][first + j]),
        };
        Self::Articulated(ArticulatedInertia {
            angular: symmetric(0),
            coupling: std::array::from_fn(|i| [3, 4, 5].map(|j| rows[i][j])),
            linear: symmetric(3),
        })
    }

    pub(in crate::recursive) fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        if let (Self::Rigid(own), Self::Rigid(other)) = (self, other) {
            return Self::Rigid(own.plus(graph, other));
        }
        let (own, other) = (self.articulated(graph), other.articulated(graph));
        let angular = graph.add_symmetric(&own.angular, &other.angular);
        let linear = graph.add_symmetric(&own.linear, &other.linear);
        Self::Articulated(ArticulatedInertia {
            angular,
            coupling: [0, 1, 2].map(|i| graph.add_vectors(own.coupling[i], other.coupling[i])),
            linear,
        })
    }
}

impl ArticulatedInertia {
    /// About a point from which this one's point lies at `d`: `H' = H + tilde(d) M`, `I' = I + tilde(d) H^T - H' tilde(d)`.
    fn moved(&self, graph: &mut ExprGraph, d: Vector) -> Self {
        if graph.is_zero_vector(d) {
            return *self;
        }
        let columns = [0, 1, 2].map(|j| {
            let carried = graph.cross(d, self.linear.column(j));
            let column = [0, 1, 2].map(|i| self.coupling[i][j]);
            graph.add_vectors(column, carried)
        });
        let coupling = transpose(&columns);
        // (d × row j of H)_i + (d × row i of H')_j.
        let mut turned = |i: usize, j: usize| {
            if i == j {
                let both = graph.add_vectors(self.coupling[i], coupling[i]);
                let lever = graph.cross(d, both);
                return lever[i];
            }
            let (first, second) = (
                graph.cross(d, self.coupling[j]),
                graph.cross(d, coupling[i]),
            );
            graph.add(first[i], second[j])
        };
        let diagonal = [0, 1, 2].map(|i| turned(i, i));
        let mixed = [(1, 2), (0, 2), (0, 1)].map(|(i, j)| turned(i, j));
        Self {
            angular: Symmetric {
                diagonal: graph.add_vectors(self.angular.diagonal, diagonal),
                mixed: graph.add_vectors(self.angular.mixed, mixed),
            },
            coupling,
            linear: self.linear,
        }
    }
}
