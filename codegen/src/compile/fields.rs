//! Names of the fields of `Prepared`.

use std::collections::BTreeMap;

use crate::{
    expr::{Input, Node},
    passes::hoist::{Field, Preparation},
    taken::Taken,
    tree::Tree,
};

/// The fields, in the order of the prepared values: a parameter's own name, or the function, the body and what it is there or, without
/// that, a number counted there.
pub(super) fn names<'a>(preparation: &'a Preparation, tree: &Tree) -> Vec<String> {
    let mut taken = Taken::default();
    let mut counters: BTreeMap<_, usize> = BTreeMap::new();
    let name = |field: &'a Field| {
        if let Node::Input(Input::Parameter(id)) = preparation.graph.node(field.root.node()) {
            return taken.take(tree.parameters[id.index()].name.clone());
        }
        let function = field.function.as_deref().unwrap_or_default();
        let body = tree.identifier(field.scope);
        taken.take(if let Some(label) = &field.label {
            format!("{function}_{body}_{label}")
        } else {
            let counter = counters.entry((function, field.scope)).or_default();
            *counter += 1;
            format!("{function}_{body}_k{counter}")
        })
    };
    preparation.fields.iter().map(name).collect()
}
