//! Derivatives of accelerations of frames.
//!
//! Motions from one on give the frame `V`, `W`, `a`, `α` as they are seen from before it, those before it `W'` and `α'`. The motion, with the column
//! `v`, `w`, carries the former as a whole and moves the frame: by its coordinate the acceleration changes by
//! `α' × v + W' × (W' × v + 2 w × V) + w × a` and `w × α + W' × (w × W)`. Along the frame's own axes it changes by `w ×` the whole less.

use super::{
    columns::{by_rows, of_rows},
    moving::{Moved, Moving, Twist, put},
};
use crate::{
    expr::{Expr, ExprGraph, Vector},
    functions::{
        argument::Argument,
        formulation::Way,
        function::ByArguments,
        roots::{derivatives::swept::by_motions_or_swept, frames},
        subject::{Subject, View},
    },
    given::Accelerations,
    recursive::Plan,
    solve::SpeedMatrix,
    tree::Tree,
};

pub(in crate::functions) fn acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    derived(graph, tree, plan, subject, Accelerations::Given)
}

/// For `u_dot = 0`.
pub(in crate::functions) fn jacobian_dot_u(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    derived(graph, tree, plan, subject, Accelerations::Zero)
}

fn derived(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
    accelerations: Accelerations<'static>,
) -> ByArguments {
    let way = Way::Recursive(plan);
    let by_u_dot = frames::jacobian(graph, tree, way, subject);
    let (values, [by_q, by_u]) = by_motions_or_swept(
        graph,
        tree,
        [Argument::Q, Argument::U],
        |graph| frames::accelerated(graph, tree, way, subject, accelerations),
        |graph| {
            let columns = of_rows(&by_u_dot, tree.n_speeds);
            let still = graph.zero_vector();
            by_motions(graph, tree, subject, &columns, (accelerations, still))
        },
    );
    let mut by = vec![(Argument::Q, by_q), (Argument::U, by_u)];
    if accelerations == Accelerations::Given {
        by.push((Argument::UDot, by_rows(&by_u_dot, tree.n_speeds)));
    }
    ByArguments {
        by,
        values: Some(values),
        mass: None,
    }
}

/// The acceleration, and by coordinates and by speeds, with the columns of the Jacobian. `felt` at rest, along the frame's own axes; zero
/// of plain accelerations.
pub(super) fn by_motions(
    graph: &mut ExprGraph,
    tree: &Tree,
    subject: &Subject,
    columns: &[Twist],
    (accelerations, felt): (Accelerations<'_>, Vector),
) -> (Vec<Expr>, [SpeedMatrix; 2]) {
    let is_local = subject.view == View::Local;
    let moving = Moving::new(graph, tree, subject, columns, accelerations);
    let mut whole = moving.after[0].acceleration;
    whole[0] = graph.add_vectors(whole[0], felt);
    if is_local {
        whole[1] = moving.before[moving.groups.len()].acceleration[1];
    }
    let none = vec![vec![graph.zero(); tree.n_speeds]; 6];
    let (mut by_q, mut by_u) = (none.clone(), none);
    for (place, group) in moving.groups.iter().enumerate() {
        let (before, after) = (&moving.before[place], &moving.after[place]);
        for &speed in &group.speeds {
            let own = columns[speed.index()];
            let turned = if is_local {
                // The frame's axes turn with the motion.
                graph.sub_vectors(after.acceleration[0], whole[0])
            } else {
                after.acceleration[0]
            };
            let linear = linear_by_coordinate(graph, own, before, (after, turned));
            let angular = if is_local {
                turning_seen(graph, own[1], before, after)
            } else {
                turning(graph, own[1], before, after)
            };
            put(&mut by_q, speed.index(), [linear, angular]);
            let velocity = if group.speeds.len() == 1 {
                by_speed_alone(graph, own, before, after)
            } else {
                let farther = &moving.after[place + 1];
                by_speed(graph, own, (before, group.velocity), farther)
            };
            put(&mut by_u, speed.index(), velocity);
        }
    }
    (whole.concat(), [by_q, by_u])
}

/// `turned`: what the motion turns of the origin's acceleration.
fn linear_by_coordinate(
    graph: &mut ExprGraph,
    [v, w]: Twist,
    before: &Moved,
    (after, turned): (&Moved, Vector),
) -> Vector {
    let (turning, alpha) = (before.velocity[1], before.acceleration[1]);
    let moved = graph.cross(turning, v);
    let carried = graph.cross(w, after.velocity[0]);
    let sum = graph.add_vectors(moved, carried);
    let relative = graph.add_vectors(sum, carried);
    let terms = [
        graph.cross(alpha, v),
        graph.cross(turning, relative),
        graph.cross(w, turned),
    ];
    let linear = graph.add_vectors(terms[0], terms[1]);
    graph.add_vectors(linear, terms[2])
}

/// `w × α + W' × (w × W)`.
fn turning(graph: &mut ExprGraph, w: Vector, before: &Moved, after: &Moved) -> Vector {
    let turned = graph.cross(w, after.acceleration[1]);
    let carried = graph.cross(w, after.velocity[1]);
    let axes = graph.cross(before.velocity[1], carried);
    graph.add_vectors(turned, axes)
}

/// The same less `w × (α' + α + W' × W)`, the whole: `α' × w + (W' × w) × W`.
fn turning_seen(graph: &mut ExprGraph, w: Vector, before: &Moved, after: &Moved) -> Vector {
    let turned = graph.cross(before.acceleration[1], w);
    let carried = graph.cross(before.velocity[1], w);
    let axes = graph.cross(carried, after.velocity[1]);
    graph.add_vectors(turned, axes)
}

/// By the speed of a motion that no other one carries along: twice what a change of its coordinate makes of the velocity's linear part.
fn by_speed_alone(graph: &mut ExprGraph, [v, w]: Twist, before: &Moved, after: &Moved) -> Twist {
    let moved = graph.cross(before.velocity[1], v);
    let carried = graph.cross(w, after.velocity[0]);
    let sum = graph.add_vectors(moved, carried);
    let linear = graph.doubled(sum);
    [linear, between(graph, w, before, after)]
}

/// The same of a group, which adds this velocity, with what motions farther out add.
fn by_speed(
    graph: &mut ExprGraph,
    [v, w]: Twist,
    (before, own): (&Moved, Twist),
    farther: &Moved,
) -> Twist {
    let mut twice = |part: Vector, own: Vector| {
        let twice = graph.doubled(part);
        graph.add_vectors(twice, own)
    };
    let turning = twice(before.velocity[1], own[1]);
    let carried = twice(farther.velocity[0], own[0]);
    let (moved, carried) = (graph.cross(turning, v), graph.cross(w, carried));
    let linear = graph.add_vectors(moved, carried);
    [linear, between(graph, w, before, farther)]
}

/// How an axis turns with motions before it, and turns those after it.
fn between(graph: &mut ExprGraph, w: Vector, before: &Moved, after: &Moved) -> Vector {
    let [carried, carrying] = [before, after].map(|own| graph.cross(own.velocity[1], w));
    graph.sub_vectors(carried, carrying)
}
