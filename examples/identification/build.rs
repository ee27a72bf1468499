//! Generates both arms from their URDFs.

use std::error::Error;

use kane_codegen::build_script::Build;

const FUNCTIONS: [&str; 4] = [
    "inertial_parameters",
    "inverse_dynamics",
    "base_regressor",
    "joint_regressor",
];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    for arm in ["ur5", "panda"] {
        let urdf = format!("../../tests/robots/{arm}/{arm}.urdf");
        Build::new(&*urdf).functions(FUNCTIONS).run()?;
    }
    Ok(())
}
