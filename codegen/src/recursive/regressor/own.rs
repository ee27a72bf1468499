//! What a unit of each of a body's own parameters needs, and how that is turned by the body's own hinge.

use super::{
    column::UnitColumn,
    shared::{Shared, component},
};
use crate::{
    expr::{Axis, Expr, ExprGraph, Matrix, Vector, negated},
    given,
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            link::Link, link_motion::LinkMotion, linkage::Linkage, rotation::Turn, wrench::Wrench,
        },
        matrices::{axes_below::About, lever::Levered, shortcut::Next},
    },
    tree::{InertialParameter, N_INERTIAL, Tree, regressor_place},
};

/// The columns of a body, of the parameters for which there are any.
pub(super) fn columns(
    graph: &mut ExprGraph,
    tree: &Tree,
    (body, link): (BodyId, &Link),
    motion: &LinkMotion,
    is_carried: impl Fn(&usize) -> bool,
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
    let next = Next {
        hinge: tree.body(body).joint.hinge_axis(),
        leaves: false,
    };
    let mut columns = Vec::new();
    for parameter in (0..N_INERTIAL).filter(is_carried) {
        let wrench = felt.of_parameter(graph, parameter);
        let wrench = wrench.map(|v| {
            let internal = given::constant_back(graph, &pose.rotation, v);
            link.of_body(graph, internal)
        });
        let mut needed = Levered::new(graph, wrench);
        needed.reach(graph, origin, next);
        columns.push(UnitColumn {
            body,
            parameter,
            needed,
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
                moment: self.of_inertia(
                    graph,
                    InertialParameter::COMPONENTS[parameter - InertialParameter::INERTIAS.start],
                ),
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

/// Of a body on a hinge that stays where it is, what its first moments across the hinge's axis need: they feel the acceleration `a`
/// of a point on the axis, about an axis `s` below by `a × s`. Farther along the hinge's axis by `z` they need `z` less of the
/// product of inertia of both.
pub(super) fn weigh(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    body: BodyId,
    shared: &Shared,
    below: &[About],
    y: &mut [Expr],
) {
    let Some(own) = shared.hinge_axis() else {
        return;
    };
    let (tree, link) = (linkage.tree, &linkage.links[body]);
    let axes = users_axes(graph, tree, body, link);
    let origin = given::fixed(graph, &tree.body(body).pose.origin);
    let origin = link.point_of_body(graph, origin);
    let along = graph.dot(axes[own], origin);
    for other in (0..3).filter(|other| *other != own) {
        for about in below {
            let felt = graph.dot(axes[other], about.crossed);
            let factor = graph.number(about.motion.factor);
            let felt = graph.mul(factor, felt);
            let entry = &mut y[regressor_place(
                tree,
                about.motion.speed.index(),
                body,
                InertialParameter::MOMENTS.start + other,
            )];
            *entry = graph.add(*entry, felt);
        }
        for speed in 0..tree.n_speeds {
            let of_inertia = y[regressor_place(tree, speed, body, component(own, other))];
            let farther = graph.mul(along, of_inertia);
            let entry = &mut y
                [regressor_place(tree, speed, body, InertialParameter::MOMENTS.start + other)];
            *entry = graph.sub(*entry, farther);
        }
    }
}

/// The user's axes of a body by rows, link components.
fn users_axes(graph: &mut ExprGraph, tree: &Tree, body: BodyId, link: &Link) -> Matrix {
    let rotation = tree.body(body).pose.rotation;
    graph.identity().map(|axis| {
        let internal = given::constant_back(graph, &rotation, axis);
        link.of_body(graph, internal)
    })
}

/// A body on a hinge along one of the user's axes, where there are shorter ways to turn what its inertia needs.
///
/// With the hinge's axis `e`, another of the user's axes `d`, the force `f` that a first moment along `d` needs, and
/// `m = -e·U e`, a product of inertia of `d` and `e` needs `-e × (f + m d)` across the axis: once `f` and `d` are turned, so is
/// this. A moment of inertia about `e` needs `(e·w) w × e` across it, and the lower body knows what `w` is there before it turns.
pub(super) struct OnHinge {
    body: BodyId,
    /// The user's axis that is the hinge's.
    own: usize,
    axis: Axis,
    /// The user's axes by rows, link components.
    axes: Matrix,
    /// The angular velocity, along the axis, and before the turn.
    along: Expr,
    w: Vector,
    /// `-e·U e`.
    stretch: Expr,
}

impl OnHinge {
    pub(super) fn new(
        graph: &mut ExprGraph,
        linkage: &Linkage<'_>,
        body: BodyId,
        motions: &BodyMap<LinkMotion>,
        own: usize,
    ) -> Option<Self> {
        let Linkage { tree, links, .. } = linkage;
        let (axis, lower) = (tree.body(body).joint.hinge_axis()?, tree.lower(body)?);
        let (link, motion) = (&links[body], &motions[body]);
        let a = axis.index();
        let axes = users_axes(graph, tree, body, link);
        Some(Self {
            body,
            own,
            axis,
            axes,
            along: motion.w[a],
            w: link.passage.constant.forward(graph, motions[lower].w),
            stretch: -motion.u[a][a],
        })
    }

    /// Finds what a turn has made of the moments of the body's own columns, `before` it, in a shorter way.
    pub(super) fn shorten(
        &self,
        graph: &mut ExprGraph,
        columns: &mut [UnitColumn],
        before: &[Vector],
        rotation: &dyn Turn,
    ) {
        graph.enter(self.body);
        for (place, before) in before.iter().enumerate() {
            let column = &columns[place];
            if column.body != self.body || column.needed.wrench.moment == *before {
                continue;
            }
            let parameter = column.parameter;
            if let Some(across) = self.across(graph, columns, rotation, parameter) {
                let moment = &mut columns[place].needed.wrench.moment;
                let (b, c) = self.axis.others();
                (moment[b], moment[c]) = (across[b], across[c]);
            }
        }
    }

    /// The turned moment of a parameter, as far as it is across the axis.
    fn across(
        &self,
        graph: &mut ExprGraph,
        columns: &[UnitColumn],
        rotation: &dyn Turn,
        parameter: usize,
    ) -> Option<Vector> {
        let &[row, column] = InertialParameter::COMPONENTS
            .get(parameter.checked_sub(InertialParameter::INERTIAS.start)?)?;
        let other = match (row == self.own, column == self.own) {
            (true, true) => {
                let axis = graph.unit_vector(self.axis.index());
                let across = graph.cross(self.w, axis);
                return Some(graph.scale(self.along, across));
            }
            (true, false) => column,
            (false, true) => row,
            (false, false) => return None,
        };
        let of_moment = columns.iter().find(|column| {
            column.body == self.body && column.parameter == InertialParameter::MOMENTS.start + other
        })?;
        if !of_moment.needed.has_force(graph) || of_moment.needed.has_left() {
            return None;
        }
        let direction = rotation.backward(graph, self.axes[other]);
        let stretched = graph.scale(self.stretch, direction);
        let sum = graph.add_vectors(of_moment.needed.wrench.force, stretched);
        Some(negated(graph.cross(self.axes[self.own], sum)))
    }
}
