//! Which entries packed derivatives have.

use std::collections::BTreeSet;

use crate::{compile::Emittable, functions::Part, tree::Tree};

/// The entries of a packed derivative, as constants say them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackedEntries {
    /// The part of a request that writes them, as it is asked for.
    pub of: String,
    /// The name of the constant that says how many there are.
    pub length: String,
    /// The name of the constant that says where they stand.
    pub constant: String,
    /// What that says.
    pub doc: String,
    /// The row and column of each.
    pub places: Vec<[usize; 2]>,
    /// How many rows there are: of second derivatives, as many as columns.
    pub n_rows: usize,
    /// How many columns belong to each variable, in their order.
    pub columns: Vec<(String, usize)>,
    /// The colours of its columns, where it has any.
    pub colors: Option<Colors>,
}

/// Colours of columns: two of one colour share no row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Colors {
    /// The name of the constant that holds them.
    pub constant: String,
    /// What that says.
    pub doc: String,
    /// The name of the constant that says how many columns there are.
    pub length: String,
    /// For each column its colour, from 0.
    pub colors: Vec<usize>,
}

impl PackedEntries {
    /// Those that the functions write, each once.
    pub(in crate::listing) fn of(tree: &Tree, functions: &[Emittable]) -> Vec<Self> {
        let mut known = BTreeSet::new();
        let parts = functions.iter().flat_map(|one| one.request.parts());
        let all = parts.filter_map(|part| Self::of_part(tree, part));
        all.filter(|one| known.insert(one.constant.clone()))
            .collect()
    }

    fn of_part(tree: &Tree, part: &Part) -> Option<Self> {
        let sparsity = part.sparsity(tree)?;
        let (text, is_second) = (part.text(), sparsity.colors.is_none());
        let which = if is_second {
            "on and below the diagonal"
        } else {
            "row after row"
        };
        let by = part.derivative.iter().flat_map(|own| &own.by);
        let columns = by.map(|own| (own.name().to_owned(), own.n_entries(tree)));
        let columns: Vec<(String, usize)> = columns.collect();
        Some(Self {
            length: part.len_constant(),
            constant: part.places_constant(),
            doc: format!(
                "The row and column of each entry that `{text}` writes, {which}: the others are zero, whatever numbers the model has."
            ),
            places: sparsity.places.clone(),
            n_rows: if is_second {
                columns.iter().map(|(_, length)| length).sum()
            } else {
                part.n_values(tree)
            },
            columns,
            colors: sparsity.colors.clone().map(|colors| Colors {
                constant: part.colors_constant(),
                doc: format!(
                    "A colour for each column of `{text}`, from 0: two of one colour share no row, so one direction gives all entries of a colour."
                ),
                length: part.columns_constant(),
                colors,
            }),
            of: text,
        })
    }
}
