//! What the motions on the way to a frame add to its velocity and acceleration, those before each and those from it on.
//!
//! Columns are those of the frame's Jacobian, along axes that all share. Motions of which each carries the other, as the components of an angular
//! velocity do, are one group.

use crate::{
    expr::{Expr, ExprGraph, Input, Vector},
    functions::{roots::derivatives::carrying::Carrying, subject::Subject},
    given::{self, Accelerations},
    id::SpeedId,
    solve::SpeedMatrix,
    tree::{Motion, Tree},
};

/// Linear and angular: of the frame's origin, and of its axes.
pub(super) type Twist = [Vector; 2];

/// Motions that carry one another.
#[derive(Debug)]
pub(super) struct Group {
    pub(super) speeds: Vec<SpeedId>,
    /// What they add to the velocity.
    pub(super) velocity: Twist,
    /// What their accelerations add to the frame's.
    acceleration: Twist,
}

/// Velocity and acceleration that some of the motions alone give the frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moved {
    pub(super) velocity: Twist,
    pub(super) acceleration: Twist,
}

/// The motions on the way to a frame, outward.
#[derive(Debug)]
pub(super) struct Moving {
    pub(super) groups: Vec<Group>,
    /// By the motions before each group, and by all. Of accelerations it holds the angular part alone.
    pub(super) before: Vec<Moved>,
    /// By each group and those after it, seen from before it; and by none.
    pub(super) after: Vec<Moved>,
}

impl Moving {
    /// Of a tree in which each speed moves one joint.
    pub(super) fn new(
        graph: &mut ExprGraph,
        tree: &Tree,
        subject: &Subject,
        columns: &[Twist],
        accelerations: Accelerations<'_>,
    ) -> Self {
        let carrying = Carrying::new(tree);
        graph.enter(None);
        let speeds = carrying.outward(subject.speeds(tree));
        let groups = speeds
            .chunk_by(|a, b| carrying.carries(*a, *b) && carrying.carries(*b, *a))
            .map(|speeds| Group::new(graph, speeds, columns, accelerations));
        let groups: Vec<Group> = groups.collect();
        let mut moved = Moved::none(graph);
        let mut before = vec![moved];
        for group in &groups {
            moved = moved.with_after(graph, group);
            before.push(moved);
        }
        let mut moved = Moved::none(graph);
        let mut after = vec![moved];
        for group in groups.iter().rev() {
            moved = moved.with_before(graph, group);
            after.push(moved);
        }
        after.reverse();
        Self {
            groups,
            before,
            after,
        }
    }
}

impl Group {
    fn new(
        graph: &mut ExprGraph,
        speeds: &[SpeedId],
        columns: &[Twist],
        accelerations: Accelerations<'_>,
    ) -> Self {
        let zero = [graph.zero_vector(); 2];
        let (mut velocity, mut acceleration) = (zero, zero);
        for &speed in speeds {
            let column = &columns[speed.index()];
            let u = graph.input(Input::U(speed));
            velocity = plus(graph, velocity, column, u);
            let motion = Motion { speed, factor: 1.0 };
            let u_dot = given::acceleration(graph, Some(motion), accelerations);
            acceleration = plus(graph, acceleration, column, u_dot);
        }
        Self {
            speeds: speeds.to_vec(),
            velocity,
            acceleration,
        }
    }
}

fn plus(graph: &mut ExprGraph, sum: Twist, column: &Twist, factor: Expr) -> Twist {
    [0, 1].map(|part| {
        let own = graph.scale(factor, column[part]);
        graph.add_vectors(sum[part], own)
    })
}

impl Moved {
    fn none(graph: &mut ExprGraph) -> Self {
        let zero = [graph.zero_vector(); 2];
        Self {
            velocity: zero,
            acceleration: zero,
        }
    }

    /// With motions that these carry; of the acceleration the angular part alone.
    fn with_after(self, graph: &mut ExprGraph, group: &Group) -> Self {
        let [linear, angular] = self.acceleration;
        let axes = graph.cross(self.velocity[1], group.velocity[1]);
        let own = graph.add_vectors(group.acceleration[1], axes);
        Self {
            velocity: [0, 1]
                .map(|part| graph.add_vectors(self.velocity[part], group.velocity[part])),
            acceleration: [linear, graph.add_vectors(angular, own)],
        }
    }

    /// With motions that carry these: `a + v_dot + w × (2 V + v)`, `α + w_dot + w × W`.
    fn with_before(self, graph: &mut ExprGraph, group: &Group) -> Self {
        let [v, w] = group.velocity;
        let twice = graph.doubled(self.velocity[0]);
        let twice = graph.add_vectors(twice, v);
        let carried = [twice, self.velocity[1]].map(|part| graph.cross(w, part));
        let acceleration = [0, 1].map(|part| {
            let own = graph.add_vectors(group.acceleration[part], carried[part]);
            graph.add_vectors(self.acceleration[part], own)
        });
        Self {
            velocity: [0, 1]
                .map(|part| graph.add_vectors(self.velocity[part], group.velocity[part])),
            acceleration,
        }
    }
}

/// How a velocity along the frame's own axes, which some motions give, changes by a motion that carries none of them. So does a column of theirs.
pub(super) fn seen_from_frame(
    graph: &mut ExprGraph,
    [v, w]: Twist,
    [v_before, w_before]: Twist,
) -> Twist {
    let (moved, turned) = (graph.cross(w_before, v), graph.cross(v_before, w));
    [graph.add_vectors(moved, turned), graph.cross(w_before, w)]
}

/// Puts what a motion changes into the column of its speed.
pub(super) fn put(rows: &mut SpeedMatrix, column: usize, changes: Twist) {
    for (row, &entry) in rows.iter_mut().zip(changes.as_flattened()) {
        row[column] = entry;
    }
}
