//! What is read from the models of `tests/mjcf` moves as MuJoCo moves it: masses, positions, sites and energies, computed here
//! from the description alone, against `reference.json`.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "the tests' own functions, which clippy takes for others"
)]

use std::fs;
use std::path::{Path, PathBuf};

use kane_codegen::description::{
    Description, FrameRotation, JointKind, PerCoordinate, Reading, Rotation, Scalar, WrittenBody,
    WrittenFrame, mjcf,
};
use kane_codegen::diagnostic::{Diagnostics, Severity, Source};
use kane_test_support::compare::{Tolerance, assert_close};
use serde_json::Value;

type Vector = [f64; 3];

const SAME: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/mjcf")
}

fn read(name: &str) -> (Description, Value) {
    let folder = folder().join(name);
    let text = fs::read_to_string(folder.join(format!("{name}.xml"))).unwrap();
    let source = Source::new(format!("{name}.xml"), text);
    let include = |path: &str| fs::read(folder.join(path));
    let description = mjcf::parse(&source, &Reading::default(), &include);
    let faults = Diagnostics::new(description.source.clone(), description.faults.clone());
    assert!(!faults.has_error(), "{faults}");
    let reference = fs::read_to_string(folder.join("reference.json")).unwrap();
    (description, serde_json::from_str(&reference).unwrap())
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().unwrap();
    list.iter().map(|number| number.as_f64().unwrap()).collect()
}

fn three(values: &[f64]) -> Vector {
    values.try_into().unwrap()
}

fn value(given: Option<kane_codegen::diagnostic::Spanned<Scalar>>) -> f64 {
    given.unwrap().value.nominal()
}

fn vector(given: [Option<kane_codegen::diagnostic::Spanned<Scalar>>; 3]) -> Vector {
    given.map(value)
}

fn close(found: f64, expected: f64, what: &str) {
    let tolerance = Tolerance::relative_beyond(1.0, 1e-11);
    assert_close(what, &[found], &[expected], tolerance);
}

fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn times(a: Vector, factor: f64) -> Vector {
    a.map(|entry| entry * factor)
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Components in the outer frame of a vector given in the inner one.
fn out(rotation: &Rotation, v: Vector) -> Vector {
    [0, 1, 2].map(|i| rotation[0][i] * v[0] + rotation[1][i] * v[1] + rotation[2][i] * v[2])
}

fn product(second: &Rotation, first: &Rotation) -> Rotation {
    second.map(|row| out(first, row))
}

/// Rows are the turned axes.
fn quaternion(q: &[f64]) -> Rotation {
    let (w, v) = (q[0], three(&q[1..4]));
    // v turned: v + 2 w (r × v) + 2 r × (r × v)
    SAME.map(|axis| {
        let once = cross(v, axis);
        add(axis, add(times(once, 2.0 * w), times(cross(v, once), 2.0)))
    })
}

fn turn(axis: Vector, angle: f64) -> Rotation {
    let (sine, cosine) = libm::sincos(angle / 2.0);
    let axis = times(axis, 1.0 / dot(axis, axis).sqrt());
    quaternion(&[cosine, sine * axis[0], sine * axis[1], sine * axis[2]])
}

/// Where a body is, and how it moves, in components of the world.
#[derive(Clone, Copy)]
struct Motion {
    position: Vector,
    rotation: Rotation,
    velocity: Vector,
    angular_velocity: Vector,
}

const WORLD: Motion = Motion {
    position: [0.0; 3],
    rotation: SAME,
    velocity: [0.0; 3],
    angular_velocity: [0.0; 3],
};

impl Motion {
    fn velocity_at(&self, arm: Vector) -> Vector {
        add(self.velocity, cross(self.angular_velocity, arm))
    }
}

fn same(quantity: &PerCoordinate<Scalar>) -> f64 {
    match quantity {
        PerCoordinate::Absent => 0.0,
        PerCoordinate::Same(value) => value.value.nominal(),
        PerCoordinate::Each(_) => panic!("MJCF gives one for all"),
    }
}

/// The body's motion, and the springs' and rotors' energies of its joint.
fn step(body: &WrittenBody, lower: &Motion, q: &mut &[f64], u: &mut &[f64]) -> (Motion, f64, f64) {
    let joint = &body.joint;
    let kind = joint.kind.as_ref().unwrap().value.clone();
    let arm = out(&lower.rotation, vector(joint.attachment));
    let attachment_rotation = joint.attachment_rotation.map_or(SAME, |r| r.value);
    let seat = product(&attachment_rotation, &lower.rotation);
    let mut anchor = add(lower.position, arm);
    let mut velocity = lower.velocity_at(arm);
    let mut rotation = seat;
    let mut angular_velocity = lower.angular_velocity;
    let mut take = |n_q: usize, n_u: usize| {
        let (mine, rest) = q.split_at(n_q);
        *q = rest;
        let (my_u, rest) = u.split_at(n_u);
        *u = rest;
        (mine.to_vec(), my_u.to_vec())
    };
    let axis = joint
        .axis
        .map(|axis| times(axis.value, 1.0 / dot(axis.value, axis.value).sqrt()));
    let (my_q, my_u) = match kind {
        JointKind::Fixed => (vec![], vec![]),
        JointKind::Revolute => {
            let (q, u) = take(1, 1);
            rotation = product(&turn(axis.unwrap(), q[0]), &seat);
            angular_velocity = add(angular_velocity, times(out(&seat, axis.unwrap()), u[0]));
            (q, u)
        }
        JointKind::Prismatic => {
            let (q, u) = take(1, 1);
            let along = out(&seat, axis.unwrap());
            let shift = times(along, q[0]);
            anchor = add(anchor, shift);
            velocity = add(lower.velocity_at(add(arm, shift)), times(along, u[0]));
            (q, u)
        }
        JointKind::Spherical => {
            let (q, u) = take(4, 3);
            rotation = product(&quaternion(&q), &seat);
            angular_velocity = add(angular_velocity, out(&rotation, three(&u)));
            (q, u)
        }
        JointKind::Free => {
            let (q, u) = take(7, 6);
            assert_eq!((anchor, seat), ([0.0; 3], SAME));
            anchor = three(&q[..3]);
            rotation = quaternion(&q[3..]);
            velocity = three(&u[..3]);
            angular_velocity = out(&rotation, three(&u[3..]));
            (q, u)
        }
        other => panic!("{other:?} does not come from MJCF"),
    };
    let back = joint.body_attachment.map_or([0.0; 3], vector);
    let back = out(&rotation, times(back, -1.0));
    let motion = Motion {
        position: add(anchor, back),
        rotation,
        velocity: add(velocity, cross(angular_velocity, back)),
        angular_velocity,
    };
    let spring = my_q.iter().map(|q| (q - same(&joint.rest)).powi(2));
    let spring = 0.5 * same(&joint.stiffness) * spring.sum::<f64>();
    let rotor = 0.5 * same(&joint.armature) * my_u.iter().map(|u| u * u).sum::<f64>();
    (motion, spring, rotor)
}

/// Inertia about the mass centre in the body's axes: xx, yy, zz, xy, xz, yz.
fn inertia(body: &WrittenBody) -> [f64; 6] {
    let [xx, yy, zz, xy, xz, yz] = body.inertia.map(value);
    let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let c = body
        .inertia_rotation
        .map_or(SAME, |rotation| rotation.value);
    let turned = |i: usize, j: usize| {
        let e = |k: usize| [c[0][k], c[1][k], c[2][k]];
        dot(e(i), rows.map(|row| dot(row, e(j))))
    };
    [
        turned(0, 0),
        turned(1, 1),
        turned(2, 2),
        turned(0, 1),
        turned(0, 2),
        turned(1, 2),
    ]
}

fn check_masses(bodies: &[&WrittenBody], reference: &Value) {
    for (body, expected) in bodies.iter().zip(reference["bodies"].as_array().unwrap()) {
        let name = expected["name"].as_str().unwrap();
        if !name.is_empty() {
            assert_eq!(body.name.as_ref().unwrap().value, name);
        }
        close(value(body.mass), expected["mass"].as_f64().unwrap(), name);
        let center = numbers(&expected["mass_center"]);
        for (found, expected) in vector(body.mass_center).iter().zip(center) {
            close(*found, expected, name);
        }
        for (found, expected) in inertia(body).iter().zip(numbers(&expected["inertia"])) {
            close(*found, expected, name);
        }
    }
}

/// The named sites, where MuJoCo has them.
fn check_sites(
    description: &Description,
    own: &[usize],
    motions: &[Motion],
    (sites, state): (&[Value], &Value),
) {
    for (place, site) in sites.iter().enumerate() {
        let name = site["name"].as_str().unwrap();
        // One that is called as a body gives way to that.
        let is_named = |frame: &&WrittenFrame| {
            let found = &frame.name.as_ref().unwrap().value;
            found.strip_suffix("_site").unwrap_or(found) == name
        };
        let frame = description.frames.iter().find(is_named).unwrap();
        // 0 is the world, before the bodies.
        let body = usize::try_from(site["body"].as_u64().unwrap()).unwrap();
        let motion = &motions[body.checked_sub(1).map_or(0, |body| own[body] + 1)];
        let arm = out(&motion.rotation, vector(frame.position));
        let FrameRotation::Baked(rotation) = frame.rotation.unwrap().value else {
            panic!("MJCF has no numbers of run time");
        };
        let expected = three(&numbers(&state["site_xpos"][place]));
        let axes = quaternion(&numbers(&state["site_xquat"][place]));
        let found = product(&rotation, &motion.rotation);
        for i in 0..3 {
            close(add(motion.position, arm)[i], expected[i], name);
            for (found, expected) in found[i].iter().zip(axes[i]) {
                close(*found, expected, name);
            }
        }
    }
}

fn check_state(description: &Description, own: &[usize], sites: &[Value], state: &Value) {
    let (q, u) = (numbers(&state["qpos"]), numbers(&state["qvel"]));
    let (mut q, mut u) = (&q[..], &u[..]);
    let gravity = vector(description.gravity);
    let mut motions = vec![WORLD];
    let (mut potential, mut kinetic) = (0.0, 0.0);
    let lower = description.lower_bodies.as_ref().unwrap();
    for (body, lower) in description.bodies.iter().zip(&lower.value) {
        let lower = usize::try_from(lower.unwrap().value).unwrap();
        let (motion, spring, rotor) = step(body, &motions[lower], &mut q, &mut u);
        motions.push(motion);
        let arm = out(&motion.rotation, vector(body.mass_center));
        let mass = value(body.mass);
        let lifted = body.gravity_compensation;
        let weight = mass * (1.0 - lifted.map_or(0.0, |share| share.value.nominal()));
        potential += spring - weight * dot(gravity, add(motion.position, arm));
        let w = motion
            .rotation
            .map(|axis| dot(axis, motion.angular_velocity));
        let [xx, yy, zz, xy, xz, yz] = inertia(body);
        let spin = dot(
            w,
            [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(|row| dot(row, w)),
        );
        let velocity = motion.velocity_at(arm);
        kinetic += rotor + 0.5 * (mass * dot(velocity, velocity) + spin);
    }
    assert!(q.is_empty() && u.is_empty());
    for (place, index) in own.iter().enumerate() {
        let motion = motions[index + 1];
        let arm = out(
            &motion.rotation,
            vector(description.bodies[*index].mass_center),
        );
        let expected = three(&numbers(&state["xpos"][place]));
        let expected_center = three(&numbers(&state["xipos"][place]));
        let axes = quaternion(&numbers(&state["xquat"][place]));
        for i in 0..3 {
            close(motion.position[i], expected[i], "xpos");
            close(add(motion.position, arm)[i], expected_center[i], "xipos");
            for (found, expected) in motion.rotation[i].iter().zip(axes[i]) {
                close(*found, expected, "xquat");
            }
        }
    }
    check_sites(description, own, &motions, (sites, state));
    close(
        potential,
        state["potential_energy"].as_f64().unwrap(),
        "potential energy",
    );
    close(
        kinetic,
        state["kinetic_energy"].as_f64().unwrap(),
        "kinetic energy",
    );
}

fn moves_as_in_mujoco(name: &str) {
    let (description, reference) = read(name);
    // MuJoCo's bodies are the last of those that their joints make.
    let mut own = Vec::new();
    let mut next = 0;
    for number in 1..=reference["bodies"].as_array().unwrap().len() {
        let joints = reference["joints"].as_array().unwrap().iter();
        let joints = joints.filter(|joint| joint["body"] == number).count();
        next += joints.max(1);
        own.push(next - 1);
    }
    assert_eq!(description.bodies.len(), next);
    let bodies: Vec<&WrittenBody> = own
        .iter()
        .map(|index| &description.bodies[*index])
        .collect();
    check_masses(&bodies, &reference);
    let sites = reference["sites"].as_array();
    let sites = sites.map_or(&[][..], Vec::as_slice);
    assert_eq!(description.frames.len(), sites.len());
    for state in reference["states"].as_array().unwrap() {
        check_state(&description, &own, sites, state);
    }
}

/// Makes a test of each model, and the list of their names.
macro_rules! models {
    ($($name:ident)*) => {
        const MODELS: &[&str] = &[$(stringify!($name)),*];

        $(#[test]
        fn $name() {
            moves_as_in_mujoco(stringify!($name));
        })*
    };
}

kane_test_support::mjcf_models!(models);

#[test]
fn every_model_is_listed() {
    let entries = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut found: Vec<String> = entries
        .filter(|path| path.is_dir())
        .map(|path| path.file_name().unwrap().to_string_lossy().into_owned())
        .collect();
    found.sort();
    assert_eq!(found, MODELS);
}

#[test]
fn none_of_these_models_has_a_name_that_is_not_known() {
    for name in MODELS {
        let (description, _) = read(name);
        let unknown = description
            .faults
            .iter()
            .find(|fault| fault.severity == Severity::Warning && fault.message.contains("unknown"));
        assert_eq!(unknown, None, "{name}");
    }
}
