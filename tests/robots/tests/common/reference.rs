//! The references, `NAME/reference.json`: Pinocchio's values for the same files. README.md says what each key means.

use std::{fs, path::PathBuf};

use kane_test_support::json::flat;
use serde_json::Value;

/// The path of a robot's URDF or reference.
pub(crate) fn path(name: &str, file: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), name, file].iter().collect()
}

/// A robot's reference.
pub(crate) struct Reference(Value);

impl Reference {
    pub(crate) fn new(name: &str) -> Self {
        let text =
            fs::read_to_string(path(name, "reference.json")).expect("the reference is there");
        Self(serde_json::from_str(&text).expect("it is JSON"))
    }

    pub(crate) fn is_floating(&self) -> bool {
        self.0["base"] == "floating"
    }

    pub(crate) fn moving_mass(&self) -> f64 {
        number(&self.0["moving_mass"])
    }

    /// The joints that move, in the order of Pinocchio's vectors.
    pub(crate) fn joints(&self) -> &[Value] {
        list(&self.0["joints"])
    }

    /// The links, in the order of the placements.
    pub(crate) fn links(&self) -> Vec<&str> {
        list(&self.0["links"]).iter().map(text).collect()
    }

    pub(crate) fn samples(&self) -> impl Iterator<Item = Sample<'_>> {
        list(&self.0["samples"]).iter().map(Sample)
    }
}

/// A state and what follows from it.
#[derive(Clone, Copy)]
pub(crate) struct Sample<'r>(&'r Value);

impl Sample<'_> {
    /// The numbers under a key, row-major, if it is there: large matrices are left out of most samples.
    pub(crate) fn optional(self, key: &str) -> Option<Vec<f64>> {
        self.0.get(key).map(flat)
    }

    pub(crate) fn numbers(self, key: &str) -> Vec<f64> {
        self.optional(key).expect("every sample has it")
    }

    /// What is said of a floating base in plain terms.
    pub(crate) fn base(self, key: &str) -> Vec<f64> {
        flat(&self.0["base"][key])
    }
}

pub(crate) fn list(value: &Value) -> &[Value] {
    value.as_array().expect("it is a list")
}

pub(crate) fn text(value: &Value) -> &str {
    value.as_str().expect("it is text")
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().expect("it is a number")
}

pub(crate) fn index(value: &Value) -> usize {
    usize::try_from(value.as_u64().expect("it is a whole number")).expect("it is small")
}
