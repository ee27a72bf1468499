//! Generates the robots of this package and the models of `tests/mjcf`, as a user's build script would.

use std::{env, fmt::Write as _, fs, path::Path};

use kane_codegen::{
    build_script::Build,
    config::Formulation,
    description::{Base, Chart},
    error::Error,
};
use kane_test_support::systems::trees;

/// What has a value in the references, and no other function: each is compiled several times.
const FUNCTIONS: [&str; 12] = [
    "rotation",
    "origin_position",
    "mass_center_position",
    "mass_matrix",
    "bias",
    "gravity_forces",
    "inverse_dynamics",
    "forward_dynamics",
    "kinetic_energy",
    "potential_energy",
    "linear_momentum",
    "angular_momentum",
];

/// Of these, those with two formulations.
const DYNAMICS: [&str; 5] = [
    "mass_matrix",
    "bias",
    "gravity_forces",
    "inverse_dynamics",
    "forward_dynamics",
];

/// Functions of the mass centre that have a value in the references.
const OF_CENTER: [&str; 4] = [
    "center_of_mass",
    "center_of_mass_velocity",
    "center_of_mass_jacobian",
    "centroidal_momentum_matrix",
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    trees::announce_all_seeds();
    for name in [
        "cartpole",
        "double_pendulum",
        "double_pendulum_continuous",
        "ur5",
        "panda",
    ] {
        robot(name, Base::Fixed)?;
    }
    for name in ["solo12", "talos"] {
        robot(name, Base::Free)?;
        if is_compiled(name) {
            generate(with_angles(name), &format!("{name}_angles"))?;
        }
    }
    notes(with_angles("solo12"), "solo12_angles")?;
    generate(
        model("panda")
            .lock("panda_joint3", 0.4)
            .lock("panda_joint6", -0.7)
            .remove("panda_joint5"),
        "panda_held",
    )?;
    for (name, base) in [("panda", Base::Fixed), ("solo12", Base::Free)] {
        unsnapped(name)
            .base(base)
            .functions(DYNAMICS)
            .fma()
            .name(format!("{name}_fused"))
            .run()?;
    }
    for gripper in ["gripper", "gripper_free"] {
        let built = Build::new(format!("gripper/{gripper}.urdf"));
        generate(built.clone(), gripper)?;
        notes(built, gripper)?;
    }
    joined(model("panda"), "panda")?;
    joined(model("solo12").base(Base::Free), "solo12")?;
    joined(Build::new("gripper/gripper.urdf"), "gripper")?;
    frames()?;
    matrices()?;
    derivatives()?;
    systems()?;
    hybrid()?;
    mjcf()
}

/// Functions of the hand's frame, which is a link fixed to the last that moves.
fn frames() -> Result<(), Error> {
    let build = model("panda").functions([
        "pose(panda_hand_tcp)",
        "velocity(panda_hand_tcp)",
        "velocity(panda_hand_tcp, local)",
        "pose(panda_hand_tcp)+velocity(panda_hand_tcp)",
        "position(panda_hand_tcp)",
        "linear_velocity(panda_hand_tcp, local)",
        "linear_acceleration(panda_hand_tcp)",
        "linear_jacobian(panda_hand_tcp)",
        "linear_jacobian_packed(panda_link4)",
        "linear_jacobian_dot_u(panda_hand_tcp)",
        "linear_generalized_force(panda_hand_tcp)",
        "linear_operational_inverse_inertia(panda_hand_tcp, panda_link4)",
        "operational_inverse_inertia(panda_hand_tcp, panda_link4)",
        "acceleration(panda_hand_tcp)",
        "acceleration(panda_hand_tcp, local)",
        "jacobian(panda_hand_tcp)",
        "jacobian(panda_hand_tcp, local)",
        "jacobian(panda_hand_tcp, panda_link4)",
        "jacobian_packed(panda_link4)",
        "jacobian(panda_link4)",
        "point_jacobian(panda_hand_tcp)",
        "jacobian_dot_u(panda_hand_tcp)",
        "generalized_force(panda_hand_tcp)",
        "imu(panda_hand_tcp)",
    ]);
    build.name("panda_frames").run()?;
    Ok(())
}

/// Matrices over speeds.
fn matrices() -> Result<(), Error> {
    for (name, base) in [
        ("cartpole", Base::Fixed),
        ("double_pendulum", Base::Fixed),
        ("ur5", Base::Fixed),
        ("panda", Base::Fixed),
        ("solo12", Base::Free),
        ("talos", Base::Free),
    ] {
        if !is_compiled(name) {
            continue;
        }
        let build = unsnapped(name).base(base).functions([
            "mass_matrix",
            "mass_matrix_product",
            "mass_matrix_solve",
            "mass_matrix_inverse",
            "mass_matrix_factors",
            "coriolis_matrix",
            "mass_matrix_dot",
        ]);
        build.name(format!("{name}_matrices")).run()?;
    }
    Ok(())
}

/// Of the humanoid, the only robot here whose helpers are long enough for several loops.
fn derivatives() -> Result<(), Error> {
    if is_compiled("talos") {
        let build = unsnapped("talos").base(Base::Free);
        let build = build.functions(["d(inverse_dynamics)/d(q, u, u_dot)"]);
        build.name("talos_derivatives").run()?;
    }
    Ok(())
}

/// Functions of the mass centre, and the regressors for which there are references.
fn systems() -> Result<(), Error> {
    for (name, base) in [
        ("cartpole", Base::Fixed),
        ("ur5", Base::Fixed),
        ("panda", Base::Fixed),
        ("solo12", Base::Free),
        ("talos", Base::Free),
    ] {
        let build = unsnapped(name).base(base).name(format!("{name}_center"));
        build.functions(OF_CENTER).run()?;
        if base == Base::Fixed {
            let build = unsnapped(name).name(format!("{name}_regressor"));
            build.functions(["regressor"]).run()?;
        }
    }
    Ok(())
}

/// Robots of which some joints are prescribed.
fn hybrid() -> Result<(), Error> {
    let some_of_arm = ["panda_joint2", "panda_joint4", "panda_joint5"];
    let legs = ["FL_HAA", "FL_HFE", "FL_KFE", "FR_KFE", "HL_HAA"];
    let base = ["root_joint", "FL_HFE", "HR_KFE"];
    for (build, joints, name) in [
        (
            unsnapped("ur5"),
            &["elbow_joint", "wrist_2_joint"][..],
            "ur5",
        ),
        (unsnapped("panda"), &some_of_arm, "panda"),
        (unsnapped("solo12").base(Base::Free), &legs, "solo12_legs"),
        (unsnapped("solo12").base(Base::Free), &base, "solo12_base"),
        (with_angles("solo12"), &legs, "solo12_angles_legs"),
        (with_angles("solo12"), &base, "solo12_angles_base"),
    ] {
        let build = joints
            .iter()
            .fold(build, |build, joint| build.prescribed(*joint));
        let build = build.functions(["hybrid_dynamics"]);
        build.name(format!("{name}_hybrid")).run()?;
    }
    Ok(())
}

/// Functions as they stand in the catalogue, joined, and with their sines and cosines given.
fn joined(build: Build, name: &str) -> Result<(), Error> {
    let functions = [
        "mass_matrix",
        "mass_matrix_packed",
        "bias",
        "gravity_forces",
        "inverse_dynamics",
        "mass_matrix+bias+gravity_forces",
        "mass_matrix+bias(sin_cos)",
        "inverse_dynamics(sin_cos)",
    ];
    let build = build.functions(functions);
    build.name(format!("{name}_joined")).run()?;
    Ok(())
}

/// A robot of the references: as its file is, snapped as by default, and in the notes' formulation.
fn robot(name: &str, base: Base) -> Result<(), Error> {
    generate(unsnapped(name).base(base), name)?;
    if is_compiled(name) {
        generate(model(name).base(base), &format!("{name}_snapped"))?;
    }
    if name != "talos" {
        notes(unsnapped(name).base(base), name)?;
    }
    Ok(())
}

/// True for a robot of which more than its own functions are compiled: the humanoid's take half of the compiler's time.
fn is_compiled(name: &str) -> bool {
    trees::all_seeds() || name != "talos"
}

fn model(name: &str) -> Build {
    Build::new(format!("{name}/{name}.urdf"))
}

/// As exact as the file is.
fn unsnapped(name: &str) -> Build {
    model(name).snap(0.0)
}

/// With a floating base that is described by angles.
fn with_angles(name: &str) -> Build {
    unsnapped(name).base(Base::Free).chart(Chart::Angles)
}

fn generate(build: Build, name: &str) -> Result<(), Error> {
    build.functions(FUNCTIONS).name(name).run()?;
    Ok(())
}

fn notes(build: Build, name: &str) -> Result<(), Error> {
    build
        .functions(DYNAMICS)
        .formulation(Formulation::Notes)
        .name(format!("{name}_notes"))
        .run()?;
    Ok(())
}

/// Every model of `tests/mjcf`, and a module that lists them.
#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the output folder of a build script in its environment"
)]
fn mjcf() -> Result<(), Box<dyn std::error::Error>> {
    let folder = Path::new("../mjcf");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut names = Vec::new();
    for entry in fs::read_dir(folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if folder.join(&name).join(format!("{name}.xml")).exists() {
            names.push(name);
        }
    }
    names.sort();
    let (mut modules, mut list) = (String::new(), String::new());
    for name in &names {
        let model = folder.join(name).join(format!("{name}.xml"));
        Build::new(model).functions(DYNAMICS).name(name).run()?;
        write!(modules, "modules! {{\n/// As its file is.\n{name}\n}}\n")?;
        writeln!(
            list,
            "({name:?}, || Box::new({name}::Prepared::nominal())),"
        )?;
    }
    let list = format!(
        "/// Each model with the name of its folder.\npub const MODELS: &[(&str, super::MakeDynamics)] = &[\n{list}];\n"
    );
    let target = Path::new(&env::var("OUT_DIR")?).join("mjcf.rs");
    fs::write(target, modules + &list)?;
    Ok(())
}
