//! Identities of systems on which loads act.

use super::{
    model::Model,
    quantities::{gravity, mass_matrix, matrices, vectors, worst},
    state::State,
};
use crate::{
    compare::{larger, largest, relative_to, size_of},
    rotation::{Vector, cross, dot, scaled, sum, times, transposed},
};

/// `loaded_inverse_dynamics = inverse_dynamics - generalized_forces`.
pub fn loads_take_their_generalized_forces_off(model: &dyn Model, state: &State) -> f64 {
    let needed = model.evaluate("inverse_dynamics", state);
    let loads = model.evaluate("generalized_forces", state);
    let expected: Vec<f64> = needed.iter().zip(&loads).map(|(a, b)| a - b).collect();
    let scale = larger(largest(&needed), largest(&loads));
    relative_to(
        larger(scale, mass_matrix(model, state).norm()),
        &model.evaluate("loaded_inverse_dynamics", state),
        &expected,
    )
}

/// `loaded_forward_dynamics(loaded_inverse_dynamics(u_dot)) = u_dot`, as
/// [`forward_dynamics_undoes_inverse_dynamics`](super::forces::forward_dynamics_undoes_inverse_dynamics) has it.
pub fn loaded_forward_dynamics_undoes_loaded_inverse_dynamics(
    model: &dyn Model,
    state: &State,
) -> f64 {
    let m = mass_matrix(model, state);
    let given = State {
        tau: model.evaluate("loaded_inverse_dynamics", state),
        ..state.clone()
    };
    let u_dot = model.evaluate("loaded_forward_dynamics", &given);
    let left: Vec<f64> = u_dot.iter().zip(&state.u_dot).map(|(a, b)| a - b).collect();
    let bias = largest(&model.evaluate("bias", state));
    let loads = largest(&model.evaluate("generalized_forces", state));
    size_of(m.norm() + bias + loads, &m.times(&left))
}

/// Where joints sit, and what they transmit there, inertial components.
struct Transmitted {
    /// From the inertial origin.
    points: Vec<Vector>,
    forces: Vec<Vector>,
    moments: Vec<Vector>,
}

impl Transmitted {
    fn new(model: &dyn Model, state: &State) -> Self {
        let tree = model.tree();
        let placed = model.composition().placed(&state.q);
        let wrenches = vectors(model, "joint_wrenches", state);
        let (forces, moments) = wrenches.split_at(tree.bodies.len());
        let at = |body: usize| placed[tree.bodies[body].user_number - 1];
        let turned = |parts: &[Vector]| -> Vec<Vector> {
            let parts = parts.iter().enumerate();
            let turn =
                |(body, part): (usize, &Vector)| times(&transposed(&at(body).rotation), *part);
            parts.map(turn).collect()
        };
        let point = |body: usize| {
            let own = model
                .composition()
                .joint_point(tree.bodies[body].user_number - 1);
            let own = times(&transposed(&at(body).rotation), own);
            sum(at(body).origin, own)
        };
        Self {
            points: (0..tree.bodies.len()).map(point).collect(),
            forces: turned(forces),
            moments: turned(moments),
        }
    }
}

/// Newton and Euler of each body: what its joint transmits, less what its upper bodies' joints take on, its load and its
/// weight are `m a` and `I alpha + w x I w`.
pub fn joint_wrenches_balance_bodies(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let Transmitted {
        points,
        forces,
        moments,
    } = Transmitted::new(model, state);
    let of = |function| vectors(model, function, state);
    let rotations = matrices(model, "rotation", state);
    let (positions, accelerations) = (of("mass_center_position"), of("mass_center_acceleration"));
    let (omegas, alphas) = (of("angular_velocity"), of("angular_acceleration"));
    let reach = largest(points.as_flattened());
    let size = larger(
        largest(forces.as_flattened()),
        largest(moments.as_flattened()),
    );
    let errors = model
        .composition()
        .solids()
        .into_iter()
        .enumerate()
        .map(|(k, solid)| {
            let back = transposed(&rotations[k]);
            let center = times(&back, positions[k]);
            let [fx, fy, fz, nx, ny, nz] = state.loads[k];
            let i = &solid.inertia;
            let spin = sum(times(i, alphas[k]), cross(omegas[k], times(i, omegas[k])));
            let weight = solid.weight(times(&rotations[k], gravity(tree)));
            let [weight, around] = weight.map(|part| scaled(-1.0, times(&back, part)));
            let needed = sum(scaled(solid.mass, times(&back, accelerations[k])), weight);
            let mut force = sum(times(&back, [fx, fy, fz]), scaled(-1.0, needed));
            let mut moment = times(&back, sum([nx, ny, nz], scaled(-1.0, spin)));
            moment = sum(moment, scaled(-1.0, around));
            let mut add = |joint: usize, sign: f64| {
                let lever = sum(points[joint], scaled(-1.0, center));
                force = sum(force, scaled(sign, forces[joint]));
                let turning = sum(moments[joint], cross(lever, forces[joint]));
                moment = sum(moment, scaled(sign, turning));
            };
            add(k, 1.0);
            for upper in &tree.bodies[k].uppers {
                add(upper.index(), -1.0);
            }
            let reach = larger(reach, largest(&center));
            let scale = larger(size, larger(largest(&needed), largest(&spin))) * larger(reach, 1.0);
            size_of(larger(scale, 1.0), &[force, moment].concat())
        });
    worst(errors)
}

/// For each speed: what the joints transmit does the work of `tau` less what springs, dampers and rotors need.
pub fn joint_wrenches_along_motions_are_the_forces(model: &dyn Model, state: &State) -> f64 {
    let tree = model.tree();
    let transmitted = Transmitted::new(model, state);
    let rotations = matrices(model, "rotation", state);
    let centers = vectors(model, "mass_center_position", state);
    let mut expected = model.evaluate("loaded_inverse_dynamics", state);
    for acting in model.composition().acting() {
        let (speed, forces) = acting.needed(state);
        expected[speed] -= forces.iter().sum::<f64>();
    }
    let mut most = largest(&expected);
    let mut found = Vec::new();
    for speed in 0..tree.n_speeds {
        let mut unit = state.clone();
        unit.u.fill(0.0);
        unit.u[speed] = 1.0;
        let velocities = vectors(model, "mass_center_velocity", &unit);
        let omegas = vectors(model, "angular_velocity", &unit);
        // Angular velocity, and the velocity of a point.
        let moving = |body: usize, point: Vector| {
            let back = transposed(&rotations[body]);
            let w = times(&back, omegas[body]);
            let lever = sum(point, scaled(-1.0, times(&back, centers[body])));
            [w, sum(times(&back, velocities[body]), cross(w, lever))]
        };
        let mut power = 0.0;
        for body in tree.body_ids() {
            let (k, point) = (body.index(), transmitted.points[body.index()]);
            let lower = tree.lower(body).map(|lower| moving(lower.index(), point));
            let [w_lower, v_lower] = lower.unwrap_or_default();
            let [w, v] = moving(k, point);
            let (force, moment) = (transmitted.forces[k], transmitted.moments[k]);
            let [w, v] = [sum(w, scaled(-1.0, w_lower)), sum(v, scaled(-1.0, v_lower))];
            power += dot(force, v) + dot(moment, w);
            most = larger(most, largest(&force) * largest(&v_lower));
            most = larger(most, largest(&moment) * largest(&w_lower));
        }
        found.push(power);
    }
    relative_to(most, &found, &expected)
}
