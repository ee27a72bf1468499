//! A whole module, item by item.

use super::{
    constants, frames, function, structures, system,
    text::{banner, printed},
};
use crate::{listing::Module, threads};

/// The text of a module.
pub(crate) fn source(module: &Module) -> String {
    let facts = &module.facts;
    let mut constants = facts.constants();
    constants.extend(module.identity());
    let mut items = constants::items(&constants);
    items.extend(structures::parameters(module));
    items.extend(structures::prepared(module));
    items.push(system::item(facts));
    items.extend(system::parametric(facts));
    if let Some(sin_cos) = &module.sin_cos {
        items.extend(constants::items(&facts.angle_constants()));
        items.push(structures::sin_cos());
        items.push(function::item(facts, sin_cos));
    }
    items.extend(constants::items(&facts.output_constants()));
    items.extend(constants::items(facts.prescribed_constant().as_slice()));
    items.extend(frames::types(module));
    let functions = threads::map(&module.functions, |one| {
        printed(function::items(facts, one))
    });
    banner(&facts.origin.lines()) + &printed(items) + &functions.concat()
}
