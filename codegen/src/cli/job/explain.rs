//! Why nothing can be generated: each fault at its place, in the model or in the `kane.toml` that lists it.

use std::collections::{BTreeMap, BTreeSet};

use kane_codegen::{
    description,
    diagnostic::{Diagnostic, Diagnostics, Source},
    error::Error,
    functions::RequestError,
    tree::{self, Changes, Checked},
};

use super::{Job, Listing, include, read};
use crate::cli::Failures;

impl Job {
    /// Why the model cannot be read, where it is listed.
    pub(super) fn unreadable(&self, error: Error) -> Failures {
        let Some(Listing { config, model, .. }) = &self.listing else {
            return error.into();
        };
        let fault = Diagnostic::error(format!("{error:?}")).at(*model, "listed here");
        Diagnostics::new(Source::clone(config), vec![fault]).into()
    }

    /// Why nothing can be generated, each fault at its place where it has one.
    pub(crate) fn explained(&self, error: Error) -> Failures {
        match error {
            Error::Invalid(found) => self.refused(&found),
            Error::Requests(faults) => {
                let (faults, again) = once_a_frame(faults);
                let (placed, others) = self.placed(faults, |listing, fault| {
                    let shown = listing.functions.fault(fault)?;
                    Some(match frame(fault).and_then(|name| again.get(name)) {
                        Some(count) => shown.help(more(*count)),
                        None => shown,
                    })
                });
                let mut failures = Failures::default();
                if !others.is_empty() {
                    failures.add(Error::Requests(others));
                }
                failures.add(placed);
                failures
            }
            Error::Prescribed(faults) => {
                let (placed, others) =
                    self.placed(faults, |listing, fault| listing.prescribed.fault(fault));
                let mut failures = placed;
                if !others.is_empty() {
                    let others = Error::Prescribed(others);
                    let model = self.model.display();
                    failures.add(Failures::message(format!("`{model}`: {others}")));
                }
                failures
            }
            Error::Unrepresentable { .. } | Error::TooLarge { .. } => {
                Failures::message(format!("`{}`: {error}", self.model.display()))
            }
            error => error.into(),
        }
    }

    /// Why functions cannot be had: at their places in `kane.toml` where they `are_listed` there, else as they were asked for.
    pub(crate) fn refused_functions(&self, error: Error, are_listed: bool) -> Failures {
        if are_listed {
            self.explained(error)
        } else {
            error.into()
        }
    }

    /// The same, and what else cannot be had.
    pub(super) fn explained_with_lacking(&self, error: Error) -> Failures {
        let are_prescribed_told = matches!(error, Error::Prescribed(_));
        let mut failures = self.explained(error);
        failures.add(self.lacking(are_prescribed_told));
        failures
    }

    /// What is asked for and cannot be had, whatever is wrong with the changes: as of the model without them.
    fn lacking(&self, are_prescribed_told: bool) -> Failures {
        let mut failures = Failures::default();
        let Ok(source) = read(&self.model) else {
            return failures;
        };
        let description = description::read(&source, &self.options.reading, &include(&self.model));
        let unchanged = Changes {
            remove_massless: self.options.changes.remove_massless,
            ..Changes::default()
        };
        let Ok(Checked { tree, .. }) = tree::build_with(&description, &unchanged) else {
            return failures;
        };
        let requests = self.options.requests(&tree).map_err(Error::Requests);
        failures.keep(requests.map_err(|error| self.explained(error)));
        if are_prescribed_told {
            return failures;
        }
        let prescribed = tree::prescribe(&description, tree, &self.options.prescribed);
        let prescribed = prescribed.map_err(Error::Prescribed);
        failures.keep(prescribed.map_err(|error| self.explained(error)));
        failures
    }

    /// What is wrong with the model, and with what is changed of it, at its place where it has one.
    fn refused(&self, found: &Diagnostics) -> Failures {
        let faults = found.list().to_vec();
        let (placed, others) = self.placed(faults, |listing, fault| listing.changed.fault(fault));
        let mut failures = Failures::default();
        if !others.is_empty() {
            failures.add(Diagnostics::new(found.source().clone(), others));
        }
        failures.add(placed);
        failures
    }

    /// Faults of what `kane.toml` says, at their places there, and the others.
    fn placed<F>(
        &self,
        faults: Vec<F>,
        place: impl Fn(&Listing, &F) -> Option<Diagnostic>,
    ) -> (Failures, Vec<F>) {
        let Some(listing) = &self.listing else {
            return (Failures::default(), faults);
        };
        let (mut placed, mut others) = (Vec::new(), Vec::new());
        for fault in faults {
            match place(listing, &fault) {
                Some(fault) => placed.push(fault.at(listing.model, "the model")),
                None => others.push(fault),
            }
        }
        let mut failures = Failures::default();
        if !placed.is_empty() {
            failures.add(Diagnostics::new(Source::clone(&listing.config), placed));
        }
        (failures, others)
    }
}

/// The frame that a request asks for in vain.
fn frame(fault: &RequestError) -> Option<&str> {
    match fault {
        RequestError::UnknownFrame { name, .. } => Some(name),
        _ => None,
    }
}

/// The faults with the first one alone of each frame that is missing, and how many more there were.
fn once_a_frame(faults: Vec<RequestError>) -> (Vec<RequestError>, BTreeMap<String, usize>) {
    let (mut first, mut again) = (BTreeSet::new(), BTreeMap::new());
    let is_first = |fault: &RequestError| {
        let Some(name) = frame(fault) else {
            return true;
        };
        let is_first = first.insert(name.to_owned());
        if !is_first {
            *again.entry(name.to_owned()).or_default() += 1;
        }
        is_first
    };
    let faults = faults.into_iter().filter(is_first).collect();
    (faults, again)
}

fn more(count: usize) -> String {
    match count {
        1 => "one more function asks for it".to_owned(),
        several => format!("{several} more functions ask for it"),
    }
}
