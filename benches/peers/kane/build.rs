//! Generates the robots, as a user's build script would.

use kane_codegen::{build_script::Build, description::Base};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    for (name, base, link) in [
        ("ur5", Base::Fixed, "wrist_3_link"),
        ("panda", Base::Fixed, "panda_link7"),
        ("solo12", Base::Free, "FL_LOWER_LEG"),
        ("talos", Base::Free, "arm_left_7_link"),
    ] {
        let jacobian = format!("jacobian({link})");
        let jacobian_packed = format!("jacobian_packed({link})");
        let build = Build::new(format!("../../../tests/robots/{name}/{name}.urdf"))
            .base(base)
            .functions([
                "inverse_dynamics",
                "mass_matrix",
                "mass_matrix_packed",
                "forward_dynamics",
                &jacobian,
                &jacobian_packed,
                "coriolis_matrix",
                "mass_matrix_inverse",
                "mass_matrix_inverse_packed",
                "regressor",
                "regressor_packed",
                "d(inverse_dynamics)/d(q, u, u_dot)",
                "d(forward_dynamics)/d(q, u, tau)",
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
