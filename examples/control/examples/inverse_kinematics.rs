//! The Solo 12 crouches and looks down: where its joints have to be, with all four feet where they stand.

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane::{
    System,
    functions::Pose,
    inverse_kinematics::{Goal, InverseKinematics, Limits},
};
use kane_examples::solo12::{
    NQ, Prepared,
    frames::{BaseLink, FlFoot, FrFoot, HlFoot, HrFoot},
};

type Robot = Prepared<f64>;

fn main() {
    let robot = Robot::nominal();
    // The body's quaternion and position, then each leg's hip, thigh and knee.
    let front = [0.0, 0.8, -1.6];
    let hind = [0.0, -0.8, 1.6];
    let mut q = [0.0; NQ];
    q[0] = 1.0;
    for (leg, angles) in [front, front, hind, hind].into_iter().enumerate() {
        q[7 + 3 * leg..][..3].copy_from_slice(&angles);
    }

    // Five centimetres down, and the nose by a fifth of a radian: the rotation maps inertial components to the body's.
    let (sine, cosine) = kane::Real::sin_cos(0.2);
    let rotation = [[cosine, 0.0, -sine], [0.0, 1.0, 0.0], [sine, 0.0, cosine]];
    let goals = (
        Goal::<_, BaseLink>::pose(rotation, [0.0, 0.0, -0.05]),
        stays::<FlFoot>(&robot, &q),
        stays::<FrFoot>(&robot, &q),
        stays::<HlFoot>(&robot, &q),
        stays::<HrFoot>(&robot, &q),
    );
    let solver = InverseKinematics::new(Limits::of::<Robot>());
    let remaining = solver.solve(&robot, &goals, &mut q, 100);

    for (name, q) in Robot::COORDINATE_NAMES.iter().zip(q) {
        println!("{name:>14} {q:8.4}");
    }
    println!(
        "within {:.3} µm and {:.3} µrad of all five goals",
        1e6 * remaining.position,
        1e6 * remaining.orientation,
    );
}

/// The foot `F` where it is.
fn stays<F>(robot: &Robot, q: &[f64; NQ]) -> Goal<f64, F>
where
    Robot: Pose<f64, F>,
{
    let (mut rotation, mut position) = ([[0.0; 3]; 3], [0.0; 3]);
    robot.pose(q, &mut rotation, &mut position);
    Goal::position(position)
}
