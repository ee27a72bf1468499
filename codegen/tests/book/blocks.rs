//! Every block of code is tested, or says that it is not.

use std::fs;

use kane_codegen::{config, description::toml, diagnostic::Source, tree};

use crate::page::{self, Block, Page, REPLAYED, Use, repository};

/// What is wrong with a block's language and comment; none if a test looks at it.
fn untested(page: &Page, block: &Block) -> Option<String> {
    let replayed = REPLAYED.contains(&&*page.path);
    let why = match (&*block.language, &block.used) {
        ("text", None) | ("sh", Some(Use::NotRun)) => return None,
        (_, Some(used)) if *used != Use::NotRun => {
            if replayed {
                return None;
            }
            "is of no tutorial that is run"
        }
        ("rust", None) if doc_tested(&page.path) => return None,
        ("rust", None) => "is of a page that src/lib.rs does not include",
        ("toml", None) => match read(&block.text) {
            Ok(()) => return None,
            Err(faults) => return Some(faults),
        },
        _ => "is not tested; mark it as text, or say with a comment what it is",
    };
    Some(why.to_owned())
}

fn doc_tested(path: &str) -> bool {
    let library = fs::read_to_string(repository("src/lib.rs")).unwrap();
    library.contains(&format!("include_str!(\"../{path}\")"))
}

/// Reads a `kane.toml`, a model, or a part of one.
fn read(text: &str) -> Result<(), String> {
    if text.contains("[[system]]") {
        return match config::parse(&Source::new("kane.toml", text)) {
            Ok(_) => Ok(()),
            Err(faults) => Err(faults.to_string()),
        };
    }
    let body = "name = \"part\"\nlower_bodies = [0]\n[[body]]\nname = \"hand\"\nmass = 1.0\nmass_center = [0.0, 0.0, 0.0]\n\
        inertia = { xx = 0.1, yy = 0.1, zz = 0.1, xy = 0.0, xz = 0.0, yz = 0.0 }\n\
        attachment = [0.0, 0.0, 0.0]\njoint = \"free\"\n";
    let text = if text.contains("lower_bodies") {
        text.to_owned()
    } else {
        format!("{body}{text}")
    };
    let description = toml::parse(&Source::new("model.toml", text));
    match tree::build(&description) {
        Ok(_) => Ok(()),
        Err(faults) => Err(faults.to_string()),
    }
}

#[test]
fn every_block_of_code_is_tested_or_marked_as_text() {
    let mut found = Vec::new();
    for page in page::all() {
        for block in &page.blocks {
            if let Some(why) = untested(&page, block) {
                found.push(format!("{}: this block {why}\n{}", page.path, block.text));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n\n"));
}

#[test]
fn a_faulty_model_in_a_page_is_found() {
    assert!(read("[[frame]]\nname = \"tool\"\nbody = \"arm\"\n").is_err());
    assert!(read("[[system]]\nmodel = \"arm.toml\"\noutptu = \"arm.rs\"\n").is_err());
    assert!(read("lower_bodies = [0]\n").is_err());
}
