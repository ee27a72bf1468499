//! The way between a frame and who sees it: the inertial frame, or another.

use super::reach::{Reach, path};
use crate::{
    expr::ExprGraph,
    id::{BodyId, BodyMap},
    recursive::links::{
        link::Link,
        passage::{Passage, Passenger},
        root,
        rotation::Turn,
    },
    tree::{NamedFrame, Tree},
};

/// The links between a frame and who sees it.
pub(super) struct Between<'a> {
    tree: &'a Tree,
    links: &'a BodyMap<Link>,
    /// Those that carry the frame alone, from it inward.
    pub(super) ahead: Vec<BodyId>,
    /// Those that carry who sees it alone, likewise.
    pub(super) behind: Vec<BodyId>,
    /// How the frame's own link is reached, if not as the link says.
    last: Option<Passage>,
}

impl<'a> Between<'a> {
    pub(super) fn new(
        tree: &'a Tree,
        links: &'a BodyMap<Link>,
        frame: NamedFrame,
        from: Option<NamedFrame>,
    ) -> Self {
        let mut ahead = path(tree, frame);
        let mut behind = from.map_or_else(Vec::new, |from| path(tree, from));
        while ahead.last().is_some() && ahead.last() == behind.last() {
            ahead.pop();
            behind.pop();
        }
        Self {
            tree,
            links,
            ahead,
            behind,
            last: None,
        }
    }

    /// The same with the frame's link turned about its joint until the frame's axes are sparse there, and the frame in it.
    pub(super) fn aligned(
        graph: &mut ExprGraph,
        tree: &'a Tree,
        links: &'a BodyMap<Link>,
        frame: NamedFrame,
        from: Option<NamedFrame>,
    ) -> (Self, Reach) {
        let mut way = Self::new(tree, links, frame, from);
        let reach = Reach::of(graph, tree, links, frame);
        let Some(&body) = way.ahead.first() else {
            return (way, reach);
        };
        graph.enter(body);
        let Some(phased) = links[body].phased(graph, &reach.axes) else {
            return (way, reach);
        };
        let aligned = Reach {
            axes: phased.axes,
            position: phased.turn.forward(graph, reach.position),
        };
        way.last = Some(phased.passage);
        (way, aligned)
    }

    fn passage(&self, body: BodyId) -> &Passage {
        let is_last = self.ahead.first() == Some(&body);
        let last = self.last.as_ref().filter(|_| is_last);
        last.unwrap_or(&self.links[body].passage)
    }

    /// Through a joint inward; from a link on the inertial frame to the inertial origin.
    pub(super) fn inward(
        &self,
        graph: &mut ExprGraph,
        body: BodyId,
        passenger: &mut impl Passenger,
    ) {
        graph.enter(body);
        self.passage(body).inward(graph, passenger);
        if self.tree.lower(body).is_none() {
            let origin = root::origin(graph, self.tree, &self.links[body], body);
            passenger.shift(graph, body, origin);
        }
    }

    /// The same outward.
    pub(super) fn outward(
        &self,
        graph: &mut ExprGraph,
        body: BodyId,
        passenger: &mut impl Passenger,
    ) {
        if self.tree.lower(body).is_none() {
            let origin = root::origin(graph, self.tree, &self.links[body], body);
            passenger.shift(graph, body, origin);
        }
        graph.enter(body);
        self.passage(body).outward(graph, passenger);
    }

    /// Where who sees the frame stands in its link.
    pub(super) fn view(&self, graph: &mut ExprGraph, from: Option<NamedFrame>) -> Reach {
        match from {
            Some(from) => Reach::of(graph, self.tree, self.links, from),
            None => Reach {
                axes: graph.identity(),
                position: graph.zero_vector(),
            },
        }
    }
}
