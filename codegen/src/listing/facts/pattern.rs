//! Which columns compact outputs have.

use std::collections::BTreeSet;

use crate::{compile::Emittable, functions::CompactBlock};

/// Which columns of a whole a compact output has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// The function that writes it.
    pub function: &'static str,
    /// The name of the constant that says how many columns there are.
    pub columns: String,
    /// The name of the constant that says which.
    pub blocks: String,
    /// What that says.
    pub doc: String,
    /// How many columns there are.
    pub n_columns: usize,
    /// The non-zero partitions, body after body.
    pub entries: Vec<CompactBlock>,
}

impl Pattern {
    /// Those of the functions' outputs, each once.
    pub(in crate::listing) fn of(functions: &[Emittable]) -> Vec<Self> {
        let mut known = BTreeSet::new();
        let patterns = functions.iter().filter_map(|emittable| {
            let function = emittable.request.compact()?;
            let blocks = &emittable.blocks;
            known.insert(function.name).then(|| Self {
                function: function.name,
                columns: function.compact_columns_constant(),
                blocks: function.blocks_constant(),
                doc: format!(
                    "The non-zero partitions that `{}` writes, body after body.",
                    function.name
                ),
                n_columns: blocks.iter().map(|block| block.columns).sum(),
                entries: blocks.clone(),
            })
        });
        patterns.collect()
    }
}
