//! Lanes: batches of every robot have the bits of each state alone.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use kane::{
    Array, Lanes, Real,
    batch::Batch,
    functions::{Bias, ForwardDynamics, InverseDynamics, MassMatrix},
    wide::{f32x4, f64x8},
};
use kane_test_support::random::Random;

/// The four dynamics functions of a batch, row by row, against those of each state.
fn check<L, S, O>(lanes: &S, single: &O)
where
    L: Lanes,
    L::Scalar: PartialEq,
    S: MassMatrix<L> + Bias<L> + InverseDynamics<L> + ForwardDynamics<L>,
    O: MassMatrix<L::Scalar>
        + Bias<L::Scalar>
        + InverseDynamics<L::Scalar>
        + ForwardDynamics<L::Scalar>,
{
    let n = L::LANES + 3;
    let zero = L::Scalar::from_f64(0.0);
    let mut random = Random::new(7);
    let mut rows = |rows: usize| -> Vec<L::Scalar> {
        let numbers = random.numbers(rows * n).into_iter();
        numbers.map(L::Scalar::from_f64).collect()
    };
    let n_speeds = S::U::LEN;
    let (q, u, third) = (rows(S::Q::LEN), rows(n_speeds), rows(n_speeds));
    let [mut bias, mut tau, mut u_dot] = [(); 3].map(|()| vec![zero; n_speeds * n]);
    let mut m = vec![zero; n_speeds * n_speeds * n];
    let batch = Batch::<L>::new(n);
    batch.bias(lanes, &q, &u, &mut bias).unwrap();
    batch
        .inverse_dynamics(lanes, &q, &u, &third, &mut tau)
        .unwrap();
    batch
        .forward_dynamics(lanes, &q, &u, &third, &mut u_dot)
        .unwrap();
    batch.mass_matrix(lanes, &q, &mut m).unwrap();

    for state in 0..n {
        let column = |rows: &[L::Scalar]| -> Vec<L::Scalar> {
            rows.iter().skip(state).step_by(n).copied().collect()
        };
        let speeds = |rows: &[L::Scalar]| O::U::from_fn(|speed| column(rows)[speed]);
        let one_q = column(&q);
        let q = O::Q::from_fn(|place| one_q[place]);
        let [u, third] = [&u, &third].map(|rows| speeds(rows));
        let mut out = O::U::filled(zero);
        single.bias(&q, &u, &mut out);
        assert!(column(&bias) == out.as_ref(), "bias of state {state}");
        single.inverse_dynamics(&q, &u, &third, &mut out);
        assert!(
            column(&tau) == out.as_ref(),
            "inverse dynamics of state {state}"
        );
        single.forward_dynamics(&q, &u, &third, &mut out);
        assert!(
            column(&u_dot) == out.as_ref(),
            "forward dynamics of state {state}"
        );
        let mut matrix = O::Matrix::filled(out);
        single.mass_matrix(&q, &mut matrix);
        let entries: Vec<L::Scalar> = matrix
            .as_ref()
            .iter()
            .flat_map(AsRef::as_ref)
            .copied()
            .collect();
        assert!(column(&m) == entries, "mass matrix of state {state}");
    }
}

/// Without optimization each of thousands of vectors has places of its own on the stack, more than a test's has.
fn with_a_large_stack(test: fn()) {
    let thread = std::thread::Builder::new().stack_size(1 << 28);
    thread.spawn(test).unwrap().join().unwrap();
}

macro_rules! robots {
    ($($(#[$condition:meta])? $test:ident: $robot:ident, $lanes:ty;)+) => {$(
        $(#[$condition])?
        #[test]
        fn $test() {
            use kane_test_robots::$robot::Prepared;
            with_a_large_stack(|| {
                type Scalar = <$lanes as Lanes>::Scalar;
                check::<$lanes, _, _>(&Prepared::nominal(), &Prepared::<Scalar>::nominal());
            });
        }
    )+};
}

robots! {
    lanes_of_a_cartpole: cartpole, f64x8;
    lanes_of_a_double_pendulum: double_pendulum, f64x8;
    lanes_of_a_continuous_double_pendulum: double_pendulum_continuous, f64x8;
    lanes_of_the_ur5: ur5, f64x8;
    lanes_of_the_panda: panda, f64x8;
    short_lanes_of_the_panda: panda, f32x4;
    lanes_of_solo12: solo12, f64x8;
    #[cfg(every_system)]
    lanes_of_talos: talos, f64x8;
    lanes_of_the_fused_panda: panda_fused, f64x8;
    short_lanes_of_the_fused_panda: panda_fused, f32x4;
}
