//! The mass centre of all bodies and how it moves: masses and first moments pass inward with their rates, and where that is asked for with the rates of these, as they are seen from
//! the link that has been reached, and arrive in inertial components. They are divided by all mass there, for a changed mass is to
//! change nothing of bodies that are not on its path.

use crate::{
    expr::{Expr, ExprGraph, Purpose, Vector},
    given::{self, Accelerations},
    id::{BodyId, BodyMap},
    kane::center::Momentum,
    recursive::{
        links::{
            link::{self, Link},
            link_motion,
            linkage::Linkage,
            passage::{Drive, Passenger, speeds},
            root,
            rotation::Turn,
            totalled::{Addend, totalled},
            wrench::Wrench,
        },
        plan::Plan,
    },
    tree::{Motion, Tree},
};

/// From the inertial origin, inertial components; the origin itself where no body has mass.
pub fn position(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vector {
    let links = link::links(graph, tree, &root::kept_whole(tree, plan));
    let first = BodyId::new(0);
    if given::inverse_total_mass(graph, tree).is_none() {
        return graph.zero_vector();
    }
    let from_first = from_first(graph, tree, &links);
    let origin = root::origin(graph, tree, &links[first], first);
    graph.enter(None);
    graph.add_vectors(origin, from_first)
}

/// Its velocity, inertial components; zero where no body has mass.
pub fn velocity(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vector {
    let links = link::links(graph, tree, plan);
    let rate = moment_rate(graph, tree, &links);
    given::over_total_mass(graph, tree, rate)
}

/// The rates of linear and angular momentum about it for `y_dot = 0`: resultants of what links need where there is no weight.
pub fn momentum_matrix_dot_u(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Momentum {
    let plan = root::kept_whole(tree, plan);
    let linkage = Linkage::weightless(graph, tree, &plan);
    let center = from_first(graph, tree, &linkage.links);
    let wrenches = link_motion::inertial_wrenches(graph, &linkage, Accelerations::Zero);
    let name = |wrench: &Wrench, graph: &mut ExprGraph| {
        graph.name_vector(wrench.force, "f");
        graph.name_vector(wrench.moment, "n");
    };
    let mut sum = Momentum::zero(graph);
    graph.begin(Purpose::Momentum);
    let passage = |body| &linkage.passages[body];
    totalled(
        graph,
        tree,
        passage,
        wrenches,
        name,
        |graph, body, wrench| {
            let origin = root::from_first(graph, tree, &linkage.links, body);
            graph.enter(None);
            let from_center = graph.sub_vectors(origin, center);
            let about_center = wrench.moved(graph, from_center);
            let own = Momentum {
                linear: about_center.force,
                angular: about_center.moment,
            };
            sum = sum.plus(graph, &own);
        },
    );
    sum
}

/// The acceleration of the mass centre for `y_dot = 0`, inertial components; zero where no body has mass.
pub fn jacobian_dot_u(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vector {
    let links = link::links(graph, tree, plan);
    let second = whole(graph, tree, &links, true).second;
    let second = second.unwrap_or_else(|| graph.zero_vector());
    given::over_total_mass(graph, tree, second)
}

/// The rate of the first moment of all bodies, which is their linear momentum: inertial components.
pub(super) fn moment_rate(graph: &mut ExprGraph, tree: &Tree, links: &BodyMap<Link>) -> Vector {
    whole(graph, tree, links, false).rate
}

/// From the origin of the first link on the inertial frame to the mass centre, inertial components; zero where no body has
/// mass.
pub(in crate::recursive) fn from_first(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
) -> Vector {
    let moment = whole(graph, tree, links, false).moment;
    given::over_total_mass(graph, tree, moment)
}

/// Mass with first moment and its rates, about the origin and in the axes that have been reached.
#[derive(Clone, Copy, Debug)]
struct MovingMass {
    mass: Expr,
    /// Mass times the position of its centre.
    moment: Vector,
    /// How that changes as it is seen from there.
    rate: Vector,
    /// How the rate changes as it is seen from there, for `y_dot = 0`; `None` where nobody asks.
    second: Option<Vector>,
}

/// All of it, about the origin of the first link on the inertial frame, inertial components.
fn whole(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    with_second: bool,
) -> MovingMass {
    graph.begin(Purpose::Momentum);
    let masses = BodyMap::outward(tree.bodies.len(), |body, _| MovingMass {
        mass: links[body].inertia.mass,
        moment: links[body].inertia.moment,
        rate: graph.zero_vector(),
        second: with_second.then(|| graph.zero_vector()),
    });
    let name = |mass: &MovingMass, graph: &mut ExprGraph| {
        graph.name_vector(mass.moment, "composite");
        graph.name_vector(mass.rate, "composite_dot");
        if let Some(second) = mass.second {
            graph.name_vector(second, "composite_ddot");
        }
    };
    let mut all = MovingMass::none(graph, with_second);
    let passage = |body| &links[body].passage;
    totalled(
        graph,
        tree,
        passage,
        masses,
        name,
        |graph, body, mut mass| {
            let origin = root::from_first(graph, tree, links, body);
            graph.enter(None);
            mass.shift(graph, body, origin);
            all = all.plus(graph, &mass);
        },
    );
    all
}

impl MovingMass {
    fn none(graph: &mut ExprGraph, with_second: bool) -> Self {
        Self {
            mass: graph.zero(),
            moment: graph.zero_vector(),
            rate: graph.zero_vector(),
            second: with_second.then(|| graph.zero_vector()),
        }
    }
}

impl Addend for MovingMass {
    fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            mass: graph.add(self.mass, other.mass),
            moment: graph.add_vectors(self.moment, other.moment),
            rate: graph.add_vectors(self.rate, other.rate),
            second: self
                .second
                .zip(other.second)
                .map(|(own, other)| graph.add_vectors(own, other)),
        }
    }

    /// The lower link's own rate is zero: what arrives first would else bear its name.
    fn name_below(&self, graph: &mut ExprGraph) {
        graph.name_vector(self.rate, "composite_dot_below");
        if let Some(second) = self.second {
            graph.name_vector(second, "composite_ddot_below");
        }
    }
}

impl Passenger for MovingMass {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let shift = graph.scale(self.mass, offset);
        self.moment = graph.add_vectors(self.moment, shift);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let rates = speeds(graph, drive.motions());
        let (before, swept) = (self.rate, graph.cross(rates, self.moment));
        self.rate = graph.add_vectors(before, swept);
        // `w × (2 h_dot + w × h)`: for `y_dot = 0` the rate is constant. Translations enter farther in, along the joint's axes; along the
        // link's own their `w × m v` would be here once, and not twice.
        let both = graph.add_vectors(before, self.rate);
        self.second = self.second.map(|second| {
            let convected = graph.cross(rates, both);
            let second = graph.add_vectors(second, convected);
            rotation.backward(graph, second)
        });
        self.moment = rotation.backward(graph, self.moment);
        self.rate = rotation.backward(graph, self.rate);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let rates = speeds(graph, motions);
        let moved = graph.scale(self.mass, rates);
        self.rate = graph.add_vectors(self.rate, moved);
    }
}
