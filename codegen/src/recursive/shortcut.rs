//! Shortcuts for the columns of a mass matrix to a root that translates.
//!
//! The linear part of a column is needed for the levers of the offsets that it passes, and where the root's translations are
//! read, in axes that do not turn with the root. Once the last offset is passed it can go there at once: one rotation by a
//! matrix that all columns of the link share, in place of one at every joint on the way.

use super::{column::Column, linkage::Linkage, plan::Technique, rotation::Turn};
use crate::{
    expr::{ExprGraph, Matrix},
    id::{BodyId, BodyMap},
};

/// The links from which a column's linear part can go to the root's translations.
pub(super) struct Shortcuts<'a> {
    linkage: &'a Linkage<'a>,
    is_open: BodyMap<bool>,
    /// The axes along which the root translates, by rows, in link components: as far as they were asked for.
    directions: BodyMap<Option<Matrix>>,
}

impl<'a> Shortcuts<'a> {
    pub(super) fn new(graph: &ExprGraph, linkage: &'a Linkage<'a>) -> Self {
        let Linkage {
            tree, links, axes, ..
        } = linkage;
        // Open: the link's joint only turns, and what is below has no offset up to the root.
        let is_open = BodyMap::outward(tree.bodies.len(), |body, is_open: &BodyMap<bool>| {
            let Some(lower) = tree.lower(body) else {
                return false;
            };
            let only_turns = tree.body(body).joint.hinge_axis().is_some();
            let is_next = match tree.lower(lower) {
                None => {
                    let shifts = tree.body(lower).joint.shifts();
                    shifts.iter().all(Option::is_some) && axes[lower].shift_before_turns()
                }
                Some(_) => is_open[lower] && graph.is_zero_vector(links[lower].passage.offset),
            };
            linkage.plan.uses(Technique::Shortcut) && only_turns && is_next
        });
        Self {
            linkage,
            is_open,
            directions: BodyMap::outward(tree.bodies.len(), |_, _| None),
        }
    }

    /// Sends the linear parts of columns that have arrived at a link, in its axes, to the root's translations, if that is
    /// cheaper than to carry them on.
    pub(super) fn take(&mut self, graph: &mut ExprGraph, body: BodyId, columns: &mut [Column]) {
        let n_columns = columns.iter().filter(|own| !own.has_arrived()).count();
        if !self.is_open[body] || !self.is_cheaper(graph, body, n_columns) {
            return;
        }
        graph.enter(body);
        let passage = &self.linkage.links[body].passage;
        let offset = passage.constant.forward(graph, passage.offset);
        let offset = passage.forward_from_joint(graph, offset);
        graph.name_vector(offset, "offset_turned");
        let directions = self.directions(graph, body);
        for column in columns.iter_mut().filter(|own| !own.has_arrived()) {
            column.arrive(graph, offset, &directions);
        }
        graph.enter(body);
    }

    /// A rotation costs a vector 6 operations, three of them, for the directions, 18; an offset along one axis across the
    /// joint's has two parts when turned, so that each lever costs 4 more.
    fn is_cheaper(&self, graph: &mut ExprGraph, body: BodyId, n_columns: usize) -> bool {
        let joint = &self.linkage.tree.body(body).joint;
        let Some(axis) = joint.hinge_axis() else {
            return false;
        };
        let passage = &self.linkage.links[body].passage;
        let offset = passage.constant.forward(graph, passage.offset);
        let (b, c) = axis.others();
        let n_across = [b, c]
            .into_iter()
            .filter(|i| !graph.is_zero(offset[*i]))
            .count();
        match n_across {
            0 => 6 * n_columns > 18,
            1 => 2 * n_columns > 20,
            _ => 6 * n_columns > 24,
        }
    }

    fn directions(&mut self, graph: &mut ExprGraph, body: BodyId) -> Matrix {
        if let Some(known) = self.directions[body] {
            return known;
        }
        let passage = &self.linkage.links[body].passage;
        let directions = match self.linkage.tree.lower(body) {
            None => {
                graph.enter(body);
                let axes = graph.identity();
                axes.map(|axis| passage.forward_from_joint(graph, axis))
            }
            Some(lower) => {
                let below = self.directions(graph, lower);
                graph.enter(body);
                below.map(|direction| {
                    let direction = passage.constant.forward(graph, direction);
                    passage.forward_from_joint(graph, direction)
                })
            }
        };
        graph.name_matrix(&directions, "direction");
        self.directions[body] = Some(directions);
        directions
    }
}
