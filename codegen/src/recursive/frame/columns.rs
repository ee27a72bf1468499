//! Jacobians whose columns pass joint by joint, beside the lever: what a motion adds is known along the axes that it enters, and
//! few of its entries are other than zero there.
//!
//! Columns pass inward from the frame to the inertial axes. As another frame sees them, they pass inward to the nearest link that
//! carries both, and outward from there. Components along the frame's own axes pass outward alone.

use super::{
    between::Between,
    reach::{Contributions, Reach, path},
};
use crate::{
    expr::{ExprGraph, Vector, negated},
    given::FrameMotion,
    id::{BodyId, BodyMap},
    recursive::links::{
        link::Link,
        passage::{Drive, Passenger},
        rotation::Turn,
    },
    tree::{Motion, NamedFrame, Tree},
};

/// The columns of the frame, or of a point that it is given, along the inertial axes, or as another frame sees it.
pub(super) fn seen(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    (frame, point): (NamedFrame, Option<Vector>),
    from: Option<NamedFrame>,
) -> Contributions {
    let way = Between::new(tree, links, frame, from);
    let mut carried = Carried {
        lever: Reach::of(graph, tree, links, frame).of_point(graph, point),
        columns: Columns::default(),
    };
    for &body in &way.ahead {
        carried.columns.at = Some(body);
        way.inward(graph, body, &mut carried);
        carried.columns.name(graph, tree);
    }
    // What moves the other frame moves it away: these are the columns of the other, seen from the frame.
    let mut behind = Behind(carried);
    behind.0.columns.each(negated);
    for &body in way.behind.iter().rev() {
        behind.0.columns.at = Some(body);
        way.outward(graph, body, &mut behind);
        behind.0.columns.name(graph, tree);
    }
    let mut columns = behind.0.columns;
    let axes = way.view(graph, from).axes;
    columns.each(|v| negated(graph.mul_vector(&axes, v)));
    columns.take()
}

/// The columns along the frame's own axes.
pub(super) fn local(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    (frame, point): (NamedFrame, Option<Vector>),
) -> Contributions {
    let reach = Reach::of(graph, tree, links, frame);
    let path = path(tree, frame);
    let mut levers = LeversInward {
        lever: reach.of_point(graph, point),
        at_turns: Vec::new(),
    };
    for &body in &path {
        graph.enter(body);
        links[body].passage.inward(graph, &mut levers);
        graph.name_vector(levers.lever, "lever");
    }
    let mut own = ColumnsOutward {
        levers: levers.at_turns,
        columns: Columns::default(),
    };
    for body in path.into_iter().rev() {
        graph.enter(body);
        own.columns.at = Some(body);
        links[body].passage.outward(graph, &mut own);
        own.columns.name(graph, tree);
    }
    own.columns.each(|v| graph.mul_vector(&reach.axes, v));
    own.columns.take()
}

/// An inertial vector along the frame's axes.
pub(super) fn along_frame(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    frame: NamedFrame,
    inertial: Vector,
) -> Vector {
    let mut carried = Direction(inertial);
    for body in path(tree, frame).into_iter().rev() {
        graph.enter(body);
        links[body].passage.outward(graph, &mut carried);
        graph.name_vector(carried.0, "up");
    }
    let reach = Reach::of(graph, tree, links, frame);
    graph.mul_vector(&reach.axes, carried.0)
}

/// What each motion contributes, of those that have been met.
#[derive(Debug, Default)]
struct Columns {
    /// The body whose joint is passed.
    at: Option<BodyId>,
    all: Vec<Column>,
}

#[derive(Debug)]
struct Column {
    /// The body that the motion moves: whatever is carried belongs to it.
    body: BodyId,
    /// The motion's place among the six of the joint.
    place: usize,
    motion: Motion,
    of_frame: FrameMotion,
}

impl Columns {
    /// Motions about the axes enter, with the frame's origin ahead by this lever.
    fn about(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3], lever: Vector) {
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let angular = graph.unit_vector(axis);
            let linear = graph.cross(angular, lever);
            self.add(motion, axis, FrameMotion { linear, angular });
        }
    }

    /// Motions along the axes enter.
    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let linear = graph.unit_vector(axis);
            let angular = graph.zero_vector();
            self.add(motion, 3 + axis, FrameMotion { linear, angular });
        }
    }

    fn add(&mut self, motion: Motion, place: usize, of_frame: FrameMotion) {
        self.all.push(Column {
            body: self.at.expect("frames: a motion is one of a body"),
            place,
            motion,
            of_frame,
        });
    }

    fn each(&mut self, mut change: impl FnMut(Vector) -> Vector) {
        for column in &mut self.all {
            let FrameMotion { linear, angular } = &mut column.of_frame;
            *linear = change(*linear);
            *angular = change(*angular);
        }
    }

    /// Labels what has come to the link that is reached.
    fn name(&self, graph: &mut ExprGraph, tree: &Tree) {
        let at = self.at.map_or("", |body| &tree.body(body).identifier);
        for column in &self.all {
            let name = tree.body(column.body).joint.motion_names()[column.place];
            let FrameMotion { linear, angular } = column.of_frame;
            graph.enter(column.body);
            graph.name_vector(linear, &format!("{name}_v_{at}"));
            graph.name_vector(angular, &format!("{name}_w_{at}"));
        }
    }

    fn take(self) -> Contributions {
        let columns = self.all.into_iter();
        columns
            .map(|column| (column.motion, column.of_frame))
            .collect()
    }
}

/// On the way inward from the frame.
struct Carried {
    /// Of the frame's origin, from the origin that has been reached.
    lever: Vector,
    columns: Columns,
}

impl Passenger for Carried {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.lever = graph.add_vectors(self.lever, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.columns.about(graph, drive.motions(), self.lever);
        self.columns.each(|v| rotation.backward(graph, v));
        self.lever = rotation.backward(graph, self.lever);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        self.columns.along(graph, motions);
    }
}

/// The same on the way outward to another frame.
struct Behind(Carried);

impl Passenger for Behind {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.0.lever = graph.sub_vectors(self.0.lever, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let Self(Carried { lever, columns }) = self;
        columns.each(|v| rotation.forward(graph, v));
        *lever = rotation.forward(graph, *lever);
        columns.about(graph, drive.motions(), *lever);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        self.0.columns.along(graph, motions);
    }
}

/// Where the frame's origin is, on the way inward.
struct LeversInward {
    lever: Vector,
    /// The same wherever rotations end, in the order of the way.
    at_turns: Vec<Vector>,
}

impl Passenger for LeversInward {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.lever = graph.add_vectors(self.lever, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        self.at_turns.push(self.lever);
        self.lever = rotation.backward(graph, self.lever);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}

/// On the way outward to the frame itself.
struct ColumnsOutward {
    /// The levers of the rest of the way.
    levers: Vec<Vector>,
    columns: Columns,
}

impl Passenger for ColumnsOutward {
    fn shift(&mut self, _: &mut ExprGraph, _: BodyId, _: Vector) {}

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let lever = self.levers.pop();
        let lever = lever.expect("frames: the way outward is the way inward");
        self.columns.each(|v| rotation.forward(graph, v));
        self.columns.about(graph, drive.motions(), lever);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        self.columns.along(graph, motions);
    }
}

/// A vector that stays as it is, along the axes that have been reached outward.
struct Direction(Vector);

impl Passenger for Direction {
    fn shift(&mut self, _: &mut ExprGraph, _: BodyId, _: Vector) {}

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        self.0 = rotation.forward(graph, self.0);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}
