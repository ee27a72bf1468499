//! A module and its tests as a crate, compiled and run by itself.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Output},
    sync::OnceLock,
};

use kane_codegen::{
    companions::CompanionKind, config::Functions, description::no_includes, diagnostic::Source,
    generate::generate, options::Options,
};

/// The file of the crate `kane`, compiled once without features.
fn runtime() -> &'static Path {
    static RUNTIME: OnceLock<PathBuf> = OnceLock::new();
    RUNTIME.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("beside");
        fs::create_dir_all(&folder).unwrap();
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/lib.rs");
        let mut command = rustc(&folder);
        command.args(["--crate-name=kane", "--crate-type=rlib"]);
        assert_succeeds(&command.arg(root).output().unwrap());
        folder.join("libkane.rlib")
    })
}

/// A module and what tests it.
pub(crate) struct Tested {
    module: String,
    tests: String,
}

impl Tested {
    /// Generates every function of a description.
    pub(crate) fn new(description: &str) -> Self {
        Self::with(description, &[])
    }

    /// The same, with these requests beside.
    pub(crate) fn with(description: &str, requests: &[&str]) -> Self {
        let requests = requests.iter().map(|text| (*text).to_owned());
        let options = Options {
            functions: Functions::All(requests.collect()),
            companions: [CompanionKind::Tests].into(),
            module: "module".to_owned(),
            ..Options::default()
        };
        let source = Source::new("model.toml", description);
        let generated = generate(&source, "model.toml", &options, &no_includes);
        let generated = generated.unwrap_or_else(|error| panic!("{error}\n{description}"));
        Self {
            module: generated.source,
            tests: generated.companions[0].text.clone(),
        }
    }

    pub(crate) fn module(&self) -> &str {
        &self.module
    }

    pub(crate) fn tests(&self) -> &str {
        &self.tests
    }

    /// How many tests the module passes, which are all.
    pub(crate) fn passes(&self, name: &str) -> usize {
        let output = self.run(&self.module);
        let printed = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success(), "{name}: {printed}");
        printed.matches(" ... ok").count()
    }

    /// Whether another module in the place of its own is found out.
    pub(crate) fn fails(&self, module: &str) -> bool {
        !self.run(module).status.success()
    }

    fn run(&self, module: &str) -> Output {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str| folder.path().join(name);
        fs::write(file("module.rs"), module).unwrap();
        fs::write(file("module_tests.rs"), &self.tests).unwrap();
        let text = "mod module;\n#[cfg(test)]\nmod module_tests;\n";
        fs::write(file("main.rs"), text).unwrap();
        let kane = format!("kane={}", runtime().display());
        let mut command = rustc(folder.path());
        command.args(["--test", "--crate-name=tests", "--extern", &kane]);
        assert_succeeds(&command.arg(file("main.rs")).output().unwrap());
        Command::new(file("tests")).output().unwrap()
    }
}

/// Without optimization, of which compiling once and running once would take more than it gives.
fn rustc(folder: &Path) -> Command {
    let mut command = Command::new("rustc");
    command
        .args(["--edition=2024", "--cap-lints=allow", "--out-dir"])
        .arg(folder);
    command
}

fn assert_succeeds(output: &Output) {
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
}
