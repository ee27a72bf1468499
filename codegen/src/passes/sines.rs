//! Sines. Needs: nothing. Afterwards: the sines and cosines of angles among the coordinates, and of what is such an angle or
//! several of them plus what is known before the loop, are inputs or made of inputs by the addition theorems. Keeps: the
//! value of every root, up to rounding, and bit for bit where no theorem is needed. Does not: touch the sine of a multiple
//! of an angle, as of a joint that follows another with a ratio; it stays, and its angle is computed from `q`.

use std::collections::BTreeMap;

use super::rebuild::Rebuilt;
use crate::{
    expr::{Binding, Expr, ExprGraph, Input, Node},
    id::{BodyId, CoordinateId},
    tree::Tree,
};

/// An angle among the coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Angle {
    /// Its place in `q`.
    pub coordinate: CoordinateId,
    /// The body that it turns.
    pub body: BodyId,
    /// "theta1", "theta2" or "theta3".
    pub kind: &'static str,
}

/// The angles among the coordinates, in the order of `q`: each has the place of its sine and cosine.
pub fn angles(tree: &Tree) -> Vec<Angle> {
    let mut angles = Vec::new();
    for body in tree.body_ids() {
        let coordinates = tree.body(body).joint.coordinates().into_iter();
        let turning = coordinates.filter(|(kind, _)| kind.starts_with("theta"));
        angles.extend(turning.map(|(kind, coordinate)| Angle {
            coordinate,
            body,
            kind,
        }));
    }
    angles.sort_by_key(|angle| angle.coordinate);
    angles
}

/// The graph with the sines and cosines of `angles` given, and its roots.
pub fn run(old: &ExprGraph, roots: &[Expr], angles: &[Angle]) -> (ExprGraph, Vec<Expr>) {
    let places = angles.iter().enumerate();
    let places = places.map(|(place, angle)| (angle.coordinate, place));
    let places: BTreeMap<CoordinateId, usize> = places.collect();
    let needed = old.reachable(roots);
    let mut graph = ExprGraph::with_capacity(old.len());
    let mut rebuilt = Rebuilt::new(old);
    for id in old.ids().filter(|id| needed[id.index()]) {
        graph.enter_like(old, id);
        let pair = match old.node(id) {
            Node::Sin(angle) | Node::Cos(angle) => {
                pair(&mut graph, old, &rebuilt, &places, Expr::of(angle))
            }
            _ => None,
        };
        let expr = match pair {
            None => rebuilt.copy(&mut graph, old, id),
            Some([sine, cosine]) => {
                let is_sine = matches!(old.node(id), Node::Sin(_));
                if is_sine { sine } else { cosine }
            }
        };
        graph.name_like(expr, old, Expr::of(id));
        rebuilt.set(id, expr);
    }
    let roots = roots.iter().map(|&root| rebuilt.expr(root)).collect();
    (graph, roots)
}

/// Sine and cosine of an angle, of a sum from those of its terms, so that sums which continue one another share them:
/// `sin(a + b) = sin a cos b + cos a sin b`, `cos(a + b) = cos a cos b - sin a sin b`. `None` where it has others.
fn pair(
    graph: &mut ExprGraph,
    old: &ExprGraph,
    rebuilt: &Rebuilt,
    places: &BTreeMap<CoordinateId, usize>,
    angle: Expr,
) -> Option<[Expr; 2]> {
    let id = angle.node();
    if old.binding(id) != Binding::State {
        let angle = rebuilt.expr(angle);
        return Some([graph.sin(angle), graph.cos(angle)].map(|entry| without_crumb(graph, entry)));
    }
    match old.node(id) {
        Node::Input(Input::Q(coordinate)) => {
            let place = *places.get(&coordinate)?;
            let sine = graph.input(Input::Sine(place)).signed(angle.is_negative());
            Some([sine, graph.input(Input::Cosine(place))])
        }
        Node::Add(a, b) => {
            let sign = angle.is_negative();
            let [s, c] = pair(graph, old, rebuilt, places, a.signed(sign))?;
            let [t, d] = pair(graph, old, rebuilt, places, b.signed(sign))?;
            let [first, second, third, fourth] =
                [(s, d), (c, t), (c, d), (s, t)].map(|(a, b)| graph.mul(a, b));
            Some([graph.add(first, second), graph.sub(third, fourth)])
        }
        _ => None,
    }
}

/// A sine or cosine, zero where it is so but for rounding, as that of a right angle is.
fn without_crumb(graph: &mut ExprGraph, entry: Expr) -> Expr {
    match graph.as_number(entry) {
        Some(number) if number.abs() < f64::EPSILON => graph.zero(),
        _ => entry,
    }
}
