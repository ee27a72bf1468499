//! The statements of a program: sines and cosines, inputs read into locals, one assignment a group of operations.

use std::collections::BTreeMap;

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use super::{
    expression::{self, Writer},
    ident,
};
use crate::{
    expr::Input,
    program::{Groups, Instruction, Operand, Origin, Program, ValueId},
};

/// The most `let`s in a function. Debug information opens a scope at each of them, inside that of the one before, and the
/// compiler's stack ends after two or three thousand. In longer functions the next values of a body are declared together.
const MOST_LETS: usize = 1_800;

/// Of how many bodies how many values are declared together, from longer to longer functions.
const TOGETHER: [(usize, usize); 4] = [(1, 8), (1, 64), (16, 64), (256, 256)];

/// Where values go: the stores of each value, and those of numbers and of fields of `Prepared`.
#[derive(Default)]
pub(super) struct Stores {
    pub(super) of_values: BTreeMap<ValueId, Vec<TokenStream>>,
    pub(super) of_constants: Vec<TokenStream>,
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
) -> Vec<TokenStream> {
    let writer = Writer {
        program,
        groups,
        names,
    };
    let Stores {
        of_values,
        of_constants,
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
fn inputs(program: &Program, parameters: &[String]) -> BTreeMap<ValueId, TokenStream> {
    let place = |id: ValueId| match program.value(id).origin {
        Origin::Instruction | Origin::Input(Input::Prepared(_)) => None,
        Origin::Input(input) => Some((id, expression::input(input, parameters))),
    };
    program.ids().filter_map(place).collect()
}

/// A statement of a body.
enum Statement {
    /// One that declares and assigns values.
    Assign {
        values: Vec<ValueId>,
        pattern: TokenStream,
        value: TokenStream,
    },
    /// Another.
    Other(TokenStream),
}

struct Body<'a> {
    writer: Writer<'a>,
    /// What is not read yet of inputs, and of sines and cosines that were computed together.
    reads: BTreeMap<ValueId, TokenStream>,
    stores: BTreeMap<ValueId, Vec<TokenStream>>,
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
                let value = self.writer.operation(*operation).into_token_stream();
                let pattern = self.name(*result).into_token_stream();
                self.assign(vec![*result], pattern, value);
            }
            Instruction::SinCos {
                angles,
                sines,
                cosines,
            } => {
                self.read(angles.iter().filter_map(|angle| angle.value()).collect());
                self.sin_cos(angles, sines, cosines);
            }
        }
    }

    fn sin_cos(
        &mut self,
        angles: &[Operand],
        sines: &[Option<ValueId>],
        cosines: &[Option<ValueId>],
    ) {
        let operands = angles.iter().map(|&angle| self.writer.operand(angle));
        if let ([angle], [sine], [cosine]) = (angles, sines, cosines) {
            let angle = self.writer.operand(*angle);
            let (s, c) = (self.pattern(*sine), self.pattern(*cosine));
            let values = [*sine, *cosine].into_iter().flatten().collect();
            return self.assign(values, quote!((#s, #c)), quote!(R::sin_cos(#angle)));
        }
        // Each body takes its own from the arrays, so that a new body adds a line here and none to the others.
        let statement = quote!(let (sines, cosines) = R::sin_cos_array([#(#operands),*]););
        self.statements.push(Statement::Other(statement));
        for (array, values) in [("sines", sines), ("cosines", cosines)] {
            let array = ident(array);
            for (place, id) in values.iter().enumerate() {
                let place = Literal::usize_unsuffixed(place);
                self.reads.extend(id.map(|id| (id, quote!(#array[#place]))));
            }
        }
    }

    fn assign(&mut self, values: Vec<ValueId>, pattern: TokenStream, value: TokenStream) {
        let stores: Vec<TokenStream> = values
            .iter()
            .filter_map(|id| self.stores.remove(id))
            .flatten()
            .collect();
        self.statements.push(Statement::Assign {
            values,
            pattern,
            value,
        });
        self.statements
            .extend(stores.into_iter().map(Statement::Other));
    }

    /// Reads into locals what is not there yet.
    fn read(&mut self, ids: Vec<ValueId>) {
        for id in ids {
            if let Some(value) = self.reads.remove(&id) {
                let name = self.name(id).into_token_stream();
                self.assign(vec![id], name, value);
            }
        }
    }

    fn name(&self, id: ValueId) -> proc_macro2::Ident {
        ident(&self.writer.names[id.index()])
    }

    fn pattern(&self, id: Option<ValueId>) -> TokenStream {
        id.map_or(quote!(_), |id| self.name(id).into_token_stream())
    }

    /// The statements, with a declaration of every value.
    fn declared(&self) -> Vec<TokenStream> {
        let declarations = self.declarations();
        let mut statements = Vec::with_capacity(self.statements.len());
        for statement in &self.statements {
            match (statement, &declarations) {
                (Statement::Other(statement), _) => statements.push(statement.clone()),
                (Statement::Assign { pattern, value, .. }, None) => {
                    statements.push(quote!(let #pattern = #value;));
                }
                (
                    Statement::Assign {
                        values,
                        pattern,
                        value,
                    },
                    Some(declarations),
                ) => {
                    for together in values.iter().filter_map(|id| declarations.get(id)) {
                        let names: Vec<_> = together.iter().map(|&id| self.name(id)).collect();
                        statements.push(match &names[..] {
                            [name] => quote!(let #name;),
                            names => quote!(let (#(#names),*);),
                        });
                    }
                    statements.push(quote!(#pattern = #value;));
                }
            }
        }
        statements
    }

    /// Where a function has so many statements that each `let` cannot have a scope of its own: values that are declared
    /// together, by the first of them.
    fn declarations(&self) -> Option<BTreeMap<ValueId, Vec<ValueId>>> {
        let assigned = self
            .statements
            .iter()
            .flat_map(|statement| match statement {
                Statement::Assign { values, .. } => &values[..],
                Statement::Other(_) => &[],
            });
        let assigned: Vec<ValueId> = assigned.copied().collect();
        if assigned.len() <= MOST_LETS {
            return None;
        }
        let together = TOGETHER.map(|(bodies, values)| self.chunks(&assigned, bodies, values));
        let [.., last] = &together;
        let fewest = together.iter().find(|chunks| chunks.len() <= MOST_LETS);
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
