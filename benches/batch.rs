//! Batches of states: the scalar functions one state after the other, and lanes. What is shown is the whole batch.
//!
//! The scalar takes its states one after the other from memory, as one would keep them for it; lanes take rows, and groups that
//! lie together, as [`Batch`] does. A batch of 1024 states fits a cache, one of 60,000 fits none. Vectors are as fast as the
//! target they are compiled for: `RUSTFLAGS="-C target-cpu=native"`.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use kane::batch::Batch;
use kane::eight_body::{NQ, NU, Prepared};
use kane::functions::{Bias, ForwardDynamics, InverseDynamics};
use kane::wide::{f32x8, f32x16, f64x2, f64x4, f64x8};
use kane::{Lanes, Real};

const STATES: [usize; 2] = [1024, 60_000];

/// Rows of all states, none of their numbers like its neighbours.
fn rows<S: Real>(states: usize, rows: usize, start: f64) -> Vec<S> {
    let number = |place: usize| (start + 0.37 * place as f64) % 1.6 - 0.8;
    (0..rows * states)
        .map(|place| S::from_f64(number(place)))
        .collect()
}

/// The same numbers, state after state.
fn arrays<const N: usize>(states: usize, start: f64) -> Vec<[f64; N]> {
    let rows = rows::<f64>(states, N, start);
    let state = |state: usize| core::array::from_fn(|row| rows[row * states + state]);
    (0..states).map(state).collect()
}

/// The same numbers, group after group.
fn grouped<L: Lanes, const N: usize>(batch: Batch<L>, states: usize, start: f64) -> Vec<[L; N]> {
    let mut groups = vec![[L::from_f64(0.0); N]; batch.n_groups()];
    let rows = rows::<L::Scalar>(states, N, start);
    batch
        .to_groups(&rows, &mut groups)
        .expect("both are of this batch");
    groups
}

fn scalar(criterion: &mut Criterion) {
    for states in STATES {
        scalar_of(criterion, states);
    }
}

fn scalar_of(criterion: &mut Criterion, states: usize) {
    let mut group = criterion.benchmark_group(format!("eight_body/batch of {states}"));
    group.throughput(Throughput::Elements(states as u64));
    let system = Prepared::<f64>::nominal();
    let q = arrays::<NQ>(states, 0.1);
    let [u, third] = [0.3, 0.5].map(|start| arrays::<NU>(states, start));
    let mut out = vec![[0.0; NU]; states];
    group.bench_function("bias/scalar", |bencher| {
        bencher.iter(|| {
            for ((out, q), u) in out.iter_mut().zip(&q).zip(&u) {
                system.bias(q, u, out);
            }
            black_box(&mut out);
        });
    });
    group.bench_function("inverse_dynamics/scalar", |bencher| {
        bencher.iter(|| {
            for (((out, q), u), u_dot) in out.iter_mut().zip(&q).zip(&u).zip(&third) {
                system.inverse_dynamics(q, u, u_dot, out);
            }
            black_box(&mut out);
        });
    });
    group.bench_function("forward_dynamics/scalar", |bencher| {
        bencher.iter(|| {
            for (((out, q), u), tau) in out.iter_mut().zip(&q).zip(&u).zip(&third) {
                system.forward_dynamics(q, u, tau, out);
            }
            black_box(&mut out);
        });
    });
    group.finish();
}

fn lanes<L: Lanes>(criterion: &mut Criterion, name: &str) {
    for states in STATES {
        lanes_of::<L>(criterion, name, states);
    }
}

fn lanes_of<L: Lanes>(criterion: &mut Criterion, name: &str, states: usize) {
    let mut group = criterion.benchmark_group(format!("eight_body/batch of {states}"));
    group.throughput(Throughput::Elements(states as u64));
    let system = Prepared::<L>::nominal();
    let batch = Batch::<L>::new(states);
    let q = rows::<L::Scalar>(states, NQ, 0.1);
    let [u, third] = [0.3, 0.5].map(|start| rows::<L::Scalar>(states, NU, start));
    let mut out = rows::<L::Scalar>(states, NU, 0.0);
    group.bench_function(format!("bias/{name}"), |bencher| {
        bencher.iter(|| black_box(batch.bias(&system, &q, &u, &mut out)));
    });
    group.bench_function(format!("inverse_dynamics/{name}"), |bencher| {
        bencher.iter(|| black_box(batch.inverse_dynamics(&system, &q, &u, &third, &mut out)));
    });
    group.bench_function(format!("forward_dynamics/{name}"), |bencher| {
        bencher.iter(|| black_box(batch.forward_dynamics(&system, &q, &u, &third, &mut out)));
    });
    let q = grouped::<L, NQ>(batch, states, 0.1);
    let [u, third] = [0.3, 0.5].map(|start| grouped::<L, NU>(batch, states, start));
    let mut out = vec![[L::from_f64(0.0); NU]; batch.n_groups()];
    group.bench_function(format!("inverse_dynamics/{name}, groups"), |bencher| {
        bencher.iter(|| {
            black_box(batch.inverse_dynamics_of_groups(&system, &q, &u, &third, &mut out))
        });
    });
    group.bench_function(format!("forward_dynamics/{name}, groups"), |bencher| {
        bencher.iter(|| {
            black_box(batch.forward_dynamics_of_groups(&system, &q, &u, &third, &mut out))
        });
    });
    group.finish();
}

fn vectors(criterion: &mut Criterion) {
    lanes::<f64x2>(criterion, "f64x2");
    lanes::<f64x4>(criterion, "f64x4");
    lanes::<f64x8>(criterion, "f64x8");
    lanes::<f32x8>(criterion, "f32x8");
    lanes::<f32x16>(criterion, "f32x16");
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(30)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = scalar, vectors
}
criterion_main!(benches);
