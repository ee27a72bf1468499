//! Two descriptions of one system, evaluated in one state.

use std::ops::RangeInclusive;

use kane_codegen::{
    functions::Formulation,
    id::BodyId,
    tree::{Body, ChartCoordinates, Orientation, Tree},
};
use kane_test_support::{
    compare::{assert_within, larger, largest, relative_to},
    dynamics::{
        Model, State,
        numbering::Maps,
        quantities::{mass_matrix, rows},
    },
    numeric::dot,
    random::Random,
    rotation::Rotation,
    systems::{RandomSystem, Sizes, Style, trees},
};

use crate::evaluator::Evaluator;

/// Those that are tried of forty.
pub(super) fn seeds() -> RangeInclusive<u64> {
    trees::tried(401..=440)
}

/// 2 to 11 bodies, one number after the other.
pub(super) fn system(seed: u64) -> RandomSystem {
    let bodies = usize::try_from(2 + seed % 10).expect("at most 11");
    RandomSystem::new(seed, Sizes { bodies, speeds: 24 }, Style::Framed)
}

/// The state of one of two descriptions in terms of that of the other: rows over its speeds, columns over the other's.
pub(super) struct Mapped {
    pub(super) q: Vec<f64>,
    pub(super) t: Vec<Vec<f64>>,
    pub(super) t_dot: Vec<Vec<f64>>,
}

impl Mapped {
    pub(super) fn new(a: &Tree, b: &Tree) -> Self {
        let zero = vec![vec![0.0; a.n_speeds]; b.n_speeds];
        Self {
            q: vec![0.0; b.n_coordinates],
            t: zero.clone(),
            t_dot: zero,
        }
    }

    /// A coordinate and a speed that are the same in both.
    pub(super) fn copy(&mut self, q: &[f64], (a, b): (&[usize; 2], &[usize; 2])) {
        self.q[b[0]] = q[a[0]];
        self.t[b[1]][a[1]] = 1.0;
    }

    /// Speeds that are turned.
    pub(super) fn turn(&mut self, turn: &Rotation, (a, b): (&[usize], &[usize])) {
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
            self.note(function, larger(largest(&of_b), 1.0), &of_a, &of_b);
        }
        for function in [
            "kinetic_energy",
            "potential_energy",
            "linear_momentum",
            "angular_momentum",
        ] {
            let of_a = self.a.evaluate(function, &state_a);
            let of_b = self.b.evaluate(function, &state_b);
            self.note(function, larger(largest(&of_b), 1.0), &of_a, &of_b);
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
                let scale = larger(largest(row), 1.0);
                self.note(partial, scale, &of_a[0][at_a], &projected(t, row));
                let expected = added(&projected(t, dot), &projected(t_dot, row));
                let scale = larger(scale, largest(dot));
                self.note(partial_dot, scale, &of_a[1][at_a], &expected);
            }
        }
    }

    fn compare_forces(&mut self) {
        let t = &self.mapped.t;
        let [state_a, state_b] = self.states(&self.state.u_dot);
        let m_b = mass_matrix(self.b, &state_b);
        let scale = larger(m_b.norm(), largest(&self.b.evaluate("bias", &state_b)));
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
        let moved = larger(largest(&u_dot), 1.0);
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
pub(super) fn agree(
    tolerance: f64,
    seed: u64,
    [a, b]: [&RandomSystem; 2],
    mapped: impl Fn(&Evaluator, &Evaluator, &State) -> Mapped,
) -> f64 {
    let [a, b] = [a, b].map(|system| Evaluator::new(system, Formulation::Recursive));
    let state = State::random(a.tree(), seed);
    let mapped = mapped(&a, &b, &state);
    let (error, function) = disagreement(&a, &b, &state, &mapped);
    assert_within(format!("seed {seed}, {function}"), error, tolerance)
}

/// The coordinates of a joint that are no part of an orientation with an angular velocity, each with its speed.
pub(super) fn plain(tree: &Tree, body: BodyId) -> Vec<[usize; 2]> {
    let joint = &tree.body(body).joint;
    let (coordinates, speeds) = (joint.coordinates(), joint.speeds());
    let skipped = match joint.orientation {
        Orientation::Rates(_) => [0, 0],
        Orientation::AngularVelocity {
            chart: ChartCoordinates::Angles(_),
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

pub(super) fn is_ball(body: &Body) -> bool {
    matches!(body.joint.orientation, Orientation::AngularVelocity { .. })
}
