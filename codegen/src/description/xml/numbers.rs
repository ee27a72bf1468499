//! The reading of numbers in attributes: finite, with space between them.

use crate::description::xml::document::Element;
use crate::description::xml::reader::Reader;
use crate::diagnostic::{Diagnostic, Span, Spanned, shown};

impl Reader {
    /// A finite number, of an attribute that may be absent.
    pub(crate) fn optional_number(
        &mut self,
        element: Element<'_>,
        owner: &str,
        name: &str,
    ) -> Option<Spanned<f64>> {
        let value = element.attribute(name)?;
        self.number(value, &format!("`{name}` of {owner}"))
    }

    /// A limit, of an attribute that may be absent; `none` is the infinity that stands for no limit, as does what is beyond all floats.
    pub(crate) fn optional_limit(
        &mut self,
        element: Element<'_>,
        owner: &str,
        name: &str,
        none: f64,
    ) -> Option<Spanned<f64>> {
        let value = element.attribute(name)?;
        let is_none = value.value.trim_ascii().parse() == Ok(none);
        if is_none {
            return None;
        }
        self.number(value, &format!("`{name}` of {owner}"))
    }

    /// A finite number; `what` is the words for it, such as "`value` of `mass` of link `hub`".
    pub(crate) fn number(&mut self, value: Spanned<&str>, what: &str) -> Option<Spanned<f64>> {
        self.numbers(value, what).map(|[number]| number)
    }

    /// As many finite numbers as asked for, with space between them; minus zero becomes zero.
    pub(crate) fn numbers<const N: usize>(
        &mut self,
        value: Spanned<&str>,
        what: &str,
    ) -> Option<[Spanned<f64>; N]> {
        self.some_numbers(value, what, N, N)?.try_into().ok()
    }

    /// At least `least` and at most `most` finite numbers, with space between them; minus zero becomes zero.
    pub(crate) fn some_numbers(
        &mut self,
        value: Spanned<&str>,
        what: &str,
        least: usize,
        most: usize,
    ) -> Option<Vec<Spanned<f64>>> {
        let words: Vec<Spanned<&str>> = words(value).collect();
        if words.len() < least || words.len() > most {
            let expected = match (least, most) {
                (1, 1) => "a number".to_owned(),
                (least, most) if least == most => format!("{least} numbers"),
                (least, most) => format!("{least} to {most} numbers"),
            };
            let found = match words.len() {
                0 => "is empty".to_owned(),
                1 => "has 1 entry".to_owned(),
                n => format!("has {n} entries"),
            };
            let fault = Diagnostic::error(format!("{what} {found}; expected {expected}"));
            let fault = fault.at(value.span, format!("expected {expected}"));
            self.faults.push(with_help(fault, value.value));
            return None;
        }
        let several = words.len() > 1;
        let numbers: Vec<Option<Spanned<f64>>> = words
            .iter()
            .enumerate()
            .map(|(index, word)| {
                if several {
                    self.word(*word, &format!("entry {} of {what}", index + 1))
                } else {
                    self.word(*word, what)
                }
            })
            .collect();
        numbers.into_iter().collect()
    }

    fn word(&mut self, word: Spanned<&str>, what: &str) -> Option<Spanned<f64>> {
        let found = shown(word.value);
        let (message, label) = match word.value.parse::<f64>() {
            // So that `-0.0` and `0` are the same description.
            Ok(number) if number.is_finite() => return Some(Spanned::new(number + 0.0, word.span)),
            Ok(_) if word.value.contains(|c: char| c.is_ascii_digit()) => (
                format!("{what} is {found}, which does not fit a 64-bit float"),
                "too large",
            ),
            Ok(_) => (
                format!("{what} is `{found}`; expected a finite number"),
                "not finite",
            ),
            Err(_) => (
                format!("{what} is `{found}`; expected a number"),
                "no number",
            ),
        };
        let fault = Diagnostic::error(message).at(word.span, label);
        self.faults.push(with_help(fault, word.value));
        None
    }
}

/// With what to do about commas, and about what xacro has to put in.
fn with_help(fault: Diagnostic, value: &str) -> Diagnostic {
    if value.contains("${") || value.contains("$(") {
        fault.help("expand the file first: `xacro arm.urdf.xacro > arm.urdf`")
    } else if value.contains(',') {
        fault
            .help("numbers have a decimal point and stand with spaces between them, without commas")
    } else {
        fault
    }
}

/// The words of a value, with their places.
pub(crate) fn words(value: Spanned<&str>) -> impl Iterator<Item = Spanned<&str>> {
    let words = value.value.split_ascii_whitespace();
    words.map(move |word| Spanned::new(word, word_span(value, word)))
}

/// The place of a word of a value; that of the whole value where entities or line ends of two bytes move its words.
fn word_span(value: Spanned<&str>, word: &str) -> Span {
    let at = word.as_ptr() as usize - value.value.as_ptr() as usize;
    if value.span.end - value.span.start == value.value.len() {
        Span::from(value.span.start + at..value.span.start + at + word.len())
    } else {
        value.span
    }
}
