//! What can go wrong in the library.

use std::{error, fmt, path::PathBuf};

use crate::{
    diagnostic::{Diagnostics, Escaped},
    functions::RequestError,
    limits::OUTPUT_BYTES,
    options::{SNAP_TOLERANCES, companion::EXPECTED_NAME},
    tree::PrescribedFault,
};

/// Why nothing was generated.
///
/// [`fmt::Debug`] writes what people read, causes too: a build script whose `main` returns an error prints that.
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// An input file breaks a rule; every breach is listed with its place.
    #[error("{0}")]
    Invalid(Diagnostics),
    /// What is asked for and cannot be had: all that is wrong.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Requests(Vec<RequestError>),
    /// A tolerance that is none, or so large that it would make another system.
    #[error("the snap tolerance is {tolerance:?}; expected at least {} and less than {}", SNAP_TOLERANCES.start, SNAP_TOLERANCES.end)]
    SnapTolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// A coordinate that would be held at no number.
    #[error("`{name}` is locked at {value}; expected a finite number")]
    LockedValue {
        /// The coordinate or joint.
        name: String,
        /// The value.
        value: f64,
    },
    /// A coordinate that is to be held at two values.
    #[error("`{name}` is locked twice")]
    LockedTwice {
        /// The coordinate or joint.
        name: String,
    },
    /// Joints whose accelerations cannot be prescribed.
    #[error("{}", in_words(.0))]
    Prescribed(Vec<PrescribedFault>),
    /// A name of a module that files beside it cannot use.
    #[error(
        "the module is called `{}`; the files beside it contain that name: {EXPECTED_NAME}",
        name.escaped()
    )]
    ModuleName {
        /// The name.
        name: String,
    },
    /// A file that would be overwritten does not begin with our banner.
    #[error("`{}` was not written by `kane generate`; move it away, or overwrite it with --force", path.display())]
    NotGenerated {
        /// The file.
        path: PathBuf,
    },
    /// A file that would be overwritten was generated from another model.
    #[error("`{}` was generated from `{model}`; choose another --output, or overwrite it with --force", path.display())]
    OtherModel {
        /// The file.
        path: PathBuf,
        /// Its model, as its banner names it.
        model: String,
    },
    /// A link that would be replaced.
    #[error("`{}` is a link; name the file to which it leads, or replace the link with --force", path.display())]
    Link {
        /// The link.
        path: PathBuf,
    },
    /// A file that would be too large to be read again.
    #[error("`{}` would have {bytes} bytes; expected at most {OUTPUT_BYTES}: ask for fewer functions", path.display())]
    OutputTooLarge {
        /// The file.
        path: PathBuf,
        /// Its size.
        bytes: usize,
    },
    /// A file that would be overwritten and may hold what was written by hand.
    #[error("`{}` is there already; move it away, or overwrite it with --force", path.display())]
    Exists {
        /// The file.
        path: PathBuf,
    },
    /// A name that a build script gives a module and no file can have.
    #[error("the module is called `{}`; expected a file name, without a folder and without `.rs`: `Build::name` gives it another", name.escaped())]
    FileName {
        /// The name.
        name: String,
    },
    /// Two modules of a build script have one file.
    #[error("`{}` is generated twice, with other contents; give one module another name, by `Build::name`", path.display())]
    GeneratedTwice {
        /// The file.
        path: PathBuf,
    },
    /// What is wrong with what a build script asks of a model.
    #[error("{model}: {error}")]
    OfModel {
        /// The model's path.
        model: String,
        /// What is wrong.
        error: Box<Error>,
    },
    /// The build.rs API was called outside of a build script.
    #[error("OUT_DIR is not set: this is for build scripts, which cargo runs")]
    NoBuildScript,
    /// The numbers of a description make a value that f64 does not hold.
    #[error(
        "the numbers of the description are too large or too small, or masses add up to zero: `{what}` needs a number that f64 does not hold"
    )]
    Unrepresentable {
        /// The function, or the table, in which it appeared.
        what: String,
    },
    /// What is asked for would take too much time or memory.
    #[error("{what} {found} {unit}; expected at most {most}{}", advice.map_or_else(String::new, |advice| format!("; {advice}")))]
    TooLarge {
        /// What it is, with a verb.
        what: String,
        /// How much there is.
        found: usize,
        /// Of what.
        unit: &'static str,
        /// How much is allowed, of [`limits`](crate::limits).
        most: usize,
        /// What to do about it, where that does not go without saying.
        advice: Option<&'static str>,
    },
    /// A file could not be read or written.
    #[error("cannot access `{}`", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
}

/// Faults, each with what to do about it.
fn in_words(faults: &[PrescribedFault]) -> String {
    let faults = faults.iter();
    let faults: Vec<String> = faults
        .map(|fault| format!("{fault}; {}", fault.help()))
        .collect();
    faults.join("; ")
}

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Rust writes `Error: ` before it.
        let text = self.to_string();
        f.write_str(text.strip_prefix("error: ").unwrap_or(&text))?;
        let causes = std::iter::successors(error::Error::source(self), |&cause| cause.source());
        causes
            .into_iter()
            .try_for_each(|cause| write!(f, ": {cause}"))
    }
}

impl From<Diagnostics> for Error {
    fn from(diagnostics: Diagnostics) -> Self {
        Self::Invalid(diagnostics)
    }
}
