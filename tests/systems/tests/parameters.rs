//! One system three times: every value baked, every value runtime, and baked with other values.
#![allow(
    clippy::print_stdout,
    reason = "the largest errors and the operations found, shown with --nocapture"
)]

use kane::{
    System,
    functions::{
        MassMatrix, PartialAngularVelocity, PartialAngularVelocityDot, PartialVelocity,
        PartialVelocityDot, PartialVelocityOrigin, PartialVelocityOriginDot,
    },
};
use kane_codegen::{
    config::{Formulation, Functions},
    description::no_includes,
    diagnostic::Source,
    generate::generate,
    options::Options,
};
use kane_test_support::{
    compare::{assert_within, relative},
    dynamics::{Model, State, agreement::disagreement, quantities::EXACT},
};
use kane_test_systems::{
    BAKED_RUNTIME_CHANGED, Compiled, RUNTIME_GIVEN_CHANGED, baked, changed_parameters, runtime,
};
use quote::ToTokens;

use crate::common::CompiledModel;

fn assert_agree(a: &CompiledModel, b: &CompiledModel) {
    for seed in 1..=5 {
        let state = State::random(a.tree(), seed);
        let (error, function) = disagreement(a, b, |_| true, &state);
        println!("{error:e} in {function}");
        assert_within(format!("{function}, state of seed {seed}"), error, EXACT);
    }
}

#[test]
fn nominal_runtime_values_are_as_good_as_baked_ones() {
    let [baked, runtime, _] = BAKED_RUNTIME_CHANGED.map(CompiledModel::new);
    assert!(baked.tree().parameters.is_empty() && runtime.tree().parameters.len() > 70);
    assert_agree(&baked, &runtime);
}

#[test]
fn other_runtime_values_are_as_good_as_a_model_with_those_baked() {
    let [baked, runtime, changed] = BAKED_RUNTIME_CHANGED.map(CompiledModel::new);
    let given = runtime.called(RUNTIME_GIVEN_CHANGED);
    assert_agree(&changed, &given);
    let state = State::random(changed.tree(), 1);
    for function in [
        "mass_matrix",
        "bias",
        "forward_dynamics",
        "potential_energy",
    ] {
        let (old, new) = (
            baked.evaluate(function, &state),
            given.evaluate(function, &state),
        );
        let moved = relative(&new, &old);
        assert!(
            moved > 1e-3,
            "{function}: the other values change it by {moved:e} only"
        );
    }
    assert_ne!(changed_parameters::<f64>(), runtime::Parameters::default());
}

/// All arrays of the two systems have the same types.
fn assert_same_types<A, B>()
where
    A: System<f64>
        + MassMatrix<f64>
        + PartialAngularVelocity<f64>
        + PartialAngularVelocityDot<f64>
        + PartialVelocityOrigin<f64>
        + PartialVelocityOriginDot<f64>
        + PartialVelocity<f64>
        + PartialVelocityDot<f64>,
    B: System<
            f64,
            Q = A::Q,
            U = A::U,
            Matrix = A::Matrix,
            Loads = A::Loads,
            Scalars = A::Scalars,
            Vectors = A::Vectors,
            Rotations = A::Rotations,
        > + MassMatrix<f64>
        + PartialAngularVelocity<
            f64,
            PartialAngularVelocityColumns = A::PartialAngularVelocityColumns,
        > + PartialAngularVelocityDot<
            f64,
            PartialAngularVelocityDotColumns = A::PartialAngularVelocityDotColumns,
        > + PartialVelocityOrigin<f64, PartialVelocityOriginColumns = A::PartialVelocityOriginColumns>
        + PartialVelocityOriginDot<
            f64,
            PartialVelocityOriginDotColumns = A::PartialVelocityOriginDotColumns,
        > + PartialVelocity<f64, PartialVelocityColumns = A::PartialVelocityColumns>
        + PartialVelocityDot<f64, PartialVelocityDotColumns = A::PartialVelocityDotColumns>,
{
    assert_eq!(
        A::PARTIAL_ANGULAR_VELOCITY_BLOCKS,
        B::PARTIAL_ANGULAR_VELOCITY_BLOCKS
    );
    assert_eq!(
        A::PARTIAL_ANGULAR_VELOCITY_DOT_BLOCKS,
        B::PARTIAL_ANGULAR_VELOCITY_DOT_BLOCKS
    );
    assert_eq!(
        A::PARTIAL_VELOCITY_ORIGIN_BLOCKS,
        B::PARTIAL_VELOCITY_ORIGIN_BLOCKS
    );
    assert_eq!(
        A::PARTIAL_VELOCITY_ORIGIN_DOT_BLOCKS,
        B::PARTIAL_VELOCITY_ORIGIN_DOT_BLOCKS
    );
    assert_eq!(A::PARTIAL_VELOCITY_BLOCKS, B::PARTIAL_VELOCITY_BLOCKS);
    assert_eq!(
        A::PARTIAL_VELOCITY_DOT_BLOCKS,
        B::PARTIAL_VELOCITY_DOT_BLOCKS
    );
    assert_eq!(A::SPEED_NAMES, B::SPEED_NAMES);
    assert_eq!(A::LOWER_BODIES, B::LOWER_BODIES);
}

#[test]
fn signatures_and_layouts_do_not_depend_on_what_is_baked() {
    assert_eq!(
        (baked::NB, baked::NQ, baked::NU),
        (runtime::NB, runtime::NQ, runtime::NU)
    );
    assert_same_types::<baked::Prepared<f64>, runtime::Prepared<f64>>();
    // All but what says what is set at run time, which model it is, and what functions cost.
    let baked = declared(BAKED_RUNTIME_CHANGED[0]);
    assert!(baked.len() >= 30);
    assert_eq!(baked, declared(BAKED_RUNTIME_CHANGED[1]));
}

/// Constants that differ.
const OWN: [&str; 5] = [
    "PARAMETERS_LEN",
    "PARAMETER_NAMES",
    "FINGERPRINT",
    "OPERATIONS",
    "NAME",
];

/// The signatures of the free functions and the constants with their values, as text.
fn declared(compiled: Compiled) -> Vec<String> {
    let text = generated(compiled).0;
    let file = syn::parse_file(&text).expect("what is generated is Rust");
    let items = file.items.into_iter().filter_map(|item| match item {
        syn::Item::Fn(function) => Some(function.sig.to_token_stream().to_string()),
        syn::Item::Const(constant) if OWN.iter().all(|own| constant.ident != own) => {
            let (name, ty, value) = (&constant.ident, &constant.ty, &constant.expr);
            // Their factors are found numerically, and differ in last digits.
            let value = (name != "BASE_PARAMETER_TERMS").then_some(value);
            Some(quote::quote!(#name: #ty = #value).to_string())
        }
        _ => None,
    });
    items.collect()
}

/// The text, and for each function its operations.
fn generated(compiled: Compiled) -> (String, Vec<(String, usize)>) {
    let options = Options {
        functions: Functions::All(Vec::new()),
        formulation: Formulation::Recursive,
        ..Options::default()
    };
    let model = Source::new(compiled.name, compiled.model);
    let generated =
        generate(&model, compiled.name, &options, &no_includes).expect("it was generated before");
    let counts = generated
        .functions
        .iter()
        .map(|(name, operations)| (name.clone(), operations.total()));
    (generated.source, counts.collect())
}

/// What depends on parameters alone is computed outside; the model has no zeros that baking would fold.
#[test]
fn runtime_values_cost_next_to_nothing_in_the_loop() {
    let [baked, runtime, _] = BAKED_RUNTIME_CHANGED.map(|compiled| generated(compiled).1);
    let (mut all_baked, mut all_runtime) = (0, 0);
    for ((name, baked), (_, runtime)) in baked.into_iter().zip(runtime) {
        println!("{name}: {baked} baked, {runtime} runtime");
        (all_baked, all_runtime) = (all_baked + baked, all_runtime + runtime);
    }
    println!("together: {all_baked} baked, {all_runtime} runtime");
    assert!(
        all_runtime * 100 <= all_baked * 103,
        "{all_runtime} operations, {all_baked} baked"
    );
}
