//! The arguments that say how a model is read and what is changed of it.

use std::mem;

use clap::Args;
use kane_codegen::{
    choices::name_of,
    config::{Changed, Prescribed},
    description::{Base, Chart, Reading},
    diagnostic::Escaped,
    options::Options,
    tree::Changes,
};

use crate::cli::{
    Failures,
    arguments::parse::{lock, one_of, tolerance},
    job::Listing,
};

/// What a URDF or MJCF leaves to the user.
#[derive(Args, Debug)]
pub(crate) struct ReadingArguments {
    /// The joint between the inertial frame and the root link of a URDF [default: fixed]
    #[arg(long, value_name = "BASE", requires = "model", value_parser = one_of(Base::NAMED))]
    base: Option<Base>,

    /// The orientation coordinates of free and ball joints of a URDF or MJCF [default: quaternion]
    #[arg(long, value_name = "CHART", requires = "model", value_parser = one_of(Chart::NAMED))]
    chart: Option<Chart>,

    /// Ignore parts of an MJCF, with a warning: equalities, fluid, tendons, gravcomp, or the name of
    /// an equality; comma-separated
    ///
    /// `equalities` are all active equalities; `connect`, `weld` and so on are those of one kind. `fluid` is the forces from `density` and
    /// `viscosity`. `tendons` is the stiffness, damping, armature and friction of tendons.
    #[arg(long, value_name = "A,B", requires = "model", value_delimiter = ',')]
    leave_out: Vec<String>,
}

/// How a model is read, and what is changed of it.
#[derive(Args, Debug)]
pub(crate) struct ChangesArguments {
    #[command(flatten)]
    reading: ReadingArguments,

    /// Snap entries of constant rotations to 0, 1 or -1 if they are this near [default: 1e-9]
    ///
    /// Rounded right angles, such as 1.5708, leave small entries that cost operations: 1e-5 removes them. 0 changes nothing.
    #[arg(long, value_name = "TOLERANCE", requires = "model", value_parser = tolerance, allow_hyphen_values = true)]
    snap: Option<f64>,

    /// Lock a coordinate at a value, rad or m; without VALUE at 0. May be repeated
    ///
    /// NAME is the coordinate, as `kane info` lists it, or its joint.
    #[arg(long, value_name = "NAME[=VALUE]", requires = "model", value_parser = lock)]
    lock: Vec<(String, f64)>,

    /// Fix a joint at zero coordinates. May be repeated
    ///
    /// JOINT is the name of the joint, or of its body.
    #[arg(long, value_name = "JOINT", requires = "model")]
    remove: Vec<String>,

    /// Fix at zero every motion that moves no mass, and list them
    ///
    /// Such motions, of a massless finger or a frame that turns about its own axis, make mass matrices singular.
    /// `--remove-massless=false` overrides `remove_massless = true` in `kane.toml`.
    #[arg(
        long,
        value_name = "BOOL",
        requires = "model",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "true"
    )]
    remove_massless: Option<bool>,

    /// Prescribe the accelerations of a joint for `hybrid_dynamics`, which finds its forces. May be repeated
    ///
    /// JOINT is the name of the joint, or of its body.
    #[arg(long, value_name = "JOINT", requires = "model")]
    prescribed: Vec<String>,
}

impl ReadingArguments {
    /// What is said, above what was said before.
    pub(crate) fn above(&self, before: Reading) -> Reading {
        Reading {
            base: self.base.or(before.base),
            chart: self.chart.or(before.chart),
            leave_out: if self.leave_out.is_empty() {
                before.leave_out
            } else {
                self.leave_out.iter().cloned().collect()
            },
        }
    }

    fn words(&self) -> Vec<String> {
        let base = self
            .base
            .map(|base| ["--base", name_of(&base, &Base::NAMED)]);
        let chart = self
            .chart
            .map(|chart| ["--chart", name_of(&chart, &Chart::NAMED)]);
        let words = base.into_iter().chain(chart).flatten();
        let mut words: Vec<String> = words.map(str::to_owned).collect();
        if !self.leave_out.is_empty() {
            words.extend(["--leave-out".to_owned(), self.leave_out.join(",")]);
        }
        words
    }
}

impl ChangesArguments {
    /// Names that are given twice.
    pub(crate) fn check(&self) -> Result<(), Failures> {
        let locked: Vec<&str> = self.lock.iter().map(|(name, _)| name.as_str()).collect();
        let removed: Vec<&str> = self.remove.iter().map(String::as_str).collect();
        let prescribed: Vec<&str> = self.prescribed.iter().map(String::as_str).collect();
        let mut failures = Failures::default();
        for (option, names) in [
            ("--lock", locked),
            ("--remove", removed),
            ("--prescribed", prescribed),
        ] {
            for (index, name) in names.iter().enumerate() {
                if names[..index].contains(name) {
                    let name = name.escaped();
                    failures.add(Failures::message(format!("{option} names `{name}` twice")));
                }
            }
        }
        failures.none()
    }

    /// What is changed of the model: what is said, above what was said before.
    fn above(&self, before: Changes) -> Changes {
        let mut changes = before;
        if let Some(snap) = self.snap {
            changes.snap = snap;
        }
        if !self.lock.is_empty() {
            changes.lock.clone_from(&self.lock);
        }
        if !self.remove.is_empty() {
            changes.remove.clone_from(&self.remove);
        }
        if let Some(remove_massless) = self.remove_massless {
            changes.remove_massless = remove_massless;
        }
        changes
    }

    /// Sets what is said, above what was said before.
    pub(crate) fn set(&self, options: &mut Options) {
        options.reading = self.reading.above(mem::take(&mut options.reading));
        options.changes = self.above(mem::take(&mut options.changes));
        if !self.prescribed.is_empty() {
            options.prescribed.clone_from(&self.prescribed);
        }
    }

    /// Leaves out what `kane.toml` names where others are named in its place.
    pub(crate) fn replace(&self, listing: &mut Listing) {
        if !self.prescribed.is_empty() {
            listing.prescribed = Prescribed::default();
        }
        self.forget(&mut listing.changed);
    }

    /// Leaves out the lists in whose place there are others.
    fn forget(&self, changed: &mut Changed) {
        let ReadingArguments {
            base,
            chart,
            leave_out,
        } = &self.reading;
        for (is_given, list) in [
            (!self.lock.is_empty(), Changes::LOCK),
            (!self.remove.is_empty(), Changes::REMOVE),
            (base.is_some(), Reading::BASE),
            (chart.is_some(), Reading::CHART),
            (!leave_out.is_empty(), Reading::LEAVE_OUT),
        ] {
            if is_given {
                changed.forget(list);
            }
        }
    }

    /// The same arguments, as words of a command.
    pub(crate) fn words(&self) -> Vec<String> {
        let mut words = self.reading.words();
        let mut push = |option: &str, value: String| words.extend([option.to_owned(), value]);
        if let Some(snap) = self.snap {
            push("--snap", format!("{snap:?}"));
        }
        for (name, value) in &self.lock {
            push("--lock", format!("{name}={value:?}"));
        }
        for name in &self.remove {
            push("--remove", name.clone());
        }
        for name in &self.prescribed {
            push("--prescribed", name.clone());
        }
        if let Some(remove) = self.remove_massless {
            let word = if remove { "" } else { "=false" };
            words.push(format!("--remove-massless{word}"));
        }
        words
    }
}
