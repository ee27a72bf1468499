//! The text of a module as Rust, whatever it holds: syntax that is nested very deep would not fit the stack.

use std::{mem, thread};

use proc_macro2::{Delimiter, TokenStream, TokenTree, token_stream};
use syn::{Error, File, Result};

/// The most tokens that stand open: in each group around a place those since what ended last, an item, a statement or an
/// entry of a list. Our own modules have two thousand.
pub const MOST_OPEN: usize = 10_000;
/// What these need of a stack.
const STACK: usize = 256 << 20;

/// What `work` makes of a text, or why it is no Rust that can be read. It has no `#!` line: a module begins with its banner.
///
/// # Errors
/// Syntax that is none, or nested deeper than [`MOST_OPEN`] tokens.
pub fn read<T: Send>(text: &str, work: impl FnOnce(File) -> T + Send) -> Result<T> {
    let read = || {
        let tokens: TokenStream = text.parse()?;
        check_depth(tokens.clone())?;
        syn::parse2(tokens).map(work)
    };
    thread::scope(|scope| {
        let builder = thread::Builder::new().stack_size(STACK);
        let started = builder.spawn_scoped(scope, read);
        let started = started.map_err(|error| Error::new(proc_macro2::Span::call_site(), error))?;
        let joined = started.join();
        joined.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

/// A group of tokens, read as far as this.
struct Open {
    tokens: token_stream::IntoIter,
    is_file: bool,
    since: Since,
}

/// What stands in a group since something ended there.
#[derive(Default)]
struct Since {
    n_tokens: usize,
    /// `<` without its `>`, or a comparison.
    n_angles: usize,
    /// A `|`: maybe that of a closure, whose parameters a comma does not end.
    has_bar: bool,
    /// A `=`: a value follows, which a block does not end.
    has_equals: bool,
    /// The token before is the first half of `->` or `=>`.
    is_arrow: bool,
}

impl Since {
    fn see(&mut self, token: &TokenTree) {
        self.n_tokens += 1;
        let was_arrow = mem::take(&mut self.is_arrow);
        let TokenTree::Punct(mark) = token else {
            return;
        };
        match mark.as_char() {
            '<' => self.n_angles += 1,
            '>' if !was_arrow => self.n_angles = self.n_angles.saturating_sub(1),
            '|' => self.has_bar = true,
            '-' => self.is_arrow = true,
            '=' => (self.is_arrow, self.has_equals) = (true, true),
            _ => {}
        }
    }

    /// True where nothing goes on behind this token that stood open before it.
    fn ends_with(&self, token: &TokenTree, is_file: bool) -> bool {
        match token {
            TokenTree::Punct(mark) if mark.as_char() == ';' => true,
            TokenTree::Punct(mark) if mark.as_char() == ',' => self.n_angles == 0 && !self.has_bar,
            // The body of a function, say.
            TokenTree::Group(group) if is_file && group.delimiter() == Delimiter::Brace => {
                self.n_angles == 0 && !self.has_equals
            }
            _ => false,
        }
    }
}

fn check_depth(tokens: TokenStream) -> Result<()> {
    let open = |tokens: TokenStream, is_file| Open {
        tokens: tokens.into_iter(),
        is_file,
        since: Since::default(),
    };
    let mut groups = vec![open(tokens, true)];
    let mut n_open = 0;
    while let Some(group) = groups.last_mut() {
        let Some(token) = group.tokens.next() else {
            n_open -= group.since.n_tokens;
            groups.pop();
            continue;
        };
        group.since.see(&token);
        n_open += 1;
        if n_open > MOST_OPEN {
            return Err(Error::new(token.span(), "nested too deep"));
        }
        if group.since.ends_with(&token, group.is_file) {
            n_open -= mem::take(&mut group.since).n_tokens;
        }
        if let TokenTree::Group(inner) = token {
            groups.push(open(inner.stream(), false));
        }
    }
    Ok(())
}
