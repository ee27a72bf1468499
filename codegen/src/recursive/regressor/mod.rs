//! Forces as they are linear in inertial parameters: the wrenches that a unit of each parameter needs are carried inward, and
//! every speed reads its entry off them.
//!
//! First moments need forces and moments, inertias moments alone, which no offset changes. What a joint does not move of a
//! body's inertia needs as much as if the lower body had it: its columns are sums of that body's (`shared`), and are not carried.
//! A body's `own` columns are those of its own parameters.

mod column;
mod order;
mod own;
mod shared;

use self::{column::UnitColumn, own::OnHinge, shared::Shared};
use super::{
    links::{
        link_motion,
        linkage::Linkage,
        passage::{Drive, Passenger},
        rotation::Turn,
    },
    matrices::{
        axes_below::{About, AxesBelow},
        shortcut::{Shortcut, Shortcuts},
    },
    plan::Plan,
    technique::Technique,
};
use crate::{
    expr::{Axis, Expr, ExprGraph, Purpose, Vector},
    given::Accelerations,
    id::{BodyId, BodyMap, SpeedId},
    tree::{InertialParameter, Motion, N_INERTIAL, Tree, regressor_place},
};

/// For each speed, body and parameter what `tau` has of it.
pub fn regressor(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let mut own = ExprGraph::default();
    let entries = entries(&mut own, tree, plan);
    order::by_columns(graph, &own, &entries, tree.bodies.len() * N_INERTIAL)
}

/// The same, from body to body inward.
fn entries(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let tree = &*tree.with_whole_weights();
    let shared = shared::shared(graph, tree, plan);
    let whole = plan.with(Technique::Regroup, false);
    let linkage = Linkage::of_speeds(graph, tree, &whole);
    let motions = link_motion::motions(graph, &linkage, Accelerations::Given);
    graph.begin(Purpose::Regressor);
    let felt = BodyMap::outward(tree.bodies.len(), |body, _| motions[body].a);
    let mut ahead = AxesBelow::new(graph, &linkage, felt);
    let mut columns = BodyMap::outward(tree.bodies.len(), |body, _| {
        let link = &linkage.links[body];
        let is_weighed = is_weighed(&ahead, &shared, body);
        let is_carried = |parameter: &usize| {
            let is_first_moment = InertialParameter::MOMENTS.contains(parameter);
            !(shared[body].gives(*parameter) || is_weighed && is_first_moment)
        };
        own::columns(graph, tree, (body, link), &motions[body], is_carried)
    });
    let mut shortcuts = Shortcuts::new(graph, &linkage);
    let mut y = vec![graph.zero(); tree.n_speeds * tree.bodies.len() * N_INERTIAL];
    for body in tree.body_ids().rev() {
        let hinge = shared[body].hinge_axis();
        let mut carried = Carried {
            tree,
            body,
            hinge: hinge.and_then(|own| OnHinge::new(graph, &linkage, body, &motions, own)),
            columns: std::mem::take(&mut columns[body]),
            shortcuts: &mut shortcuts,
            ahead: &mut ahead,
            y: &mut y,
        };
        linkage.passages[body].inward(graph, &mut carried);
        let arrived = carried.columns;
        if let Some(lower) = tree.lower(body) {
            columns[lower].extend(arrived);
        }
    }
    for body in tree.body_ids() {
        graph.enter(body);
        if is_weighed(&ahead, &shared, body) {
            let axes = ahead.own(graph, body);
            graph.enter(body);
            own::weigh(graph, &linkage, body, &shared[body], &axes, &mut y);
        }
        shared[body].fill(graph, tree, body, &mut y);
    }
    y
}

/// True for a link that feels nothing but weight where its axis is, about which its user's first moments are then read.
fn is_weighed(ahead: &AxesBelow<'_>, shared: &BodyMap<Shared>, body: BodyId) -> bool {
    ahead.is_still(body) && shared[body].hinge_axis().is_some()
}

/// Unit columns on their way inward through a joint, whose motions read off them what acts along them.
struct Carried<'a, 'b> {
    tree: &'a Tree,
    body: BodyId,
    /// Where the body's own columns are turned in a shorter way.
    hinge: Option<OnHinge>,
    columns: Vec<UnitColumn>,
    shortcuts: &'a mut Shortcuts<'b>,
    ahead: &'a mut AxesBelow<'b>,
    y: &'a mut [Expr],
}

impl Carried<'_, '_> {
    /// Reads off what acts about (from 0) or along (from 3) axes.
    fn read_off(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3], first: usize) {
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(Motion { speed, factor }) = motion else {
                continue;
            };
            let factor = graph.number(factor);
            for own in &self.columns {
                graph.enter(own.body);
                let share = graph.mul(factor, own.needed.read(first + axis));
                add(graph, self.tree, own, (speed, share), self.y);
            }
        }
    }

    /// Reads off what joints below feel of moments alone, if that is cheaper than to carry them there.
    fn read_ahead(&mut self, graph: &mut ExprGraph, axis: Axis, shortcut: Option<Shortcut>) {
        if !self.ahead.may(self.body) {
            return;
        }
        let no_force = self.ahead.is_still(self.body);
        let columns = std::mem::take(&mut self.columns);
        let (mut moments, others): (Vec<_>, Vec<_>) = columns.into_iter().partition(|own| {
            let departs =
                own.needed.is_departing(graph) && !own.needed.is_sparse_across(graph, axis);
            no_force || departs || !own.needed.has_force(graph)
        });
        self.columns = others;
        let Some(axes) = self.ahead.from(graph, self.body, moments.len()) else {
            self.columns.extend(moments);
            return;
        };
        for own in &mut moments {
            graph.enter(own.body);
            own.needed.settle_past(graph, shortcut, axis);
            for &About { motion, axis, .. } in &axes {
                let along = graph.dot(axis, own.needed.wrench.moment);
                let factor = graph.number(motion.factor);
                let share = graph.mul(factor, along);
                add(graph, self.tree, own, (motion.speed, share), self.y);
            }
        }
    }
}

/// Adds to a column's entry of a speed.
fn add(
    graph: &mut ExprGraph,
    tree: &Tree,
    column: &UnitColumn,
    (speed, share): (SpeedId, Expr),
    y: &mut [Expr],
) {
    let entry = &mut y[regressor_place(tree, speed.index(), column.body, column.parameter)];
    *entry = graph.add(*entry, share);
}

impl Passenger for Carried<'_, '_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        let next = self.shortcuts.next(graph, lower);
        let at = &self.tree.body(lower).identifier;
        for own in &mut self.columns {
            graph.enter(own.body);
            own.needed.reach(graph, offset, next);
            let name = InertialParameter::NAMES[own.parameter];
            graph.name_vector(own.needed.wrench.force, &format!("{name}_f_{at}"));
            graph.name_vector(own.needed.wrench.moment, &format!("{name}_n_{at}"));
        }
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.read_off(graph, drive.motions(), 0);
        if let Drive::Angle(axis, _) = drive {
            let at = (self.body, axis);
            let shortcut = self.shortcuts.send(graph, at, self.columns.iter_mut());
            self.read_ahead(graph, axis, shortcut);
            for own in &mut self.columns {
                graph.enter(own.body);
                own.needed.before_turn(graph, axis, shortcut);
            }
        }
        let before: Vec<Vector> = self
            .columns
            .iter()
            .map(|own| own.needed.wrench.moment)
            .collect();
        for own in &mut self.columns {
            graph.enter(own.body);
            own.needed.turn(graph, rotation);
        }
        if let (Drive::Angle(..), Some(hinge)) = (drive, &self.hinge) {
            hinge.shorten(graph, &mut self.columns, &before, rotation);
        }
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        self.read_off(graph, motions, 3);
    }
}
