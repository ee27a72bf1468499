//! Sines and cosines of the seven angles of an arm: ours as one array and one by one, and the platform's.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use kane::Real;

#[expect(
    clippy::disallowed_methods,
    reason = "the platform's sines are what ours are compared with"
)]
fn seven_angles(criterion: &mut Criterion) {
    let angles: [f64; 7] = core::array::from_fn(|joint| 0.3 * joint as f64 - 1.0);
    let mut group = criterion.benchmark_group("sines of seven angles");
    group.bench_function("array", |bencher| {
        bencher.iter(|| f64::sin_cos_array(black_box(angles)));
    });
    group.bench_function("one by one", |bencher| {
        bencher.iter(|| black_box(angles).map(<f64 as Real>::sin_cos));
    });
    group.bench_function("platform", |bencher| {
        bencher.iter(|| black_box(angles).map(f64::sin_cos));
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = seven_angles
}
criterion_main!(benches);
