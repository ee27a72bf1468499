//! A whole module as data.

use super::{
    Facts, Function,
    constants::{Constant, Data, FINGERPRINT, OPERATIONS, constant},
    verify::{verify, verify_facts},
    write::{FunctionWriter, nominal, sin_cos},
};
use crate::{compile::Compiled, origin::Origin, tree::Tree};

/// What a module says and does.
#[derive(Clone, Debug)]
pub struct Module {
    /// What is known beside the functions.
    pub facts: Facts,
    /// Writes the nominal parameters.
    pub nominal: Function,
    /// Computes what depends on parameters alone.
    pub prepare: Function,
    /// Takes sines and cosines, for functions that are given them.
    pub sin_cos: Option<Function>,
    /// What was asked for, in order.
    pub functions: Vec<Function>,
}

impl Module {
    /// The module of a tree with these programs.
    ///
    /// # Panics
    /// Where the listing breaks a promise: a bug of ours.
    pub fn new(tree: &Tree, origin: Origin, compiled: &Compiled) -> Self {
        let facts = Facts::of(tree, origin, compiled);
        let writer = FunctionWriter::new(tree, compiled, &facts);
        let module = Self {
            nominal: nominal(&facts),
            prepare: writer.prepare(&compiled.preparation),
            sin_cos: facts.angles.as_ref().map(|_| sin_cos(&facts)),
            functions: writer.functions(),
            facts,
        };
        if let Err(fault) = module.verify() {
            unreachable!("listing: {fault}");
        }
        module
    }

    /// Checks what every listing holds.
    fn verify(&self) -> Result<(), String> {
        verify_facts(&self.facts).map_err(|fault| fault.to_string())?;
        self.all().try_for_each(|function| {
            let name = &function.signature.name;
            verify(&self.facts, function).map_err(|fault| format!("`{name}`: {fault}"))
        })
    }

    /// Which model it is, and what its functions cost.
    pub fn identity(&self) -> [Constant<'_>; 2] {
        [
            constant(
                FINGERPRINT,
                "Hash of the model: of every name, number, joint and place in it after all changes, whatever is generated from it.",
                Data::Hash(self.facts.origin.fingerprint),
            ),
            constant(
                OPERATIONS,
                "Of each function the multiplications, additions, divisions, sines and cosines of one call.",
                Data::Costs(self.costed().collect()),
            ),
        ]
    }

    /// All functions: those that others need before, then what was asked for.
    pub fn all(&self) -> impl Iterator<Item = &Function> {
        [&self.nominal, &self.prepare]
            .into_iter()
            .chain(&self.sin_cos)
            .chain(&self.functions)
    }

    /// Those that say what they cost.
    pub fn costed(&self) -> impl Iterator<Item = &Function> {
        self.all().skip(1)
    }

    /// The function of this name, among those asked for.
    pub fn function(&self, name: &str) -> Option<&Function> {
        let mut functions = self.functions.iter();
        functions.find(|function| function.signature.name == name)
    }
}
