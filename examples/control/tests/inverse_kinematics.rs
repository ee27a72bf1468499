//! Inverse kinematics of an arm with a joint too many, one without, and a robot on four feet, from near and from far.

use std::array::from_fn;

use allocation_counter::measure;
use kane::{
    System,
    functions::{Jacobian, Pose},
    inverse_kinematics::{Goal, Goals, InverseKinematics, Limits},
};
use kane_examples::{Noise, panda, solo12, ur5};

/// From -1 to 1.
fn symmetric(draws: &mut Noise) -> f64 {
    2.0 * draws.even() - 1.0
}

/// Anywhere between the limits.
fn between<const N: usize>(draws: &mut Noise, limits: &Limits<f64, N>) -> [f64; N] {
    from_fn(|i| limits.lower[i] + draws.even() * (limits.upper[i] - limits.lower[i]))
}

/// Where the frame `F` is at `q`, as a goal.
fn goal<F, S: Pose<f64, F>>(system: &S, q: &S::Q) -> Goal<f64, F> {
    let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
    system.pose(q, &mut rotation, &mut position);
    Goal::pose(rotation, position)
}

fn exact<const NQ: usize>(limits: Limits<f64, NQ>) -> InverseKinematics<f64, NQ> {
    InverseKinematics {
        tolerance: 1e-10,
        ..InverseKinematics::new(limits)
    }
}

fn assert_within<const NQ: usize>(limits: &Limits<f64, NQ>, q: &[f64; NQ]) {
    for i in 0..NQ {
        assert!(
            limits.lower[i] <= q[i] && q[i] <= limits.upper[i],
            "{i} of {q:?}"
        );
    }
}

/// An arm's frame reaches the poses of random coordinates, from starts near to these and far from them.
fn arm<F, S, const NQ: usize, const NU: usize>(system: &S)
where
    S: Pose<f64, F> + Jacobian<f64, F> + System<f64, Q = [f64; NQ], U = [f64; NU]>,
{
    let solver = exact(Limits::of::<S>());
    let mut draws = Noise::new(1);
    for _ in 0..200 {
        let there = between(&mut draws, &solver.limits);
        let goal = goal::<F, S>(system, &there);

        let mut near = there.map(|q| q + 0.1 * symmetric(&mut draws));
        let remaining = solver.solve(system, &goal, &mut near, 20);
        assert!(remaining.is_within(1e-10), "{there:?}: {remaining:?}");
        assert_within(&solver.limits, &near);

        let mut far = between(&mut draws, &solver.limits);
        let remaining = solver.search(system, &goal, &mut far, 100, 50);
        assert!(remaining.is_within(1e-10), "{there:?}: {remaining:?}");
        assert_within(&solver.limits, &far);
    }
}

#[test]
fn the_panda_reaches_poses_it_can_reach() {
    arm::<panda::frames::Payload, _, _, _>(&panda::Prepared::nominal());
}

#[test]
fn the_ur5_reaches_poses_it_can_reach() {
    arm::<ur5::frames::Payload, _, _, _>(&ur5::Prepared::nominal());
}

#[test]
fn limits_are_never_left_though_the_goal_is_out_of_reach() {
    let system = panda::Prepared::nominal();
    let solver = exact(Limits::of::<panda::Prepared<f64>>());
    let mut draws = Noise::new(2);
    for _ in 0..50 {
        // No point of the arm is a metre and a half from where it stands.
        let away = [
            2.0 + draws.even(),
            3.0 * symmetric(&mut draws),
            3.0 * symmetric(&mut draws),
        ];
        let goal = Goal::<_, panda::frames::Payload>::position(away);
        let mut q = between(&mut draws, &solver.limits);
        let mut before = f64::INFINITY;
        for _ in 0..100 {
            let step = solver.step(&system, &goal, &q);
            for (q, u) in q.iter().zip(step.u) {
                assert!(u.is_finite() && q.is_finite());
            }
            let remaining = solver.solve(&system, &goal, &mut q, 1);
            assert!(remaining.weighted <= before, "{remaining:?} after {before}");
            before = remaining.weighted;
            assert_within(&solver.limits, &q);
        }
    }
}

#[test]
fn it_ends_where_no_small_step_helps() {
    // Poses at random, most of them out of reach.
    let system = panda::Prepared::nominal();
    let solver = exact(Limits::of::<panda::Prepared<f64>>());
    let mut draws = Noise::new(3);
    let mut n_stationary = 0;
    for _ in 0..100 {
        let q = between(&mut draws, &solver.limits);
        let turned = goal::<panda::frames::Payload, _>(&system, &q).rotation;
        let place = from_fn(|_| 2.0 * symmetric(&mut draws));
        let goal = Goal::<_, panda::frames::Payload>::pose(turned, place);
        let mut q = between(&mut draws, &solver.limits);
        let _ = solver.solve(&system, &goal, &mut q, 5000);
        n_stationary += usize::from(is_stationary(&system, &goal, &solver.limits, &q));
    }
    // Damping that has grown ends one before.
    assert!(n_stationary >= 99, "{n_stationary}");
}

/// True where the error falls along no coordinate that no limit holds, by differences.
fn is_stationary<F>(
    system: &panda::Prepared<f64>,
    goal: &Goal<f64, F>,
    limits: &Limits<f64, { panda::NQ }>,
    q: &[f64; panda::NQ],
) -> bool
where
    panda::Prepared<f64>: Pose<f64, F> + Jacobian<f64, F>,
{
    let free = InverseKinematics::new(Limits::none());
    let error = |i: usize, by: f64| {
        let mut moved = *q;
        moved[i] += by;
        let step = free.step::<_, _, { panda::NU }>(system, goal, &moved);
        step.remaining.weighted
    };
    let is_level = |i: usize| {
        let rate = (error(i, 1e-5) - error(i, -1e-5)) / 2e-5;
        let is_held = if rate > 0.0 {
            q[i] == limits.lower[i]
        } else {
            q[i] == limits.upper[i]
        };
        is_held || rate.abs() < 1e-4
    };
    (0..panda::NQ).all(is_level)
}

#[test]
fn a_search_begins_elsewhere_whatever_q_is() {
    let system = panda::Prepared::nominal();
    let mut draws = Noise::new(5);
    let limited = exact(Limits::of::<panda::Prepared<f64>>());
    for solver in [limited, exact(Limits::none())] {
        for _ in 0..50 {
            let there = between(&mut draws, &limited.limits);
            let goal = goal::<panda::frames::Payload, _>(&system, &there);
            for first in [f64::NAN, f64::INFINITY, 0.3] {
                let mut q = between(&mut draws, &limited.limits);
                q[0] = first;
                let remaining = solver.search(&system, &goal, &mut q, 100, 50);
                assert!(remaining.is_within(1e-10), "{there:?}: {remaining:?}");
            }
        }
    }
}

#[test]
fn a_search_keeps_what_it_has_reached() {
    // Orientations count next to nothing, but have a tolerance.
    let system = panda::Prepared::nominal();
    let mut solver = exact(Limits::of::<panda::Prepared<f64>>());
    solver.tolerance = 1e-3;
    let mut draws = Noise::new(4);
    for _ in 0..300 {
        let there = between(&mut draws, &solver.limits);
        let goal = goal::<panda::frames::Payload, _>(&system, &there).weighing(1.0, 1e-4);
        let begin = between(&mut draws, &solver.limits);
        let mut n_starts = 1;
        let first = loop {
            let mut q = begin;
            let remaining = solver.search(&system, &goal, &mut q, 10, n_starts);
            if remaining.is_within(1e-3) || n_starts == 10 {
                break remaining;
            }
            n_starts += 1;
        };
        let mut q = begin;
        let remaining = solver.search(&system, &goal, &mut q, 10, 10);
        assert_eq!(remaining, first);
    }
}

#[test]
fn a_joint_at_its_limit_leaves_the_rest_to_the_others() {
    // The hand goes on where the pose of the goal needs the fourth joint beyond a limit that is drawn tighter.
    let system = panda::Prepared::nominal();
    let there = [0.3, -0.4, 0.2, -2.0, 0.1, 1.8, 0.8];
    let goal = goal::<panda::frames::Payload, _>(&system, &there);
    let position = Goal::<_, panda::frames::Payload>::position(goal.position);
    let mut solver = exact(Limits::of::<panda::Prepared<f64>>());
    solver.limits.lower[3] = -1.9;
    let mut q = [0.0, 0.0, 0.0, -1.7, 0.0, 1.8, 0.0];
    let remaining = solver.solve(&system, &position, &mut q, 20);
    assert!(remaining.is_within(1e-10), "{remaining:?}");
    assert_within(&solver.limits, &q);
}

type Solo12 = solo12::Prepared<f64>;

/// Feet and body of the Solo 12 where they are at `q`.
fn stance(
    system: &Solo12,
    q: &[f64; solo12::NQ],
) -> impl Goals<f64, Solo12, { solo12::NU }> + use<> {
    (
        goal::<solo12::frames::BaseLink, _>(system, q),
        on::<solo12::frames::FlFoot>(system, q),
        on::<solo12::frames::FrFoot>(system, q),
        on::<solo12::frames::HlFoot>(system, q),
        on::<solo12::frames::HrFoot>(system, q),
    )
}

/// Where a foot stands, with any orientation.
fn on<F>(system: &Solo12, q: &[f64; solo12::NQ]) -> Goal<f64, F>
where
    Solo12: Pose<f64, F>,
{
    Goal::position(goal::<F, _>(system, q).position)
}

#[test]
fn four_feet_and_a_free_body_reach_their_places() {
    let system = Solo12::nominal();
    let solver = exact(Limits::of::<Solo12>());
    let mut draws = Noise::new(3);
    for _ in 0..100 {
        let there = standing(&mut draws);
        let goals = stance(&system, &there);

        let mut near = there.map(|q| q + 0.1 * symmetric(&mut draws));
        let remaining = solver.solve(&system, &goals, &mut near, 20);
        assert!(remaining.is_within(1e-10), "{there:?}: {remaining:?}");

        let mut far = standing(&mut draws);
        let remaining = solver.search(&system, &goals, &mut far, 200, 50);
        assert!(remaining.is_within(1e-10), "{there:?}: {remaining:?}");
    }
}

/// Anywhere, turned anyhow, with legs that are bent: a straight leg is singular.
fn standing(draws: &mut Noise) -> [f64; solo12::NQ] {
    let mut q: [f64; solo12::NQ] = from_fn(|_| symmetric(draws));
    for (name, q) in Solo12::COORDINATE_NAMES.iter().zip(&mut q) {
        if name.ends_with("kfe") {
            *q = 0.5 * *q - 1.2;
        }
    }
    let length = q[..4].iter().map(|e| e * e).sum::<f64>().sqrt();
    for e in &mut q[..4] {
        *e /= length;
    }
    q
}

#[test]
fn nothing_is_allocated() {
    let system = Solo12::nominal();
    let solver = InverseKinematics::new(Limits::of::<Solo12>());
    let mut draws = Noise::new(4);
    let goals = stance(&system, &standing(&mut draws));
    let mut q = standing(&mut draws);
    let allocations = measure(|| {
        let _ = solver.search(&system, &goals, &mut q, 10, 3);
    });
    assert_eq!(allocations.count_total, 0);
}

#[test]
fn single_precision_reaches_what_it_can_tell_apart() {
    type Arm = panda::Prepared<f32>;
    let system = Arm::nominal();
    let there = [0.3, -0.4, 0.2, -2.0, 0.1, 1.8, 0.8];
    let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
    panda::payload_pose(&system, &there, &mut rotation, &mut position);
    let goal = Goal::<f32, panda::frames::Payload>::pose(rotation, position);
    let solver = InverseKinematics::new(Limits::of::<Arm>());
    assert_eq!((solver.tolerance, solver.least_damping), (1e-5, 1e-4));
    let mut q = [0.0, 0.0, 0.0, -1.7, 0.0, 1.5, 0.0];
    let remaining = solver.solve(&system, &goal, &mut q, 50);
    assert!(remaining.is_within(1e-5), "{remaining:?}");
    // As near as it gets.
    let solver = InverseKinematics {
        tolerance: 2e-6,
        ..solver
    };
    let remaining = solver.solve(&system, &goal, &mut q, 50);
    assert!(remaining.is_within(2e-6), "{remaining:?}");
}

#[test]
fn what_is_not_a_number_is_told() {
    let system = panda::Prepared::nominal();
    let solver = exact(Limits::of::<panda::Prepared<f64>>());
    let goal = Goal::<_, panda::frames::Payload>::position([f64::NAN, 0.0, 0.0]);
    let begin = [0.0, 0.0, 0.0, -1.7, 0.0, 1.5, 0.0];
    let mut q = begin;
    let remaining = solver.solve(&system, &goal, &mut q, 20);
    assert!(!remaining.is_within(1e-10) && remaining.position.is_nan());
    assert_eq!(q, begin);
}
