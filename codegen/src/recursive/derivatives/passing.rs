//! Composite bodies on their way inward, where columns begin.

use super::{
    start::Start,
    way::{At, Went},
};
use crate::{
    expr::{ExprGraph, Vector},
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            linkage::Linkage,
            passage::{Drive, speeds},
            rotation::Turn,
            totalled::Addend as _,
            wrench::Wrench,
        },
        matrices::{
            gathered::Gathered,
            moments::{Changing, Moments, Rates},
        },
    },
    tree::Motion,
};

/// Links with what they have gathered so far of those that they carry.
pub(super) struct Composites<'a> {
    ways: &'a BodyMap<Went>,
    gathered: Gathered<Rates>,
    wrenches: BodyMap<Wrench>,
}

impl<'a> Composites<'a> {
    /// Nothing but the links themselves, and the wrenches that they need.
    pub(super) fn new(
        graph: &mut ExprGraph,
        linkage: &Linkage<'_>,
        ways: &'a BodyMap<Went>,
        wrenches: &BodyMap<Wrench>,
    ) -> Self {
        Self {
            ways,
            gathered: Gathered::new(graph, linkage),
            wrenches: wrenches.clone(),
        }
    }

    /// A link with all that it carries.
    pub(super) fn at(&self, body: BodyId) -> Passing<'a> {
        Passing {
            body,
            moments: self.gathered.moments[body],
            rates: self.gathered.rates[body],
            wrench: self.wrenches[body],
            way: &self.ways[body].at_motions,
        }
    }

    /// Adds what has come to a link, once it and its columns are named.
    pub(super) fn add(
        &mut self,
        graph: &mut ExprGraph,
        lower: BodyId,
        come: &Passing<'_>,
        name_columns: impl FnOnce(&mut ExprGraph),
    ) {
        let moments = (&come.moments, &come.rates);
        self.gathered.add(graph, lower, moments, name_columns);
        self.wrenches[lower] = self.wrenches[lower].plus(graph, &come.wrench);
    }
}

/// A composite body, and how its link moves where motions enter.
pub(super) struct Passing<'a> {
    pub(super) body: BodyId,
    pub(super) moments: Moments,
    /// Doubled.
    pub(super) rates: Rates,
    /// What it needs.
    pub(super) wrench: Wrench,
    /// The rest of the way.
    pub(super) way: &'a [At],
}

impl<'a> Passing<'a> {
    /// No masses, on the same way.
    pub(super) fn nothing(graph: &mut ExprGraph, body: BodyId, way: &'a [At]) -> Self {
        let nothing = graph.zero_vector();
        Self {
            body,
            moments: Moments {
                mass: graph.zero(),
                first: nothing,
                second: graph.zero_symmetric(),
            },
            rates: Rates::zero(graph),
            wrench: Wrench {
                force: nothing,
                moment: nothing,
            },
            way,
        }
    }

    /// How the link moves where the next motions enter.
    pub(super) fn next(&mut self) -> At {
        let (at, rest) = self
            .way
            .split_last()
            .expect("derivatives: the way inward is the way outward");
        self.way = rest;
        *at
    }

    /// What columns begin with that begin here.
    pub(super) fn start(&self, at: &At) -> Start {
        Start {
            body: self.body,
            moments: self.moments,
            rates: self.rates,
            wrench: self.wrench,
            at: *at,
        }
    }

    /// To the link that comes next, from whose origin the last one lies at `offset`.
    pub(super) fn shift(&mut self, graph: &mut ExprGraph, offset: Vector) {
        graph.enter(self.body);
        self.wrench = self.wrench.moved(graph, offset);
        self.rates = self.rates.moved(graph, offset);
        self.moments = self.moments.moved(graph, offset);
    }

    /// To the axes before a rotation, seen from there.
    pub(super) fn turn_back(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        graph.enter(self.body);
        self.wrench = self.wrench.map(|v| rotation.backward(graph, v));
        let w = drive.speeds(graph);
        let w = graph.doubled(w);
        self.rates = self
            .rates
            .undriven(graph, &mut self.moments, rotation, (drive, w));
    }

    /// Seen from where these motions have not entered yet.
    pub(super) fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        graph.enter(self.body);
        let own = speeds(graph, motions);
        let own = graph.doubled(own);
        self.rates = self.rates.carried(graph, &self.moments, own);
    }
}
