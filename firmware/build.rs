//! Generates the Panda, as a user's build script would, and says how a program for a microcontroller is linked.

use std::env;

use kane_codegen::build_script::Build;

#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the target and the package's folder in the environment"
)]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    Build::new("../tests/robots/panda/panda.urdf")
        .functions(["inverse_dynamics"])
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
