//! Generates the robots from their URDFs, the arms with a payload in their hands that is set at run time, and a linkage.

use std::{env, error::Error, fs, path::Path};

use kane_codegen::{
    build_script::Build,
    config::Functions,
    description::{self, Base, Reading, Scalar, no_includes, toml},
    diagnostic::Source,
    generate::generate,
    options::Options,
    output::{self, Overwrite},
};

const UR5: [&str; 7] = [
    "gravity_forces",
    "forward_dynamics",
    "mass_matrix_product",
    "coriolis_matrix",
    "pose(payload)",
    "jacobian(payload)",
    "generalized_force(payload)",
];

const PANDA: [&str; 9] = [
    "inverse_dynamics",
    "forward_dynamics",
    "regressor",
    "mass_matrix_inverse",
    "pose(payload)",
    "velocity(payload)",
    "jacobian(payload)",
    "jacobian_dot_u(payload)",
    "generalized_force(payload)",
];

const SOLO12: [&str; 20] = [
    "pose(base_link)",
    "jacobian(base_link)",
    "pose(FL_FOOT)",
    "jacobian(FL_FOOT)",
    "pose(FR_FOOT)",
    "jacobian(FR_FOOT)",
    "pose(HL_FOOT)",
    "jacobian(HL_FOOT)",
    "pose(HR_FOOT)",
    "jacobian(HR_FOOT)",
    // What balances it calls together.
    "mass_matrix+bias",
    "feet = linear_jacobian(FL_FOOT)+linear_jacobian(FR_FOOT)+linear_jacobian(HL_FOOT)+linear_jacobian(HR_FOOT)\
     +linear_jacobian_dot_u(FL_FOOT)+linear_jacobian_dot_u(FR_FOOT)+linear_jacobian_dot_u(HL_FOOT)+linear_jacobian_dot_u(HR_FOOT)",
    "balance = center_of_mass+centroidal_momentum_matrix+centroidal_momentum_matrix_dot_u\
     +pose(base_link)+velocity(base_link)+jacobian(base_link)+jacobian_dot_u(base_link)",
    // It is pushed at its base, and by the ground at its feet.
    "forward_dynamics",
    "contacts = position(FL_FOOT)+position(FR_FOOT)+position(HL_FOOT)+position(HR_FOOT)\
     +linear_velocity(FL_FOOT)+linear_velocity(FR_FOOT)+linear_velocity(HL_FOOT)+linear_velocity(HR_FOOT)",
    "generalized_force(base_link)",
    "linear_generalized_force(FL_FOOT)",
    "linear_generalized_force(FR_FOOT)",
    "linear_generalized_force(HL_FOOT)",
    "linear_generalized_force(HR_FOOT)",
];

const FOUR_BAR: [&str; 6] = [
    "inverse_dynamics",
    "forward_dynamics",
    "mass_matrix_inverse",
    // The two ends of the loop.
    "ends = position(coupler_end)+linear_jacobian(coupler_end)+linear_jacobian_dot_u(coupler_end)\
     +position(rocker_end)+linear_jacobian(rocker_end)+linear_jacobian_dot_u(rocker_end)",
    // One seen from the other, for inverse kinematics.
    "pose(coupler_end, rocker_end)",
    "jacobian(coupler_end, rocker_end)",
];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    with_payload("ur5", "tool0", Payload::Point, &UR5)?;
    with_payload("panda", "panda_hand_tcp", Payload::Body, &PANDA)?;
    Build::new("../../tests/robots/solo12/solo12.urdf")
        .base(Base::Free)
        .functions(SOLO12)
        .run()?;
    Build::new("models/four_bar.toml")
        .functions(FOUR_BAR)
        .run()?;
    Ok(())
}

/// What of a payload is set at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Payload {
    /// The mass of a point at the tool's tip.
    Point,
    /// Mass, mass centre and inertia.
    Body,
}

/// The massless link at the tool's tip becomes the payload; by hand, `kane convert` and an editor do that. Where
/// nothing is to be changed, `build_script::Build` is all that a build script needs.
#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the output folder of a build script in its environment"
)]
fn with_payload(
    robot: &str,
    tip: &str,
    payload: Payload,
    functions: &[&str],
) -> Result<(), Box<dyn Error>> {
    let urdf = format!("../../tests/robots/{robot}/{robot}.urdf");
    println!("cargo::rerun-if-changed={urdf}");
    let source = Source::new(&*urdf, fs::read_to_string(&urdf)?);
    let mut model = description::read(&source, &Reading::default(), &no_includes);
    for body in &mut model.bodies {
        if let Some(name) = &mut body.name
            && name.value == tip
        {
            "payload".clone_into(&mut name.value);
            let mut set = vec![&mut body.mass];
            if payload == Payload::Body {
                set.extend(&mut body.mass_center);
                set.extend(&mut body.inertia);
            }
            for number in set.into_iter().flatten() {
                number.value = Scalar::Runtime(0.0);
            }
        }
    }
    let options = Options {
        functions: Functions::Named(functions.iter().map(ToString::to_string).collect()),
        ..Options::default()
    };
    let shown = format!("{robot}.toml");
    let model = Source::new(&*shown, toml::write(&model)?);
    let generated = generate(&model, &shown, &options, &no_includes)?;
    let path = Path::new(&env::var("OUT_DIR")?).join(format!("{robot}.rs"));
    output::write(&generated.files(&path), Overwrite::Generated)?;
    Ok(())
}
