//! Coordinates that follow others, on trees of two or three bodies.

use kane_test_support::models::build;

/// How many motions of a tree with followers move no mass; nothing else is wrong with it.
fn n_coupled_idle(text: &str) -> usize {
    let Err(faults) = build(text) else {
        return 0;
    };
    for fault in faults.list() {
        let is_of_mass =
            fault.message.ends_with("no mass") || fault.message.starts_with("nothing that moves");
        assert!(is_of_mass, "{}", fault.message);
    }
    faults.list().len()
}

/// A body without mass, or a ball of it.
fn weight(name: &str, mass: f64, joint: &str) -> String {
    format!(
        "[[body]]\nname = \"{name}\"\nmass = {mass:?}\nmass_center = [0.0, 0.0, 0.0]\nattachment = [0.0, 0.0, 0.3]\n\
         inertia = {{ xx = {mass:?}, yy = {mass:?}, zz = {mass:?}, xy = 0.0, xz = 0.0, yz = 0.0 }}\n{joint}\n"
    )
}

#[test]
fn the_rotor_of_what_follows_moves_with_what_it_follows() {
    let idle = |rotor: &str| {
        let follower = format!("joint = [\"theta1\"]\nmimic = {{ joint = \"a\" }}\n{rotor}");
        let bodies = weight("a", 0.0, "joint = [\"theta1\"]") + &weight("b", 0.0, &follower);
        n_coupled_idle(&format!("name = \"s\"\nlower_bodies = [0, 0]\n{bodies}"))
    };
    assert_eq!((idle(""), idle("armature = 0.1")), (1, 0));
}

#[test]
fn mass_beyond_what_follows_moves_with_what_it_follows() {
    let bodies = [
        weight("a", 0.0, "joint = [\"s1\"]"),
        weight("b", 0.0, "joint = [\"s1\"]\nmimic = { joint = \"a\" }"),
        weight("tip", 1.0, "joint = [\"theta2\"]"),
    ];
    let text = format!(
        "name = \"s\"\nlower_bodies = [0, 0, 2]\n{}",
        bodies.concat()
    );
    assert_eq!(n_coupled_idle(&text), 0);
}

#[test]
fn motions_that_cancel_one_another_move_no_mass() {
    let idle = |multiplier: f64| {
        let follows =
            format!("joint = [\"s1\"]\nmimic = {{ joint = \"a\", multiplier = {multiplier:?} }}");
        let bodies = weight("a", 0.0, "joint = [\"s1\"]") + &weight("b", 1.0, &follows);
        n_coupled_idle(&format!("name = \"s\"\nlower_bodies = [0, 1]\n{bodies}"))
    };
    assert_eq!((idle(-1.0), idle(-0.5)), (1, 0));
}
