//! Fused multiply-add: the bits of the functions without it where the hardware does not fuse, and nearly those elsewhere.

use crate::common::robot;
use kane_test_robots::{Dynamics, MakeDynamics, PANDA_FUSED, SOLO12_FUSED};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    random::Random,
};

/// Where the hardware fuses, relative to a quantity's largest entry: one rounding of 1e-16 less in each of some hundred
/// operations, and for a solution the condition number of the mass matrix, below 1e5.
const TOLERANCE: f64 = 1e-10;
/// Whether `kane::Real::mul_add` rounds once.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

fn check(name: &str, fused: MakeDynamics) {
    let (plain, fused) = ((robot(name).plain)(), fused());
    let n_speeds = plain.limits().effort.len();
    let n_coordinates = plain.coordinate_names().len();
    let mut random = Random::new(6);
    for state in 0..20 {
        let q = plain.normalize(&random.numbers(n_coordinates));
        let [u, third] = [(); 2].map(|()| random.numbers(n_speeds));
        let of = |robot: &dyn Dynamics| {
            [
                robot.mass_matrix(&q),
                robot.bias(&q, &u),
                robot.inverse_dynamics(&q, &u, &third),
                robot.forward_dynamics(&q, &u, &third),
            ]
        };
        let (plain, fused) = (of(&*plain), of(&*fused));
        for (plain, fused) in plain.iter().zip(&fused) {
            let tolerance = Tolerance::relative(if FUSED { TOLERANCE } else { 0.0 });
            assert_close(format!("{name}, state {state}"), fused, plain, tolerance);
        }
    }
}

#[test]
fn fused_panda_is_the_panda() {
    check("panda", PANDA_FUSED);
}

#[test]
fn fused_solo12_is_solo12() {
    check("solo12", SOLO12_FUSED);
}
