//! What is derived whole, however little of it is written.

use kane_codegen::{
    config::Formulation,
    description::{self, no_includes},
    diagnostic::Source,
    functions::Request,
    generate::{checked, generate},
    options::Options,
};

use crate::sizes::{chain, named};

/// So many hinges, each on the inertial frame.
fn star(n_bodies: usize) -> String {
    let lower: Vec<usize> = (0..n_bodies).collect();
    let text = chain(n_bodies, "[\"theta2\"]", "");
    text.replace(&format!("{lower:?}"), &format!("{:?}", vec![0; n_bodies]))
}

/// All but the first of so many joints of a chain.
fn others(n_bodies: usize) -> Vec<String> {
    (1..n_bodies).map(|number| format!("b{number}")).collect()
}

fn told(text: String, options: &Options) -> Result<(), String> {
    let source = Source::new("model.toml", text);
    let generated = generate(&source, "model.toml", options, &no_includes);
    generated.map(|_| ()).map_err(|error| error.to_string())
}

#[test]
fn whole_matrices_are_told_before_few_of_their_numbers_are_written() {
    for (text, function, why) in [
        (
            chain(300, "[\"theta2\"]", ""),
            "base_parameters",
            "the regressor for `base_parameters` has 900000 numbers; expected at most 250000",
        ),
        (
            star(4000),
            "regressor_packed",
            "the regressor for `regressor_packed` has 160000000 numbers; expected at most 4000000",
        ),
        (
            star(4000),
            "mass_matrix_inverse_packed",
            "the inverse for `mass_matrix_inverse_packed` has 16000000 numbers; expected at most 1000000",
        ),
    ] {
        assert_eq!(told(text, &named(function)), Err(why.to_owned()));
    }
}

#[test]
fn notes_of_prescribed_joints_have_all_terms_of_the_mass_matrix() {
    let options = Options {
        formulation: Formulation::Notes,
        prescribed: others(200),
        ..named("hybrid_dynamics")
    };
    let why = "the notes' sums for `hybrid_dynamics` have 1353400 terms; expected at most 100000";
    let text = chain(200, "[\"theta2\"]", "");
    assert_eq!(told(text, &options), Err(why.to_owned()));
}

#[test]
fn mass_matrices_of_many_prescribed_joints_count_as_work() {
    // Plans are compared by the mass matrix only where that may pay: with one of 1000 speeds it took half a minute.
    let text = chain(1000, "[\"theta2\"]", "");
    let options = Options {
        prescribed: others(1000),
        ..named("hybrid_dynamics")
    };
    let source = Source::new("model.toml", text.clone());
    let description = description::read(&source, &options.reading, &no_includes);
    let tree = checked(&description, &options).unwrap().tree;
    let request = Request::parse("hybrid_dynamics").unwrap();
    assert!(request.factorising(&tree) > 1000 * 1000 / 2);
    assert_eq!(told(text, &options), Ok(()));
}
