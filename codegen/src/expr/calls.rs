//! Calls of a graph. What they compute are inputs of it, which are made after all that the call reads.

use std::{collections::BTreeMap, sync::Arc};

use super::{
    graph::ExprGraph,
    lockstep::{Call, Helper, Lockstep, Met},
    node::{CallId, CallResult, Expr, Input, Node, NodeId},
};

impl ExprGraph {
    /// One more than the last number that a lockstep has; [`Self::take_call`] adds those of another graph.
    ///
    /// # Panics
    /// For the 65,537th of a graph.
    pub fn next_lockstep(&self) -> u16 {
        let last = self.locksteps.last_key_value();
        last.map_or(0, |(last, _)| {
            last.checked_add(1).expect("expr: a lockstep a function")
        })
    }

    /// Adds helpers, and what all columns share, under a number that is free.
    pub fn add_lockstep(
        &mut self,
        number: u16,
        shared: Vec<Expr>,
        helpers: Vec<Arc<Helper<Self>>>,
    ) {
        let lockstep = Lockstep {
            shared,
            helpers,
            calls: BTreeMap::new(),
        };
        let known = self.locksteps.insert(number, lockstep);
        assert!(known.is_none(), "expr: lockstep {number} is there already");
    }

    /// Calls a helper on columns.
    ///
    /// # Panics
    /// For the 65,537th call of a lockstep.
    pub fn add_call(&mut self, lockstep: u16, call: Call) -> CallId {
        let own = self.locksteps.get_mut(&lockstep);
        let of = own.expect("expr: a lockstep is there before its calls");
        let number = u16::try_from(of.calls.len()).expect("expr: calls are numbered in 16 bits");
        of.calls.insert(number, call);
        CallId {
            lockstep,
            call: number,
        }
    }

    /// What a call computes of a lane, by its place.
    ///
    /// # Panics
    /// For the 65,537th number that a helper computes.
    pub fn call_result(&mut self, call: CallId, lane: usize, place: usize) -> Expr {
        let narrow = |number: usize| u16::try_from(number).expect("expr: 65,536 numbers a column");
        self.input(Input::CallResult(CallResult {
            call,
            lane: narrow(lane),
            place: narrow(place),
        }))
    }

    /// A lockstep of the graph.
    pub fn lockstep(&self, number: u16) -> &Lockstep<Self> {
        &self.locksteps[&number]
    }

    /// Changes every helper, each once.
    pub fn change_helpers(
        &mut self,
        change: impl Fn(&ExprGraph, &[Expr]) -> (ExprGraph, Vec<Expr>),
    ) {
        let mut changed: Vec<[Arc<Helper<Self>>; 2]> = Vec::new();
        let own = self.locksteps.values_mut();
        for helper in own.flat_map(|lockstep| &mut lockstep.helpers) {
            let known = changed.iter().find(|[old, _]| Arc::ptr_eq(old, helper));
            let new = known.map(|[_, new]| Arc::clone(new));
            *helper = new.unwrap_or_else(|| {
                let (graph, roots) = change(&helper.graph, &helper.roots);
                let lanes = helper.lanes;
                let new = Arc::new(Helper {
                    lanes,
                    graph,
                    roots,
                });
                changed.push([Arc::clone(helper), Arc::clone(&new)]);
                new
            });
        }
    }

    /// All that a call reads: what is shared, and what is of its columns.
    pub fn read_by(&self, call: CallId) -> impl Iterator<Item = Expr> + use<'_> {
        let of = self.lockstep(call.lockstep);
        let shared = of.shared.iter().copied();
        shared.chain(of.calls[&call.call].operands())
    }

    /// What calls read that compute some of these nodes, each once.
    pub fn called(&self, is_needed: impl Fn(NodeId) -> bool) -> Vec<Expr> {
        let mut met = Met::default();
        let results = self.ids().filter_map(|id| match self.node(id) {
            Node::Input(Input::CallResult(result)) if is_needed(id) => Some(result),
            _ => None,
        });
        let calls = results.filter_map(|result| self.newly_called(result.call, &mut met));
        calls.flatten().collect()
    }

    /// What the call reads; `None` where it was met before.
    pub(super) fn newly_called(
        &self,
        call: CallId,
        met: &mut Met,
    ) -> Option<impl Iterator<Item = Expr> + use<'_>> {
        if !met.calls.insert(call) {
            return None;
        }
        let of = self.lockstep(call.lockstep);
        let is_first = met.locksteps.insert(call.lockstep);
        let shared = of.shared.iter().filter(move |_| is_first).copied();
        Some(shared.chain(of.calls[&call.call].operands()))
    }

    /// Takes a call of another graph over, on what stands here for its operands, unless it is there.
    pub fn take_call(
        &mut self,
        other: &Self,
        CallId { lockstep, call }: CallId,
        of: impl Fn(Expr) -> Expr,
    ) {
        let theirs = other.lockstep(lockstep);
        let own = self.locksteps.entry(lockstep);
        let own = own.or_insert_with(|| Lockstep {
            shared: theirs.shared.iter().map(|expr| of(*expr)).collect(),
            helpers: theirs.helpers.clone(),
            calls: BTreeMap::new(),
        });
        own.calls.entry(call).or_insert_with(|| {
            let Call { helper, sides } = &theirs.calls[&call];
            Call {
                helper: *helper,
                sides: sides
                    .iter()
                    .map(|row| row.iter().map(|own| of(*own)).collect())
                    .collect(),
            }
        });
    }
}
