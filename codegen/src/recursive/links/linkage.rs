//! What every quantity passes through: the links of a plan, and how the motions of their joints are taken.

use std::collections::BTreeSet;

use super::{
    link::{self, Link},
    link_axes::{self, LinkAxes},
    passage::Passage,
};
use crate::{
    expr::ExprGraph,
    id::{BodyMap, SpeedId},
    recursive::plan::Plan,
    tree::Tree,
};

/// The links of a plan, joined.
#[derive(Debug)]
pub(in crate::recursive) struct Linkage<'a> {
    pub(in crate::recursive) tree: &'a Tree,
    pub(in crate::recursive) plan: &'a Plan,
    /// The links move as the speeds say, through passages of their own.
    pub(in crate::recursive) links: BodyMap<Link>,
    /// The axes along which forces and accelerations are taken.
    pub(in crate::recursive) axes: BodyMap<LinkAxes>,
    /// The passages with motions along these: what forces and accelerations pass through.
    pub(in crate::recursive) passages: BodyMap<Passage>,
    /// The bodies that are taken to fall: they feel no gravity, their accelerations are relative to it.
    pub(in crate::recursive) falls: BodyMap<bool>,
}

impl<'a> Linkage<'a> {
    /// Forces and accelerations are those of the speeds, and no body is taken to fall.
    pub(in crate::recursive) fn of_speeds(
        graph: &mut ExprGraph,
        tree: &'a Tree,
        plan: &'a Plan,
    ) -> Self {
        let axes = BodyMap::outward(tree.bodies.len(), |body, _| {
            LinkAxes::of_speeds(&tree.body(body).joint)
        });
        let falls = BodyMap::outward(tree.bodies.len(), |_, _| false);
        Self::along(graph, tree, plan, axes, falls)
    }

    /// As [`Self::of_speeds`], but all bodies are taken to fall: they feel no gravity.
    pub(in crate::recursive) fn weightless(
        graph: &mut ExprGraph,
        tree: &'a Tree,
        plan: &'a Plan,
    ) -> Self {
        let falls = BodyMap::outward(tree.bodies.len(), |_, _| true);
        Self {
            falls,
            ..Self::of_speeds(graph, tree, plan)
        }
    }

    /// Forces and accelerations are those of the motions that are solved for, and of the prescribed speeds.
    pub(in crate::recursive) fn of_solution(
        graph: &mut ExprGraph,
        tree: &'a Tree,
        plan: &'a Plan,
        prescribed: &BTreeSet<SpeedId>,
    ) -> Self {
        let falls = link_axes::falling(tree, plan, prescribed);
        Self::along(graph, tree, plan, solved(tree, plan, prescribed), falls)
    }

    /// The same where nothing has weight.
    pub(in crate::recursive) fn of_solution_without_weight(
        graph: &mut ExprGraph,
        tree: &'a Tree,
        plan: &'a Plan,
        prescribed: &BTreeSet<SpeedId>,
    ) -> Self {
        let falls = BodyMap::outward(tree.bodies.len(), |_, _| false);
        let axes = solved(tree, plan, prescribed);
        Self::along(graph, tree, plan, axes, falls)
    }

    fn along(
        graph: &mut ExprGraph,
        tree: &'a Tree,
        plan: &'a Plan,
        axes: BodyMap<LinkAxes>,
        falls: BodyMap<bool>,
    ) -> Self {
        let links = link::links(graph, tree, plan);
        let passages = BodyMap::outward(tree.bodies.len(), |body, _| {
            let joint = &tree.body(body).joint;
            links[body].passage.clone().with_axes(joint, axes[body])
        });
        Self {
            tree,
            plan,
            links,
            axes,
            passages,
            falls,
        }
    }
}

/// The axes along which motions are solved for.
fn solved(tree: &Tree, plan: &Plan, prescribed: &BTreeSet<SpeedId>) -> BodyMap<LinkAxes> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        LinkAxes::of_solution(&tree.body(body).joint, plan, prescribed)
    })
}
