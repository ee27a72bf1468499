//! One system, described in two ways: other charts and speeds, frames turned on both sides of a joint, bodies that are fixed
//! merged by hand, joints that follow others projected out by hand. On random trees, through the programs that would be
//! emitted.
//!
//! Where the speeds of the one are `T` times those of the other, `u_b = T u_a`, so are its partial velocities, and its mass
//! matrix and forces are projected: `M_a = T^T M_b T`, `tau_a = T^T tau_b`.
#![allow(
    clippy::print_stdout,
    reason = "the largest errors found, shown with --nocapture"
)]

mod dynamics;
mod evaluator;

use dynamics::{
    Maps, Model, State,
    identities::{self, DIFFERENTIATED, EXACT, rows},
    numeric::{derivative, dot, largest, relative_to},
    random::{
        Random, RandomSystem, Sizes, Style,
        rotation::{IDENTITY, Rotation, quaternion_of, rate_columns, times},
        tree,
    },
};
use evaluator::Evaluator;
use kane_codegen::{
    functions::Formulation,
    id::{BodyId, CoordinateId, SpeedId},
    tree::{Body, ChartCoordinates as Chart, Orientation, Tree},
};

const SEEDS: std::ops::RangeInclusive<u64> = 401..=440;

/// 2 to 11 bodies, each number with four seeds.
fn system(seed: u64) -> RandomSystem {
    let bodies = usize::try_from(2 + seed % 10).expect("at most 11");
    RandomSystem::new(seed, Sizes { bodies, speeds: 24 }, Style::Framed)
}

/// The state of one of two descriptions in terms of that of the other: rows over its speeds, columns over the other's.
struct Mapped {
    q: Vec<f64>,
    t: Vec<Vec<f64>>,
    t_dot: Vec<Vec<f64>>,
}

impl Mapped {
    fn new(a: &Tree, b: &Tree) -> Self {
        let zero = vec![vec![0.0; a.n_speeds]; b.n_speeds];
        Self {
            q: vec![0.0; b.n_coordinates],
            t: zero.clone(),
            t_dot: zero,
        }
    }

    /// A coordinate and a speed that are the same in both.
    fn copy(&mut self, q: &[f64], (a, b): (&[usize; 2], &[usize; 2])) {
        self.q[b[0]] = q[a[0]];
        self.t[b[1]][a[1]] = 1.0;
    }

    /// Speeds that are turned.
    fn turn(&mut self, turn: &Rotation, (a, b): (&[usize], &[usize])) {
        for (row, b) in turn.iter().zip(b) {
            for (entry, a) in row.iter().zip(a) {
                self.t[*b][*a] = *entry;
            }
        }
    }
}

fn product(t: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
    t.iter().map(|row| dot(row, x)).collect()
}

/// `T^T x`.
fn projected(t: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
    let columns = 0..t.first().map_or(0, Vec::len);
    columns
        .map(|column| t.iter().zip(x).map(|(row, x)| row[column] * x).sum())
        .collect()
}

fn added(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

/// Two descriptions in one state.
struct Pair<'a> {
    a: &'a dyn Model,
    b: &'a dyn Model,
    state: &'a State,
    mapped: &'a Mapped,
    /// For each body of `b` its place in `a`.
    bodies: Vec<usize>,
    tau_b: Vec<f64>,
    /// The largest error, and where it is.
    worst: (f64, &'static str),
}

/// The largest error by which the two break their agreement in a state of the first, and where.
fn disagreement(
    a: &dyn Model,
    b: &dyn Model,
    state: &State,
    mapped: &Mapped,
) -> (f64, &'static str) {
    let mut random = Random::new(7);
    let mut pair = Pair {
        a,
        b,
        state,
        mapped,
        bodies: Maps::of_bodies(a.tree(), b.tree()),
        tau_b: mapped.t.iter().map(|_| random.symmetric()).collect(),
        worst: (0.0, "nothing"),
    };
    pair.compare_bodies();
    pair.compare_partial_velocities();
    pair.compare_forces();
    pair.worst
}

impl Pair<'_> {
    fn note(&mut self, function: &'static str, scale: f64, found: &[f64], expected: &[f64]) {
        let error = relative_to(scale, found, expected);
        if error > self.worst.0 || error.is_nan() {
            self.worst = (error, function);
        }
    }

    /// Both states, for accelerations of `a`.
    fn states(&self, u_dot: &[f64]) -> [State; 2] {
        let (t, state) = (&self.mapped.t, self.state);
        let state_a = State {
            u_dot: u_dot.to_vec(),
            tau: projected(t, &self.tau_b),
            ..state.clone()
        };
        let state_b = State {
            q: self.mapped.q.clone(),
            u: product(t, &state.u),
            u_dot: added(&product(t, u_dot), &product(&self.mapped.t_dot, &state.u)),
            tau: self.tau_b.clone(),
            loads: self.bodies.iter().map(|&at| state.loads[at]).collect(),
            w_rel: self.bodies.iter().map(|&at| state.w_rel[at]).collect(),
        };
        [state_a, state_b]
    }

    fn compare_bodies(&mut self) {
        let [state_a, state_b] = self.states(&self.state.u_dot);
        for (function, width) in [
            ("rotation", 9),
            ("relative_rotation", 9),
            ("origin_position", 3),
            ("mass_center_position", 3),
            ("angular_velocity", 3),
            ("relative_angular_velocity", 3),
            ("origin_velocity", 3),
            ("mass_center_velocity", 3),
            ("angular_acceleration", 3),
            ("mass_center_acceleration", 3),
        ] {
            let of_a = self.a.evaluate(function, &state_a);
            let of_a: Vec<f64> = self
                .bodies
                .iter()
                .flat_map(|&body| &of_a[body * width..][..width])
                .copied()
                .collect();
            let of_b = self.b.evaluate(function, &state_b);
            self.note(function, largest(&of_b).max(1.0), &of_a, &of_b);
        }
        for function in [
            "kinetic_energy",
            "potential_energy",
            "linear_momentum",
            "angular_momentum",
        ] {
            let of_a = self.a.evaluate(function, &state_a);
            let of_b = self.b.evaluate(function, &state_b);
            self.note(function, largest(&of_b).max(1.0), &of_a, &of_b);
        }
    }

    fn compare_partial_velocities(&mut self) {
        let [state_a, state_b] = self.states(&self.state.u_dot);
        let (t, t_dot) = (&self.mapped.t, &self.mapped.t_dot);
        let places: Vec<(usize, usize)> = self
            .bodies
            .iter()
            .enumerate()
            .flat_map(|(body, &place)| (0..3).map(move |axis| (3 * place + axis, 3 * body + axis)))
            .collect();
        for [partial, partial_dot] in [
            ["partial_angular_velocity", "partial_angular_velocity_dot"],
            ["partial_velocity_origin", "partial_velocity_origin_dot"],
            ["partial_velocity", "partial_velocity_dot"],
        ] {
            let of_a = [partial, partial_dot].map(|function| rows(self.a, function, &state_a));
            let of_b = [partial, partial_dot].map(|function| rows(self.b, function, &state_b));
            for &(at_a, at_b) in &places {
                let [row, dot] = [&of_b[0][at_b], &of_b[1][at_b]];
                let scale = largest(row).max(1.0);
                self.note(partial, scale, &of_a[0][at_a], &projected(t, row));
                let expected = added(&projected(t, dot), &projected(t_dot, row));
                let scale = scale.max(largest(dot));
                self.note(partial_dot, scale, &of_a[1][at_a], &expected);
            }
        }
    }

    fn compare_forces(&mut self) {
        let t = &self.mapped.t;
        let [state_a, state_b] = self.states(&self.state.u_dot);
        let m_b = identities::mass_matrix(self.b, &state_b);
        let scale = m_b.norm().max(largest(&self.b.evaluate("bias", &state_b)));
        let mut m = Vec::new();
        for column in 0..self.state.u.len() {
            let column: Vec<f64> = t.iter().map(|row| row[column]).collect();
            m.extend(projected(t, &m_b.times(&column)));
        }
        let of_a = |function, state: &State| self.a.evaluate(function, state);
        let of_b = |function, state: &State| projected(t, &self.b.evaluate(function, state));
        let steady = self.states(&vec![0.0; self.state.u.len()]);
        let bias = of_b("inverse_dynamics", &steady[1]);
        let loads = of_b("generalized_forces", &state_b);
        let forcing: Vec<f64> = loads.iter().zip(&bias).map(|(f, bias)| f - bias).collect();
        // The accelerations that forces give to the one leave none of them over in the other, but what holds its followers.
        let u_dot = of_a("forward_dynamics", &state_a);
        let [_, solved] = self.states(&u_dot);
        let mut pairs = vec![
            ("mass_matrix", of_a("mass_matrix", &state_a), m),
            ("bias", of_a("bias", &state_a), bias),
            ("forcing", of_a("forcing", &state_a), forcing),
            (
                "generalized_forces",
                of_a("generalized_forces", &state_a),
                loads,
            ),
            (
                "inverse_dynamics",
                of_a("inverse_dynamics", &state_a),
                of_b("inverse_dynamics", &state_b),
            ),
        ];
        let moved = largest(&u_dot).max(1.0);
        let shrunk = |forces: Vec<f64>| forces.iter().map(|force| force / moved).collect();
        pairs.push((
            "forward_dynamics",
            shrunk(of_b("inverse_dynamics", &solved)),
            shrunk(state_a.tau.clone()),
        ));
        if self.a.tree().n_speeds == self.b.tree().n_speeds {
            let own = self.b.evaluate("forward_dynamics", &state_b);
            let forces = |u_dot: &[f64]| shrunk(m_b.times(u_dot));
            pairs.push(("forward_dynamics", forces(&own), forces(&solved.u_dot)));
        }
        for (function, found, expected) in pairs {
            self.note(function, scale, &found, &expected);
        }
    }
}

/// Requires that two descriptions of one system agree.
fn agree(
    tolerance: f64,
    seed: u64,
    [a, b]: [&RandomSystem; 2],
    mapped: impl Fn(&Evaluator, &Evaluator, &State) -> Mapped,
) -> f64 {
    let [a, b] = [a, b].map(|system| Evaluator::new(system, Formulation::Recursive));
    let state = State::random(a.tree(), seed);
    let mapped = mapped(&a, &b, &state);
    let (error, function) = disagreement(&a, &b, &state, &mapped);
    assert!(
        error <= tolerance,
        "seed {seed}, {function}: off by {error:e}, {tolerance:e} allowed"
    );
    error
}

/// The coordinates of a joint that are no part of an orientation with an angular velocity, each with its speed.
fn plain(tree: &Tree, body: BodyId) -> Vec<[usize; 2]> {
    let joint = &tree.body(body).joint;
    let (coordinates, speeds) = (joint.coordinates(), joint.speeds());
    let skipped = match joint.orientation {
        Orientation::Rates(_) => [0, 0],
        Orientation::AngularVelocity {
            chart: Chart::Angles(_),
            ..
        } => [3, 3],
        Orientation::AngularVelocity { .. } => [4, 3],
    };
    let coordinates = coordinates.into_iter().skip(skipped[0]);
    let speeds = speeds.into_iter().skip(skipped[1]);
    coordinates
        .zip(speeds)
        .map(|((_, coordinate), (_, speed))| [coordinate.index(), speed.index()])
        .collect()
}

/// The speeds of rates become angular velocities, and the angles whatever the other has.
fn to_angular_velocities(a: &Evaluator, b: &Evaluator, state: &State) -> Mapped {
    let mut mapped = Mapped::new(a.tree(), b.tree());
    for body in a.tree().body_ids() {
        let Orientation::AngularVelocity { chart, speeds } = b.tree().body(body).joint.orientation
        else {
            for places in plain(a.tree(), body).iter().zip(&plain(b.tree(), body)) {
                mapped.copy(&state.q, places);
            }
            continue;
        };
        let own = plain(a.tree(), body);
        let angles = [0, 1, 2].map(|i| state.q[own[i][0]]);
        let rates = [0, 1, 2].map(|i| state.u[own[i][1]]);
        let places: Vec<CoordinateId> = match chart {
            Chart::Angles(places) => places.to_vec(),
            Chart::EulerParameters(places) => places.to_vec(),
        };
        let values = match chart {
            Chart::Angles(_) => angles.to_vec(),
            Chart::EulerParameters(_) => quaternion_of(angles).to_vec(),
        };
        for (place, value) in places.into_iter().zip(values) {
            mapped.q[place.index()] = value;
        }
        let columns = |t: f64| {
            let moved = [0, 1, 2].map(|i| angles[i] + t * rates[i]);
            rate_columns(moved)
                .into_iter()
                .flatten()
                .collect::<Vec<f64>>()
        };
        let (now, change) = (columns(0.0), derivative(columns));
        for (column, places) in own.iter().take(3).enumerate() {
            for (row, speed) in speeds.into_iter().enumerate() {
                mapped.t[speed.index()][places[1]] = now[3 * column + row];
                mapped.t_dot[speed.index()][places[1]] = change[3 * column + row];
            }
        }
        for places in own[3..].iter().zip(&plain(b.tree(), body)) {
            mapped.copy(&state.q, places);
        }
    }
    mapped
}

fn is_ball(body: &Body) -> bool {
    matches!(body.joint.orientation, Orientation::AngularVelocity { .. })
}

#[test]
fn bodies_accelerate_alike_in_every_chart() {
    let mut most = 0.0_f64;
    let mut n_compared = 0;
    for seed in SEEDS {
        let system = system(seed).with_free_balls();
        let rates = system.in_chart("angles", "rates");
        let moves = tree(&rates.toml());
        for chart in ["angles", "quaternion"] {
            let other = system.in_chart(chart, "angular_velocity");
            let tree = tree(&other.toml());
            assert_eq!(tree.is_some(), moves.is_some(), "seed {seed}, {chart}");
            // Without its rotor a ball can move no mass.
            let Some(tree) = tree.filter(|tree| tree.bodies.iter().any(is_ball)) else {
                continue;
            };
            assert_eq!(tree.has_quaternions(), chart == "quaternion");
            let pair = [&rates, &other];
            most = most.max(agree(DIFFERENTIATED, seed, pair, to_angular_velocities));
            n_compared += 1;
        }
    }
    println!("largest error {most:e} of {n_compared}");
    assert!(n_compared >= 20, "{n_compared} pairs");
}

/// The same coordinates, but for orientations and translations of joints that turn in every direction, where their frames
/// are turned.
fn to_turned(
    turns: &[Option<Rotation>],
) -> impl Fn(&Evaluator, &Evaluator, &State) -> Mapped + use<'_> {
    |a, b, state| {
        let mut mapped = Mapped::new(a.tree(), b.tree());
        for body in a.tree().body_ids() {
            let [of_a, of_b] = [a, b].map(|model| plain(model.tree(), body));
            let number = a.tree().body(body).name[1..].parse::<usize>();
            let turn = turns[number.expect("b and a number")].unwrap_or(IDENTITY);
            let [joint_a, joint_b] = [a, b].map(|model| &model.tree().body(body).joint);
            let turns = [joint_a, joint_b].map(|joint| match joint.orientation {
                Orientation::AngularVelocity {
                    chart: Chart::EulerParameters(parameters),
                    speeds,
                } => Some((parameters, speeds)),
                _ => None,
            });
            let [Some((e_a, speeds_a)), Some((e_b, speeds_b))] = turns else {
                for places in of_a.iter().zip(&of_b) {
                    mapped.copy(&state.q, places);
                }
                continue;
            };
            let [e0, e1, e2, e3] = e_a.map(|place| state.q[place.index()]);
            let [x, y, z] = times(&turn, [e1, e2, e3]);
            for (place, value) in e_b.into_iter().zip([e0, x, y, z]) {
                mapped.q[place.index()] = value;
            }
            let speeds = |speeds: [SpeedId; 3]| speeds.map(SpeedId::index).to_vec();
            mapped.turn(&turn, (&speeds(speeds_a), &speeds(speeds_b)));
            // All three translations are free, or none, or the joint is not turned.
            let mut shift = [0.0; 3];
            for (shift, [coordinate, _]) in shift.iter_mut().zip(&of_a) {
                *shift = state.q[*coordinate];
            }
            for (shift, [coordinate, _]) in times(&turn, shift).into_iter().zip(&of_b) {
                mapped.q[*coordinate] = shift;
            }
            let speeds = |of: &[[usize; 2]]| of.iter().map(|places| places[1]).collect::<Vec<_>>();
            mapped.turn(&turn, (&speeds(&of_a), &speeds(&of_b)));
        }
        mapped
    }
}

#[test]
fn frames_turned_alike_on_both_sides_change_nothing() {
    let mut most = 0.0_f64;
    let mut n_turned = 0;
    for seed in SEEDS {
        let system = system(seed)
            .with_free_balls()
            .in_chart("quaternion", "angular_velocity");
        let (turned, turns) = system.turned(seed);
        let trees = [&system, &turned].map(|system| tree(&system.toml()));
        assert_eq!(trees[0].is_some(), trees[1].is_some(), "seed {seed}");
        // Without its rotor a ball can move no mass.
        if trees[0].is_some() {
            most = most.max(agree(EXACT, seed, [&system, &turned], to_turned(&turns)));
            n_turned += turns.iter().flatten().count();
        }
    }
    println!("largest error {most:e} with {n_turned} turned joints");
    assert!(n_turned >= 100, "{n_turned} turned joints");
}

#[test]
fn what_is_fixed_is_as_if_merged_by_hand() {
    let mut most = 0.0_f64;
    let (mut n_compared, mut n_runtime) = (0, 0);
    for seed in SEEDS {
        let system = system(seed);
        if !system.has_fixed() {
            continue;
        }
        let given = Evaluator::new(&system, Formulation::Recursive);
        let merged = Evaluator::new(&system.merged(), Formulation::Recursive);
        assert!(merged.tree().frames.len() < given.tree().frames.len());
        let state = State::random(given.tree(), seed);
        let (error, function) = identities::disagreement(&given, &merged, |_| true, &state);
        assert!(error <= EXACT, "seed {seed}, {function}: {error:e}");
        most = most.max(error);
        n_compared += 1;
        n_runtime += usize::from(!given.tree().parameters.is_empty());
    }
    println!("largest error {most:e} of {n_compared}, {n_runtime} with runtime values");
    assert!(
        n_compared >= 15 && n_runtime >= 5,
        "{n_compared}, {n_runtime}"
    );
}

/// A joint that follows another has a coordinate of its own in the other description.
fn to_freed(a: &Evaluator, b: &Evaluator, state: &State) -> Mapped {
    let mut mapped = Mapped::new(a.tree(), b.tree());
    for body in a.tree().body_ids() {
        for places in plain(a.tree(), body).iter().zip(&plain(b.tree(), body)) {
            mapped.copy(&state.q, places);
        }
        let [of_a, of_b] = [a, b].map(|model| &model.tree().body(body).joint);
        if is_ball(a.tree().body(body)) {
            let coordinates = of_a.coordinates().into_iter().zip(of_b.coordinates());
            for ((_, coordinate), (_, coordinate_b)) in coordinates {
                mapped.q[coordinate_b.index()] = state.q[coordinate.index()];
            }
            for ((_, speed), (_, speed_b)) in of_a.speeds().into_iter().zip(of_b.speeds()) {
                mapped.t[speed_b.index()][speed.index()] = 1.0;
            }
        }
    }
    for (place, body) in a.composition().followers() {
        let link = a.composition().link(place);
        let [coordinate, speed] = plain(b.tree(), body)[0];
        mapped.q[coordinate] = link.value(&state.q);
        let [_, leader] = link.places.expect("what moves follows what moves");
        mapped.t[speed][leader] = link.multiplier;
    }
    mapped
}

#[test]
fn what_follows_is_as_if_projected_by_hand() {
    let mut most = 0.0_f64;
    let mut n_compared = 0;
    for seed in SEEDS {
        let system = system(seed).with_moving_followers();
        let freed = system.without_followers();
        let trees = [&system, &freed].map(|system| tree(&system.toml()));
        let [Some(given), Some(free)] = trees else {
            // Without followers a massless body can be left to itself.
            continue;
        };
        if given.n_speeds == free.n_speeds {
            continue;
        }
        most = most.max(agree(EXACT, seed, [&system, &freed], to_freed));
        n_compared += 1;
    }
    println!("largest error {most:e} of {n_compared}");
    assert!(n_compared >= 12, "{n_compared}");
}
