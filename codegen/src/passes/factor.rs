//! Factor. Needs: nothing. Afterwards: no sum whose products all belong to its own body has two with a common factor,
//! `a b + a c`, where nothing else uses the products; each became `a (b + c)`. Nor has a body's part of a sum two terms that are
//! known before the loop: they are added up last. Keeps: the value of every root, up to rounding. Never raises the number of
//! operations in the loop. Does not: touch a labelled value, one that is used twice, or a sum that takes a product of another
//! body, for what one body's terms have in common must not change another body's lines.

use crate::expr::{Binding, Expr, ExprGraph, Node, NodeId, Rebuilt};

/// The graph with its sums factored, and its roots.
pub fn run(mut graph: ExprGraph, mut roots: Vec<Expr>) -> (ExprGraph, Vec<Expr>) {
    // What was pulled out of a sum can leave another sum behind. Each round lowers the count in the loop, so the rounds end.
    while let Some(next) = once(&graph, &roots) {
        (graph, roots) = next;
    }
    (graph, roots)
}

/// One round; `None` where there is nothing to factor.
fn once(old: &ExprGraph, roots: &[Expr]) -> Option<(ExprGraph, Vec<Expr>)> {
    let sums = Sums::new(old, roots);
    let factored = sums.all_factored();
    if factored.is_empty() {
        return None;
    }
    let mut factored = factored.into_iter().peekable();
    let mut graph = ExprGraph::with_capacity(old.len());
    let mut rebuilt = Rebuilt::new(old);
    for id in old.ids().filter(|id| sums.uses[id.index()] > 0) {
        graph.enter_like(old, id);
        let expr = match factored.next_if(|(head, _)| *head == id) {
            None => rebuilt.copy(&mut graph, old, id),
            Some((_, terms)) => build_sum(&mut graph, &rebuilt, &terms),
        };
        graph.name_like(expr, old, id);
        rebuilt.set(id, expr);
    }
    let roots = roots.iter().map(|&root| rebuilt.expr(root)).collect();
    Some((graph, roots))
}

/// A term of a sum.
#[derive(Clone, Debug)]
enum Term {
    /// A node that stays as it is.
    Whole(Expr),
    /// A product that only this sum uses.
    Product {
        negative: bool,
        factors: [NodeId; 2],
    },
    /// A factor times the sum of what it multiplied.
    Factored { factor: NodeId, rest: Vec<Expr> },
    /// The sum of those that are known before the loop.
    Known(Vec<Term>),
}

struct Sums<'a> {
    graph: &'a ExprGraph,
    uses: Vec<u32>,
    /// Sums that are part of a longer sum of the same body, and of nothing else.
    absorbed: Vec<bool>,
}

impl<'a> Sums<'a> {
    fn new(graph: &'a ExprGraph, roots: &[Expr]) -> Self {
        let mut sums = Self {
            graph,
            uses: graph.uses(roots),
            absorbed: vec![false; graph.len()],
        };
        for id in graph.ids().filter(|id| sums.uses[id.index()] > 0) {
            if !sums.is_local_sum(id) {
                continue;
            }
            for operand in graph.node(id).operands() {
                let same_body = graph.scope(operand) == graph.scope(id);
                sums.absorbed[operand.index()] =
                    same_body && sums.is_private(operand) && sums.is_local_sum(operand);
            }
        }
        sums
    }

    /// True for a value of the loop without a label that is used once. What depends on parameters alone costs nothing
    /// there, and would if it were joined to what does not.
    fn is_private(&self, id: NodeId) -> bool {
        let in_loop = self.graph.binding(id) == Binding::State;
        let is_free = self.graph.label(id).is_none_or(|label| label.is_hint);
        in_loop && self.uses[id.index()] == 1 && is_free
    }

    /// True for a sum that takes no product of another body's: there one body is joined to another.
    fn is_local_sum(&self, id: NodeId) -> bool {
        let foreign = |operand: NodeId| {
            let is_product =
                matches!(self.graph.node(operand), Node::Mul(..)) && self.is_private(operand);
            is_product && self.graph.scope(operand) != self.graph.scope(id)
        };
        let node = self.graph.node(id);
        matches!(node, Node::Add(..)) && !node.operands().any(foreign)
    }

    /// The sums in which there is something to factor, in order, with their terms afterwards.
    fn all_factored(&self) -> Vec<(NodeId, Vec<Term>)> {
        let is_head = |id: &NodeId| {
            self.uses[id.index()] > 0 && !self.absorbed[id.index()] && self.is_local_sum(*id)
        };
        let heads = self.graph.ids().filter(is_head);
        heads
            .filter_map(|id| Some((id, self.factored(id)?)))
            .collect()
    }

    /// The terms of a sum after factoring; `None` where there is nothing to factor.
    fn factored(&self, head: NodeId) -> Option<Vec<Term>> {
        let mut terms = self.terms(head);
        let mut changed = false;
        while let Some(factor) = common_factor(&terms) {
            terms = pull_out(terms, factor);
            changed = true;
        }
        // In a sum that is known as a whole all terms are, and gathering them would change nothing, round after round.
        let in_loop = self.graph.binding(head) == Binding::State;
        if in_loop && terms.iter().filter(|term| self.is_known(term)).count() > 1 {
            let (known, mut others): (Vec<_>, Vec<_>) =
                terms.into_iter().partition(|term| self.is_known(term));
            others.push(Term::Known(known));
            return Some(others);
        }
        changed.then_some(terms)
    }

    /// True for what is known before the loop.
    fn is_known(&self, term: &Term) -> bool {
        matches!(term, Term::Whole(expr) if self.graph.binding(expr.node()) != Binding::State)
    }

    /// The terms of a sum from left to right.
    fn terms(&self, head: NodeId) -> Vec<Term> {
        let mut terms = Vec::new();
        let mut pending = vec![Expr::of(head)];
        while let Some(expr) = pending.pop() {
            let id = expr.node();
            match self.graph.node(id) {
                Node::Add(a, b) if id == head || self.absorbed[id.index()] => {
                    pending.push(b.signed(expr.is_negative()));
                    pending.push(a.signed(expr.is_negative()));
                }
                Node::Mul(a, b) if self.is_private(id) => {
                    terms.push(Term::Product {
                        negative: expr.is_negative(),
                        factors: [a, b],
                    });
                }
                _ => terms.push(Term::Whole(expr)),
            }
        }
        terms
    }
}

/// The factor that most products share, the first of several; `None` where no two share one.
fn common_factor(terms: &[Term]) -> Option<NodeId> {
    let mut best: Option<(usize, NodeId)> = None;
    for term in terms {
        let Term::Product { factors, .. } = term else {
            continue;
        };
        for &factor in factors {
            let sharing = terms.iter().filter(|term| has_factor(term, factor)).count();
            if sharing > best.map_or(1, |(most, _)| most) {
                best = Some((sharing, factor));
            }
        }
    }
    best.map(|(_, factor)| factor)
}

fn has_factor(term: &Term, factor: NodeId) -> bool {
    matches!(term, Term::Product { factors, .. } if factors.contains(&factor))
}

/// The terms with one factor pulled out, in the place of the first product that had it.
fn pull_out(terms: Vec<Term>, factor: NodeId) -> Vec<Term> {
    let mut rest = Vec::new();
    let mut place = None;
    let mut kept = Vec::with_capacity(terms.len());
    for term in terms {
        match term {
            Term::Product { negative, factors } if factors.contains(&factor) => {
                place.get_or_insert(kept.len());
                let other = if factors[0] == factor {
                    factors[1]
                } else {
                    factors[0]
                };
                rest.push(Expr::of(other).signed(negative));
            }
            _ => kept.push(term),
        }
    }
    kept.insert(
        place.expect("factor: the factor is one of a term's"),
        Term::Factored { factor, rest },
    );
    kept
}

fn build_sum(graph: &mut ExprGraph, rebuilt: &Rebuilt, terms: &[Term]) -> Expr {
    let mut sum = graph.zero();
    for term in terms {
        let term = match term {
            Term::Known(known) => build_sum(graph, rebuilt, known),
            Term::Whole(expr) => rebuilt.expr(*expr),
            Term::Product {
                negative,
                factors: [a, b],
            } => graph
                .mul(rebuilt.node(*a), rebuilt.node(*b))
                .signed(*negative),
            Term::Factored { factor, rest } => {
                let mut inner = graph.zero();
                for &other in rest {
                    inner = graph.add(inner, rebuilt.expr(other));
                }
                graph.mul(rebuilt.node(*factor), inner)
            }
        };
        sum = graph.add(sum, term);
    }
    sum
}
