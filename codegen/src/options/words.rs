//! Options in words, as they stand in the banner.
//!
//! Afterwards: options with the same words give the same module, and the same options have the same words however they were
//! given.

use crate::{
    choices::name_of,
    description::{Base, Chart, Reading},
    functions::{ALL, DEFAULT, Parsed},
    recursive::Technique,
    tree::Changes,
};

use super::{Formulation, Functions, Options};

impl Options {
    /// All that can influence the module. What is written beside it cannot.
    pub(crate) fn in_words(&self) -> String {
        let Self {
            reading:
                Reading {
                    base,
                    chart,
                    leave_out,
                },
            changes:
                Changes {
                    snap,
                    lock,
                    remove,
                    remove_massless,
                },
            prescribed,
            functions,
            formulation,
            fma,
            without,
            companions: _,
            module: _,
        } = self;
        let mut parts = vec![
            format!("functions: {}", functions_in_words(functions)),
            format!("formulation: {}", name_of(formulation, &Formulation::ALL)),
            format!("snap: {:?}", snap + 0.0),
        ];
        let base = base.map(|base| name_of(&base, &Base::NAMED));
        parts.extend(base.map(|base| format!("base: {base}")));
        let chart = chart.map(|chart| name_of(&chart, &Chart::NAMED));
        parts.extend(chart.map(|chart| format!("chart: {chart}")));
        // Quoted with their escapes, so that no name leaves the comment or imitates another option.
        let left_out = leave_out.iter().map(|name| format!("{name:?}"));
        parts.extend(listed("leave_out", left_out.collect()));
        let locked = lock.iter();
        let locked = locked.map(|(name, value)| format!("{name:?} = {:?}", value + 0.0));
        parts.extend(listed("lock", locked.collect()));
        let removed = remove.iter().map(|name| format!("{name:?}"));
        parts.extend(listed("remove", removed.collect()));
        parts.extend(remove_massless.then(|| "remove_massless: true".to_owned()));
        let prescribed = prescribed.iter().map(|name| format!("{name:?}"));
        parts.extend(listed("prescribed", prescribed.collect()));
        let without = without.iter();
        let without = without.map(|one| name_of(one, &Technique::ALL).to_owned());
        parts.extend(listed("without", without.collect()));
        parts.extend(fma.then(|| "fma: true".to_owned()));
        parts.join("; ")
    }
}

/// A set has those that are no more than one of its functions.
fn functions_in_words(functions: &Functions) -> String {
    let set = match functions {
        Functions::Default(_) => Some(DEFAULT),
        Functions::All(_) => Some(ALL),
        Functions::Named(_) => None,
    };
    let is_in_set = |named: &Parsed| {
        let function = named.catalogue_function();
        function.is_some_and(|function| functions.set_has(function))
    };
    let named = functions.requests().into_iter();
    let others = named.filter(|named| !is_in_set(named));
    let words = set.map(str::to_owned).into_iter();
    let words: Vec<String> = words.chain(others.map(|one| one.text())).collect();
    words.join(", ")
}

/// A part that lists something, in an order of its own; none where the list is empty.
fn listed(part: &str, mut list: Vec<String>) -> Option<String> {
    list.sort();
    (!list.is_empty()).then(|| format!("{part}: {}", list.join(", ")))
}
