//! Functions of random systems, evaluated as the programs that would be emitted.

use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex},
};

use kane_codegen::{
    expr::{Expr, ExprGraph, Input},
    functions::{CompactBlock, Formulation, Function},
    passes::{factor, hoist},
    program::{self, Program},
    recursive::Plan,
    tree::Tree,
};
use kane_test_support::{
    dynamics::{
        Model, State,
        composition::Composition,
        state::{FRAME_FORCE, FRAME_MOMENT, FRAME_POINT},
    },
    systems::{RandomSystem, tree},
};

/// A system, evaluated through the programs of one formulation.
pub(crate) struct Evaluator {
    name: String,
    composition: Arc<Composition>,
    formulation: Formulation,
    plan: Plan,
    functions: Mutex<BTreeMap<&'static str, Arc<Flat>>>,
}

/// A function as it would be emitted.
struct Flat {
    program: Program,
    blocks: Vec<CompactBlock>,
    prepared: Vec<f64>,
}

impl Evaluator {
    /// With every technique where the formulation has any.
    pub(crate) fn new(system: &RandomSystem, formulation: Formulation) -> Self {
        Self::of(&system.name, &system.toml(), formulation)
    }

    /// A description that is accepted, in our own format.
    pub(crate) fn of(name: &str, text: &str, formulation: Formulation) -> Self {
        let tree = tree(text).expect("the description is accepted");
        Self {
            name: format!("{name} in formulation {}", formulation.name()),
            plan: Plan::full(&tree),
            composition: Arc::new(Composition::new(text, &tree)),
            formulation,
            functions: Mutex::default(),
        }
    }

    /// The same system by another formulation or plan.
    pub(crate) fn otherwise(&self, formulation: Formulation, plan: Plan) -> Self {
        Self {
            name: format!("{} and in {}", self.name, formulation.name()),
            composition: Arc::clone(&self.composition),
            formulation,
            plan,
            functions: Mutex::default(),
        }
    }

    fn flat(&self, function: &str) -> Arc<Flat> {
        let function = Function::find(function).expect("a function of the catalogue");
        let mut functions = self.functions.lock().expect("no test panics in here");
        let flat = functions
            .entry(function.name)
            .or_insert_with(|| Arc::new(flat(self.tree(), function, self.formulation, &self.plan)));
        Arc::clone(flat)
    }
}

impl Model for Evaluator {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn composition(&self) -> &Composition {
        &self.composition
    }

    fn evaluate(&self, function: &str, state: &State) -> Vec<f64> {
        let flat = self.flat(function);
        let values = flat.program.evaluate(|given| match given {
            Input::Prepared(place) => flat.prepared[place],
            given => input(self.tree(), state, given),
        });
        if Function::find(function).is_some_and(Function::is_compact) {
            dense(self.tree(), &flat.blocks, &values)
        } else {
            values
        }
    }
}

/// Derives, factors, hoists and flattens.
fn flat(tree: &Tree, function: &'static Function, formulation: Formulation, plan: &Plan) -> Flat {
    let derived = function.derive(tree, formulation, plan);
    let (graph, roots) = if function.is_compact() {
        (derived.graph, derived.roots)
    } else {
        factor::run(derived.graph, derived.roots)
    };
    let (graph, roots, prepared) = hoisted(tree, &graph, &roots);
    Flat {
        program: program::flatten(&graph, &roots),
        blocks: derived.blocks,
        prepared,
    }
}

/// The graph inside the loop, and the values of what is outside.
pub(crate) fn hoisted(
    tree: &Tree,
    graph: &ExprGraph,
    roots: &[Expr],
) -> (ExprGraph, Vec<Expr>, Vec<f64>) {
    let mut preparation = hoist::Preparation::default();
    let (graph, roots) = hoist::run(graph, roots, "f", &mut preparation);
    let prepared = preparation
        .graph
        .evaluate(&preparation.roots(), |given| match given {
            Input::Parameter(id) => tree.parameters[id.index()].nominal,
            other => unreachable!("{other:?} is no parameter"),
        });
    (graph, roots, prepared)
}

/// A number of a direction or multiplier, none like another.
pub(crate) fn product(of: usize, place: usize) -> f64 {
    libm::sin(1.3 * of as f64 + 0.7 * place as f64)
}

pub(crate) fn input(tree: &Tree, state: &State, given: Input) -> f64 {
    match given {
        Input::Q(id) => state.q[id.index()],
        Input::U(id) => state.u[id.index()],
        Input::UDot(id) => state.u_dot[id.index()],
        Input::Tau(id) => state.tau[id.index()],
        Input::Force(body, axis) => state.loads[body.index()][axis],
        Input::Moment(body, axis) => state.loads[body.index()][3 + axis],
        Input::RelativeAngularVelocity(body, axis) => state.w_rel[body.index()][axis],
        Input::Point(axis) => FRAME_POINT[axis],
        Input::FrameForce(axis) => FRAME_FORCE[axis],
        Input::FrameMoment(axis) => FRAME_MOMENT[axis],
        Input::Product(of, place) => product(of, place),
        Input::Shared(_) | Input::Side(_) | Input::CallResult(_) => {
            unreachable!("calls compute these")
        }
        Input::Parameter(id) => tree.parameters[id.index()].nominal,
        Input::Sine(place) => libm::sin(state.q[tree.angles()[place].coordinate.index()]),
        Input::Cosine(place) => libm::cos(state.q[tree.angles()[place].coordinate.index()]),
        Input::Prepared(_) => unreachable!("prepared values are hoisted"),
    }
}

fn dense(tree: &Tree, blocks: &[CompactBlock], columns: &[f64]) -> Vec<f64> {
    let width = tree.n_speeds;
    let mut dense = vec![0.0; tree.bodies.len() * 3 * width];
    for block in blocks {
        for column in 0..block.columns {
            for row in 0..3 {
                // Several columns of one speed are added: joints that follow others have some.
                dense[(block.body * 3 + row) * width + block.speed + column] +=
                    columns[3 * (block.first + column) + row];
            }
        }
    }
    dense
}
