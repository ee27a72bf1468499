//! Steps: where they lead, and their derivatives against differences of order 12 on the manifold, and against each other.

mod conditions;
mod scheme;

use kane::discrete::{Change, StepByParameters, StepDerivatives};
use kane::functions::{
    ForwardDynamics, ForwardDynamicsAndDerivatives, ForwardDynamicsJvp, ForwardDynamicsVjp,
};
use kane::integrate::rk4_step;
use kane::manifold::{q_minus, q_plus};
use kane::{Array, System};
use kane_optimal::{cart_pole, eight_body, panda, tumbler};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    numeric::{derivative, dot},
    random::Random,
};
use scheme::{Driven, Scheme};

/// Differences lose a digit and a half to the sums that they are of, and the mass matrix, which is solved with four times,
/// up to three more.
const DIFFERENCED: Tolerance = Tolerance::relative_beyond(1.0, 1e-10);

/// Rounding of the two ways, of which each solves with the mass matrix four times.
const ROUNDED: Tolerance = Tolerance::relative_beyond(1.0, 1e-12);

/// A state that is about one everywhere, quaternions of length one.
fn drawn<S: System<f64>>(system: &S, seed: u64, force: f64, dt: f64) -> Driven<S::Q, S::U> {
    let mut random = Random::new(seed);
    let mut rest = S::Q::filled(0.0);
    for joint in S::JOINTS {
        if let (Some(place), kane::Chart::EulerParameters) = (joint.q[0], joint.chart) {
            rest[place] = 1.0;
        }
    }
    let mut numbers = |size: f64| S::U::from_fn(|_| size * random.symmetric());
    Driven {
        q: q_plus(system, &rest, &numbers(1.0)),
        u: numbers(1.0),
        tau: numbers(force),
        dt,
    }
}

/// The state that lies along a change.
fn displaced<S: System<f64>>(
    system: &S,
    at: &Driven<S::Q, S::U>,
    (change, tau): &(Change<S::U>, S::U),
    t: f64,
) -> Driven<S::Q, S::U> {
    Driven {
        q: q_plus(system, &at.q, &S::U::from_fn(|i| t * change.q[i])),
        u: S::U::from_fn(|i| at.u[i] + t * change.u[i]),
        tau: S::U::from_fn(|i| at.tau[i] + t * tau[i]),
        dt: at.dt,
    }
}

/// Where a step leads, as seen from another state: changes of `q` before those of `u`.
fn seen<S: System<f64>>(system: &S, from: &(S::Q, S::U), to: &(S::Q, S::U)) -> Vec<f64> {
    let q = q_minus(system, &from.0, &to.0);
    let u = (0..S::U::LEN).map(|i| to.1[i] - from.1[i]);
    q.as_ref().iter().copied().chain(u).collect()
}

/// What a change becomes, by differences of the step.
fn differenced<S: ForwardDynamics<f64>>(
    scheme: Scheme,
    system: &S,
    at: &Driven<S::Q, S::U>,
    along: &(Change<S::U>, S::U),
) -> Vec<f64> {
    let after = scheme.step(system, at);
    derivative(|t| {
        let other = scheme.step(system, &displaced(system, at, along, t));
        seen(system, &after, &other)
    })
}

fn flat<U: Array<f64>>(change: &Change<U>) -> Vec<f64> {
    let both = change.q.as_ref().iter().chain(change.u.as_ref());
    both.copied().collect()
}

fn random_change<U: Array<f64>>(random: &mut Random) -> (Change<U>, U) {
    let mut numbers = || U::from_fn(|_| random.symmetric());
    let (q, u) = (numbers(), numbers());
    (Change { q, u }, numbers())
}

fn unit<U: Array<f64>>(entry: usize) -> (Change<U>, U) {
    let part = |first: usize| U::from_fn(|i| f64::from(first + i == entry));
    let n = U::LEN;
    let change = Change {
        q: part(0),
        u: part(n),
    };
    (change, part(2 * n))
}

/// `A` and `B` beside each other, column by column.
fn columns<U: Array<f64>, M: Array<U>>(of: &StepDerivatives<M>) -> Vec<Vec<f64>> {
    let blocks = [
        (&of.q_by_q, &of.u_by_q),
        (&of.q_by_u, &of.u_by_u),
        (&of.q_by_tau, &of.u_by_tau),
    ];
    let of_block = |(upper, lower): (&M, &M)| {
        let (upper, lower) = (*upper, *lower);
        (0..U::LEN).map(move |column| {
            let rows = upper.as_ref().iter().chain(lower.as_ref());
            rows.map(|row| row[column]).collect()
        })
    };
    blocks.into_iter().flat_map(of_block).collect()
}

/// Tries both steps of a system from a state, and returns `A` and `B` of each.
fn whole_derivatives_are_differences<S>(system: &S, at: &Driven<S::Q, S::U>) -> [Vec<Vec<f64>>; 2]
where
    S: ForwardDynamics<f64> + ForwardDynamicsAndDerivatives<f64>,
{
    Scheme::ALL.map(|scheme| {
        let mut found = StepDerivatives::filled(S::Matrix::filled(S::U::filled(f64::NAN)));
        let what = format!("{}, {scheme:?}", S::NAME);
        let after = scheme.linearized(system, at, &mut found);
        // It is the same step; of what is joined, the operations come in another order.
        let there = seen(system, &scheme.step(system, at), &after);
        assert_close(&what, &there, &vec![0.0; there.len()], ROUNDED);
        let columns = columns(&found);
        for (place, column) in columns.iter().enumerate() {
            let expected = differenced(scheme, system, at, &unit(place));
            assert_close(format!("{what}, {place}"), column, &expected, DIFFERENCED);
        }
        columns
    })
}

/// Forward and back, without the matrices.
fn products_are_those_with<S>(
    scheme: Scheme,
    system: &S,
    at: &Driven<S::Q, S::U>,
    columns: &[Vec<f64>],
) where
    S: ForwardDynamics<f64> + ForwardDynamicsJvp<f64> + ForwardDynamicsVjp<f64>,
{
    let mut random = Random::new(7);
    let what = format!("{}, {scheme:?}", S::NAME);
    let along: (Change<S::U>, S::U) = random_change(&mut random);
    let given = [flat(&along.0), along.1.as_ref().to_vec()].concat();
    let mut expected = vec![0.0; 2 * S::U::LEN];
    for (column, factor) in columns.iter().zip(&given) {
        for (sum, entry) in expected.iter_mut().zip(column) {
            *sum += factor * entry;
        }
    }
    let (q, u, change) = scheme.forward(system, at, along);
    assert_close(&what, &flat(&change), &expected, ROUNDED);
    let there = scheme.step(system, at);
    assert_eq!(q.as_ref(), there.0.as_ref(), "{what}");
    assert_eq!(u.as_ref(), there.1.as_ref(), "{what}");
    let multiplier: (Change<S::U>, S::U) = random_change(&mut random);
    let expected: Vec<f64> = columns
        .iter()
        .map(|column| dot(column, &flat(&multiplier.0)))
        .collect();
    let (before, of_tau) = scheme.adjoint(system, at, multiplier.0);
    let found = [flat(&before), of_tau.as_ref().to_vec()].concat();
    assert_close(&what, &found, &expected, ROUNDED);
}

/// The same, and products with directions and multipliers.
fn all_derivatives_are_differences<S>(system: &S, at: &Driven<S::Q, S::U>)
where
    S: ForwardDynamics<f64>
        + ForwardDynamicsAndDerivatives<f64>
        + ForwardDynamicsJvp<f64>
        + ForwardDynamicsVjp<f64>,
{
    let of_both = whole_derivatives_are_differences(system, at);
    for (scheme, columns) in Scheme::ALL.into_iter().zip(of_both) {
        products_are_those_with(scheme, system, at, &columns);
    }
}

#[test]
fn a_and_b_are_differences_of_the_step() {
    let cart = cart_pole::Prepared::nominal();
    all_derivatives_are_differences(&cart, &drawn(&cart, 1, 3.0, 0.02));
    let arm = panda::Prepared::nominal();
    let _ = whole_derivatives_are_differences(&arm, &drawn(&arm, 2, 20.0, 0.01));
    let tumbler = tumbler::Prepared::nominal();
    // A long step, so that turns count.
    for dt in [1e-4, 0.02, 0.2] {
        all_derivatives_are_differences(&tumbler, &drawn(&tumbler, 3, 0.3, dt));
    }
}

#[test]
fn a_step_has_the_same_bits_on_every_machine() {
    let system = tumbler::Prepared::<f64>::nominal();
    let mut at = drawn(&system, 6, 0.3, 0.01);
    for scheme in Scheme::ALL {
        for _ in 0..20 {
            (at.q, at.u) = scheme.step(&system, &at);
        }
    }
    let bits = at.q.iter().chain(&at.u).map(|number| number.to_bits());
    let mixed = bits.fold(0_u64, |sum, bits| {
        (sum ^ bits).wrapping_mul(0x0100_0000_01b3)
    });
    assert_eq!(mixed, 0x5f31_7337_be31_fd19, "{mixed:#018x}");
}

#[test]
fn eight_bodies_change_as_differences_of_the_step_do() {
    let system = eight_body::Prepared::<f64>::nominal();
    let mut random = Random::new(5);
    for scheme in Scheme::ALL {
        let at = drawn(&system, 4, 1.0, 0.02);
        let what = format!("{scheme:?}");
        let along = random_change(&mut random);
        let (_, _, change) = scheme.forward(&system, &at, along);
        let expected = differenced(scheme, &system, &at, &along);
        assert_close(&what, &flat(&change), &expected, DIFFERENCED);
        // <w, A v + B t> = <A^T w, v> + <B^T w, t>.
        let (multiplier, _) = random_change(&mut random);
        let (before, of_tau) = scheme.adjoint(&system, &at, multiplier);
        let ahead = dot(&flat(&multiplier), &flat(&change));
        let back = dot(&flat(&before), &flat(&along.0)) + dot(&of_tau, &along.1);
        assert_close(&what, &[back], &[ahead], ROUNDED);
    }
}

#[test]
fn a_step_changes_with_values_set_at_run_time_as_differences_do() {
    for scheme in Scheme::ALL {
        let parameters = tumbler::Parameters::<f64>::default();
        assert_eq!(
            tumbler::PARAMETER_NAMES,
            ["trunk_mass", "arm_mass_center_z"]
        );
        assert_eq!(
            parameters.to_array(),
            [parameters.trunk_mass, parameters.arm_mass_center_z]
        );
        let at = drawn(&tumbler::Prepared::new(&parameters), 8, 0.5, 0.1);
        let none = [[f64::NAN; 2]; 10];
        let mut found = StepByParameters::filled(none);
        let system = tumbler::Prepared::new(&parameters);
        scheme.by_parameters(&system, &at, &mut found);
        let after = scheme.step(&system, &at);
        for (place, name) in tumbler::PARAMETER_NAMES.iter().enumerate() {
            // A tenth of the steps: the values are not much larger than these.
            let expected = derivative(|t| {
                let mut values = parameters.to_array();
                values[place] += 0.1 * t;
                let changed = tumbler::Prepared::new(&tumbler::Parameters::from_array(values));
                seen(&changed, &after, &scheme.step(&changed, &at))
            });
            let rows = found.q.iter().chain(&found.u);
            let column: Vec<f64> = rows.map(|row| 0.1 * row[place]).collect();
            assert_close(
                format!("{name}, {scheme:?}"),
                &column,
                &expected,
                DIFFERENCED,
            );
        }
    }
}

#[test]
fn derivatives_by_the_state_and_by_values_are_the_same_together() {
    let system = tumbler::Prepared::<f64>::nominal();
    let at = drawn(&system, 11, 0.5, 0.1);
    for scheme in Scheme::ALL {
        let mut alone = StepDerivatives::filled([[f64::NAN; 10]; 10]);
        let mut by_values = StepByParameters::filled([[f64::NAN; 2]; 10]);
        let after = scheme.linearized(&system, &at, &mut alone);
        scheme.by_parameters(&system, &at, &mut by_values);
        let mut together = StepDerivatives::filled([[f64::NAN; 10]; 10]);
        let mut values_too = StepByParameters::filled([[f64::NAN; 2]; 10]);
        let both = (&mut together, &mut values_too);
        let after_both = scheme.linearized_and_by_parameters(&system, &at, both);
        assert_eq!(after_both, after, "{scheme:?}");
        assert_eq!(together, alone, "{scheme:?}");
        for (found, alone) in [(values_too.q, by_values.q), (values_too.u, by_values.u)] {
            // Alone, `euler` moves by `forward_dynamics`, whose operations come in another order.
            assert_close(
                format!("{scheme:?}"),
                found.as_flattened(),
                alone.as_flattened(),
                ROUNDED,
            );
        }
    }
}

#[test]
fn the_steps_are_of_first_and_fourth_order_on_the_manifold() {
    let system = tumbler::Prepared::<f64>::nominal();
    let at = drawn(&system, 9, 0.5, 0.0);
    let after = |scheme: Scheme, n: i32| {
        let mut own = Driven {
            dt: 0.2 / f64::from(n),
            ..at
        };
        for _ in 0..n {
            (own.q, own.u) = scheme.step(&system, &own);
        }
        (own.q, own.u)
    };
    let (mut q, mut u) = (at.q, at.u);
    for _ in 0..2000 {
        rk4_step(&system, &at.tau, 1e-4, &mut q, &mut u);
    }
    for (scheme, n, order) in [(Scheme::Euler, 200, 1), (Scheme::Rk4, 10, 4)] {
        let error = |n: i32| {
            let away = seen(&system, &(q, u), &after(scheme, n));
            dot(&away, &away).sqrt()
        };
        // Twice as many steps: the error falls by two to the order, but for higher orders' share.
        let falls = (error(n) / error(2 * n)).log2();
        assert_close(
            format!("{scheme:?}"),
            &[falls],
            &[f64::from(order)],
            Tolerance::absolute(0.3),
        );
    }
}

#[test]
fn where_speeds_are_rates_the_step_is_the_ordinary_one() {
    let system = panda::Prepared::<f64>::nominal();
    let at = drawn(&system, 10, 20.0, 0.01);
    let (mut q, mut u) = (at.q, at.u);
    rk4_step(&system, &at.tau, at.dt, &mut q, &mut u);
    let found = Scheme::Rk4.step(&system, &at);
    assert_close("q", &found.0, &q, ROUNDED);
    assert_close("u", &found.1, &u, ROUNDED);
}

#[test]
fn products_along_values_set_at_run_time_are_those_with_whole_derivatives() {
    let system = tumbler::Prepared::<f64>::nominal();
    let at = drawn(&system, 12, 0.5, 0.1);
    let mut random = Random::new(13);
    for scheme in Scheme::ALL {
        let what = format!("{scheme:?}");
        let mut by_values = StepByParameters::filled([[f64::NAN; 2]; 10]);
        scheme.by_parameters(&system, &at, &mut by_values);
        let rows: Vec<[f64; 2]> = by_values.q.into_iter().chain(by_values.u).collect();
        let along = random_change(&mut random);
        let values = [random.symmetric(), random.symmetric()];
        let (_, _, alone) = scheme.forward(&system, &at, along);
        let expected: Vec<f64> = flat(&alone)
            .iter()
            .zip(&rows)
            .map(|(change, row)| change + dot(row, &values))
            .collect();
        let found = scheme.forward_with_parameters(&system, &at, (along.0, along.1, values));
        assert_close(&what, &flat(&found), &expected, ROUNDED);
        let (multiplier, _) = random_change(&mut random);
        let (before, of_tau) = scheme.adjoint(&system, &at, multiplier);
        let (found, found_of_tau, of_values) =
            scheme.adjoint_with_parameters(&system, &at, multiplier);
        assert_close(&what, &flat(&found), &flat(&before), ROUNDED);
        assert_close(&what, &found_of_tau, &of_tau, ROUNDED);
        let weights = flat(&multiplier);
        let expected = [0, 1].map(|value| {
            let column: Vec<f64> = rows.iter().map(|row| row[value]).collect();
            dot(&column, &weights)
        });
        assert_close(&what, &of_values, &expected, ROUNDED);
    }
}
