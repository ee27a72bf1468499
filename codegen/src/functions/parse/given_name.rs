//! Names that functions are given: `step = mass_matrix+bias`.

use super::{request_error::RequestError, syntax::Word};
use crate::{
    functions::{
        function::Function,
        signature::{HELPER_INFIX, SIN_COS, STAGE_INFIX},
    },
    words::is_rust_keyword,
};

/// The longest name that a function may be given.
const LONGEST_NAME: usize = 64;

/// What generated modules, and C's headers, have beside functions that are asked for.
const TAKEN: [&str; 3] = [SIN_COS, "prepare", "nominal"];

/// What is wrong with the name that a function is given.
pub(super) fn fault(word: &Word) -> Option<RequestError> {
    let name = word.text.as_str();
    let is_of_name = |own: char| own.is_ascii_lowercase() || own.is_ascii_digit() || own == '_';
    let why = if name.is_empty() {
        "expected a name before `=`"
    } else if !name.starts_with(|first: char| first.is_ascii_lowercase())
        || !name.chars().all(is_of_name)
    {
        "expected lower-case letters, digits and `_`, a letter first"
    } else if name.len() > LONGEST_NAME {
        "expected 64 characters at most"
    } else if is_rust_keyword(name) {
        "it is a keyword of Rust"
    } else if Function::find(name).is_some() {
        "it is a function of the catalogue"
    } else if TAKEN.contains(&name)
        || [STAGE_INFIX, HELPER_INFIX]
            .iter()
            .any(|infix| name.contains(infix))
    {
        "it has a meaning of its own"
    } else {
        return None;
    };
    Some(RequestError::Name {
        name: name.to_owned(),
        why,
        place: word.place.clone(),
    })
}
