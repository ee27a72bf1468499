//! What a joint does not move of a body's inertia, as parameters of its lower body.
//!
//! A mass on the axis of a hinge moves as a point of the lower body does, and so do a first and a second moment along the axis;
//! what only translates turns as its lower body does. The columns of such parameters are constant sums of the lower body's for
//! every speed below the joint, and zero for the joint's own: base inertial parameters (Khalil and Kleinfinger 1987), read the
//! other way round.

use super::plan::{Plan, Regroup};
use crate::{
    expr::{Expr, ExprGraph, Matrix, Symmetric, Vector},
    geometry::Rotation,
    given,
    id::{BodyId, BodyMap},
    kane::regressor::{COMPONENTS, PARAMETERS, place},
    tree::Tree,
};

/// The columns of a body that its lower body's give.
#[derive(Clone, Debug, Default)]
pub(super) struct Shared {
    given: Vec<Given>,
}

/// One of them.
#[derive(Clone, Debug)]
struct Given {
    parameter: usize,
    /// What a unit of it, with as much of `beside`, is in parameters of the lower body.
    of_lower: [Expr; PARAMETERS.len()],
    beside: Option<usize>,
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
        Some(own) => on_axis(graph, tree, [body, lower], own, choice),
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
) -> Shared {
    let n = axes(graph, tree, body, lower)[own];
    let p = origin(graph, tree, body, lower);
    let (b, c) = ((own + 1) % 3, (own + 2) % 3);
    let (kept, given) = if choice == Regroup::Last {
        (c, b)
    } else {
        (b, c)
    };
    let (zero, one) = (graph.zero(), graph.one());
    let two = graph.number(2.0);
    let around_point = around(graph, [p, p], one);
    let around_both = around(graph, [n, p], two);
    let around_axis = around(graph, [n, n], one);
    let none = graph.zero_vector();
    Shared {
        given: vec![
            Given {
                parameter: 0,
                of_lower: parameters(one, p, &around_point),
                beside: None,
            },
            Given {
                parameter: 1 + own,
                of_lower: parameters(zero, n, &around_both),
                beside: None,
            },
            Given {
                parameter: component(given, given),
                of_lower: parameters(zero, none, &around_axis),
                beside: Some(component(kept, kept)),
            },
        ],
    }
}

/// All of the inertia.
fn turning_as_lower(graph: &mut ExprGraph, tree: &Tree, body: BodyId, lower: BodyId) -> Shared {
    let axes = axes(graph, tree, body, lower);
    let (zero, none) = (graph.zero(), graph.zero_vector());
    let given = COMPONENTS.map(|[row, column]| {
        let tensor = product(graph, axes[row], axes[column], row == column);
        Given {
            parameter: component(row, column),
            of_lower: parameters(zero, none, &tensor),
            beside: None,
        }
    });
    Shared {
        given: given.to_vec(),
    }
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
fn component(row: usize, column: usize) -> usize {
    let found = COMPONENTS.iter().position(|place| *place == [row, column]);
    4 + found.expect("shared: the six components are listed")
}

/// `factor ((a·b) 1 - (a b^T + b a^T) / 2)`: a second moment as an inertia.
fn around(graph: &mut ExprGraph, [a, b]: [Vector; 2], factor: Expr) -> Symmetric {
    let half = graph.number(0.5);
    let mut tensor = graph.zero_symmetric();
    let products: Vector = std::array::from_fn(|i| {
        let square = graph.mul(a[i], b[i]);
        graph.mul(factor, square)
    });
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        tensor.diagonal[i] = graph.add(products[j], products[k]);
        let (first, second) = (graph.mul(a[j], b[k]), graph.mul(a[k], b[j]));
        let both = graph.add(first, second);
        let both = graph.mul(factor, both);
        tensor.mixed[i] = -graph.mul(half, both);
    }
    tensor
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

fn parameters(mass: Expr, moment: Vector, inertia: &Symmetric) -> [Expr; PARAMETERS.len()] {
    std::array::from_fn(|parameter| match parameter {
        0 => mass,
        1..4 => moment[parameter - 1],
        _ => {
            let [row, column] = COMPONENTS[parameter - 4];
            inertia.entry(row, column)
        }
    })
}

impl Shared {
    /// True for a parameter whose column the lower body's give.
    pub(super) fn gives(&self, parameter: usize) -> bool {
        self.given.iter().any(|given| given.parameter == parameter)
    }

    /// Writes these columns of a body, once those of its lower body are whole.
    pub(super) fn fill(&self, graph: &mut ExprGraph, tree: &Tree, body: BodyId, y: &mut [Expr]) {
        let Some(lower) = tree.lower(body) else {
            return;
        };
        for given in &self.given {
            for speed in 0..tree.n_speeds {
                let mut sum = graph.zero();
                for (parameter, &factor) in given.of_lower.iter().enumerate() {
                    let term = graph.mul(factor, y[place(tree, speed, lower, parameter)]);
                    sum = graph.add(sum, term);
                }
                if let Some(beside) = given.beside {
                    sum = graph.sub(sum, y[place(tree, speed, body, beside)]);
                }
                y[place(tree, speed, body, given.parameter)] = sum;
            }
        }
    }
}
