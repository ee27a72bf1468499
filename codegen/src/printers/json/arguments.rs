//! What a function is given and what it writes, argument by argument.

use super::{
    pattern,
    syntax::{list, object, one_or_several, string},
};
use crate::{
    functions::{Access, Declared, Signature},
    listing::Facts,
};

/// Members of a function.
pub(super) fn members(facts: &Facts, signature: &Signature) -> [(&'static str, String); 2] {
    let of = |access| list(signature.with(access).map(|own| argument(facts, own)));
    [
        ("arguments", of(Access::Read)),
        ("outputs", of(Access::Written)),
    ]
}

fn argument(facts: &Facts, argument: &Declared) -> String {
    let mut members = vec![("name", string(&argument.name))];
    let shape = facts.extent(argument).shape();
    if let Some(lengths) = shape {
        members.push(("shape", list(lengths)));
        let units = facts.units.among(&argument.unit);
        members.push(("unit", one_or_several(&units)));
    }
    members.push(("meaning", string(&argument.meaning)));
    members.extend(pattern::members(facts, argument));
    object(&members)
}
