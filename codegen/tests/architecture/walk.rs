//! Files of a folder, as text.

use std::{collections::BTreeMap, fs, path::Path};

/// What the first line of a generated file begins with.
const GENERATED: &str = "// @generated";

/// Texts by their paths below a folder, with `/` between names.
#[derive(Debug, Default)]
pub(crate) struct Sources(pub(crate) BTreeMap<String, String>);

impl Sources {
    /// All that people wrote in Rust below a folder.
    pub(crate) fn read(folder: &Path) -> Self {
        let mut sources = Self::default();
        sources.add(folder, "");
        assert!(!sources.0.is_empty(), "{} holds no Rust", folder.display());
        sources
    }

    fn add(&mut self, folder: &Path, prefix: &str) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap();
            let place = format!("{prefix}{name}");
            if path.is_dir() && name != "target" {
                self.add(&path, &format!("{place}/"));
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let text = fs::read_to_string(&path).unwrap();
                if !text.starts_with(GENERATED) {
                    self.0.insert(place, text);
                }
            }
        }
    }
}
