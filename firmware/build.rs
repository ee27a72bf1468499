//! Generates the Panda and the cart with its derivatives, as a user's build script would, or random trees, and says how a
//! program for a microcontroller is linked.

use std::{env, error::Error, fmt::Write as _, fs, path::Path};

use kane_codegen::build_script::Build;
use kane_test_support::systems::trees;

#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the target and the package's folder in the environment"
)]
fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=FIRMWARE_TREES");
    let trees = env::var("FIRMWARE_TREES").unwrap_or_default();
    let bounds = trees.split_whitespace().map(str::parse);
    generate_trees(&bounds.collect::<Result<Vec<usize>, _>>()?)?;
    Build::new("../tests/robots/panda/panda.urdf")
        .functions([
            "inverse_dynamics",
            "jacobian(panda_hand_tcp)",
            "coriolis_matrix",
            "d(inverse_dynamics)/d(q, u, u_dot)",
            "d(forward_dynamics)/d(q, u, tau)",
            "vjp(forward_dynamics; q, u, tau)",
        ])
        .run()?;
    Build::new("../models/cart_pole.toml")
        .name("cart_pole_steps")
        .functions([
            "forward_dynamics",
            "forward_dynamics+d(forward_dynamics)/d(q, u, tau)",
            "packed(d(forward_dynamics)/d(q, tau))",
            "hessian(inverse_dynamics; q, u)",
        ])
        .run()?;
    if env::var("CARGO_CFG_TARGET_OS")? == "none" {
        println!("cargo::rerun-if-changed=memory.x");
        println!(
            "cargo::rustc-link-search={}",
            env::var("CARGO_MANIFEST_DIR")?
        );
        println!("cargo::rustc-link-arg=-Tlink.x");
        // The relocations show who calls whom, and with that who could panic.
        println!("cargo::rustc-link-arg=--emit-relocs");
    }
    Ok(())
}

/// The trees from one place to before another, in modules, with a macro that calls another one for each; of none a macro
/// that calls nothing.
fn generate_trees(bounds: &[usize]) -> Result<(), Box<dyn Error>> {
    #[expect(
        clippy::disallowed_methods,
        reason = "cargo names the output folder of a build script in its environment"
    )]
    let out = env::var("OUT_DIR")?;
    let [first, end] = bounds.try_into().unwrap_or([0, 0]);
    let (mut modules, mut calls) = (String::new(), String::new());
    for system in trees::first(end as u64).skip(first) {
        let name = &system.name;
        let model = Path::new(&out).join(format!("{name}.toml"));
        fs::write(&model, system.toml())?;
        Build::new(model)
            .functions(["inverse_dynamics", "mass_matrix", "forward_dynamics"])
            .run()?;
        writeln!(
            modules,
            "#[allow(clippy::pedantic, reason = \"generated\")]\n\
             mod {name} {{ include!(concat!(env!(\"OUT_DIR\"), \"/{name}.rs\")); }}"
        )?;
        write!(calls, "$call!({name}); ")?;
    }
    let each = format!("macro_rules! each_tree {{ ($call:ident) => {{ {calls} }}; }}\n");
    fs::write(Path::new(&out).join("trees.rs"), modules + &each)?;
    Ok(())
}
