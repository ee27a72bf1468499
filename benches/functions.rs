//! Each default function of the bundled systems, one state a call.
//!
//! `SYSTEM/function`: calls that do not wait for one another, as many as the machine overlaps. `SYSTEM/chained`: every call
//! waits for the output of the one before, as a control loop's does.

#![expect(
    clippy::large_stack_arrays,
    reason = "a mass matrix is an array, here as in a control loop"
)]

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use kane::{cart_pole, eight_body};

/// `N` numbers, none like another.
fn numbers<const N: usize>(start: f64) -> [f64; N] {
    core::array::from_fn(|place| (start + 0.37 * place as f64) % 1.6 - 0.8)
}

/// Every argument that a default function has.
struct State<const NQ: usize, const NU: usize> {
    q: [f64; NQ],
    u: [f64; NU],
    u_dot: [f64; NU],
    tau: [f64; NU],
}

impl<const NQ: usize, const NU: usize> State<NQ, NU> {
    fn new() -> Self {
        Self {
            q: numbers(0.1),
            u: numbers(0.3),
            u_dot: numbers(0.5),
            tau: numbers(0.7),
        }
    }
}

/// The given numbers, once those of `output` are there.
fn after<const N: usize>(given: &[f64; N], output: &[f64]) -> [f64; N] {
    let mut after = *given;
    for (after, output) in after.iter_mut().zip(output.iter().cycle()) {
        *after += 0.0 * *output;
    }
    after
}

/// Both measurements of each function; `numbers` are those of its output.
macro_rules! functions {
    ($criterion:ident, $system:ident:
        $($function:ident($($argument:ident),*), $output:ident = $zero:expr, $numbers:expr;)+) => {{
        use $system::{NAME, NB, NQ, NU, Prepared};
        let prepared = Prepared::<f64>::nominal();
        let state = State::<NQ, NU>::new();
        $(
            let name = format!("{NAME}/function/{}", stringify!($function));
            $criterion.bench_function(&name, |bencher| {
                let mut $output = $zero;
                bencher.iter(|| {
                    $system::$function(&prepared, black_box(&state.q), $(&state.$argument,)* &mut $output);
                    black_box(&mut $output);
                });
            });
            let name = format!("{NAME}/chained/{}", stringify!($function));
            $criterion.bench_function(&name, |bencher| {
                let (mut next, mut $output) = (state.q, $zero);
                bencher.iter(|| {
                    $system::$function(&prepared, &next, $(&state.$argument,)* &mut $output);
                    next = after(&state.q, $numbers);
                });
                black_box(next);
            });
        )+
    }};
}

macro_rules! default_functions {
    ($criterion:ident, $system:ident) => {
        functions! { $criterion, $system:
            q_dot(u), rates = [0.0; NQ], &rates;
            mass_matrix(), m = [[0.0; NU]; NU], m.as_flattened();
            bias(u), bias = [0.0; NU], &bias;
            inverse_dynamics(u, u_dot), forces = [0.0; NU], &forces;
            forward_dynamics(u, tau), solved = [0.0; NU], &solved;
            rotation(), rotations = [[[0.0; 3]; 3]; NB], rotations.as_flattened().as_flattened();
            mass_center_position(), positions = [[0.0; 3]; NB], positions.as_flattened();
            kinetic_energy(u), energy = 0.0, &[energy];
            potential_energy(), energy = 0.0, &[energy];
        }
    };
}

fn bundled(criterion: &mut Criterion) {
    default_functions!(criterion, cart_pole);
    default_functions!(criterion, eight_body);
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(50)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = bundled
}
criterion_main!(benches);
