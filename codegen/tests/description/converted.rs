//! A model of another format and its conversion to our own give the same module.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;
use std::path::{Path, PathBuf};

use kane_codegen::description::{self, Base, Chart, Reading, no_includes, toml};
use kane_codegen::diagnostic::Source;
use kane_codegen::generate::generate;
use kane_codegen::options::Options;
use kane_codegen::tree::Changes;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../tests")
        .join(name)
}

/// The module without its banner, which names the model and the options.
fn module(source: &Source, reading: &Reading, base: &Path) -> String {
    let options = Options {
        reading: reading.clone(),
        changes: Changes::default(),
        ..Options::default()
    };
    let include = |path: &str| fs::read(base.join(path));
    let generated = generate(source, "model", &options, &include).unwrap();
    let lines = generated.source.lines();
    let code = lines.skip_while(|line| line.starts_with("// "));
    code.collect::<Vec<_>>().join("\n")
}

fn assert_converts(path: &Path, reading: &Reading) {
    let base = path.parent().unwrap();
    let name = path.to_string_lossy();
    let source = Source::new(name.clone(), fs::read_to_string(path).unwrap());
    let include = |path: &str| fs::read(base.join(path));
    let text = toml::write(&description::read(&source, reading, &include)).unwrap();
    let converted = Source::new("converted.toml", text);
    assert!(
        module(&source, reading, base) == module(&converted, &Reading::default(), base),
        "{name} {reading:?}"
    );
    let again = description::read(&converted, &Reading::default(), &no_includes);
    assert_eq!(toml::write(&again).unwrap(), converted.text());
}

#[test]
fn robots_convert() {
    let path = |name: &str| folder("robots").join(name).join(format!("{name}.urdf"));
    for name in ["cartpole", "double_pendulum_continuous", "ur5", "panda"] {
        assert_converts(&path(name), &Reading::default());
    }
    for (name, chart) in [("panda", Chart::Angles), ("solo12", Chart::Quaternion)] {
        let reading = Reading {
            base: Some(Base::Free),
            chart: Some(chart),
            ..Reading::default()
        };
        assert_converts(&path(name), &reading);
    }
}

#[test]
fn mjcf_models_convert() {
    let mut n_models = 0;
    for entry in fs::read_dir(folder("mjcf")).unwrap() {
        let folder = entry.unwrap().path();
        let Some(name) = folder.file_name().and_then(|name| name.to_str()) else {
            continue;
        };
        let path = folder.join(format!("{name}.xml"));
        if path.exists() {
            assert_converts(&path, &Reading::default());
            n_models += 1;
        }
    }
    assert!(n_models >= 14, "{n_models} models were found");
}
