//! Derivatives of inverse dynamics from composite bodies (as Singh, Russell and Wensing 2022 have them, here in the axes of links).
//!
//! A displacement along a motion moves all that is carried, rigidly and with its relative motions. Seen along with it, the
//! acceleration of a mass at `r` changes by `A + D × r + 2 u × r_dot`, where for a turn about `e`, in terms of the lower link's
//! motion, `u = w × e`, `D = alpha × e + w × u` and `A = a × e`; for a translation `D` alone is left, everywhere the same.
//! A change of the speed changes it by `2 e × r_dot + ((w + w') × e) × r`, with `w'` after the joint; for a translation by `2 w × e`.
//!
//! So a column begins with two wrenches that its masses need more, by its coordinate and by its speed. They pass inward with the
//! column's momentum and couple, and every motion farther in reads its rows off the wrenches, and the mirrored entries off momentum
//! and couple, as for the Coriolis matrix. All that is linear in velocities passes doubled.
//!
//! What all bodies need together changes as the columns' wrenches say where they have come to the inertial frame (`resultant`).

mod ahead;
mod begun;
mod carried;
mod column;
mod displaced;
mod found;
mod lockstep;
mod passing;
mod reader;
pub mod resultant;
mod sides;
mod start;
mod wanted;
mod way;

pub use self::{found::Derivatives, wanted::Wanted};

use std::collections::BTreeMap;

use self::{
    ahead::{Place, SendAhead},
    begun::Begins,
    carried::Carried,
    column::DerivativeColumn,
    lockstep::Inward,
    passing::Composites,
    way::{Went, ways},
};
use super::{
    forces::loaded,
    links::{linkage::Linkage, wrench::Wrench},
    matrices::shortcut::Shortcuts,
    plan::Plan,
    technique::Technique,
};
use crate::{
    expr::{Expr, ExprGraph, Input, Purpose},
    given::{Accelerations, Loads},
    id::{BodyMap, SpeedId},
    solve::zero_matrix,
    tree::Tree,
};

/// The derivatives of `A y_dot - f` of Eq. (43), without springs, dampers and rotors.
pub fn of_inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    accelerations: Accelerations<'_>,
    loads: Loads,
    wanted: Wanted,
) -> Derivatives {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    on_links(graph, linkage, accelerations, loads, wanted)
}

/// Those of `A y_dot` alone by coordinates and accelerations, of a system at rest without weight. The accelerations depend on no speeds.
pub fn of_mass_matrix_product(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    accelerations: Accelerations<'_>,
) -> Derivatives {
    // What depends on speeds falls away afterwards, which it does not in calls.
    let one_by_one = plan.with(Technique::Lockstep, false);
    let linkage = Linkage::weightless(graph, tree, &one_by_one);
    let found = on_links(graph, linkage, accelerations, Loads::Absent, Wanted::ALL);
    let at_rest = (0..tree.n_speeds).map(|speed| (Input::U(SpeedId::new(speed)), graph.zero()));
    let at_rest = at_rest.collect();
    let [by_q, by_u_dot] = [found.by_q, found.by_u_dot].map(|matrix| {
        let entries = graph.substituted(&matrix.concat(), &at_rest);
        entries
            .chunks(tree.n_speeds)
            .map(<[Expr]>::to_vec)
            .collect()
    });
    Derivatives {
        by_q,
        by_u_dot,
        by_u: zero_matrix(graph, tree.n_speeds),
    }
}

fn on_links(
    graph: &mut ExprGraph,
    linkage: Linkage<'_>,
    accelerations: Accelerations<'_>,
    loads: Loads,
    wanted: Wanted,
) -> Derivatives {
    let Linkage { tree, plan, .. } = linkage;
    let wrenches = loaded::needed(graph, &linkage, accelerations, loads);
    graph.begin(Purpose::Derivative);
    let ways = ways(graph, &linkage, accelerations);
    // What is read where joints follow others would have to be told apart by motions.
    let in_lockstep = plan.uses(Technique::Lockstep) && !tree.has_followers();
    let sweep = Sweep {
        linkage,
        wrenches,
        ways,
        in_lockstep,
        wanted,
    };
    let mut begun = BTreeMap::new();
    if in_lockstep {
        let mut later = Begins::Later(Vec::new());
        sweep.run(graph, &mut later);
        begun = later.together(graph, wanted);
    }
    sweep.run(graph, &mut Begins::Here(begun))
}

/// What composite bodies are made of as they pass inward.
struct Sweep<'a> {
    linkage: Linkage<'a>,
    /// The wrenches that links need.
    wrenches: BodyMap<Wrench>,
    ways: BodyMap<Went>,
    in_lockstep: bool,
    wanted: Wanted,
}

impl Sweep<'_> {
    /// Inward, body by body, with columns that begin where this says.
    fn run(&self, graph: &mut ExprGraph, begins: &mut Begins) -> Derivatives {
        let Self { linkage, ways, .. } = self;
        let tree = linkage.tree;
        let mut composites = Composites::new(graph, linkage, ways, &self.wrenches);
        let mut columns =
            BodyMap::outward(tree.bodies.len(), |_, _| Vec::<DerivativeColumn>::new());
        let mut shortcuts = Shortcuts::new(graph, linkage);
        let mut found = Derivatives::zero(graph, tree);
        let inward = Inward {
            linkage,
            ways,
            wanted: self.wanted,
        };
        let ahead = self.in_lockstep.then_some(&inward as &dyn SendAhead);
        for body in tree.body_ids().rev() {
            graph.enter(body);
            let mut carried = Carried {
                passing: composites.at(body),
                shortcuts: &mut shortcuts,
                columns: std::mem::take(&mut columns[body]),
                found: &mut found,
                begins,
                step: 0,
                entry: 0,
                ahead,
            };
            linkage.passages[body].inward(graph, &mut carried);
            let Carried {
                passing,
                columns: others,
                ..
            } = carried;
            if let Some(lower) = tree.lower(body) {
                composites.add(graph, lower, &passing, |graph| {
                    for column in &others {
                        column.hint(graph, tree, lower);
                    }
                });
                columns[lower].extend(others);
                if let Some(ahead) = ahead {
                    let from = Place::at_link(lower);
                    let arrived = &mut columns[lower];
                    ahead.send(graph, from, arrived, &mut shortcuts, &mut found);
                }
            }
        }
        found
    }
}
