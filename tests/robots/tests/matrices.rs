//! Matrices over speeds against Pinocchio's: the inverse of the mass matrix, the Coriolis matrix, the rate of the mass matrix.
//!
//! With `v` for `u = T v` (see [`motion`](crate::common::motion)) the matrices become `M_P^-1 = T^-1 M^-1 T^-T` and
//! `C_P = T^T (C T + M T_dot)`, and `M_dot = C + C^T` holds in both.

use kane::{
    Array, System,
    functions::{
        CoriolisMatrix, MassMatrix, MassMatrixDot, MassMatrixFactors, MassMatrixInverse,
        MassMatrixProduct, MassMatrixSolve, solve_factored,
    },
};
use kane_test_support::{
    compare::{larger, relative, relative_to},
    errors::Errors,
    numeric::{Matrix, condition},
};

use crate::common::{
    motion::{Motion, congruent},
    reference::Reference,
};

/// Sums of some hundred products, rounded to 1e-16 each on both sides.
const EXACT: f64 = 1e-12;

/// The part of the condition number that multiplies it where the mass matrix is solved with.
const PER_CONDITION: f64 = 1e-4;

fn array<A: Array<f64>>(numbers: &[f64]) -> A {
    A::from_fn(|place| numbers[place])
}

fn whole<S: System<f64>>(write: impl FnOnce(&mut S::Matrix)) -> Matrix {
    let mut m = S::Matrix::filled(S::U::filled(f64::NAN));
    write(&mut m);
    let entries = m.as_ref().iter().flat_map(AsRef::as_ref);
    Matrix::new(S::U::LEN, entries.copied().collect())
}

fn sum(a: &Matrix, b: &Matrix) -> Matrix {
    let entries = a.entries.iter().zip(&b.entries).map(|(a, b)| a + b);
    Matrix::new(a.n, entries.collect())
}

fn transposed(m: &Matrix) -> Matrix {
    let entries = (0..m.n * m.n).map(|place| m.at(place % m.n, place / m.n));
    Matrix::new(m.n, entries.collect())
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transposed(b);
    let rows = columns.entries.chunks_exact(b.n);
    let columns: Vec<f64> = rows.flat_map(|column| a.times(column)).collect();
    transposed(&Matrix::new(a.n, columns))
}

fn pinocchio_agrees<S>(name: &str, system: &S)
where
    S: MassMatrix<f64> + MassMatrixInverse<f64> + CoriolisMatrix<f64> + MassMatrixDot<f64>,
{
    let reference = Reference::new(name);
    let mut errors = Errors::default();
    let mut n_coriolis = 0;
    for sample in reference.samples() {
        let v = sample.numbers("v");
        let motion = Motion::new(S::JOINTS, reference.joints(), sample, &v);
        let (q, u): (S::Q, S::U) = (array(&motion.q), array(&motion.u));
        let m = whole::<S>(|m| system.mass_matrix(&q, m));
        let inverse = whole::<S>(|h| {
            system.mass_matrix_inverse(&q, h);
        });
        if let Some(expected) = sample.optional("ddq_dtau") {
            let m_p = motion.pinocchio_mass_matrix(&m);
            let found = congruent(&transposed(&motion.t_inverse), &inverse);
            let tolerance = EXACT * larger(PER_CONDITION * condition(&m_p), 1.0);
            errors.add("ddq_dtau", relative(&found.entries, &expected), tolerance);
        }
        let Some(expected) = sample.optional("coriolis_matrix") else {
            continue;
        };
        n_coriolis += 1;
        let c = whole::<S>(|c| {
            system.coriolis_matrix(&q, &u, c);
        });
        let t_dot = motion.t_dot.as_ref().expect("the base has a quaternion");
        let rest = product(&m, t_dot);
        let moving = product(&transposed(&motion.t), &rest);
        let c_p = sum(&congruent(&motion.t, &c), &moving);
        let error = relative(&c_p.entries, &expected);
        errors.add("coriolis_matrix", error, EXACT);

        let expected = Matrix::new(c.n, expected);
        let m_dot = whole::<S>(|m_dot| {
            system.mass_matrix_dot(&q, &u, m_dot);
        });
        let turning = sum(&moving, &transposed(&moving));
        let found = sum(&congruent(&motion.t, &m_dot), &turning);
        let expected = sum(&expected, &transposed(&expected));
        let error = relative_to(expected.norm(), &found.entries, &expected.entries);
        errors.add("C + C^T", error, EXACT);
    }
    assert!(n_coriolis >= 2, "{n_coriolis}");
    errors.show(name);
}

/// Products, solutions, factors and the inverse say the same.
fn operators_agree<S>(name: &str, system: &S)
where
    S: MassMatrix<f64>
        + MassMatrixInverse<f64>
        + MassMatrixProduct<f64>
        + MassMatrixSolve<f64>
        + MassMatrixFactors<f64>,
{
    let reference = Reference::new(name);
    let mut errors = Errors::default();
    for sample in reference.samples() {
        let motion = Motion::new(S::JOINTS, reference.joints(), sample, &sample.numbers("v"));
        let (q, x): (S::Q, S::U) = (array(&motion.q), array(&motion.u));
        let m = whole::<S>(|m| system.mass_matrix(&q, m));
        let mut tau = S::U::filled(f64::NAN);
        system.mass_matrix_product(&q, &x, &mut tau);
        let error = relative(tau.as_ref(), &m.times(x.as_ref()));
        errors.add("mass_matrix_product", error, EXACT);

        let tolerance = EXACT * larger(PER_CONDITION * condition(&m), 1.0);
        let mut solved = S::U::filled(f64::NAN);
        system.mass_matrix_solve(&q, &tau, &mut solved);
        let error = relative(solved.as_ref(), x.as_ref());
        errors.add("mass_matrix_solve", error, tolerance);

        let mut entries = <S as MassMatrixFactors<f64>>::Entries::filled(f64::NAN);
        system.mass_matrix_factors(&q, &mut entries);
        let mut solved = tau;
        solve_factored(entries.as_ref(), S::PLACES, S::ORDER, solved.as_mut());
        let error = relative(solved.as_ref(), x.as_ref());
        errors.add("solve_factored", error, tolerance);

        let inverse = whole::<S>(|h| {
            system.mass_matrix_inverse(&q, h);
        });
        let error = relative(&inverse.times(tau.as_ref()), x.as_ref());
        errors.add("mass_matrix_inverse", error, tolerance);
    }
    errors.show(name);
}

macro_rules! robots {
    ($($(#[$condition:meta])? $name:ident: $module:ident;)+) => {$(
        $(#[$condition])?
        mod $name {
            use kane_test_robots::$module::Prepared;

            #[test]
            fn matrices_are_those_of_pinocchio() {
                super::pinocchio_agrees(stringify!($name), &Prepared::nominal());
            }

            #[test]
            fn operators_agree() {
                super::operators_agree(stringify!($name), &Prepared::nominal());
            }
        }
    )+};
}

robots! {
    cartpole: cartpole_matrices;
    double_pendulum: double_pendulum_matrices;
    ur5: ur5_matrices;
    panda: panda_matrices;
    solo12: solo12_matrices;
    #[cfg(every_system)]
    talos: talos_matrices;
}
