//! What is wrong with parts that are joined.

use super::request_error::RequestError;
use crate::functions::{derivatives::derivative::DerivativeKind, function::Function, part::Part};

/// A part as it is written.
pub(super) struct WrittenPart {
    pub(super) text: String,
    /// The same without its derivative.
    pub(super) of_values: String,
    pub(super) function: &'static Function,
    pub(super) derivative: Option<DerivativeKind>,
}

/// The first fault of parts as they are written: of what may be one frame of a model none is told.
pub(super) fn written_fault(text: &str, parts: &[WrittenPart]) -> Option<RequestError> {
    let texts: Vec<String> = parts.iter().map(|part| part.text.clone()).collect();
    let compact = || {
        let mut functions = parts.iter().map(|part| part.function);
        let compact = functions.find(|function| function.is_compact())?;
        (parts.len() > 1).then(|| RequestError::Compact {
            request: text.to_owned(),
            name: compact.name.to_owned(),
        })
    };
    let own = || {
        let own = parts.iter();
        let own = own.filter(|part| has_own_arguments(part.function, part.derivative));
        own_arguments(
            text,
            own.map(|part| (plain(&part.of_values), part.text.clone())),
        )
    };
    repeated(text, &texts).or_else(compact).or_else(own)
}

/// The first fault of parts on the tree of a model: what is one frame there may be written in several ways.
pub(super) fn fault(text: &str, parts: &[Part]) -> Option<RequestError> {
    let texts: Vec<String> = parts.iter().map(Part::text).collect();
    let own = || {
        let kind = |part: &Part| part.derivative.as_ref().map(|derivative| derivative.kind);
        let own = parts
            .iter()
            .filter(|part| has_own_arguments(part.function, kind(part)));
        own_arguments(text, own.map(|part| (part.values().text(), part.text())))
    };
    repeated(text, &texts).or_else(own)
}

/// The first of these texts that stands there a second time.
fn repeated(text: &str, texts: &[String]) -> Option<RequestError> {
    let twice = (1..texts.len()).find(|&at| texts[..at].contains(&texts[at]))?;
    Some(RequestError::Repeated {
        request: text.to_owned(),
        name: texts[twice].clone(),
    })
}

/// What is given to one function is the same for its values and its derivatives: the texts of both, of what is given something.
fn own_arguments(
    text: &str,
    mut own: impl Iterator<Item = (String, String)>,
) -> Option<RequestError> {
    let (first, _) = own.next()?;
    let (_, other) = own.find(|(values, _)| *values != first)?;
    Some(RequestError::OwnArguments {
        request: text.to_owned(),
        name: other,
    })
}

/// True where it is given what no other part can be given beside it.
fn has_own_arguments(function: &Function, derivative: Option<DerivativeKind>) -> bool {
    let is_weighted = matches!(
        derivative,
        Some(DerivativeKind::Vjp | DerivativeKind::Hessian)
    );
    let mut arguments = function.arguments.iter();
    is_weighted || arguments.any(|argument| argument.is_of_frame())
}

/// A text without what names of the model and those of generated code differ in.
fn plain(text: &str) -> String {
    let letters = text.chars().filter(|letter| letter.is_alphanumeric());
    letters.flat_map(char::to_lowercase).collect()
}
