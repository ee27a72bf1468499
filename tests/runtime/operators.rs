//! Solutions with the mass matrix: several right-hand sides at once in lanes, and with its factors.

use kane::eight_body::{
    MASS_MATRIX_FACTORS_LEN, MASS_MATRIX_FACTORS_ORDER, MASS_MATRIX_FACTORS_PLACES, NQ, NU,
    Prepared,
};
use kane::functions::{MassMatrixFactors, MassMatrixProduct, MassMatrixSolve, solve_factored};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    random::Random,
};

/// Relative to a solution's largest entry: the condition number of some hundred multiplies rounding.
const SOLUTION: Tolerance = Tolerance::relative(1e-11);

#[cfg(feature = "wide")]
#[test]
fn each_lane_has_a_right_hand_side_of_its_own() {
    use kane::{Lanes, Real, wide::f64x4};
    let mut random = Random::new(11);
    let q = [(); NQ].map(|()| random.between(-1.0, 1.0));
    let forces = [(); f64x4::LANES].map(|()| [(); NU].map(|()| random.symmetric()));
    let tau = std::array::from_fn(|speed| f64x4::load(&forces.map(|force| force[speed])));
    let mut found = [f64x4::from_f64(f64::NAN); NU];
    Prepared::<f64x4>::nominal().mass_matrix_solve(&q.map(f64x4::from_f64), &tau, &mut found);
    for (lane, force) in forces.iter().enumerate() {
        let mut expected = [f64::NAN; NU];
        Prepared::<f64>::nominal().mass_matrix_solve(&q, force, &mut expected);
        let own = found.map(|entry| {
            let mut numbers = [f64::NAN; f64x4::LANES];
            entry.store(&mut numbers);
            numbers[lane]
        });
        // In the same order, to the last bit.
        assert_eq!(own, expected, "lane {lane}");
    }
}

#[test]
fn factors_solve() {
    let system = Prepared::<f64>::nominal();
    let mut random = Random::new(12);
    for _ in 0..5 {
        let q = [(); NQ].map(|()| random.between(-1.0, 1.0));
        let x = [(); NU].map(|()| random.symmetric());
        let mut b = [f64::NAN; NU];
        system.mass_matrix_product(&q, &x, &mut b);
        let mut entries = [f64::NAN; MASS_MATRIX_FACTORS_LEN];
        system.mass_matrix_factors(&q, &mut entries);
        solve_factored(
            &entries,
            MASS_MATRIX_FACTORS_PLACES,
            &MASS_MATRIX_FACTORS_ORDER,
            &mut b,
        );
        assert_close("x", &b, &x, SOLUTION);
    }
}

#[test]
fn what_the_lists_lack_is_no_panic() {
    let mut b = [1.0, 2.0];
    solve_factored::<f64>(&[], &[[0, 0], [7, 9]], &[1, 5, 0], &mut b);
    assert_eq!(b, [1.0, 2.0]);
}
