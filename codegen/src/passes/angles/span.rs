//! Which angles are whole multiples of others, added up: Gaussian elimination in whole numbers.

use std::collections::BTreeMap;

use super::sum::{Terms, add, scale};
use crate::expr::NodeId;

/// Beyond this numbers are no longer exact enough to go on.
const LARGEST: i64 = 1 << 24;

/// Angles of which none follows from the others.
#[derive(Default)]
pub(super) struct Span {
    rows: Vec<Row>,
}

/// A combination of angles, and the first term of it, which no later row has.
struct Row {
    pivot: NodeId,
    terms: Terms,
    angles: Terms,
}

/// What is left of an angle: `times` the angle is `terms` and the other angles, each as often as `angles` says.
struct Reduced {
    times: i64,
    terms: Terms,
    angles: Terms,
}

impl Span {
    /// How often each of the angles is to be added to make this one, whose terms these are; `None` where no whole numbers do. It joins
    /// them if it does not follow from them.
    pub(super) fn take(&mut self, angle: NodeId, terms: &Terms) -> Option<Terms> {
        let Reduced {
            times,
            terms,
            mut angles,
        } = self.reduced(terms)?;
        if let Some((&pivot, _)) = terms.first_key_value() {
            scale(&mut angles, -1);
            angles.insert(angle, times);
            self.rows.push(Row {
                pivot,
                terms,
                angles,
            });
            return None;
        }
        let is_whole = angles.values().all(|often| often % times == 0);
        is_whole.then(|| {
            let own = angles.into_iter();
            own.map(|(id, often)| (id, often / times)).collect()
        })
    }

    /// `None` where numbers grow too large.
    fn reduced(&self, terms: &Terms) -> Option<Reduced> {
        let mut left = Reduced {
            times: 1,
            terms: terms.clone(),
            angles: BTreeMap::new(),
        };
        for row in &self.rows {
            let Some(&often) = left.terms.get(&row.pivot) else {
                continue;
            };
            let pivot = row.terms[&row.pivot];
            let mut most = 0;
            // Of a long chain, each row changes a term or two.
            if pivot != 1 {
                left.times *= pivot;
                let scaled = [&mut left.terms, &mut left.angles].map(|own| scale(own, pivot));
                most = scaled.into_iter().fold(left.times.abs(), i64::max);
            }
            most = most.max(add(&mut left.terms, &row.terms, -often));
            most = most.max(add(&mut left.angles, &row.angles, often));
            if most > LARGEST {
                return None;
            }
        }
        Some(left)
    }
}
