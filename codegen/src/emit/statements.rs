//! The statements of a program: inputs read into locals, sines and cosines, one assignment a group of operations.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::{
    expression::{self, Writer},
    ident,
};
use crate::program::{Groups, Instruction, Origin, Program, ValueId};

/// Where values go: the stores of each value, and those of numbers and of fields of `Prepared`.
#[derive(Default)]
pub(super) struct Stores {
    pub(super) of_values: BTreeMap<ValueId, Vec<TokenStream>>,
    pub(super) of_constants: Vec<TokenStream>,
}

/// The statements of a program: inputs are read where they are first needed, values stored as soon as they are there.
/// The compiler needs a fifth less time for that than for all stores in one block, which it tries to make vectors of.
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
    let declarations = declarations(program, groups);
    let bound = BTreeSet::new();
    let mut body = Body {
        writer,
        parameters,
        declarations,
        stores: of_values,
        bound,
        statements: Vec::new(),
    };
    for instruction in &program.instructions {
        body.instruction(instruction);
        for result in instruction.results() {
            body.store(result);
        }
    }
    // What is left to store are inputs.
    for id in program.stores.iter().filter_map(|store| store.value()) {
        let mut inputs = Vec::new();
        body.writer.input_of(id, &mut inputs);
        body.bind(inputs);
        body.store(id);
    }
    body.statements.extend(of_constants);
    body.statements
}

/// Where a function has so many statements that each `let` cannot have a scope of its own: values that are declared
/// together, by the first of them.
type Declarations = BTreeMap<ValueId, Vec<ValueId>>;

/// Debug information opens a scope at each `let`, inside that of the `let` before, and the compiler's stack ends
/// after two or three thousand. In longer functions the next values of a body are declared together.
fn declarations(program: &Program, groups: &Groups) -> Option<Declarations> {
    let assigned = program
        .instructions
        .iter()
        .filter_map(|instruction| match instruction {
            Instruction::Compute { result, .. } => {
                Some(*result).filter(|&id| groups.inlined(id).is_none())
            }
            Instruction::SinCos { .. } => None,
        });
    let mut bodies: BTreeMap<_, Vec<ValueId>> = BTreeMap::new();
    for id in assigned {
        bodies.entry(program.value(id).scope).or_default().push(id);
    }
    let together = match bodies.values().map(Vec::len).sum() {
        0..=1_200 => return None,
        1_201..=12_000 => 8,
        _ => 64,
    };
    let chunks = bodies.values().flat_map(|ids| ids.chunks(together));
    Some(chunks.map(|chunk| (chunk[0], chunk.to_vec())).collect())
}

struct Body<'a> {
    writer: Writer<'a>,
    parameters: &'a [String],
    declarations: Option<Declarations>,
    stores: BTreeMap<ValueId, Vec<TokenStream>>,
    bound: BTreeSet<ValueId>,
    statements: Vec<TokenStream>,
}

impl Body<'_> {
    fn instruction(&mut self, instruction: &Instruction) {
        let mut inputs = Vec::new();
        match instruction {
            Instruction::Compute { result, operation } => {
                if self.writer.groups.inlined(*result).is_some() {
                    return;
                }
                self.writer.inputs_of(*operation, &mut inputs);
                self.bind(inputs);
                self.assign(*result, &self.writer.operation(*operation));
            }
            Instruction::SinCos {
                angles,
                sines,
                cosines,
            } => {
                for id in angles.iter().filter_map(|angle| angle.value()) {
                    self.writer.input_of(id, &mut inputs);
                }
                self.bind(inputs);
                let angles: Vec<_> = angles
                    .iter()
                    .map(|&angle| self.writer.operand(angle))
                    .collect();
                let names = |ids: &[Option<ValueId>]| {
                    ids.iter().map(|&id| self.pattern(id)).collect::<Vec<_>>()
                };
                let (sines, cosines) = (names(sines), names(cosines));
                if let ([angle], [sine], [cosine]) = (&angles[..], &sines[..], &cosines[..]) {
                    self.statements
                        .push(quote!(let (#sine, #cosine) = R::sin_cos(#angle);));
                } else {
                    // Three short lines: a pattern of two lists is printed over a dozen.
                    self.statements
                        .push(quote!(let (sines, cosines) = R::sin_cos_array([#(#angles),*]);));
                    self.statements.push(quote!(let [#(#sines),*] = sines;));
                    self.statements.push(quote!(let [#(#cosines),*] = cosines;));
                }
            }
        }
    }

    fn assign(&mut self, id: ValueId, value: &syn::Expr) {
        let name = self.name(id);
        let Some(declarations) = &self.declarations else {
            return self.statements.push(quote!(let #name = #value;));
        };
        if let Some(together) = declarations.get(&id) {
            let names: Vec<_> = together.iter().map(|&id| self.name(id)).collect();
            self.statements.push(match &names[..] {
                [name] => quote!(let #name;),
                names => quote!(let (#(#names),*);),
            });
        }
        self.statements.push(quote!(#name = #value;));
    }

    fn store(&mut self, id: ValueId) {
        self.statements
            .extend(self.stores.remove(&id).unwrap_or_default());
    }

    /// Reads inputs into locals, each where it is first needed.
    fn bind(&mut self, inputs: Vec<ValueId>) {
        for id in inputs {
            if let Origin::Input(input) = self.writer.program.value(id).origin
                && self.bound.insert(id)
            {
                let (name, value) = (self.name(id), expression::input(input, self.parameters));
                self.statements.push(quote!(let #name = #value;));
            }
        }
    }

    fn name(&self, id: ValueId) -> proc_macro2::Ident {
        ident(&self.writer.names[id.index()])
    }

    fn pattern(&self, id: Option<ValueId>) -> TokenStream {
        id.map_or(quote!(_), |id| self.name(id).into_token_stream())
    }
}
