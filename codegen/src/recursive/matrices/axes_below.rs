//! The axes of the joints below a link that stays where it is, along its own axes: where only moments are left, what acts about
//! these can be read off them ahead.
//!
//! A moment that is carried to joints through one point is rotated by each of them for 6 operations, by the last for 3. Read off
//! by an axis that is known along the link's axes it costs 5, and 3 for the next joint's, whose axis is across the link's own.
//! The axes are the same for all that arrives at the link.

use crate::{
    expr::{ExprGraph, Vector},
    id::{BodyId, BodyMap},
    recursive::{
        links::{linkage::Linkage, rotation::Turn},
        technique::Technique,
    },
    tree::Motion,
};

/// A motion about an axis, link components.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct About {
    pub(in crate::recursive) motion: Motion,
    pub(in crate::recursive) axis: Vector,
    /// `v × axis`, with the vector `v` of the axis' link that was asked for.
    pub(in crate::recursive) crossed: Vector,
}

/// The links from which it may be read ahead.
pub(in crate::recursive) struct AxesBelow<'a> {
    linkage: &'a Linkage<'a>,
    /// Links that hinges alone carry, all of whose axes pass through the link's origin.
    is_still: BodyMap<bool>,
    /// A vector of each link, link components, whose products with the link's own axes are asked for.
    vectors: BodyMap<Vector>,
    /// The axes of the link's own joint and of those below, as far as they were asked for.
    axes: BodyMap<Option<Vec<About>>>,
}

impl<'a> AxesBelow<'a> {
    /// With the products of a vector of each link, link components, with its joint's axes: of its angular velocity these are how
    /// fast the axes turn, of the acceleration of its origin what they feel of a first moment.
    pub(in crate::recursive) fn new(
        graph: &ExprGraph,
        linkage: &'a Linkage<'a>,
        vectors: BodyMap<Vector>,
    ) -> Self {
        let Linkage { tree, links, .. } = linkage;
        let is_still = BodyMap::outward(tree.bodies.len(), |body, is_still: &BodyMap<bool>| {
            let is_next = tree.lower(body).is_none_or(|lower| {
                is_still[lower] && graph.is_zero_vector(links[body].passage.offset)
            });
            is_next && tree.body(body).joint.hinge_axis().is_some()
        });
        Self {
            linkage,
            is_still,
            vectors,
            axes: BodyMap::outward(tree.bodies.len(), |_, _| None),
        }
    }

    /// True for a link whose forces no joint below feels.
    pub(in crate::recursive) fn is_still(&self, body: BodyId) -> bool {
        self.is_still[body]
    }

    /// True for a link from which it may be read ahead.
    pub(in crate::recursive) fn may(&self, body: BodyId) -> bool {
        let Linkage { tree, plan, .. } = self.linkage;
        let is_on_still = tree.lower(body).is_some_and(|lower| self.is_still[lower]);
        plan.uses(Technique::Shortcut)
            && is_on_still
            && tree.body(body).joint.hinge_axis().is_some()
    }

    /// The axes of the joints below a link by which so many moments are to be read off, if that is cheaper than to carry these
    /// on.
    pub(in crate::recursive) fn from(
        &mut self,
        graph: &mut ExprGraph,
        body: BodyId,
        n_moments: usize,
    ) -> Option<Vec<About>> {
        let lower = self.linkage.tree.lower(body)?;
        if !self.may(body) || n_moments == 0 {
            return None;
        }
        let carried = self.carried(graph, body);
        let before = graph.len();
        let axes = self.below(graph, body, lower);
        let known = graph.len() - before;
        let read: usize = axes.iter().map(|own| dot(graph, &own.axis)).sum();
        (n_moments * carried > n_moments * read + known).then_some(axes)
    }

    /// The axes of the joints below a link, along its own.
    fn below(&mut self, graph: &mut ExprGraph, body: BodyId, lower: BodyId) -> Vec<About> {
        let axes = self.own(graph, lower);
        graph.enter(body);
        let axes = axes.into_iter();
        axes.map(|own| About {
            motion: own.motion,
            axis: self.to_link(graph, body, own.axis),
            crossed: self.to_link(graph, body, own.crossed),
        })
        .collect()
    }

    /// The axes of a link's own joint and of those below, along its own.
    pub(in crate::recursive) fn own(&mut self, graph: &mut ExprGraph, body: BodyId) -> Vec<About> {
        if let Some(known) = &self.axes[body] {
            return known.clone();
        }
        let tree = self.linkage.tree;
        let joint = &tree.body(body).joint;
        let mut axes = Vec::new();
        for (axis, motion) in joint.turns().into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            graph.enter(body);
            let axis = graph.unit_vector(axis);
            let crossed = graph.cross(self.vectors[body], axis);
            axes.push(About {
                motion,
                axis,
                crossed,
            });
        }
        if let Some(lower) = tree.lower(body) {
            axes.extend(self.below(graph, body, lower));
        }
        self.axes[body] = Some(axes.clone());
        axes
    }

    fn to_link(&self, graph: &mut ExprGraph, body: BodyId, v: Vector) -> Vector {
        let passage = &self.linkage.links[body].passage;
        let v = passage.constant.forward(graph, v);
        passage.forward_from_joint(graph, v)
    }

    /// What it costs to carry a moment on to all joints below a link.
    fn carried(&self, graph: &mut ExprGraph, body: BodyId) -> usize {
        let tree = self.linkage.tree;
        let Some(lower) = tree.lower(body) else {
            return 0;
        };
        let axes = graph.identity();
        let turned = axes.map(|axis| self.to_link(graph, body, axis));
        let costs = turned.map(|axis| dot(graph, &axis));
        if tree.lower(lower).is_some() {
            return costs.iter().sum::<usize>() + self.carried(graph, lower);
        }
        let last = tree.body(lower).joint.hinge_axis();
        last.map_or(0, |axis| costs[axis.index()])
    }
}

/// The operations of a product with a vector of which some components are zero, or one is one.
fn dot(graph: &ExprGraph, axis: &Vector) -> usize {
    let n = axis.iter().filter(|own| !graph.is_zero(**own)).count();
    if n == 1 { 0 } else { 2 * n - 1 }
}
