//! How links move, and the wrenches that they need for it.
//!
//! Inertia forces are taken about the link's origin, so no velocity of a mass centre is formed; gravity is an
//! upward acceleration of the inertial frame. With `U = tilde(alpha) + tilde(w)^2` the force is `m a + U h`,
//! and the moment is `h × a` plus products of the inertia's components with entries of U and of `w w^T`.

use super::{
    link::Link,
    linkage::Linkage,
    passage::{Drive, Passenger, speed_rates, speeds},
    rotation::Turn,
    wrench::Wrench,
};
use crate::{
    expr::{Axis, Expr, ExprGraph, Matrix, Purpose, Vector, negated},
    given::{self, Accelerations},
    id::{BodyId, BodyMap},
    recursive::technique::Technique,
    tree::{Joint, Motion},
};

/// A link's motion, link components.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct LinkMotion {
    /// Angular velocity.
    pub(in crate::recursive) w: Vector,
    /// `tilde(alpha) + tilde(w)^2`: what a point's position is multiplied by for its acceleration.
    pub(in crate::recursive) u: Matrix,
    /// The squares of its components, and the products `w_y w_z`, `w_z w_x`, `w_x w_y`.
    pub(in crate::recursive) squares: Vector,
    pub(in crate::recursive) products: Vector,
    /// Angular acceleration.
    pub(in crate::recursive) alpha: Vector,
    /// Acceleration of the origin, less gravity.
    pub(in crate::recursive) a: Vector,
}

impl LinkMotion {
    /// How `U` changes with a turn about an axis `e`, along the axes that turn: `U tilde(e) - tilde(e) U`.
    pub(in crate::recursive) fn turned_field(&self, graph: &mut ExprGraph, axis: usize) -> Matrix {
        let (a, (b, c)) = (axis, Axis::ALL[axis].others());
        let two = graph.number(2.0);
        let twice = graph.mul(two, self.products[a]);
        let squares = graph.sub(self.squares[c], self.squares[b]);
        let mut turned = [graph.zero_vector(); 3];
        (turned[a][b], turned[a][c]) = (self.u[a][c], -self.u[a][b]);
        (turned[b][a], turned[c][a]) = (self.u[c][a], -self.u[b][a]);
        (turned[b][b], turned[c][c]) = (twice, -twice);
        // The diagonal of U is of squares: `U_cc - U_bb = w_c^2 - w_b^2`.
        (turned[b][c], turned[c][b]) = (squares, squares);
        turned
    }
}

/// How each link moves.
pub(in crate::recursive) fn motions(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    accelerations: Accelerations<'_>,
) -> BodyMap<LinkMotion> {
    let Linkage {
        tree, links, falls, ..
    } = linkage;
    graph.begin(Purpose::Motion);
    let gravity = given::acting_gravity(graph, tree);
    BodyMap::outward(tree.bodies.len(), |body, motions: &BodyMap<LinkMotion>| {
        graph.enter(body);
        let lower = tree.lower(body).map(|lower| &motions[lower]);
        let base = if falls[body] {
            graph.zero_vector()
        } else {
            negated(gravity)
        };
        read_translations(graph, &tree.body(body).joint, accelerations);
        let mut moving = Moving::new(graph, lower, base, accelerations);
        links[body].passage.outward(graph, &mut moving);
        moving.arrived(graph)
    })
}

/// What each link needs to move as it does, weight included.
pub(in crate::recursive) fn inertial_wrenches(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    accelerations: Accelerations<'_>,
) -> BodyMap<Wrench> {
    let Linkage { tree, links, .. } = linkage;
    let by_second = linkage.plan.uses(Technique::SecondMoments);
    let motions = motions(graph, linkage, accelerations);
    graph.begin(Purpose::Needed);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let (link, motion) = (&links[body], &motions[body]);
        let inertia = &link.inertia;
        let carried = graph.scale(inertia.mass, motion.a);
        let turned = graph.mul_vector(&motion.u, inertia.moment);
        let lever = graph.cross(inertia.moment, motion.a);
        let spin = euler(graph, link, motion, by_second);
        graph.hint(|graph| {
            graph.name_vector(carried, "f_of_a");
            graph.name_vector(turned, "f_of_turn");
            graph.name_vector(lever, "n_of_a");
            graph.name_vector(spin, "n_of_turn");
        });
        Wrench {
            force: graph.add_vectors(carried, turned),
            moment: graph.add_vectors(spin, lever),
        }
    })
}

/// Makes inputs of the speeds and accelerations of a joint's translations, before the sums in which they then stand first.
fn read_translations(graph: &mut ExprGraph, joint: &Joint, accelerations: Accelerations<'_>) {
    given::shift_speeds(graph, joint);
    for shift in joint.shifts() {
        given::acceleration(graph, shift, accelerations);
    }
}

/// A motion on its way outward through a joint.
pub(in crate::recursive) struct Moving<'a> {
    /// That of the lower link; `None` is the inertial frame.
    lower: Option<&'a LinkMotion>,
    accelerations: Accelerations<'a>,
    pub(in crate::recursive) w: Vector,
    pub(in crate::recursive) alpha: Vector,
    a: Vector,
    /// The axis of its last angle, and the square of the angular velocity across it: the lower link has that already.
    across: Option<(Axis, Expr)>,
}

impl<'a> Moving<'a> {
    /// At the lower link's origin; `base` is the acceleration of the inertial frame, less gravity.
    pub(in crate::recursive) fn new(
        graph: &mut ExprGraph,
        lower: Option<&'a LinkMotion>,
        base: Vector,
        accelerations: Accelerations<'a>,
    ) -> Self {
        let still = graph.zero_vector();
        let (w, alpha, a) = lower.map_or((still, still, base), |own| (own.w, own.alpha, own.a));
        Self {
            lower,
            accelerations,
            w,
            alpha,
            a,
            across: None,
        }
    }

    /// `w_b^2 + w_c^2` of the lower link's components, where its axes are those that an angle is about to turn.
    fn square_across(&self, graph: &mut ExprGraph, axis: Axis) -> Option<(Axis, Expr)> {
        let below = self.lower?.w.map(Expr::node);
        let (b, c) = axis.others();
        let own = [self.w[b], self.w[c]];
        let is_lower = |w: Expr| !graph.is_zero(w) && below.contains(&w.node());
        if !own.into_iter().all(is_lower) {
            return None;
        }
        let [b, c] = own.map(|w| graph.mul(w, w));
        Some((axis, graph.add(b, c)))
    }

    /// Adds a relative angular velocity: the lower axes turn under the new ones, by `w × relative`.
    fn add_angular_velocity(&mut self, graph: &mut ExprGraph, motions: [Motion; 3]) {
        let motions = motions.map(Some);
        let relative = speeds(graph, motions);
        let second = speed_rates(graph, motions, self.accelerations);
        let turned = graph.cross(self.w, relative);
        let alpha = graph.add_vectors(self.alpha, turned);
        self.w = graph.add_vectors(self.w, relative);
        self.alpha = graph.add_vectors(alpha, second);
    }

    /// The same where it is the rate of one angle.
    fn add_rate(&mut self, graph: &mut ExprGraph, axis: Axis, motion: Motion) {
        let rate = given::speed(graph, Some(motion));
        let second = given::acceleration(graph, Some(motion), self.accelerations);
        let (a, (b, c)) = (axis.index(), axis.others());
        let (w, alpha) = (&mut self.w, &mut self.alpha);
        let (along_b, along_c) = (graph.mul(w[c], rate), graph.mul(w[b], rate));
        for (own, [of_rate, of_lower]) in [(b, [along_b, alpha[b]]), (c, [along_c, alpha[c]])] {
            let axis = Axis::ALL[own].letter();
            graph.hint(|graph| {
                graph.name_by(of_rate, || format!("alpha_of_rate_{axis}"));
                graph.name_by(of_lower, || format!("alpha_of_lower_{axis}"));
            });
        }
        alpha[b] = graph.add(alpha[b], along_b);
        alpha[c] = graph.sub(alpha[c], along_c);
        alpha[a] = graph.add(alpha[a], second);
        w[a] = graph.add(w[a], rate);
    }

    /// The motion where it has come.
    pub(in crate::recursive) fn reached(&self, graph: &mut ExprGraph) -> LinkMotion {
        let mut motion = LinkMotion::new(graph, self.w, self.alpha, self.a);
        if let Some((axis, square)) = self.across {
            motion.u[axis.index()][axis.index()] = -square;
        }
        motion
    }

    pub(in crate::recursive) fn arrived(self, graph: &mut ExprGraph) -> LinkMotion {
        graph.name_vector(self.w, "w");
        graph.name_vector(self.alpha, "alpha");
        graph.name_vector(self.a, "a");
        let arrived = self.reached(graph);
        graph.name_matrix(&arrived.u, "u");
        arrived
    }
}

impl LinkMotion {
    /// The motion with these velocities and accelerations.
    pub(in crate::recursive) fn new(
        graph: &mut ExprGraph,
        w: Vector,
        alpha: Vector,
        a: Vector,
    ) -> Self {
        let squares = w.map(|component| graph.mul(component, component));
        graph.hint(|graph| graph.name_each(squares, ["w_xx", "w_yy", "w_zz"]));
        let products = Axis::ALL.map(|axis| {
            let (b, c) = axis.others();
            graph.mul(w[b], w[c])
        });
        graph.hint(|graph| graph.name_each(products, ["w_yz", "w_zx", "w_xy"]));
        Self {
            w,
            u: acceleration_matrix(graph, squares, products, alpha),
            squares,
            products,
            alpha,
            a,
        }
    }
}

impl Passenger for Moving<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        if let Some(lower) = self.lower {
            let turned = graph.mul_vector(&lower.u, offset);
            graph.hint(|graph| graph.name_vector(turned, "a_of_offset"));
            self.a = graph.add_vectors(self.a, turned);
            graph.hint(|graph| graph.name_vector(self.a, "a_at_joint"));
        }
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let turned = rotation.forward(graph, self.w);
        self.across = match drive {
            Drive::Angle(axis, _) => self.square_across(graph, axis),
            Drive::Nothing => self.across.filter(|_| turned == self.w),
            Drive::AngularVelocity(_) => None,
        };
        self.w = turned;
        self.alpha = rotation.forward(graph, self.alpha);
        if let Drive::Angle(axis, motion) = drive {
            self.add_rate(graph, axis, motion);
        }
        self.a = rotation.forward(graph, self.a);
        if let Drive::AngularVelocity(motions) = drive {
            self.add_angular_velocity(graph, motions);
        }
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let s_dot = speeds(graph, motions);
        let s_ddot = speed_rates(graph, motions, self.accelerations);
        let twice = graph.doubled(s_dot);
        let coriolis = graph.cross(self.w, twice);
        self.a = graph.add_vectors(self.a, coriolis);
        self.a = graph.add_vectors(self.a, s_ddot);
    }
}

/// `tilde(alpha) + tilde(w)^2`.
fn acceleration_matrix(
    graph: &mut ExprGraph,
    squares: Vector,
    products: Vector,
    alpha: Vector,
) -> Matrix {
    let mut u = [[graph.zero(); 3]; 3];
    for axis in Axis::ALL {
        let (a, (b, c)) = (axis.index(), axis.others());
        u[a][a] = -graph.add(squares[b], squares[c]);
        u[b][c] = graph.sub(products[a], alpha[a]);
        u[c][b] = graph.add(products[a], alpha[a]);
    }
    u
}

/// `I alpha + tilde(w) I w` by the entries of `U`: about x it is
/// `I_xx alpha_x + (I_zz - I_yy) w_y w_z - I_xy U_zx + I_xz U_yx + I_yz (U_yy - U_zz)`.
///
/// With the second moments `S = tr(I) 1 / 2 - I` the first two terms are `S_yy U_zy - S_zz U_yz`: one, where a second moment
/// is zero.
fn euler(graph: &mut ExprGraph, link: &Link, motion: &LinkMotion, by_second: bool) -> Vector {
    let LinkMotion {
        u,
        squares,
        products,
        alpha,
        ..
    } = motion;
    let tensor = &link.inertia.inertia;
    Axis::ALL.map(|axis| {
        let (a, (b, c)) = (axis.index(), axis.others());
        let second = [link.second[b], link.second[c]];
        let zeros = second.map(|moment| graph.is_zero(moment));
        let [first, gyroscopic] = if by_second && zeros[0] != zeros[1] {
            [(second[0], u[c][b]), (-second[1], u[b][c])]
        } else {
            let spread = graph.sub(tensor.diagonal[c], tensor.diagonal[b]);
            [(tensor.diagonal[a], alpha[a]), (spread, products[a])]
        };
        // U_yy - U_zz without what cancels.
        let tilt = graph.sub(squares[b], squares[c]);
        let products = [
            gyroscopic,
            (-tensor.entry(a, b), u[c][a]),
            (tensor.entry(a, c), u[b][a]),
            (tensor.entry(b, c), tilt),
        ];
        let mut sum = graph.mul(first.0, first.1);
        for (constant, motion) in products {
            let term = graph.mul(constant, motion);
            sum = graph.add(sum, term);
        }
        sum
    })
}
