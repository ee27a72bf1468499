//! The paths that items name.

use std::collections::BTreeSet;

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{
    Item, UseTree, Visibility,
    parse::{Parse, Parser},
};

/// Macros whose tokens are text of another program.
pub(crate) const QUOTES: [&str; 3] = ["quote", "quote_spanned", "parse_quote"];

/// A name that a `use` brings.
#[derive(Debug)]
pub(crate) struct Use {
    /// The name; `None` for all names of a module.
    pub(crate) name: Option<String>,
    /// What it stands for.
    pub(crate) path: Vec<String>,
    /// Whether others can have it from here.
    pub(crate) is_public: bool,
}

/// What code speaks of.
#[derive(Debug, Default)]
pub(crate) struct Spoken {
    /// Paths of at least two names.
    pub(crate) paths: Vec<Vec<String>>,
    /// All names.
    pub(crate) names: BTreeSet<String>,
}

/// The names that a `use` brings.
pub(crate) fn of_use(item: &syn::ItemUse) -> Vec<Use> {
    let is_public = !matches!(item.vis, Visibility::Inherited);
    let mut uses = Vec::new();
    if item.leading_colon.is_none() {
        of_tree(&item.tree, &[], is_public, &mut uses);
    }
    uses
}

fn of_tree(tree: &UseTree, before: &[String], is_public: bool, uses: &mut Vec<Use>) {
    let path_to = |name: &dyn ToString| {
        let name = name.to_string();
        let own = (name != "self" || before.is_empty()).then_some(name);
        before.iter().cloned().chain(own).collect::<Vec<String>>()
    };
    let mut add = |name: Option<String>, path| {
        uses.push(Use {
            name,
            path,
            is_public,
        });
    };
    match tree {
        UseTree::Path(part) => of_tree(&part.tree, &path_to(&part.ident), is_public, uses),
        UseTree::Name(part) => {
            let path = path_to(&part.ident);
            add(path.last().cloned(), path);
        }
        UseTree::Rename(part) => add(Some(part.rename.to_string()), path_to(&part.ident)),
        UseTree::Glob(_) => add(None, before.to_vec()),
        UseTree::Group(group) => {
            for tree in &group.items {
                of_tree(tree, before, is_public, uses);
            }
        }
    }
}

/// What an item that is neither a `use` nor a module speaks of.
pub(crate) fn of_item(item: &Item, spoken: &mut Spoken) {
    of_tokens(item.to_token_stream(), spoken);
}

fn of_tokens(tokens: TokenStream, spoken: &mut Spoken) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut rest = &tokens[..];
    while !rest.is_empty() {
        rest = &rest[of_first(rest, spoken)..];
    }
}

/// Reads what tokens begin with, and tells how many that are.
fn of_first(tokens: &[TokenTree], spoken: &mut Spoken) -> usize {
    match tokens {
        [TokenTree::Group(group), ..] => {
            of_tokens(group.stream(), spoken);
            1
        }
        [TokenTree::Ident(word), TokenTree::Ident(_), ..] if word == "use" => {
            let end = tokens.iter().position(|token| is(token, ';'));
            let end = end.unwrap_or(tokens.len());
            let mut uses = Vec::new();
            if let Ok(tree) = UseTree::parse.parse2(tokens[1..end].iter().cloned().collect()) {
                of_tree(&tree, &[], false, &mut uses);
            }
            spoken.paths.extend(uses.into_iter().map(|one| one.path));
            end
        }
        // Whom something is visible to.
        [TokenTree::Ident(word), TokenTree::Group(_), ..] if word == "pub" => 2,
        [TokenTree::Ident(word), bang, TokenTree::Group(_), ..]
            if is(bang, '!') && QUOTES.contains(&&*word.to_string()) =>
        {
            3
        }
        // What is left of a value, and its fields and methods.
        [one, other, ..] if is(one, '.') && is(other, '.') => 2,
        [dot, TokenTree::Ident(_), ..] if is(dot, '.') => 2,
        [TokenTree::Ident(_), ..] => {
            let path = path(tokens);
            let read = 3 * path.len() - 2;
            spoken.names.extend(path.iter().cloned());
            if path.len() > 1 {
                spoken.paths.push(path);
            }
            read
        }
        // What is named by its crate, or of a type.
        [_, _, rest @ ..] if is_colons(tokens) => 2 + (3 * path(rest).len()).saturating_sub(2),
        _ => 1,
    }
}

/// The names with which tokens begin, with `::` between them.
fn path(mut tokens: &[TokenTree]) -> Vec<String> {
    let mut path = Vec::new();
    while let [TokenTree::Ident(name), rest @ ..] = tokens {
        path.push(name.to_string());
        tokens = match rest {
            [_, _, rest @ ..] if is_colons(tokens.get(1..).unwrap_or_default()) => rest,
            _ => &[],
        };
    }
    path
}

fn is_colons(tokens: &[TokenTree]) -> bool {
    matches!(tokens, [one, other, ..] if is(one, ':') && is(other, ':'))
}

fn is(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}
