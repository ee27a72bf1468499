//! A whole module as data.

use std::collections::BTreeSet;

use super::{
    BaseParameters, Entries, Facts, FrameSpeeds, Function, Pattern,
    facts::Wanted,
    verify::{verify, verify_facts},
    write::{FunctionWriter, nominal, sin_cos},
};
use crate::{
    compile::{Compiled, Emittable},
    functions::Request,
    origin::Origin,
    threads,
    tree::Tree,
};

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
        let facts = Facts::of(
            tree,
            origin,
            &compiled.fields,
            wanted(tree, &compiled.functions),
        );
        let writer = FunctionWriter::new(tree, compiled, &facts);
        let module = Self {
            nominal: nominal(&facts),
            prepare: writer.prepare(&compiled.preparation),
            sin_cos: facts.angles.as_ref().map(|_| sin_cos(&facts)),
            functions: threads::map(&compiled.functions, |emittable| writer.function(emittable)),
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

/// What the functions want of the facts.
fn wanted(tree: &Tree, functions: &[Emittable]) -> Wanted {
    let any = |is: fn(&Request) -> bool| functions.iter().any(|one| is(&one.function));
    let mut known = BTreeSet::new();
    let patterns = functions.iter().filter_map(|emittable| {
        let function = emittable.function.compact()?;
        known.insert(function.name).then(|| Pattern {
            function: function.name,
            columns: function.compact_columns_constant(),
            blocks: function.blocks_constant(),
            doc: format!(
                "The non-zero partitions that `{}` writes, body after body.",
                function.name
            ),
            n_columns: emittable.program.stores.len() / 3,
            entries: emittable.blocks.clone(),
        })
    });
    Wanted {
        patterns: patterns.collect(),
        base_parameters: BaseParameters::of(tree, functions),
        frame_speeds: FrameSpeeds::of(tree, functions),
        entries: Entries::of(tree, functions),
        angles: any(Request::is_at_sin_cos),
        prescribed: any(Request::prescribes),
        values: any(Request::is_by_parameters) || !tree.parameters.is_empty(),
        packed: functions
            .iter()
            .flat_map(|one| one.function.packed())
            .collect(),
    }
}
