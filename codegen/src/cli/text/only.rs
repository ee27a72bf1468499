//! What alone differs between two texts: told by their tokens, for a number or a name of another length wraps lines.

use std::{collections::BTreeMap, iter};

/// What alone differs between two texts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Only {
    /// Spaces outside strings, line ends, commas before closing brackets.
    Layout,
    /// Comments; with those of items, which are documentation.
    Comments,
    /// These, and numbers of the model.
    Numbers,
    /// Comments, and names, each in all of its places.
    Names,
}

impl Only {
    /// The second text is what we write.
    pub(super) fn of(old: &str, new: &str) -> Option<Self> {
        let texts = Texts {
            has_comments: !new.starts_with(JSON),
        };
        let have_same_comments = texts.comments(old).eq(texts.comments(new));
        if texts.code(old).eq(texts.code(new)) {
            return Some(if have_same_comments {
                Self::Layout
            } else {
                Self::Comments
            });
        }
        let have_same_items = texts.items(old).eq(texts.items(new));
        let (old, new) = (texts.tokens(old), texts.tokens(new));
        if old == new {
            return have_same_comments.then_some(Self::Layout);
        }
        let [old_masked, new_masked] =
            [&old, &new].map(|tokens| tokens.iter().copied().map(Token::masked));
        if old_masked.eq(new_masked) {
            Some(Self::Numbers)
        } else if have_same_items {
            Some(Self::Comments)
        } else if are_renamed(&old, &new) {
            Some(Self::Names)
        } else {
            None
        }
    }
}

/// How a manifest begins; it has no comments.
const JSON: char = '{';

/// What lines of two texts are.
#[derive(Clone, Copy)]
struct Texts {
    has_comments: bool,
}

/// A piece of code.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Token<'a> {
    /// A name or a keyword.
    Word(&'a str),
    /// A number of the model: it has a decimal point or an exponent; with a minus that opens an argument or an entry.
    Real(&'a str),
    /// A hash, which changes with all of them.
    Hash(&'a str),
    /// Everything else, indexes and lengths too.
    Other(&'a str),
}

impl Token<'_> {
    /// The same for all numbers of the model.
    fn masked(self) -> Self {
        match self {
            Self::Real(_) => Self::Real(""),
            Self::Hash(_) => Self::Hash(""),
            token => token,
        }
    }
}

/// True where each name stands for one other, in all of its places.
fn are_renamed(old: &[Token<'_>], new: &[Token<'_>]) -> bool {
    let (mut there, mut back) = (BTreeMap::new(), BTreeMap::new());
    let mut pairs = iter::zip(old, new);
    let are_alike = |(old, new)| match (old, new) {
        (&Token::Word(old), &Token::Word(new)) => {
            *there.entry(old).or_insert(new) == new && *back.entry(new).or_insert(old) == old
        }
        (Token::Hash(_), Token::Hash(_)) => true,
        (old, new) => old == new,
    };
    old.len() == new.len() && pairs.all(are_alike)
}

impl Texts {
    /// The lines without comments that no item has.
    fn code(self, text: &str) -> impl Iterator<Item = &str> {
        text.lines().filter(move |line| !self.is_comment(line))
    }

    /// The comments that no item has.
    fn comments(self, text: &str) -> impl Iterator<Item = &str> {
        text.lines().filter(move |line| self.is_comment(line))
    }

    /// The lines without comments of any kind.
    fn items(self, text: &str) -> impl Iterator<Item = &str> {
        let is_item =
            move |line: &&str| !(self.has_comments && line.trim_start().starts_with("//"));
        text.lines().filter(is_item)
    }

    fn is_comment(self, line: &str) -> bool {
        self.has_comments && line.starts_with("//") && !line.starts_with("///")
    }

    /// The code without what only lays it out: spaces outside strings, line ends, commas before closing brackets.
    fn tokens(self, text: &str) -> Vec<Token<'_>> {
        let mut tokens = Vec::new();
        for line in self.code(text) {
            let line = line.trim_start();
            let mut rest = line.strip_prefix("///").unwrap_or(line).trim_start();
            let mut is_in_string = false;
            while !rest.is_empty() {
                let (token, after) = first(rest, tokens.last());
                let closes = matches!(token, Token::Other(")" | "]" | "}"));
                if closes && tokens.last() == Some(&Token::Other(",")) {
                    tokens.pop();
                }
                tokens.push(token);
                is_in_string ^= token == Token::Other("\"");
                rest = if is_in_string {
                    after
                } else {
                    after.trim_start()
                };
            }
        }
        tokens
    }
}

/// The token with which a text begins, and the rest.
fn first<'a>(text: &'a str, previous: Option<&Token<'_>>) -> (Token<'a>, &'a str) {
    let starts_number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
    let opens = matches!(
        previous,
        Some(Token::Other("(" | "[" | "{" | "," | "=" | ":"))
    );
    let sign = usize::from(opens && text.starts_with('-'));
    if starts_number(&text[sign..]) {
        let (token, rest) = text.split_at(sign + number(&text[sign..]));
        let token = match token {
            hash if hash.starts_with("0x") => Token::Hash(hash),
            range if range.contains("..") => Token::Other(range),
            real if real.contains(['.', 'e', 'E']) => Token::Real(real),
            index => Token::Other(index),
        };
        return (token, rest);
    }
    let is_in_name = |character: char| character.is_alphanumeric() || character == '_';
    let word = text.find(|character| !is_in_name(character));
    match word.unwrap_or(text.len()) {
        0 => {
            let length = text.chars().next().map_or(0, char::len_utf8);
            let (token, rest) = text.split_at(length);
            (Token::Other(token), rest)
        }
        length => {
            let (word, rest) = text.split_at(length);
            (Token::Word(word), rest)
        }
    }
}

/// How long the number is with which a text begins.
fn number(text: &str) -> usize {
    let mut previous = ' ';
    let mut goes_on = |character: char| {
        let signs = matches!(character, '+' | '-') && matches!(previous, 'e' | 'E');
        let goes_on = character.is_ascii_alphanumeric() || matches!(character, '.' | '_') || signs;
        previous = character;
        goes_on
    };
    text.find(|character| !goes_on(character))
        .unwrap_or(text.len())
}
