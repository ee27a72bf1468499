//! Shortcuts for what passes inward in columns, past the last offset on the way.
//!
//! The linear part of a column is needed for the levers of the offsets that it passes, and where the root's translations are
//! read, in axes that do not turn with the root. The last offset can be passed before the joint is, for it can be had along
//! the link's axes: then the linear part goes to the root's translations at once, by one rotation that all columns of the link
//! share, in place of one at every joint on the way; or, where the root has none, nowhere.

use crate::{
    expr::{Axis, ExprGraph, Matrix, Vector},
    id::{BodyId, BodyMap},
    recursive::{
        links::{linkage::Linkage, rotation::Turn},
        technique::Technique,
    },
};

/// The links from which a column's linear part can leave.
pub(in crate::recursive) struct Shortcuts<'a> {
    linkage: &'a Linkage<'a>,
    /// To the root's translations.
    is_open: BodyMap<bool>,
    /// Links whose origins stay where they are.
    is_still: BodyMap<bool>,
    /// The axes along which the root translates, by rows, in link components: as far as they were asked for.
    directions: BodyMap<Option<Matrix>>,
}

/// A shortcut from a link.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Shortcut {
    /// From the lower link's origin, along the link's axes.
    pub(in crate::recursive) offset: Vector,
    /// How many components it has across the joint's axis before it is turned.
    pub(in crate::recursive) n_across: usize,
    /// The axes along which the root translates, by rows, in link components; `None` where it does not.
    pub(in crate::recursive) directions: Option<Matrix>,
}

impl Shortcut {
    /// What is read where the root translates.
    pub(in crate::recursive) fn arrived(&self, graph: &mut ExprGraph, linear: Vector) -> Vector {
        match &self.directions {
            Some(directions) => graph.mul_vector(directions, linear),
            None => graph.zero_vector(),
        }
    }

    /// Sends the columns that may leave, before a turn about an axis.
    pub(in crate::recursive) fn take<'c, C: Sent + 'c>(
        &self,
        graph: &mut ExprGraph,
        axis: Axis,
        columns: impl IntoIterator<Item = &'c mut C>,
    ) {
        for column in columns {
            if column.stays(graph) {
                column.depart(graph, self, axis);
            }
        }
    }
}

/// A column of which forces, or linear momenta, leave on a shortcut.
pub(in crate::recursive) trait Sent {
    /// How many of them a rotation would have to turn.
    const N_FORCES: usize;

    /// True as long as they may leave.
    fn stays(&self, graph: &ExprGraph) -> bool;

    /// Sends them, before a turn about an axis.
    fn depart(&mut self, graph: &mut ExprGraph, shortcut: &Shortcut, axis: Axis);
}

/// What meets a column that has come to a link.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Next {
    /// The axis of the link's joint, if it is a hinge.
    pub(in crate::recursive) hinge: Option<Axis>,
    /// True where there may be a shortcut.
    pub(in crate::recursive) leaves: bool,
}

impl Next {
    /// Of which nothing is known: all of a moment is wanted.
    pub(in crate::recursive) const UNKNOWN: Self = Self {
        hinge: None,
        leaves: false,
    };
}

impl<'a> Shortcuts<'a> {
    pub(in crate::recursive) fn new(graph: &ExprGraph, linkage: &'a Linkage<'a>) -> Self {
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
        let is_still = BodyMap::outward(tree.bodies.len(), |body, is_still: &BodyMap<bool>| {
            let shifts = tree.body(body).joint.shifts();
            let is_next = match tree.lower(body) {
                None => true,
                Some(lower) => is_still[lower] && graph.is_zero_vector(links[body].passage.offset),
            };
            is_next && shifts.iter().all(Option::is_none)
        });
        Self {
            linkage,
            is_open,
            is_still,
            directions: BodyMap::outward(tree.bodies.len(), |_, _| None),
        }
    }

    /// True for a link from which there may be a shortcut.
    pub(in crate::recursive) fn may(&self, graph: &ExprGraph, body: BodyId) -> bool {
        self.is_open[body] || self.ends(graph, body)
    }

    /// What meets a column at a link.
    pub(in crate::recursive) fn next(&self, graph: &ExprGraph, body: BodyId) -> Next {
        Next {
            hinge: self.linkage.tree.body(body).joint.hinge_axis(),
            leaves: self.may(graph, body),
        }
    }

    /// The shortcut from a link for so many linear parts, if that is cheaper than to carry them on.
    fn from(&mut self, graph: &mut ExprGraph, body: BodyId, n_vectors: usize) -> Option<Shortcut> {
        let ends = self.ends(graph, body);
        if !(self.is_open[body] || ends) || !self.is_cheaper(graph, body, n_vectors, ends) {
            return None;
        }
        graph.enter(body);
        let passage = &self.linkage.links[body].passage;
        let n_across = self.n_across(graph, body)?;
        let offset = passage.constant.forward(graph, passage.offset);
        let offset = passage.forward_from_joint(graph, offset);
        graph.name_vector(offset, "offset_turned");
        let directions = (!ends).then(|| self.directions(graph, body));
        graph.enter(body);
        Some(Shortcut {
            offset,
            n_across,
            directions,
        })
    }

    /// True for the last offset on the way to a root that does not translate.
    pub(in crate::recursive) fn ends(&self, graph: &ExprGraph, body: BodyId) -> bool {
        let Linkage { tree, links, .. } = self.linkage;
        let only_turns = tree.body(body).joint.hinge_axis().is_some();
        self.linkage.plan.uses(Technique::Shortcut)
            && only_turns
            && tree.lower(body).is_some_and(|lower| self.is_still[lower])
            && !graph.is_zero_vector(links[body].passage.offset)
    }

    /// How many components the offset has across the joint's axis.
    fn n_across(&self, graph: &mut ExprGraph, body: BodyId) -> Option<usize> {
        let axis = self.linkage.tree.body(body).joint.hinge_axis()?;
        let passage = &self.linkage.links[body].passage;
        let offset = passage.constant.forward(graph, passage.offset);
        let (b, c) = axis.others();
        let across = [b, c].into_iter();
        Some(across.filter(|i| !graph.is_zero(offset[*i])).count())
    }

    /// A rotation costs a vector 6 operations, three of them, for the directions, 18; an offset along one axis across the
    /// joint's has two parts when turned, so that each lever costs 2 more about the joint's axis.
    fn is_cheaper(
        &self,
        graph: &mut ExprGraph,
        body: BodyId,
        n_vectors: usize,
        ends: bool,
    ) -> bool {
        let Some(n_across) = self.n_across(graph, body) else {
            return false;
        };
        let directions = if ends { 0 } else { 18 };
        match n_across {
            0 => 6 * n_vectors > directions,
            1 => 4 * n_vectors > directions + 2,
            _ => 6 * n_vectors > directions + 6,
        }
    }

    /// Sends columns on the shortcut from a link before its turn about an axis, if there is one that pays.
    pub(in crate::recursive) fn send<'c, C: Sent + 'c>(
        &mut self,
        graph: &mut ExprGraph,
        (body, axis): (BodyId, Axis),
        columns: impl Iterator<Item = &'c mut C>,
    ) -> Option<Shortcut> {
        let columns: Vec<_> = columns.collect();
        let shortcut = self.for_columns(graph, body, columns.iter().map(|own| &**own))?;
        shortcut.take(graph, axis, columns);
        Some(shortcut)
    }

    /// The shortcut from a link for columns, if there is one that pays.
    pub(in crate::recursive) fn for_columns<'c, C: Sent + 'c>(
        &mut self,
        graph: &mut ExprGraph,
        body: BodyId,
        columns: impl Iterator<Item = &'c C>,
    ) -> Option<Shortcut> {
        let n_columns = columns.filter(|own| own.stays(graph)).count();
        self.from(graph, body, C::N_FORCES * n_columns)
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
