//! A composite body with the columns of what it carries, passing a joint.

use super::{
    ahead::{Place, SendAhead},
    begun::Begins,
    column::DerivativeColumn,
    found::Derivatives,
    passing::Passing,
    reader::Reader,
    way::At,
};
use crate::{
    expr::{ExprGraph, Vector},
    id::BodyId,
    recursive::{
        links::{
            passage::{Drive, Passenger},
            rotation::Turn,
        },
        matrices::{shortcut::Shortcuts, speed_matrix},
    },
    tree::Motion,
};

/// A composite body and the columns of what it carries, on their way inward through a joint.
pub(super) struct Carried<'a, 'b> {
    pub(super) passing: Passing<'a>,
    pub(super) shortcuts: &'a mut Shortcuts<'b>,
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
        self.step += 1;
        self.passing.next()
    }

    /// Sends columns ahead from where they have been read.
    fn send(&mut self, graph: &mut ExprGraph) {
        if let Some(ahead) = self.ahead {
            let from = Place {
                body: self.passing.body,
                step: self.step,
            };
            ahead.send(graph, from, &mut self.columns, self.shortcuts, self.found);
        }
    }

    /// Rows and mirrored entries of motions that enter together, off the columns of others.
    fn read(&mut self, graph: &mut ExprGraph, readers: &[Reader]) {
        let Self { columns, found, .. } = self;
        for reader in readers {
            for column in columns.iter() {
                let own = &column.carrying;
                let row = [reader.motion, own.motion];
                let mirrored = [own.motion, reader.motion];
                let momentum = own.momentum.read(reader.place);
                let [needed, moved] = column.needed(reader.place);
                speed_matrix::add(graph, &mut found.by_u, row, needed);
                let displaced = reader.displaced(graph, own);
                speed_matrix::add(graph, &mut found.by_q, mirrored, displaced);
                let a = &mut found.by_u_dot;
                speed_matrix::add_mirrored(graph, a, row, momentum, false);
                speed_matrix::add(graph, &mut found.by_q, row, moved);
                let driven = reader.driven(graph, own);
                speed_matrix::add(graph, &mut found.by_u, mirrored, driven);
            }
        }
    }

    /// What motions that enter together make of the columns that begin with them: each meets each other.
    fn read_begun(
        &mut self,
        graph: &mut ExprGraph,
        readers: &[Reader],
        begun: &[DerivativeColumn],
    ) {
        let found = &mut *self.found;
        for reader in readers {
            for column in begun {
                let own = &column.carrying;
                let row = [reader.motion, own.motion];
                let [needed, moved] = column.needed(reader.place);
                speed_matrix::add(graph, &mut found.by_u, row, needed);
                // Of its own column the force by the coordinate is read where it begins.
                let displaced = if own.motion == reader.motion {
                    moved
                } else {
                    reader.displaced(graph, own)
                };
                let mirrored = [own.motion, reader.motion];
                speed_matrix::add(graph, &mut found.by_q, mirrored, displaced);
                let momentum = own.momentum.read(reader.place);
                speed_matrix::add(graph, &mut found.by_u_dot, row, momentum);
            }
        }
    }

    /// Begins the columns of turns that enter together, and reads them; `own` is the angular velocity that enters with them, where that
    /// has several components.
    fn begin(&mut self, graph: &mut ExprGraph, at: &At, readers: &[Reader], own: Option<Vector>) {
        let (start, is_hinge) = (self.passing.start(at), own.is_none());
        let own = own.unwrap_or_else(|| graph.zero_vector());
        let begun = readers
            .iter()
            .filter_map(|reader| self.begins.turn(graph, &start, (reader, own), is_hinge));
        let begun: Vec<DerivativeColumn> = begun.collect();
        self.read_begun(graph, readers, &begun);
        self.columns.extend(begun);
    }

    /// All of it to the axes before a rotation, seen from there.
    fn turn_back(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        if let Drive::Angle(axis, _) = drive {
            let at = (self.passing.body, axis);
            let shortcut = self.shortcuts.send(graph, at, self.columns.iter_mut());
            for column in &mut self.columns {
                column.before_turn(graph, axis, shortcut);
            }
        }
        for column in &mut self.columns {
            column.turn(graph, rotation);
        }
        self.passing.turn_back(graph, rotation, drive);
    }
}

impl Passenger for Carried<'_, '_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        let next = self.shortcuts.next(graph, lower);
        for column in &mut self.columns {
            column.reach(graph, offset, next);
        }
        self.passing.shift(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let at = self.next();
        if self.step < self.entry {
            return;
        }
        let own = matches!(drive, Drive::AngularVelocity(_)).then(|| drive.speeds(graph));
        let entering = own.unwrap_or_else(|| graph.zero_vector());
        let readers = |graph: &mut ExprGraph, at: &At| {
            let motions = drive.motions().into_iter().enumerate();
            let motions = motions.filter_map(|(axis, motion)| Some((axis, motion?)));
            let readers =
                motions.map(|(axis, motion)| Reader::of_turn(graph, motion, axis, at, entering));
            readers.collect::<Vec<Reader>>()
        };
        let after = readers(graph, &at);
        if self.step > self.entry {
            self.read(graph, &after);
        }
        if at.before.is_none() {
            self.begin(graph, &at, &after, own);
        }
        if self.step > self.entry {
            self.send(graph);
        }
        self.turn_back(graph, rotation, drive);
        if let Some(before) = at.before {
            let at = before.at();
            let before = readers(graph, &at);
            self.begin(graph, &at, &before, own);
        }
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
        self.read(graph, &readers);
        let start = self.passing.start(&at);
        let begun = readers
            .iter()
            .filter_map(|reader| self.begins.shift(graph, &start, reader));
        let begun: Vec<DerivativeColumn> = begun.collect();
        self.read_begun(graph, &readers, &begun);
        self.columns.extend(begun);
        self.send(graph);
        self.passing.along(graph, motions);
    }
}
