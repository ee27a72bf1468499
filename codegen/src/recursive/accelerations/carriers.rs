//! The carriers of floating trees: their roots, and the bodies near these on which several branches are.
//!
//! Motions of joints are expressed along those of the root: carried inward, as what moves with the link.

use crate::{
    expr::{Expr, ExprGraph, Purpose, Vector},
    id::{BodyId, BodyMap, SpeedId},
    recursive::{
        links::{
            linkage::Linkage,
            passage::{Drive, Passenger},
            rotation::Turn,
        },
        technique::Technique,
    },
    solve::{Carriers, RootMotion},
    tree::{Mechanics, Motion, Tree},
};

/// So many joints may lie between a root and a carrier: the axis of a farther one has six parts along the root's motions, and to
/// add what moves about it costs more than it saves.
const MOST_JOINTS: usize = 3;

/// The carriers, where the plan uses them.
pub(in crate::recursive) fn carriers(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> Carriers {
    let Linkage { tree, plan, .. } = linkage;
    let mut carriers = Carriers::default();
    if !plan.uses(Technique::Carriers) {
        return carriers;
    }
    graph.begin(Purpose::Composite);
    let roots = BodyMap::outward(tree.bodies.len(), |body, roots: &BodyMap<BodyId>| {
        let lower = tree.lower(body);
        lower.map_or(body, |lower| roots[lower])
    });
    let carry = carrying(tree);
    for body in tree.body_ids() {
        let root = roots[body];
        let Some(root_speeds) = speeds_of_root(linkage, root) else {
            continue;
        };
        let Some(lower) = tree.lower(body) else {
            carriers.add_root(body, root_speeds);
            continue;
        };
        let Some(motion) = only_motion(tree, body) else {
            continue;
        };
        let gives_way = lower == root && !has_rotor(tree, body);
        if !carry[body] && !gives_way {
            continue;
        }
        let along_root = along_root(graph, linkage, body, motion.speed);
        if carry[body] {
            carriers.add(tree, body, motion.speed, along_root);
        }
        if gives_way {
            release(graph, tree, body, along_root, &mut carriers);
        }
    }
    carriers
}

/// The speeds of a root that moves freely, about and along the axes of its link or along those of its joint.
fn speeds_of_root(linkage: &Linkage<'_>, root: BodyId) -> Option<[SpeedId; 6]> {
    let joint = &linkage.tree.body(root).joint;
    let [turns, _] = linkage.axes[root].motions(joint);
    let [a, b, c] = turns?;
    let [d, e, f] = joint.shifts();
    Some([a, b, c, d?, e?, f?].map(|motion| motion.speed))
}

/// Bodies on the way to one that several others are on, by one motion each, and those next to a root, whose motions are constant
/// along the root's.
fn carrying(tree: &Tree) -> BodyMap<bool> {
    let joints = BodyMap::outward(
        tree.bodies.len(),
        |body, joints: &BodyMap<Option<usize>>| match tree.lower(body) {
            None => Some(0),
            Some(lower) => {
                let own = only_motion(tree, body).map(|_| 1)?;
                Some(joints[lower]? + own).filter(|joints| *joints <= MOST_JOINTS)
            }
        },
    );
    let mut carrying = BodyMap::outward(tree.bodies.len(), |_, _| false);
    for body in tree.body_ids() {
        let n_uppers = tree.uppers(body).len();
        let is_next = joints[body] == Some(1) && n_uppers > 0;
        if joints[body].is_some() && (is_next || n_uppers > 1) {
            let mut next = Some(body);
            while let Some(own) = next {
                carrying[own] = true;
                next = tree.lower(own);
            }
        }
    }
    carrying
}

/// The motion of a joint that has one.
fn only_motion(tree: &Tree, body: BodyId) -> Option<Motion> {
    let mut motions = tree.body(body).joint.motions().into_iter().flatten();
    let only = motions.next()?;
    motions.next().is_none().then_some(only)
}

fn has_rotor(tree: &Tree, body: BodyId) -> bool {
    let mut mechanics = tree.body(body).joint.mechanics.iter();
    mechanics.any(Mechanics::has_rotor)
}

/// Takes a joint on a root for one that gives way, if that is cheaper: an entry less for each speed on it, one more for each
/// other part of its motion.
fn release(
    graph: &ExprGraph,
    tree: &Tree,
    body: BodyId,
    motion: RootMotion,
    carriers: &mut Carriers,
) {
    let size = |place: usize| graph.as_number(motion[place]).map_or(0.0, f64::abs);
    let pivot = (0..6).max_by(|&a, &b| size(a).total_cmp(&size(b)));
    let others = motion.iter().filter(|part| !graph.is_zero(**part)).count();
    if let Some(pivot) = pivot.filter(|pivot| size(*pivot) > 0.5)
        && others <= n_speeds_on(tree, body)
    {
        carriers.release(body, motion, pivot);
    }
}

/// How many speeds a body has with all that is on it.
fn n_speeds_on(tree: &Tree, body: BodyId) -> usize {
    let own = tree.body(body).joint.speeds().len();
    let uppers = tree.uppers(body).iter();
    own + uppers.map(|&upper| n_speeds_on(tree, upper)).sum::<usize>()
}

/// A speed's motion along those of its root.
fn along_root(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    body: BodyId,
    speed: SpeedId,
) -> RootMotion {
    let Linkage {
        tree,
        passages,
        axes,
        ..
    } = linkage;
    let mut moving = UnitMotion {
        speed,
        parts: [graph.zero_vector(); 2],
    };
    let mut own = body;
    while let Some(lower) = tree.lower(own) {
        graph.enter(own);
        passages[own].inward(graph, &mut moving);
        own = lower;
    }
    graph.enter(body);
    let [about, mut along] = moving.parts;
    if axes[own].shift_before_turns() {
        along = passages[own].backward_to_joint(graph, along);
    }
    graph.name_vector(about, "axis");
    graph.name_vector(along, "lever");
    let ([a, b, c], [d, e, f]) = (about, along);
    [a, b, c, d, e, f]
}

/// What moves with a link for a unit of one speed: about an axis, and at the origin that it has reached.
struct UnitMotion {
    speed: SpeedId,
    parts: [Vector; 2],
}

impl UnitMotion {
    fn enter(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3], part: usize) {
        for (axis, motion) in motions.into_iter().enumerate() {
            if let Some(motion) = motion.filter(|motion| motion.speed == self.speed) {
                let factor: Expr = graph.number(motion.factor);
                self.parts[part][axis] = factor;
            }
        }
    }
}

impl Passenger for UnitMotion {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let [about, along] = self.parts;
        let around = graph.cross(offset, about);
        self.parts[1] = graph.add_vectors(along, around);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.enter(graph, drive.motions(), 0);
        self.parts = self.parts.map(|v| rotation.backward(graph, v));
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        self.enter(graph, motions, 1);
    }
}
