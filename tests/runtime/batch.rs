//! Batches: the bits of each state alone, whatever is left over after full groups; wrong lengths are told.

#![allow(clippy::unwrap_used, reason = "a test stops where it cannot go on")]

use kane::batch::{Batch, LengthError};
use kane::eight_body::{MASS_MATRIX_PACKED_LEN, NQ, NU, Prepared};
use kane::functions::{
    Bias, ForwardDynamics, InverseDynamics, KineticEnergy, MassMatrix, MassMatrixPacked,
};
use kane::{Lanes, Real, System};
use kane_test_support::random::Random;

/// Every argument of a batch of states, row by row.
struct States<S> {
    n: usize,
    q: Vec<S>,
    u: Vec<S>,
    u_dot: Vec<S>,
}

impl<S: Real> States<S> {
    fn new(n: usize) -> Self {
        let mut random = Random::new(20_261_123);
        let mut numbers = |rows: usize| {
            (0..rows * n)
                .map(|_| S::from_f64(random.symmetric()))
                .collect()
        };
        Self {
            n,
            q: numbers(NQ),
            u: numbers(NU),
            u_dot: numbers(NU),
        }
    }

    /// The numbers of one state.
    fn one<const ROWS: usize>(&self, rows: &[S], state: usize) -> [S; ROWS] {
        core::array::from_fn(|row| rows[row * self.n + state])
    }
}

/// Every method of a batch against the function of each state alone.
fn check<L: Lanes>(sizes: &[usize])
where
    L::Scalar: PartialEq,
{
    let zero = L::Scalar::from_f64(0.0);
    let (system, single) = (Prepared::<L>::nominal(), Prepared::<L::Scalar>::nominal());
    for &n in sizes {
        let states = States::<L::Scalar>::new(n);
        let States { q, u, u_dot, .. } = &states;
        let batch = Batch::<L>::new(n);
        let mut outputs = [(); 4].map(|()| vec![zero; NU * n]);
        let mut m = vec![zero; NU * NU * n];
        let [q_dot, bias, tau, solved] = &mut outputs;
        batch.q_dot(&system, q, u, q_dot).unwrap();
        batch.bias(&system, q, u, bias).unwrap();
        batch.inverse_dynamics(&system, q, u, u_dot, tau).unwrap();
        batch
            .forward_dynamics(&system, q, u, u_dot, solved)
            .unwrap();
        batch.mass_matrix(&system, q, &mut m).unwrap();
        let mut entries = vec![zero; MASS_MATRIX_PACKED_LEN * n];
        batch.mass_matrix_packed(&system, q, &mut entries).unwrap();
        for state in 0..n {
            let [q, u, u_dot] = [q, u, u_dot].map(|rows| states.one::<NU>(rows, state));
            let mut expected = [[zero; NU]; 4];
            let mut expected_m = [[zero; NU]; NU];
            single.q_dot(&q, &u, &mut expected[0]);
            single.bias(&q, &u, &mut expected[1]);
            single.inverse_dynamics(&q, &u, &u_dot, &mut expected[2]);
            single.forward_dynamics(&q, &u, &u_dot, &mut expected[3]);
            single.mass_matrix(&q, &mut expected_m);
            let mut expected_entries = [zero; MASS_MATRIX_PACKED_LEN];
            single.mass_matrix_packed(&q, &mut expected_entries);
            assert_eq!(
                states.one::<MASS_MATRIX_PACKED_LEN>(&entries, state),
                expected_entries,
                "state {state} of {n}"
            );
            for (found, expected) in outputs.iter().zip(&expected) {
                assert_eq!(
                    &states.one::<NU>(found, state),
                    expected,
                    "state {state} of {n}"
                );
            }
            for (found, expected) in m.chunks(NU * n).zip(&expected_m) {
                assert_eq!(
                    &states.one::<NU>(found, state),
                    expected,
                    "state {state} of {n}"
                );
            }
        }
    }
}

#[test]
fn single_lanes_are_the_functions_themselves() {
    check::<f64>(&[0, 1, 3, 8, 17]);
    check::<f32>(&[2]);
}

#[cfg(feature = "wide")]
#[test]
fn lanes_are_the_functions_of_each_state_whatever_is_left_over() {
    use kane::wide::{f32x4, f64x8};
    // Without optimization each of ten thousand vectors has places of its own on the stack, more than a test's has.
    let thread = std::thread::Builder::new().stack_size(1 << 28);
    let checks = thread.spawn(|| {
        // Groups, and tiles of eight of them.
        check::<f64x8>(&[0, 1, 7, 8, 9, 16, 21, 63, 64, 65, 139]);
        check::<f32x4>(&[0, 3, 4, 5, 8, 31, 32, 70]);
    });
    checks.unwrap().join().unwrap();
}

/// Any function, by groups, here that of the energies: the example of the documentation with lanes and a rest.
#[cfg(feature = "wide")]
#[test]
fn groups_serve_any_function_and_write_no_state_that_is_not_theirs() {
    use kane::wide::f64x8;
    let n = 11;
    let states = States::<f64>::new(n);
    let batch = Batch::<f64x8>::new(n);
    let (system, single) = (Prepared::<f64x8>::nominal(), Prepared::<f64>::nominal());
    let mut energies = vec![f64::NAN; n];
    let (q, u) = (
        batch.rows("q", &states.q, NQ).unwrap(),
        batch.rows("u", &states.u, NU).unwrap(),
    );
    let mut rows = batch.rows_mut("energies", &mut energies, 1).unwrap();
    let zero = f64x8::from_f64(0.0);
    let (mut group_q, mut group_u, mut energy) = ([zero; NQ], [zero; NU], zero);
    for group in batch.groups() {
        group.load(&q, &mut group_q).unwrap();
        group.load(&u, &mut group_u).unwrap();
        system.kinetic_energy(&group_q, &group_u, &mut energy);
        // A second row, which there is none of, is dropped.
        group.store([&energy, &energy], &mut rows).unwrap();
    }
    for (state, &found) in energies.iter().enumerate() {
        let mut expected = 0.0;
        let [q, u] = [&states.q, &states.u].map(|rows| states.one::<NU>(rows, state));
        single.kinetic_energy(&q, &u, &mut expected);
        assert_eq!(found, expected, "state {state}");
    }
}

#[test]
fn slices_of_another_length_are_told_and_nothing_is_written() {
    let n = 3;
    let States { q, u, u_dot, .. } = States::<f64>::new(n);
    let system = Prepared::<f64>::nominal();
    let batch = Batch::<f64>::new(n);
    let mut tau = vec![9.0; NU * n];
    let short = &u[1..];
    let error = batch.inverse_dynamics(&system, &q, short, &u_dot, &mut tau);
    let expected = LengthError {
        argument: "u",
        found: NU * n - 1,
        rows: NU,
        states: n,
    };
    assert_eq!(error, Err(expected));
    assert_eq!(
        expected.to_string(),
        "`u` has a length of 143; expected 48 rows of 3"
    );
    let error = batch.bias(&system, &q, &u, &mut tau[..n]).unwrap_err();
    assert_eq!((error.argument, error.found), ("bias", n));
    let error = batch.mass_matrix(&system, &q, &mut tau).unwrap_err();
    assert_eq!((error.argument, error.rows), ("m", NU * NU));
    assert!(tau.iter().all(|&value| value == 9.0));
}

#[test]
fn rows_of_a_batch_of_another_size_are_refused_and_nothing_is_read_or_written() {
    let (batch, other) = (Batch::<f64>::new(6), Batch::<f64>::new(4));
    let given = [1.0; 12];
    let mut written = [2.0; 12];
    let rows = other.rows("q", &given, 3).unwrap();
    let mut rows_mut = other.rows_mut("tau", &mut written, 3).unwrap();
    let mut kept = [7.0, 8.0];
    for group in batch.groups() {
        let error = group.load(&rows, &mut kept).unwrap_err();
        assert_eq!(
            error.to_string(),
            "`q` has a length of 12; expected 3 rows of 6"
        );
        let error = group.store([&9.0], &mut rows_mut).unwrap_err();
        assert_eq!((error.argument, error.states), ("tau", 6));
    }
    assert_eq!(kept, [7.0, 8.0]);
    assert_eq!(written, [2.0; 12]);
    // Another batch of the same size has the same rows.
    let same = Batch::<f64>::new(6).rows("q", &given, 2).unwrap();
    batch
        .groups()
        .last()
        .unwrap()
        .load(&same, &mut kept)
        .unwrap();
    assert_eq!(kept, [1.0; 2]);
}

#[test]
fn sizes_that_no_memory_holds_are_an_error_and_no_panic() {
    let batch = Batch::<f64>::new(usize::MAX);
    assert!(batch.rows("q", &[1.0], 2).is_err());
    let none = batch.rows("nothing", &[], 0).unwrap();
    let mut kept = [7.0, 8.0];
    for group in batch.groups().take(2) {
        group.load(&none, &mut kept).unwrap();
    }
    assert_eq!(kept, [7.0, 8.0]);
}

#[cfg(feature = "wide")]
#[test]
fn groups_that_lie_together_have_the_bits_of_rows() {
    use kane::wide::f64x4;
    for n in [1, 4, 11] {
        let states = States::<f64>::new(n);
        let (batch, system) = (Batch::<f64x4>::new(n), Prepared::<f64x4>::nominal());
        let zero = f64x4::from_f64(0.0);
        let mut q = vec![[zero; NQ]; batch.n_groups()];
        let mut u = vec![[zero; NU]; batch.n_groups()];
        let mut third = u.clone();
        batch.to_groups(&states.q, &mut q).unwrap();
        batch.to_groups(&states.u, &mut u).unwrap();
        batch.to_groups(&states.u_dot, &mut third).unwrap();
        let same = |groups: &[[f64x4; NU]], rows: &[f64]| {
            let mut found = vec![0.0; NU * n];
            batch.from_groups(groups, &mut found).unwrap();
            let bits = |numbers: &[f64]| -> Vec<u64> {
                numbers.iter().map(|number| number.to_bits()).collect()
            };
            assert_eq!(bits(&found), bits(rows));
        };
        let (mut groups, mut rows) = (u.clone(), vec![0.0; NU * n]);
        batch.q_dot_of_groups(&system, &q, &u, &mut groups).unwrap();
        batch
            .q_dot(&system, &states.q, &states.u, &mut rows)
            .unwrap();
        same(&groups, &rows);
        batch.bias_of_groups(&system, &q, &u, &mut groups).unwrap();
        batch
            .bias(&system, &states.q, &states.u, &mut rows)
            .unwrap();
        same(&groups, &rows);
        batch
            .inverse_dynamics_of_groups(&system, &q, &u, &third, &mut groups)
            .unwrap();
        batch
            .inverse_dynamics(&system, &states.q, &states.u, &states.u_dot, &mut rows)
            .unwrap();
        same(&groups, &rows);
        batch
            .forward_dynamics_of_groups(&system, &q, &u, &third, &mut groups)
            .unwrap();
        batch
            .forward_dynamics(&system, &states.q, &states.u, &states.u_dot, &mut rows)
            .unwrap();
        same(&groups, &rows);
    }
}

/// Mass matrices of groups that lie together against those of each group alone.
fn matrices_are_those_of_each_group<L: Lanes + PartialEq>(n: usize) {
    let (batch, system) = (Batch::<L>::new(n), Prepared::<L>::nominal());
    let states = States::<L::Scalar>::new(n);
    let zero = L::from_f64(0.0);
    let mut q = vec![[zero; NQ]; batch.n_groups()];
    batch.to_groups(&states.q, &mut q).unwrap();
    let mut m = vec![[[zero; NU]; NU]; batch.n_groups()];
    let mut entries = vec![[zero; MASS_MATRIX_PACKED_LEN]; batch.n_groups()];
    batch.mass_matrix_of_groups(&system, &q, &mut m).unwrap();
    batch
        .mass_matrix_packed_of_groups(&system, &q, &mut entries)
        .unwrap();
    for (q, (m, entries)) in q.iter().zip(m.iter().zip(&entries)) {
        let mut alone = [[zero; NU]; NU];
        system.mass_matrix(q, &mut alone);
        assert_eq!(m, &alone);
        assert!(m[0][0] != zero);
        let mut alone = [zero; MASS_MATRIX_PACKED_LEN];
        system.mass_matrix_packed(q, &mut alone);
        assert_eq!(entries, &alone);
    }
    let short = batch.mass_matrix_of_groups(&system, &q[1..], &mut m);
    assert_eq!(short.unwrap_err().argument, "q");
}

#[test]
fn mass_matrices_of_groups_are_those_of_each_group() {
    matrices_are_those_of_each_group::<f64>(3);
    #[cfg(feature = "wide")]
    matrices_are_those_of_each_group::<kane::wide::f64x4>(7);
}

#[test]
fn slices_without_an_array_for_each_group_are_refused() {
    let (batch, system) = (Batch::<f64>::new(2), Prepared::<f64>::nominal());
    let (q, u) = ([[0.0; NQ]; 2], [[0.5; NU]; 2]);
    let mut tau = [[7.0; NU]; 2];
    let fault = batch.inverse_dynamics_of_groups(&system, &q[1..], &u, &u, &mut tau);
    let fault = fault.unwrap_err();
    assert_eq!((fault.argument, fault.found, fault.states), ("q", 1, 2));
    assert_eq!(tau, [[7.0; NU]; 2]);
    let mut rows = [7.0; 2 * NU];
    let fault = batch.from_groups(&u[1..], &mut rows).unwrap_err();
    assert_eq!((fault.argument, fault.found), ("groups", 1));
    assert_eq!(rows, [7.0; 2 * NU]);
}
