//! Masses of composite bodies and how they are spread: mass, first and second moments about an origin, and how fast these
//! change in axes of which some of the bodies turn.
//!
//! With positions `r` from the origin the first moment is `h = sum m r`, the second `S = sum m r r^T`, from which the inertia is
//! `tr(S) 1 - S`. Whatever moves is seen from the link that has been reached: `f = sum m r_dot`, `N = sum m r_dot r^T`. The
//! link's own masses add nothing to these, and a joint adds what its rate alone does.

use crate::{
    expr::{Axis, Expr, ExprGraph, Matrix, Symmetric, Vector},
    recursive::links::{inertia, link::Link, passage::Drive, rotation::Turn},
};

/// Mass, first and second moment about a point.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Moments {
    /// Mass, kg.
    pub(in crate::recursive) mass: Expr,
    /// Mass times the position of the mass centre, kg m.
    pub(in crate::recursive) first: Vector,
    /// Masses times the dyads of their positions, kg m².
    pub(in crate::recursive) second: Symmetric,
}

/// How fast they change, as seen from a link.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Rates {
    /// `f`, linear momentum, kg m/s.
    pub(in crate::recursive) first: Vector,
    /// `N`: the second moment changes by it and its transpose, kg m²/s.
    pub(in crate::recursive) second: Matrix,
}

impl Moments {
    /// A link's own.
    pub(in crate::recursive) fn of(link: &Link) -> Self {
        Self {
            mass: link.inertia.mass,
            first: link.inertia.moment,
            second: Symmetric {
                diagonal: link.second,
                mixed: link.inertia.inertia.mixed.map(|mixed| -mixed),
            },
        }
    }

    /// The angular momentum for a unit angular velocity about an axis.
    pub(in crate::recursive) fn about(&self, graph: &mut ExprGraph, axis: usize) -> Vector {
        across(graph, axis, self.second.column(axis), self.second.diagonal)
    }

    /// The angular momentum for an angular velocity.
    pub(in crate::recursive) fn spinning(&self, graph: &mut ExprGraph, w: Vector) -> Vector {
        let columns = [0, 1, 2].map(|axis| {
            let about = self.about(graph, axis);
            graph.scale(w[axis], about)
        });
        let sum = graph.add_vectors(columns[0], columns[1]);
        graph.add_vectors(sum, columns[2])
    }

    /// The moment `sum m r × Q r`, where Q is the change of a field of accelerations about this axis
    /// ([`turned_field`](crate::recursive::links::link_motion::LinkMotion::turned_field)).
    pub(in crate::recursive) fn moment_of_field(
        &self,
        graph: &mut ExprGraph,
        q: &Matrix,
        axis: usize,
    ) -> Vector {
        let (a, (b, c)) = (axis, Axis::ALL[axis].others());
        let s = |row, column| self.second.entry(row, column);
        let two = graph.number(2.0);
        let (unequal, mixed) = (graph.sub(s(b, b), s(c, c)), graph.mul(two, s(b, c)));
        // Those of `(Q S)_kj - (Q S)_jk`, of which `Q_aa` is zero, `Q_cc = -Q_bb` and `Q_cb = Q_bc`.
        let along_b = [
            (q[a][b], s(b, c)),
            (q[a][c], s(c, c)),
            (-q[c][a], s(a, a)),
            (-q[c][b], s(b, a)),
            (-q[c][c], s(c, a)),
        ];
        let along_c = [
            (q[b][a], s(a, a)),
            (q[b][b], s(b, a)),
            (q[b][c], s(c, a)),
            (-q[a][b], s(b, b)),
            (-q[a][c], s(c, b)),
        ];
        let along_a = [
            (q[c][a], s(a, b)),
            (-q[b][a], s(a, c)),
            (q[b][c], unequal),
            (-q[b][b], mixed),
        ];
        let mut moment = graph.zero_vector();
        for (place, terms) in [(a, &along_a[..]), (b, &along_b), (c, &along_c)] {
            for &(entry, second) in terms {
                let term = graph.mul(entry, second);
                moment[place] = graph.add(moment[place], term);
            }
        }
        moment
    }

    /// About a point from which this one's point lies at `d`: `h' = h + m d`, `S' = S + h d^T + d h'^T`.
    pub(in crate::recursive) fn moved(&self, graph: &mut ExprGraph, d: Vector) -> Self {
        let shift = graph.scale(self.mass, d);
        let first = graph.add_vectors(self.first, shift);
        let both = graph.add_vectors(self.first, first);
        let mut second = self.second;
        for axis in Axis::ALL {
            let (a, (b, c)) = (axis.index(), axis.others());
            let square = graph.mul(d[a], both[a]);
            second.diagonal[a] = graph.add(second.diagonal[a], square);
            let (plus, other) = (graph.mul(self.first[b], d[c]), graph.mul(d[b], first[c]));
            let product = graph.add(plus, other);
            second.mixed[a] = graph.add(second.mixed[a], product);
        }
        Self {
            mass: self.mass,
            first,
            second,
        }
    }

    /// Components before a rotation of what is given by those after it.
    pub(in crate::recursive) fn turned_back(
        &self,
        graph: &mut ExprGraph,
        rotation: &dyn Turn,
    ) -> Self {
        Self {
            mass: self.mass,
            first: rotation.backward(graph, self.first),
            second: rotation.backward_symmetric(graph, &self.second),
        }
    }

    /// Names the first moment `text_h`, the second `text_s`, by hints.
    pub(in crate::recursive) fn hint(&self, graph: &mut ExprGraph, text: &str) {
        graph.hint(|graph| {
            graph.name_vector(self.first, &format!("{text}_h"));
            inertia::name(graph, &self.second, &format!("{text}_s"));
        });
    }

    /// Both together, about the same point.
    pub(in crate::recursive) fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            mass: graph.add(self.mass, other.mass),
            first: graph.add_vectors(self.first, other.first),
            second: graph.add_symmetric(&self.second, &other.second),
        }
    }
}

/// How fast moments change, as seen from a link: all of it, or what is symmetric.
pub(in crate::recursive) trait Changing: Copy {
    /// Of what does not change.
    fn zero(graph: &mut ExprGraph) -> Self;

    /// Both together, about the same point.
    fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self;

    /// Names its numbers by hints that begin with a text.
    fn hint(&self, graph: &mut ExprGraph, text: &str);

    /// Seen from axes about which those that have been reached turn by `w`.
    fn driven(&self, graph: &mut ExprGraph, moments: &Moments, w: Vector) -> Self;

    /// Components before a rotation of what is given by those after it.
    fn turned_back(&self, graph: &mut ExprGraph, rotation: &dyn Turn) -> Self;

    /// Before a rotation that is driven at `w`, seen from the axes before it; so become the moments.
    ///
    /// The rate of an angle may enter on either side of its rotation: before it, where a link that carries nothing has no rates yet.
    fn undriven(
        &self,
        graph: &mut ExprGraph,
        moments: &mut Moments,
        rotation: &dyn Turn,
        (drive, w): (Drive, Vector),
    ) -> Self {
        if let Drive::AngularVelocity(_) = drive {
            let driven = self.driven(graph, moments, w);
            *moments = moments.turned_back(graph, rotation);
            driven.turned_back(graph, rotation)
        } else {
            *moments = moments.turned_back(graph, rotation);
            let turned = self.turned_back(graph, rotation);
            turned.driven(graph, moments, w)
        }
    }
}

impl Changing for Rates {
    fn zero(graph: &mut ExprGraph) -> Self {
        Self {
            first: graph.zero_vector(),
            second: [graph.zero_vector(); 3],
        }
    }

    /// Both together, about the same point, seen from the same link.
    fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            first: graph.add_vectors(self.first, other.first),
            second: [0, 1, 2].map(|i| graph.add_vectors(self.second[i], other.second[i])),
        }
    }

    /// Names the linear momentum `text_p`, the rate of the second moment `text_n`, by hints.
    fn hint(&self, graph: &mut ExprGraph, text: &str) {
        graph.hint(|graph| {
            graph.name_vector(self.first, &format!("{text}_p"));
            graph.name_matrix(&self.second, &format!("{text}_n"));
        });
    }

    /// Seen from axes about which those that have been reached turn by `w`: `f + w × h`, `N + tilde(w) S`.
    fn driven(&self, graph: &mut ExprGraph, moments: &Moments, w: Vector) -> Self {
        let swept = graph.cross(w, moments.first);
        let columns = [0, 1, 2].map(|axis| graph.cross(w, moments.second.column(axis)));
        Self {
            first: graph.add_vectors(self.first, swept),
            second: self.plus_columns(graph, &columns),
        }
    }

    /// Components before a rotation of what is given by those after it.
    fn turned_back(&self, graph: &mut ExprGraph, rotation: &dyn Turn) -> Self {
        Self {
            first: rotation.backward(graph, self.first),
            second: rotation.backward_matrix(graph, &self.second),
        }
    }
}

impl Rates {
    /// Seen from where the origin moves by `v`: `f + m v`, `N + v h^T`.
    pub(in crate::recursive) fn carried(
        &self,
        graph: &mut ExprGraph,
        moments: &Moments,
        v: Vector,
    ) -> Self {
        let moved = graph.scale(moments.mass, v);
        let columns = moments.first.map(|along| graph.scale(along, v));
        Self {
            first: graph.add_vectors(self.first, moved),
            second: self.plus_columns(graph, &columns),
        }
    }

    /// About a point of the same link from which this one's point lies at `d`: `N + f d^T`.
    pub(in crate::recursive) fn moved(&self, graph: &mut ExprGraph, d: Vector) -> Self {
        let columns = d.map(|along| graph.scale(along, self.first));
        Self {
            first: self.first,
            second: self.plus_columns(graph, &columns),
        }
    }

    /// A column of `tr(N) 1 - N`.
    pub(in crate::recursive) fn column(&self, graph: &mut ExprGraph, axis: usize) -> Vector {
        let column = self.second.map(|row| row[axis]);
        across(graph, axis, column, self.diagonal())
    }

    /// A row of it.
    pub(in crate::recursive) fn row(&self, graph: &mut ExprGraph, axis: usize) -> Vector {
        across(graph, axis, self.second[axis], self.diagonal())
    }

    /// It times a vector.
    pub(in crate::recursive) fn times(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        let columns = [0, 1, 2].map(|axis| {
            let column = self.column(graph, axis);
            graph.scale(v[axis], column)
        });
        let sum = graph.add_vectors(columns[0], columns[1]);
        graph.add_vectors(sum, columns[2])
    }

    fn diagonal(&self) -> Vector {
        [0, 1, 2].map(|i| self.second[i][i])
    }

    fn plus_columns(&self, graph: &mut ExprGraph, columns: &[Vector; 3]) -> Matrix {
        let mut sum = self.second;
        for (i, row) in sum.iter_mut().enumerate() {
            for (entry, column) in row.iter_mut().zip(columns) {
                *entry = graph.add(*entry, column[i]);
            }
        }
        sum
    }
}

/// A column or row of `tr(X) 1 - X` by that of X and its diagonal.
pub(in crate::recursive) fn across(
    graph: &mut ExprGraph,
    axis: usize,
    line: Vector,
    diagonal: Vector,
) -> Vector {
    let mut across = line.map(|entry| -entry);
    across[axis] = graph.add(diagonal[(axis + 1) % 3], diagonal[(axis + 2) % 3]);
    across
}
