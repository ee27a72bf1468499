//! The eight-body system in a control loop, then let go.
//!
//! First ten seconds under a joint-space control law, called every millisecond: springs and dampers in every joint,
//! none between the hub and the inertial frame. Then ten seconds without loads, where energy and both momenta must
//! stay what they are. Run: `cargo run --release --package kane-eight-body`

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane::{
    Real,
    eight_body::{COORDINATE_NAMES, NB, NQ, NU, Prepared, SPEED_BODIES},
    functions::{AngularMomentum, KineticEnergy, LinearMomentum, Singularity},
    integrate::rk4_step,
};

/// The control period and the integration step, s.
const STEP: f64 = 1e-3;
/// Control steps in ten seconds.
const STEPS: usize = 10_000;
/// N m/rad and N/m.
const STIFFNESS: f64 = 4.0;
/// N m s/rad and N s/m.
const DAMPING: f64 = 3.0;

/// The joint-space control law: every joint but the hub's is pulled to zero and damped.
fn control(q: &[f64; NQ], u: &[f64; NU], tau: &mut [f64; NU]) {
    for i in 0..NU {
        let is_joint = SPEED_BODIES[i] != 0;
        tau[i] = if is_joint {
            -STIFFNESS * q[i] - DAMPING * u[i]
        } else {
            0.0
        };
    }
}

/// A state that no coordinate shares with another: small angles and offsets, small relative rates.
fn start() -> ([f64; NQ], [f64; NU]) {
    let q = core::array::from_fn(|i| 0.2 * Real::sin_cos(1.7 * i as f64).0);
    let u = core::array::from_fn(|i| 0.03 * Real::sin_cos(2.3 * i as f64 + 1.0).1);
    (q, u)
}

struct Integrals {
    energy: f64,
    linear: [f64; 3],
    angular: [f64; 3],
}

fn integrals(system: &Prepared<f64>, q: &[f64; NQ], u: &[f64; NU]) -> Integrals {
    let mut integrals = Integrals {
        energy: 0.0,
        linear: [0.0; 3],
        angular: [0.0; 3],
    };
    system.kinetic_energy(q, u, &mut integrals.energy);
    system.linear_momentum(q, u, &mut integrals.linear);
    system.angular_momentum(q, u, &mut integrals.angular);
    integrals
}

/// The distance from the angles' singularity, `|cos(theta_2)|`, of the body that is nearest.
fn least_distance(system: &Prepared<f64>, q: &[f64; NQ]) -> f64 {
    let mut distances = [0.0; NB];
    system.singularity(q, &mut distances);
    distances.into_iter().fold(1.0, f64::min)
}

fn norm(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    norm(core::array::from_fn(|i| a[i] - b[i]))
}

/// The joint coordinate that is farthest from zero.
fn farthest(q: &[f64; NQ]) -> (usize, f64) {
    let joints = (0..NQ).filter(|&i| SPEED_BODIES[i] != 0);
    joints.map(|i| (i, q[i])).fold((0, 0.0), |far, other| {
        if other.1.abs() > far.1.abs() {
            other
        } else {
            far
        }
    })
}

fn main() {
    let system = Prepared::<f64>::nominal();
    let (mut q, mut u) = start();
    let mut least = least_distance(&system, &q);

    println!(
        "under control: tau = -{STIFFNESS} q - {DAMPING} u in every joint, called every {STEP} s"
    );
    println!(
        "{:>6}  {:>14}  {:>14}  farthest joint coordinate",
        "t, s", "energy, J", "|cos theta2|"
    );
    for step in 0..=STEPS {
        if step % 1000 == 0 {
            let energy = integrals(&system, &q, &u).energy;
            let (i, value) = farthest(&q);
            let time = step as f64 * STEP;
            println!(
                "{time:>6.1}  {energy:>14.6e}  {least:>14.6}  {} = {value:+.6}",
                COORDINATE_NAMES[i]
            );
        }
        let mut tau = [0.0; NU];
        control(&q, &u, &mut tau);
        rk4_step(&system, &tau, STEP, &mut q, &mut u);
        least = least.min(least_distance(&system, &q));
    }

    let (mut q, mut u) = start();
    let before = integrals(&system, &q, &u);
    for _ in 0..STEPS {
        rk4_step(&system, &[0.0; NU], STEP, &mut q, &mut u);
        least = least.min(least_distance(&system, &q));
    }
    let after = integrals(&system, &q, &u);
    let energy_drift = ((after.energy - before.energy) / before.energy).abs();
    println!();
    println!("let go for {} s, steps of {STEP} s:", STEPS as f64 * STEP);
    println!(
        "energy            {:.9e} J, relative drift {energy_drift:.1e}",
        after.energy
    );
    for (name, before, after) in [
        ("linear momentum  ", before.linear, after.linear),
        ("angular momentum ", before.angular, after.angular),
    ] {
        println!(
            "{name} {:.9e}, relative drift {:.1e}",
            norm(after),
            difference(after, before) / norm(before)
        );
    }
    println!("least |cos theta2| met in both: {least:.3}");
    assert!(energy_drift < 1e-9, "energy drifts by {energy_drift:e}");
}
