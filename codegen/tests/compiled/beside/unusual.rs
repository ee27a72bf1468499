//! Models with numbers far from one, and far from one another.

use std::fmt::Write as _;

use super::crates::Tested;
use super::mutants::{Evaluated, Verdict};
use kane_test_support::mutant::{Mutant, mutant};

/// A shoulder that turns, an elbow, and a tip that slides: their masses, kg, the length of each, m, and what acts in the
/// first joint.
fn chain(masses: [f64; 3], length: f64, mechanics: &str) -> String {
    let mut text =
        "name = \"chain\"\ngravity = [0.0, 0.0, -9.81]\nlower_bodies = [0, 1, 2]\n".to_owned();
    let joints = [
        format!("joint = \"revolute\"\naxis = [0.3, 1.0, 0.2]\n{mechanics}"),
        "joint = \"universal\"\n".to_owned(),
        "joint = \"prismatic\"\naxis = [0.1, -0.4, 1.0]\n".to_owned(),
    ];
    for (place, (mass, joint)) in masses.into_iter().zip(joints).enumerate() {
        let [x, y, z] = [0.21, -0.34, 0.55].map(|part| part * length);
        let [xx, yy, zz, xy] = [0.11, 0.13, 0.09, 0.02].map(|part| part * mass * length * length);
        write!(
            text,
            "\n[[body]]\nname = \"b{place}\"\nmass = {mass:?}\nmass_center = [{x:?}, {y:?}, {z:?}]\n\
             inertia = {{ xx = {xx:?}, yy = {yy:?}, zz = {zz:?}, xy = {xy:?}, xz = 0.0, yz = 0.0 }}\n\
             attachment = [{z:?}, {x:?}, {y:?}]\n{joint}"
        )
        .unwrap();
    }
    text
}

/// What the tests of values do not see is compiled and run: their identities may.
fn assert_caught(tested: &Tested, evaluated: &Evaluated, mutant: &Mutant) {
    let is_seen = evaluated.verdict(mutant) == Verdict::Seen;
    let is_caught = is_seen || tested.fails(&mutant.module);
    assert!(is_caught, "not caught: {}", mutant.line);
}

fn assert_tested(description: &str) {
    let tested = Tested::new(description);
    tested.passes("the module as it is");
    let evaluated = Evaluated::new(tested.module(), tested.tests());
    for seed in 0..4 {
        let mutant = mutant(tested.module(), seed);
        assert_caught(&tested, &evaluated, &mutant);
    }
}

/// States of metres would be all that counts in its equations.
#[test]
fn a_microscopic_chain() {
    assert_tested(&chain([2e-9, 1e-9, 5e-10], 1e-5, ""));
}

/// A solution with its mass matrix has lost most of its digits.
#[test]
fn a_chain_that_ends_in_nearly_nothing() {
    assert_tested(&chain([2.0, 1e-6, 1e-12], 0.5, ""));
}

/// Its first joint moves hardly more than what is on it.
#[test]
fn a_chain_that_ends_in_nearly_everything() {
    assert_tested(&chain([1e-6, 1e-3, 1e3], 0.5, ""));
}

/// Forces of the spring are a billion times those of the motion.
#[test]
fn a_chain_on_a_stiff_spring() {
    assert_tested(&chain(
        [2.0, 1.0, 0.5],
        0.5,
        "stiffness = 1e9\nrest = 0.3\n",
    ));
}

/// The rotor is all that the first joint feels.
#[test]
fn a_chain_behind_a_rotor() {
    assert_tested(&chain(
        [2.0, 1.0, 0.5],
        0.5,
        "armature = 1e5\ndamping = 1e5\n",
    ));
}

/// An arm of which much is zero, and could be something else.
const ZEROS: &str = r#"
name = "arm"
gravity = [{ runtime = 0.0 }, 0.0, -9.81]
lower_bodies = [0, 1]

[[body]]
name = "upper"
mass = 2.0
mass_center = [0.0, { runtime = 0.0 }, 0.3]
inertia = { xx = 0.03, yy = 0.03, zz = 0.02, xy = 0.0, xz = { runtime = 0.0 }, yz = 0.0 }
attachment = [0.0, 0.0, 0.1]
joint = "universal"

[[body]]
name = "fore"
mass = 1.0
mass_center = [0.0, 0.0, 0.2]
inertia = { xx = 0.01, yy = 0.01, zz = 0.01, xy = 0.0, xz = 0.0, yz = 0.0 }
attachment = [{ runtime = 0.0 }, 0.0, 0.6]
joint = "revolute"
axis = [0.0, 1.0, 0.0]
stiffness = { runtime = 0.0 }
rest = 0.2
damping = { runtime = 0.0 }
"#;

/// The module with the other sign before a parameter, where it is first added or subtracted.
fn with_wrong_sign(module: &str, parameter: &str) -> Mutant {
    let [plus, minus] = [" + p.", " - p."].map(|sign| format!("{sign}{parameter} "));
    let (right, wrong) = if module.contains(&minus) {
        (minus, plus)
    } else {
        (plus, minus)
    };
    let place = module.find(&right);
    let place = place.unwrap_or_else(|| panic!("{parameter} is never added"));
    Mutant {
        module: module.replacen(&right, &wrong, 1),
        line: parameter.to_owned(),
        place,
    }
}

#[test]
fn a_wrong_sign_before_a_parameter_that_is_zero() {
    let tested = Tested::new(ZEROS);
    tested.passes("the module as it is");
    let evaluated = Evaluated::new(tested.module(), tested.tests());
    for parameter in [
        "gravity_x",
        "upper_mass_center_y",
        "upper_inertia_xz",
        "fore_attachment_x",
        "fore_stiffness",
    ] {
        let wrong = with_wrong_sign(tested.module(), parameter);
        assert_caught(&tested, &evaluated, &wrong);
    }
}

const TURNED_FRAME: &str = r#"
[[frame]]
name = "camera"
body = "upper"
position = [0.1, { runtime = 0.2 }, 0.3]
rotation = { runtime = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]] }
"#;

/// Its nine numbers are those of a rotation in each state: of other numbers equations are not true.
#[test]
fn a_frame_that_is_turned_at_run_time() {
    let requests = [
        "pose(camera)",
        "jacobian(camera, local)",
        "jacobian(fore, camera)",
        "jacobian_packed(fore, camera)",
        "position(fore, camera)",
        "linear_jacobian_packed(camera, local)",
        "linear_generalized_force(camera, local)",
        "linear_operational_inverse_inertia(camera, fore)",
        "jacobian_dot_u(camera, local)",
        "point_jacobian(camera)",
        "generalized_force(camera)",
        "operational_inverse_inertia(camera, fore)",
        "imu(camera)",
        "d(jacobian(camera, local))/d(q, parameters)",
        "jvp(operational_inverse_inertia(camera); q, parameters)",
        "vjp(imu(camera); q, u, parameters)",
    ];
    let tested = Tested::with(&format!("{ZEROS}{TURNED_FRAME}"), &requests);
    tested.passes("the module as it is");
}

/// It has none, and its derivatives by them have no columns.
#[test]
fn a_chain_and_its_derivatives_by_values_at_run_time() {
    let chain = chain([2.0, 1.0, 0.5], 0.5, "");
    let requests = [
        "d(inverse_dynamics)/d(parameters)",
        "vjp(forward_dynamics; q, u, tau, parameters)",
    ];
    assert!(Tested::with(&chain, &requests).passes("without values at run time") > 0);
}
