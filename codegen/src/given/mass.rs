//! How a body's mass is distributed: a body with all that is fixed to it, in internal axes.

use super::numbers::{constant, fixed, value, vector};
use crate::{
    expr::{Axis, Expr, ExprGraph, Symmetric, Vector},
    tree::{Body, N_INERTIAL, RigidPart, Tree, Value},
};

/// A mass that is zero whatever is set at run time.
const NO_MASS: Value = Value::Baked(0.0);

/// `m_K`: the mass of a body with all that is fixed to it.
pub fn mass(graph: &mut ExprGraph, body: &Body) -> Expr {
    let mut sum = graph.zero();
    for part in &body.parts {
        let mass = value(graph, part.mass);
        sum = graph.add(sum, mass);
    }
    sum
}

/// The mass of all bodies.
fn total_mass(graph: &mut ExprGraph, tree: &Tree) -> Expr {
    let mut sum = graph.zero();
    for body in tree.body_ids() {
        graph.enter(body);
        let own = mass(graph, tree.body(body));
        graph.enter(None);
        sum = graph.add(sum, own);
    }
    graph.name(sum, "mass");
    sum
}

/// One over the mass of all bodies; `None` where none has any.
pub fn inverse_total_mass(graph: &mut ExprGraph, tree: &Tree) -> Option<Expr> {
    let mass = total_mass(graph, tree);
    (!graph.is_zero(mass)).then(|| graph.reciprocal(mass))
}

/// A vector over the mass of all bodies, as one of the system; zero where none has any.
pub fn over_total_mass(graph: &mut ExprGraph, tree: &Tree, v: Vector) -> Vector {
    let inverse = inverse_total_mass(graph, tree);
    graph.enter(None);
    match inverse {
        Some(inverse) => graph.scale(inverse, v),
        None => graph.zero_vector(),
    }
}

/// `r_K`: from the internal origin of a body to its mass centre, internal axes; for a body without mass its own, whatever
/// is fixed to it. Where one part has all the mass, its mass centre as it stands.
pub fn mass_center(graph: &mut ExprGraph, body: &Body) -> Vector {
    let mut heavy = body.parts.iter().filter(|part| part.mass != NO_MASS);
    match (heavy.next(), heavy.next()) {
        (None, _) => return fixed(graph, &body.parts[0].mass_center),
        (Some(only), None) => return fixed(graph, &only.mass_center),
        (Some(_), Some(_)) => {}
    }
    let mass = mass(graph, body);
    let mut moment = graph.zero_vector();
    for part in &body.parts {
        let (mass, center) = (value(graph, part.mass), fixed(graph, &part.mass_center));
        let own = graph.scale(mass, center);
        moment = graph.add_vectors(moment, own);
    }
    let inverse = graph.reciprocal(mass);
    graph.scale(inverse, moment)
}

/// What is lifted of the weights of a body and of all that is fixed to it.
#[derive(Clone, Copy, Debug)]
pub struct Lifted {
    /// The sum of the shares of the masses, kg.
    pub mass: Expr,
    /// The sum of their first moments about the internal origin, internal axes, kg m.
    pub moment: Vector,
}

/// What is lifted of a body; `None` where nothing is.
pub fn lifted(graph: &mut ExprGraph, body: &Body) -> Option<Lifted> {
    let mut parts = body.parts.iter().filter(|part| part.is_lifted()).peekable();
    parts.peek()?;
    let mut sum = Lifted {
        mass: graph.zero(),
        moment: graph.zero_vector(),
    };
    for part in parts {
        let (share, mass) = (value(graph, part.lifted), value(graph, part.mass));
        let mass = graph.mul(share, mass);
        let center = fixed(graph, &part.mass_center);
        let moment = graph.scale(mass, center);
        sum.mass = graph.add(sum.mass, mass);
        sum.moment = graph.add_vectors(sum.moment, moment);
    }
    Some(sum)
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
        let moved = moved(graph, &own, mass, d);
        sum = graph.add_symmetric(&sum, &moved);
    }
    sum
}

/// The inertia about a point of a mass whose mass centre, about which it is given, is at `d` from there.
fn moved(graph: &mut ExprGraph, own: &Symmetric, mass: Expr, d: Vector) -> Symmetric {
    let mut moved = *own;
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
        moved.diagonal[a] = graph.add(moved.diagonal[a], around);
        moved.mixed[a] = graph.sub(moved.mixed[a], mixed);
    }
    moved
}

/// The ten inertial parameters of these parts together, in the order of the regressor's columns: about the origin and along the axes
/// from which they are seen.
pub fn inertial_parameters(graph: &mut ExprGraph, parts: &[RigidPart]) -> [Expr; N_INERTIAL] {
    let mut mass = graph.zero();
    let mut moment = graph.zero_vector();
    let mut inertia = graph.zero_symmetric();
    for part in parts {
        let (own_mass, center) = (value(graph, part.mass), fixed(graph, &part.mass_center));
        let own_moment = graph.scale(own_mass, center);
        let own = part_inertia(graph, part);
        let own = moved(graph, &own, own_mass, center);
        mass = graph.add(mass, own_mass);
        moment = graph.add_vectors(moment, own_moment);
        inertia = graph.add_symmetric(&inertia, &own);
    }
    let ([x, y, z], [xx, yy, zz], [yz, xz, xy]) = (moment, inertia.diagonal, inertia.mixed);
    // As `InertialParameter::NAMES` has them.
    [mass, x, y, z, xx, xy, yy, xz, yz, zz]
}

/// The inertia of a part about its own mass centre, internal axes of its body.
pub fn part_inertia(graph: &mut ExprGraph, part: &RigidPart) -> Symmetric {
    let i = &part.inertia;
    let own = Symmetric {
        diagonal: vector(graph, [i.xx, i.yy, i.zz]),
        mixed: vector(graph, [i.yz, i.xz, i.xy]),
    };
    let axes = constant(graph, &part.axes);
    graph.turn_back_symmetric(&axes, &own)
}
