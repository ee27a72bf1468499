//! Where columns begin: what a motion makes of the masses that it moves.

use super::{column::DerivativeColumn, displaced, reader::Reader, way::At};
use crate::{
    expr::{Expr, ExprGraph, Matrix, Symmetric, Vector},
    id::BodyId,
    recursive::{
        links::{link_motion::LinkMotion, wrench::Wrench},
        matrices::{
            coriolis::{
                column::{CoriolisColumn, Masses},
                velocities::Velocity,
            },
            lever::Levered,
            moments::{Moments, Rates},
        },
    },
};

/// A composite body where a motion moves it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    pub(super) body: BodyId,
    pub(super) moments: Moments,
    /// Doubled.
    pub(super) rates: Rates,
    pub(super) wrench: Wrench,
    pub(super) at: At,
}

impl Start {
    fn masses(&self) -> Masses<'_> {
        Masses {
            body: self.body,
            moments: &self.moments,
            rates: &self.rates,
        }
    }

    /// The column of a turn; `own` is the angular velocity that enters with it, where that has several components.
    pub(super) fn turn(
        &self,
        graph: &mut ExprGraph,
        reader: &Reader,
        own: Vector,
    ) -> DerivativeColumn {
        let Self {
            moments, rates, at, ..
        } = self;
        let axis = reader.place;
        let velocity: Velocity = [graph.doubled(at.after.w), at.v];
        let mut carrying =
            CoriolisColumn::of_turn(graph, self.masses(), reader.motion, axis, velocity);
        let e = graph.unit_vector(axis);
        let own = graph.cross(own, e);
        let (spun, swept) = (
            moments.spinning(graph, own),
            graph.cross(own, moments.first),
        );
        let more = Wrench {
            force: swept,
            moment: spun,
        };
        let needed = carrying.needed.wrench.minus(graph, &more);
        carrying.needed = Levered::new(graph, needed);

        let (u, a) = (reader.by_q[2], graph.cross(at.after.a, e));
        let [moment, force] = if graph.is_zero_vector(own) {
            displaced::by_angle(graph, moments, axis, &at.after)
        } else {
            displaced::by_turn(graph, moments, reader.by_q[0], [at.after.w, u])
        };
        let moment = [
            graph.cross(e, self.wrench.moment),
            graph.cross(moments.first, a),
            moment,
            rates.times(graph, u),
        ];
        let force = [
            graph.cross(e, self.wrench.force),
            graph.scale(moments.mass, a),
            force,
            graph.cross(u, rates.first),
        ];
        let displaced = Wrench {
            force: sum(graph, &force),
            moment: sum(graph, &moment),
        };
        DerivativeColumn {
            carrying,
            displaced: Levered::new(graph, displaced),
        }
    }

    /// The column of a translation.
    pub(super) fn shift(&self, graph: &mut ExprGraph, reader: &Reader) -> DerivativeColumn {
        let (axis, moments, at) = (reader.place - 3, &self.moments, &self.at);
        let velocity: Velocity = [graph.doubled(at.lower.w), at.v];
        let carrying =
            CoriolisColumn::of_shift(graph, self.masses(), reader.motion, axis, velocity);
        let (e, d) = (graph.unit_vector(axis), reader.by_q[1]);
        let moment = [
            graph.cross(e, self.wrench.force),
            graph.cross(moments.first, d),
        ];
        let displaced = Wrench {
            force: graph.scale(moments.mass, d),
            moment: sum(graph, &moment),
        };
        DerivativeColumn {
            carrying,
            displaced: Levered::new(graph, displaced),
        }
    }
}

fn sum(graph: &mut ExprGraph, terms: &[Vector]) -> Vector {
    let zero = graph.zero_vector();
    terms
        .iter()
        .fold(zero, |sum, &term| graph.add_vectors(sum, term))
}

impl Start {
    /// All of its numbers, but for the motion before the hinge.
    pub(super) fn parts_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        let Self {
            moments:
                Moments {
                    mass,
                    first,
                    second: Symmetric { diagonal, mixed },
                },
            rates,
            wrench,
            at,
            ..
        } = self;
        let LinkMotion {
            w,
            u: [x, y, z],
            squares,
            products,
            alpha,
            a,
        } = &mut at.after;
        let [p, q, r] = &mut rates.second;
        let masses = [first, diagonal, mixed, &mut rates.first, p, q, r];
        let motion = [w, x, y, z, squares, products, alpha, a, &mut at.v];
        let wrench = [&mut wrench.force, &mut wrench.moment];
        let vectors = masses.into_iter().chain(wrench).chain(motion);
        std::iter::once(mass).chain(vectors.flatten())
    }

    /// Along axes of which the first is the one of this number, in cyclic order.
    pub(super) fn turned(&self, first: usize) -> Self {
        let vector = |v: Vector| turned(v, first);
        let matrix = |rows: Matrix| turned(rows.map(vector), first);
        let Self {
            body,
            moments,
            rates,
            wrench,
            at,
        } = *self;
        let LinkMotion {
            w,
            u,
            squares,
            products,
            alpha,
            a,
        } = at.after;
        let after = LinkMotion {
            w: vector(w),
            u: matrix(u),
            squares: vector(squares),
            products: vector(products),
            alpha: vector(alpha),
            a: vector(a),
        };
        Self {
            body,
            moments: Moments {
                mass: moments.mass,
                first: vector(moments.first),
                second: Symmetric {
                    diagonal: vector(moments.second.diagonal),
                    mixed: vector(moments.second.mixed),
                },
            },
            rates: Rates {
                first: vector(rates.first),
                second: matrix(rates.second),
            },
            wrench: wrench.map(vector),
            at: At {
                after,
                v: vector(at.v),
                ..at
            },
        }
    }
}

/// The components in cyclic order from this one on.
pub(super) fn turned<T: Copy>(own: [T; 3], first: usize) -> [T; 3] {
    [0, 1, 2].map(|place| own[(place + first) % 3])
}
