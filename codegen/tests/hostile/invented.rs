//! What fuzzing found, and models of this repository with seeded changes.

use kane_codegen::description::Reading;
use kane_test_support::{
    promises::{self, Files},
    random::Random,
};

use crate::common::{everything, files};

#[test]
fn what_fuzzing_found_holds() {
    let found = files("tests/fuzzed", "");
    assert!(!found.is_empty());
    for (name, text) in found {
        let files = Files::new(&name, &text);
        promises::reading(&files, &Reading::default());
        promises::generating(&files, &everything());
    }
}

/// Models of this repository in each format: folders, and how often each of their files is changed. Most of a faulty one is
/// right, and it leads to what right ones do not reach.
const MODELS: [(&str, &str, usize); 8] = [
    ("tests/models", ".toml", 30),
    ("../models", ".toml", 30),
    ("../tests/reference", ".toml", 30),
    ("../tests/robots", ".urdf", 30),
    ("../tests/mjcf", ".xml", 30),
    ("tests/invalid", ".toml", 3),
    ("tests/invalid", ".urdf", 3),
    ("tests/invalid", ".xml", 3),
];

#[test]
fn mutated_models_keep_all_promises() {
    let mut random = Random::new(7);
    let pieces = [
        "\"", "'", "<", ">", "/>", "&", "&#10;", "<!--", "]]>", "\0", "\r", "\u{9b}", "\u{202e}",
        "é", "1e999", "-", "nan", "0", "=", "{", "[", "runtime", "name", "inf", " ",
    ];
    for (path, ending, times) in MODELS {
        let models = files(path, ending);
        assert!(!models.is_empty(), "{path}");
        for (name, model) in models {
            for _ in 0..times {
                let mut text: Vec<char> = model.chars().collect();
                for _ in 0..=random.below(4) {
                    let start = random.below(text.len() + 1);
                    let end = (start + random.below(12)).min(text.len());
                    text.splice(start..end, pieces[random.below(pieces.len())].chars());
                }
                let text: String = text.into_iter().collect();
                promises::reading(&Files::new(&name, &text), &Reading::default());
            }
        }
    }
}
