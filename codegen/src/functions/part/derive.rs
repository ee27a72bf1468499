//! From a part to the expressions of its outputs.

use super::Part;
use crate::{
    functions::{
        derivatives::{
            derivative::{Asked, sweep},
            solved::Solution,
        },
        derived::Derived,
        formulation::Formulation,
        told::Told,
    },
    recursive::{Plan, Technique},
    tree::{Tree, Value},
};

impl Part {
    /// By what it is derived. The recursion relies on rotations being orthonormal, which they are not where an entry changes
    /// alone.
    fn formulation(&self, tree: &Tree, wanted: Formulation) -> Formulation {
        if self.function.formulations().contains(&wanted) && !self.is_by_turn(tree) {
            wanted
        } else {
            Formulation::Notes
        }
    }

    /// True where an entry of its frames' rotations is a variable.
    fn is_by_turn(&self, tree: &Tree) -> bool {
        let (Some(subject), Some(derivative)) = (&self.subject, &self.derivative) else {
            return false;
        };
        let frames = subject.frames.iter();
        let turns = frames.filter_map(|frame| tree.frame_turn(frame.frame));
        let mut entries = turns.flat_map(|turn| turn.as_flattened());
        entries.any(|entry| match entry {
            Value::Baked(_) => false,
            Value::Runtime(id) => derivative.by.iter().any(|variable| variable.has(*id)),
        })
    }

    /// Derives the values of its function after others, in the same graph, in this formulation where it can be.
    pub(in crate::functions) fn derive_values(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        formulation: Formulation,
        plan: &Plan,
    ) {
        let way = self.formulation(tree, formulation).by(plan);
        let subject = self.subject.as_ref();
        self.function
            .derivation
            .derive_in(derived, tree, way, subject);
    }

    /// Derives it after others, in the same graph, in this formulation where it can be. Returns what it found of
    /// others.
    pub(in crate::functions) fn derive_in(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        formulation: Formulation,
        plan: &Plan,
    ) -> Told {
        let first = derived.roots.len();
        let is_direct = self.formulation(tree, formulation) == Formulation::Recursive
            && plan.uses(Technique::DirectDerivatives);
        if is_direct
            && self.is_whole_derivative()
            && let Some(told) = self.derive_matrices(derived, tree, formulation, plan)
        {
            let function = self.function;
            return told.into_told(self.values().name(), function.derivatives_tell);
        }
        if is_direct
            && let Some(derivative) = self.second_derivative()
            && let Some(forces) = self.function.inverse_dynamics
        {
            let by = (formulation, plan);
            return self.derive_second(derived, tree, by, derivative, forces);
        }
        // No sweep goes through calls.
        let is_swept = self.derivative.is_some();
        let one_by_one = is_swept.then(|| plan.with(Technique::Lockstep, false));
        let plan = one_by_one.as_ref().unwrap_or(plan);
        self.derive_values(derived, tree, formulation, plan);
        if let Some(derivative) = &self.derivative {
            let sizes = self.output_sizes(tree);
            let multipliers = derivative.arguments(self.function.outputs, self.subject_length());
            let values = derived.roots.split_off(first);
            let sparsity = self.sparsity(tree);
            let asked = Asked {
                multipliers: &multipliers,
                sparsity: sparsity.as_deref(),
            };
            if is_direct && let Some(inverse_dynamics) = self.function.inverse_dynamics {
                let solution = Solution {
                    u_dot: &values,
                    inverse_dynamics,
                };
                derivative.apply_to_solution(derived, tree, plan, &solution, asked);
                return Told::default();
            }
            derivative.apply(derived, tree, &values, &sizes, sweep(plan), asked);
        }
        Told::default()
    }

    /// The same where others ask for what its recursion finds beside its entries.
    pub(in crate::functions) fn derive_with_matrices(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        formulation: Formulation,
        plan: &Plan,
    ) -> Told {
        if let Some(beside) = self.function.beside
            && self.derivative.is_none()
            && self.formulation(tree, formulation) == Formulation::Recursive
        {
            let (entries, told) = (beside.derive)(&mut derived.graph, tree, plan);
            derived.roots.extend(entries);
            return told;
        }
        self.derive_in(derived, tree, formulation, plan)
    }
}
