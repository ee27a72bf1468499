//! Why a command could not do what was asked for: every reason, in the user's words.

use std::{error, fmt, io};

use kane_codegen::{diagnostic::Diagnostics, error::Error, object};

/// Reasons, each as it is shown.
#[derive(Debug, Default)]
pub(crate) struct Failures(Vec<String>);

impl Failures {
    /// A reason of our own: lower case, without a final stop.
    pub(crate) fn message(text: impl fmt::Display) -> Self {
        Self(vec![format!("error: {text}")])
    }

    /// What explains other reasons.
    pub(crate) fn note(text: impl fmt::Display) -> Self {
        Self(vec![format!("note: {text}")])
    }

    /// Adds reasons; one that is known already is not said twice.
    pub(crate) fn add(&mut self, more: impl Into<Self>) {
        for reason in more.into().0 {
            if !self.0.contains(&reason) {
                self.0.push(reason);
            }
        }
    }

    /// The value if it is there, else `None` and its reasons are kept.
    pub(crate) fn keep<T>(&mut self, result: Result<T, impl Into<Self>>) -> Option<T> {
        result.map_err(|reasons| self.add(reasons)).ok()
    }

    /// An error if there is a reason.
    pub(crate) fn none(self) -> Result<(), Self> {
        if self.0.is_empty() { Ok(()) } else { Err(self) }
    }
}

impl fmt::Display for Failures {
    /// One after the other; an empty line beside those that take several lines.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, reason) in self.0.iter().enumerate() {
            if index > 0 {
                let wide = reason.contains('\n') || self.0[index - 1].contains('\n');
                f.write_str(if wide { "\n\n" } else { "\n" })?;
            }
            f.write_str(reason)?;
        }
        Ok(())
    }
}

impl From<Error> for Failures {
    fn from(error: Error) -> Self {
        if let Error::Invalid(diagnostics) = error {
            return diagnostics.into();
        }
        match error {
            Error::Requests(faults) => {
                let mut failures = Self::default();
                for fault in faults {
                    failures.add(Self::message(fault));
                }
                failures
            }
            error => Self::message(format_args!("{error:?}")),
        }
    }
}

impl From<object::Error> for Failures {
    fn from(error: object::Error) -> Self {
        Self::message(with_causes(&error))
    }
}

impl From<Diagnostics> for Failures {
    fn from(diagnostics: Diagnostics) -> Self {
        Self(vec![diagnostics.to_string()])
    }
}

impl From<io::Error> for Failures {
    /// Files have errors of their own, with a path; what is left is standard output.
    fn from(error: io::Error) -> Self {
        Self::message(format!("cannot write to standard output: {error}"))
    }
}

fn with_causes(error: &dyn error::Error) -> String {
    let causes = std::iter::successors(error.source(), |&cause| cause.source());
    causes.fold(error.to_string(), |text, cause| format!("{text}: {cause}"))
}
