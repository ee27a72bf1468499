//! Angles of MJCF that are in another unit than they look.

use crate::mjcf_support::read;

#[test]
fn ranges_in_radians_are_told_where_angles_are_degrees() {
    let told = |compiler: &str, ranges: &[&str]| {
        let joints = ranges.iter().enumerate();
        let joints = joints.map(|(place, range)| {
            format!("<joint name=\"j{place}\" axis=\"0 1 0\" range=\"{range}\"/>")
        });
        let model = read(&format!(
            "<mujoco>{compiler}<worldbody><body name=\"b\">{}<geom size=\"1\"/></body></worldbody></mujoco>",
            joints.collect::<String>()
        ));
        let faults = model.faults.iter().map(|fault| fault.message.clone());
        faults.collect::<Vec<_>>()
    };
    let warning = "the ranges of all hinges are within 2.80 degrees, and one ends at -1.5700; are they in radians?";
    assert_eq!(told("", &["-1.57 1.57", "0.1 2.8"]), [warning]);
    for right in ["1.5708", "3.14159", "4.712", "6.2832"] {
        assert_eq!(told("", &[&format!("-0.5 {right}")]).len(), 1, "{right}");
    }
    // What may be degrees, and what is in radians.
    assert_eq!(told("", &["-1.57 1.57", "-90 90"]), [""; 0]);
    assert_eq!(told("", &["-1 2", "0 1.5"]), [""; 0]);
    let radians = "<compiler angle=\"radian\"/>";
    assert_eq!(told(radians, &["-1.57 1.57", "0.1 2.8"]), [""; 0]);
}

#[test]
fn help_does_not_take_the_unit_of_ranges_for_that_of_all_angles() {
    let model = read(
        "<mujoco><worldbody><body name=\"b\" euler=\"90 0 0\"><joint axis=\"0 1 0\" range=\"-1.57 1.57\"/><geom size=\"1\"/></body></worldbody></mujoco>",
    );
    let helps: Vec<_> = model
        .faults
        .iter()
        .map(|fault| fault.help.as_deref())
        .collect();
    let help = "convert the ranges to degrees, or set `<compiler angle=\"radian\"/>` if all angles of the file are in radians";
    assert_eq!(helps, [Some(help)]);
}
