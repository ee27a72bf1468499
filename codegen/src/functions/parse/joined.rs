//! What is wrong with parts that are joined.

use super::request_error::RequestError;
use crate::functions::{derivatives::derivative::DerivativeKind, function::Function, part::Part};

/// The first fault of parts as they are written.
pub(super) fn written_fault<'a>(
    text: &str,
    parts: impl Iterator<Item = (String, &'a Function)>,
) -> Option<RequestError> {
    let (texts, functions): (Vec<_>, Vec<_>) = parts.unzip();
    let compact = || {
        let compact = functions.iter().find(|function| function.is_compact())?;
        (functions.len() > 1).then(|| RequestError::Compact {
            request: text.to_owned(),
            name: compact.name.to_owned(),
        })
    };
    repeated(text, &texts).or_else(compact)
}

/// The first fault of parts on the tree of a model: what is one frame there may be written in several ways.
pub(super) fn fault(text: &str, parts: &[Part]) -> Option<RequestError> {
    let texts: Vec<String> = parts.iter().map(Part::text).collect();
    repeated(text, &texts).or_else(|| own_arguments(text, parts))
}

/// The first of these texts that stands there a second time.
fn repeated(text: &str, texts: &[String]) -> Option<RequestError> {
    let twice = (1..texts.len()).find(|&at| texts[..at].contains(&texts[at]))?;
    Some(RequestError::Repeated {
        request: text.to_owned(),
        name: texts[twice].clone(),
    })
}

/// What is given to one function is the same for its values and its derivatives.
fn own_arguments(text: &str, parts: &[Part]) -> Option<RequestError> {
    let mut own = parts.iter().filter(|part| has_own_arguments(part));
    let first = own.next().map(|part| part.values().text());
    let other = own.find(|part| Some(part.values().text()) != first)?;
    Some(RequestError::OwnArguments {
        request: text.to_owned(),
        name: other.text(),
    })
}

/// True where it is given what no other part can be given beside it.
fn has_own_arguments(part: &Part) -> bool {
    let derivative = part.derivative.as_ref();
    let is_weighted = derivative.is_some_and(|derivative| {
        matches!(
            derivative.kind,
            DerivativeKind::Vjp | DerivativeKind::Hessian
        )
    });
    let mut arguments = part.function.arguments.iter();
    is_weighted || arguments.any(|argument| argument.is_of_frame())
}
