//! Links between pages, and from them to files.

use std::{
    fs,
    path::{Component, Path, PathBuf},
};

use crate::page::{self, Page, repository};

/// Links of a page that lead nowhere.
fn dead(page: &Page) -> Vec<String> {
    let folder = Path::new(&page.path).parent().unwrap();
    let links = page.links.iter().filter(|link| {
        if link.contains("://") {
            return false;
        }
        let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
        let target = if path.is_empty() {
            PathBuf::from(&page.path)
        } else {
            normal(&folder.join(path))
        };
        let target = target.to_str().unwrap();
        if !repository(target).exists() {
            return true;
        }
        !anchor.is_empty() && !page::read(target).anchors.iter().any(|own| own == anchor)
    });
    links.map(|link| format!("{}: {link}", page.path)).collect()
}

/// Without `..`, which could lead out of the repository and in again.
fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for part in path.components() {
        if part == Component::ParentDir {
            assert!(normal.pop(), "{} leaves the repository", path.display());
        } else {
            normal.push(part);
        }
    }
    normal
}

#[test]
fn every_link_and_anchor_leads_somewhere() {
    let mut pages = page::all();
    pages.push(page::read("benches/peers/README.md"));
    let dead: Vec<String> = pages.iter().flat_map(dead).collect();
    assert!(dead.is_empty(), "{dead:#?}");
}

#[test]
fn a_dead_link_is_found() {
    let text = "[a](gone.md) [b](README.md#no-such-heading) [c](README.md#kane)\n";
    let page = page::parse("page.md", text);
    let expected = ["page.md: gone.md", "page.md: README.md#no-such-heading"];
    assert_eq!(dead(&page), expected);
}

#[test]
fn the_book_lists_every_page() {
    let summary = page::read("docs/SUMMARY.md");
    for page in page::all() {
        if let Some(path) = page.path.strip_prefix("docs/")
            && path != "SUMMARY.md"
        {
            assert!(
                summary.links.iter().any(|link| link == path),
                "docs/SUMMARY.md does not list {path}"
            );
        }
    }
}

/// docs.rs shows the page without the files beside it: `src/lib.rs` gives each of its links another target.
#[test]
fn what_rustdoc_includes_links_to_no_file() {
    let path = "docs/conventions.md";
    let text = fs::read_to_string(repository(path)).unwrap();
    let library = fs::read_to_string(repository("src/lib.rs")).unwrap();
    for link in page::read(path).links {
        let definition = text
            .lines()
            .find(|line| line.ends_with(&format!("]: {link}")));
        let (label, _) = definition.unwrap().split_once(':').unwrap();
        assert!(
            library.contains(&format!("#[doc = \"{label}: #")),
            "{path}: {link}"
        );
    }
}
