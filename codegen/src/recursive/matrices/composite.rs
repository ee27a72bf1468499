//! The mass matrix from composite bodies (Walker and Orin 1982): each body with all that it carries is one
//! rigid body, whose momentum for a unit speed is carried inward and read off at every speed that it passes.

use super::{column::Column, shortcut::Shortcuts, speed_matrix};
use crate::{
    expr::{Axis, ExprGraph, Purpose, Vector},
    given::mechanics,
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            inertia::{self, Composite},
            linkage::Linkage,
            passage::{Drive, Passenger},
            rotation::Turn,
        },
        plan::Plan,
    },
    solve::{SpeedMatrix, zero_matrix},
    tree::{Motion, Tree},
};

/// `A`, Eq. (42), re-associated along the tree.
pub fn mass_matrix(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> SpeedMatrix {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    matrix(graph, &linkage)
}

/// The same on links that are there.
pub(in crate::recursive) fn matrix(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> SpeedMatrix {
    let Linkage {
        tree,
        links,
        passages,
        ..
    } = linkage;
    graph.begin(Purpose::Composite);
    let mut shortcuts = Shortcuts::new(graph, linkage);
    // Of the inertias what is known before the loop, and the rest.
    let mut known = BodyMap::outward(tree.bodies.len(), |body, _| links[body].inertia.inertia);
    let mut composites = BodyMap::outward(tree.bodies.len(), |body, _| Composite {
        inertia: graph.zero_symmetric(),
        ..links[body].inertia
    });
    let mut columns = BodyMap::outward(tree.bodies.len(), |_, _| Vec::<Column>::new());
    let mut a = zero_matrix(graph, tree.n_speeds);
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let composite = composites[body].with_inertia(graph, &known[body]);
        inertia::name(graph, &composite.inertia, "composite");
        graph.name_vector(composite.moment, "composite");
        let mut carried = Carried {
            tree,
            body,
            composite,
            hinge: None,
            columns: std::mem::take(&mut columns[body]),
            shortcuts: &mut shortcuts,
            a: &mut a,
        };
        passages[body].inward(graph, &mut carried);
        let Carried {
            composite,
            columns: arrived,
            ..
        } = carried;
        if let Some(lower) = tree.lower(body) {
            let (composite, own) = composite.parted(graph);
            graph.hint(|graph| {
                inertia::name(graph, &composite.inertia, "composite_on_lower");
                graph.name_vector(composite.moment, "composite_on_lower");
            });
            graph.enter(lower);
            known[lower] = graph.add_symmetric(&known[lower], &own);
            composites[lower] = composites[lower].plus(graph, &composite);
            columns[lower].extend(arrived);
        }
    }
    a
}

/// The same with the rotors' inertias.
pub(in crate::recursive) fn matrix_with_rotors(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
) -> SpeedMatrix {
    let mut matrix = matrix(graph, linkage);
    mechanics::add_rotors(graph, linkage.tree, &mut matrix);
    matrix
}

/// A composite body and the columns of what it carries, on their way inward through a joint: where a speed moves the body, its
/// column begins, and its row is read off all columns.
struct Carried<'a, 'b> {
    tree: &'a Tree,
    body: BodyId,
    composite: Composite,
    /// The axis of its hinge, along the axes that have been reached.
    hinge: Option<Vector>,
    columns: Vec<Column>,
    shortcuts: &'a mut Shortcuts<'b>,
    a: &'a mut SpeedMatrix,
}

impl Carried<'_, '_> {
    /// Begins a column: the momentum of the composite body for a unit value of a speed.
    fn begin(
        &mut self,
        graph: &mut ExprGraph,
        motion: Motion,
        place: usize,
        momentum: [Vector; 2],
    ) {
        let names = self.tree.body(self.body).joint.motion_names();
        self.columns.push(Column::new(
            graph,
            self.body,
            motion,
            names[place],
            momentum,
        ));
        let last = self.columns.len() - 1;
        for (i, column) in self.columns.iter().enumerate() {
            let entry = column.momentum(place);
            speed_matrix::add_mirrored(graph, self.a, [motion, column.motion], entry, i == last);
        }
    }
}

impl Carried<'_, '_> {
    /// Gets columns ready for a turn about an axis; their linear parts leave on a shortcut, if there is one here.
    fn take_shortcut(&mut self, graph: &mut ExprGraph, axis: Axis) {
        let body = self.body;
        let ends = self.shortcuts.ends(graph, body);
        // The body's own is turned with the composite's first moment, whose product with the axis it is.
        let columns = self.columns.iter_mut();
        let columns = columns.filter(|own| !ends || own.body() != body);
        let shortcut = self.shortcuts.send(graph, (body, axis), columns);
        for column in &mut self.columns {
            column.before_turn(graph, axis, shortcut);
        }
        graph.enter(body);
    }
}

impl Carried<'_, '_> {
    /// Without mass left, half of what an offset adds to the moment of inertia about the hinge's axis is what it adds to the body's
    /// own column along that: where the offset has two components across it, that is the shorter way.
    fn halve(&mut self, graph: &mut ExprGraph, before: &Composite, offset: Vector) {
        let Some(axis) = self.hinge.filter(|_| graph.is_zero(before.mass)) else {
            return;
        };
        let is_there = |i: &usize| !graph.is_zero(axis[*i]);
        let places: Vec<usize> = (0..3).filter(is_there).collect();
        let &[a] = &*places else { return };
        if (0..3).any(|i| i != a && graph.is_zero(offset[i])) {
            return;
        }
        let own = self.columns.iter_mut().find(|own| own.body() == self.body);
        if let Some(column) = own {
            let half = graph.number(0.5);
            let both = graph.add(
                before.inertia.diagonal[a],
                self.composite.inertia.diagonal[a],
            );
            let mean = graph.mul(half, both);
            let along = graph.mul(axis[a], mean);
            column.set_along(graph, a, along);
        }
    }
}

impl Passenger for Carried<'_, '_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        let next = self.shortcuts.next(graph, lower);
        for column in &mut self.columns {
            column.reach(graph, offset, next);
            column.name(graph, self.tree, lower);
        }
        graph.enter(self.body);
        let before = self.composite;
        self.composite = before.moved(graph, offset);
        self.halve(graph, &before, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        for (axis, motion) in drive.motions().into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let momentum = self.composite.turned_about(graph, axis);
            self.begin(graph, motion, axis, momentum);
        }
        if let Drive::Angle(axis, _) = drive {
            self.take_shortcut(graph, axis);
            let hinge = self.tree.body(self.body).joint.hinge_axis();
            self.hinge = hinge.map(|axis| graph.unit_vector(axis.index()));
        }
        self.hinge = self.hinge.map(|axis| rotation.backward(graph, axis));
        self.composite = rotation.backward_composite(graph, &self.composite);
        for column in &mut self.columns {
            column.turn(graph, rotation);
        }
        graph.enter(self.body);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        // Inside a body the translations' columns are read first: they are the sparsest.
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let momentum = self.composite.shifted_along(graph, axis);
            self.begin(graph, motion, 3 + axis, momentum);
        }
    }
}
