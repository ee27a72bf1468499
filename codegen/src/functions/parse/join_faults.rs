//! What is wrong with parts that are joined.

use super::request_error::RequestError;
use crate::functions::{derivatives::derivative::DerivativeKind, part::AskedPart};

/// The first fault of these parts. `alike` makes one text of those of what may be given the same.
pub(super) fn first(
    text: &str,
    parts: &[AskedPart<'_>],
    alike: fn(&str) -> String,
) -> Option<RequestError> {
    repeated(text, parts)
        .or_else(|| compact(text, parts))
        .or_else(|| own_arguments(text, parts, alike))
}

/// The first of these texts that stands there a second time.
fn repeated(text: &str, parts: &[AskedPart<'_>]) -> Option<RequestError> {
    let texts: Vec<String> = parts.iter().map(AskedPart::text).collect();
    let twice = (1..texts.len()).find(|&at| texts[..at].contains(&texts[at]))?;
    Some(RequestError::Repeated {
        request: text.to_owned(),
        name: texts[twice].clone(),
    })
}

fn compact(text: &str, parts: &[AskedPart<'_>]) -> Option<RequestError> {
    let mut functions = parts.iter().map(|part| part.function);
    let compact = functions.find(|function| function.is_compact())?;
    (parts.len() > 1).then(|| RequestError::Compact {
        request: text.to_owned(),
        name: compact.name.to_owned(),
    })
}

/// What is given to one function is the same for its values and its derivatives.
fn own_arguments(
    text: &str,
    parts: &[AskedPart<'_>],
    alike: fn(&str) -> String,
) -> Option<RequestError> {
    let own = parts.iter().filter(|part| has_own_arguments(part));
    let mut own = own.map(|part| (alike(&part.text_of_values()), part));
    let (first, _) = own.next()?;
    let (_, other) = own.find(|(values, _)| *values != first)?;
    Some(RequestError::OwnArguments {
        request: text.to_owned(),
        name: other.text(),
    })
}

/// True where it is given what no other part can be given beside it.
fn has_own_arguments(part: &AskedPart<'_>) -> bool {
    let is_weighted = matches!(
        part.derivative,
        Some((DerivativeKind::Vjp | DerivativeKind::Hessian, _))
    );
    let mut arguments = part.function.arguments.iter();
    is_weighted || arguments.any(|argument| argument.is_of_frame())
}

/// A text without what names of the model and those of generated code differ in: before the model is known, both may be of one frame.
pub(super) fn plain(text: &str) -> String {
    let letters = text.chars().filter(|letter| letter.is_alphanumeric());
    letters.flat_map(char::to_lowercase).collect()
}
