//! A composite body with the columns of what it carries, passing a joint.

use super::{
    ahead::{Place, SendAhead},
    begun::Begins,
    column::DerivativeColumn,
    found::Derivatives,
    reader::Reader,
    start::Start,
    way::{At, doubled},
};
use crate::{
    expr::{ExprGraph, Vector},
    id::BodyId,
    recursive::{
        links::{
            passage::{Drive, Passenger, speeds},
            rotation::Turn,
            wrench::Wrench,
        },
        matrices::{
            moments::{Changing, Moments, Rates},
            shortcut::Shortcuts,
            speed_matrix,
        },
    },
    tree::Motion,
};

/// A composite body and the columns of what it carries, on their way inward through a joint.
pub(super) struct Carried<'a, 'b> {
    pub(super) body: BodyId,
    pub(super) shortcuts: &'a mut Shortcuts<'b>,
    pub(super) moments: Moments,
    /// Doubled.
    pub(super) rates: Rates,
    pub(super) wrench: Wrench,
    /// The rest of the way.
    pub(super) way: &'a [At],
    pub(super) columns: Vec<DerivativeColumn>,
    pub(super) found: &'a mut Derivatives,
    /// Where columns begin.
    pub(super) begins: &'a mut Begins,
    /// How many steps of the way through the joint have begun.
    pub(super) step: usize,
    /// Those that are behind where the columns come in, as [`Place`] has it.
    pub(super) entry: usize,
    /// What columns are sent ahead by.
    pub(super) ahead: Option<&'a dyn SendAhead>,
}

impl Carried<'_, '_> {
    fn next(&mut self) -> At {
        let (at, rest) = self
            .way
            .split_last()
            .expect("derivatives: the way inward is the way outward");
        self.way = rest;
        self.step += 1;
        *at
    }

    /// Sends columns ahead from where they have been read.
    fn send(&mut self, graph: &mut ExprGraph) {
        if let Some(ahead) = self.ahead {
            let Self { body, step, .. } = *self;
            let from = Place { body, step };
            ahead.send(graph, from, &mut self.columns, self.shortcuts, self.found);
        }
    }

    /// What columns begin with that begin here.
    fn start(&self, at: &At) -> Start {
        Start {
            body: self.body,
            moments: self.moments,
            rates: self.rates,
            wrench: self.wrench,
            at: *at,
        }
    }

    /// Rows and mirrored entries of motions that enter together, of which the columns began last.
    fn read(&mut self, graph: &mut ExprGraph, readers: &[Reader]) {
        let n_begun = match self.begins {
            Begins::Here(_) => readers.len(),
            Begins::Nowhere | Begins::Later(_) => 0,
        };
        let first = self.columns.len() - n_begun;
        let Self { columns, found, .. } = self;
        for reader in readers {
            for (i, column) in columns.iter().enumerate() {
                let own = &column.carrying;
                let row = [reader.motion, own.motion];
                let mirrored = [own.motion, reader.motion];
                let momentum = own.momentum.read(reader.place);
                let [needed, moved] = column.needed(reader.place);
                speed_matrix::add(graph, &mut found.by_u, row, needed);
                // Of its own column the force by the coordinate is read where it begins.
                let displaced = if own.motion == reader.motion && i >= first {
                    moved
                } else {
                    reader.displaced(graph, own)
                };
                speed_matrix::add(graph, &mut found.by_q, mirrored, displaced);
                if i >= first {
                    // Each of them meets each other.
                    speed_matrix::add(graph, &mut found.by_u_dot, row, momentum);
                    continue;
                }
                let a = &mut found.by_u_dot;
                speed_matrix::add_mirrored(graph, a, row, momentum, false);
                speed_matrix::add(graph, &mut found.by_q, row, moved);
                let driven = reader.driven(graph, own);
                speed_matrix::add(graph, &mut found.by_u, mirrored, driven);
            }
        }
    }
}

impl Passenger for Carried<'_, '_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        let next = self.shortcuts.next(graph, lower);
        for column in &mut self.columns {
            column.reach(graph, offset, next);
        }
        graph.enter(self.body);
        self.wrench = self.wrench.moved(graph, offset);
        self.rates = self.rates.moved(graph, offset);
        self.moments = self.moments.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let at = self.next();
        if self.step < self.entry {
            return;
        }
        let own = match drive {
            Drive::AngularVelocity(_) => drive.speeds(graph),
            Drive::Nothing | Drive::Angle(..) => graph.zero_vector(),
        };
        let motions = drive.motions().into_iter().enumerate();
        let motions = motions.filter_map(|(axis, motion)| Some((axis, motion?)));
        let readers: Vec<Reader> = motions
            .map(|(axis, motion)| Reader::of_turn(graph, motion, axis, &at, own))
            .collect();
        let start = self.start(&at);
        for reader in &readers {
            let is_hinge = matches!(drive, Drive::Angle(..));
            let column = self.begins.turn(graph, &start, (reader, own), is_hinge);
            self.columns.extend(column);
        }
        if self.step > self.entry {
            self.read(graph, &readers);
            self.send(graph);
        }
        if let Drive::Angle(axis, _) = drive {
            let at = (self.body, axis);
            let shortcut = self.shortcuts.send(graph, at, self.columns.iter_mut());
            for column in &mut self.columns {
                column.before_turn(graph, axis, shortcut);
            }
        }
        for column in &mut self.columns {
            column.turn(graph, rotation);
        }
        graph.enter(self.body);
        self.wrench = self.wrench.map(|v| rotation.backward(graph, v));
        let w = drive.speeds(graph);
        let w = doubled(graph, w);
        self.rates = self
            .rates
            .undriven(graph, &mut self.moments, rotation, (drive, w));
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let at = self.next();
        if self.step <= self.entry {
            return;
        }
        let moving = motions.into_iter().enumerate();
        let moving = moving.filter_map(|(axis, motion)| Some((axis, motion?)));
        let readers: Vec<Reader> = moving
            .map(|(axis, motion)| Reader::of_shift(graph, motion, axis, &at))
            .collect();
        let start = self.start(&at);
        for reader in &readers {
            let column = self.begins.shift(graph, &start, reader);
            self.columns.extend(column);
        }
        self.read(graph, &readers);
        self.send(graph);
        graph.enter(self.body);
        let own = speeds(graph, motions);
        let own = doubled(graph, own);
        self.rates = self.rates.carried(graph, &self.moments, own);
    }
}
