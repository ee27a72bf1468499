//! What every quantity passes through: the links of a plan, and how the motions of their joints are taken.

use super::{
    axes::{self, Axes},
    link::{self, Link},
    plan::Plan,
};
use crate::{expr::ExprGraph, id::BodyMap, tree::Tree};

/// The links of a plan, joined.
#[derive(Debug)]
pub(super) struct Linkage<'a> {
    pub(super) tree: &'a Tree,
    pub(super) plan: &'a Plan,
    pub(super) links: BodyMap<Link>,
    /// The axes along which motions are taken.
    pub(super) axes: BodyMap<Axes>,
    /// The bodies that are taken to fall: they feel no gravity, their accelerations are relative to it.
    pub(super) falls: BodyMap<bool>,
}

impl<'a> Linkage<'a> {
    /// Motions are those of the speeds, and no body is taken to fall.
    pub(super) fn of_speeds(graph: &mut ExprGraph, tree: &'a Tree, plan: &'a Plan) -> Self {
        Self {
            tree,
            plan,
            links: link::links(graph, tree, plan),
            axes: axes::of_speeds(tree),
            falls: BodyMap::outward(tree.bodies.len(), |_, _| false),
        }
    }

    /// Motions are those that are solved for.
    pub(super) fn of_solution(graph: &mut ExprGraph, tree: &'a Tree, plan: &'a Plan) -> Self {
        Self {
            tree,
            plan,
            links: link::links(graph, tree, plan),
            axes: axes::of_solution(tree, plan),
            falls: axes::falling(tree, plan),
        }
    }
}
