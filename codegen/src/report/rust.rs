//! The text of a module as Rust, whatever it holds: syntax that is nested very deep would not fit the stack.

use std::thread;

use proc_macro2::{TokenStream, TokenTree};
use syn::{Error, File, Result};

/// The most tokens that stand open: in each group around a place those since its last comma or semicolon. Our own modules
/// have two thousand.
const MOST_OPEN: usize = 10_000;
/// What these need of a stack.
const STACK: usize = 256 << 20;

/// What `work` makes of a text, or why it is no Rust that can be read.
pub(super) fn read<T: Send>(text: &str, work: impl FnOnce(File) -> T + Send) -> Result<T> {
    let read = || {
        if let Ok(tokens) = text.parse() {
            check_depth(tokens)?;
        }
        syn::parse_file(text).map(work)
    };
    thread::scope(|scope| {
        let builder = thread::Builder::new().stack_size(STACK);
        let started = builder.spawn_scoped(scope, read);
        let started = started.map_err(|error| Error::new(proc_macro2::Span::call_site(), error))?;
        let joined = started.join();
        joined.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

fn check_depth(tokens: TokenStream) -> Result<()> {
    let mut open = vec![(tokens.into_iter(), 0_usize)];
    let mut n_open = 0;
    while let Some((tokens, own)) = open.last_mut() {
        let Some(token) = tokens.next() else {
            n_open -= *own;
            open.pop();
            continue;
        };
        match &token {
            TokenTree::Punct(mark) if [',', ';'].contains(&mark.as_char()) => {
                n_open -= *own;
                *own = 0;
            }
            _ => (*own, n_open) = (*own + 1, n_open + 1),
        }
        if n_open > MOST_OPEN {
            return Err(Error::new(token.span(), "nested too deep"));
        }
        if let TokenTree::Group(group) = token {
            open.push((group.stream().into_iter(), 0));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn syntax_nested_too_deep_is_an_error() {
        let many = |text: &str| text.repeat(200_000);
        for deep in [
            format!("const A: f64 = {}1{};", many("("), many(")")),
            format!("const A: f64 = {}1;", many("-")),
            format!("const A: f64 = 1{};", many("+1")),
            format!("const A: {}u8 = 1;", many("&")),
            format!("fn a() {{ {} }}", many("if a {} else ")),
        ] {
            assert!(read(&deep, drop).is_err());
        }
        let wide = format!("const A: [f64; 200000] = [{}];", many("1.0, "));
        assert!(read(&wide, drop).is_ok());
    }
}
