//! Operation counts: what users compare and continuous integration pins.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt,
};

use super::{Helper, Instruction, Operation, Program};
use crate::expr::{Binding, CallId, Expr, ExprGraph, Input, Node, NodeId};

/// How many operations of each kind a program performs. Signs, absolute values, copies and stores count nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Multiplications.
    pub mul: usize,
    /// Additions and subtractions.
    pub add: usize,
    /// Divisions.
    pub div: usize,
    /// Sines and cosines: 2 for the `sin_cos` of one angle.
    pub trig: usize,
}

impl Operations {
    /// What a program of these roots would perform in the loop, counted without making it.
    pub fn of(graph: &ExprGraph, roots: &[Expr]) -> Self {
        let needed = graph.reachable(roots);
        let mut operations = Self::default();
        let mut angles = BTreeSet::new();
        let mut calls = BTreeSet::new();
        let is_in_loop = |id: &NodeId| needed[id.index()] && graph.binding(*id) == Binding::State;
        for id in graph.ids().filter(is_in_loop) {
            match graph.node(id) {
                Node::Add(..) => operations.add += 1,
                Node::Mul(..) => operations.mul += 1,
                Node::Div(..) => operations.div += 1,
                Node::Sin(angle) | Node::Cos(angle) => _ = angles.insert(angle),
                Node::Input(Input::CallResult(result)) => {
                    calls.insert(result.call);
                }
                Node::Number(_) | Node::Input(_) | Node::Abs(_) => {}
            }
        }
        operations.trig = 2 * angles.len();
        let mut helpers = BTreeMap::new();
        for CallId { lockstep, call } in calls {
            let of = graph.lockstep(lockstep);
            let helper = of.calls[&call].helper;
            let own = helpers.entry((lockstep, helper));
            let helper = &of.helpers[helper];
            let own = own.or_insert_with(|| Self::of(&helper.graph, &helper.roots));
            operations.add_lanes(helper.lanes, *own);
        }
        operations
    }

    /// Adds what a call performs: all lanes count, those without a column too.
    fn add_lanes(&mut self, lanes: usize, own: Self) {
        self.mul += lanes * own.mul;
        self.add += lanes * own.add;
        self.div += lanes * own.div;
        self.trig += lanes * own.trig;
    }

    /// All operations.
    pub fn total(self) -> usize {
        self.mul + self.add + self.div + self.trig
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            mul,
            add,
            div,
            trig,
        } = self;
        write!(
            f,
            "{} = {mul} mul + {add} add + {div} div + {trig} trig",
            self.total()
        )
    }
}

impl Program {
    /// The operations of the program.
    pub fn operations(&self) -> Operations {
        let mut operations = Operations::default();
        for instruction in &self.instructions {
            match instruction {
                Instruction::SinCos { angles, .. } => operations.trig += 2 * angles.len(),
                Instruction::Compute { operation, .. } => match operation {
                    Operation::Add(..) => operations.add += 1,
                    Operation::Mul(..) => operations.mul += 1,
                    Operation::MulAdd(..) => {
                        operations.mul += 1;
                        operations.add += 1;
                    }
                    Operation::Div(..) => operations.div += 1,
                    Operation::Abs(_) | Operation::Neg(_) => {}
                },
                Instruction::Share { .. } => {}
                Instruction::Call { helper, .. } => {
                    let helper = &self.helpers[*helper];
                    operations.add_lanes(helper.lanes, helper.program.operations());
                }
            }
        }
        operations
    }

    /// How many operations its text has: those of a helper once, however often it is run.
    pub fn written(&self) -> usize {
        let of_helper = |helper: &Helper| helper.program.operations().total();
        let called = self
            .instructions
            .iter()
            .map(|instruction| match instruction {
                Instruction::Call { helper, .. } => {
                    let helper = &self.helpers[*helper];
                    helper.lanes * of_helper(helper)
                }
                _ => 0,
            });
        let helpers: usize = self.helpers.iter().map(of_helper).sum();
        self.operations().total() + helpers - called.sum::<usize>()
    }

    /// How many steps a processor takes that goes through the lanes of a call together: operations, numbers that are stored for
    /// calls, and twice those that they compute, which are stored and read.
    pub fn steps(&self) -> usize {
        let mut steps = self.operations().total();
        for instruction in &self.instructions {
            if let Instruction::Call {
                helper,
                sides,
                results,
                ..
            } = instruction
            {
                let helper = &self.helpers[*helper];
                steps -= (helper.lanes - 1) * helper.program.operations().total();
                steps += sides.iter().flatten().count();
                steps += 2 * results.iter().flatten().flatten().count();
            }
        }
        steps
    }

    /// How many pairs of a multiplication and an addition are fused; both count among [`Self::operations`].
    pub fn fused(&self) -> usize {
        let of_one = |instruction: &Instruction| match instruction {
            Instruction::Compute {
                operation: Operation::MulAdd(..),
                ..
            } => 1,
            Instruction::Call { helper, .. } => {
                let helper = &self.helpers[*helper];
                helper.lanes * helper.program.fused()
            }
            _ => 0,
        };
        self.instructions.iter().map(of_one).sum()
    }
}
