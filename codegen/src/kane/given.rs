//! What an equation is given: coordinates, speeds, loads, and the numbers of the description, in internal axes.

use crate::{
    expr::{Axis, Expr, ExprGraph, Input, Matrix, Symmetric, Vector, negated},
    geometry::{Rotation, transposed},
    id::{BodyId, SpeedId},
    tree::{Body, Coordinate, Joint, Motion, Offset, Part, Tree, Value},
};

/// The accelerations with which a right-hand side is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accelerations {
    /// `u_dot` as an argument.
    Given,
    /// Zero: what is left is the bias.
    Zero,
}

/// A number of the description.
pub fn value(graph: &mut ExprGraph, value: Value) -> Expr {
    match value {
        Value::Baked(number) => graph.number(number),
        Value::Runtime(parameter) => graph.input(Input::Parameter(parameter)),
    }
}

/// Three numbers of the description.
pub fn vector(graph: &mut ExprGraph, values: [Value; 3]) -> Vector {
    values.map(|component| value(graph, component))
}

/// Gravity, inertial components.
pub fn gravity(graph: &mut ExprGraph, tree: &Tree) -> Vector {
    graph.enter(None);
    vector(graph, tree.gravity)
}

/// A vector fixed in a body, along the axes of the whole.
pub fn fixed(graph: &mut ExprGraph, offset: &Offset) -> Vector {
    let mut sum = graph.zero_vector();
    for step in offset.steps() {
        let own = vector(graph, step.vector);
        let mut turned = constant_back(graph, &step.rotation, own);
        if step.negative {
            turned = negated(turned);
        }
        sum = graph.add_vectors(sum, turned);
    }
    sum
}

/// A constant rotation as expressions.
pub fn constant(graph: &mut ExprGraph, rotation: &Rotation) -> Matrix {
    rotation.map(|row| row.map(|entry| graph.number(entry)))
}

/// The components, before a constant rotation, of a vector given by those after it.
pub fn constant_back(graph: &mut ExprGraph, rotation: &Rotation, v: Vector) -> Vector {
    let back = constant(graph, &transposed(rotation));
    graph.mul_vector(&back, v)
}

/// `m_K`: the mass of a body with all that is fixed to it.
pub fn mass(graph: &mut ExprGraph, body: &Body) -> Expr {
    let mut sum = graph.zero();
    for part in &body.parts {
        let mass = value(graph, part.mass);
        sum = graph.add(sum, mass);
    }
    sum
}

/// `r_K`: from the internal origin of a body to its mass centre, internal axes; for a body without mass its own, whatever
/// is fixed to it.
pub fn mass_center(graph: &mut ExprGraph, body: &Body) -> Vector {
    if let [part] = &body.parts[..] {
        return fixed(graph, &part.mass_center);
    }
    let mass = mass(graph, body);
    if graph.is_zero(mass) {
        return fixed(graph, &body.parts[0].mass_center);
    }
    let mut moment = graph.zero_vector();
    for part in &body.parts {
        let (mass, center) = (value(graph, part.mass), fixed(graph, &part.mass_center));
        let own = graph.scale(mass, center);
        moment = graph.add_vectors(moment, own);
    }
    let inverse = graph.reciprocal(mass);
    graph.scale(inverse, moment)
}

/// `I_GK`: the inertia of a body with all that is fixed to it about its mass centre, internal axes.
pub fn inertia(graph: &mut ExprGraph, body: &Body) -> Symmetric {
    if let [part] = &body.parts[..] {
        return part_inertia(graph, part);
    }
    let center = mass_center(graph, body);
    let mut sum = graph.zero_symmetric();
    for part in &body.parts {
        let (mass, own_center) = (value(graph, part.mass), fixed(graph, &part.mass_center));
        let own = part_inertia(graph, part);
        let d = graph.sub_vectors(own_center, center);
        for axis in Axis::ALL {
            let (a, (b, c)) = (axis.index(), axis.others());
            // m (d·d 1 - d d^T)
            let (bb, cc, bc) = (
                graph.mul(d[b], d[b]),
                graph.mul(d[c], d[c]),
                graph.mul(d[b], d[c]),
            );
            let around = graph.add(bb, cc);
            let (around, mixed) = (graph.mul(mass, around), graph.mul(mass, bc));
            let diagonal = graph.add(own.diagonal[a], around);
            let mixed = graph.sub(own.mixed[a], mixed);
            sum.diagonal[a] = graph.add(sum.diagonal[a], diagonal);
            sum.mixed[a] = graph.add(sum.mixed[a], mixed);
        }
    }
    sum
}

/// The inertia of a part about its own mass centre, internal axes of its body.
pub fn part_inertia(graph: &mut ExprGraph, part: &Part) -> Symmetric {
    let i = &part.inertia;
    let own = Symmetric {
        diagonal: vector(graph, [i.xx, i.yy, i.zz]),
        mixed: vector(graph, [i.yz, i.xz, i.xy]),
    };
    let axes = constant(graph, &part.axes);
    graph.turn_back_symmetric(&axes, &own)
}

/// A relative coordinate: an entry of `q`, the value at which it is locked, or that of another which it follows.
pub fn coordinate(graph: &mut ExprGraph, coordinate: Coordinate) -> Expr {
    match coordinate {
        Coordinate::Free { coordinate, .. } => graph.input(Input::Q(coordinate)),
        Coordinate::Locked(at) => graph.number(at),
        Coordinate::Mimic {
            coordinate,
            multiplier,
            offset,
            ..
        } => {
            let other = graph.input(Input::Q(coordinate));
            let (multiplier, offset) = (graph.number(multiplier), graph.number(offset));
            let scaled = graph.mul(multiplier, other);
            graph.add(scaled, offset)
        }
    }
}

/// The speed of a relative motion: an entry of `u`, or a multiple of one that it follows; zero where held.
pub fn speed(graph: &mut ExprGraph, motion: Option<Motion>) -> Expr {
    of_motion(graph, motion, Input::U)
}

/// The derivative of the speed of a relative motion.
pub fn acceleration(
    graph: &mut ExprGraph,
    motion: Option<Motion>,
    accelerations: Accelerations,
) -> Expr {
    match accelerations {
        Accelerations::Given => of_motion(graph, motion, Input::UDot),
        Accelerations::Zero => graph.zero(),
    }
}

fn of_motion(
    graph: &mut ExprGraph,
    motion: Option<Motion>,
    input: impl Fn(SpeedId) -> Input,
) -> Expr {
    let Some(Motion { speed, factor }) = motion else {
        return graph.zero();
    };
    let (speed, factor) = (graph.input(input(speed)), graph.number(factor));
    graph.mul(factor, speed)
}

/// The speeds of the three translations, along the joint's axes.
pub fn shift_speeds(graph: &mut ExprGraph, joint: &Joint) -> Vector {
    joint.shifts().map(|shift| speed(graph, shift))
}

/// The directions of the three translations, lower-body components: `A_K` by rows.
pub fn shift_directions(graph: &mut ExprGraph, joint: &Joint) -> Matrix {
    constant(graph, &joint.rotation)
}

/// `q_K`: from the lower body's origin to where the joint sits, lower-body components.
pub fn attachment(graph: &mut ExprGraph, joint: &Joint) -> Vector {
    fixed(graph, &joint.attachment)
}

/// `q_K + s_K`: from the lower body's origin to the body's, lower-body components.
pub fn offset(graph: &mut ExprGraph, body: &Body) -> Vector {
    let attachment = attachment(graph, &body.joint);
    let translation = body.joint.translations.map(|s| coordinate(graph, s));
    let translation = constant_back(graph, &body.joint.rotation, translation);
    let offset = graph.add_vectors(attachment, translation);
    graph.name_vector(offset, "offset");
    offset
}

/// A load's force at the mass centre, internal axes.
pub fn force(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Vector {
    let force = [0, 1, 2].map(|i| graph.input(Input::Force(body, i)));
    constant_back(graph, &tree.body(body).pose.rotation, force)
}

/// A load's moment, internal axes.
pub fn moment(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Vector {
    let moment = [0, 1, 2].map(|i| graph.input(Input::Moment(body, i)));
    constant_back(graph, &tree.body(body).pose.rotation, moment)
}

/// A relative angular velocity that the function is given, internal axes.
pub fn relative_angular_velocity(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Vector {
    let w = [0, 1, 2].map(|i| graph.input(Input::RelativeAngularVelocity(body, i)));
    constant_back(graph, &tree.body(body).pose.rotation, w)
}
