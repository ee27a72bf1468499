//! Generates the robots from their URDFs, each with a payload in its hand: a mass that is set at run time.

use std::{env, error::Error, fs, path::Path};

use kane_codegen::{
    compile::Options,
    config::Functions,
    description::{self, Reading, Scalar, no_includes, toml},
    diagnostic::Source,
    generate::generate,
    output::{self, Overwrite},
};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    with_payload("ur5", "tool0", &["gravity_forces", "forward_dynamics"])?;
    with_payload(
        "panda",
        "panda_hand_tcp",
        &["inverse_dynamics", "forward_dynamics"],
    )
}

/// The massless link at the tool's tip becomes the payload, a point mass; by hand, `kane convert` and an editor do that. Where
/// nothing is to be changed, `build_script::Build` is all that a build script needs.
#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the output folder of a build script in its environment"
)]
fn with_payload(robot: &str, tip: &str, functions: &[&str]) -> Result<(), Box<dyn Error>> {
    let urdf = format!("../../tests/robots/{robot}/{robot}.urdf");
    println!("cargo::rerun-if-changed={urdf}");
    let source = Source::new(&*urdf, fs::read_to_string(&urdf)?);
    let mut model = description::read(&source, &Reading::default(), &no_includes);
    for body in &mut model.bodies {
        if let (Some(name), Some(mass)) = (&mut body.name, &mut body.mass)
            && name.value == tip
        {
            "payload".clone_into(&mut name.value);
            mass.value = Scalar::Runtime(0.0);
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
