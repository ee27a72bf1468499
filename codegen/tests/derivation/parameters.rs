//! Values of parameters beside the nominal ones.

use kane_codegen::drawn::parameters::{changed, is_real, nominal};
use kane_codegen::tree::Tree;
use kane_test_support::models;

/// A body of which much is a parameter, and much zero.
fn tree(inertia: &str) -> Tree {
    let text = format!(
        "name = \"one\"\n\
         gravity = [{{ runtime = 0.0 }}, 0.0, {{ runtime = -9.81 }}]\n\
         lower_bodies = [0]\n\
         [[body]]\n\
         name = \"one\"\n\
         mass = {{ runtime = 2.0 }}\n\
         mass_center = [{{ runtime = 0.0 }}, 0.0, {{ runtime = -0.5 }}]\n\
         inertia = {{ {inertia} }}\n\
         attachment = [0.0, 0.0, 0.0]\n\
         joint = [\"theta1\", \"s2\"]\n"
    );
    models::build(&text).expect("a sound description").tree
}

const ALL: &str = "xx = { runtime = 0.0 }, yy = { runtime = 0.3 }, zz = { runtime = 0.3 }, \
                   xy = { runtime = 0.0 }, xz = { runtime = 0.0 }, yz = { runtime = 0.0 }";

/// The components of the only part, xx first, with these values of the parameters.
fn inertia(tree: &Tree, values: &[f64]) -> [f64; 6] {
    let mut given = tree.clone();
    for (parameter, &value) in given.parameters.iter_mut().zip(values) {
        parameter.nominal = value;
    }
    let of = &given.bodies[0].parts[0].inertia;
    [of.xx, of.yy, of.zz, of.xy, of.xz, of.yz].map(|component| given.nominal(component))
}

#[test]
fn no_changed_value_is_zero_or_its_nominal_one() {
    let tree = tree(ALL);
    for seed in 1..100 {
        for (changed, nominal) in changed(&tree, seed).into_iter().zip(nominal(&tree)) {
            assert!(changed != 0.0, "zero for {nominal}");
            assert!((changed - nominal).abs() > 1e-4, "{changed} for {nominal}");
        }
    }
}

#[test]
fn value_that_f64_cannot_hold_changed_stays_the_nominal_one() {
    let mut tree = tree(ALL);
    let largest = tree.parameters.iter().position(|one| one.unit == "kg");
    let largest = largest.expect("a mass");
    tree.parameters[largest].nominal = 1.75e308;
    assert_eq!(changed(&tree, 1)[largest], 1.75e308);
}

#[test]
fn changed_inertias_are_those_of_real_bodies() {
    let rod =
        "xx = 0.0, yy = { runtime = 0.3 }, zz = { runtime = 0.3 }, xy = 0.0, xz = 0.0, yz = 0.0";
    let plate =
        "xx = 0.2, yy = 0.104, zz = 0.1, xy = { runtime = 0.0 }, xz = 0.0, yz = { runtime = 0.02 }";
    for tree in [ALL, rod, plate].map(tree) {
        for seed in 1..100 {
            let tensor = inertia(&tree, &changed(&tree, seed));
            assert!(is_real(tensor), "seed {seed}: {tensor:?}");
        }
    }
}

#[test]
fn what_no_real_body_has_is_told() {
    assert!(is_real([0.0, 0.3, 0.3, 0.0, 0.0, 0.0]));
    assert!(!is_real([0.0, 0.3, 0.4, 0.0, 0.0, 0.0]));
    assert!(!is_real([0.1, 0.3, 0.3, 0.2, 0.0, 0.0]));
}
