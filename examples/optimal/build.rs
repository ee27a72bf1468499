//! Generates the systems with the derivatives that steps, regulators and estimators call.

use std::{env, error::Error, fs, path::Path};

use kane_codegen::{
    build_script::Build,
    config::Functions,
    description::{self, Reading, Scalar, no_includes, toml},
    diagnostic::Source,
    generate::generate,
    options::Options,
    output::{self, Overwrite},
};

/// What steps, their derivatives and products with these are made of.
const STEPS: [&str; 4] = [
    "forward_dynamics",
    "forward_dynamics+d(forward_dynamics)/d(q, u, tau)",
    "jvp(forward_dynamics; q, u, tau)",
    "vjp(forward_dynamics; q, u, tau)",
];

/// The same by values set at run time.
const BY_PARAMETERS: [&str; 3] = [
    "d(forward_dynamics)/d(parameters)",
    "jvp(forward_dynamics; q, u, tau, parameters)",
    "vjp(forward_dynamics; q, u, tau, parameters)",
];

/// What steps under loads are made of, and of systems with driven joints; and for tests what these are compared with.
const UNDER_CONDITIONS: [&str; 10] = [
    "loaded_forward_dynamics",
    "loaded_forward_dynamics+d(loaded_forward_dynamics)/d(q, u, tau)",
    "jvp(loaded_forward_dynamics; q, u, tau)",
    "vjp(loaded_forward_dynamics; q, u, tau)",
    "hybrid_dynamics",
    "hybrid_dynamics+d(hybrid_dynamics)/d(q, u, tau)",
    "jvp(hybrid_dynamics; q, u, tau)",
    "vjp(hybrid_dynamics; q, u, tau)",
    "generalized_forces",
    "loaded_inverse_dynamics",
];

/// The other derivatives for which the runtime has traits: for tests.
const OTHERS: [&str; 8] = [
    "d(forward_dynamics)/d(q, u, tau)",
    "d(inverse_dynamics)/d(q, u, u_dot)",
    "inverse_dynamics+d(inverse_dynamics)/d(q, u, u_dot)",
    "d(inverse_dynamics)/d(parameters)",
    "jvp(inverse_dynamics; q, u, u_dot)",
    "jvp(inverse_dynamics; q, u, u_dot, parameters)",
    "vjp(inverse_dynamics; q, u, u_dot)",
    "vjp(inverse_dynamics; q, u, u_dot, parameters)",
];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    let of_steps = STEPS.into_iter().chain(BY_PARAMETERS);
    Build::new("../../models/cart_pole.toml")
        .functions(of_steps.clone().chain(OTHERS))
        .run()?;
    Build::new("models/tumbler.toml")
        .functions(of_steps.chain(UNDER_CONDITIONS))
        .prescribed("tail")
        .run()?;
    // Its derivatives as a whole are ten times as long as their products with a direction.
    Build::new("../../models/eight_body.toml")
        .functions([STEPS[0], STEPS[2], STEPS[3]])
        .run()?;
    panda()
}

/// The arm with a payload in its hand whose mass and mass centre are set at run time: the massless link at the tip becomes
/// that.
#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the output folder of a build script in its environment"
)]
fn panda() -> Result<(), Box<dyn Error>> {
    let urdf = "../../tests/robots/panda/panda.urdf";
    println!("cargo::rerun-if-changed={urdf}");
    let source = Source::new(urdf, fs::read_to_string(urdf)?);
    let mut model = description::read(&source, &Reading::default(), &no_includes);
    for body in &mut model.bodies {
        if let Some(name) = &mut body.name
            && name.value == "panda_hand_tcp"
        {
            "payload".clone_into(&mut name.value);
            let set = [&mut body.mass].into_iter().chain(&mut body.mass_center);
            for number in set.flatten() {
                number.value = Scalar::Runtime(0.0);
            }
        }
    }
    let of_arm = [
        "inverse_dynamics",
        "d(inverse_dynamics)/d(parameters)",
        "pose(payload)",
        "jacobian(payload)",
    ];
    // Tests try products with directions on the others.
    let functions = STEPS[..2].iter().copied().chain(of_arm);
    let options = Options {
        functions: Functions::Named(functions.map(ToOwned::to_owned).collect()),
        ..Options::default()
    };
    let model = Source::new("panda.toml", toml::write(&model)?);
    let generated = generate(&model, "panda.toml", &options, &no_includes)?;
    let path = Path::new(&env::var("OUT_DIR")?).join("panda.rs");
    output::write(&generated.files(&path), Overwrite::Generated)?;
    Ok(())
}
