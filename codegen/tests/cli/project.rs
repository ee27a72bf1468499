//! A folder with models, and the command run in it.

use std::{
    fs,
    io::Write as _,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
    time::SystemTime,
};

use tempfile::TempDir;

/// A folder of its own.
pub(crate) struct Project(TempDir);

/// What a run said, and its exit code.
#[derive(Debug)]
pub(crate) struct Ran {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Ran {
    /// What was told, without the counts and the time at the end of the line about files.
    pub(crate) fn told(&self) -> String {
        let line = |line: &str| match line.split_once("; ") {
            Some((files, _)) if line.ends_with(" s") => format!("{}\n", files_alone(files, line)),
            _ => format!("{line}\n"),
        };
        self.err.lines().map(line).collect()
    }
}

/// What stands before the counts: files that were written, and how many were not.
fn files_alone<'a>(written: &'a str, line: &'a str) -> &'a str {
    match line[written.len() + 2..].split_once("; ") {
        Some((up_to_date, _)) => &line[..written.len() + 2 + up_to_date.len()],
        None => written,
    }
}

impl From<Output> for Ran {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code().unwrap(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Project {
    pub(crate) fn empty() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// `models/arm.toml`, and a `kane.toml` that has `mass_matrix` and `bias` of it written to `generated/arm.rs`.
    pub(crate) fn arm() -> Self {
        let project = Self::empty();
        project.write("models/arm.toml", &model("arm", "2.0"));
        project.write("kane.toml", &system("models/arm.toml", "generated/arm.rs"));
        project
    }

    /// The same, generated.
    pub(crate) fn generated() -> Self {
        let project = Self::arm();
        assert_eq!(project.kane(&["generate"]).code, 0);
        project
    }

    pub(crate) fn path(&self, path: &str) -> PathBuf {
        self.0.path().join(path)
    }

    pub(crate) fn write(&self, path: &str, text: &str) {
        let path = self.path(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    pub(crate) fn read(&self, path: &str) -> String {
        fs::read_to_string(self.path(path)).unwrap()
    }

    pub(crate) fn replace(&self, path: &str, from: &str, to: &str) {
        let text = self.read(path);
        assert!(text.contains(from), "`{path}` has no `{from}`");
        self.write(path, &text.replace(from, to));
    }

    pub(crate) fn modified(&self, path: &str) -> SystemTime {
        fs::metadata(self.path(path)).unwrap().modified().unwrap()
    }

    /// Every file below the folder, with its text.
    pub(crate) fn files(&self) -> Vec<(PathBuf, String)> {
        let mut files = Vec::new();
        visit(self.0.path(), &mut files);
        files.sort();
        files
    }

    /// The command in the project's folder.
    pub(crate) fn command(&self) -> Command {
        self.command_in("")
    }

    /// The command in a folder of the project.
    pub(crate) fn command_in(&self, folder: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_kane"));
        command.current_dir(self.path(folder)).stdin(Stdio::null());
        command
    }

    pub(crate) fn kane(&self, arguments: &[&str]) -> Ran {
        self.kane_in("", arguments)
    }

    pub(crate) fn kane_in(&self, folder: &str, arguments: &[&str]) -> Ran {
        let output = self.command_in(folder).args(arguments).output();
        output.unwrap().into()
    }

    /// A git repository of all files.
    pub(crate) fn committed(self) -> Self {
        self.git(&["init", "--quiet"]);
        self.commit();
        self
    }

    /// Commits all files; what git says and does depends on nobody's settings.
    pub(crate) fn commit(&self) {
        self.git(&["add", "--all"]);
        self.git(&["commit", "--quiet", "--message", "models"]);
    }

    /// Runs git, which must succeed.
    pub(crate) fn git(&self, arguments: &[&str]) -> String {
        let ran: Ran = self.git_command(arguments).output().unwrap().into();
        assert_eq!(ran.code, 0, "git {arguments:?}: {}", ran.err);
        ran.out
    }

    /// Git in the project's folder.
    pub(crate) fn git_command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new("git");
        command.current_dir(self.path("")).args(arguments);
        for (name, value) in [
            // What it says is English.
            ("LC_ALL", "C"),
            ("GIT_CONFIG_GLOBAL", "/dev/null"),
            ("GIT_CONFIG_NOSYSTEM", "1"),
            ("GIT_AUTHOR_NAME", "author"),
            ("GIT_AUTHOR_EMAIL", "author@example.org"),
            ("GIT_COMMITTER_NAME", "author"),
            ("GIT_COMMITTER_EMAIL", "author@example.org"),
        ] {
            command.env(name, value);
        }
        command
    }

    /// The command with text on its standard input.
    pub(crate) fn kane_given(&self, arguments: &[&str], input: &str) -> Ran {
        let mut command = self.command();
        command.args(arguments).stdin(Stdio::piped());
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let mut stdin = child.stdin.take().unwrap();
        stdin.write_all(input.as_bytes()).unwrap();
        drop(stdin);
        child.wait_with_output().unwrap().into()
    }
}

fn visit(folder: &Path, files: &mut Vec<(PathBuf, String)>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            visit(&path, files);
        } else {
            let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
            files.push((path, text));
        }
    }
}

/// A double pendulum with a sliding root; the mass of its upper body may be `{ runtime = 2.0 }`.
pub(crate) fn model(name: &str, mass: &str) -> String {
    format!(
        r#"name = "{name}"
gravity = [0.0, 0.0, -9.81]
lower_bodies = [0, 1]

[[body]]
name = "upper"
mass = {mass}
mass_center = [0.01, 0.02, -0.5]
inertia = {{ xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01, xz = 0.0, yz = 0.0 }}
attachment = [0.0, 0.1, 0.3]
joint = ["theta1", "s2"]

[[body]]
name = "fore"
mass = 1.5
mass_center = [0.0, 0.02, -0.4]
inertia = {{ xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.0, xz = 0.01, yz = 0.0 }}
attachment = [0.0, 0.0, -1.0]
joint = ["theta2"]
"#
    )
}

/// An entry of `kane.toml`.
pub(crate) fn system(model: &str, output: &str) -> String {
    format!(
        "[[system]]\nmodel = \"{model}\"\noutput = \"{output}\"\nfunctions = [\"mass_matrix\", \"bias\"]\n"
    )
}

/// A file of this repository.
pub(crate) fn repository(path: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join(path)
}

/// The operations that a module states of its functions, but for those of `Prepared`.
pub(crate) fn operations_of(module: &str) -> usize {
    let functions = module.split("\n/// Operations: ").skip(1);
    let totals = functions.map(|line| line.split(' ').next().unwrap());
    totals.map(|total| total.parse::<usize>().unwrap()).sum()
}
