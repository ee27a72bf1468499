//! Names that functions are given: `step = mass_matrix+bias`.

use super::{request_error::RequestError, syntax::Word};
use crate::{
    functions::{
        function::Function,
        signature::{HELPER_INFIX, NOMINAL, PREPARE, SIN_COS, STAGE_INFIX},
    },
    words::{C_STRUCTURES, is_c_runtime, is_rust_keyword},
};

/// The longest name that a function may be given.
const LONGEST_NAME: usize = 64;

/// The functions that generated modules, and C's headers, have beside those that are asked for.
const TAKEN: [&str; 3] = [SIN_COS, PREPARE, NOMINAL];

/// What the names of stages and helpers have.
const INFIXES: [&str; 2] = [STAGE_INFIX, HELPER_INFIX];

/// What is wrong with the name that a function is given.
pub(super) fn fault(word: &Word) -> Option<RequestError> {
    Some(RequestError::Name {
        name: word.text.clone(),
        why: why_not(&word.text)?,
        place: word.place.clone(),
    })
}

fn why_not(name: &str) -> Option<String> {
    let is_of_name = |own: char| own.is_ascii_lowercase() || own.is_ascii_digit() || own == '_';
    let begins = name.starts_with(|first: char| first.is_ascii_lowercase());
    let why = if name.is_empty() {
        "expected a name before `=`"
    } else if !begins || !name.chars().all(is_of_name) || name.split('_').any(str::is_empty) {
        "expected words of lower-case letters and digits with one `_` between them, a letter first"
    } else if name.len() > LONGEST_NAME {
        return Some(format!("expected {LONGEST_NAME} characters at most"));
    } else if is_rust_keyword(name) {
        "it is a keyword of Rust"
    } else if Function::find(name).is_some() {
        "it is a function of the catalogue"
    } else if TAKEN.contains(&name) || C_STRUCTURES.contains(&name) {
        "a module has something of that name"
    } else if is_c_runtime(name) {
        "the C interface has a function of that name"
    } else {
        let mut infixes = INFIXES.into_iter();
        let infix = infixes.find(|infix| name.contains(infix))?;
        return Some(format!(
            "`{infix}` marks what a long function calls, such as `bias{infix}1`"
        ));
    };
    Some(why.to_owned())
}
