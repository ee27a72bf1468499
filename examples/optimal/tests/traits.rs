//! Generic code holds derivatives by their traits, and what these give belongs together.

use kane::functions::{
    ForwardDynamicsAndDerivatives, ForwardDynamicsByParameters, ForwardDynamicsDerivatives,
    ForwardDynamicsJvp, ForwardDynamicsParametersJvp, ForwardDynamicsParametersVjp,
    ForwardDynamicsVjp, InverseDynamicsAndDerivatives, InverseDynamicsByParameters,
    InverseDynamicsDerivatives, InverseDynamicsJvp, InverseDynamicsParametersJvp,
    InverseDynamicsParametersVjp, InverseDynamicsVjp,
};
use kane::{Array, Parametric};
use kane_optimal::cart_pole;
use kane_test_support::compare::{Tolerance, assert_close};

/// Rounding of some dozens of operations on numbers below a hundred.
const ROUNDED: Tolerance = Tolerance::absolute(1e-12);

/// Of one function: by `q`, by `u` and by the third argument, by parameters; joined; and products.
struct Found<S: Parametric<f64>> {
    whole: [S::Matrix; 3],
    joined: [S::Matrix; 3],
    by_parameters: S::ByParameters,
    along: [S::U; 2],
    back: [[S::U; 3]; 2],
    parameters_back: S::Values,
}

fn zero<A: Array<f64>>() -> A {
    A::filled(0.0)
}

fn matrix<U: Array<f64>, M: Array<U>>() -> M {
    M::filled(zero())
}

/// A number a place, the same wherever it is asked for.
fn given<A: Array<f64>>(seed: u8) -> A {
    let number = |place: usize| place as f64 * 1.7 + f64::from(seed);
    A::from_fn(|place| kane::Real::sin_cos(number(place)).0)
}

/// Everything of forward dynamics, for a system of which nothing else is known.
fn forward<S>(system: &S) -> Found<S>
where
    S: ForwardDynamicsDerivatives<f64>
        + ForwardDynamicsAndDerivatives<f64>
        + ForwardDynamicsByParameters<f64>
        + ForwardDynamicsJvp<f64>
        + ForwardDynamicsParametersJvp<f64>
        + ForwardDynamicsVjp<f64>
        + ForwardDynamicsParametersVjp<f64>,
{
    let (q, u, tau) = (given(1), given(2), given(3));
    let (dq, du, dtau): (S::U, S::U, S::U) = (given(4), given(5), given(6));
    let (values, weights) = (given(7), given(8));
    let mut found = Found {
        whole: [matrix(); 3],
        joined: [matrix(); 3],
        by_parameters: matrix(),
        along: [zero(); 2],
        back: [[zero(); 3]; 2],
        parameters_back: zero(),
    };
    let [a, b, c] = &mut found.whole;
    system.d_forward_dynamics_d_q_u_tau(&q, &u, &tau, a, b, c);
    let [a, b, c] = &mut found.joined;
    let mut u_dot = zero();
    system.forward_dynamics_and_d_forward_dynamics_d_q_u_tau(&q, &u, &tau, &mut u_dot, a, b, c);
    system.d_forward_dynamics_d_parameters(&q, &u, &tau, &mut found.by_parameters);
    let [a, b] = &mut found.along;
    system.jvp_forward_dynamics_q_u_tau(&q, &u, &tau, &dq, &du, &dtau, a);
    system.jvp_forward_dynamics_q_u_tau_parameters(&q, &u, &tau, &dq, &du, &dtau, &values, b);
    let [[a, b, c], [d, e, f]] = &mut found.back;
    system.vjp_forward_dynamics_q_u_tau(&q, &u, &tau, &weights, a, b, c);
    let last = &mut found.parameters_back;
    system.vjp_forward_dynamics_q_u_tau_parameters(&q, &u, &tau, &weights, d, e, f, last);
    found
}

/// Everything of inverse dynamics.
fn inverse<S>(system: &S) -> Found<S>
where
    S: InverseDynamicsDerivatives<f64>
        + InverseDynamicsAndDerivatives<f64>
        + InverseDynamicsByParameters<f64>
        + InverseDynamicsJvp<f64>
        + InverseDynamicsParametersJvp<f64>
        + InverseDynamicsVjp<f64>
        + InverseDynamicsParametersVjp<f64>,
{
    let (q, u, u_dot) = (given(1), given(2), given(3));
    let (dq, du, du_dot): (S::U, S::U, S::U) = (given(4), given(5), given(6));
    let (values, weights) = (given(7), given(8));
    let mut found = Found {
        whole: [matrix(); 3],
        joined: [matrix(); 3],
        by_parameters: matrix(),
        along: [zero(); 2],
        back: [[zero(); 3]; 2],
        parameters_back: zero(),
    };
    let [a, b, c] = &mut found.whole;
    system.d_inverse_dynamics_d_q_u_u_dot(&q, &u, &u_dot, a, b, c);
    let [a, b, c] = &mut found.joined;
    let mut tau = zero();
    system.inverse_dynamics_and_d_inverse_dynamics_d_q_u_u_dot(&q, &u, &u_dot, &mut tau, a, b, c);
    system.d_inverse_dynamics_d_parameters(&q, &u, &u_dot, &mut found.by_parameters);
    let [a, b] = &mut found.along;
    system.jvp_inverse_dynamics_q_u_u_dot(&q, &u, &u_dot, &dq, &du, &du_dot, a);
    system.jvp_inverse_dynamics_q_u_u_dot_parameters(&q, &u, &u_dot, &dq, &du, &du_dot, &values, b);
    let [[a, b, c], [d, e, f]] = &mut found.back;
    system.vjp_inverse_dynamics_q_u_u_dot(&q, &u, &u_dot, &weights, a, b, c);
    let last = &mut found.parameters_back;
    system.vjp_inverse_dynamics_q_u_u_dot_parameters(&q, &u, &u_dot, &weights, d, e, f, last);
    found
}

type CartPole = cart_pole::Prepared<f64>;

/// Holds the products against those with the matrices.
fn belongs_together(what: &str, found: &Found<CartPole>) {
    let flat = |matrices: &[[[f64; 2]; 2]; 3]| matrices.as_flattened().as_flattened().to_vec();
    assert_close(what, &flat(&found.joined), &flat(&found.whole), ROUNDED);
    let directions: [[f64; 2]; 3] = [given(4), given(5), given(6)];
    let (values, weights): ([f64; 1], [f64; 2]) = (given(7), given(8));
    let mut along = [0.0; 2];
    let mut back = [[0.0; 2]; 3];
    for (place, (matrix, direction)) in found.whole.iter().zip(directions).enumerate() {
        for row in 0..2 {
            for column in 0..2 {
                along[row] += matrix[row][column] * direction[column];
                back[place][column] += matrix[row][column] * weights[row];
            }
        }
    }
    let by_parameters = found.by_parameters.as_flattened();
    let with_values = [0, 1].map(|row| along[row] + by_parameters[row] * values[0]);
    assert_close(what, &found.along[0], &along, ROUNDED);
    assert_close(what, &found.along[1], &with_values, ROUNDED);
    for found in &found.back {
        assert_close(what, found.as_flattened(), back.as_flattened(), ROUNDED);
    }
    let of_values = by_parameters[0] * weights[0] + by_parameters[1] * weights[1];
    assert_close(what, &found.parameters_back, &[of_values], ROUNDED);
}

#[test]
fn every_trait_is_held_and_products_are_those_with_the_matrices() {
    let system = CartPole::nominal();
    belongs_together("forward", &forward(&system));
    belongs_together("inverse", &inverse(&system));
}

#[test]
fn values_as_an_array_make_the_system_that_the_parameters_make() {
    assert_eq!(
        <CartPole as Parametric<f64>>::PARAMETER_NAMES,
        ["pole_mass"]
    );
    let nominal = cart_pole::Parameters::<f64>::default();
    assert_eq!(CartPole::nominal_values(), [nominal.pole_mass]);
    let heavier = cart_pole::Parameters { pole_mass: 0.7 };
    assert_eq!(CartPole::with_values(&[0.7]), CartPole::new(&heavier));
    assert_ne!(CartPole::with_values(&[0.7]), CartPole::nominal());
}
