//! Identities of energies and momenta, most of them differentiated by finite differences.

use kane_codegen::tree::Orientation;

use super::{
    model::Model,
    quantities::{gravity, mass_matrix, matrices, vectors, worst},
    state::State,
    topology::{floats, root_speeds},
};
use crate::{
    compare::{larger, largest, relative, relative_to},
    numeric::{derivative, dot},
    rotation::{cross, scaled, sum, times, transposed},
};

/// What dampers need at every speed.
fn damping(model: &dyn Model, state: &State) -> Vec<f64> {
    let mut damping = vec![0.0; state.u.len()];
    for acting in model.composition().acting() {
        let (speed, [_, damper, _]) = acting.needed(state);
        damping[speed] += damper;
    }
    damping
}

/// `d(T + V)/dt = tau u + sum_K F_K v_K + M_K w_K`, less what dampers take, along a motion that the forces and loads make.
pub fn power_is_the_rate_of_energy(model: &dyn Model, state: &State) -> f64 {
    let energy = |t: f64| {
        let state = state.moved(model.tree(), t);
        let mut energy = model.evaluate("kinetic_energy", &state);
        energy.extend(model.evaluate("potential_energy", &state));
        energy
    };
    let rates = derivative(energy);
    // What is left of the forces after the loads have done their part.
    let loads = model.evaluate("generalized_forces", state);
    let needed = model.evaluate("inverse_dynamics", state);
    let tau: Vec<f64> = needed
        .iter()
        .zip(&loads)
        .map(|(needed, load)| needed - load)
        .collect();
    let velocities = vectors(model, "mass_center_velocity", state);
    let omegas = vectors(model, "angular_velocity", state);
    let by_loads: Vec<f64> = state
        .loads
        .iter()
        .zip(velocities.iter().zip(&omegas))
        .map(|(load, (v, w))| dot(&load[..3], v) + dot(&load[3..], w))
        .collect();
    let by_tau: Vec<f64> = tau.iter().zip(&state.u).map(|(tau, u)| tau * u).collect();
    let taken = dot(&damping(model, state), &state.u);
    let power = by_tau.iter().sum::<f64>() + by_loads.iter().sum::<f64>() - taken;
    let scale = worst([
        largest(&by_loads),
        largest(&by_tau),
        taken,
        largest(&energy(0.0)),
    ]);
    relative_to(scale, &[rates[0] + rates[1]], &[power])
}

/// Lagrange, speeds held: `bias = d(M u)/dt - dT/dq + dV/dq` and dampers; for the components of an angular velocity, whose
/// coordinates move as these do one by one, also `w x dT/dw` (Hamel).
pub fn bias_follows_from_the_energies(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let steady = State {
        u_dot: vec![0.0; state.u.len()],
        ..state.clone()
    };
    let momenta = |t: f64| mass_matrix(model, &steady.moved(tree, t)).times(&state.u);
    let energies = |state: &State| {
        [
            model.evaluate("kinetic_energy", state)[0],
            model.evaluate("potential_energy", state)[0],
        ]
    };
    let gradient = |speed| derivative(|t| energies(&state.displaced(tree, speed, t)).to_vec());
    let mut expected = derivative(momenta);
    for (speed, expected) in expected.iter_mut().enumerate() {
        let [kinetic, potential] = gradient(speed)[..] else {
            unreachable!("two energies")
        };
        *expected += potential - kinetic;
    }
    for (expected, damping) in expected.iter_mut().zip(damping(model, state)) {
        *expected += damping;
    }
    let p = momenta(0.0);
    for body in &tree.bodies {
        if let Orientation::AngularVelocity { speeds, .. } = body.joint.orientation {
            let of = |numbers: &[f64]| speeds.map(|speed| numbers[speed.index()]);
            let turning = cross(of(&state.u), of(&p));
            for (speed, turning) in speeds.into_iter().zip(turning) {
                expected[speed.index()] += turning;
            }
        }
    }
    let bias = model.evaluate("bias", state);
    let scale = worst([largest(&bias), largest(&p), largest(&energies(state))]);
    relative_to(scale, &bias, &expected)
}

/// `bias = dV/dq` at rest.
pub fn bias_at_rest_is_the_gradient_of_potential_energy(model: &dyn Model, state: &State) -> f64 {
    let rest = State {
        u: vec![0.0; state.u.len()],
        ..state.clone()
    };
    let energy = |state: &State| model.evaluate("potential_energy", state);
    let gradient: Vec<f64> = (0..state.u.len())
        .flat_map(|speed| derivative(|t| energy(&rest.displaced(model.tree(), speed, t))))
        .collect();
    relative_to(
        larger(largest(&gradient), energy(&rest)[0].abs()),
        &model.evaluate("bias", &rest),
        &gradient,
    )
}

/// `T = u M u / 2 = sum_K (m v_K v_K + w_K I w_K) / 2` and rotors, `p = sum_K m v_K`, `h = sum_K r_K x m v_K + I w_K` and
/// `V = -sum_K m g r_K` and springs, in inertial components.
pub fn energies_and_momenta_are_sums_over_bodies(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let rotations = matrices(model, "rotation", state);
    let positions = vectors(model, "mass_center_position", state);
    let velocities = vectors(model, "mass_center_velocity", state);
    let omegas = vectors(model, "angular_velocity", state);
    let (mut kinetic, mut potential) = (0.0, 0.0);
    let (mut linear, mut angular) = ([0.0; 3], [0.0; 3]);
    let mut most = [0.0_f64; 3];
    for (k, solid) in model.composition().solids().iter().enumerate() {
        let (m, turn) = (solid.mass, transposed(&rotations[k]));
        let h = times(&solid.inertia, omegas[k]);
        let (p, r) = (
            scaled(m, times(&turn, velocities[k])),
            times(&turn, positions[k]),
        );
        kinetic += 0.5 * (m * dot(&velocities[k], &velocities[k]) + dot(&h, &omegas[k]));
        potential += solid.potential(times(&rotations[k], gravity(tree)), positions[k]);
        linear = sum(linear, p);
        angular = sum(angular, sum(cross(r, p), times(&turn, h)));
        most[0] = larger(most[0], m * largest(&gravity(tree)) * largest(&r));
        most[1] = larger(most[1], largest(&p));
        most[2] = larger(most[2], larger(largest(&p) * largest(&r), largest(&h)));
    }
    for acting in model.composition().acting() {
        let [rotor, spring] = acting.energies(state);
        kinetic += rotor;
        potential += spring;
        most[0] = larger(most[0], spring.abs());
    }
    let quadratic = 0.5 * dot(&state.u, &mass_matrix(model, state).times(&state.u));
    let of = |function| model.evaluate(function, state);
    worst([
        relative(&of("kinetic_energy"), &[kinetic]),
        relative(&of("kinetic_energy"), &[quadratic]),
        relative_to(most[0], &of("potential_energy"), &[potential]),
        relative_to(most[1], &of("linear_momentum"), &linear),
        relative_to(most[2], &of("angular_momentum"), &angular),
    ])
}

/// `T_K = (m v_K v_K + w_K I w_K) / 2` and rotors, `V_K = -m g r_K` and springs, whose sums are those of the whole.
pub fn energies_by_body_are_those_of_bodies(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let rotations = matrices(model, "rotation", state);
    let positions = vectors(model, "mass_center_position", state);
    let velocities = vectors(model, "mass_center_velocity", state);
    let omegas = vectors(model, "angular_velocity", state);
    let (mut kinetic, mut potential) = (Vec::new(), Vec::new());
    let mut most = 0.0_f64;
    for (k, solid) in model.composition().solids().iter().enumerate() {
        let (m, g) = (solid.mass, times(&rotations[k], gravity(tree)));
        let h = times(&solid.inertia, omegas[k]);
        kinetic.push(0.5 * (m * dot(&velocities[k], &velocities[k]) + dot(&h, &omegas[k])));
        potential.push(solid.potential(g, positions[k]));
        most = larger(most, m * largest(&g) * largest(&positions[k]));
    }
    for acting in model.composition().acting() {
        let [rotor, spring] = acting.energies(state);
        let body = acting.body().index();
        kinetic[body] += rotor;
        potential[body] += spring;
        most = larger(most, spring.abs());
    }
    let of = |function| model.evaluate(function, state);
    let sum = |energies: &[f64]| [energies.iter().sum::<f64>()];
    worst([
        relative(&of("kinetic_energies"), &kinetic),
        relative_to(most, &of("potential_energies"), &potential),
        relative(&sum(&of("kinetic_energies")), &of("kinetic_energy")),
        relative_to(
            most,
            &sum(&of("potential_energies")),
            &of("potential_energy"),
        ),
    ])
}

/// Where nothing holds the tree: the rates of linear and angular momentum are the resultant of weight and loads, whatever
/// the joints do, springs, dampers, rotors and what follows what with them; where there is neither, both are conserved.
/// Along the motion that forward dynamics gives.
pub fn momenta_of_a_floating_tree_change_by_external_loads(
    model: &dyn Model,
    state: &State,
) -> f64 {
    let tree = model.tree();
    if !floats(model.composition()) {
        return 0.0;
    }
    worst([true, false].map(|loaded| {
        let mut state = state.clone();
        if !loaded {
            state.loads.fill([0.0; 6]);
        }
        // The joints' forces: all but those between a root and the inertial frame, which undo springs and dampers there.
        for speed in root_speeds(tree) {
            state.tau[speed] = 0.0;
        }
        for acting in model.composition().acting() {
            let (speed, [_, damper, spring]) = acting.needed(&state);
            if root_speeds(tree).any(|root| root == speed) {
                state.tau[speed] += damper + spring;
            }
        }
        let loads = model.evaluate("generalized_forces", &state);
        state
            .tau
            .iter_mut()
            .zip(&loads)
            .for_each(|(tau, load)| *tau += load);
        state.u_dot = model.evaluate("forward_dynamics", &state);
        momentum_error(model, &state)
    }))
}

fn momentum_error(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let rotations = matrices(model, "rotation", state);
    let positions = vectors(model, "mass_center_position", state);
    let accelerations = vectors(model, "mass_center_acceleration", state);
    let alphas = vectors(model, "angular_acceleration", state);
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    let mut most = [0.0_f64; 2];
    for (k, solid) in model.composition().solids().iter().enumerate() {
        let (turn, m) = (transposed(&rotations[k]), solid.mass);
        let load = state.loads[k];
        let g = times(&rotations[k], gravity(tree));
        let [weight, around] = solid.weight(g).map(|part| times(&turn, part));
        let f = sum(times(&turn, [load[0], load[1], load[2]]), weight);
        let r = times(&turn, positions[k]);
        force = sum(force, f);
        moment = sum(
            moment,
            sum(cross(r, f), times(&turn, [load[3], load[4], load[5]])),
        );
        moment = sum(moment, around);
        let inertial = m * largest(&accelerations[k]) + largest(&f);
        most[0] = larger(most[0], inertial);
        let turning = largest(&times(&solid.inertia, alphas[k]));
        most[1] = larger(most[1], larger(inertial * largest(&r), turning));
    }
    let momenta = |function: &str| {
        let momentum = |t: f64| model.evaluate(function, &state.moved(tree, t));
        (derivative(momentum), largest(&momentum(0.0)))
    };
    let (linear, p) = momenta("linear_momentum");
    let (angular, h) = momenta("angular_momentum");
    worst([
        relative_to(larger(most[0], p), &linear, &force),
        relative_to(larger(most[1], h), &angular, &moment),
    ])
}
