//! Generates the robots, as a user's build script would.

use kane_codegen::{build_script::Build, description::Base};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    for (name, base) in [
        ("ur5", Base::Fixed),
        ("panda", Base::Fixed),
        ("solo12", Base::Free),
        ("talos", Base::Free),
    ] {
        let build = Build::new(format!("../../../tests/robots/{name}/{name}.urdf"))
            .base(base)
            .functions([
                "inverse_dynamics",
                "mass_matrix",
                "mass_matrix_packed",
                "forward_dynamics",
            ]);
        let build = if cfg!(feature = "fma") {
            build.fma()
        } else {
            build
        };
        build.run()?;
    }
    Ok(())
}
