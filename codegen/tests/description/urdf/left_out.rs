//! Springs and rotors that only other programs have.

use kane_codegen::description::{Description, Reading};

use super::{NO_GRAVITY, parse, robot, told};

/// A robot with one joint, and this inside it and behind it.
fn with(inside: &str, behind: &str) -> Description {
    let text = robot(&[("j", "continuous", "a", "b", inside)]);
    let text = text.replace("</robot>", &format!("{behind}</robot>"));
    parse(&text, &Reading::default())
}

#[test]
fn springs_and_rotors_are_told_to_be_left_out() {
    let spring = "<gazebo reference=\"j\"><springReference>0.2</springReference><springStiffness> 10 </springStiffness></gazebo>";
    let rotor = "<transmission name=\"t\"><actuator name=\"m\"><rotorInertia>1e-4</rotorInertia></actuator></transmission>";
    let drake = "<transmission><actuator name=\"m\"><drake:rotor_inertia xmlns:drake=\"d\" value=\"0.3\"/></actuator></transmission>";
    let of_spring = "`springStiffness` of gazebo `j` is left out: a URDF has no such value";
    assert_eq!(told(&with("", spring)), [NO_GRAVITY, of_spring]);
    let of_rotor = "`rotorInertia` of transmission `t` is left out: a URDF has no such value";
    assert_eq!(told(&with("", rotor)), [NO_GRAVITY, of_rotor]);
    let of_drake = "`drake:rotor_inertia` of a transmission is left out: a URDF has no such value";
    assert_eq!(told(&with("", drake)), [NO_GRAVITY, of_drake]);
    let motor = rotor.replace("rotorInertia", "motorInertia");
    let of_motor = of_rotor.replace("rotorInertia", "motorInertia");
    assert_eq!(told(&with("", &motor)), [NO_GRAVITY, &of_motor]);
    let noted = spring.replace(" 10 ", "<!-- N m/rad -->10");
    assert_eq!(told(&with("", &noted)), [NO_GRAVITY, of_spring]);
    // Many of them are one line.
    let model = with("", &(spring.repeat(2) + rotor));
    let source = model.source.clone();
    let told = kane_codegen::diagnostic::Diagnostics::new(source, model.faults).brief();
    let told: Vec<&String> = told.lines.iter().map(|line| &line.1).collect();
    assert!(
        told.iter()
            .any(|line| line.contains("2 springs of Gazebo are left out")),
        "{told:?}"
    );
}

#[test]
fn what_has_no_effect_is_left_out_without_a_word() {
    let reduction = "<transmission name=\"t\"><joint name=\"j\"/><actuator name=\"m\"><mechanicalReduction>50</mechanicalReduction><rotorInertia>0</rotorInertia></actuator></transmission>";
    let implicit = "<gazebo reference=\"j\"><implicitSpringDamper>1</implicitSpringDamper><springStiffness>0.0</springStiffness></gazebo>";
    assert_eq!(told(&with("", reduction)), [NO_GRAVITY]);
    assert_eq!(told(&with(implicit, reduction)), [NO_GRAVITY]);
    // Of what stands elsewhere nothing is known.
    let visual = "<material name=\"m\"><springStiffness>1</springStiffness></material>";
    assert_eq!(told(&with("", visual)), [NO_GRAVITY]);
}
