//! When what goes to an output is stored.

use std::collections::BTreeMap;

use crate::listing::{Entry, Expression, Statement};
use crate::{
    expr::Input,
    program::{Definition, Operand, Program, ValueId},
};

/// The most zeros that a compiler may join. More it makes a call of `memset`, on the smallest of processors already where they have
/// 32 bytes.
const MOST_ZEROS: usize = 4;

/// The stores of a program: those of each value, and those of numbers and of fields of `Prepared`, which wait for nothing.
#[derive(Default)]
pub(super) struct Stores {
    pub(super) of_values: BTreeMap<ValueId, Vec<(Entry, Operand)>>,
    pub(super) of_constants: Vec<Statement>,
}

impl Stores {
    /// The stores to these places, with the last of each few zeros that stand side by side kept apart from those after it.
    pub(super) fn of(
        program: &Program,
        stored: impl IntoIterator<Item = (Entry, Operand)>,
        constant: impl Fn(Operand) -> Expression,
    ) -> Self {
        let mut stores = Self::default();
        let mut n_zeros = 0;
        for (place, store) in stored {
            n_zeros = match store {
                Operand::Number(0.0) => n_zeros % MOST_ZEROS + 1,
                _ => 0,
            };
            match store.value().filter(|&id| !is_field(program, id)) {
                Some(id) => stores.of_values.entry(id).or_default().push((place, store)),
                None => stores.of_constants.push(Statement::Store {
                    place,
                    value: constant(store),
                    is_apart: n_zeros == MOST_ZEROS,
                }),
            }
        }
        stores
    }
}

/// True for a field of `Prepared`, which is read where it stands.
pub(super) fn is_field(program: &Program, id: ValueId) -> bool {
    matches!(
        program.value(id).definition,
        Definition::Input(Input::Prepared(_))
    )
}
