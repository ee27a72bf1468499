//! How fast first and second moments of composite bodies change, seen from the link that has been reached: the symmetric part of
//! [`Rates`](super::moments::Rates), of which fewer numbers pass.

use super::moments::{self, Changing, Moments};
use crate::{
    expr::{Axis, Expr, ExprGraph, Symmetric, Vector},
    recursive::links::{inertia, rotation::Turn},
};

/// `h_dot` and `S_dot`.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Spreading {
    /// `h_dot`, linear momentum, kg m/s.
    pub(in crate::recursive) first: Vector,
    /// `S_dot`, kg m²/s.
    pub(in crate::recursive) second: Symmetric,
}

impl Changing for Spreading {
    fn zero(graph: &mut ExprGraph) -> Self {
        Self {
            first: graph.zero_vector(),
            second: graph.zero_symmetric(),
        }
    }

    /// Both together, about the same point, seen from the same link.
    fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            first: graph.add_vectors(self.first, other.first),
            second: graph.add_symmetric(&self.second, &other.second),
        }
    }

    /// Names `h_dot` and `S_dot` `text_h_dot` and `text_s_dot`, by hints.
    fn hint(&self, graph: &mut ExprGraph, text: &str) {
        graph.hint(|graph| {
            graph.name_vector(self.first, &format!("{text}_h_dot"));
            inertia::name(graph, &self.second, &format!("{text}_s_dot"));
        });
    }

    /// Seen from axes about which those that have been reached turn by `w`: `h_dot + w × h`,
    /// `S_dot + tilde(w) S - S tilde(w)`.
    fn driven(&self, graph: &mut ExprGraph, moments: &Moments, w: Vector) -> Self {
        let swept = graph.cross(w, moments.first);
        let columns = [0, 1, 2].map(|axis| graph.cross(w, moments.second.column(axis)));
        Self {
            first: graph.add_vectors(self.first, swept),
            second: self.plus_both(graph, |graph, i, j| {
                if i == j {
                    let two = graph.number(2.0);
                    graph.mul(two, columns[i][i])
                } else {
                    graph.add(columns[j][i], columns[i][j])
                }
            }),
        }
    }

    /// Components before a rotation of what is given by those after it.
    fn turned_back(&self, graph: &mut ExprGraph, rotation: &dyn Turn) -> Self {
        Self {
            first: rotation.backward(graph, self.first),
            second: rotation.backward_symmetric(graph, &self.second),
        }
    }
}

impl Spreading {
    /// Seen from where the origin moves by `v`: `h_dot + m v`, `S_dot + v h^T + h v^T`.
    pub(in crate::recursive) fn carried(
        &self,
        graph: &mut ExprGraph,
        moments: &Moments,
        v: Vector,
    ) -> Self {
        let moved = graph.scale(moments.mass, v);
        Self {
            first: graph.add_vectors(self.first, moved),
            second: self.plus_dyads(graph, moments.first, v),
        }
    }

    /// About a point of the same link from which this one's point lies at `d`: `S_dot + h_dot d^T + d h_dot^T`.
    pub(in crate::recursive) fn moved(&self, graph: &mut ExprGraph, d: Vector) -> Self {
        Self {
            first: self.first,
            second: self.plus_dyads(graph, self.first, d),
        }
    }

    /// The rate of the angular momentum for a unit angular velocity about an axis.
    pub(in crate::recursive) fn about(&self, graph: &mut ExprGraph, axis: usize) -> Vector {
        moments::across(graph, axis, self.second.column(axis), self.second.diagonal)
    }

    fn plus_dyads(&self, graph: &mut ExprGraph, a: Vector, b: Vector) -> Symmetric {
        self.plus_both(graph, |graph, i, j| {
            if i == j {
                return twice(graph, a[i], b[i]);
            }
            let own = graph.mul(a[i], b[j]);
            let mirrored = graph.mul(b[i], a[j]);
            graph.add(own, mirrored)
        })
    }

    fn plus_both(
        &self,
        graph: &mut ExprGraph,
        entry: impl Fn(&mut ExprGraph, usize, usize) -> Expr,
    ) -> Symmetric {
        let mut sum = self.second;
        for axis in Axis::ALL {
            let (a, (b, c)) = (axis.index(), axis.others());
            let own = entry(graph, a, a);
            sum.diagonal[a] = graph.add(sum.diagonal[a], own);
            let mixed = entry(graph, b, c);
            sum.mixed[a] = graph.add(sum.mixed[a], mixed);
        }
        sum
    }
}

/// `2 a b`; of a number the double first, so that its sign stays beside it.
fn twice(graph: &mut ExprGraph, a: Expr, b: Expr) -> Expr {
    let two = graph.number(2.0);
    let (first, second) = if graph.as_number(a).is_some() {
        (a, b)
    } else {
        (b, a)
    };
    let double = graph.mul(two, first);
    graph.mul(double, second)
}
