//! The tests beside a module pass for it, and fail for every module with one token changed that changes a value.

use kane::self_test::Mismatch;

type Tests = &'static [(&'static str, fn() -> Result<(), Mismatch>)];

/// The names of the tests that fail.
fn failing(tests: Tests) -> Vec<&'static str> {
    let failing = tests.iter().filter(|(_, test)| test().is_err());
    failing.map(|(name, _)| *name).collect()
}

macro_rules! modules {
    ($($module:ident, $harmless:literal: $($mutant:ident)+;)+) => {$(
        #[test]
        fn $module() {
            use kane_test_mutations::$module;
            assert_eq!(failing($module::tests::ALL), [""; 0], "the module as it is");
            let mutants = [$((
                stringify!($mutant),
                failing(kane_test_mutations::$mutant::tests::ALL),
            )),+];
            let missed: Vec<_> = mutants.iter().filter(|(_, failing)| failing.is_empty()).collect();
            for (mutant, failing) in &mutants {
                println!("{mutant}: {}", failing.join(", "));
            }
            assert!(missed.len() <= $harmless, "not caught: {missed:?}");
        }
    )+};
}

modules! {
    cart_pole, 0: cart_pole_0 cart_pole_1 cart_pole_2 cart_pole_3 cart_pole_4 cart_pole_5 cart_pole_6 cart_pole_7 cart_pole_8 cart_pole_9;
    double_pendulum, 0: double_pendulum_0 double_pendulum_1 double_pendulum_2 double_pendulum_3 double_pendulum_4
        double_pendulum_5 double_pendulum_6 double_pendulum_7 double_pendulum_8 double_pendulum_9;
    ur5, 0: ur5_0 ur5_1 ur5_2 ur5_3 ur5_4 ur5_5 ur5_6 ur5_7 ur5_8 ur5_9;
    // Nothing is left of a free body once its speeds are eliminated: pivots add products that are zero, whatever their sign.
    eight_body, 2: eight_body_0 eight_body_1 eight_body_2 eight_body_3 eight_body_4 eight_body_5 eight_body_6 eight_body_7
        eight_body_8 eight_body_9;
    panda, 0: panda_0 panda_1 panda_2 panda_3 panda_4 panda_5 panda_6 panda_7 panda_8 panda_9;
}
