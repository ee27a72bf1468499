//! How the parts of a request are derived beside one another.

use crate::recursive::{Plan, Technique};

/// By which plan each part of a request is derived, and which of them may be read off what others find.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Arrangement {
    parts: Vec<Arranged>,
}

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Arranged {
    plan: Plan,
    is_read_off: bool,
}

impl Arrangement {
    /// Each part by a plan of its own; what others find is read off.
    pub fn new(plans: impl Iterator<Item = Plan>) -> Self {
        let part = |plan| Arranged {
            plan,
            is_read_off: true,
        };
        Self {
            parts: plans.map(part).collect(),
        }
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

    /// The same with another plan for one part.
    #[must_use]
    pub fn with_plan(&self, place: usize, plan: Plan) -> Self {
        let mut other = self.clone();
        other.parts[place].plan = plan;
        other
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
