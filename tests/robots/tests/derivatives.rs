//! Derivatives of the humanoid, whose legs and arms go side by side in helpers of several loops, against differences of what it
//! computes without them.

use kane::{functions::InverseDynamics as _, manifold::q_plus};
use kane_test_robots::{
    talos,
    talos_derivatives::{self as derived, NQ, NU},
};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    random::Random,
};

/// Half the difference of the forces at the two ends of a step along one direction.
fn half_difference(at: impl Fn(f64) -> [f64; NU]) -> [f64; NU] {
    let [before, after] = [-1.0, 1.0].map(at);
    std::array::from_fn(|row| (after[row] - before[row]) / 2.0)
}

#[test]
fn loops_of_the_humanoids_helpers_compute_what_differences_do() {
    let p = derived::Prepared::<f64>::nominal();
    let values = talos::Prepared::<f64>::nominal();
    let mut random = Random::new(11);
    let mut drawn = || -> [f64; NU] { std::array::from_fn(|_| random.symmetric()) };
    for _ in 0..3 {
        let mut q = [0.0; NQ];
        q[0] = 1.0;
        let q = q_plus(&values, &q, &drawn());
        let [u, u_dot] = [drawn(), drawn()];
        let tau = |q: &[f64; NQ], u: &[f64; NU], u_dot: &[f64; NU]| {
            let mut tau = [0.0; NU];
            values.inverse_dynamics(q, u, u_dot, &mut tau);
            tau
        };
        let [mut by_q, mut by_u, mut by_u_dot] = [[[0.0; NU]; NU]; 3];
        derived::d_inverse_dynamics_d_q_u_u_dot(
            &p,
            &q,
            &u,
            &u_dot,
            &mut by_q,
            &mut by_u,
            &mut by_u_dot,
        );
        let [mut expected_q, mut expected_u, mut expected_u_dot] = [[[0.0; NU]; NU]; 3];
        for column in 0..NU {
            let along = |size: f64| {
                let mut direction = [0.0; NU];
                direction[column] = size;
                direction
            };
            let plus = |v: &[f64; NU], size: f64| {
                let mut moved = *v;
                moved[column] += size;
                moved
            };
            // Forces are of second degree in speeds and of first in accelerations, of which a difference is the derivative.
            let of_u = half_difference(|side| tau(&q, &plus(&u, side), &u_dot));
            let of_u_dot = half_difference(|side| tau(&q, &u, &plus(&u_dot, side)));
            let step = 1e-3;
            let of_q = |size: f64| {
                half_difference(|side| tau(&q_plus(&values, &q, &along(side * size)), &u, &u_dot))
            };
            let [near, far] = [of_q(step), of_q(2.0 * step)];
            for row in 0..NU {
                expected_u[row][column] = of_u[row];
                expected_u_dot[row][column] = of_u_dot[row];
                expected_q[row][column] = (8.0 * near[row] - far[row]) / (6.0 * step);
            }
        }
        // Of the largest entry: differences of the fourth order with steps of 1e-3 leave 1e-12, rounding a few 1e-14.
        for (name, found, expected, tolerance) in [
            ("dtau_dq", by_q, expected_q, 1e-11),
            ("dtau_du", by_u, expected_u, 1e-13),
            ("dtau_du_dot", by_u_dot, expected_u_dot, 1e-13),
        ] {
            let [found, expected] = [&found, &expected].map(|matrix| matrix.as_flattened());
            assert_close(name, found, expected, Tolerance::relative(tolerance));
        }
    }
}
