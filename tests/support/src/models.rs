//! Descriptions of which a test says only what matters to it.

use kane_codegen::description::toml;
use kane_codegen::diagnostic::{Diagnostics, Source};
use kane_codegen::tree::{self, Checked};

/// Reads and builds.
///
/// # Errors
/// What is wrong with the text.
pub fn build(text: &str) -> Result<Checked, Diagnostics> {
    tree::build(&toml::parse(&Source::new("model.toml", text)))
}

/// The keys of a body of which nothing matters but its name and its joint.
pub fn body(name: &str, joint: &str) -> String {
    format!(
        "[[body]]
name = \"{name}\"
mass = 2.0
mass_center = [0.01, 0.02, -0.5]
inertia = {{ xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01, xz = 0.0, yz = 0.0 }}
attachment = [0.0, 0.1, 0.3]
joint = {joint}
"
    )
}

/// A system of such bodies.
pub fn system(lower_bodies: &str, bodies: &[(&str, &str)]) -> String {
    let bodies: Vec<String> = bodies
        .iter()
        .map(|(name, joint)| body(name, joint))
        .collect();
    format!(
        "name = \"system\"\nlower_bodies = {lower_bodies}\ngravity = [0, 0, 0]\n{}",
        bodies.join("\n")
    )
}

/// The same model with every mass, inertia and attachment of its bodies a parameter, number by number.
pub fn at_run_time(text: &str) -> String {
    let keys = ["mass", "inertia", "attachment"];
    let line = |line: &str| {
        if !keys.iter().any(|key| line.starts_with(key)) {
            return line.to_owned();
        }
        let words = line.split_inclusive([' ', ',', ']']).map(|word| {
            let number = word
                .trim_start_matches('[')
                .trim_end_matches([' ', ',', ']']);
            let is_number = number.parse::<f64>().is_ok();
            if is_number {
                word.replace(number, &format!("{{ runtime = {number} }}"))
            } else {
                word.to_owned()
            }
        });
        words.collect()
    };
    let lines: Vec<String> = text.lines().map(line).collect();
    lines.join("\n") + "\n"
}
