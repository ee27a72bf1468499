//! Functions of thousands of values, which compilers have to bear.

use std::collections::BTreeSet;

use kane_codegen::{
    description::{Base, Reading},
    diagnostic::Source,
    options::Options,
};

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

/// The rows of numbers that a loop over columns reads and writes.
fn rows(body: &str) -> BTreeSet<String> {
    let places = body.match_indices("[lane]").map(|(end, _)| {
        let start = body[..end].rfind([' ', '(', '-']).map_or(0, |at| at + 1);
        body[start..end].to_owned()
    });
    places.collect()
}

#[test]
fn loops_over_columns_read_and_write_no_more_rows_than_a_compiler_takes() {
    let options = Options {
        functions: named(&["regressor_packed", "d(inverse_dynamics)/d(q, u, u_dot)"]),
        reading: Reading {
            base: Some(Base::Free),
            ..Reading::default()
        },
        ..Options::default()
    };
    let talos = include_str!("../../../tests/robots/talos/talos.urdf");
    let source = Source::new("talos.urdf", talos);
    let text = generate(&source, "talos.urdf", &options).unwrap().source;
    let helpers = text.split("\nfn ").skip(1);
    let helpers = helpers.filter(|own| own.split('<').next().unwrap().contains("_lockstep_"));
    let mut most_loops = 0;
    for helper in helpers {
        let helper = helper.split_once("\n}\n").unwrap().0;
        let loops: Vec<_> = helper
            .split("\n    for (lane, _) in ")
            .skip(1)
            .map(rows)
            .collect();
        for rows in &loops {
            assert!((1..=240).contains(&rows.len()), "{} rows", rows.len());
        }
        most_loops = most_loops.max(loops.len());
    }
    assert!(most_loops > 2, "some go through much");
}
