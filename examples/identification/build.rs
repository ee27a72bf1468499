//! Generates both arms from their URDFs, and writes down what these say of each link's mass: a generated module has
//! no such table.

use std::{env, error::Error, fmt::Write as _, fs, path::Path};

use kane_codegen::{
    build_script::Build,
    description::{self, Reading, Scalar, no_includes},
    diagnostic::{Source, Spanned},
};

const UNTURNED: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

const FUNCTIONS: [&str; 3] = ["inverse_dynamics", "base_regressor", "joint_regressor"];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    for arm in ["ur5", "panda"] {
        let urdf = format!("../../tests/robots/{arm}/{arm}.urdf");
        Build::new(&*urdf).functions(FUNCTIONS).run()?;
        links(arm, &urdf)?;
    }
    Ok(())
}

/// Writes the links of an arm with what a URDF says of their mass, `ur5_links.rs` for `ur5.urdf`.
#[expect(
    clippy::disallowed_methods,
    reason = "cargo names the output folder of a build script in its environment"
)]
fn links(arm: &str, urdf: &str) -> Result<(), Box<dyn Error>> {
    let source = Source::new(urdf, fs::read_to_string(urdf)?);
    let model = description::read(&source, &Reading::default(), &no_includes);
    let mut text = String::from("&[\n");
    for body in &model.bodies {
        let name = &body.name.as_ref().ok_or("a link has a name")?.value;
        let turned = body.inertia_rotation.as_ref();
        if turned.is_some_and(|rotation| rotation.value != UNTURNED) {
            return Err(format!("the inertia of {name} is not along its own axes").into());
        }
        let number = |given: &Option<Spanned<Scalar>>| {
            given.as_ref().map_or(0.0, |given| given.value.nominal())
        };
        let mass = number(&body.mass);
        let center = body.mass_center.each_ref().map(number);
        let inertia = body.inertia.each_ref().map(number);
        writeln!(
            text,
            "Link {{ name: {name:?}, mass: {mass:?}, mass_center: {center:?}, inertia: {inertia:?} }},"
        )?;
    }
    text.push(']');
    let path = Path::new(&env::var("OUT_DIR")?).join(format!("{arm}_links.rs"));
    fs::write(path, text)?;
    Ok(())
}
