//! What must not be among imports: circles, and modules that stand below.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::krate::{Crate, Imports};

/// The shortest circle through each file that no shorter one names, in lines.
pub(crate) fn circles(imports: &Imports) -> Vec<String> {
    let circles = imports.keys().filter_map(|file| circle(imports, file));
    let mut circles: Vec<Vec<&str>> = circles.collect();
    circles.sort_by_key(Vec::len);
    let mut told: BTreeSet<&str> = BTreeSet::new();
    circles.retain(|circle| {
        let is_new = !circle.iter().all(|file| told.contains(file));
        told.extend(circle);
        is_new
    });
    let lines = circles.iter().map(|circle| {
        let next = circle.iter().cycle().skip(1);
        let pairs = circle.iter().zip(next);
        let lines = pairs.map(|(&file, &next)| {
            let path = &imports[file][next];
            format!("  {file} imports {next}: {path}\n")
        });
        lines.collect()
    });
    lines.collect()
}

/// The shortest way from a file back to it.
fn circle<'a>(imports: &'a Imports, start: &'a str) -> Option<Vec<&'a str>> {
    let mut before: BTreeMap<&str, &str> = BTreeMap::new();
    let mut waiting = VecDeque::from([start]);
    while let Some(file) = waiting.pop_front() {
        for next in imports.get(file).into_iter().flat_map(BTreeMap::keys) {
            if next == start {
                let back = std::iter::successors(Some(file), |file| before.get(file).copied());
                let mut circle: Vec<&str> = back.collect();
                circle.reverse();
                return Some(circle);
            }
            if !before.contains_key(next.as_str()) {
                before.insert(next, file);
                waiting.push_back(next);
            }
        }
    }
    None
}

/// The imports of files from modules that stand below theirs in the root's list, a line each.
pub(crate) fn breaches(all: &Crate) -> Vec<String> {
    let root = &all.modules[0];
    let list = root.children.iter();
    let list: Vec<(&str, &str)> = list
        .map(|(name, place)| (name.as_str(), all.modules[*place].file.as_str()))
        .collect();
    // The module in the list to which a file belongs.
    let place = |file: &str| {
        list.iter().position(|(name, own)| {
            let below = file.strip_prefix(name);
            file == *own || below.is_some_and(|rest| rest.starts_with('/'))
        })
    };
    let mut breaches = Vec::new();
    for (file, imported) in &all.imports() {
        for (other, path) in imported {
            if let (Some(own), Some(other)) = (place(file), place(other))
                && own < other
            {
                let (own, other) = (list[own].0, list[other].0);
                let root = &root.file;
                breaches.push(format!(
                    "{file} imports {path}, but {root} lists `{other}` below `{own}`"
                ));
            }
        }
    }
    breaches
}
