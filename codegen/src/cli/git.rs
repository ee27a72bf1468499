//! Files as they are in a git revision, read by the command `git`.

use std::{
    fmt,
    io::{self, Read},
    path::{Component, Path, PathBuf},
    process::{Command, Output, Stdio},
};

use kane_codegen::{config::clean_path, diagnostic::Escaped, error::Error, input};

use crate::cli::{Failures, paths};

/// A file in a revision.
#[derive(Clone, Debug)]
pub(crate) struct Revision {
    /// The revision, as git reads it; empty for what is staged.
    name: String,
    /// The file's path from the repository's root, or from the current folder where it begins with `./` or `../`.
    path: String,
}

impl Revision {
    /// Reads `REVISION:PATH`.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let (name, path) = text.split_once(':')?;
        (!path.is_empty()).then(|| Self {
            name: name.to_owned(),
            path: path.to_owned(),
        })
    }

    /// This file, whose path is absolute or relative to the current folder.
    pub(crate) fn of(name: &str, file: &Path) -> Result<Self, Failures> {
        let prefix = git(&["rev-parse", "--show-prefix"]).ok();
        let prefix = prefix.and_then(|output| String::from_utf8(output.stdout).ok());
        let prefix = prefix.unwrap_or_default();
        let from_here = if file.is_absolute() {
            let folder = paths::target(paths::parent(file))?;
            paths::shown(&folder.join(file.file_name().unwrap_or_default()))?
        } else {
            file.to_owned()
        };
        let path = Path::new(prefix.trim_end_matches(['\n', '\r'])).join(from_here);
        let path = clean_path(&path);
        let is_below = matches!(path.components().next(), Some(Component::Normal(_)));
        let path = paths::with_slashes(&path).filter(|_| is_below);
        let path = path.ok_or_else(|| {
            let file = file.to_string_lossy();
            Failures::message(format!("git knows no file `{}`", file.escaped()))
        })?;
        Ok(Self {
            name: name.to_owned(),
            path,
        })
    }

    /// True where the revision has the file.
    pub(crate) fn exists(&self) -> bool {
        let output = git(&["cat-file", "-e", &self.to_string()]);
        output.is_ok_and(|output| output.status.success())
    }

    /// The file's text.
    pub(crate) fn read(&self) -> Result<String, Failures> {
        self.read_by(|from| input::text_from(from))
    }

    /// What a reader makes of the file.
    fn read_by<T>(
        &self,
        reader: impl FnOnce(&mut dyn Read) -> io::Result<T>,
    ) -> Result<T, Failures> {
        let object = self.to_string();
        let cannot_run = |error| is_missing(&object, &error);
        let mut blob = command(&["cat-file", "blob", &object]);
        let blob = blob.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut blob = blob.spawn().map_err(cannot_run)?;
        // Of a file that is too large git writes no more than is read.
        let found = match blob.stdout.take() {
            Some(mut out) => reader(&mut out),
            None => reader(&mut io::empty()),
        };
        let output = blob.wait_with_output().map_err(cannot_run)?;
        let found = found.map_err(|source| Error::Io {
            path: PathBuf::from(&object),
            source,
        })?;
        if !output.status.success() {
            return Err(Failures::message(format!(
                "git has no file `{}`: {}",
                object.escaped(),
                told(&output)
            )));
        }
        Ok(found)
    }

    /// Reads a file that stands beside this one, in the same revision.
    pub(crate) fn beside(&self, path: &str) -> io::Result<Vec<u8>> {
        let joined = paths::parent(Path::new(&self.path)).join(path);
        let from_here = self.is_from_here();
        let joined =
            paths::with_slashes(&clean_path(&joined)).ok_or(io::ErrorKind::InvalidInput)?;
        let beside = Self {
            name: self.name.clone(),
            path: if from_here {
                format!("./{joined}")
            } else {
                joined
            },
        };
        let bytes = beside.read_by(|from| input::named_from(from));
        bytes.map_err(|failures| io::Error::other(failures.to_string()))
    }

    /// True for a path that git reads from the current folder, and not from the root of the repository.
    fn is_from_here(&self) -> bool {
        self.path.starts_with("./") || self.path.starts_with("../")
    }

    /// Where the file stands among the user's own, if it does.
    pub(crate) fn own_file(&self) -> Option<PathBuf> {
        if self.is_from_here() {
            return Some(PathBuf::from(&self.path));
        }
        let output = git(&["rev-parse", "--show-toplevel"]).ok()?;
        let root = String::from_utf8(output.stdout).ok()?;
        let root = Path::new(root.trim_end_matches(['\n', '\r']));
        output.status.success().then(|| root.join(&self.path))
    }
}

impl fmt::Display for Revision {
    /// As git reads it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.name, self.path)
    }
}

/// Why a name is no revision, and what to do.
pub(crate) fn why_no_revision(name: &str) -> String {
    let output = match git(&["rev-parse", "--is-shallow-repository"]) {
        Ok(output) => output,
        Err(error) => return format!(", for git cannot be run: {error}; expected two files"),
    };
    if !output.status.success() {
        let told = told(&output);
        return if told.contains("not a git repository") {
            ", for this folder is in no git repository; expected two files".to_owned()
        } else {
            format!(": {told}")
        };
    }
    if let Some((old, new)) = name.split_once("...").or_else(|| name.split_once("..")) {
        let or_head = |name: &str| if name.is_empty() { "HEAD" } else { name }.escaped();
        let (old, new) = (or_head(old), or_head(new));
        return format!("; expected two revisions apart: `kane diff {old} {new}`");
    }
    if !is_commit("HEAD") {
        return ", for the repository has no commit yet; expected two files".to_owned();
    }
    let shallow = match output.stdout.trim_ascii() {
        b"true" => "; this clone lacks older commits, which `git fetch --unshallow` gets",
        _ => "",
    };
    format!(
        "; expected one, or a second file to compare it with; `kane diff HEAD` compares all systems with the last commit{shallow}"
    )
}

/// What git told of its failure, in one line.
fn told(output: &Output) -> String {
    let told = String::from_utf8_lossy(&output.stderr);
    let lines = told.lines().map(str::trim).filter(|line| !line.is_empty());
    lines.collect::<Vec<_>>().join(" ")
}

/// True for the name of a commit.
pub(crate) fn is_commit(name: &str) -> bool {
    let commit = format!("{name}^{{commit}}");
    let output = git(&[
        "rev-parse",
        "--verify",
        "--quiet",
        "--end-of-options",
        &commit,
    ]);
    output.is_ok_and(|output| output.status.success())
}

fn git(arguments: &[&str]) -> io::Result<Output> {
    command(arguments).output()
}

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new("git");
    // What it tells stands in our messages, which are in English.
    command.args(arguments).env("LC_ALL", "C");
    command
}

fn is_missing(object: &str, error: &io::Error) -> Failures {
    Failures::message(format!(
        "`{}` is no file here, and git, which would know a revision, cannot be run: {error}",
        object.escaped()
    ))
}
