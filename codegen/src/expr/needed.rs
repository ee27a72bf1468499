//! What some expressions of a graph need, and how often.

use super::{
    graph::ExprGraph,
    lockstep::Met,
    node::{Expr, Input, Node},
};

impl ExprGraph {
    /// How often each node is used: by the nodes that `roots` need, and by the roots themselves; zero for a dead node.
    pub fn uses(&self, roots: &[Expr]) -> Vec<u32> {
        let mut uses = vec![0; self.len()];
        for root in roots {
            uses[root.node().index()] += 1;
        }
        let mut met = Met::default();
        for id in self.ids().rev() {
            if uses[id.index()] == 0 {
                continue;
            }
            let node = self.node(id);
            for operand in node.operands() {
                uses[operand.index()] += 1;
            }
            if let Node::Input(Input::CallResult(result)) = node {
                for read in self
                    .newly_called(result.call, &mut met)
                    .into_iter()
                    .flatten()
                {
                    uses[read.node().index()] += 1;
                }
            }
        }
        uses
    }

    /// For each node, whether `roots` need it.
    pub fn reachable(&self, roots: &[Expr]) -> Vec<bool> {
        self.uses(roots).into_iter().map(|uses| uses > 0).collect()
    }

    /// For each node, whether it depends on such an input, or on what a call returns.
    pub fn varies(&self, is_such: impl Fn(Input) -> bool) -> Vec<bool> {
        let mut varies = vec![false; self.len()];
        for id in self.ids() {
            varies[id.index()] = match self.node(id) {
                Node::Input(input) => is_such(input) || matches!(input, Input::CallResult(_)),
                node => node.operands().any(|operand| varies[operand.index()]),
            };
        }
        varies
    }

    /// How many nodes `roots` need, their own among them.
    pub fn n_needed(&self, roots: &[Expr]) -> usize {
        let needed = self.reachable(roots);
        needed.into_iter().filter(|needed| *needed).count()
    }

    /// How many operations `roots` need.
    pub fn n_operations(&self, roots: &[Expr]) -> usize {
        let needed = self.reachable(roots);
        let needed = self.ids().filter(|id| needed[id.index()]);
        let operations = needed.filter(|id| self.node(*id).operands().next().is_some());
        operations.count()
    }
}
