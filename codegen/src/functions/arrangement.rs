//! How the parts of a request are derived beside one another.

use super::formulation::Formulation;
use crate::recursive::{Plan, Technique};

/// In which formulation and by which plan each part of a request is derived, and which of them may be read off what others find.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Arrangement {
    parts: Vec<Arranged>,
}

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Arranged {
    formulation: Formulation,
    plan: Plan,
    is_read_off: bool,
}

impl Arrangement {
    /// Each part by the recursion, by a plan of its own; what others find is read off.
    pub fn new(plans: impl Iterator<Item = Plan>) -> Self {
        let part = |plan| Arranged {
            formulation: Formulation::Recursive,
            plan,
            is_read_off: true,
        };
        Self {
            parts: plans.map(part).collect(),
        }
    }

    /// The parts of several, one after the other.
    pub fn concat(several: impl Iterator<Item = Self>) -> Self {
        Self {
            parts: several.flat_map(|one| one.parts).collect(),
        }
    }

    /// The formulation of the part in this place.
    pub fn formulation(&self, place: usize) -> Formulation {
        self.parts[place].formulation
    }

    /// The plan of the part in this place.
    pub fn plan(&self, place: usize) -> &Plan {
        &self.parts[place].plan
    }

    /// True for a part that is read off what others find, where they do.
    pub fn is_read_off(&self, place: usize) -> bool {
        self.parts[place].is_read_off
    }

    /// True where a part's plan uses the technique.
    pub fn uses(&self, technique: Technique) -> bool {
        self.parts.iter().any(|part| part.plan.uses(technique))
    }

    /// The same with each part in this formulation.
    #[must_use]
    pub fn with_formulation(mut self, formulation: Formulation) -> Self {
        for part in &mut self.parts {
            part.formulation = formulation;
        }
        self
    }

    /// The same with one part in the formulation and by the plan that it has in another arrangement.
    #[must_use]
    pub fn with_part(&self, place: usize, other: &Self) -> Self {
        let mut changed = self.clone();
        changed.parts[place] = Arranged {
            is_read_off: self.is_read_off(place),
            ..other.parts[place].clone()
        };
        changed
    }

    /// The same with one part read off what others find, or derived in its own way though they do.
    #[must_use]
    pub fn with_read_off(&self, place: usize, is_read_off: bool) -> Self {
        let mut other = self.clone();
        other.parts[place].is_read_off = is_read_off;
        other
    }

    /// The same with each plan changed.
    #[must_use]
    pub fn with_plans(&self, change: impl Fn(&Plan) -> Plan) -> Self {
        let mut other = self.clone();
        for part in &mut other.parts {
            part.plan = change(&part.plan);
        }
        other
    }
}
