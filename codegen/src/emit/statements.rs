//! The statements of a program: sines and cosines, inputs read into locals, one assignment a group of operations.

use std::{collections::BTreeMap, mem};

use syn::{Expr, Ident, Stmt};

use super::{
    expression::{self, Writer},
    ident, syntax,
};
use crate::{
    expr::Input,
    program::{Groups, Instruction, Operand, Origin, Program, ValueId},
};

/// The most `let`s in a function. Debug information opens a scope at each of them, inside that of the one before, and the
/// compiler's stack ends after two or three thousand. In longer functions the next values of a body are declared together.
const MOST_LETS: usize = 1_800;

/// The most angles of one call. Of a hundred and more the compiler makes a loop. Fewer a call cost time: of values that stand
/// in one array it finds more that can be computed side by side.
pub(super) const ANGLES_OF_CALL: usize = 64;

/// Of how many bodies how many values are declared together, from longer to longer functions.
const TOGETHER: [(usize, usize); 4] = [(1, 8), (1, 64), (16, 64), (256, 256)];

/// Where values go: the stores of each value, and those of numbers and of fields of `Prepared`.
#[derive(Default)]
pub(super) struct Stores {
    pub(super) of_values: BTreeMap<ValueId, Vec<Stmt>>,
    pub(super) of_constants: Vec<Stmt>,
    /// True where there are fences among the latter.
    pub(super) has_fences: bool,
}

/// The statements of a program: inputs, sines and cosines are read where they are first needed, values stored as soon as
/// they are there. The compiler needs a fifth less time for that than for all stores in one block, which it tries to make
/// vectors of.
pub(super) fn of(
    program: &Program,
    groups: &Groups,
    names: &[String],
    parameters: &[String],
    stores: Stores,
) -> Vec<Stmt> {
    let writer = Writer {
        program,
        groups,
        names,
    };
    let Stores {
        of_values,
        of_constants,
        ..
    } = stores;
    let mut body = Body {
        writer,
        reads: inputs(program, parameters),
        stores: of_values,
        statements: Vec::new(),
    };
    for instruction in &program.instructions {
        body.instruction(instruction);
    }
    // What is left to store was not needed before.
    let stored = program.stores.iter().filter_map(|store| store.value());
    body.read(stored.collect());
    let mut statements = body.declared();
    statements.extend(of_constants);
    statements
}

/// Where every input is read from; fields of `Prepared` are read where they stand.
fn inputs(program: &Program, parameters: &[String]) -> BTreeMap<ValueId, Expr> {
    let place = |id: ValueId| match program.value(id).origin {
        Origin::Instruction | Origin::Input(Input::Prepared(_)) => None,
        Origin::Input(input) => Some((id, expression::input(input, parameters))),
    };
    program.ids().filter_map(place).collect()
}

/// A statement of a body.
enum Statement {
    /// One that declares and assigns a value, or several at once, of which not all need be wanted.
    Assign {
        values: Vec<Option<ValueId>>,
        value: Expr,
    },
    /// Another.
    Other(Stmt),
}

struct Body<'a> {
    writer: Writer<'a>,
    /// What is not read yet of inputs, and of sines and cosines that were computed together.
    reads: BTreeMap<ValueId, Expr>,
    stores: BTreeMap<ValueId, Vec<Stmt>>,
    statements: Vec<Statement>,
}

impl Body<'_> {
    fn instruction(&mut self, instruction: &Instruction) {
        match instruction {
            Instruction::Compute { result, operation } => {
                if self.writer.groups.inlined(*result).is_some() {
                    return;
                }
                let mut read = Vec::new();
                self.writer.read_by(*operation, &mut read);
                self.read(read);
                let value = self.writer.operation(*operation);
                self.assign(vec![Some(*result)], value);
            }
            Instruction::SinCos {
                angles,
                sines,
                cosines,
            } => {
                if let ([angle], [sine], [cosine]) = (&angles[..], &sines[..], &cosines[..]) {
                    self.read(angle.value().into_iter().collect());
                    let value = self.writer.call("sin_cos", angles);
                    return self.assign(vec![*sine, *cosine], value);
                }
                let [sines, cosines] = [sines, cosines].map(|ids| ids.chunks(ANGLES_OF_CALL));
                let calls = angles.chunks(ANGLES_OF_CALL).zip(sines).zip(cosines);
                for (number, ((angles, sines), cosines)) in (1..).zip(calls) {
                    self.sin_cos_array(number, angles, sines, cosines);
                }
            }
        }
    }

    /// The call of a number, from 1, for some of the angles.
    fn sin_cos_array(
        &mut self,
        number: usize,
        angles: &[Operand],
        sines: &[Option<ValueId>],
        cosines: &[Option<ValueId>],
    ) {
        self.read(angles.iter().filter_map(|angle| angle.value()).collect());
        // Each body takes its own from the arrays, so that a new body adds a line here and none to the others.
        let arrays = ["sines", "cosines"].map(|name| match number {
            1 => ident(name),
            _ => ident(&format!("{name}_{number}")),
        });
        let operands = angles.iter().map(|&angle| self.writer.operand(angle));
        let value = syntax::call(
            syntax::of_scalar("sin_cos_array"),
            [syntax::array(operands)],
        );
        let pattern = syntax::pattern(&arrays.clone().map(Some));
        let statement = syntax::declare(pattern, Some(value));
        self.statements.push(Statement::Other(statement));
        for (array, values) in arrays.iter().zip([sines, cosines]) {
            for (place, id) in values.iter().enumerate() {
                let value = || syntax::index(syntax::name(array), place);
                self.reads.extend(id.map(|id| (id, value())));
            }
        }
    }

    fn assign(&mut self, values: Vec<Option<ValueId>>, value: Expr) {
        let stores: Vec<Stmt> = values
            .iter()
            .flatten()
            .filter_map(|id| self.stores.remove(id))
            .flatten()
            .collect();
        self.statements.push(Statement::Assign { values, value });
        self.statements
            .extend(stores.into_iter().map(Statement::Other));
    }

    /// Reads into locals what is not there yet.
    fn read(&mut self, ids: Vec<ValueId>) {
        for id in ids {
            if let Some(value) = self.reads.remove(&id) {
                self.assign(vec![Some(id)], value);
            }
        }
    }

    fn name(&self, id: ValueId) -> Ident {
        ident(&self.writer.names[id.index()])
    }

    /// The statements, with a declaration of every value.
    fn declared(mut self) -> Vec<Stmt> {
        let declarations = self.declarations();
        let given = mem::take(&mut self.statements);
        let mut statements = Vec::with_capacity(given.len());
        for statement in given {
            let (values, value) = match statement {
                Statement::Other(statement) => {
                    statements.push(statement);
                    continue;
                }
                Statement::Assign { values, value } => (values, value),
            };
            let names: Vec<_> = values.iter().map(|id| id.map(|id| self.name(id))).collect();
            let Some(declarations) = &declarations else {
                statements.push(syntax::declare(syntax::pattern(&names), Some(value)));
                continue;
            };
            let together = values
                .iter()
                .flatten()
                .filter_map(|id| declarations.get(id));
            statements.extend(together.map(|together| {
                let names: Vec<_> = together.iter().map(|&id| Some(self.name(id))).collect();
                syntax::declare(syntax::pattern(&names), None)
            }));
            statements.push(syntax::assign(syntax::places(&names), value));
        }
        statements
    }

    /// Where a function has so many statements that each `let` cannot have a scope of its own: values that are declared
    /// together, by the first of them.
    fn declarations(&self) -> Option<BTreeMap<ValueId, Vec<ValueId>>> {
        let values = |statement: &'_ Statement| match statement {
            Statement::Assign { values, .. } => values.clone(),
            Statement::Other(_) => Vec::new(),
        };
        let assigned = self.statements.iter().flat_map(values).flatten();
        let assigned: Vec<ValueId> = assigned.collect();
        // Sines and cosines come in arrays, by lets of their own.
        let is_let = |statement: &&Statement| matches!(statement, Statement::Other(Stmt::Local(_)));
        let n_arrays = self.statements.iter().filter(is_let).count();
        let most = MOST_LETS.saturating_sub(n_arrays);
        if assigned.len() <= most {
            return None;
        }
        let together = TOGETHER.map(|(bodies, values)| self.chunks(&assigned, bodies, values));
        let [.., last] = &together;
        let fewest = together.iter().find(|chunks| chunks.len() <= most);
        let chunks = fewest.unwrap_or(last).iter();
        Some(chunks.map(|chunk| (chunk[0], chunk.clone())).collect())
    }

    /// The values of so many bodies, so many together, in order.
    fn chunks(&self, assigned: &[ValueId], bodies: usize, together: usize) -> Vec<Vec<ValueId>> {
        let mut groups: BTreeMap<Option<usize>, Vec<ValueId>> = BTreeMap::new();
        for &id in assigned {
            let scope = self.writer.program.value(id).scope;
            let group = scope.map(|body| body.index() / bodies);
            groups.entry(group).or_default().push(id);
        }
        let chunks = groups.values().flat_map(|ids| ids.chunks(together));
        chunks.map(<[ValueId]>::to_vec).collect()
    }
}
