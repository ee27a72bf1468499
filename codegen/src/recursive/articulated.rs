//! Forward dynamics by articulated bodies (Featherstone 1983): no mass matrix, and work that grows with the number of bodies.
//!
//! With the links moving as they would without accelerations, each needs a wrench; what the true motion adds is linear in the
//! accelerations. From the leaves inward each motion is eliminated where it enters: it leaves the link an inertia that
//! resists along that motion no more, and a wrench whose part along it is the joint's own force. From the inertial frame
//! outward the accelerations follow. A body that moves freely hands nothing inward but that force.

use std::collections::BTreeMap;

use super::{
    articulated_inertia::Inertia,
    inertia, link_motion,
    linkage::Linkage,
    passage::{Drive, Passenger},
    rotation::Turn,
    wrench::Wrench,
};
use crate::{
    expr::{Expr, ExprGraph, Vector},
    given::{self, Accelerations},
    id::{BodyId, BodyMap, SpeedId},
    tree::{Joint, Motion},
};

/// A motion that was eliminated: about (0 to 2) or along (3 to 5) an axis.
#[derive(Clone, Debug)]
struct Eliminated {
    place: usize,
    /// What is left of the joint's force for it, over what resists it.
    own: Expr,
    /// What the other parts of the acceleration take from it.
    factors: [Expr; 6],
    /// True where a rotor resists the motion as well.
    has_rotor: bool,
}

/// Accelerations with `M u_dot + bias = tau`, of the linkage's motions; `tau` is theirs, less what springs and dampers take.
pub(super) fn solution(graph: &mut ExprGraph, linkage: &Linkage<'_>, tau: &[Expr]) -> Vec<Expr> {
    let Linkage {
        tree,
        links,
        passages,
        ..
    } = linkage;
    let mut wrenches = link_motion::inertial_wrenches(graph, linkage, Accelerations::Zero);
    let mut inertias = BodyMap::outward(tree.bodies.len(), |body, _| {
        Inertia::Rigid(links[body].inertia)
    });
    let mut eliminated = BTreeMap::new();
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut resisting = Resisting {
            joint: &tree.body(body).joint,
            inertia: inertias[body],
            wrench: wrenches[body],
            tau,
            eliminated: &mut eliminated,
        };
        resisting.name(graph);
        passages[body].inward_to_joint(graph, &mut resisting);
        if let Some(lower) = tree.lower(body) {
            passages[body].inward_from_joint(graph, &mut resisting);
            let Resisting {
                inertia, wrench, ..
            } = resisting;
            graph.enter(lower);
            wrenches[lower] = wrenches[lower].plus(graph, &wrench);
            inertias[lower] = inertias[lower].plus(graph, &inertia);
        }
    }
    recovered(graph, linkage, &eliminated)
}

/// The accelerations of the motions, from the inertial frame outward.
fn recovered(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    eliminated: &BTreeMap<SpeedId, Eliminated>,
) -> Vec<Expr> {
    let Linkage { tree, passages, .. } = linkage;
    let mut accelerations = vec![graph.zero(); tree.n_speeds];
    BodyMap::outward(tree.bodies.len(), |body, added: &BodyMap<[Vector; 2]>| {
        graph.enter(body);
        let below = tree.lower(body).map(|lower| added[lower]);
        let mut accelerating = Accelerating {
            added: below.unwrap_or([graph.zero_vector(); 2]),
            eliminated,
            accelerations: &mut accelerations,
        };
        passages[body].outward(graph, &mut accelerating);
        let added = accelerating.added;
        graph.name_vector(added[0], "alpha_added");
        graph.name_vector(added[1], "a_added");
        added
    });
    accelerations
}

/// What accelerations add to a link's own, angular and linear, on its way outward through a joint.
struct Accelerating<'a> {
    added: [Vector; 2],
    eliminated: &'a BTreeMap<SpeedId, Eliminated>,
    accelerations: &'a mut [Expr],
}

impl Accelerating<'_> {
    fn recover(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        for Motion { speed, .. } in motions.into_iter().flatten() {
            let acceleration = self.eliminated[&speed].recover(graph, &mut self.added);
            self.accelerations[speed.index()] = acceleration;
        }
    }
}

impl Passenger for Accelerating<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let [alpha, a] = self.added;
        let turned = graph.cross(alpha, offset);
        self.added = [alpha, graph.add_vectors(a, turned)];
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.added = self.added.map(|v| rotation.forward(graph, v));
        self.recover(graph, drive.motions());
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        self.recover(graph, motions);
    }
}

impl Eliminated {
    /// The acceleration of the motion, which is added to the link's.
    fn recover(&self, graph: &mut ExprGraph, added: &mut [Vector; 2]) -> Expr {
        let mut sum = self.own;
        for (place, &factor) in self.factors.iter().enumerate() {
            // Without a rotor its own factor is one: the sum is the whole new part, whatever it was before.
            if place != self.place || self.has_rotor {
                let term = graph.mul(factor, added[place / 3][place % 3]);
                sum = graph.sub(sum, term);
            }
        }
        let part = &mut added[self.place / 3][self.place % 3];
        let (whole, acceleration) = if self.has_rotor {
            (graph.add(*part, sum), sum)
        } else {
            (sum, graph.sub(sum, *part))
        };
        *part = whole;
        acceleration
    }
}

/// A link's inertia and wrench on their way inward through a joint, past which motions are eliminated.
struct Resisting<'a> {
    joint: &'a Joint,
    inertia: Inertia,
    wrench: Wrench,
    tau: &'a [Expr],
    eliminated: &'a mut BTreeMap<SpeedId, Eliminated>,
}

impl Passenger for Resisting<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.wrench = self.wrench.moved(graph, offset);
        self.inertia = self.inertia.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        for (axis, motion) in drive.motions().into_iter().enumerate().rev() {
            self.eliminate(graph, axis, motion);
        }
        self.wrench = self.wrench.map(|v| rotation.backward(graph, v));
        self.inertia = self.inertia.turned_back(graph, rotation);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        // Before rotations: of a body that carries none but free ones their block is a multiple of the identity.
        for (axis, motion) in motions.into_iter().enumerate().rev() {
            self.eliminate(graph, 3 + axis, motion);
        }
    }
}

impl Resisting<'_> {
    fn name(&self, graph: &mut ExprGraph) {
        graph.name_vector(self.wrench.force, "f");
        graph.name_vector(self.wrench.moment, "n");
        match &self.inertia {
            Inertia::Rigid(composite) => inertia::name(graph, &composite.inertia, "composite"),
            Inertia::Articulated(own) => {
                inertia::name(graph, &own.angular, "articulated");
                graph.name_matrix(&own.coupling, "coupling");
                inertia::name(graph, &own.linear, "carried");
            }
        }
    }

    /// Eliminates a motion of a joint, if there is one: `D` is what resists it, `l` the column of the inertia over that.
    fn eliminate(&mut self, graph: &mut ExprGraph, place: usize, motion: Option<Motion>) {
        let Some(motion) = motion else {
            return;
        };
        let name = self.joint.motion_names()[place];
        let mut rows = self.inertia.rows(graph);
        let mut needed = self.wrench.parts();
        let column = rows.map(|row| row[place]);
        let rotor = given::value(graph, self.joint.mechanics[place].armature);
        let has_rotor = !graph.is_zero(rotor);
        let pivot = graph.add(column[place], rotor);
        graph.name(pivot, format!("pivot_{name}"));
        let inverse = graph.reciprocal(pivot);
        graph.name(inverse, format!("inverse_{name}"));
        let force = self.tau[motion.speed.index()];
        let rest = graph.sub(force, needed[place]);
        graph.name(rest, format!("rest_{name}"));
        let letters = ["nx", "ny", "nz", "fx", "fy", "fz"];
        let mut factors = [graph.zero(); 6];
        for (i, factor) in factors.iter_mut().enumerate() {
            if i == place && !has_rotor {
                *factor = graph.one();
            } else {
                *factor = graph.mul(column[i], inverse);
                graph.name(*factor, format!("l_{name}_{}", letters[i]));
            }
        }
        let zero = graph.zero();
        for i in 0..6 {
            for j in i..6 {
                let entry = if (i == place || j == place) && !has_rotor {
                    zero
                } else {
                    let update = graph.mul(factors[i], column[j]);
                    graph.sub(rows[i][j], update)
                };
                (rows[i][j], rows[j][i]) = (entry, entry);
            }
            needed[i] = if i == place && !has_rotor {
                force
            } else {
                let taken = graph.mul(factors[i], rest);
                graph.add(needed[i], taken)
            };
        }
        let own = graph.mul(rest, inverse);
        self.inertia = Inertia::of_rows(graph, &rows);
        self.wrench = Wrench::of_parts(needed);
        let eliminated = Eliminated {
            place,
            own,
            factors,
            has_rotor,
        };
        self.eliminated.insert(motion.speed, eliminated);
    }
}
