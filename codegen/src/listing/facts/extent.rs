//! Which numbers an argument holds, and in what order.

use super::size::{N_ANGLES, Sizes};
use crate::functions::{Declared, Element};
use crate::listing::{Member, Step};

/// What an argument holds, as sizes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extent {
    /// The lengths of nested arrays, outermost first.
    lengths: Vec<usize>,
    element: Element,
    /// How many numbers each member of an element holds.
    n_members: usize,
}

impl Extent {
    /// The extent of an argument in a module with these sizes, so many parameters and so many prepared values.
    pub fn of(argument: &Declared, sizes: &Sizes, n_parameters: usize, n_fields: usize) -> Self {
        let lengths = argument.lengths.iter();
        Self {
            lengths: lengths.map(|length| sizes.length(length)).collect(),
            element: argument.element,
            n_members: match argument.element {
                Element::Scalar => 1,
                Element::Load => 3,
                Element::SinCos => sizes.named(N_ANGLES).map_or(0, |size| size.value),
                Element::Parameters => n_parameters,
                Element::Prepared => n_fields,
            },
        }
    }

    /// The lengths of its nested arrays, outermost first.
    pub fn lengths(&self) -> &[usize] {
        &self.lengths
    }

    /// The lengths of nested arrays of plain numbers that stand in memory as it does, outermost first: a load is a force and a
    /// moment, sines stand before cosines. `None` for structures whose members have names of their own.
    pub fn shape(&self) -> Option<Vec<usize>> {
        let inner = match self.element {
            Element::Scalar => vec![],
            Element::Load | Element::SinCos => vec![2, self.n_members],
            Element::Parameters | Element::Prepared => return None,
        };
        Some([&self.lengths[..], &inner].concat())
    }

    /// How many numbers it holds.
    pub fn size(&self) -> usize {
        self.lengths.iter().product::<usize>() * self.of_element()
    }

    fn of_element(&self) -> usize {
        match self.element {
            Element::Load | Element::SinCos => 2 * self.n_members,
            Element::Scalar | Element::Parameters | Element::Prepared => self.n_members,
        }
    }

    /// The steps to a number, counted from 0 in the order of the memory.
    pub fn steps(&self, place: usize) -> Vec<Step> {
        let (mut element, inner) = (place / self.of_element(), place % self.of_element());
        let mut steps = vec![Step::Index(0); self.lengths.len()];
        for (step, length) in steps.iter_mut().zip(&self.lengths).rev() {
            *step = Step::Index(element % length);
            element /= length;
        }
        let pair = |members: [Member; 2]| {
            let (member, place) = (inner / self.n_members, inner % self.n_members);
            [Step::Member(members[member]), Step::Index(place)]
        };
        match self.element {
            Element::Scalar => {}
            Element::Load => steps.extend(pair([Member::Force, Member::Moment])),
            Element::SinCos => steps.extend(pair([Member::Sines, Member::Cosines])),
            Element::Parameters => steps.push(Step::Member(Member::Parameter(inner))),
            Element::Prepared => steps.push(Step::Member(Member::Prepared(inner))),
        }
        steps
    }

    /// The place of the number to which these steps lead; `None` where they lead to none.
    pub fn place(&self, steps: &[Step]) -> Option<usize> {
        let (outer, inner) = steps.split_at_checked(self.lengths.len())?;
        let mut place = 0;
        for (step, &length) in outer.iter().zip(&self.lengths) {
            let Step::Index(index) = *step else {
                return None;
            };
            place = place * length + Some(index).filter(|&index| index < length)?;
        }
        Some(place * self.of_element() + self.within(inner)?)
    }

    /// The place of a number within an element.
    fn within(&self, steps: &[Step]) -> Option<usize> {
        let (member, index) = match (self.element, steps) {
            (Element::Scalar, []) => (0, 0),
            (Element::Load, &[Step::Member(Member::Force), Step::Index(index)])
            | (Element::SinCos, &[Step::Member(Member::Sines), Step::Index(index)])
            | (Element::Parameters, &[Step::Member(Member::Parameter(index))])
            | (Element::Prepared, &[Step::Member(Member::Prepared(index))]) => (0, index),
            (Element::Load, &[Step::Member(Member::Moment), Step::Index(index)])
            | (Element::SinCos, &[Step::Member(Member::Cosines), Step::Index(index)]) => (1, index),
            _ => return None,
        };
        (index < self.n_members).then_some(member * self.n_members + index)
    }
}
