//! Hoist. Needs: nothing. Afterwards: a function's graph holds no operation that depends on parameters alone, and no
//! parameter: each such value is an input `Prepared(i)`, computed once in [`Preparation`]. What two functions need is
//! computed once, but each has a field of its own for it, so that no function's text depends on another; plain parameters
//! are shared.
//! Keeps: the value of every root. Does not: move numbers, which cost nothing.

use std::collections::BTreeMap;

use crate::{
    expr::{Binding, Expr, ExprGraph, Input, Node, NodeId, Rebuilt},
    id::BodyId,
};

/// The values that depend on parameters alone.
#[derive(Clone, Debug, Default)]
pub struct Preparation {
    /// Their graph, whose inputs are parameters.
    pub graph: ExprGraph,
    /// The values in the order of `Input::Prepared`.
    pub fields: Vec<Field>,
    /// The places of fields by their nodes: one for each function that needs the value.
    places: BTreeMap<NodeId, Vec<usize>>,
}

/// A value that depends on parameters alone.
#[derive(Clone, Debug)]
pub struct Field {
    /// The function that needs it; `None` for a parameter, which all share.
    pub function: Option<String>,
    /// The body that it belongs to.
    pub scope: Option<BodyId>,
    /// What the function calls it.
    pub label: Option<String>,
    /// The value, with the sign that its label means.
    pub root: Expr,
}

/// The graph with the parameters' own work taken out, and its roots.
pub fn run(
    old: &ExprGraph,
    roots: &[Expr],
    function: &str,
    preparation: &mut Preparation,
) -> (ExprGraph, Vec<Expr>) {
    let needed = old.reachable(roots);
    let mut outside = Rebuilt::new(old);
    let mut inside = Rebuilt::new(old);
    let mut graph = ExprGraph::with_capacity(old.len());
    for id in old.ids().filter(|id| needed[id.index()]) {
        if old.binding(id) != Binding::State {
            preparation.graph.enter_like(old, id);
            let expr = outside.copy(&mut preparation.graph, old, id);
            preparation.graph.name_like(expr, old, id);
            outside.set(id, expr);
        }
    }
    let mut boundary = vec![false; old.len()];
    for id in old
        .ids()
        .filter(|id| needed[id.index()] && old.binding(*id) == Binding::State)
    {
        for operand in old.node(id).operands() {
            boundary[operand.index()] = true;
        }
    }
    let called = old.called(|id| needed[id.index()]);
    for root in roots.iter().chain(&called) {
        boundary[root.node().index()] = true;
    }
    for id in old.ids().filter(|id| needed[id.index()]) {
        graph.enter_like(old, id);
        let expr = match old.binding(id) {
            Binding::Parameters if !boundary[id.index()] => continue,
            Binding::Parameters => {
                preparation.take(&mut graph, outside.node(id), function, old, id)
            }
            Binding::Number | Binding::State => inside.copy(&mut graph, old, id),
        };
        graph.name_like(expr, old, id);
        inside.set(id, expr);
    }
    let roots = roots.iter().map(|&root| inside.expr(root)).collect();
    (graph, roots)
}

impl Preparation {
    /// The values of the fields.
    pub fn roots(&self) -> Vec<Expr> {
        self.fields.iter().map(|field| field.root).collect()
    }

    /// A value of the preparation as an input of the function in whose graph it is `id`.
    fn take(
        &mut self,
        graph: &mut ExprGraph,
        value: Expr,
        function: &str,
        old: &ExprGraph,
        id: NodeId,
    ) -> Expr {
        if let Node::Number(bits) = self.graph.node(value.node()) {
            return graph
                .number(f64::from_bits(bits))
                .signed(value.is_negative());
        }
        let is_parameter = matches!(self.graph.node(value.node()), Node::Input(_));
        let function = Some(function).filter(|_| !is_parameter);
        let fields = &mut self.fields;
        let places = self.places.entry(value.node()).or_default();
        let known = |place: &&usize| fields[**place].function.as_deref() == function;
        let place = places.iter().find(known).copied();
        let place = place.unwrap_or_else(|| {
            let label = old.label(id);
            let negative = value.is_negative() ^ label.is_some_and(|label| label.negative);
            fields.push(Field {
                function: function.map(str::to_owned),
                scope: old.scope(id),
                label: label.map(|label| label.text.clone()),
                root: value.abs_sign().signed(negative),
            });
            places.push(fields.len() - 1);
            fields.len() - 1
        });
        let negative = value.is_negative() ^ self.fields[place].root.is_negative();
        graph.input(Input::Prepared(place)).signed(negative)
    }
}
