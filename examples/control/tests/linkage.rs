//! A four-bar linkage against its geometry and its equation of motion in the crank's angle alone.

#![expect(
    clippy::disallowed_methods,
    reason = "a last digit that depends on the platform is within the tolerances"
)]

use allocation_counter::measure;
use kane_examples::{
    CallTimes, Desired,
    four_bar::{NQ, NU, Prepared},
    linkage::{Controller, Report, closed, run},
};

/// Of crank, coupler, rocker and the ground between their pivots, m.
const LENGTHS: [f64; 4] = [0.2, 0.5, 0.4, 0.5];
/// Of crank, coupler and rocker: kg, m, m, kg m².
const LINKS: [(f64, [f64; 2], f64); 3] = [
    (1.0, [0.1, 0.0], 0.0035),
    (2.0, [0.25, 0.02], 0.0205),
    (1.5, [0.2, 0.0], 0.0205),
];

/// The angles of the links from the horizontal, rad, by the triangle of the ends of crank and ground: the rocker leans outward.
fn angles(crank: f64) -> [f64; 3] {
    let [r, coupler, rocker, ground] = LENGTHS;
    let [x, y] = [r * crank.cos() - ground, r * crank.sin()];
    let span = x.hypot(y);
    let cosine = (rocker * rocker + span * span - coupler * coupler) / (2.0 * rocker * span);
    let of_rocker = y.atan2(x) - cosine.acos();
    let end = [ground + rocker * of_rocker.cos(), rocker * of_rocker.sin()];
    let of_coupler = (end[1] - r * crank.sin()).atan2(end[0] - r * crank.cos());
    [crank, of_coupler, of_rocker]
}

/// The coordinates with the loop closed, whole turns apart from those of the model.
fn coordinates(crank: f64) -> [f64; NQ] {
    let [crank, coupler, rocker] = angles(crank);
    [crank, coupler - crank, rocker]
}

/// The difference of two angles, rad.
fn apart(a: f64, b: f64) -> f64 {
    (a - b).sin().atan2((a - b).cos())
}

/// The derivative of `f` at `x`, to the fourth order.
fn derivative(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let h = 1e-3;
    let slope = |step: f64| (f(x + step) - f(x - step)) / (2.0 * step);
    (4.0 * slope(h) - slope(2.0 * h)) / 3.0
}

/// Where the mass centre of a link is at a crank's angle, m.
fn center(link: usize, crank: f64) -> [f64; 2] {
    let own = angles(crank);
    let [r, .., ground] = LENGTHS;
    let pivot = [
        [0.0, 0.0],
        [r * crank.cos(), r * crank.sin()],
        [ground, 0.0],
    ][link];
    let (sine, cosine) = own[link].sin_cos();
    let [x, y] = LINKS[link].1;
    [
        pivot[0] + cosine * x - sine * y,
        pivot[1] + sine * x + cosine * y,
    ]
}

/// The linkage's inertia as the crank feels it, kg m².
fn inertia(crank: f64) -> f64 {
    let parts = LINKS.iter().enumerate().map(|(link, (mass, _, inertia))| {
        let [vx, vy] = [0, 1].map(|axis| derivative(|angle| center(link, angle)[axis], crank));
        // Angles jump by whole turns.
        let here = angles(crank)[link];
        let turn = derivative(|angle| apart(angles(angle)[link], here), crank);
        mass * (vx * vx + vy * vy) + inertia * turn * turn
    });
    parts.sum()
}

/// N m, by the crank's equation of motion: `I a + I' w² / 2 + V'`.
fn torque(crank: f64, w: f64, a: f64) -> f64 {
    let weight = |angle: f64| {
        let parts = LINKS.iter().enumerate();
        parts
            .map(|(link, (mass, ..))| 9.81 * mass * center(link, angle)[1])
            .sum()
    };
    inertia(crank) * a + 0.5 * derivative(inertia, crank) * w * w + derivative(weight, crank)
}

fn turned(turns: f64, duration: f64) -> Report {
    let (mut times, mut report) = (CallTimes::default(), None);
    let allocations = measure(|| report = run(turns, duration, &mut times));
    assert_eq!(allocations.count_total, 0);
    report.expect("the links never come into one line")
}

#[test]
fn its_loop_closes_as_the_geometry_says() {
    let linkage = Prepared::nominal();
    for crank in [-0.5, 0.0, 0.3, 0.9] {
        let q = closed(&linkage, crank).expect("these angles close from the one start");
        for (own, expected) in q.into_iter().zip(coordinates(crank)) {
            // 1e-12 m of a link of 0.2 m, at angles that are far from singular.
            assert!(apart(own, expected).abs() < 1e-10, "{crank}: {q:?}");
        }
    }
}

#[test]
fn its_motor_s_torque_is_that_of_the_equation_of_motion_of_the_crank() {
    let controller = Controller::default();
    for (crank, w, a) in [
        (0.3, 2.0, -5.0),
        (1.7, -6.0, 3.0),
        (4.0, 0.0, 0.0),
        (5.5, 9.0, 40.0),
    ] {
        let q = coordinates(crank);
        let speeds = derivatives(crank).map(|rate| rate * w);
        let desired = Desired {
            q: [crank],
            u: [w],
            u_dot: [a],
        };
        let found = controller
            .torque(&q, &speeds, &desired)
            .expect("no singular posture");
        let expected = torque(crank, w, a);
        // Differences of differences of the fourth order with steps of 1e-3.
        let most = 1e-6 * (1.0 + expected.abs());
        assert!(
            (found - expected).abs() < most,
            "{crank}: {found}, {expected}"
        );
    }
}

/// How the coordinates change with the crank's angle.
fn derivatives(crank: f64) -> [f64; NU] {
    let here = coordinates(crank);
    [0, 1, 2].map(|i| derivative(|angle| apart(coordinates(angle)[i], here[i]), crank))
}

#[test]
fn no_torque_moves_coupler_and_rocker_out_of_one_line() {
    let desired = Desired {
        q: [0.3],
        u: [0.0],
        u_dot: [0.0],
    };
    // Both links point the same way.
    let q = [0.3, 0.9, 1.2];
    assert_eq!(Controller::default().torque(&q, &[0.0; NU], &desired), None);
}

#[test]
fn its_crank_turns_as_asked_and_its_loop_stays_closed() {
    for turns in [1.0, -1.0] {
        let report = turned(turns, 2.0);
        assert!(report.error < 1e-3, "{report:?}");
        assert!(report.gap < 1e-8, "{report:?}");
        assert!(report.force < 40.0 && report.torque < 10.0, "{report:?}");
        let expected = coordinates(report.q[0]);
        for (own, expected) in report.q.into_iter().zip(expected) {
            assert!(apart(own, expected).abs() < 1e-7, "{report:?}");
        }
    }
}
