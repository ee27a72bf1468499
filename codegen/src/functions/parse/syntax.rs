//! The grammar of requests: text to a syntax tree, with the place of every word.
//!
//! ```text
//! request = [name "="] part ("+" part)* ["(sin_cos)"]
//! part    = "d" "(" part ")" "/" "d" "(" words ")"
//!         | "packed" "(" part ")"
//!         | ("jvp" | "vjp" | "hessian") "(" part ";" words ")"
//!         | word ["(" words ")"]
//! words   = word ("," word)*
//! name    = characters other than = + ( ) , ; "
//! word    = characters other than + ( ) , ; " | '"' (a character other than " | '""')* '"'
//! ```
//!
//! White space around words says nothing. Between quotes, `""` is one quote. Does not: know a function, a frame or a variable.

use std::ops::Range;

use crate::limits;

/// What stands after a request whose function is given sines and cosines.
pub const AT_SIN_COS: &str = "(sin_cos)";

/// What stands behind a frame whose own axes are meant; a frame of this name stands in quotes.
pub const LOCAL: &str = "local";

/// A request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sum {
    /// What the function is to be called.
    pub name: Option<Word>,
    /// What is asked for together, in order.
    pub parts: Vec<Part>,
    /// True where the function is given sines and cosines.
    pub at_sin_cos: bool,
}

/// A part of a request, and the place where it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// What it asks for.
    pub kind: Kind,
    /// Its bytes in the request.
    pub place: Range<usize>,
}

/// What a part asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the examples say what each field is")]
pub enum Kind {
    /// `rotation`, or `pose(tool0)`.
    Named { name: Word, of: Vec<Word> },
    /// `d(bias)/d(q, u)`.
    Derivative { of: Box<Part>, by: Vec<Word> },
    /// `packed(d(bias)/d(q, u))`.
    Packed { of: Box<Part> },
    /// `jvp(bias; q, u)`.
    Product {
        product: Product,
        of: Box<Part>,
        along: Vec<Word>,
    },
}

/// What is made of derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Product {
    /// Their product with a direction.
    Jvp,
    /// A multiplier's product with them.
    Vjp,
    /// Second derivatives, times a multiplier.
    Hessian,
}

impl Product {
    /// All of them, with their names.
    pub const NAMED: [(&str, Self); 3] = [
        ("jvp", Self::Jvp),
        ("vjp", Self::Vjp),
        ("hessian", Self::Hessian),
    ];

    fn named(name: &str) -> Option<Self> {
        let mut named = Self::NAMED.into_iter();
        named.find(|(own, _)| *own == name).map(|(_, own)| own)
    }

    /// What stands where variables are lacking.
    fn expected_variables(self) -> &'static str {
        match self {
            Self::Jvp => "expected `; VARIABLES`, as in `jvp(inverse_dynamics; q, u)`",
            Self::Vjp => "expected `; VARIABLES`, as in `vjp(inverse_dynamics; q, u)`",
            Self::Hessian => "expected `; VARIABLES`, as in `hessian(inverse_dynamics; q, u)`",
        }
    }
}

/// A name, without its quotes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// Its characters.
    pub text: String,
    /// Its bytes in the request, quotes included.
    pub place: Range<usize>,
    is_quoted: bool,
}

impl Word {
    /// True for this word without quotes, which is then no name.
    pub fn is(&self, word: &str) -> bool {
        !self.is_quoted && self.text == word
    }
}

/// What the grammar does not allow, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unexpected {
    /// What is allowed there, in words.
    pub expected: &'static str,
    /// The bytes of the request that stand there instead; none at its end.
    pub place: Range<usize>,
}

/// Reads a request.
///
/// # Errors
/// The first place that the grammar does not allow.
pub fn read(text: &str) -> Result<Sum, Unexpected> {
    let mut reader = Reader {
        text,
        at: 0,
        depth: 0,
        n_words: 0,
    };
    let name = reader.name();
    let mut parts = vec![reader.part()?];
    while reader.take('+') {
        parts.push(reader.part()?);
    }
    let at_sin_cos = reader.is_at_suffix();
    if !at_sin_cos && !reader.rest().is_empty() {
        return Err(reader.unexpected(if reader.rest().starts_with('/') {
            "expected `+` or the end; second derivatives are `hessian(PART; VARIABLES)`"
        } else {
            "expected `+` or the end"
        }));
    }
    Ok(Sum {
        name,
        parts,
        at_sin_cos,
    })
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
    split_at(list, ',')
}

/// Takes a text apart at the separators that stand in no brackets and no quotes.
pub(crate) fn split_at(text: &str, separator: char) -> impl Iterator<Item = &str> {
    let (mut depth, mut is_quoted) = (0_usize, false);
    text.split(move |character| {
        match character {
            '"' => is_quoted = !is_quoted,
            '(' if !is_quoted => depth += 1,
            ')' if !is_quoted => depth = depth.saturating_sub(1),
            _ => {}
        }
        character == separator && depth == 0 && !is_quoted
    })
}

/// A word as a request has to write it: in quotes where it would be read otherwise.
pub fn written(word: &str) -> String {
    let is_plain = !word.is_empty()
        && word.trim() == word
        && !word.contains(is_special)
        && word != LOCAL
        && format!("({word})") != AT_SIN_COS;
    if is_plain {
        word.to_owned()
    } else {
        format!("\"{}\"", word.replace('"', "\"\""))
    }
}

/// A request by the texts of its parts.
pub fn sum(parts: impl Iterator<Item = String>, at_sin_cos: bool) -> String {
    let parts: Vec<String> = parts.collect();
    parts.join("+") + if at_sin_cos { AT_SIN_COS } else { "" }
}

/// A request with what its function is to be called.
pub fn named(name: Option<&str>, sum: String) -> String {
    match name {
        Some(name) => format!("{name} = {sum}"),
        None => sum,
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
    n_words: usize,
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

    /// What stands before the first `=`, if that comes before all that a part may have.
    fn name(&mut self) -> Option<Word> {
        self.skip();
        let (start, rest) = (self.at, self.rest());
        let end = rest.find(|character| character == '=' || is_special(character))?;
        if !rest[end..].starts_with('=') {
            return None;
        }
        let text = rest[..end].trim_end().to_owned();
        self.at = start + end + 1;
        Some(Word {
            place: start..start + text.len(),
            text,
            is_quoted: false,
        })
    }

    fn part(&mut self) -> Result<Part, Unexpected> {
        self.skip();
        let start = self.at;
        let name = self.word()?;
        let is_operator = !name.is_quoted && self.rest().starts_with('(');
        let product = Product::named(&name.text).filter(|_| is_operator);
        let kind = match (name.text.as_str(), product) {
            (_, Some(product)) => self.product(product)?,
            ("d", None) if is_operator => self.derivative()?,
            ("packed", None) if is_operator => self.packed()?,
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
        self.expect(')', self.unless_sum("expected `)`"))?;
        let expected = "expected `/d(VARIABLES)`, as in `d(forward_dynamics)/d(q, u, tau)`";
        self.expect('/', expected)?;
        self.expect('d', expected)?;
        self.expect('(', expected)?;
        let by = self.words()?;
        Ok(Kind::Derivative { of, by })
    }

    /// What is expected after the part that an operator is of.
    fn unless_sum(&self, expected: &'static str) -> &'static str {
        if self.rest().starts_with('+') {
            "differentiate each part by itself, and join what comes of them with `+`"
        } else {
            expected
        }
    }

    fn packed(&mut self) -> Result<Kind, Unexpected> {
        let of = self.inner()?;
        let expected = if self.rest().starts_with('+') {
            "a part is packed by itself, and joined outside: `forward_dynamics+packed(d(forward_dynamics)/d(q, u))`"
        } else {
            "expected `)`"
        };
        self.expect(')', expected)?;
        Ok(Kind::Packed { of })
    }

    fn product(&mut self, product: Product) -> Result<Kind, Unexpected> {
        let of = self.inner()?;
        self.expect(';', self.unless_sum(product.expected_variables()))?;
        let along = self.words()?;
        Ok(Kind::Product { product, of, along })
    }

    /// Words up to the bracket that closes them.
    fn words(&mut self) -> Result<Vec<Word>, Unexpected> {
        let mut words = vec![self.word()?];
        while self.take(',') {
            words.push(self.word()?);
        }
        let expected = match self.rest().chars().next() {
            Some(';') => {
                "expected `,` or `)`; with `;` there are `jvp(F; X)`, `vjp(F; X)`, the gradient, and `hessian(F; X)`; a name that contains `;` stands in quotes"
            }
            Some('+' | '(' | '"') => {
                "expected `,` or `)`; a name that contains `+`, `(` or `\"` stands in quotes"
            }
            _ => "expected `,` or `)`",
        };
        self.expect(')', expected)?;
        Ok(words)
    }

    /// A word; one without quotes may be empty, and is then no name of anything.
    fn word(&mut self) -> Result<Word, Unexpected> {
        self.skip();
        self.n_words += 1;
        if self.n_words > limits::REQUEST_WORDS {
            return Err(self.unexpected("expected a thousand words at most"));
        }
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
