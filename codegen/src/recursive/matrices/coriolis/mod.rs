//! The Coriolis matrix from composite bodies, as the mass matrix is made of them (Echeandia and Wensing 2021).
//!
//! Of all masses `C_ij = sum m J_i · J_dot_j`: J are the velocities for a unit speed. A column's masses need a force and moment
//! `(sum m J_dot_j, sum m r × J_dot_j)`, which every motion farther in reads off: row i, column j. The mirrored entry is read off
//! the column's momentum, for the axis of motion i turns, and off the couple `sum m r_dot × J_j`. All three pass inward.
//! With rates seen from the link, `B = tr(N) 1 - N`, second moments S, and `w` and `v` of the link, they begin for a turn
//! about `e` as `B e - e × S w` and `e × f + w × (e × h)`, and `B^T e + S (w × e) + v × (e × h)`.
//!
//! About the axis of an angle all of this is the same on both sides of its rotation, if `w` and rates are of one side.
//!
//! How fast a whole tree is translated does not matter: of `v` only what joints beyond the root add is there.

pub(in crate::recursive) mod column;
pub(in crate::recursive) mod velocities;

use self::{
    column::{CoriolisColumn, Masses},
    velocities::{AtMotions, Velocity, velocities},
};
use super::{
    axes_below::{About, AxesBelow},
    gathered::Gathered,
    lever::Levered,
    moments::{Changing, Moments, Rates},
    shortcut::{Shortcut, Shortcuts},
    speed_matrix,
};
use crate::{
    expr::{Axis, ExprGraph, Purpose, Vector},
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            linkage::Linkage,
            passage::{Drive, Passenger, speeds},
            rotation::Turn,
            wrench::Wrench,
        },
        plan::Plan,
    },
    solve::{SpeedMatrix, zero_matrix},
    tree::{Motion, Tree},
};

/// `C`, with `C u` the bias of a system without weight, springs and dampers, and `M_dot = C + C^T`.
pub fn coriolis_matrix(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> SpeedMatrix {
    found(graph, tree, plan, None)
}

/// The same, and the mass matrix without rotors: the columns' momenta hold it.
pub fn coriolis_and_mass_matrix(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> (SpeedMatrix, SpeedMatrix) {
    let mut mass = zero_matrix(graph, tree.n_speeds);
    let c = found(graph, tree, plan, Some(&mut mass));
    (c, mass)
}

/// The Coriolis matrix; adds to the mass matrix what momenta say of it, where it is asked for.
fn found(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    mut mass: Option<&mut SpeedMatrix>,
) -> SpeedMatrix {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    let velocities = velocities(graph, &linkage);
    graph.begin(Purpose::Composite);
    let mut gathered = Gathered::<Rates>::new(graph, &linkage);
    let mut columns = BodyMap::outward(tree.bodies.len(), |_, _| Vec::<CoriolisColumn>::new());
    let mut shortcuts = Shortcuts::new(graph, &linkage);
    let angular = BodyMap::outward(tree.bodies.len(), |body, _| velocities[body].velocity[0]);
    let mut ahead = AxesBelow::new(graph, &linkage, angular);
    let mut c = zero_matrix(graph, tree.n_speeds);
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut carried = Carried {
            body,
            moments: gathered.moments[body],
            rates: gathered.rates[body],
            velocities: &velocities[body].at_motions,
            columns: std::mem::take(&mut columns[body]),
            shortcuts: &mut shortcuts,
            ahead: &mut ahead,
            c: &mut c,
            mass: mass.as_deref_mut(),
        };
        linkage.passages[body].inward(graph, &mut carried);
        let Carried {
            moments: arrived,
            rates: changing,
            columns: others,
            ..
        } = carried;
        if let Some(lower) = tree.lower(body) {
            gathered.add(graph, lower, (&arrived, &changing), |graph| {
                for column in &others {
                    column.hint(graph, tree, lower);
                }
            });
            columns[lower].extend(others);
        }
    }
    c
}

/// A composite body and the columns of what it carries, on their way inward through a joint: where a speed moves the body, its
/// column begins, and row and column are read off all columns.
struct Carried<'a, 'b> {
    body: BodyId,
    moments: Moments,
    rates: Rates,
    /// The link's velocity wherever motions of the rest of the way enter.
    velocities: &'a [AtMotions],
    columns: Vec<CoriolisColumn>,
    shortcuts: &'a mut Shortcuts<'b>,
    ahead: &'a mut AxesBelow<'b>,
    c: &'a mut SpeedMatrix,
    mass: Option<&'a mut SpeedMatrix>,
}

impl Carried<'_, '_> {
    /// The velocities where the next motions enter.
    fn next(&mut self) -> AtMotions {
        let (velocity, rest) = self
            .velocities
            .split_last()
            .expect("coriolis: the way inward is the way outward");
        self.velocities = rest;
        *velocity
    }

    fn masses(&self) -> Masses<'_> {
        Masses {
            body: self.body,
            moments: &self.moments,
            rates: &self.rates,
        }
    }

    /// Reads off what joints below make of columns of which moments alone are left, if that is cheaper than to carry them there.
    fn read_ahead(&mut self, graph: &mut ExprGraph, axis: Axis, shortcut: Option<Shortcut>) {
        if !self.ahead.may(self.body) {
            return;
        }
        let no_force = self.ahead.is_still(self.body);
        let is_left = |graph: &ExprGraph, own: &CoriolisColumn| {
            let is_left = |part: &Levered| part.has_left() || !part.has_force(graph);
            no_force || is_left(&own.needed) && is_left(&own.momentum)
        };
        let columns = std::mem::take(&mut self.columns);
        let (mut moments, others): (Vec<_>, Vec<_>) =
            columns.into_iter().partition(|own| is_left(graph, own));
        self.columns = others;
        let Some(axes) = self.ahead.from(graph, self.body, 3 * moments.len()) else {
            self.columns.extend(moments);
            return;
        };
        for column in &mut moments {
            graph.enter(column.body);
            column.needed.settle_past(graph, shortcut, axis);
            column.momentum.settle_past(graph, shortcut, axis);
            for &About {
                motion,
                axis,
                crossed: rate,
            } in &axes
            {
                let row = graph.dot(axis, column.needed.wrench.moment);
                speed_matrix::add(graph, self.c, [motion, column.motion], row);
                let turned = graph.dot(rate, column.momentum.wrench.moment);
                let couple = graph.dot(axis, column.couple);
                let mirrored = graph.add(turned, couple);
                speed_matrix::add(graph, self.c, [column.motion, motion], mirrored);
                if let Some(mass) = self.mass.as_deref_mut() {
                    let entry = graph.dot(axis, column.momentum.wrench.moment);
                    let row = [motion, column.motion];
                    speed_matrix::add_mirrored(graph, mass, row, entry, false);
                }
            }
        }
    }

    /// Row and column of a motion, about (0 to 2) or along (3 to 5) an axis, off the columns of others.
    fn read(&mut self, graph: &mut ExprGraph, motion: Motion, place: usize, [w, v]: Velocity) {
        let unit = graph.unit_vector(place % 3);
        for column in &self.columns {
            let row = column.needed.read(place);
            speed_matrix::add(graph, self.c, [motion, column.motion], row);
            if let Some(mass) = self.mass.as_deref_mut() {
                let entry = column.momentum.read(place);
                let row = [motion, column.motion];
                speed_matrix::add_mirrored(graph, mass, row, entry, false);
            }
            let axis_rate = graph.cross(w, unit);
            let Wrench { moment, force } = column.momentum.wrench;
            let momentum = if place < 3 { moment } else { force };
            let mut mirrored = graph.dot(axis_rate, momentum);
            if place < 3 {
                let origin_rate = graph.cross(v, unit);
                let lever = graph.dot(origin_rate, force);
                mirrored = graph.add(mirrored, lever);
                mirrored = graph.add(mirrored, column.couple[place]);
            }
            speed_matrix::add(graph, self.c, [column.motion, motion], mirrored);
        }
    }

    /// Begins the column of a motion.
    fn begin(&mut self, graph: &mut ExprGraph, motion: Motion, place: usize, velocity: Velocity) {
        let masses = self.masses();
        let column = match place {
            0..3 => CoriolisColumn::of_turn(graph, masses, motion, place, velocity),
            _ => CoriolisColumn::of_shift(graph, masses, motion, place - 3, velocity),
        };
        let row = [motion; 2];
        speed_matrix::add(graph, self.c, row, column.needed.read(place));
        if let Some(mass) = self.mass.as_deref_mut() {
            let entry = column.momentum.read(place);
            speed_matrix::add_mirrored(graph, mass, row, entry, true);
        }
        self.columns.push(column);
    }

    /// The shortcut before the link's turn, if there is one that pays.
    fn shortcut(&mut self, graph: &mut ExprGraph) -> Option<Shortcut> {
        self.shortcuts
            .for_columns(graph, self.body, self.columns.iter())
    }

    /// Sends columns off before a turn about an axis, or gets them ready for it.
    fn leave(&mut self, graph: &mut ExprGraph, axis: Axis, shortcut: Option<Shortcut>) {
        if let Some(shortcut) = &shortcut {
            shortcut.take(graph, axis, self.columns.iter_mut());
        }
        self.read_ahead(graph, axis, shortcut);
        for column in &mut self.columns {
            column.before_turn(graph, axis, shortcut);
        }
    }

    /// All of it to the axes before a rotation, seen from there.
    fn turn_back(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        for column in &mut self.columns {
            column.turn(graph, rotation);
        }
        graph.enter(self.body);
        let w = drive.speeds(graph);
        self.rates = self
            .rates
            .undriven(graph, &mut self.moments, rotation, (drive, w));
    }
}

impl Passenger for Carried<'_, '_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        let next = self.shortcuts.next(graph, lower);
        for column in &mut self.columns {
            column.reach(graph, offset, next);
        }
        graph.enter(self.body);
        self.rates = self.rates.moved(graph, offset);
        self.moments = self.moments.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let AtMotions { before, after } = self.next();
        match drive {
            // If what is below turns, the column begins before the rotation: of `w` the link's own rate is not there yet. If not,
            // `w` is zero there, and the composite body, which nothing reads, need not be turned back.
            Drive::Angle(axis, motion) if !graph.is_zero_vector(before[0]) => {
                let place = axis.index();
                let shortcut = self.shortcut(graph);
                // What leaves is read where it is.
                let is_read_first = self.ahead.may(self.body) || shortcut.is_some();
                if is_read_first {
                    self.read(graph, motion, place, after);
                }
                self.leave(graph, axis, shortcut);
                self.turn_back(graph, rotation, drive);
                if !is_read_first {
                    self.read(graph, motion, place, before);
                }
                self.begin(graph, motion, place, before);
            }
            _ => {
                for (place, motion) in drive.motions().into_iter().enumerate() {
                    if let Some(motion) = motion {
                        self.read(graph, motion, place, after);
                        self.begin(graph, motion, place, after);
                    }
                }
                if let Drive::Angle(axis, _) = drive {
                    let shortcut = self.shortcut(graph);
                    self.leave(graph, axis, shortcut);
                }
                self.turn_back(graph, rotation, drive);
            }
        }
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let AtMotions { after, .. } = self.next();
        for (axis, motion) in motions.into_iter().enumerate() {
            if let Some(motion) = motion {
                self.read(graph, motion, 3 + axis, after);
                self.begin(graph, motion, 3 + axis, after);
            }
        }
        let own = speeds(graph, motions);
        self.rates = self.rates.carried(graph, &self.moments, own);
    }
}
