//! The derivation of a request: all its parts in one graph, where what they share is built once.
//!
//! In: a request, a tree, by which plan each part is derived. Out: [`Derived`].

use super::{
    arrangement::Arrangement, derived::Derived, formulation::Formulation, function::Function,
    part::Part, request::Request, told::Told,
};
use crate::{
    differentiate::Sweep,
    expr::ExprGraph,
    recursive::{Plan, Technique},
    tree::Tree,
};

/// About how many nodes the dynamics of a body are.
const NODES_PER_BODY: usize = 250;

impl Request {
    /// Derives all parts by one plan.
    pub fn derive(&self, tree: &Tree, formulation: Formulation, plan: &Plan) -> Derived {
        let arrangement = self.arranged_by(tree, plan);
        self.derive_arranged(tree, &arrangement.with_formulation(formulation))
    }

    /// Derives all parts, each in its formulation by its plan, or read off what others find where the arrangement says so. One that has
    /// a single formulation takes no notice of another, and only what needs a plan of its plan.
    pub fn derive_arranged(&self, tree: &Tree, arrangement: &Arrangement) -> Derived {
        let mut derived = Derived {
            graph: ExprGraph::with_capacity(NODES_PER_BODY * tree.bodies.len()),
            ..Derived::default()
        };
        let parts = self.parts();
        let mut roots = vec![Vec::new(); parts.len()];
        let mut told = Told::default();
        for place in self.order() {
            let (part, plan) = (&parts[place], arrangement.plan(place));
            let formulation = arrangement.formulation(place);
            derived.graph.enter(None);
            let is_read_off = arrangement.is_read_off(place);
            if let Some(entries) = part.told_by(&mut derived.graph, tree, plan, &told, is_read_off)
            {
                roots[place] = entries;
                continue;
            }
            let found = if self.is_asked(arrangement, part) {
                part.derive_with_matrices(&mut derived, tree, formulation, plan)
            } else {
                part.derive_in(&mut derived, tree, formulation, plan)
            };
            told.extend(found, part.derivative.is_some());
            roots[place] = std::mem::take(&mut derived.roots);
        }
        derived.roots = roots.concat();
        derived
    }

    /// The recursion by one plan for all parts. Where one row is to be carried through a derivative it is, whatever is swept beside it. Second
    /// derivatives go over a gradient that is carried back: one that is asked for beside them is the same.
    pub fn arranged_by(&self, tree: &Tree, plan: &Plan) -> Arrangement {
        let derivatives = self.parts().iter().filter(|part| part.derivative.is_some());
        let has_several = derivatives.count() > 1;
        let of_part = |part: &Part| {
            if part.derivative.is_none() {
                // How derivatives are found says nothing.
                let plan = plan.with(Technique::DirectDerivatives, false);
                return plan.with(Technique::Reverse, false);
            }
            let sweep = has_several.then(|| part.one_row_sweep(tree)).flatten();
            match sweep {
                Some(sweep) => plan.with(Technique::Reverse, sweep == Sweep::Reverse),
                None => plan.clone(),
            }
        };
        Arrangement::new(self.parts().iter().map(of_part))
    }

    /// True where columns may go several at a time, if parts are derived by these plans.
    pub fn has_columns(&self, arrangement: &Arrangement) -> bool {
        let mut parts = self.parts().iter().enumerate();
        parts.any(|(place, part)| part.has_columns(arrangement.plan(place)))
    }

    /// True where a part may be read off what another finds, if that is derived by its plan.
    pub fn may_read_off(&self, arrangement: &Arrangement, place: usize) -> bool {
        let read = &self.parts()[place];
        let mut others = self.parts().iter().enumerate();
        others.any(|(other, part)| {
            let is_direct = arrangement.plan(other).uses(Technique::DirectDerivatives);
            part.finds_matrix_of(read)
                && arrangement.formulation(other) == Formulation::Recursive
                && (is_direct || part.derivative.is_none())
        })
    }

    /// True where some other part is to be read off what this one finds.
    fn is_asked(&self, arrangement: &Arrangement, part: &Part) -> bool {
        let mut others = self.parts().iter().enumerate();
        others.any(|(place, other)| arrangement.is_read_off(place) && part.finds_matrix_of(other))
    }

    /// The places of the parts in the order in which they are derived: values come after derivatives that may tell them.
    fn order(&self) -> Vec<usize> {
        let parts = self.parts();
        let is_told = |place: &usize| {
            let mut others = parts.iter();
            others.any(|other| other.may_tell(&parts[*place]))
        };
        let (last, mut order): (Vec<_>, Vec<_>) = (0..parts.len()).partition(is_told);
        order.extend(last);
        order
    }
}

impl Function {
    /// Derives a function of the whole system; one that has a single formulation takes no notice of `formulation`, and only
    /// the recursive one of `plan`.
    pub fn derive(&'static self, tree: &Tree, formulation: Formulation, plan: &Plan) -> Derived {
        Request::from(self).derive(tree, formulation, plan)
    }
}
