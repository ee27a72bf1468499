//! `f32` beside `f64`: how near the functions of robots are to one another, as `docs/guarantees.md` says.

use kane::{
    Array, Real,
    functions::{ForwardDynamics, InverseDynamics, MassMatrix},
};
use kane_test_support::{
    compare::{assert_within, larger, relative},
    random::Random,
};

/// Random states of each robot.
const N_STATES: usize = 1000;

/// A robot, and how far `f32` may be off in its mass matrix, inverse dynamics and forward dynamics, relative to the largest entry.
type Row = (&'static str, [f64; 3]);

/// As the book has it.
const ROWS: [Row; 4] = [
    ("ur5", [4e-7, 2e-6, 1e-6]),
    ("panda", [6e-7, 1e-6, 1e-5]),
    ("solo12", [4e-8, 4e-7, 5e-6]),
    ("talos", [6e-8, 5e-7, 5e-6]),
];

/// Of the mass matrix, inverse dynamics and forward dynamics of a state, all entries.
fn outputs<R, S>(system: &S, [q, u, third]: &[Vec<f32>; 3]) -> [Vec<R>; 3]
where
    R: Real,
    S: MassMatrix<R> + InverseDynamics<R> + ForwardDynamics<R>,
{
    let of = |numbers: &[f32], place: usize| R::from_f64(f64::from(numbers[place]));
    let q = S::Q::from_fn(|place| of(q, place));
    let [u, third] = [u, third].map(|numbers| S::U::from_fn(|place| of(numbers, place)));
    let [mut tau, mut u_dot] = [S::U::filled(R::from_f64(f64::NAN)); 2];
    let mut m = S::Matrix::filled(tau);
    system.mass_matrix(&q, &mut m);
    system.inverse_dynamics(&q, &u, &third, &mut tau);
    system.forward_dynamics(&q, &u, &third, &mut u_dot);
    let m = m.as_ref().iter().flat_map(AsRef::as_ref).copied();
    [m.collect(), tau.as_ref().to_vec(), u_dot.as_ref().to_vec()]
}

/// Angles and positions to 3, speeds to 1.5, accelerations and forces to 3; a quaternion of length one.
fn state(random: &mut Random, n_q: usize, n_u: usize) -> [Vec<f32>; 3] {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "both precisions get the same numbers"
    )]
    let mut numbers = |n: usize, size: f64| -> Vec<f32> {
        let numbers = random.numbers(n).into_iter();
        numbers.map(|number| (size * number) as f32).collect()
    };
    let [mut q, u, third] = [numbers(n_q, 3.0), numbers(n_u, 1.5), numbers(n_u, 3.0)];
    if n_q > n_u {
        let length = q[..4].iter().map(|e| e * e).sum::<f32>().sqrt();
        q[..4].iter_mut().for_each(|e| *e /= length);
    }
    [q, u, third]
}

/// The largest error of each function, relative to the largest entry of what it writes.
fn errors<S, D>(single: &S, double: &D) -> [f64; 3]
where
    S: MassMatrix<f32> + InverseDynamics<f32> + ForwardDynamics<f32>,
    D: MassMatrix<f64> + InverseDynamics<f64> + ForwardDynamics<f64>,
{
    let mut random = Random::new(9);
    let mut worst = [0.0; 3];
    for _ in 0..N_STATES {
        let state = state(&mut random, S::Q::LEN, S::U::LEN);
        let (found, expected) = (
            outputs::<f32, S>(single, &state),
            outputs::<f64, D>(double, &state),
        );
        for (worst, (found, expected)) in worst.iter_mut().zip(found.iter().zip(&expected)) {
            let found: Vec<f64> = found.iter().copied().map(f64::from).collect();
            let error = relative(&found, expected);
            *worst = larger(*worst, error);
        }
    }
    worst
}

macro_rules! check {
    ($($robot:ident),+) => {$(
        let (single, double) = (
            kane_test_robots::$robot::Prepared::<f32>::nominal(),
            kane_test_robots::$robot::Prepared::<f64>::nominal(),
        );
        let name = stringify!($robot);
        let (_, allowed) = ROWS.into_iter().find(|row| row.0 == name).expect("the book has it");
        let found = errors(&single, &double);
        for (found, allowed) in found.into_iter().zip(allowed) {
            assert_within(name, found, allowed);
        }
    )+};
}

#[test]
fn the_book_has_what_is_allowed() {
    let book = include_str!("../../../docs/guarantees.md");
    for (name, [matrix, inverse, forward]) in ROWS {
        let row = format!("| {name} | {matrix:e} | {inverse:e} | {forward:e} |");
        assert!(book.contains(&row), "{row}");
    }
}

#[test]
fn single_precision_is_as_near_as_the_book_says() {
    check!(ur5, panda, solo12, talos);
}
