//! Lines of documentation that say facts, and what reads them back from modules of any age.

use crate::{program::Operations, tree::Parameter};

/// What a function states about itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counted {
    /// Its operations.
    pub operations: Operations,
    /// Its formulation, where it has more than one.
    pub formulation: Option<String>,
}

/// With what the line of operations begins.
const OPERATIONS: &str = "Operations: ";
/// What stands before the formulation.
const FORMULATION: &str = "; formulation: ";
/// With what the line of a nominal value begins.
const NOMINAL: &str = "Nominal value ";

impl Counted {
    /// `Operations: 7 = 4 mul + 3 add + 0 div + 0 trig; formulation: notes.`
    pub fn line(&self) -> String {
        let formulation = self.formulation.iter();
        let formulation: String = formulation.flat_map(|name| [FORMULATION, name]).collect();
        format!("{OPERATIONS}{}{formulation}.", self.operations)
    }

    /// That line and, where so many pairs of a multiplication and an addition are fused, another that says so.
    pub fn lines(&self, fused: usize) -> Vec<String> {
        let mut lines = vec![self.line()];
        if fused > 0 {
            lines.push(format!(
                "Of the multiplications and additions {fused} each are fused."
            ));
        }
        lines
    }

    /// What such a line says; `None` where it is another.
    pub fn read(line: &str) -> Option<Self> {
        let line = line.trim().strip_prefix(OPERATIONS)?;
        let line = line.strip_suffix('.').unwrap_or(line);
        let (counts, formulation) = match line.split_once(FORMULATION) {
            Some((counts, formulation)) => (counts, Some(formulation.to_owned())),
            None => (line, None),
        };
        let (_, terms) = counts.split_once(" = ")?;
        let mut operations = Operations::default();
        for term in terms.split(" + ") {
            let (number, kind) = term.split_once(' ')?;
            let count = match kind {
                "mul" => &mut operations.mul,
                "add" => &mut operations.add,
                "div" => &mut operations.div,
                "trig" => &mut operations.trig,
                _ => return None,
            };
            *count = number.parse().ok()?;
        }
        Some(Self {
            operations,
            formulation,
        })
    }
}

/// `Nominal value 12.0 kg.`
pub fn nominal(parameter: &Parameter) -> String {
    let (nominal, unit) = (parameter.nominal, parameter.unit);
    match unit {
        "1" => format!("{NOMINAL}{nominal:?}."),
        _ => format!("{NOMINAL}{nominal:?} {unit}."),
    }
}

/// The value and unit of such a line; `None` where it is another.
pub fn read_nominal(line: &str) -> Option<&str> {
    let value = line.trim().strip_prefix(NOMINAL)?;
    Some(value.trim_end_matches('.'))
}
