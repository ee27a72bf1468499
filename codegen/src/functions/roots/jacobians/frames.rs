//! Derivatives of where frames are and of what moves them: what the frame's own motion turns and carries.

use super::totals::by_coordinates;
use crate::{
    differentiate::Sweep,
    expr::{Expr, ExprGraph, Vector},
    functions::{
        argument::Argument,
        formulation::Way,
        function::Jacobians,
        roots::frames,
        subject::{Subject, View},
    },
    id::{BodyId, SpeedId},
    recursive::Plan,
    tree::Tree,
};

/// The rotation's rows are the frame's axes, which turn with it; the position moves as its Jacobian says.
pub(in crate::functions) fn pose(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> Jacobians {
    let way = Way::Recursive(plan);
    let pose = frames::pose(graph, tree, way, subject);
    let by_q = if subject.view == View::Other {
        // The other frame's axes may be given, and be none of a rotation.
        by_coordinates(graph, tree, Sweep::Forward, &pose)
    } else {
        let motion = frames::jacobian(graph, tree, way, subject);
        let motion: Vec<Vec<Expr>> = motion.chunks(tree.n_speeds).map(<[_]>::to_vec).collect();
        let (linear, angular) = motion.split_at(3);
        let mut rows = turned(graph, &pose[..9], angular);
        rows.extend_from_slice(linear);
        rows
    };
    Jacobians {
        by: vec![(Argument::Q, by_q)],
        values: Some(pose),
        mass: None,
    }
}

pub(in crate::functions) fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> Jacobians {
    let speeds: Vec<SpeedId> = (0..tree.n_speeds).map(SpeedId::new).collect();
    let entries = frames::jacobian(graph, tree, Way::Recursive(plan), subject);
    of_columns(graph, tree, subject, &speeds, entries)
}

pub(in crate::functions) fn jacobian_packed(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> Jacobians {
    let entries = frames::jacobian_packed(graph, tree, Way::Recursive(plan), subject);
    of_columns(graph, tree, subject, &subject.speeds(tree), entries)
}

pub(in crate::functions) fn point_jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> Jacobians {
    let speeds: Vec<SpeedId> = (0..tree.n_speeds).map(SpeedId::new).collect();
    let entries = frames::point_jacobian(graph, tree, Way::Recursive(plan), subject);
    of_columns(graph, tree, subject, &speeds, entries)
}

/// How the columns of these speeds change, entries by rows: with a motion that carries their axis they turn as a whole; by others the axis
/// stays, and the frame moves. Along the frame's own axes what turns as a whole does not change.
fn of_columns(
    graph: &mut ExprGraph,
    tree: &Tree,
    subject: &Subject,
    speeds: &[SpeedId],
    entries: Vec<Expr>,
) -> Jacobians {
    let by_q = if subject.view == View::Other || tree.has_followers() {
        by_coordinates(graph, tree, Sweep::Forward, &entries)
    } else {
        let n = speeds.len();
        let vector = |first: usize, column: usize| -> Vector {
            std::array::from_fn(|i| entries[(first + i) * n + column])
        };
        let columns = (0..n).map(|column| [vector(0, column), vector(3, column)]);
        let columns: Vec<[Vector; 2]> = columns.collect();
        let carrying = Carrying::new(tree);
        let mut rows = vec![vec![graph.zero(); tree.n_speeds]; entries.len()];
        for (place, &speed) in speeds.iter().enumerate() {
            for (by, &cause) in speeds.iter().enumerate() {
                let is_carried = carrying.carries(cause, speed);
                let changes = if subject.view == View::Local {
                    let none = [graph.zero_vector(); 2];
                    if is_carried {
                        none
                    } else {
                        seen_from_frame(graph, columns[place], columns[by])
                    }
                } else {
                    changed(graph, columns[place], columns[by], is_carried)
                };
                for (i, &entry) in changes.as_flattened().iter().enumerate() {
                    rows[i * n + place][cause.index()] = entry;
                }
            }
        }
        rows
    };
    Jacobians {
        by: vec![(Argument::Q, by_q)],
        values: Some(entries),
        mass: None,
    }
}

/// How a column, linear and angular, changes by the motion of another one, along axes that do not turn.
fn changed(
    graph: &mut ExprGraph,
    [v, w]: [Vector; 2],
    [v_by, w_by]: [Vector; 2],
    is_carried: bool,
) -> [Vector; 2] {
    if is_carried {
        [graph.cross(w_by, v), graph.cross(w_by, w)]
    } else {
        [graph.cross(w, v_by), graph.zero_vector()]
    }
}

/// The same along the frame's axes, by a motion that does not carry the column's axis.
fn seen_from_frame(
    graph: &mut ExprGraph,
    [v, w]: [Vector; 2],
    [v_by, w_by]: [Vector; 2],
) -> [Vector; 2] {
    let (moved, turned) = (graph.cross(w, v_by), graph.cross(v, w_by));
    [graph.add_vectors(moved, turned), graph.cross(w, w_by)]
}

/// Which motions carry the axes of which others.
struct Carrying<'a> {
    tree: &'a Tree,
    /// Of each speed the body that it moves, and its motion's place among the six of the joint.
    places: Vec<(BodyId, usize)>,
}

impl<'a> Carrying<'a> {
    /// Of a tree in which each speed moves one joint.
    fn new(tree: &'a Tree) -> Self {
        let mut places = vec![(BodyId::new(0), 0); tree.n_speeds];
        for body in tree.body_ids() {
            let motions = tree.body(body).joint.motions();
            for (place, motion) in motions.into_iter().enumerate() {
                if let Some(motion) = motion {
                    places[motion.speed.index()] = (body, place);
                }
            }
        }
        Self { tree, places }
    }

    /// True where the motion of one speed carries the axis of another's. Inside a joint translations carry all others, each angle the axes of
    /// those after it, an angular velocity its own three, and neither those of translations.
    fn carries(&self, cause: SpeedId, speed: SpeedId) -> bool {
        let (below, own) = (self.places[cause.index()], self.places[speed.index()]);
        if below.0 != own.0 {
            let path = std::iter::successors(self.tree.lower(own.0), |body| self.tree.lower(*body));
            return path.into_iter().any(|body| body == below.0);
        }
        let joint = &self.tree.body(own.0).joint;
        let is_before = joint.angular_velocity().is_some() || below.1 <= own.1;
        below.1 >= 3 || own.1 < 3 && is_before
    }
}

/// How the entries of a rotation change, row after row, with the columns of its frame's angular velocity.
fn turned(graph: &mut ExprGraph, rotation: &[Expr], angular: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
    graph.enter(None);
    let mut rows = Vec::with_capacity(rotation.len());
    for axis in rotation.chunks(3) {
        let axis: Vector = std::array::from_fn(|i| axis[i]);
        let columns = 0..angular[0].len();
        let columns = columns.map(|column| {
            let w = std::array::from_fn(|i| angular[i][column]);
            graph.cross(w, axis)
        });
        let columns: Vec<Vector> = columns.collect();
        rows.extend((0..3).map(|i| columns.iter().map(|own| own[i]).collect::<Vec<Expr>>()));
    }
    rows
}
