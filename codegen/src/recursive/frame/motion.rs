//! Velocities and accelerations of a frame.
//!
//! What is along inertial axes passes inward: it arrives in inertial components. What is along the frame's own axes passes
//! outward.

use super::reach::{Reach, path};
use crate::{
    expr::{ExprGraph, Purpose, Vector, negated},
    given::{self, Accelerations, FrameMotion},
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            link::{self, Link},
            link_velocity::LinkVelocity,
            passage::{Drive, Passenger, speed_rates, speeds},
            rotation::Turn,
        },
        plan::Plan,
    },
    tree::{Motion, NamedFrame, Tree},
};

/// Velocity in the inertial frame, inertial components.
pub fn velocity(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, frame: NamedFrame) -> FrameMotion {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let mut seen = SeenFrame::of(graph, tree, &links, frame, None);
    seen.walk(graph, tree, &links, frame);
    seen.velocity
}

/// Acceleration in the inertial frame, inertial components.
pub fn acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
    accelerations: Accelerations<'static>,
) -> FrameMotion {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let mut seen = SeenFrame::of(graph, tree, &links, frame, Some(accelerations));
    seen.walk(graph, tree, &links, frame);
    seen.acceleration
}

/// Velocity in the inertial frame, components along the frame's own axes.
pub fn local_velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
) -> FrameMotion {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let mut carried = LinkVelocity::zero(graph);
    for body in path(tree, frame).into_iter().rev() {
        graph.enter(body);
        links[body].passage.outward(graph, &mut carried);
        carried.name(graph);
    }
    let LinkVelocity { linear, angular } = carried;
    let Reach { axes, position } = Reach::of(graph, tree, &links, frame);
    let swept = graph.cross(angular, position);
    let linear = graph.add_vectors(linear, swept);
    FrameMotion {
        linear: graph.mul_vector(&axes, linear),
        angular: graph.mul_vector(&axes, angular),
    }
}

/// Acceleration in the inertial frame, components along the frame's own axes.
pub fn local_acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
    accelerations: Accelerations<'static>,
) -> FrameMotion {
    let still = graph.zero_vector();
    accelerated(graph, tree, plan, frame, (accelerations, still)).acceleration
}

/// The specific force at the frame's origin, its acceleration less gravity, and its angular velocity, along its own axes.
pub fn imu(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, frame: NamedFrame) -> FrameMotion {
    let upward = negated(given::gravity(graph, tree));
    let accelerated = accelerated(graph, tree, plan, frame, (Accelerations::Given, upward));
    FrameMotion {
        linear: accelerated.acceleration.linear,
        angular: accelerated.angular_velocity,
    }
}

/// A frame's acceleration and angular velocity, along its own axes.
struct Accelerated {
    acceleration: FrameMotion,
    angular_velocity: Vector,
}

/// The walk outward, from an inertial frame with this acceleration.
fn accelerated(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
    (accelerations, base): (Accelerations<'static>, Vector),
) -> Accelerated {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let mut carried = LinkAcceleration {
        accelerations,
        angular: graph.zero_vector(),
        acceleration: FrameMotion {
            linear: base,
            angular: graph.zero_vector(),
        },
    };
    for body in path(tree, frame).into_iter().rev() {
        graph.enter(body);
        links[body].passage.outward(graph, &mut carried);
        graph.name_vector(carried.angular, "w");
        graph.name_vector(carried.acceleration.linear, "a_o");
        graph.name_vector(carried.acceleration.angular, "alpha");
    }
    let Reach { axes, position } = Reach::of(graph, tree, &links, frame);
    carried.shift_by(graph, position);
    let LinkAcceleration {
        angular,
        acceleration,
        ..
    } = carried;
    Accelerated {
        acceleration: FrameMotion {
            linear: graph.mul_vector(&axes, acceleration.linear),
            angular: graph.mul_vector(&axes, acceleration.angular),
        },
        angular_velocity: graph.mul_vector(&axes, angular),
    }
}

/// The motion of a frame as it is seen from the link that has been reached inward, along its axes.
struct SeenFrame {
    velocity: FrameMotion,
    acceleration: FrameMotion,
    /// `None` where no acceleration is wanted.
    accelerations: Option<Accelerations<'static>>,
    /// Of the frame's origin, from the link's.
    position: Vector,
}

impl SeenFrame {
    fn of(
        graph: &mut ExprGraph,
        tree: &Tree,
        links: &BodyMap<Link>,
        frame: NamedFrame,
        accelerations: Option<Accelerations<'static>>,
    ) -> Self {
        let zero = graph.zero_vector();
        let still = FrameMotion {
            linear: zero,
            angular: zero,
        };
        Self {
            velocity: still,
            acceleration: still,
            accelerations,
            position: Reach::of(graph, tree, links, frame).position,
        }
    }

    fn walk(
        &mut self,
        graph: &mut ExprGraph,
        tree: &Tree,
        links: &BodyMap<Link>,
        frame: NamedFrame,
    ) {
        for body in path(tree, frame) {
            graph.enter(body);
            links[body].passage.inward(graph, self);
            graph.name_vector(self.velocity.linear, "seen_v");
            graph.name_vector(self.velocity.angular, "seen_w");
            if self.accelerations.is_some() {
                graph.name_vector(self.acceleration.linear, "seen_a");
                graph.name_vector(self.acceleration.angular, "seen_alpha");
            }
        }
    }

    /// What the rates of a rotation add, and theirs: `a + w_dot × p + w × (2 v + w × p)`, `alpha + w_dot + w × w'`.
    fn turned(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let rates = speeds(graph, motions);
        let before = self.velocity;
        let swept = graph.cross(rates, self.position);
        self.velocity.linear = graph.add_vectors(before.linear, swept);
        self.velocity.angular = graph.add_vectors(before.angular, rates);
        let Some(accelerations) = self.accelerations else {
            return;
        };
        let second = speed_rates(graph, motions, accelerations);
        let both = graph.add_vectors(before.linear, self.velocity.linear);
        let swung = graph.cross(second, self.position);
        let convected = graph.cross(rates, both);
        let linear = graph.add_vectors(self.acceleration.linear, swung);
        self.acceleration.linear = graph.add_vectors(linear, convected);
        let convected = graph.cross(rates, before.angular);
        let angular = graph.add_vectors(self.acceleration.angular, second);
        self.acceleration.angular = graph.add_vectors(angular, convected);
    }
}

impl Passenger for SeenFrame {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.position = graph.add_vectors(self.position, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.turned(graph, drive.motions());
        for motion in [&mut self.velocity, &mut self.acceleration] {
            for vector in [&mut motion.linear, &mut motion.angular] {
                *vector = rotation.backward(graph, *vector);
            }
        }
        self.position = rotation.backward(graph, self.position);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let rates = speeds(graph, motions);
        self.velocity.linear = graph.add_vectors(self.velocity.linear, rates);
        if let Some(accelerations) = self.accelerations {
            let second = speed_rates(graph, motions, accelerations);
            self.acceleration.linear = graph.add_vectors(self.acceleration.linear, second);
        }
    }
}

/// The acceleration of the link that has been reached outward, along its axes.
struct LinkAcceleration {
    accelerations: Accelerations<'static>,
    /// Angular velocity.
    angular: Vector,
    /// Of its origin, and angular.
    acceleration: FrameMotion,
}

impl LinkAcceleration {
    fn shift_by(&mut self, graph: &mut ExprGraph, offset: Vector) {
        let swung = graph.cross(self.acceleration.angular, offset);
        let swept = graph.cross(self.angular, offset);
        let convected = graph.cross(self.angular, swept);
        for term in [swung, convected] {
            self.acceleration.linear = graph.add_vectors(self.acceleration.linear, term);
        }
    }
}

impl Passenger for LinkAcceleration {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.shift_by(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let FrameMotion { linear, angular } = &mut self.acceleration;
        for vector in [linear, &mut *angular, &mut self.angular] {
            *vector = rotation.forward(graph, *vector);
        }
        let rates = speeds(graph, drive.motions());
        let second = speed_rates(graph, drive.motions(), self.accelerations);
        let convected = graph.cross(self.angular, rates);
        for term in [second, convected] {
            *angular = graph.add_vectors(*angular, term);
        }
        self.angular = graph.add_vectors(self.angular, rates);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let rates = speeds(graph, motions);
        let twice = graph.doubled(rates);
        let convected = graph.cross(self.angular, twice);
        let second = speed_rates(graph, motions, self.accelerations);
        for term in [second, convected] {
            self.acceleration.linear = graph.add_vectors(self.acceleration.linear, term);
        }
    }
}
