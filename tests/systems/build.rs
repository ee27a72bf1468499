//! Generates the systems of this package, as a user's build script would: the references, and random ones.

use std::{env, error::Error, fs, path::Path, time::SystemTime};

use kane_codegen::{build_script::Build, config::Formulation, functions::CATALOGUE};

use kane_test_support::systems::{RandomSystem, Sizes, Style, tree, trees};

/// The systems with reference values that `kane` does not bundle.
const REFERENCES: [&str; 5] = ["one_body", "chain3", "star5", "two_roots", "tree12"];

/// Bodies and the most speeds of the random systems; the seed is 100 and the place in this list.
const RANDOM: [(usize, usize); 8] = [
    (2, 6),
    (3, 8),
    (4, 12),
    (6, 12),
    (5, 16),
    (7, 18),
    (9, 20),
    (12, 24),
];

/// As [`RANDOM`], with joints of every kind, of which every other one is prescribed; the seed is 500 and the place in this list.
const FRAMED: [(usize, usize); 3] = [(4, 8), (6, 10), (7, 10)];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    trees::announce_all_seeds();
    for name in REFERENCES.into_iter().filter(|name| is_compiled(name)) {
        let model = format!("../reference/{name}.toml");
        let functions = CATALOGUE.iter().map(|function| function.name);
        Build::new(&model)
            .functions(functions.filter(|name| !FURTHER.contains(name)))
            .formulation(Formulation::Recursive)
            .run()?;
        in_notes(&model, name, &FURTHER)?;
    }
    in_notes("../../models/eight_body.toml", "eight_body", &FURTHER)?;

    for (seed, (bodies, speeds)) in (100..).zip(RANDOM) {
        let system = RandomSystem::new(seed, Sizes { bodies, speeds }, Style::Plain);
        if !is_compiled(&system.name) {
            continue;
        }
        all(&written(&system)?, Formulation::Cheapest)?;
    }
    for (seed, (bodies, speeds)) in (500..).zip(FRAMED) {
        let system = RandomSystem::new(seed, Sizes { bodies, speeds }, Style::Framed);
        prescribed(&system)?;
    }
    // One system in other numbers, in both orders.
    let system = RandomSystem::new(
        200,
        Sizes {
            bodies: 5,
            speeds: 12,
        },
        Style::Plain,
    );
    all(
        &written(&system.ordered("body").named("body_order"))?,
        Formulation::Cheapest,
    )?;
    all(
        &written(&system.ordered("notes").named("notes_order"))?,
        Formulation::Cheapest,
    )?;
    let renumbered = system.ordered("body").renumbered(1);
    all(
        &written(&renumbered.named("renumbered"))?,
        Formulation::Cheapest,
    )?;
    notes(&written(&renumbered.named("renumbered"))?, "renumbered")?;
    // One system with every value baked or none, and with other values.
    let system = RandomSystem::new(
        300,
        Sizes {
            bodies: 6,
            speeds: 14,
        },
        Style::Plain,
    )
    .without_zeros();
    let changed = system.changed(1);
    all(
        &written(&system.with_runtime(false).named("baked"))?,
        Formulation::Recursive,
    )?;
    all(
        &written(&system.with_runtime(true).named("runtime"))?,
        Formulation::Recursive,
    )?;
    all(
        &written(&changed.with_runtime(false).named("changed"))?,
        Formulation::Recursive,
    )?;
    parameters(&changed.with_runtime(true))
}

/// The systems that take a third of the compiler's time.
const LARGE: [&str; 3] = ["tree12", "random_105", "random_107"];

fn is_compiled(name: &str) -> bool {
    trees::all_seeds() || !LARGE.contains(&name)
}

/// Every function.
fn all(model: &str, formulation: Formulation) -> Result<(), Box<dyn Error>> {
    Build::new(model)
        .functions(["all"])
        .formulation(formulation)
        .run()?;
    Ok(())
}

/// Every function; of the joints with speeds of their own the first, the third and so on are prescribed.
fn prescribed(system: &RandomSystem) -> Result<(), Box<dyn Error>> {
    let tree = tree(&system.toml()).ok_or("a random system is refused")?;
    let moving = tree.bodies.iter();
    let moving = moving.filter(|body| !body.joint.speeds().is_empty());
    let build = Build::new(written(system)?).functions(["all"]);
    let build = moving
        .step_by(2)
        .fold(build, |build, body| build.prescribed(&body.name));
    build.run()?;
    Ok(())
}

/// What references are without, for the seconds of the compiler.
const FURTHER: [&str; 25] = [
    "mass_matrix_product",
    "mass_matrix_solve",
    "mass_matrix_inverse",
    "mass_matrix_inverse_packed",
    "mass_matrix_factors",
    "coriolis_matrix",
    "mass_matrix_dot",
    "loaded_inverse_dynamics",
    "loaded_forward_dynamics",
    "kinetic_energies",
    "potential_energies",
    "joint_wrenches",
    "hybrid_dynamics",
    "center_of_mass",
    "center_of_mass_velocity",
    "center_of_mass_jacobian",
    "center_of_mass_jacobian_dot_u",
    "centroidal_momentum_matrix",
    "centroidal_momentum_matrix_dot_u",
    "inertial_parameters",
    "base_parameters",
    "regressor",
    "regressor_packed",
    "base_regressor",
    "joint_regressor",
];

/// The functions that have two formulations, in the notes' own.
fn notes(model: &str, name: &str) -> Result<(), Box<dyn Error>> {
    in_notes(model, name, &[])
}

/// The same but for some.
fn in_notes(model: &str, name: &str, without: &[&str]) -> Result<(), Box<dyn Error>> {
    let both = CATALOGUE
        .iter()
        .filter(|function| function.formulations().len() > 1 && !without.contains(&function.name));
    Build::new(model)
        .functions(both.map(|function| function.name))
        .formulation(Formulation::Notes)
        .name(format!("{name}_notes"))
        .run()?;
    Ok(())
}

/// Writes a description into `OUT_DIR`.
fn written(system: &RandomSystem) -> Result<String, Box<dyn Error>> {
    write(&format!("{}.toml", system.name), &system.toml())
}

/// Writes the nominal values of a system as an expression.
fn parameters(system: &RandomSystem) -> Result<(), Box<dyn Error>> {
    let tree = tree(&system.toml()).ok_or("changed values are refused")?;
    let fields = tree.parameters.iter().map(|parameter| {
        format!(
            "    {}: R::from_f64({:?}),\n",
            parameter.name, parameter.nominal
        )
    });
    write(
        "changed_parameters.rs",
        &format!("Parameters {{\n{}}}\n", fields.collect::<String>()),
    )?;
    Ok(())
}

fn write(name: &str, text: &str) -> Result<String, Box<dyn Error>> {
    #[expect(
        clippy::disallowed_methods,
        reason = "cargo names the output folder of a build script in its environment"
    )]
    let folder = env::var("OUT_DIR")?;
    let path = Path::new(&folder).join(name);
    fs::write(&path, text)?;
    // A file younger than the script's run would make cargo run it again, every time.
    fs::File::options()
        .write(true)
        .open(&path)?
        .set_modified(SystemTime::UNIX_EPOCH)?;
    Ok(path
        .to_str()
        .ok_or("the output folder is not Unicode")?
        .to_owned())
}
