//! A run that is killed, at any moment, leaves of each file the old text or the new one.

use std::{
    fs,
    io::{BufRead as _, BufReader},
    path::PathBuf,
    process::{Child, Stdio},
    thread,
    time::{Duration, Instant},
};

use super::project::{Project, model};

/// Systems, with four files each, of a function that is soon derived.
const SYSTEMS: usize = 26;
/// Files of which the run tells before it is killed, at most; those that remain are more lines than a pipe takes.
const MOST_TOLD: u64 = 30;
/// Kills at any moment of a run, and kills while it writes.
const KILLS: [u64; 2] = [28, 12];

/// A folder whose path takes a thousand characters: lines about its files fill a pipe soon, and who writes them waits.
fn folder() -> String {
    vec!["f".repeat(240); 4].join("/")
}

/// Many systems of one model, in which a mass is one of two.
struct Systems {
    project: Project,
    files: Vec<PathBuf>,
    /// The texts of the files for each mass.
    texts: [Vec<Vec<u8>>; 2],
}

impl Systems {
    fn new() -> Self {
        let project = Project::empty();
        let outputs = (0..SYSTEMS).map(|number| format!("{}/arm{number}", folder()));
        let outputs: Vec<String> = outputs.collect();
        let system = |output: &String| {
            format!(
                "[[system]]\nmodel = \"models/arm.toml\"\noutput = \"{output}.rs\"\n\
                functions = [\"q_dot\"]\nmanifest = true\nabi = \"c\"\n"
            )
        };
        let config: String = outputs.iter().map(system).collect();
        let files = outputs.iter().flat_map(|output| {
            [".rs", ".json", "_c.rs", ".h"].map(|ending| project.path(&format!("{output}{ending}")))
        });
        let files: Vec<PathBuf> = files.collect();
        project.write("kane.toml", &config);
        let mut systems = Self {
            project,
            files,
            texts: [Vec::new(), Vec::new()],
        };
        for mass in [1, 0] {
            systems.choose(mass);
            assert_eq!(systems.project.kane(&["generate"]).code, 0);
            systems.texts[mass] = systems.read();
        }
        systems
    }

    fn choose(&self, mass: usize) {
        let mass = ["2.0", "3.0"][mass];
        self.project.write("models/arm.toml", &model("arm", mass));
    }

    fn read(&self) -> Vec<Vec<u8>> {
        let files = self.files.iter();
        files.map(|file| fs::read(file).unwrap()).collect()
    }

    fn start(&self) -> Child {
        let mut command = self.project.command();
        command
            .args(["generate", "--verbose"])
            .stderr(Stdio::piped());
        command.spawn().unwrap()
    }

    /// How many files have the text for this mass; all others have that for the other one.
    fn count(&self, mass: usize) -> usize {
        let texts = self.texts[0].iter().zip(&self.texts[1]);
        let has_it = self.read().into_iter().zip(texts).map(|(text, (a, b))| {
            assert!(text == *a || text == *b, "half a file");
            text == *[a, b][mass]
        });
        has_it.filter(|has_it| *has_it).count()
    }

    /// The files that are no whole ones.
    fn left_over(&self) -> usize {
        let entries = fs::read_dir(self.project.path(&folder())).unwrap();
        entries.count() - self.files.len()
    }

    /// A run that nobody kills makes everything right.
    fn complete(&self, mass: usize) {
        self.choose(mass);
        assert_eq!(self.project.kane(&["generate"]).code, 0);
        assert_eq!((self.count(mass), self.left_over()), (self.files.len(), 0));
    }

    fn are_up_to_date(&self) -> bool {
        self.project.kane(&["check"]).code == 0
    }
}

/// A seeded fraction of a whole.
fn fraction(seed: u64, whole: u64) -> u64 {
    seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) % whole
}

#[test]
#[expect(
    clippy::disallowed_methods,
    reason = "how long a run takes says when it can be killed"
)]
fn run_that_is_killed_leaves_each_file_old_or_new() {
    let systems = Systems::new();
    systems.choose(1);
    let start = Instant::now();
    systems.complete(1);
    let whole = u64::try_from(start.elapsed().as_micros()).unwrap();
    systems.complete(0);
    for seed in 0..KILLS[0] {
        // The first one at once: nothing is written yet.
        let moment = fraction(seed, whole);
        let mass = usize::from(seed % 2 == 0);
        systems.choose(mass);
        let mut run = systems.start();
        thread::sleep(Duration::from_micros(moment));
        run.kill().unwrap();
        run.wait().unwrap();
        let n_new = systems.count(mass);
        assert!(seed > 0 || n_new == 0);
    }
    systems.complete(1);
    assert!(systems.are_up_to_date());
}

#[test]
fn run_that_is_killed_while_it_writes_leaves_each_file_old_or_new() {
    let systems = Systems::new();
    let n_files = systems.files.len();
    for seed in 0..KILLS[1] {
        let n_told = 1 + fraction(seed, MOST_TOLD);
        systems.choose(1);
        let mut run = systems.start();
        let mut said = BufReader::with_capacity(1, run.stderr.take().unwrap());
        for _ in 0..n_told {
            let mut line = String::new();
            said.read_line(&mut line).unwrap();
            assert!(line.starts_with("wrote "), "{line}");
        }
        run.kill().unwrap();
        run.wait().unwrap();
        let n_new = systems.count(1);
        assert!(
            n_told <= n_new as u64 && n_new < n_files,
            "{n_new} of {n_files}"
        );
        assert!(systems.left_over() > 0);
        systems.complete(0);
    }
    assert!(systems.are_up_to_date());
}
