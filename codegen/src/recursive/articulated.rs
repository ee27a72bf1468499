//! Forward dynamics by articulated bodies (Featherstone 1983): no mass matrix, and work that grows with the number of bodies.
//!
//! With the links moving as they would without accelerations, each needs a wrench; what the true motion adds is linear in the
//! accelerations. From the leaves inward each motion is eliminated where it enters: it leaves the link an inertia that
//! resists along that motion no more, and a wrench whose part along it is the joint's own force. From the inertial frame
//! outward the accelerations follow. A body that moves freely hands nothing inward but that force.

use super::{
    axes::{self, Axes},
    blocks::Inertia,
    inertia,
    link::{Link, Turning},
    linkage::Linkage,
    motion::{self, Wrench},
    rotation::{Rotation, Turn},
};
use crate::{
    expr::{Expr, ExprGraph, Matrix, Vector},
    id::BodyMap,
    kane::{Accelerations, given},
    tree::{Joint, Motion},
};

/// A motion that was eliminated: about (0 to 2) or along (3 to 5) an axis.
#[derive(Clone, Debug)]
struct Eliminated {
    place: usize,
    motion: Motion,
    /// What is left of the joint's force for it, over what resists it.
    own: Expr,
    /// What the other parts of the acceleration take from it.
    factors: [Expr; 6],
    /// True where a rotor resists the motion as well.
    has_rotor: bool,
}

/// What happens to a wrench on its way inward through a joint, in order.
#[derive(Clone, Debug)]
enum Step {
    Eliminated(Eliminated),
    Rotation(Rotation),
    Matrix(Matrix),
}

/// Accelerations with `M u_dot + bias = tau`, of the linkage's motions; `tau` is theirs, less what springs and dampers take.
pub(super) fn solution(graph: &mut ExprGraph, linkage: &Linkage<'_>, tau: &[Expr]) -> Vec<Expr> {
    let Linkage {
        tree, links, axes, ..
    } = linkage;
    assert!(
        !axes::has_followers(tree),
        "a speed that moves several joints cannot be eliminated where it enters"
    );
    let mut wrenches = motion::wrenches(graph, linkage, Accelerations::Zero);
    let mut inertias = BodyMap::outward(tree.bodies.len(), |body, _| {
        Inertia::Rigid(links[body].inertia)
    });
    let mut steps = BodyMap::outward(tree.bodies.len(), |_, _| Vec::new());
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut passing = Passing {
            inertia: inertias[body],
            wrench: wrenches[body],
            steps: Vec::new(),
        };
        passing.name(graph);
        let (joint, link) = (&tree.body(body).joint, &links[body]);
        passing.through_joint(graph, joint, link, axes[body], tau);
        if let Some(lower) = tree.lower(body) {
            passing.move_inward(graph, link);
            graph.enter(lower);
            wrenches[lower] = wrenches[lower].plus(graph, &passing.wrench);
            inertias[lower] = inertias[lower].plus(graph, &passing.inertia);
        }
        steps[body] = passing.steps;
    }
    outward(graph, linkage, &steps)
}

/// The accelerations of the motions, from the inertial frame outward.
fn outward(graph: &mut ExprGraph, linkage: &Linkage<'_>, steps: &BodyMap<Vec<Step>>) -> Vec<Expr> {
    let Linkage { tree, links, .. } = linkage;
    let mut accelerations = vec![graph.zero(); tree.n_speeds];
    BodyMap::outward(tree.bodies.len(), |body, added: &BodyMap<[Vector; 2]>| {
        graph.enter(body);
        let link = &links[body];
        let mut added = match tree.lower(body) {
            None => [graph.zero_vector(); 2],
            Some(lower) => {
                let [alpha, a] = added[lower];
                let turned = graph.cross(alpha, link.offset);
                [alpha, graph.add_vectors(a, turned)].map(|v| link.constant.forward(graph, v))
            }
        };
        for step in steps[body].iter().rev() {
            match step {
                Step::Rotation(rotation) => {
                    added = added.map(|v| rotation.forward(graph, v));
                }
                Step::Matrix(matrix) => added = added.map(|v| matrix.forward(graph, v)),
                Step::Eliminated(eliminated) => {
                    let acceleration = eliminated.recover(graph, &mut added);
                    accelerations[eliminated.motion.speed.index()] = acceleration;
                }
            }
        }
        graph.name_vector(added[0], "alpha_added");
        graph.name_vector(added[1], "a_added");
        added
    });
    accelerations
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

/// A link's inertia and wrench on their way inward.
struct Passing {
    inertia: Inertia,
    wrench: Wrench,
    steps: Vec<Step>,
}

impl Passing {
    fn name(&self, graph: &mut ExprGraph) {
        graph.name_vector(self.wrench.force, "f");
        graph.name_vector(self.wrench.moment, "n");
        match &self.inertia {
            Inertia::Rigid(composite) => inertia::name(graph, &composite.inertia, "composite"),
            Inertia::Articulated(blocks) => {
                inertia::name(graph, &blocks.angular, "articulated");
                graph.name_matrix(&blocks.coupling, "coupling");
                inertia::name(graph, &blocks.linear, "carried");
            }
        }
    }

    /// From the link's axes to the joint's in the lower link.
    fn through_joint(
        &mut self,
        graph: &mut ExprGraph,
        joint: &Joint,
        link: &Link,
        axes: Axes,
        tau: &[Expr],
    ) {
        let [turns, shifts] = axes.along_link(joint);
        // Translations first: of a body that carries none but free ones their block is a multiple of the identity.
        for (first, motions) in [(3, shifts), (0, turns)] {
            for axis in [2, 1, 0] {
                let motion = motions.map(|motions| motions[axis]);
                self.eliminate(graph, joint, first + axis, motion, tau);
            }
        }
        match &link.turning {
            Turning::Angles(rotations) => {
                for rotation in rotations.iter().rev() {
                    let motion = rotation.motion.filter(|_| turns.is_none());
                    self.eliminate(graph, joint, rotation.axis.index(), motion, tau);
                    self.turn(graph, rotation);
                    self.steps.push(Step::Rotation(*rotation));
                }
            }
            Turning::Matrix(matrix) => {
                self.turn(graph, matrix);
                self.steps.push(Step::Matrix(*matrix));
            }
        }
        for (axis, motion) in joint.shifts().into_iter().enumerate().rev() {
            let motion = motion.filter(|_| shifts.is_none());
            self.eliminate(graph, joint, 3 + axis, motion, tau);
        }
    }

    /// To the axes before a rotation.
    fn turn(&mut self, graph: &mut ExprGraph, turn: &impl Turn) {
        self.wrench = self.wrench.map(|v| turn.backward(graph, v));
        self.inertia = self.inertia.turned_back(graph, turn);
    }

    /// From the joint's axes to the lower link's, about its origin.
    fn move_inward(&mut self, graph: &mut ExprGraph, link: &Link) {
        self.turn(graph, &link.constant);
        let lever = graph.cross(link.offset, self.wrench.force);
        self.wrench.moment = graph.add_vectors(self.wrench.moment, lever);
        self.inertia = self.inertia.moved(graph, link.offset);
    }

    /// Eliminates a motion of a joint, if there is one: `D` is what resists it, `l` the column of the inertia over that.
    fn eliminate(
        &mut self,
        graph: &mut ExprGraph,
        joint: &Joint,
        place: usize,
        motion: Option<Motion>,
        tau: &[Expr],
    ) {
        let Some(motion) = motion else {
            return;
        };
        let name = joint.motion_names()[place];
        let mut rows = self.inertia.rows(graph);
        let mut needed = self.wrench.parts();
        let column = rows.map(|row| row[place]);
        let rotor = given::value(graph, joint.mechanics[place].armature);
        let has_rotor = !graph.is_zero(rotor);
        let pivot = graph.add(column[place], rotor);
        graph.name(pivot, format!("pivot_{name}"));
        let inverse = graph.reciprocal(pivot);
        graph.name(inverse, format!("inverse_{name}"));
        let force = tau[motion.speed.index()];
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
        self.steps.push(Step::Eliminated(Eliminated {
            place,
            motion,
            own,
            factors,
            has_rotor,
        }));
    }
}

impl Wrench {
    fn map(&self, mut f: impl FnMut(Vector) -> Vector) -> Self {
        Self {
            force: f(self.force),
            moment: f(self.moment),
        }
    }

    fn parts(&self) -> [Expr; 6] {
        let ([nx, ny, nz], [fx, fy, fz]) = (self.moment, self.force);
        [nx, ny, nz, fx, fy, fz]
    }

    fn of_parts([nx, ny, nz, fx, fy, fz]: [Expr; 6]) -> Self {
        Self {
            force: [fx, fy, fz],
            moment: [nx, ny, nz],
        }
    }
}
