//! Which operations share a statement: a sum of products reads better on one line than on five.
//!
//! A value joins the expression that uses it where it belongs to the same body, has no label, is used once, and is the
//! body's last before it: the order of evaluation stays the order of the program, and neither the statements of a body
//! nor their number depend on another body.

use std::{cmp::Reverse, collections::BTreeMap};

use crate::{
    id::BodyId,
    program::{Definition, Instruction, Operand, Operation, Program, ValueId},
};

/// The most operations in one statement.
const LARGEST: usize = 12;

/// The statements of a program.
#[derive(Clone, Debug)]
pub(super) struct Groups {
    /// For each value, the operation that computes it where it stands inside a larger expression.
    inlined: Vec<Option<Operation>>,
}

/// An expression so far: which of its body's instructions it spans.
#[derive(Clone, Copy)]
struct Span {
    first: usize,
    last: usize,
    operations: usize,
    /// The operation that it ends with.
    operation: Operation,
}

impl Groups {
    /// Groups the operations of a program.
    pub(super) fn of(program: &Program) -> Self {
        let uses = program.uses();
        let mut inlined = vec![None; program.values.len()];
        let mut spans: Vec<Option<Span>> = vec![None; program.values.len()];
        let mut counters: BTreeMap<Option<BodyId>, usize> = BTreeMap::new();
        for instruction in &program.instructions {
            let Instruction::Compute { result, operation } = *instruction else {
                continue;
            };
            let scope = program.value(result).scope;
            let counter = counters.entry(scope).or_default();
            let place = *counter;
            *counter += 1;
            let mut span = Span {
                first: place,
                last: place,
                operations: if matches!(operation, Operation::MulAdd(..)) {
                    2
                } else {
                    1
                },
                operation,
            };
            let mut operands: Vec<ValueId> =
                operation.operands().filter_map(Operand::value).collect();
            operands.sort_by_key(|id| Reverse(spans[id.index()].map(|span| span.last)));
            for id in operands {
                let value = program.value(id);
                let joins = value.definition == Definition::Instruction
                    && value.label.is_none()
                    && value.scope == scope
                    && uses[id.index()] == 1;
                let Some(inner) = spans[id.index()].filter(|_| joins) else {
                    continue;
                };
                if inner.last + 1 == span.first && span.operations + inner.operations <= LARGEST {
                    inlined[id.index()] = Some(inner.operation);
                    span.first = inner.first;
                    span.operations += inner.operations;
                }
            }
            spans[result.index()] = Some(span);
        }
        Self { inlined }
    }

    /// The operation of a value that stands inside a larger expression; `None` for one with a statement of its own.
    pub(super) fn inlined(&self, id: ValueId) -> Option<Operation> {
        self.inlined[id.index()]
    }
}
