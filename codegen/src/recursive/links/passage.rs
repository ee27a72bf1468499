//! The passage through a joint, from a lower link to its link: the one place that knows how a joint is put together.
//!
//! In: a joint in the layout of its link, and the axes along which its motions are taken. Out: a [`Passage`]. Afterwards: every
//! motion of the joint is met once, where it enters, in the axes that it moves along or about.
//! Does not: know what passes.
//!
//! An algorithm is a walk: for every body, from the inertial frame outward or from the leaves inward, it takes what has arrived
//! at the link, makes a [`Passenger`] of it, sends that through [`Passage::outward`] or [`Passage::inward`], and leaves at the
//! other end what came out. The passenger says what an offset, a rotation and a motion do to it. Outward it meets
//!
//! 1. [`shift`](Passenger::shift): the offset from the lower link's origin, along the lower link's axes, where there is a lower
//!    link: of the inertial frame's origin nothing is known or needed;
//! 2. [`turn`](Passenger::turn): the constant rotation to the joint's axes;
//! 3. [`along`](Passenger::along): translations along these;
//! 4. [`turn`](Passenger::turn): the rotations to the link's axes, each with what drives it, which enters after it;
//! 5. [`along`](Passenger::along): translations that are taken along the link's axes;
//!
//! and inward the same from the last to the first: a turn's motions are then met before the turn. Gravity is the shortest
//! example that goes both ways.

use super::{
    layout::Layout,
    link_axes::LinkAxes,
    rotation::{AxisRotation, ConstantRotation, Turn},
    rounding,
};
use crate::{
    expr::{Axis, ExprGraph, Matrix, Vector},
    given::{self, Accelerations, orientation},
    id::BodyId,
    tree::{Coordinate, Joint, Motion, Tree},
};

/// What passes through joints.
pub(in crate::recursive) trait Passenger {
    /// The origin moves, outward by `offset` from the lower link's.
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector);

    /// The axes turn, outward by `rotation`; after it enter the motions that drive it.
    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive);

    /// Motions along the axes enter, x, y, z; `None` where the joint has none.
    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]);
}

/// What drives a rotation.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) enum Drive {
    /// Nothing: the rotation is constant, or its motions are taken elsewhere.
    Nothing,
    /// The rate of its angle, about the axis that it leaves where it is.
    Angle(Axis, Motion),
    /// An angular velocity, by its components along the axes after it.
    AngularVelocity([Motion; 3]),
}

impl Drive {
    /// The motions about the axes after the rotation, x, y, z.
    pub(in crate::recursive) fn motions(self) -> [Option<Motion>; 3] {
        match self {
            Self::Nothing => [None; 3],
            Self::Angle(axis, motion) => Axis::ALL.map(|other| (other == axis).then_some(motion)),
            Self::AngularVelocity(motions) => motions.map(Some),
        }
    }

    /// Picks the side of the rotation on which motions meet what passes the other way. The axis of an angle is the same on both: before
    /// it. Components of an angular velocity are along the axes after it.
    pub(in crate::recursive) fn met<T>(self, before: T, after: T) -> T {
        match self {
            Self::AngularVelocity(_) => after,
            Self::Angle(..) | Self::Nothing => before,
        }
    }

    /// The angular velocity that it adds, along the axes after the rotation.
    pub(in crate::recursive) fn speeds(self, graph: &mut ExprGraph) -> Vector {
        speeds(graph, self.motions())
    }
}

/// The speeds of motions, x, y, z; zero where there is none.
pub(in crate::recursive) fn speeds(graph: &mut ExprGraph, motions: [Option<Motion>; 3]) -> Vector {
    motions.map(|motion| given::speed(graph, motion))
}

/// The accelerations of motions, which are the rates of their speeds, in the same way.
pub(in crate::recursive) fn speed_rates(
    graph: &mut ExprGraph,
    motions: [Option<Motion>; 3],
    accelerations: Accelerations<'_>,
) -> Vector {
    motions.map(|motion| given::acceleration(graph, motion, accelerations))
}

/// The way from a lower link to a link.
#[derive(Clone, Debug)]
pub(in crate::recursive) struct Passage {
    /// `None` is the inertial frame.
    lower: Option<BodyId>,
    /// From the lower link's origin to the link's, lower-link components.
    pub(in crate::recursive) offset: Vector,
    /// From the lower link's axes to the joint's.
    pub(in crate::recursive) constant: ConstantRotation,
    turning: Turning,
    motions: Motions,
}

/// How a link is turned from its joint's axes in the lower link.
#[derive(Clone, Copy, Debug)]
enum Turning {
    /// By the 1-2-3 body-fixed rotations, in order.
    Angles([AxisRotation; 3]),
    /// By a matrix.
    Matrix(Matrix),
}

/// The motions of a joint, each where it enters.
#[derive(Clone, Debug)]
struct Motions {
    /// Along the joint's axes.
    along_joint: [Option<Motion>; 3],
    /// The rates of the three angles, each about the axis of its own rotation.
    angles: [Option<Motion>; 3],
    /// Components of the relative angular velocity along the link's axes.
    angular_velocity: Option<[Motion; 3]>,
    /// Along the link's axes.
    along_link: [Option<Motion>; 3],
}

impl Motions {
    fn new(joint: &Joint, axes: LinkAxes) -> Self {
        let [angular_velocity, along_link] = axes.motions(joint);
        Self {
            along_joint: match along_link {
                Some(_) => [None; 3],
                None => joint.shifts(),
            },
            angles: match angular_velocity {
                Some(_) => [None; 3],
                None => joint.turns(),
            },
            angular_velocity,
            along_link: along_link.map_or([None; 3], |motions| motions.map(Some)),
        }
    }

    /// What drives the rotation about an axis; the last one leads to the link's axes.
    fn drive(&self, axis: Axis) -> Drive {
        let own = self.angles[axis.index()].map(|motion| Drive::Angle(axis, motion));
        let last = self.angular_velocity.filter(|_| axis == Axis::Z);
        own.or(last.map(Drive::AngularVelocity))
            .unwrap_or(Drive::Nothing)
    }
}

/// From a lower link's axes to the joint's, and to the link's origin: of the whole way what does not turn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arm {
    offset: Vector,
    constant: ConstantRotation,
}

impl Arm {
    pub(in crate::recursive) fn new(graph: &mut ExprGraph, joint: &Joint, layout: &Layout) -> Self {
        let constant = ConstantRotation::new(graph, &layout.constant);
        let translation = joint.translations.map(|s| given::coordinate(graph, s));
        let translation = constant.backward(graph, translation);
        let offset = graph.add_vectors(layout.attachment, translation);
        Self { offset, constant }
    }
}

impl Passage {
    /// The way through a body's joint, its motions as the speeds are.
    pub(super) fn new(
        graph: &mut ExprGraph,
        tree: &Tree,
        body: BodyId,
        layout: &Layout,
        arm: Arm,
    ) -> Self {
        let joint = &tree.body(body).joint;
        Self {
            lower: tree.lower(body),
            offset: arm.offset,
            constant: arm.constant,
            turning: Turning::new(graph, tree, joint, layout.phase),
            motions: Motions::new(joint, LinkAxes::of_speeds(joint)),
        }
    }

    /// The same way with motions along other axes.
    pub(super) fn with_axes(self, joint: &Joint, axes: LinkAxes) -> Self {
        Self {
            motions: Motions::new(joint, axes),
            ..self
        }
    }

    /// The same way from a lower link whose axes do not follow its own `rotation`.
    pub(super) fn on_unturned(self, graph: &mut ExprGraph, rotation: &AxisRotation) -> Self {
        Self {
            offset: rotation.backward(graph, self.offset),
            ..self
        }
    }

    /// The rotation about one axis of a joint that has angles.
    pub(in crate::recursive) fn rotation(&self, axis: Axis) -> AxisRotation {
        match &self.turning {
            Turning::Angles(rotations) => rotations[axis.index()],
            Turning::Matrix(_) => unreachable!("turning axis: an axis alone is that of an angle"),
        }
    }

    /// The same way with another rotation about its axis, where the joint has angles.
    pub(super) fn with_rotation(self, rotation: AxisRotation) -> Self {
        let turning = match self.turning {
            Turning::Angles(mut rotations) => {
                rotations[rotation.axis.index()] = rotation;
                Turning::Angles(rotations)
            }
            matrix @ Turning::Matrix(_) => matrix,
        };
        Self { turning, ..self }
    }

    /// Sends what has arrived at the lower link to the link.
    pub(in crate::recursive) fn outward(
        &self,
        graph: &mut ExprGraph,
        passenger: &mut impl Passenger,
    ) {
        if let Some(lower) = self.lower {
            passenger.shift(graph, lower, self.offset);
        }
        passenger.turn(graph, &self.constant, Drive::Nothing);
        passenger.along(graph, self.motions.along_joint);
        for (rotation, drive) in self.turns() {
            passenger.turn(graph, rotation, drive);
        }
        passenger.along(graph, self.motions.along_link);
    }

    /// Sends what has arrived at the link to the lower link.
    pub(in crate::recursive) fn inward(
        &self,
        graph: &mut ExprGraph,
        passenger: &mut impl Passenger,
    ) {
        self.inward_to_joint(graph, passenger);
        self.inward_from_joint(graph, passenger);
    }

    /// The first part of the way inward: past all motions, to the joint's axes.
    pub(in crate::recursive) fn inward_to_joint(
        &self,
        graph: &mut ExprGraph,
        passenger: &mut impl Passenger,
    ) {
        passenger.along(graph, self.motions.along_link);
        for (rotation, drive) in self.turns().rev() {
            passenger.turn(graph, rotation, drive);
        }
        passenger.along(graph, self.motions.along_joint);
    }

    /// The rest of it: to the lower link's axes and origin.
    pub(in crate::recursive) fn inward_from_joint(
        &self,
        graph: &mut ExprGraph,
        passenger: &mut impl Passenger,
    ) {
        passenger.turn(graph, &self.constant, Drive::Nothing);
        if let Some(lower) = self.lower {
            passenger.shift(graph, lower, self.offset);
        }
    }

    /// Components along the link's axes of a vector given along the joint's.
    pub(in crate::recursive) fn forward_from_joint(
        &self,
        graph: &mut ExprGraph,
        v: Vector,
    ) -> Vector {
        self.turns()
            .fold(v, |v, (rotation, _)| rotation.forward(graph, v))
    }

    /// Components along the joint's axes of a vector given along the link's.
    pub(in crate::recursive) fn backward_to_joint(
        &self,
        graph: &mut ExprGraph,
        v: Vector,
    ) -> Vector {
        self.turns()
            .rfold(v, |v, (rotation, _)| rotation.backward(graph, v))
    }

    /// The rotations from the joint's axes to the link's, each with what drives it.
    fn turns(&self) -> impl DoubleEndedIterator<Item = (&dyn Turn, Drive)> {
        let (rotations, matrix) = match &self.turning {
            Turning::Angles(rotations) => (&rotations[..], None),
            Turning::Matrix(matrix) => (&[][..], Some(matrix)),
        };
        let rotations = rotations.iter().map(|own| (own as &dyn Turn, own.axis));
        let matrix = matrix.map(|own| (own as &dyn Turn, Axis::Z));
        let turns = rotations.chain(matrix);
        turns.map(|(rotation, axis)| (rotation, self.motions.drive(axis)))
    }
}

impl Turning {
    fn new(graph: &mut ExprGraph, tree: &Tree, joint: &Joint, phase: f64) -> Self {
        let Some(angles) = joint.angles() else {
            let matrix = orientation::of_joint(graph, tree, joint);
            graph.name_matrix(&matrix, "rel");
            return Self::Matrix(matrix);
        };
        let trigonometry = orientation::trigonometry(graph, tree, angles);
        Self::Angles(Axis::ALL.map(|axis| {
            let place = axis.index();
            let (mut sine, mut cosine) = (trigonometry.sines[place], trigonometry.cosines[place]);
            if phase != 0.0 && !matches!(angles[place], Coordinate::Locked(_)) {
                let angle = given::coordinate(graph, angles[place]);
                (sine, cosine) = rounding::phased(graph, angle, phase);
                graph.name(sine, format!("sin{}", place + 1));
                graph.name(cosine, format!("cos{}", place + 1));
            }
            AxisRotation { axis, sine, cosine }
        }))
    }
}
