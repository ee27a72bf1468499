//! What all items have: names, documentation, what they allow, and how they are printed.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::{File, Item, Stmt, parse_quote};

/// What stands for a comment until it is printed: syntax has none.
const COMMENT: &str = "kane_comment!(";

/// Items as prettyplease prints them, each after an empty line. They are made one by one: of long ones only one is in memory.
pub(super) fn printed(items: impl IntoIterator<Item = Item>) -> String {
    let mut text = String::new();
    for item in items {
        text.push('\n');
        let printed = prettyplease::unparse(&File {
            shebang: None,
            frontmatter: None,
            attrs: Vec::new(),
            items: vec![item],
        });
        text.push_str(&with_comments(&printed));
    }
    text
}

/// A statement that is printed as a comment. The words hold no quote.
pub(super) fn comment(words: &str) -> Stmt {
    parse_quote!(kane_comment!(#words);)
}

/// The text with comments where their statements stand, each on a line of its own.
fn with_comments(printed: &str) -> String {
    let mut text = String::with_capacity(printed.len());
    let mut lines = printed.split_inclusive('\n');
    while let Some(line) = lines.next() {
        let indent = &line[..line.len() - line.trim_start().len()];
        let Some(first) = line.trim_start().strip_prefix(COMMENT) else {
            text.push_str(line);
            continue;
        };
        // A long one is printed over several lines.
        let mut call = first.to_owned();
        while !call.trim_end().ends_with(");") {
            match lines.next() {
                Some(line) => call.push_str(line),
                None => break,
            }
        }
        let words = call.trim().trim_end_matches(");").trim().trim_matches('"');
        text.extend([indent, "// ", words, "\n"]);
    }
    text
}

/// Where a module comes from, as comments.
pub(super) fn banner(lines: &[String]) -> String {
    lines.iter().flat_map(|line| ["// ", line, "\n"]).collect()
}

/// An identifier. Names are made clear of Rust's keywords (`words`), so none is escaped.
pub(super) fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// Documentation, a line each.
pub(super) fn doc<S: AsRef<str>>(lines: impl IntoIterator<Item = S>) -> TokenStream {
    let lines = lines.into_iter().map(|line| {
        let line = line.as_ref();
        if line.is_empty() {
            String::new()
        } else {
            format!(" {line}")
        }
    });
    quote!(#(#[doc = #lines])*)
}

/// What items allow, and why: a module holds more than one program calls.
pub(super) fn allow_unused() -> TokenStream {
    quote!(#[allow(dead_code, reason = "a program calls what it needs")])
}

/// The same of data.
pub(super) fn allow_numbers() -> TokenStream {
    quote!(#[allow(dead_code, clippy::approx_constant, reason = "numbers are the model's")])
}

/// What code allows, and why: arguments follow one pattern, whether used or not, and numbers are the model's.
pub(super) fn allow_generated() -> TokenStream {
    quote! {
        #[allow(
            dead_code,
            unused_variables,
            clippy::approx_constant,
            clippy::many_single_char_names,
            clippy::needless_late_init,
            clippy::too_many_arguments,
            reason = "generated: arguments follow one pattern, numbers are the model's"
        )]
    }
}
