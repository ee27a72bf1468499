//! Columns of hinges that begin alike, four at a time: what they begin with is turned until the hinge's axis is the last, and what
//! they are is derived once, on sides in the place of its numbers, and called for four.

use std::collections::BTreeMap;

use super::{
    column::DerivativeColumn,
    reader::Reader,
    sides::on_sides,
    start::{Start, turned},
    wanted::Wanted,
};
use crate::{
    expr::{Expr, ExprGraph, LANES, Vector},
    id::SpeedId,
    recursive::{
        links::wrench::Wrench,
        matrices::{coriolis::column::CoriolisColumn, lever::Levered},
    },
    tree::Motion,
};

/// The axis of hinges that were turned.
const AXIS: usize = 2;

/// Where columns begin that motions make of masses.
#[derive(Debug)]
pub(super) enum Begins {
    /// Where masses pass the motions, but for those that have begun.
    Here(BTreeMap<SpeedId, DerivativeColumn>),
    /// Later: hinges are told.
    Later(Vec<Hinge>),
    /// Nowhere: columns pass alone, and no masses go with them.
    Nowhere,
}

/// A hinge, and what its column begins with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hinge {
    motion: Motion,
    axis: usize,
    start: Start,
}

impl Begins {
    /// The column of a turn, if it begins here; `own` is the angular velocity that enters with it, where that has several components.
    pub(super) fn turn(
        &mut self,
        graph: &mut ExprGraph,
        start: &Start,
        (reader, own): (&Reader, Vector),
        is_hinge: bool,
    ) -> Option<DerivativeColumn> {
        match self {
            Self::Here(begun) => {
                let known = begun.get(&reader.motion.speed).copied();
                Some(known.unwrap_or_else(|| start.turn(graph, reader, own)))
            }
            Self::Later(hinges) => {
                hinges.extend(is_hinge.then_some(Hinge {
                    motion: reader.motion,
                    axis: reader.place,
                    start: *start,
                }));
                None
            }
            Self::Nowhere => None,
        }
    }

    /// The column of a translation, if it begins here.
    pub(super) fn shift(
        &self,
        graph: &mut ExprGraph,
        start: &Start,
        reader: &Reader,
    ) -> Option<DerivativeColumn> {
        let is_here = matches!(self, Self::Here(_));
        is_here.then(|| start.shift(graph, reader))
    }

    /// The columns of hinges that begin alike, as long as there are four of a kind.
    pub(super) fn together(
        self,
        graph: &mut ExprGraph,
        wanted: Wanted,
    ) -> BTreeMap<SpeedId, DerivativeColumn> {
        let mut begun = BTreeMap::new();
        let Self::Later(hinges) = self else {
            return begun;
        };
        let mut kinds: BTreeMap<Vec<bool>, Vec<Hinge>> = BTreeMap::new();
        for hinge in hinges {
            let mut start = hinge.start.turned(hinge.axis + 1);
            let zeros = start.parts_mut().map(|part| graph.is_zero(*part)).collect();
            kinds.entry(zeros).or_default().push(hinge);
        }
        for hinges in kinds.into_values() {
            for four in hinges.as_chunks::<LANES>().0 {
                begun.extend(begin(graph, four, wanted).into_iter().flatten());
            }
        }
        begun
    }
}

/// The columns of four, by their speeds; none where to store what they are given takes more than is saved.
fn begin(
    graph: &mut ExprGraph,
    hinges: &[Hinge; LANES],
    wanted: Wanted,
) -> Option<[(SpeedId, DerivativeColumn); LANES]> {
    let starts = hinges.map(|hinge| hinge.start.turned(hinge.axis + 1));
    let (mut start, sides) = on_sides(graph, &starts, |start| start.parts_mut().collect());
    // About the axis of a hinge both motions are the same to what is asked of them.
    start.at.lower = start.at.after;
    graph.enter(hinges[0].start.body);
    let nothing = graph.zero_vector();
    let reader = Reader::of_turn(graph, hinges[0].motion, AXIS, &start.at, nothing);
    let column = start.turn(graph, &reader, nothing);
    let vectors = vectors(&column);
    if (LANES - 1) * graph.n_operations(vectors.as_flattened()) <= LANES * sides.len() {
        return None;
    }
    // Without the last two nothing depends on accelerations: then it is the same call before they are known and after.
    let calls = if wanted.are_all() {
        vec![&vectors[..]]
    } else {
        vec![&vectors[..5], &vectors[5..]]
    };
    let mut lanes = [const { Vec::new() }; LANES];
    for own in calls {
        let found = graph.call_outlined(own.as_flattened(), &sides);
        for (lane, found) in lanes.iter_mut().zip(found) {
            lane.extend(found);
        }
    }
    Some(std::array::from_fn(|lane| {
        let hinge = &hinges[lane];
        (hinge.motion.speed, hinge.column(graph, &lanes[lane]))
    }))
}

/// The vectors of a column: those of what its speed needs, its momentum and couple; and of what its coordinate needs.
fn vectors(column: &DerivativeColumn) -> [Vector; 7] {
    let [needed, momentum] = [
        column.carrying.needed.wrench,
        column.carrying.momentum.wrench,
    ];
    let displaced = column.displaced.wrench;
    [
        needed.moment,
        needed.force,
        momentum.moment,
        momentum.force,
        column.carrying.couple,
        displaced.moment,
        displaced.force,
    ]
}

impl Hinge {
    /// Its column, of the numbers of its vectors along turned axes.
    fn column(&self, graph: &mut ExprGraph, numbers: &[Expr]) -> DerivativeColumn {
        let back = 2 - self.axis;
        let vectors = numbers.as_chunks::<3>().0;
        let vector = |place: usize| turned(vectors[place], back);
        let wrench = |place: usize| Wrench {
            moment: vector(place),
            force: vector(place + 1),
        };
        let Self {
            motion,
            axis,
            start,
        } = *self;
        let known = [wrench(0), wrench(2)];
        graph.enter(start.body);
        DerivativeColumn {
            carrying: CoriolisColumn::known(graph, start.body, (motion, axis), known, vector(4)),
            displaced: Levered::new(graph, wrench(5)),
        }
    }
}
