//! The largest errors found, by quantity.

use std::{collections::BTreeMap, fmt::Display};

use crate::compare::{assert_within, larger};

/// For each quantity the largest error of those that were added.
#[derive(Debug, Default)]
pub struct Errors(BTreeMap<String, f64>);

impl Errors {
    /// Requires an error to be within its tolerance.
    ///
    /// # Panics
    /// If it is not, or is no number.
    #[track_caller]
    pub fn add(&mut self, what: impl ToString, error: f64, tolerance: f64) {
        let what = what.to_string();
        assert_within(&what, error, tolerance);
        let most = self.0.entry(what).or_default();
        *most = larger(*most, error);
    }

    /// Each quantity with its largest error.
    pub fn largest(&self) -> &BTreeMap<String, f64> {
        &self.0
    }

    /// Shows them under a title.
    #[expect(clippy::print_stdout, reason = "shown with --nocapture")]
    pub fn show(&self, title: impl Display) {
        let errors = self.0.iter();
        let lines = errors.map(|(what, error)| format!("\n    {what}: {error:.1e}"));
        println!("{title}{}", lines.collect::<String>());
    }
}
