//! A page of Markdown: its headings, its links, and its blocks of code.
//!
//! A comment in front of a block says what a test does with it:
//!
//! | comment | the block is |
//! | --- | --- |
//! | `file: PATH` | written to this file |
//! | `run` | run by bash, in the folder where the block before it ended |
//! | `run with TOOL` | the same, if the tool can be run |
//! | `output` | what the last run printed, line after line, with other lines between them or not |
//! | `not run: REASON` | left alone |

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// The pages that `tutorials` runs.
pub(crate) const REPLAYED: [&str; 8] = [
    "README.md",
    "docs/start.md",
    "docs/tutorials/arm.md",
    "docs/tutorials/c.md",
    "docs/tutorials/continuous_integration.md",
    "docs/tutorials/floating.md",
    "docs/tutorials/microcontroller.md",
    "docs/tutorials/spacecraft.md",
];

/// What a comment says of the block behind it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Use {
    File(String),
    Run,
    RunWith(String),
    Output,
    NotRun,
}

/// A block of code.
#[derive(Debug)]
pub(crate) struct Block {
    pub(crate) language: String,
    pub(crate) text: String,
    pub(crate) used: Option<Use>,
}

/// What a page holds, as far as tests look at it.
#[derive(Debug)]
pub(crate) struct Page {
    /// From the repository's root.
    pub(crate) path: String,
    pub(crate) blocks: Vec<Block>,
    /// Targets of links and pictures.
    pub(crate) links: Vec<String>,
    /// What a link puts behind `#` to lead to a heading.
    pub(crate) anchors: Vec<String>,
}

/// A file of this repository.
pub(crate) fn repository(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join(path)
}

/// README.md, the changelog and all pages of `docs`, in alphabetical order.
pub(crate) fn all() -> Vec<Page> {
    let mut paths = vec!["CHANGELOG.md".to_owned(), "README.md".to_owned()];
    add("docs", &mut paths);
    paths.sort();
    paths.iter().map(|path| read(path)).collect()
}

fn add(folder: &str, paths: &mut Vec<String>) {
    for entry in fs::read_dir(repository(folder)).unwrap() {
        let entry = entry.unwrap();
        let path = format!("{folder}/{}", entry.file_name().to_str().unwrap());
        if entry.file_type().unwrap().is_dir() {
            add(&path, paths);
        } else if Path::new(&path)
            .extension()
            .is_some_and(|ending| ending == "md")
        {
            paths.push(path);
        }
    }
}

/// Reads a page; the path begins at the repository's root.
pub(crate) fn read(path: &str) -> Page {
    let text = fs::read_to_string(repository(path)).unwrap();
    parse(path, &text)
}

/// Reads a page's text.
pub(crate) fn parse(path: &str, text: &str) -> Page {
    let mut page = Page {
        path: path.to_owned(),
        blocks: Vec::new(),
        links: Vec::new(),
        anchors: Vec::new(),
    };
    let mut used = None;
    let mut code: Option<Block> = None;
    let mut heading: Option<String> = None;
    let mut seen = BTreeMap::new();
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        match event {
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                page.links.push(dest_url.into_string());
            }
            Event::Html(html) => used = comment(path, &html).or(used),
            Event::Start(Tag::CodeBlock(kind)) => {
                let language = match kind {
                    CodeBlockKind::Fenced(language) => language.into_string(),
                    CodeBlockKind::Indented => "text".to_owned(),
                };
                code = Some(Block {
                    language,
                    text: String::new(),
                    used: used.take(),
                });
            }
            Event::End(TagEnd::CodeBlock) => page.blocks.extend(code.take()),
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => {
                let anchor = anchor(&heading.take().unwrap());
                let before = seen.entry(anchor.clone()).or_insert(0_usize);
                page.anchors.push(match *before {
                    0 => anchor,
                    n => format!("{anchor}-{n}"),
                });
                *before += 1;
            }
            Event::Text(text) | Event::Code(text) => {
                if let Some(block) = &mut code {
                    block.text.push_str(&text);
                } else if let Some(heading) = &mut heading {
                    heading.push_str(&text);
                }
            }
            _ => {}
        }
    }
    assert_eq!(used, None, "{path}: a comment without its block");
    page
}

/// What a comment says; nothing of what is no comment.
fn comment(path: &str, html: &str) -> Option<Use> {
    let words = html
        .trim()
        .strip_prefix("<!--")?
        .strip_suffix("-->")?
        .trim();
    if let Some(file) = words.strip_prefix("file: ") {
        return Some(Use::File(file.to_owned()));
    }
    if let Some(tool) = words.strip_prefix("run with ") {
        return Some(Use::RunWith(tool.to_owned()));
    }
    match words {
        "run" => Some(Use::Run),
        "output" => Some(Use::Output),
        _ if words.starts_with("not run: ") => Some(Use::NotRun),
        _ => panic!("{path}: unknown comment `{words}`"),
    }
}

/// A heading as hosts of code and mdBook write it behind `#`.
fn anchor(heading: &str) -> String {
    let letters = heading.to_lowercase();
    let letters = letters.chars().filter_map(|letter| match letter {
        ' ' => Some('-'),
        '-' | '_' => Some(letter),
        _ if letter.is_alphanumeric() => Some(letter),
        _ => None,
    });
    letters.collect()
}
