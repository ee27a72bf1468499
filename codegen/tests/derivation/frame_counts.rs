//! Operations of functions of frames, and of their derivatives.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fmt::Write as _;

use kane_codegen::description::{Base, Reading};

use crate::{
    compiled::read,
    counts::{counts_of, table},
    pages,
};

/// Functions of the frame `F`.
const OF_FRAMES: [&str; 23] = [
    "pose(F)",
    "position(F)",
    "velocity(F)",
    "linear_velocity(F)",
    "velocity(F, local)",
    "pose(F)+velocity(F)",
    "acceleration(F)",
    "linear_acceleration(F)",
    "acceleration(F, local)",
    "jacobian(F)",
    "linear_jacobian(F)",
    "jacobian(F, local)",
    "jacobian_packed(F)",
    "point_jacobian(F)",
    "jacobian_dot_u(F)",
    "linear_jacobian_dot_u(F)",
    "generalized_force(F)",
    "linear_generalized_force(F)",
    "generalized_force(F, local)",
    "imu(F)",
    "operational_inverse_inertia(F)",
    "linear_operational_inverse_inertia(F)",
    "pose(F)+jacobian(F)",
];

const DERIVATIVES_OF_FRAMES: [&str; 11] = [
    "d(pose(F))/d(q)",
    "d(position(F))/d(q)",
    "d(jacobian(F))/d(q)",
    "d(linear_jacobian(F))/d(q)",
    "d(velocity(F))/d(q, u)",
    "d(velocity(F, local))/d(q, u)",
    "d(acceleration(F))/d(q, u, u_dot)",
    "d(linear_acceleration(F))/d(q, u, u_dot)",
    "d(acceleration(F, local))/d(q, u, u_dot)",
    "d(jacobian_dot_u(F))/d(q, u)",
    "d(imu(F))/d(q, u, u_dot)",
];

/// The counts of functions of a frame of each robot.
fn of_frames(requests: &[&str]) -> String {
    let mut text = String::new();
    for (robot, frame) in [
        ("ur5", "tool0"),
        ("panda", "panda_hand_tcp"),
        ("solo12", "FL_FOOT"),
        ("talos", "gripper_left_base_link"),
    ] {
        let path = format!("tests/robots/{robot}/{robot}.urdf");
        let base = ["solo12", "talos"].contains(&robot).then_some(Base::Free);
        let reading = Reading {
            base,
            ..Reading::default()
        };
        let tree = read(&path, &reading);
        let requests = requests.iter().map(|request| {
            let request = request.replace("(F)", &format!("({frame})"));
            request.replace("(F, ", &format!("({frame}, "))
        });
        let counts = counts_of(&tree, &requests.collect::<Vec<_>>());
        write!(text, "{robot}\n{}", table(&counts)).unwrap();
    }
    text
}

#[test]
fn frames_of_robots() {
    insta::assert_snapshot!(of_frames(&OF_FRAMES));
}

#[test]
fn derivatives_of_frames_of_robots() {
    insta::assert_snapshot!(of_frames(&DERIVATIVES_OF_FRAMES));
}

#[test]
fn the_comparison_has_the_counts_of_jacobians() {
    for (robot, base, link) in [
        ("ur5", Base::Fixed, "wrist_3_link"),
        ("panda", Base::Fixed, "panda_link7"),
        ("solo12", Base::Free, "FL_LOWER_LEG"),
        ("talos", Base::Free, "arm_left_7_link"),
    ] {
        let reading = Reading {
            base: Some(base),
            ..Reading::default()
        };
        let tree = read(&format!("tests/robots/{robot}/{robot}.urdf"), &reading);
        let counts = counts_of(&tree, &[format!("jacobian({link})")]);
        let total = counts[0].1.total().to_string();
        pages::comparison().has_row(robot, 7, &[(2, &total)]);
    }
}
