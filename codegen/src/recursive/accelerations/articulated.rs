//! Forward dynamics by articulated bodies (Featherstone 1983): no mass matrix, and work that grows with the number of bodies.
//!
//! With the links moving as they would without accelerations, each needs a wrench; what the true motion adds is linear in the
//! accelerations. From the leaves inward each motion is eliminated where it enters: it leaves the link an inertia that
//! resists along that motion no more, and a wrench whose part along it is the joint's own force. From the inertial frame
//! outward the accelerations follow. A body that moves freely hands nothing inward but that force.

use std::collections::{BTreeMap, BTreeSet};

use super::{articulated_inertia::Inertia, prescribed::Prescribed};
use crate::{
    expr::{Expr, ExprGraph, Purpose, Vector},
    given,
    id::{BodyId, BodyMap, SpeedId},
    recursive::links::{
        linkage::Linkage,
        passage::{Drive, Passenger},
        rotation::Turn,
        totalled::Addend,
        wrench::Wrench,
    },
    solve::Partitioned,
    tree::{Joint, Motion},
};

/// A motion as it was met on the way inward.
#[derive(Clone, Debug)]
enum Met {
    /// Its acceleration is sought.
    Eliminated(Eliminated),
    /// Its force is.
    Prescribed(Prescribed),
}

/// A motion that was eliminated: about (0 to 2) or along (3 to 5) an axis.
#[derive(Clone, Debug)]
struct Eliminated {
    place: usize,
    /// What is left of the joint's force for it, over what resists it, for each right-hand side.
    own: Vec<Expr>,
    /// What the other parts of the acceleration take from it.
    factors: [Expr; 6],
    /// What resists the motion.
    pivot: Expr,
    /// True where a rotor resists the motion as well.
    has_rotor: bool,
}

/// Accelerations with `M u_dot + bias = tau`, of the linkage's motions, and forces of the prescribed speeds, whose accelerations
/// are given; `tau` is theirs, less what springs and dampers take. The links' wrenches are for what moves without the others.
pub(in crate::recursive) fn solution(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    tau: Vec<Expr>,
    prescribed: &BTreeSet<SpeedId>,
    wrenches: &BodyMap<Wrench>,
) -> Partitioned {
    let wrenches = BodyMap::outward(linkage.tree.bodies.len(), |body, _| vec![wrenches[body]]);
    let mut solutions = solutions(graph, linkage, wrenches, &[tau], prescribed);
    solutions.remove(0)
}

/// Accelerations with `M u_dot = tau` for several `tau`, of the linkage's motions: all are at rest, without weight.
pub(super) fn solutions_at_rest(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    taus: &[Vec<Expr>],
) -> Vec<Vec<Expr>> {
    let still = graph.zero_vector();
    let none = Wrench {
        force: still,
        moment: still,
    };
    let wrenches = BodyMap::outward(linkage.tree.bodies.len(), |_, _| vec![none; taus.len()]);
    let solutions = solutions(graph, linkage, wrenches, taus, &BTreeSet::new());
    let accelerations = solutions.into_iter().map(|own| own.accelerations);
    accelerations.collect()
}

/// The same for right-hand sides, each of which has a wrench that every link needs beside its accelerations.
fn solutions(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    wrenches: BodyMap<Vec<Wrench>>,
    taus: &[Vec<Expr>],
    prescribed: &BTreeSet<SpeedId>,
) -> Vec<Partitioned> {
    let met = met(graph, linkage, wrenches, taus, prescribed);
    let sides = 0..taus.len();
    sides
        .map(|side| recovered(graph, linkage, &met, side))
        .collect()
}

/// What resists each motion, and what it takes from the acceleration of the lower link, turned to where it enters.
pub(super) fn gains(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
) -> BTreeMap<SpeedId, (Expr, [Expr; 6])> {
    let none = BodyMap::outward(linkage.tree.bodies.len(), |_, _| Vec::new());
    let met = met(graph, linkage, none, &[], &BTreeSet::new());
    let gains = met.into_iter().filter_map(|(speed, met)| match met {
        Met::Eliminated(own) => Some((speed, (own.pivot, own.factors))),
        Met::Prescribed(_) => None,
    });
    gains.collect()
}

/// All motions, from the leaves inward.
fn met(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    mut wrenches: BodyMap<Vec<Wrench>>,
    taus: &[Vec<Expr>],
    prescribed: &BTreeSet<SpeedId>,
) -> BTreeMap<SpeedId, Met> {
    let Linkage {
        tree,
        links,
        passages,
        ..
    } = linkage;
    graph.begin(Purpose::Articulated);
    let mut inertias = BodyMap::outward(tree.bodies.len(), |body, _| {
        Inertia::Rigid(links[body].inertia)
    });
    let mut met = BTreeMap::new();
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut resisting = Resisting {
            joint: &tree.body(body).joint,
            inertia: inertias[body],
            wrenches: std::mem::take(&mut wrenches[body]),
            taus,
            prescribed,
            met: &mut met,
        };
        resisting.name(graph, "");
        passages[body].inward_to_joint(graph, &mut resisting);
        if let Some(lower) = tree.lower(body) {
            passages[body].inward_from_joint(graph, &mut resisting);
            graph.hint(|graph| resisting.name(graph, "_on_lower"));
            let Resisting {
                inertia,
                wrenches: arrived,
                ..
            } = resisting;
            graph.enter(lower);
            for (below, wrench) in wrenches[lower].iter_mut().zip(&arrived) {
                *below = below.plus(graph, wrench);
            }
            inertias[lower] = inertias[lower].plus(graph, &inertia);
        }
    }
    met
}

/// What is sought of the motions for one right-hand side, from the inertial frame outward.
fn recovered(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    met: &BTreeMap<SpeedId, Met>,
    side: usize,
) -> Partitioned {
    let Linkage { tree, passages, .. } = linkage;
    graph.begin(Purpose::Accelerations);
    let none = vec![graph.zero(); tree.n_speeds];
    let mut found = Partitioned {
        accelerations: none.clone(),
        forces: none,
    };
    BodyMap::outward(tree.bodies.len(), |body, added: &BodyMap<[Vector; 2]>| {
        graph.enter(body);
        let below = tree.lower(body).map(|lower| added[lower]);
        let mut accelerating = Accelerating {
            added: below.unwrap_or([graph.zero_vector(); 2]),
            met,
            side,
            found: &mut found,
        };
        passages[body].outward(graph, &mut accelerating);
        let added = accelerating.added;
        graph.name_vector(added[0], "alpha_added");
        graph.name_vector(added[1], "a_added");
        added
    });
    found
}

/// What accelerations add to a link's own, angular and linear, on its way outward through a joint.
struct Accelerating<'a> {
    added: [Vector; 2],
    met: &'a BTreeMap<SpeedId, Met>,
    side: usize,
    found: &'a mut Partitioned,
}

impl Accelerating<'_> {
    fn recover(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        for Motion { speed, .. } in motions.into_iter().flatten() {
            match &self.met[&speed] {
                Met::Eliminated(own) => {
                    let acceleration = own.recover(graph, self.side, &mut self.added);
                    self.found.accelerations[speed.index()] = acceleration;
                }
                Met::Prescribed(own) => {
                    let force = own.force(graph, self.side, &self.added);
                    self.found.forces[speed.index()] = force;
                }
            }
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
    fn recover(&self, graph: &mut ExprGraph, side: usize, added: &mut [Vector; 2]) -> Expr {
        let mut sum = self.own[side];
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

/// A link's inertia and wrenches, one a right-hand side, on their way inward through a joint, past which motions are eliminated.
struct Resisting<'a> {
    joint: &'a Joint,
    inertia: Inertia,
    wrenches: Vec<Wrench>,
    taus: &'a [Vec<Expr>],
    prescribed: &'a BTreeSet<SpeedId>,
    met: &'a mut BTreeMap<SpeedId, Met>,
}

impl Passenger for Resisting<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        for wrench in &mut self.wrenches {
            *wrench = wrench.moved(graph, offset);
        }
        self.inertia = self.inertia.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        for (axis, motion) in drive.motions().into_iter().enumerate().rev() {
            self.meet(graph, axis, motion);
        }
        for wrench in &mut self.wrenches {
            *wrench = wrench.map(|v| rotation.backward(graph, v));
        }
        self.inertia = self.inertia.turned_back(graph, rotation);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        // Before rotations: of a body that carries none but free ones their block is a multiple of the identity.
        for (axis, motion) in motions.into_iter().enumerate().rev() {
            self.meet(graph, 3 + axis, motion);
        }
    }
}

impl Resisting<'_> {
    /// Labels wrenches and inertia, with what tells where they have come.
    fn name(&self, graph: &mut ExprGraph, at: &str) {
        for wrench in &self.wrenches {
            graph.name_vector(wrench.force, &format!("f{at}"));
            graph.name_vector(wrench.moment, &format!("n{at}"));
        }
        self.inertia.name(graph, at);
    }

    /// A motion of a joint enters, if there is one: it is eliminated, or where it is prescribed passed by.
    fn meet(&mut self, graph: &mut ExprGraph, place: usize, motion: Option<Motion>) {
        let Some(motion) = motion else {
            return;
        };
        let met = if self.prescribed.contains(&motion.speed) {
            Met::Prescribed(Prescribed::new(graph, place, &self.inertia, &self.wrenches))
        } else {
            Met::Eliminated(self.eliminate(graph, place, motion))
        };
        self.met.insert(motion.speed, met);
    }

    /// Eliminates a motion: `D` is what resists it, `l` the column of the inertia over that.
    fn eliminate(&mut self, graph: &mut ExprGraph, place: usize, motion: Motion) -> Eliminated {
        let name = self.joint.motion_names()[place];
        let mut rows = self.inertia.rows(graph);
        let mut needed: Vec<_> = self.wrenches.iter().map(Wrench::parts).collect();
        let column = rows.map(|row| row[place]);
        let rotor = given::value(graph, self.joint.mechanics[place].armature);
        let has_rotor = !graph.is_zero(rotor);
        let pivot = graph.add(column[place], rotor);
        graph.name(pivot, format!("pivot_{name}"));
        let inverse = graph.reciprocal(pivot);
        graph.name(inverse, format!("inverse_{name}"));
        let forces: Vec<Expr> = self
            .taus
            .iter()
            .map(|tau| tau[motion.speed.index()])
            .collect();
        let rests: Vec<Expr> = forces
            .iter()
            .zip(&needed)
            .map(|(force, needed)| graph.sub(*force, needed[place]))
            .collect();
        for rest in &rests {
            graph.name(*rest, format!("rest_{name}"));
        }
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
            for (needed, (force, rest)) in needed.iter_mut().zip(forces.iter().zip(&rests)) {
                needed[i] = if i == place && !has_rotor {
                    *force
                } else {
                    let taken = graph.mul(factors[i], *rest);
                    graph.add(needed[i], taken)
                };
            }
        }
        let own = rests.iter().map(|rest| graph.mul(*rest, inverse));
        let own = own.collect();
        self.inertia = Inertia::of_rows(graph, &rows);
        self.wrenches = needed.into_iter().map(Wrench::of_parts).collect();
        graph.hint(|graph| self.name(graph, &format!("_past_{name}")));
        Eliminated {
            place,
            own,
            factors,
            pivot,
            has_rotor,
        }
    }
}
