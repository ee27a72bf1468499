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

/// What is left out, and what the help says of it.
fn helps(behind: &str) -> Vec<(String, String)> {
    let faults = with("", behind).faults.into_iter();
    let left_out = faults.filter(|fault| fault.message.contains("is left out"));
    let helps = left_out.map(|fault| (fault.message, fault.help.unwrap_or_default()));
    helps.collect()
}

#[test]
fn help_says_that_armature_is_reflected_and_that_springs_have_a_rest() {
    for name in ["rotorInertia", "motorInertia"] {
        let text = format!(
            "<transmission name=\"t\"><actuator name=\"m\"><{name}>1e-4</{name}></actuator></transmission>"
        );
        let message = format!("`{name}` of transmission `t` is left out: a URDF has no such value");
        let help = "`kane convert` writes the model in the format of kane, where a joint may have `armature`, the rotor's inertia times the square of the gear ratio";
        assert_eq!(helps(&text), [(message, help.to_owned())]);
    }
    let spring = "<gazebo reference=\"j\"><springReference>0.2</springReference><springStiffness>10</springStiffness></gazebo>";
    let help = "`kane convert` writes the model in the format of kane, where a joint may have `stiffness` and `rest` (`springReference`)";
    let told = helps(spring);
    assert_eq!(told.len(), 1);
    assert_eq!(told[0].1, help);
}

#[test]
fn comments_around_a_number_hide_nothing() {
    for number in [
        "<!-- N m/rad -->10",
        "\n<!-- N m/rad -->\n10",
        "10<!-- N m/rad -->",
    ] {
        let spring =
            format!("<gazebo reference=\"j\"><springStiffness>{number}</springStiffness></gazebo>");
        assert_eq!(helps(&spring).len(), 1, "{number}");
    }
}
