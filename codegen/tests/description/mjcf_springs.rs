//! Springs and dampers that `springdamper` gives where hinges of a wrist share an axis.

use kane_test_support::compare::{Tolerance, assert_close};

use crate::mjcf_support::{baked, faults, parse, read};

/// An arm with a wrist, the hinges of which are these.
fn arm(shoulder: &str, wrist: &str) -> String {
    let turned = "euler=\"15 25 35\"";
    format!(
        "<mujoco><worldbody>
           <body name=\"upper\" euler=\"10 20 30\"><joint name=\"shoulder\" axis=\"0.3 1 0.2\" {shoulder}/>
             <geom size=\"0.05\" pos=\"0 0.05 -0.2\"/>
             <body name=\"hand\" pos=\"0 0.1 -0.4\" {turned}>{wrist}<geom type=\"box\" size=\"0.04 0.1 0.2\" pos=\"0.03 0.02 -0.1\"/></body>
           </body>
         </worldbody></mujoco>"
    )
}

const ROLL: &str = "<joint name=\"roll\" axis=\"0.3 0.1 1\"/>";
const PITCH: &str = "<joint name=\"pitch\" axis=\"0 1 0\"/>";

#[test]
fn a_hinge_that_moves_what_another_one_does_changes_no_spring() {
    let yaw = ROLL.replace("roll", "yaw");
    let [spring, other] = [format!("{ROLL}{PITCH}"), format!("{ROLL}{PITCH}{yaw}")].map(|wrist| {
        let model = read(&arm("springdamper=\"0.2 0.35\"", &wrist));
        let joint = &model.bodies[0].joint;
        [&joint.stiffness, &joint.damping].map(|own| baked(own).expect("a spring and a damper"))
    });
    assert_close(
        "spring, damper",
        &other,
        &spring,
        Tolerance::relative(1e-12),
    );
}

#[test]
fn a_hinge_that_moves_what_another_one_does_has_no_inertia_for_a_spring() {
    let yaw = ROLL.replace("roll", "yaw");
    let sprung = ROLL.replace("/>", " springdamper=\"0.2 0.35\"/>");
    let model = parse(&arm("", &format!("{sprung}{PITCH}{yaw}")), &[]);
    let told = faults(&model).to_string();
    assert!(
        told.contains("error: this joint has no inertia of its own"),
        "{told}"
    );
}
