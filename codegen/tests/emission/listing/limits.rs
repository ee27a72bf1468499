//! The limits of coordinates and speeds.

use std::f64::consts::TAU;

use kane_codegen::listing::Limits;
use kane_test_support::models::{build, system};

/// Those of two hinges, of which the first has limits ±1 and 10, and the second follows it, with this text behind its joint.
fn limits(second: &str) -> Limits {
    let mut text = system(
        "[0, 0]",
        &[("one", "[\"theta1\"]"), ("two", "[\"theta1\"]")],
    );
    let first = "joint_name = \"lead\"\nlimits = { lower = -1, upper = 1, velocity = 10 }\n";
    let second = format!("mimic = {{ joint = \"lead\", {second}\n");
    let at = text.find("name = \"two\"").expect("the second body");
    let at = text[..at].rfind("[[body]]").expect("its table");
    text.insert_str(at, first);
    text.push_str(&second);
    Limits::of(&build(&text).expect("a sound description").tree)
}

#[test]
fn joints_that_follow_limit_the_one_that_leads() {
    let own = limits("multiplier = 2 }");
    assert_eq!((own.lower, own.upper), (vec![-1.0], vec![1.0]));
    assert_eq!(own.velocity, [10.0]);
    let both = limits("multiplier = 2 }\nlimits = { lower = -0.5, upper = 0.25, velocity = 1 }");
    assert_eq!((both.lower, both.upper), (vec![-0.25], vec![0.125]));
    assert_eq!(both.velocity, [0.5]);
    let turned = limits(
        "multiplier = -2, offset = 0.5 }\nlimits = { lower = -0.5, upper = 4, velocity = 40 }",
    );
    assert_eq!((turned.lower, turned.upper), (vec![-1.0], vec![0.5]));
    assert_eq!(turned.velocity, [10.0]);
}

#[test]
fn limits_that_leave_no_motion_do_not_count() {
    // As files say it where they say nothing.
    let absent = limits("multiplier = 2 }\nlimits = { lower = 0, upper = 0, velocity = 0 }");
    assert_eq!((absent.lower, absent.upper), (vec![-1.0], vec![1.0]));
    assert_eq!(absent.velocity, [10.0]);
    let touching = limits("multiplier = -1 }\nlimits = { lower = 1, upper = 2 }");
    assert_eq!((touching.lower, touching.upper), (vec![-1.0], vec![1.0]));
    let none = limits(&format!(
        "offset = {TAU} }}\nlimits = {{ lower = -1, upper = 1 }}"
    ));
    assert_eq!((none.lower, none.upper), (vec![-1.0], vec![1.0]));
}
