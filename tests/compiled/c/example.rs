//! The example in C.

use std::{path::Path, process::Command};

#[allow(clippy::pedantic, unreachable_pub, reason = "generated")]
#[rustfmt::skip]
#[path = "../../../examples/c/generated/cart_pole.rs"]
mod cart_pole;
#[allow(clippy::pedantic, unreachable_pub, reason = "generated")]
#[rustfmt::skip]
#[path = "../../../examples/c/generated/panda.rs"]
mod panda;

use kane::Real;
use kane_test_support::tool::{tool, tools};

use super::{C, bits, folder, run};

#[test]
fn example_prints_the_bits_of_rust() {
    let Some(make) = tool("make", "the example in C") else {
        return;
    };
    let expected: Vec<(&str, Vec<u64>)> = (0..5).flat_map(results).collect();
    let target = folder("example");
    for compiler in tools(C, "the example in C by this compiler") {
        let printed = run(Command::new(make)
            .args(["--silent", "run"])
            .arg(format!("CC={compiler}"))
            .arg(format!("BUILD={}", target.join(compiler).display()))
            .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/c"))
            .env("CARGO_TARGET_DIR", &target));
        let printed: Vec<(&str, Vec<u64>)> = printed.lines().map(bits).collect();
        assert_eq!(printed, expected, "{compiler}");
    }
}

/// What the program prints of a state.
fn results(state: usize) -> Vec<(&'static str, Vec<u64>)> {
    let mut results = of_cart_pole(state);
    results.push(("gravity_forces", of_panda::<f64>(state)));
    results.push(("gravity_forces_f32", of_panda::<f32>(state)));
    results
}

/// Entries as in the program.
fn entries<R: Real, const N: usize>(state: usize, first: usize) -> [R; N] {
    core::array::from_fn(|place| {
        let entry = (7 * state + 5 * (first + place)) % 17;
        R::from_f64((entry as f64 - 8.0) / 4.0)
    })
}

fn of_cart_pole(state: usize) -> Vec<(&'static str, Vec<u64>)> {
    use cart_pole::{NB, NU, Parameters, Prepared, SinCos};

    let p = Prepared::<f64>::new(&Parameters { pole_mass: 0.55 });
    let (q, u) = (entries(state, 0), entries(state, 10));
    let (mut m, mut u_dot) = ([[0.0; NU]; NU], [0.0; NU]);
    cart_pole::mass_matrix(&p, &q, &mut m);
    cart_pole::forward_dynamics(&p, &q, &u, &[3.0, 0.0], &mut u_dot);
    let mut loads = [kane::Load::default(); NB];
    loads[1].force[0] = 2.0;
    loads[1].moment[1] = -1.0;
    let (mut f, mut bias) = ([0.0; NU], [0.0; NU]);
    cart_pole::forcing(&p, &q, &u, &loads, &mut f);
    let mut sin_cos = SinCos {
        sines: [0.0],
        cosines: [0.0],
    };
    cart_pole::sin_cos(&p, &q, &mut sin_cos);
    cart_pole::bias_at_sin_cos(&p, &q, &sin_cos, &u, &mut bias);
    let results = [
        ("mass_matrix", m.as_flattened()),
        ("forward_dynamics", &u_dot),
        ("forcing", &f),
        ("bias_at_sin_cos", &bias),
    ];
    let results = results.map(|(name, values)| (name, values.iter().map(|x: &f64| x.to_bits())));
    results
        .map(|(name, values)| (name, values.collect()))
        .into()
}

fn of_panda<R: Real + Into<f64>>(state: usize) -> Vec<u64> {
    let p = panda::Prepared::<R>::nominal();
    let mut tau = [R::from_f64(0.0); panda::NU];
    panda::gravity_forces(&p, &entries(state, 0), &mut tau);
    tau.map(|x| x.into().to_bits()).into()
}
