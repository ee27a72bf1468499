//! Forces as they are linear in inertial parameters: the wrenches that a unit of each parameter needs are carried inward, and
//! every speed reads its entry off them.
//!
//! First moments need forces and moments, inertias moments alone, which no offset changes. What a joint does not move of a
//! body's inertia needs as much as if the lower body had it: its columns are sums of that body's (`shared`), and are not carried.

use super::{
    ahead::{About, Ahead},
    link::Link,
    link_motion::{self, LinkMotion},
    linkage::Linkage,
    passage::{Drive, Passenger},
    plan::{Plan, Technique},
    rotation::Turn,
    shared::{self, Shared},
    shortcut::Shortcuts,
    wrench::Wrench,
};
use crate::{
    expr::{Axis, Expr, ExprGraph, Purpose, Vector},
    given::{self, Accelerations},
    id::{BodyId, BodyMap, SpeedId},
    kane::regressor::{COMPONENTS, PARAMETERS, place},
    tree::{Motion, Tree},
};

/// For each speed, body and parameter what `tau` has of it.
pub fn regressor(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let tree = &*tree.with_whole_weights();
    let shared = shared::shared(graph, tree, plan);
    let whole = plan.with(Technique::Regroup, false);
    let linkage = Linkage::of_speeds(graph, tree, &whole);
    let motions = link_motion::motions(graph, &linkage, Accelerations::Given);
    graph.begin(Purpose::Regressor);
    let mut columns = BodyMap::outward(tree.bodies.len(), |body, _| {
        let link = &linkage.links[body];
        own_columns(graph, tree, body, link, &motions[body], &shared[body])
    });
    let mut shortcuts = Shortcuts::new(graph, &linkage);
    let mut ahead = Ahead::new(graph, &linkage, None);
    let mut y = vec![graph.zero(); tree.n_speeds * tree.bodies.len() * PARAMETERS.len()];
    for body in tree.body_ids().rev() {
        let mut carried = Carried {
            tree,
            body,
            columns: std::mem::take(&mut columns[body]),
            shortcuts: &mut shortcuts,
            ahead: &mut ahead,
            y: &mut y,
        };
        linkage.passages[body].inward(graph, &mut carried);
        let arrived = carried.columns;
        if let Some(lower) = tree.lower(body) {
            columns[lower].extend(arrived);
        }
    }
    for body in tree.body_ids() {
        graph.enter(body);
        shared[body].fill(graph, tree, body, &mut y);
    }
    y
}

/// The wrench that a unit of one parameter needs, about the origin and along the axes that it has reached.
struct UnitColumn {
    body: BodyId,
    parameter: usize,
    wrench: Wrench,
    /// The force where the root's translations are read, once it is there; the wrench's is then zero.
    arrived: Option<Vector>,
}

/// Those of a body, but what its lower body's give.
fn own_columns(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    link: &Link,
    motion: &LinkMotion,
    shared: &Shared,
) -> Vec<UnitColumn> {
    graph.enter(body);
    let pose = &tree.body(body).pose;
    let origin = given::fixed(graph, &pose.origin);
    let origin = link.point_of_body(graph, origin);
    let around = graph.mul_vector(&motion.u, origin);
    let a = graph.add_vectors(motion.a, around);
    let [w, alpha, a] = [motion.w, motion.alpha, a].map(|v| {
        let along_internal = link.to_body(graph, v);
        let axes = given::constant(graph, &pose.rotation);
        graph.mul_vector(&axes, along_internal)
    });
    let felt = LinkMotion::new(graph, w, alpha, a);
    let carried = (0..PARAMETERS.len()).filter(|parameter| !shared.gives(*parameter));
    let mut columns = Vec::new();
    for parameter in carried {
        let wrench = felt.of_parameter(graph, parameter);
        let wrench = wrench.map(|v| {
            let internal = given::constant_back(graph, &pose.rotation, v);
            link.of_body(graph, internal)
        });
        let wrench = wrench.moved(graph, origin);
        columns.push(UnitColumn {
            body,
            parameter,
            wrench,
            arrived: None,
        });
    }
    columns
}

impl LinkMotion {
    /// What a unit of a parameter needs, about the point whose acceleration is `a`, along the same axes.
    fn of_parameter(&self, graph: &mut ExprGraph, parameter: usize) -> Wrench {
        let zero = graph.zero_vector();
        match parameter {
            0 => Wrench {
                force: self.a,
                moment: zero,
            },
            1..4 => {
                let unit = graph.unit_vector(parameter - 1);
                Wrench {
                    force: self.u.map(|row| row[parameter - 1]),
                    moment: graph.cross(unit, self.a),
                }
            }
            _ => Wrench {
                force: zero,
                moment: self.of_inertia(graph, COMPONENTS[parameter - 4]),
            },
        }
    }

    /// `I alpha + tilde(w) I w` where one component of `I` is one.
    fn of_inertia(&self, graph: &mut ExprGraph, [row, column]: [usize; 2]) -> Vector {
        let mut moment = graph.zero_vector();
        if row == column {
            let (b, c) = ((row + 1) % 3, (row + 2) % 3);
            moment[row] = self.alpha[row];
            moment[b] = self.products[b];
            moment[c] = -self.products[c];
        } else {
            let a = Axis::ALL[3 - row - column];
            let (a, (b, c)) = (a.index(), a.others());
            moment[a] = graph.sub(self.squares[b], self.squares[c]);
            moment[b] = -self.u[a][b];
            moment[c] = self.u[a][c];
        }
        moment
    }
}

/// Unit columns on their way inward through a joint, whose motions read off them what acts along them.
struct Carried<'a, 'b> {
    tree: &'a Tree,
    body: BodyId,
    columns: Vec<UnitColumn>,
    shortcuts: &'a mut Shortcuts<'b>,
    ahead: &'a mut Ahead<'b>,
    y: &'a mut [Expr],
}

impl Carried<'_, '_> {
    fn read_off(
        &mut self,
        graph: &mut ExprGraph,
        motions: [Option<Motion>; 3],
        part: fn(&UnitColumn) -> Vector,
    ) {
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(Motion { speed, factor }) = motion else {
                continue;
            };
            let factor = graph.number(factor);
            for own in &self.columns {
                graph.enter(own.body);
                let share = graph.mul(factor, part(own)[axis]);
                own.add(graph, self.tree, (speed, share), self.y);
            }
        }
    }
}

impl UnitColumn {
    fn force(&self) -> Vector {
        self.arrived.unwrap_or(self.wrench.force)
    }

    /// Adds to its entry of a speed.
    fn add(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        (speed, share): (SpeedId, Expr),
        y: &mut [Expr],
    ) {
        let entry = &mut y[place(tree, speed.index(), self.body, self.parameter)];
        *entry = graph.add(*entry, share);
    }
}

impl Carried<'_, '_> {
    /// Sends the forces on a shortcut, if there is one here.
    fn take_shortcut(&mut self, graph: &mut ExprGraph) {
        if !self.shortcuts.may(graph, self.body) {
            return;
        }
        let with_force = |graph: &ExprGraph, own: &UnitColumn| {
            own.arrived.is_none() && !graph.is_zero_vector(own.wrench.force)
        };
        let n_forces = self.columns.iter().filter(|own| with_force(graph, own));
        let n_forces = n_forces.count();
        let Some(shortcut) = self.shortcuts.from(graph, self.body, n_forces) else {
            return;
        };
        for own in &mut self.columns {
            if with_force(graph, own) {
                graph.enter(own.body);
                own.wrench = own.wrench.moved(graph, shortcut.offset);
                own.arrived = Some(shortcut.arrived(graph, own.wrench.force));
                own.wrench.force = graph.zero_vector();
            }
        }
    }
}

impl Carried<'_, '_> {
    /// Reads off what joints below feel of moments alone, if that is cheaper than to carry them there.
    fn read_ahead(&mut self, graph: &mut ExprGraph) {
        if !self.ahead.may(self.body) {
            return;
        }
        let no_force = self.ahead.is_still(self.body);
        let columns = std::mem::take(&mut self.columns);
        let (moments, others): (Vec<_>, Vec<_>) = columns
            .into_iter()
            .partition(|own| no_force || graph.is_zero_vector(own.wrench.force));
        self.columns = others;
        let Some(axes) = self.ahead.from(graph, self.body, moments.len()) else {
            self.columns.extend(moments);
            return;
        };
        for own in &moments {
            graph.enter(own.body);
            for &About { motion, axis, .. } in &axes {
                let along = graph.dot(axis, own.wrench.moment);
                let factor = graph.number(motion.factor);
                let share = graph.mul(factor, along);
                own.add(graph, self.tree, (motion.speed, share), self.y);
            }
        }
    }
}

impl Passenger for Carried<'_, '_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        let at = &self.tree.body(lower).identifier;
        for own in &mut self.columns {
            graph.enter(own.body);
            own.wrench = own.wrench.moved(graph, offset);
            let name = PARAMETERS[own.parameter];
            graph.name_vector(own.wrench.force, &format!("{name}_f_{at}"));
            graph.name_vector(own.wrench.moment, &format!("{name}_n_{at}"));
        }
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.read_off(graph, drive.motions(), |own| own.wrench.moment);
        if let Drive::Angle(..) = drive {
            self.take_shortcut(graph);
            self.read_ahead(graph);
        }
        for own in &mut self.columns {
            graph.enter(own.body);
            own.wrench = own.wrench.map(|v| rotation.backward(graph, v));
        }
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        self.read_off(graph, motions, UnitColumn::force);
    }
}
