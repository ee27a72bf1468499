//! What bodies weigh, on its way inward.

use crate::{
    expr::{Axis, Expr, ExprGraph, Vector, negated},
    given::{self, Lifted},
    id::BodyId,
    recursive::{
        links::{
            link::Link,
            passage::{Drive, Passenger},
            rotation::Turn,
            totalled::Addend,
        },
        plan::Plan,
        technique::Technique,
    },
    tree::{Motion, Tree},
};

/// Gravity as it acts on weights.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Field {
    /// The upward acceleration that stands for gravity, inertial components, in units of `strength`.
    pub(in crate::recursive) upward: Vector,
    /// By which masses and first moments are multiplied where links have them; `None` is 1.
    strength: Option<Expr>,
}

impl Field {
    /// Gravity as an acceleration, beside masses.
    pub(in crate::recursive) fn of_masses(graph: &mut ExprGraph, tree: &Tree) -> Self {
        let gravity = given::acting_gravity(graph, tree);
        Self {
            upward: negated(gravity),
            strength: None,
        }
    }

    /// The same as the plan has it: a direction beside weights, where gravity is constant and along an axis.
    pub(in crate::recursive) fn new(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Self {
        let of_masses = Self::of_masses(graph, tree);
        let upward = of_masses.upward;
        let along = Axis::ALL.into_iter().find(|axis| {
            let (b, c) = axis.others();
            graph.is_zero(upward[b]) && graph.is_zero(upward[c])
        });
        let constant = along.and_then(|axis| Some((axis, graph.as_number(upward[axis.index()])?)));
        match constant {
            Some((axis, g)) if plan.uses(Technique::Weights) && g != 0.0 => {
                let mut direction = graph.zero_vector();
                direction[axis.index()] = graph.number(g.signum());
                Self {
                    upward: direction,
                    strength: Some(graph.number(g.abs())),
                }
            }
            _ => of_masses,
        }
    }

    /// What a mass and its first moment weigh.
    fn acting_on(&self, graph: &mut ExprGraph, mass: Weight) -> Weight {
        match self.strength {
            None => mass,
            Some(strength) => Weight {
                mass: graph.mul(strength, mass.mass),
                moment: graph.scale(strength, mass.moment),
            },
        }
    }
}

/// Mass and first moment about a point, in units of the [field](Field)'s strength.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Weight {
    pub(in crate::recursive) mass: Expr,
    pub(in crate::recursive) moment: Vector,
}

impl Weight {
    pub(super) fn zero(graph: &mut ExprGraph) -> Self {
        Self {
            mass: graph.zero(),
            moment: graph.zero_vector(),
        }
    }

    /// What is left of a link's weight beside what is lifted, about the link's origin.
    pub(in crate::recursive) fn left(
        graph: &mut ExprGraph,
        tree: &Tree,
        field: &Field,
        link: &Link,
        body: BodyId,
    ) -> Self {
        let (mass, moment) = (link.inertia.mass, link.inertia.moment);
        let left = match Self::lifted(graph, tree, link, body) {
            None => Self { mass, moment },
            Some(lifted) => Self {
                mass: graph.sub(mass, lifted.mass),
                moment: graph.sub_vectors(moment, lifted.moment),
            },
        };
        field.acting_on(graph, left)
    }

    /// What is lifted of a body, about its link's origin; `None` where nothing is.
    pub(super) fn lifted(
        graph: &mut ExprGraph,
        tree: &Tree,
        link: &Link,
        body: BodyId,
    ) -> Option<Self> {
        graph.enter(body);
        let Lifted { mass, moment } = given::lifted(graph, tree.body(body))?;
        let zero = graph.zero_vector();
        let from_link = link.point_of_body(graph, zero);
        let about_body = link.of_body(graph, moment);
        let own = Self {
            mass,
            moment: about_body,
        };
        Some(own.moved(graph, from_link))
    }

    /// The component of `moment × a` along an axis.
    pub(super) fn moment_about(&self, graph: &mut ExprGraph, axis: Axis, a: Vector) -> Expr {
        let (b, c) = axis.others();
        let (plus, minus) = (
            graph.mul(self.moment[b], a[c]),
            graph.mul(self.moment[c], a[b]),
        );
        graph.sub(plus, minus)
    }

    /// About a point from which this one's point lies at `offset`.
    pub(in crate::recursive) fn moved(&self, graph: &mut ExprGraph, offset: Vector) -> Self {
        let shift = graph.scale(self.mass, offset);
        Self {
            mass: self.mass,
            moment: graph.add_vectors(self.moment, shift),
        }
    }
}

/// Nothing is read off it on the way.
impl Passenger for Weight {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        *self = self.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        self.moment = rotation.backward(graph, self.moment);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}

impl Addend for Weight {
    fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            mass: graph.add(self.mass, other.mass),
            moment: graph.add_vectors(self.moment, other.moment),
        }
    }
}
