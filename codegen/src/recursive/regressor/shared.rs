//! What a joint does not move of a body's inertia, as parameters of its lower body.
//!
//! A mass on the axis of a hinge moves as a point of the lower body does, and so do a first and a second moment along the axis;
//! what only translates turns as its lower body does. The columns of such parameters are constant sums of the lower body's for
//! every speed below the joint, and zero for the joint's own: base inertial parameters (Khalil and Kleinfinger 1987), read the
//! other way round.

use super::super::plan::{Plan, Regroup};
use crate::{
    expr::{Expr, ExprGraph, Matrix, Symmetric, Vector},
    geometry::Rotation,
    given,
    id::{BodyId, BodyMap},
    recursive::links::inertia,
    tree::{InertialParameter, N_INERTIAL, Tree, regressor_place},
};

/// The columns of a body that its lower body's give.
#[derive(Clone, Debug, Default)]
pub(super) enum Shared {
    #[default]
    Nothing,
    OnAxis(OnAxis),
    /// Of a body that turns as its lower body does, all components of the inertia.
    Inertia(Vec<Symmetric>),
}

/// Mass, first and second moment along a joint's axis. All vectors are along the lower body's user axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct OnAxis {
    /// The user's axis that is the joint's.
    own: usize,
    /// Of the two moments of inertia about axes across it the one that is given, with as much of the one that is kept.
    given: usize,
    kept: usize,
    /// The direction of the axis.
    axis: Vector,
    /// From the lower body's user origin to the body's: the part across the axis, and the length along it.
    across: Vector,
    along: Expr,
}

/// What each body's lower body gives, where the plan regroups it.
pub(super) fn shared(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> BodyMap<Shared> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let choice = plan.regroup(body);
        match tree.lower(body) {
            Some(lower) if choice != Regroup::None => of_body(graph, tree, body, lower, choice),
            _ => Shared::default(),
        }
    })
}

fn of_body(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    lower: BodyId,
    choice: Regroup,
) -> Shared {
    let joint = &tree.body(body).joint;
    let Some(axis) = joint.hinge_axis() else {
        let turns_as_lower = joint.only_translates();
        return if turns_as_lower {
            turning_as_lower(graph, tree, body, lower)
        } else {
            Shared::default()
        };
    };
    let pose = &tree.body(body).pose;
    // The axis along the user's axes.
    let along = pose.rotation.map(|row| row[axis.index()]);
    let origin = given::fixed(graph, &pose.origin);
    let (b, c) = axis.others();
    let is_on_axis = graph.is_zero(origin[b]) && graph.is_zero(origin[c]);
    let own =
        (0..3).find(|&i| along[i].abs() == 1.0 && along.iter().filter(|x| **x != 0.0).count() == 1);
    match own.filter(|_| is_on_axis) {
        Some(own) => Shared::OnAxis(on_axis(graph, tree, [body, lower], own, choice)),
        None => Shared::default(),
    }
}

/// Mass, first and second moment along the user's axis `own`, which is the joint's.
fn on_axis(
    graph: &mut ExprGraph,
    tree: &Tree,
    [body, lower]: [BodyId; 2],
    own: usize,
    choice: Regroup,
) -> OnAxis {
    let (b, c) = ((own + 1) % 3, (own + 2) % 3);
    let (kept, given) = if choice == Regroup::Last {
        (c, b)
    } else {
        (b, c)
    };
    let axis = axes(graph, tree, body, lower)[own];
    let point = origin(graph, tree, body, lower);
    let along = graph.dot(axis, point);
    let part = graph.scale(along, axis);
    OnAxis {
        own,
        given: component(given, given),
        kept: component(kept, kept),
        axis,
        across: graph.sub_vectors(point, part),
        along,
    }
}

/// All of the inertia.
fn turning_as_lower(graph: &mut ExprGraph, tree: &Tree, body: BodyId, lower: BodyId) -> Shared {
    let axes = axes(graph, tree, body, lower);
    let tensors = InertialParameter::COMPONENTS
        .map(|[row, column]| product(graph, axes[row], axes[column], row == column));
    Shared::Inertia(tensors.to_vec())
}

/// The user's axes of a body along those of its lower body, where its joint does not turn it; of a hinge the axis alone means
/// anything.
fn axes(graph: &mut ExprGraph, tree: &Tree, body: BodyId, lower: BodyId) -> Matrix {
    let (own, below) = (
        &tree.body(body).pose.rotation,
        &tree.body(lower).pose.rotation,
    );
    let to_lower = |row: [f64; 3]| {
        let in_lower = apply_back(&tree.body(body).joint.rotation, row);
        below.map(|axis| (0..3).map(|i| axis[i] * in_lower[i]).sum::<f64>())
    };
    own.map(|row| to_lower(row).map(|entry| graph.number(entry)))
}

/// From the user's origin of the lower body to a body's, which its joint does not move: the lower body's user axes.
fn origin(graph: &mut ExprGraph, tree: &Tree, body: BodyId, lower: BodyId) -> Vector {
    let pose = &tree.body(body).pose;
    let offset = given::offset(graph, tree.body(body));
    let own = given::fixed(graph, &pose.origin);
    let own = given::constant_back(graph, &tree.body(body).joint.rotation, own);
    let below = &tree.body(lower).pose;
    let from = given::fixed(graph, &below.origin);
    let sum = graph.add_vectors(offset, own);
    let from_lower = graph.sub_vectors(sum, from);
    let axes = given::constant(graph, &below.rotation);
    graph.mul_vector(&axes, from_lower)
}

fn apply_back(rotation: &Rotation, v: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|j| (0..3).map(|i| rotation[i][j] * v[i]).sum())
}

/// The place of a component of the inertia among the parameters.
pub(super) fn component(row: usize, column: usize) -> usize {
    let ordered = [row.min(column), row.max(column)];
    let found = InertialParameter::COMPONENTS
        .iter()
        .position(|place| *place == ordered);
    4 + found.expect("shared: the six components are listed")
}

/// `a b^T + b a^T`, or half of it where `a` and `b` are one.
fn product(graph: &mut ExprGraph, a: Vector, b: Vector, are_one: bool) -> Symmetric {
    let factor = graph.number(if are_one { 0.5 } else { 1.0 });
    let mut tensor = graph.zero_symmetric();
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let square = graph.mul(a[i], b[i]);
        let both = graph.add(square, square);
        tensor.diagonal[i] = graph.mul(factor, both);
        let (first, second) = (graph.mul(a[j], b[k]), graph.mul(a[k], b[j]));
        let both = graph.add(first, second);
        tensor.mixed[i] = graph.mul(factor, both);
    }
    tensor
}

/// The entries of a lower body's columns of one speed.
struct Lower<'a> {
    entries: &'a [Expr],
}

impl Lower<'_> {
    fn moment(&self, axis: usize) -> Expr {
        self.entries[1 + axis]
    }

    fn inertia(&self, row: usize, column: usize) -> Expr {
        self.entries[component(row, column)]
    }

    /// What a body of this inertia needs.
    fn of_inertia(&self, graph: &mut ExprGraph, tensor: &Symmetric) -> Expr {
        InertialParameter::COMPONENTS
            .into_iter()
            .fold(graph.zero(), |sum, [row, column]| {
                let entry = self.inertia(row, column);
                let term = graph.mul(tensor.entry(row, column), entry);
                graph.add(sum, term)
            })
    }

    /// What a mass of one needs at a point.
    fn of_mass(&self, graph: &mut ExprGraph, point: Vector) -> Expr {
        let mut sum = self.entries[0];
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let around = graph.add(self.inertia(j, j), self.inertia(k, k));
            let of_square = graph.mul(point[i], around);
            let mut factor = graph.add(self.moment(i), of_square);
            for (other, &along) in point.iter().enumerate().skip(i + 1) {
                let of_product = graph.mul(along, self.inertia(i, other));
                factor = graph.sub(factor, of_product);
            }
            let share = graph.mul(point[i], factor);
            sum = graph.add(sum, share);
        }
        sum
    }
}

impl OnAxis {
    /// Of one speed: what mass, first moment and the given moment of inertia need. With `S` for a second moment along the axis,
    /// a mass of one that has first moment `H` there has `H + 2 z S` farther along by `z`, and needs `z` times their mean more.
    fn of_lower(&self, graph: &mut ExprGraph, lower: &Lower<'_>, kept: Expr) -> [Expr; 3] {
        let [one, two, half] = [1.0, 2.0, 0.5].map(|number| graph.number(number));
        let along_axis = inertia::around(graph, [self.axis, self.axis], one);
        let second = lower.of_inertia(graph, &along_axis);
        let beside = inertia::around(graph, [self.axis, self.across], two);
        let mut nearest = lower.of_inertia(graph, &beside);
        for i in 0..3 {
            let share = graph.mul(self.axis[i], lower.moment(i));
            nearest = graph.add(share, nearest);
        }
        let twice = graph.mul(two, self.along);
        let farther = graph.mul(twice, second);
        let first = graph.add(nearest, farther);
        let half = graph.mul(half, self.along);
        let both = graph.add(nearest, first);
        let more = graph.mul(half, both);
        let across = lower.of_mass(graph, self.across);
        [graph.add(across, more), first, graph.sub(second, kept)]
    }
}

impl Shared {
    /// True for a parameter whose column the lower body's give.
    pub(super) fn gives(&self, parameter: usize) -> bool {
        match self {
            Self::Nothing => false,
            Self::OnAxis(shared) => [0, 1 + shared.own, shared.given].contains(&parameter),
            Self::Inertia(_) => parameter >= 4,
        }
    }

    /// The user's axis that is the hinge's, where there is one.
    pub(super) fn hinge_axis(&self) -> Option<usize> {
        match self {
            Self::OnAxis(shared) => Some(shared.own),
            Self::Nothing | Self::Inertia(_) => None,
        }
    }

    /// Writes these columns of a body, once those of its lower body are whole.
    pub(super) fn fill(&self, graph: &mut ExprGraph, tree: &Tree, body: BodyId, y: &mut [Expr]) {
        let Some(lower) = tree.lower(body) else {
            return;
        };
        for speed in 0..tree.n_speeds {
            let first = regressor_place(tree, speed, lower, 0);
            let entries = y[first..first + N_INERTIAL].to_vec();
            let lower = Lower { entries: &entries };
            let own = regressor_place(tree, speed, body, 0);
            match self {
                Self::Nothing => {}
                Self::OnAxis(shared) => {
                    let kept = y[own + shared.kept];
                    let [mass, first, given] = shared.of_lower(graph, &lower, kept);
                    y[own] = mass;
                    y[own + 1 + shared.own] = first;
                    y[own + shared.given] = given;
                }
                Self::Inertia(tensors) => {
                    for (place, tensor) in tensors.iter().enumerate() {
                        y[own + 4 + place] = lower.of_inertia(graph, tensor);
                    }
                }
            }
        }
    }
}
