//! What the examples achieve.

use kane_optimal::{arm, reach, swing_up};

#[test]
fn a_pole_is_swung_up_within_the_limits_of_the_force() {
    let motion = swing_up::run();
    let (q, u) = motion.states.last().unwrap();
    eprintln!("{q:?} {u:?}");
    let most = motion
        .forces
        .iter()
        .fold(0.0, |most: f64, force| most.max(force[0].abs()));
    eprintln!("{most}");
    assert!(most <= swing_up::FORCE);
    for number in [q[0], q[1], u[0], u[1]] {
        assert!(number.abs() < 0.02, "{number}");
    }
}

#[test]
fn an_arm_reaches_a_point_within_the_limits_of_its_drives() {
    let motion = reach::run();
    let (q, u) = motion.states.last().unwrap();
    let way = arm::position(&reach::system(), q) - reach::goal();
    eprintln!("{} {u:?}", way.norm());
    for (joint, limit) in arm::limits().iter().enumerate() {
        let most = motion
            .forces
            .iter()
            .fold(0.0, |most: f64, torques| most.max(torques[joint].abs()));
        eprintln!("{most} of {limit}");
        assert!(most <= *limit);
    }
    assert!(way.norm() < 1e-3, "{}", way.norm());
    assert!(u.iter().all(|speed| speed.abs() < 0.05), "{u:?}");
}
