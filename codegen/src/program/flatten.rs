//! From a graph to a program: dead nodes drop out, the order of derivation stays, signs find their place.
//!
//! A difference may be computed either way round: as its label means it, or as it was written. A sum of two negatives
//! is computed as their sum. The sign then passes on to what uses the value and ends in a subtraction or a store.
//! Sines and cosines are taken first, all angles together.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use super::{Definition, Helper, Instruction, Operand, Operation, Program, ValueFacts, ValueId};
use crate::{
    expr::{self, CallId, CallResult, Expr, ExprGraph, Input, Node, NodeId},
    id::BodyId,
};

/// The program that stores `roots`.
pub fn flatten(graph: &ExprGraph, roots: &[Expr]) -> Program {
    let needed = graph.reachable(roots);
    // What calls read is stored for them.
    let mut stored_roots = graph.called(|id| needed[id.index()]);
    stored_roots.extend(roots);
    let stored = stored(graph, &stored_roots);
    let mut flattening = Flattening {
        graph,
        sines: sines(graph, &needed),
        wanted: wanted_signs(graph, &stored),
        stored,
        results: results(graph, &needed),
        needed,
        shared: BTreeSet::new(),
        helpers: Vec::new(),
        operands: vec![None; graph.len()],
        program: Program {
            values: Vec::new(),
            instructions: Vec::new(),
            stores: Vec::new(),
            helpers: Vec::new(),
        },
    };
    flattening.ready_sines();
    for id in graph.ids() {
        flattening.flatten(id);
    }
    let stores = roots.iter().map(|&root| flattening.expr(root)).collect();
    Program {
        stores,
        ..flattening.program
    }
}

struct Flattening<'a> {
    graph: &'a ExprGraph,
    needed: Vec<bool>,
    /// The sines and cosines that are needed, by their angle.
    sines: BTreeMap<NodeId, Vec<NodeId>>,
    /// For each node, whether its negative is wanted.
    wanted: Vec<bool>,
    /// For each node that is stored, whether its negative is.
    stored: Vec<Option<bool>>,
    /// What is needed of each call that was not made yet.
    results: BTreeMap<CallId, Vec<(CallResult, NodeId)>>,
    /// The locksteps whose shared values were told.
    shared: BTreeSet<u16>,
    /// The helpers that are among the program's, in their order.
    helpers: Vec<Arc<expr::Helper<ExprGraph>>>,
    /// The nodes already flattened, as signed values.
    operands: Vec<Option<Operand>>,
    program: Program,
}

impl Flattening<'_> {
    fn expr(&self, expr: Expr) -> Operand {
        let operand = self.operands[expr.node().index()].expect("program: operands come first");
        if expr.is_negative() {
            -operand
        } else {
            operand
        }
    }

    /// A new value that is the node or, where `negative`, its negative, under the node's label.
    fn value(&mut self, definition: Definition, id: NodeId, negative: bool) -> ValueId {
        let label = self.graph.label(id).map(|label| {
            let same = label.negative == negative;
            if same {
                label.text.clone()
            } else {
                format!("minus_{}", label.text)
            }
        });
        self.labelled(definition, id, label)
    }

    fn labelled(&mut self, definition: Definition, id: NodeId, label: Option<String>) -> ValueId {
        let value =
            u32::try_from(self.program.values.len()).expect("program: fewer than 2^32 values");
        self.program.values.push(ValueFacts {
            definition,
            scope: self.graph.scope(id),
            purpose: self.graph.purpose(id),
            label,
        });
        ValueId(value)
    }

    /// Flattens a node that is needed, unless it is there already; its operands are.
    fn flatten(&mut self, id: NodeId) {
        if self.needed[id.index()] && self.operands[id.index()].is_none() {
            let operand = self.node(id);
            self.operands[id.index()] = Some(operand);
        }
    }

    fn node(&mut self, id: NodeId) -> Operand {
        let of = |id| Expr::of(id);
        match self.graph.node(id) {
            Node::Number(bits) => Operand::Number(f64::from_bits(bits)),
            Node::Input(Input::CallResult(result)) => {
                self.call(result.call);
                self.operands[id.index()].expect("program: a call holds what is needed of it")
            }
            Node::Input(input) => Operand::Value {
                id: self.value(Definition::Input(input), id, false),
                negative: false,
            },
            Node::Sin(angle) | Node::Cos(angle) => {
                self.sin_cos(&[angle]);
                self.operands[id.index()].expect("program: the sines of an angle hold its node")
            }
            Node::Abs(a) => {
                let a = self.expr(of(a));
                self.compute(id, Operation::Abs(unsigned(a)), false)
            }
            Node::Mul(a, b) => {
                let (a, b, negative) = self.factors(id, a, b);
                self.compute(id, Operation::Mul(a, b), negative)
            }
            Node::Div(a, b) => {
                let (a, b, negative) = self.factors(id, a, b);
                self.compute(id, Operation::Div(a, b), negative)
            }
            Node::Add(a, b) => self.sum(id, a, b),
        }
    }

    /// The operands of a product or quotient, and whether they make the node's negative. A number takes the sign that is
    /// wanted, so that the text does not depend on whether a constant of the model is positive.
    fn factors(&self, id: NodeId, a: NodeId, b: NodeId) -> (Operand, Operand, bool) {
        let (a, b) = (self.expr(Expr::of(a)), self.expr(Expr::of(b)));
        let (natural, wanted) = (a.is_negative() ^ b.is_negative(), self.wanted[id.index()]);
        match a {
            Operand::Number(_) if natural != wanted => (-a, unsigned(b), wanted),
            _ => (unsigned(a), unsigned(b), natural),
        }
    }

    /// Where an operand stands in a sum whose order is free.
    fn rank(&self, operand: Operand) -> (bool, Option<BodyId>) {
        match operand.value() {
            Some(value) => (false, self.program.value(value).scope),
            None => (true, None),
        }
    }

    fn sum(&mut self, id: NodeId, a: Expr, b: Expr) -> Operand {
        let (a, b) = (self.expr(a), self.expr(b));
        let has_number = matches!((a, b), (Operand::Number(_), _) | (_, Operand::Number(_)));
        let same_sign = a.is_negative() == b.is_negative();
        // Two values of one sign leave no choice.
        let negative = if same_sign && !has_number {
            a.is_negative()
        } else {
            self.wanted[id.index()]
        };
        let (a, b) = if negative { (-a, -b) } else { (a, b) };
        // A value before a number, what is subtracted last, and else the body further inward first.
        let swap = a.is_negative() || !b.is_negative() && self.rank(b) < self.rank(a);
        let (a, b) = if swap { (b, a) } else { (a, b) };
        self.compute(id, Operation::Add(a, b), negative)
    }

    /// One operation, whose result is the node or, where `negative`, its negative.
    fn compute(&mut self, id: NodeId, operation: Operation, negative: bool) -> Operand {
        let label = self.graph.label(id).map(|label| label.negative);
        let meant = self.stored[id.index()].map(|root| label.unwrap_or(root));
        if meant == Some(!negative) {
            // A store would take the minus; taken here, the name means what it says to all who use it.
            let inner = self.labelled(Definition::Instruction, id, None);
            self.program.instructions.push(Instruction::Compute {
                result: inner,
                operation,
            });
            let inner = Operand::Value {
                id: inner,
                negative: false,
            };
            return self.assign(id, Operation::Neg(inner), !negative);
        }
        self.assign(id, operation, negative)
    }

    fn assign(&mut self, id: NodeId, operation: Operation, negative: bool) -> Operand {
        let result = self.value(Definition::Instruction, id, negative);
        self.program
            .instructions
            .push(Instruction::Compute { result, operation });
        Operand::Value {
            id: result,
            negative,
        }
    }

    /// A call, with all that is needed of it.
    fn call(&mut self, id: CallId) {
        let CallId { lockstep, call } = id;
        let of = self.graph.lockstep(lockstep);
        let number = usize::from(lockstep);
        if !of.shared.is_empty() && self.shared.insert(lockstep) {
            let values = of.shared.iter().map(|&own| self.expr(own)).collect();
            self.program.instructions.push(Instruction::Share {
                lockstep: number,
                values,
            });
        }
        let expr::Call { helper, sides } = &of.calls[&call];
        let own = &of.helpers[*helper];
        let mut results = vec![vec![None; own.lanes]; own.roots.len()];
        for (result, id) in self.results.remove(&id).unwrap_or_default() {
            let value = self.value(Definition::Instruction, id, false);
            results[usize::from(result.place)][usize::from(result.lane)] = Some(value);
            self.operands[id.index()] = Some(Operand::Value {
                id: value,
                negative: false,
            });
        }
        let helper = self.helper(own, [of.shared.len(), sides.len()]);
        let side = |row: &Vec<Expr>| row.iter().map(|own| self.expr(*own)).collect();
        let sides = sides.iter().map(side);
        let call = Instruction::Call {
            lockstep: number,
            helper,
            sides: sides.collect(),
            results,
        };
        self.program.instructions.push(call);
    }

    /// The place of a helper among the program's; it is given so many numbers that columns share, and so many of each.
    fn helper(
        &mut self,
        own: &Arc<expr::Helper<ExprGraph>>,
        [n_shared, n_sides]: [usize; 2],
    ) -> usize {
        let mut known = self.helpers.iter();
        if let Some(place) = known.position(|known| Arc::ptr_eq(known, own)) {
            return place;
        }
        self.helpers.push(own.clone());
        self.program.helpers.push(Helper {
            lanes: own.lanes,
            n_shared,
            n_sides,
            program: flatten(&own.graph, &own.roots),
        });
        self.helpers.len() - 1
    }

    /// First of all the sines and cosines of every angle that no other sine is part of, body after body: together they
    /// vectorise.
    fn ready_sines(&mut self) {
        let ready = ready(self.graph);
        let angles = self.sines.iter().filter(|(angle, _)| ready[angle.index()]);
        let mut angles: Vec<(NodeId, NodeId)> =
            angles.map(|(&angle, nodes)| (nodes[0], angle)).collect();
        angles.sort_by_key(|&(first, _)| (self.graph.scope(first), first));
        let angles: Vec<NodeId> = angles.into_iter().map(|(_, angle)| angle).collect();
        if angles.is_empty() {
            return;
        }
        let exprs: Vec<Expr> = angles.iter().copied().map(Expr::of).collect();
        let needed = self.graph.reachable(&exprs);
        for id in self.graph.ids().filter(|id| needed[id.index()]) {
            self.flatten(id);
        }
        self.sin_cos(&angles);
    }

    /// Sines and cosines of these angles.
    fn sin_cos(&mut self, angles: &[NodeId]) {
        let mut instruction = (Vec::new(), Vec::new(), Vec::new());
        for angle in angles {
            let operand = self.expr(Expr::of(*angle));
            let (mut sine, mut cosine) = (None, None);
            for id in self.sines[angle].clone() {
                let is_sine = matches!(self.graph.node(id), Node::Sin(_));
                // sin(-x) = -sin(x).
                let negative = is_sine && operand.is_negative();
                let result = self.value(Definition::Instruction, id, negative);
                *(if is_sine { &mut sine } else { &mut cosine }) = Some(result);
                self.operands[id.index()] = Some(Operand::Value {
                    id: result,
                    negative,
                });
            }
            instruction.0.push(unsigned(operand));
            instruction.1.push(sine);
            instruction.2.push(cosine);
        }
        let (angles, sines, cosines) = instruction;
        self.program.instructions.push(Instruction::SinCos {
            angles,
            sines,
            cosines,
        });
    }
}

/// What is needed of each call.
fn results(graph: &ExprGraph, needed: &[bool]) -> BTreeMap<CallId, Vec<(CallResult, NodeId)>> {
    let mut calls: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for id in graph.ids().filter(|id| needed[id.index()]) {
        if let Node::Input(Input::CallResult(result)) = graph.node(id) {
            calls.entry(result.call).or_default().push((result, id));
        }
    }
    calls
}

/// The sines and cosines that `roots` need, by their angle: at most one of each.
fn sines(graph: &ExprGraph, needed: &[bool]) -> BTreeMap<NodeId, Vec<NodeId>> {
    let mut sines: BTreeMap<NodeId, Vec<NodeId>> = BTreeMap::new();
    for id in graph.ids().filter(|id| needed[id.index()]) {
        if let Node::Sin(angle) | Node::Cos(angle) = graph.node(id) {
            sines.entry(angle).or_default().push(id);
        }
    }
    sines
}

/// For each node, whether it is made without a sine or cosine, so that it can be known when the function starts.
fn ready(graph: &ExprGraph) -> Vec<bool> {
    let mut ready: Vec<bool> = Vec::with_capacity(graph.len());
    for node in graph.ids().map(|id| graph.node(id)) {
        let is_late = matches!(
            node,
            Node::Sin(_) | Node::Cos(_) | Node::Input(Input::CallResult(_))
        );
        ready.push(!is_late && node.operands().all(|operand| ready[operand.index()]));
    }
    ready
}

/// For each node that is a root, whether the root is its negative.
fn stored(graph: &ExprGraph, roots: &[Expr]) -> Vec<Option<bool>> {
    let mut stored = vec![None; graph.len()];
    for root in roots {
        stored[root.node().index()] = Some(root.is_negative());
    }
    stored
}

/// For each node, whether its negative is wanted: as its label means it, else as it is stored, else as it was written.
/// Neither the signs of the model's constants nor what else uses the value has a say.
fn wanted_signs(graph: &ExprGraph, stored: &[Option<bool>]) -> Vec<bool> {
    let wanted = |id: NodeId| {
        let label = graph.label(id).map(|label| label.negative);
        label
            .or(stored[id.index()])
            .unwrap_or_else(|| graph.as_written(id).is_negative())
    };
    graph.ids().map(wanted).collect()
}

fn unsigned(operand: Operand) -> Operand {
    if operand.is_negative() {
        -operand
    } else {
        operand
    }
}
