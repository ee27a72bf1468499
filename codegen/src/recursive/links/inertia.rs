//! Inertia about a body's origin, of one body or of a body with all that it carries.

use crate::{
    expr::{Axis, Binding, Expr, ExprGraph, Node, Symmetric, Vector},
    given,
    id::BodyMap,
    tree::{RigidPart, Tree},
};

/// Mass, first moment and inertia about a point that moves with the bodies.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Composite {
    /// Mass, kg.
    pub(in crate::recursive) mass: Expr,
    /// Mass times the position of the mass centre, kg m.
    pub(in crate::recursive) moment: Vector,
    /// Inertia, kg m².
    pub(in crate::recursive) inertia: Symmetric,
}

/// Inertia about a link's origin, with its second moments `S_aa = (I_bb + I_cc - I_aa) / 2`.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct LinkInertia {
    pub(in crate::recursive) composite: Composite,
    pub(in crate::recursive) second: Vector,
}

impl LinkInertia {
    pub(in crate::recursive) fn new(graph: &mut ExprGraph, composite: Composite) -> Self {
        Self {
            composite,
            second: composite.second_moments(graph),
        }
    }
}

/// How many sums deep the parts of an entry are looked for: as a turn and an offset leave them.
const DEPTH: usize = 2;

/// The terms of a sum that change with the state, and those that do not.
fn parted(graph: &mut ExprGraph, sum: Expr, depth: usize) -> [Expr; 2] {
    let zero = graph.zero();
    if graph.binding(sum.node()) != Binding::State {
        return [zero, sum];
    }
    let Node::Add(a, b) = graph.node(sum.node()) else {
        return [sum, zero];
    };
    if depth == 0 {
        return [sum, zero];
    }
    let parts = [a, b].map(|term| parted(graph, term.signed(sum.is_negative()), depth - 1));
    let known = graph.add(parts[0][1], parts[1][1]);
    if graph.is_zero(known) {
        return [sum, zero];
    }
    [graph.add(parts[0][0], parts[1][0]), known]
}

/// For every body whether some of its ten inertial parameters are zero, along its own axes.
pub fn sparse_inertias(tree: &Tree) -> BodyMap<bool> {
    let mut graph = ExprGraph::default();
    BodyMap::outward(tree.bodies.len(), |body, _| {
        let own = own(&mut graph, &tree.body(body).parts);
        let numbers = [own.moment, own.inertia.diagonal, own.inertia.mixed];
        let mut numbers = numbers.into_iter().flatten();
        numbers.any(|number| graph.is_zero(number))
    })
}

/// The inertia of a body's parts about the origin from which they are seen: `m`, `m r`, `I_G + m (r·r 1 - r r^T)`, summed over them.
pub(in crate::recursive) fn own(graph: &mut ExprGraph, parts: &[RigidPart]) -> Composite {
    let mut parts = parts.iter();
    let first = parts.next().expect("tree: a body has a part, itself");
    let mut own = of_part(graph, first);
    for part in parts {
        let part = of_part(graph, part);
        own = own.plus(graph, &part);
    }
    own
}

fn of_part(graph: &mut ExprGraph, part: &RigidPart) -> Composite {
    let mass = given::value(graph, part.mass);
    let at_center = given::part_inertia(graph, part);
    let center = given::fixed(graph, &part.mass_center);
    let around_center = Composite {
        inertia: at_center,
        ..Composite::point(graph, mass)
    };
    around_center.moved(graph, center)
}

impl Composite {
    /// A mass at the point.
    pub(in crate::recursive) fn point(graph: &mut ExprGraph, mass: Expr) -> Self {
        Self {
            mass,
            moment: graph.zero_vector(),
            inertia: graph.zero_symmetric(),
        }
    }

    /// The same with what of the inertia changes with the state, and what is known of it before the loop: the lower link's own is
    /// added to that there.
    pub(in crate::recursive) fn parted(&self, graph: &mut ExprGraph) -> (Self, Symmetric) {
        let (mut rest, mut known) = (*self, graph.zero_symmetric());
        let Symmetric { diagonal, mixed } = &mut rest.inertia;
        let entries = diagonal.iter_mut().chain(mixed);
        let known_entries = known.diagonal.iter_mut().chain(&mut known.mixed);
        for (rest, known) in entries.zip(known_entries) {
            [*rest, *known] = parted(graph, *rest, DEPTH);
        }
        (rest, known)
    }

    /// The same with more inertia.
    pub(in crate::recursive) fn with_inertia(
        &self,
        graph: &mut ExprGraph,
        more: &Symmetric,
    ) -> Self {
        Self {
            inertia: graph.add_symmetric(more, &self.inertia),
            ..*self
        }
    }

    /// Nothing at all.
    pub(in crate::recursive) fn zero(graph: &mut ExprGraph) -> Self {
        let zero = graph.zero();
        Self::point(graph, zero)
    }

    /// The same bodies about a point from which this one's point lies at `offset`.
    ///
    /// With `h' = h + m d` and `H = h + h'`, the inertia is `I + (d·H) 1 - h d^T - d h'^T`.
    #[must_use]
    pub(in crate::recursive) fn moved(&self, graph: &mut ExprGraph, offset: Vector) -> Self {
        let shift = graph.scale(self.mass, offset);
        let moment = graph.add_vectors(self.moment, shift);
        let both = graph.add_vectors(self.moment, moment);
        let squares: Vector = std::array::from_fn(|i| graph.mul(offset[i], both[i]));
        let mut inertia = self.inertia;
        for a in 0..3 {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            let around = graph.add(squares[b], squares[c]);
            inertia.diagonal[a] = graph.add(inertia.diagonal[a], around);
            let (first, second) = (
                graph.mul(self.moment[b], offset[c]),
                graph.mul(offset[b], moment[c]),
            );
            let product = graph.add(first, second);
            inertia.mixed[a] = graph.sub(inertia.mixed[a], product);
        }
        Self {
            mass: self.mass,
            moment,
            inertia,
        }
    }

    /// The second moments about the three planes through the point, `S_aa = (I_bb + I_cc - I_aa) / 2`, kg m².
    fn second_moments(&self, graph: &mut ExprGraph) -> Vector {
        let half = graph.number(0.5);
        Axis::ALL.map(|axis| {
            let (a, (b, c)) = (axis.index(), axis.others());
            let diagonal = self.inertia.diagonal;
            let around = graph.add(diagonal[b], diagonal[c]);
            let twice = graph.sub(around, diagonal[a]);
            graph.mul(half, twice)
        })
    }

    /// Linear and angular momentum for a unit angular velocity about an axis.
    pub(in crate::recursive) fn turned_about(
        &self,
        graph: &mut ExprGraph,
        axis: usize,
    ) -> [Vector; 2] {
        let unit = graph.unit_vector(axis);
        [graph.cross(unit, self.moment), self.inertia.column(axis)]
    }

    /// The same for a unit velocity along an axis.
    pub(in crate::recursive) fn shifted_along(
        &self,
        graph: &mut ExprGraph,
        axis: usize,
    ) -> [Vector; 2] {
        let unit = graph.unit_vector(axis);
        [graph.scale(self.mass, unit), graph.cross(self.moment, unit)]
    }

    /// Both together, about the same point.
    #[must_use]
    pub(in crate::recursive) fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            mass: graph.add(self.mass, other.mass),
            moment: graph.add_vectors(self.moment, other.moment),
            inertia: graph.add_symmetric(&self.inertia, &other.inertia),
        }
    }
}

/// `factor ((a·b) 1 - (a b^T + b a^T) / 2)`: a second moment as an inertia.
pub(in crate::recursive) fn around(
    graph: &mut ExprGraph,
    [a, b]: [Vector; 2],
    factor: Expr,
) -> Symmetric {
    let half = graph.number(0.5);
    let mut tensor = graph.zero_symmetric();
    let products: Vector = std::array::from_fn(|i| {
        let scaled = graph.mul(factor, a[i]);
        graph.mul(scaled, b[i])
    });
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        tensor.diagonal[i] = graph.add(products[j], products[k]);
        let (first, second) = (graph.mul(a[j], b[k]), graph.mul(a[k], b[j]));
        let both = graph.add(first, second);
        let both = graph.mul(factor, both);
        tensor.mixed[i] = -graph.mul(half, both);
    }
    tensor
}

/// Labels the six components `text_xx` to `text_xy`.
pub(in crate::recursive) fn name(graph: &mut ExprGraph, tensor: &Symmetric, text: &str) {
    for (component, letters) in tensor.diagonal.into_iter().zip(["xx", "yy", "zz"]) {
        graph.name_by(component, || format!("{text}_{letters}"));
    }
    for (component, letters) in tensor.mixed.into_iter().zip(["yz", "xz", "xy"]) {
        graph.name_by(component, || format!("{text}_{letters}"));
    }
}
