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
fn branches_may_be_eliminated_in_any_order() {
    // Two branches with three speeds each.
    let places = [0, 3].map(|root| {
        let own = [[0, 0], [1, 0], [1, 1], [2, 0], [2, 1], [2, 2]];
        own.map(|place| place.map(|speed| root + speed))
    });
    let mut random = Random::new(13);
    let entries = [(); 12].map(|()| random.between(0.5, 2.0));
    let b = [(); 6].map(|()| random.symmetric());
    let solved = |order: [usize; 6]| {
        let mut x = b;
        solve_factored(&entries, places.as_flattened(), &order, &mut x);
        x
    };
    let by_rows = solved([5, 4, 3, 2, 1, 0]);
    for order in [[2, 1, 0, 5, 4, 3], [2, 5, 1, 4, 0, 3]] {
        assert_eq!(solved(order), by_rows, "{order:?}");
    }
    // `L^T D L` times the solution.
    for (root, own) in [0, 3].into_iter().zip(entries.chunks(6)) {
        let &[d0, l10, d1, l20, l21, d2] = own else {
            unreachable!("a branch has six entries");
        };
        let x = &by_rows[root..root + 3];
        let [y0, y1, y2] = [
            d0 * x[0],
            d1 * (l10 * x[0] + x[1]),
            d2 * (l20 * x[0] + l21 * x[1] + x[2]),
        ];
        let found = [y0 + l10 * y1 + l20 * y2, y1 + l21 * y2, y2];
        assert_close("b", &found, &b[root..root + 3], SOLUTION);
    }
}

#[test]
fn what_the_lists_lack_is_no_panic() {
    for order in [&[1, 5, 0][..], &[1, 0]] {
        let mut b = [1.0, 2.0];
        solve_factored::<f64>(&[], &[[0, 0], [7, 9]], order, &mut b);
        assert_eq!(b, [1.0, 2.0]);
        solve_factored(&[2.0, 3.0], &[[0, 0], [7, 9]], order, &mut b);
        assert_eq!(b, [0.5, 2.0]);
    }
    // Entries that end within a row: its pivot is missing.
    let places = [[0, 0], [1, 0], [1, 1], [2, 2]];
    for order in [[2, 1, 0], [1, 2, 0]] {
        let mut b = [1.0, 2.0, 3.0];
        solve_factored(&[2.0, 0.5], &places, &order, &mut b);
        assert_eq!(b, [0.0, 2.0, 3.0], "{order:?}");
    }
}
