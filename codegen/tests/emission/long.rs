//! Functions of thousands of values, which compilers have to bear.

use kane_codegen::{compile::Options, diagnostic::Source};

use crate::module::{generate, hinges, named};

#[test]
fn functions_of_many_angles_declare_their_values_by_few_lets() {
    for n_bodies in [500, 700, 2000] {
        let options = Options {
            functions: named(&["relative_rotation"]),
            ..Options::default()
        };
        let source = Source::new("chain.toml", hinges(n_bodies));
        let text = generate(&source, "chain.toml", &options).unwrap().source;
        for line in text
            .lines()
            .filter_map(|line| line.trim().strip_suffix(','))
        {
            let is_own = line
                .split_once(": ")
                .is_some_and(|(name, value)| name == value);
            assert!(!is_own, "{line} has a shorter form");
        }
        // The function, or its stages.
        let functions = text.split("\nfn relative_rotation_stage_").skip(1);
        let whole = text.split("\npub fn relative_rotation<").skip(1);
        let functions = functions.chain(whole);
        let functions: Vec<&str> = functions
            .map(|text| text.split_once("\n}\n").unwrap().0)
            .collect();
        for function in &functions {
            // The stack of rustc ends after two or three thousand of them in debug builds.
            let n_lets = function.matches("\n    let ").count();
            assert!(n_lets <= 1_800, "{n_lets} of {n_bodies} bodies");
        }
        let function = functions.concat();
        let assigned = function.lines().filter_map(|line| {
            let (name, _) = line.trim().split_once(" = ")?;
            Some(name.strip_prefix("let ").unwrap_or(name).to_owned())
        });
        let mut values: Vec<String> = assigned.filter(|name| name.starts_with('b')).collect();
        values.sort();
        // A stage names again what it reads of an earlier one.
        values.dedup();
        let expected = (1..=n_bodies)
            .flat_map(|body| ["theta3", "sin3", "cos3"].map(|value| format!("b{body}_{value}")));
        let mut expected: Vec<String> = expected.collect();
        expected.sort();
        assert_eq!(values, expected);
        assert_eq!(
            function.matches("R::sin_cos_array(").count(),
            n_bodies.div_ceil(64)
        );
    }
}
