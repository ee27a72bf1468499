//! The grammar of requests: text to a syntax tree, with the place of every word.
//!
//! ```text
//! request = part ("+" part)* ["(sin_cos)"]
//! part    = "d" "(" part ")" "/" "d" "(" words ")"
//!         | "packed" "(" "d" "(" part ")" "/" "d" "(" words ")" ")"
//!         | ("jvp" | "vjp" | "hessian") "(" part ";" words ")"
//!         | word ["(" words ")"]
//! words   = word ("," word)*
//! word    = characters other than + ( ) , ; " | '"' (a character other than " | '""')* '"'
//! ```
//!
//! White space around words says nothing. Between quotes, `""` is one quote. Does not: know a function, a frame or a variable.

use std::ops::Range;

/// What stands after a request whose function is given sines and cosines.
pub(super) const AT_SIN_COS: &str = "(sin_cos)";

/// A request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Sum {
    pub(super) parts: Vec<Part>,
    pub(super) at_sin_cos: bool,
}

/// A part of a request, and the place where it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Part {
    pub(super) kind: Kind,
    pub(super) place: Range<usize>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// `rotation`, or `pose(tool0)`.
    Named { name: Word, of: Vec<Word> },
    /// `d(bias)/d(q, u)`, or `packed(d(bias)/d(q, u))`.
    Derivative {
        of: Box<Part>,
        by: Vec<Word>,
        is_packed: bool,
    },
    /// `jvp(bias; q, u)`.
    Product {
        name: Word,
        of: Box<Part>,
        along: Vec<Word>,
    },
}

/// A name, without its quotes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Word {
    pub(super) text: String,
    pub(super) place: Range<usize>,
    is_quoted: bool,
}

impl Word {
    /// True for this word without quotes, which is then no name.
    pub(super) fn is(&self, word: &str) -> bool {
        !self.is_quoted && self.text == word
    }
}

/// What the grammar does not allow, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Unexpected {
    pub(super) expected: &'static str,
    pub(super) place: Range<usize>,
}

/// Reads a request.
pub(super) fn read(text: &str) -> Result<Sum, Unexpected> {
    let mut reader = Reader {
        text,
        at: 0,
        depth: 0,
    };
    let mut parts = vec![reader.part()?];
    while reader.take('+') {
        parts.push(reader.part()?);
    }
    let at_sin_cos = reader.is_at_suffix();
    if !at_sin_cos && !reader.rest().is_empty() {
        return Err(reader.unexpected("expected `+` or the end"));
    }
    Ok(Sum { parts, at_sin_cos })
}

/// Takes a list of requests apart, at the commas that stand in no brackets and no quotes.
///
/// ```
/// use kane_codegen::functions::split;
///
/// let list = "bias,velocity(tool0, local)";
/// assert_eq!(split(list).collect::<Vec<_>>(), ["bias", "velocity(tool0, local)"]);
/// ```
pub fn split(list: &str) -> impl Iterator<Item = &str> {
    let (mut depth, mut is_quoted) = (0_usize, false);
    list.split(move |character| {
        match character {
            '"' => is_quoted = !is_quoted,
            '(' if !is_quoted => depth += 1,
            ')' if !is_quoted => depth = depth.saturating_sub(1),
            _ => {}
        }
        character == ',' && depth == 0 && !is_quoted
    })
}

/// A word as a request has to write it: in quotes where it would be read otherwise.
pub(super) fn written(word: &str) -> String {
    let is_plain = !word.is_empty()
        && word.trim() == word
        && !word.contains(is_special)
        && format!("({word})") != AT_SIN_COS;
    if is_plain {
        word.to_owned()
    } else {
        format!("\"{}\"", word.replace('"', "\"\""))
    }
}

fn is_special(character: char) -> bool {
    "+(),;\"".contains(character)
}

/// How deep parts may stand in parts.
const MOST_DEPTH: usize = 8;

struct Reader<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
}

impl<'a> Reader<'a> {
    /// What is left, from the next character that is no white space.
    fn rest(&self) -> &'a str {
        self.text[self.at..].trim_start()
    }

    fn skip(&mut self) {
        self.at = self.text.len() - self.rest().len();
    }

    fn take(&mut self, character: char) -> bool {
        let Some(rest) = self.rest().strip_prefix(character) else {
            return false;
        };
        self.at = self.text.len() - rest.len();
        true
    }

    fn expect(&mut self, character: char, expected: &'static str) -> Result<(), Unexpected> {
        if self.take(character) {
            Ok(())
        } else {
            Err(self.unexpected(expected))
        }
    }

    fn unexpected(&self, expected: &'static str) -> Unexpected {
        let start = self.text.len() - self.rest().len();
        let length = self.rest().chars().next().map_or(0, char::len_utf8);
        Unexpected {
            expected,
            place: start..start + length,
        }
    }

    /// True where nothing is left but the suffix, which belongs to the whole request.
    fn is_at_suffix(&self) -> bool {
        let inner = self.rest().strip_prefix('(');
        let inner = inner.and_then(|inner| inner.trim_end().strip_suffix(')'));
        inner.is_some_and(|inner| inner.trim() == "sin_cos")
    }

    fn part(&mut self) -> Result<Part, Unexpected> {
        self.skip();
        let start = self.at;
        let name = self.word()?;
        let is_operator = !name.is_quoted && self.rest().starts_with('(');
        let kind = match name.text.as_str() {
            "d" if is_operator => self.derivative()?,
            "packed" if is_operator => self.packed()?,
            "jvp" | "vjp" | "hessian" if is_operator => self.product(name)?,
            _ if self.is_at_suffix() || !self.take('(') => Kind::Named {
                name,
                of: Vec::new(),
            },
            _ => Kind::Named {
                name,
                of: self.words()?,
            },
        };
        Ok(Part {
            kind,
            place: start..self.at,
        })
    }

    /// The part after an opening bracket.
    fn inner(&mut self) -> Result<Box<Part>, Unexpected> {
        self.expect('(', "expected `(`")?;
        if self.depth == MOST_DEPTH {
            return Err(self.unexpected("expected less in one another"));
        }
        self.depth += 1;
        let part = self.part()?;
        self.depth -= 1;
        Ok(Box::new(part))
    }

    fn derivative(&mut self) -> Result<Kind, Unexpected> {
        let of = self.inner()?;
        self.expect(')', "expected `)`")?;
        let expected = "expected `/d(VARIABLES)`";
        self.expect('/', expected)?;
        self.expect('d', expected)?;
        self.expect('(', expected)?;
        let by = self.words()?;
        Ok(Kind::Derivative {
            of,
            by,
            is_packed: false,
        })
    }

    /// A derivative in brackets, after the word before them.
    fn packed(&mut self) -> Result<Kind, Unexpected> {
        let expected = "expected `d(PART)/d(VARIABLES)`";
        self.expect('(', expected)?;
        self.skip();
        let start = self.at;
        let name = self.word()?;
        if !name.is("d") || !self.rest().starts_with('(') {
            self.at = start;
            return Err(self.unexpected(expected));
        }
        let inner = self.derivative()?;
        self.expect(')', "expected `)`")?;
        let Kind::Derivative { of, by, .. } = inner else {
            return Ok(inner);
        };
        Ok(Kind::Derivative {
            of,
            by,
            is_packed: true,
        })
    }

    fn product(&mut self, name: Word) -> Result<Kind, Unexpected> {
        let of = self.inner()?;
        self.expect(';', "expected `; VARIABLES`")?;
        let along = self.words()?;
        Ok(Kind::Product { name, of, along })
    }

    /// Words up to the bracket that closes them.
    fn words(&mut self) -> Result<Vec<Word>, Unexpected> {
        let mut words = vec![self.word()?];
        while self.take(',') {
            words.push(self.word()?);
        }
        self.expect(')', "expected `,` or `)`")?;
        Ok(words)
    }

    /// A word; one without quotes may be empty, and is then no name of anything.
    fn word(&mut self) -> Result<Word, Unexpected> {
        self.skip();
        let start = self.at;
        if self.take('"') {
            return self.quoted(start);
        }
        let rest = &self.text[start..];
        let text = rest[..rest.find(is_special).unwrap_or(rest.len())].trim_end();
        self.at = start + text.len();
        Ok(Word {
            text: text.to_owned(),
            place: start..self.at,
            is_quoted: false,
        })
    }

    /// A word in quotes, after the first of them, which stands at `start`.
    fn quoted(&mut self, start: usize) -> Result<Word, Unexpected> {
        let mut text = String::new();
        loop {
            let rest = &self.text[self.at..];
            let Some(length) = rest.find('"') else {
                self.at = self.text.len();
                return Err(self.unexpected("expected `\"`"));
            };
            text.push_str(&rest[..length]);
            self.at += length + 1;
            if !self.text[self.at..].starts_with('"') {
                break;
            }
            text.push('"');
            self.at += 1;
        }
        Ok(Word {
            text,
            place: start..self.at,
            is_quoted: true,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn expected(text: &str) -> (&'static str, Range<usize>) {
        let Unexpected { expected, place } = read(text).unwrap_err();
        (expected, place)
    }

    #[test]
    fn parts_stand_where_they_are_written() {
        let Sum { parts, at_sin_cos } =
            read("bias + velocity(\"left foot\", local) (sin_cos)").unwrap();
        assert!(at_sin_cos);
        let places: Vec<_> = parts.iter().map(|part| part.place.clone()).collect();
        assert_eq!(places, [0..4, 7..35]);
        let Kind::Named { name, of } = &parts[1].kind else {
            panic!("{parts:?}");
        };
        assert_eq!(name.text, "velocity");
        let of: Vec<_> = of
            .iter()
            .map(|word| (word.text.as_str(), word.place.clone()))
            .collect();
        assert_eq!(of, [("left foot", 16..27), ("local", 29..34)]);
    }

    #[test]
    fn derivatives_and_products_hold_parts() {
        let sum = read("d(pose(tool0))/d(q, u)+vjp(bias; q)").unwrap();
        let Kind::Derivative { of, by, .. } = &sum.parts[0].kind else {
            panic!("{sum:?}");
        };
        assert!(matches!(&of.kind, Kind::Named { name, .. } if name.text == "pose"));
        assert_eq!(by.len(), 2);
        assert!(matches!(&sum.parts[1].kind, Kind::Product { along, .. } if along.len() == 1));
    }

    #[test]
    fn a_frame_called_as_the_suffix_is_quoted() {
        let sum = read("pose(\"sin_cos\")").unwrap();
        assert!(!sum.at_sin_cos);
        assert_eq!(written("sin_cos"), "\"sin_cos\"");
        assert_eq!(written("a/b c"), "a/b c");
    }

    #[test]
    fn any_name_can_be_asked_for() {
        let names = [
            "a\"b", "\"", "\"\"", "a\"", "\"a", "a, b", "a)", "\\", "a\\\"", " a ", "é\"+;",
        ];
        for name in names {
            let request = format!("pose({}, local)", written(name));
            let sum = read(&request).unwrap();
            let Kind::Named { of, .. } = &sum.parts[0].kind else {
                panic!("{sum:?}");
            };
            assert_eq!([&of[0].text, &of[1].text], [name, "local"]);
            let list = format!("bias,{request},q_dot");
            assert_eq!(
                split(&list).collect::<Vec<_>>(),
                ["bias", &request, "q_dot"]
            );
        }
    }

    #[test]
    fn what_is_not_in_the_grammar_is_pointed_at() {
        assert_eq!(expected("pose(tool0"), ("expected `,` or `)`", 10..10));
        assert_eq!(expected("bias)"), ("expected `+` or the end", 4..5));
        assert_eq!(expected("pose(\"tool0)"), ("expected `\"`", 12..12));
        assert_eq!(expected("pose(\"tool0\"\")"), ("expected `\"`", 14..14));
        assert_eq!(expected("d(bias)/q"), ("expected `/d(VARIABLES)`", 8..9));
        assert_eq!(expected("jvp(bias)"), ("expected `; VARIABLES`", 8..9));
        assert_eq!(
            expected("hessian(bias)"),
            ("expected `; VARIABLES`", 12..13)
        );
        let derivative = "expected `d(PART)/d(VARIABLES)`";
        assert_eq!(expected("packed(bias)"), (derivative, 7..8));
        assert_eq!(expected("packed(d)"), (derivative, 7..8));
        assert_eq!(expected("packed(d(bias)/d(q)"), ("expected `)`", 19..19));
    }
}
