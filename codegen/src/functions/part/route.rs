//! By which way a part is derived, from what is asked for and what its function knows.

use super::Part;
use crate::{
    functions::{
        derivatives::{derivative::DerivativeKind, matrices::is_known},
        formulation::Formulation,
        function::{DerivativesFn, Function, MassMatrixUse},
        variable::Variable,
    },
    recursive::{Plan, Technique},
    tree::{Tree, Value},
};

/// A way to derive a part.
pub(super) enum Route {
    /// It is values.
    Values,
    /// Values are swept over.
    Swept,
    /// Derivatives have a way of their own.
    Direct(Direct),
}

/// A way to derivatives that is not a sweep over all that makes the values, and through no solver.
pub(in crate::functions) enum Direct {
    /// They are the entries of another function.
    Function(&'static Function),
    /// All of them, in a way of the function's own.
    Matrices(DerivativesFn),
    /// Second derivatives of what is solved for, by the forces that are lacking.
    Second,
    /// Products with derivatives of what is solved for, or all of them by what `Matrices` does not know: one solution more, or one for each
    /// column.
    Solved,
}

impl Part {
    /// By what it is derived. The recursion relies on rotations being orthonormal, which they are not where an entry changes
    /// alone.
    pub(super) fn formulation(&self, tree: &Tree, wanted: Formulation) -> Formulation {
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

    /// The way in this formulation by this plan.
    pub(super) fn route(&self, tree: &Tree, formulation: Formulation, plan: &Plan) -> Route {
        if self.derivative.is_none() {
            return Route::Values;
        }
        let direct = self.direct_by(tree, formulation, plan);
        direct.map_or(Route::Swept, Route::Direct)
    }

    /// The direct way, where this formulation and this plan take it.
    pub(in crate::functions) fn direct_by(
        &self,
        tree: &Tree,
        formulation: Formulation,
        plan: &Plan,
    ) -> Option<Direct> {
        let is_direct = self.formulation(tree, formulation) == Formulation::Recursive
            && plan.uses(Technique::DirectDerivatives);
        self.direct().filter(|_| is_direct)
    }

    /// The direct way, if there is one.
    pub(super) fn direct(&self) -> Option<Direct> {
        let derivative = self.derivative.as_ref()?;
        let whole = [DerivativeKind::Jacobian, DerivativeKind::PackedJacobian];
        if whole.contains(&derivative.kind) {
            let mut functions = self.function.derivatives_are.iter();
            if let Some((_, function)) =
                functions.find(|(argument, _)| derivative.by == [Variable::Given(*argument)])
            {
                return Some(Direct::Function(function));
            }
            if let Some(derivatives) = self.function.derivatives
                && derivative.by.iter().any(is_known)
            {
                return Some(Direct::Matrices(derivatives));
            }
        }
        self.function.inverse_dynamics?;
        Some(match derivative.kind {
            DerivativeKind::Hessian => Direct::Second,
            _ => Direct::Solved,
        })
    }

    /// The functions whose plans suit the direct way: that whose entries derivatives are, and the one that is said to be like them.
    pub(in crate::functions) fn alike(&self) -> Vec<Self> {
        let functions = match self.direct() {
            // Products with derivatives of accelerations take one more solution, by the plan of the first.
            None | Some(Direct::Solved) => [None; 2],
            Some(Direct::Function(function)) => [self.function.derivatives_like, Some(function)],
            Some(Direct::Matrices(_) | Direct::Second) => [self.function.derivatives_like, None],
        };
        let functions = functions.into_iter().flatten();
        let part = |function| Self {
            function,
            derivative: None,
            ..self.clone()
        };
        functions.map(part).collect()
    }

    /// True where derivatives have a way of their own, beside the sweeps.
    pub(in crate::functions) fn has_direct_derivatives(&self) -> bool {
        self.direct().is_some()
    }

    /// True where some of them are of accelerations that forces make, by matrices.
    pub(in crate::functions) fn differentiates_accelerations(&self) -> bool {
        let has_matrices = matches!(self.direct(), Some(Direct::Matrices(_) | Direct::Second));
        has_matrices && self.function.solves()
    }

    /// True where columns may go several at a time by this plan: those of derivatives of dynamics, and of the inverse.
    pub(in crate::functions) fn has_columns(&self, plan: &Plan) -> bool {
        let inverts = |function: &Function| function.mass_matrix == MassMatrixUse::Inverse;
        if self.derivative.is_none() {
            return inverts(self.function);
        }
        let direct = self
            .direct()
            .filter(|_| plan.uses(Technique::DirectDerivatives));
        match direct {
            Some(Direct::Function(function)) => inverts(function),
            // Those of what tells of the mass matrix are columns as it has them.
            Some(Direct::Matrices(_) | Direct::Second) => {
                !self.function.derivatives_tell.is_empty()
            }
            Some(Direct::Solved) | None => false,
        }
    }

    /// True where sweeps find derivatives even where functions are differentiated in ways of their own: those of other functions, second ones, and
    /// those by what such a way does not know. By that, accelerations are solved for.
    pub(in crate::functions) fn is_swept_beside_direct(&self) -> bool {
        let Some(derivative) = &self.derivative else {
            return false;
        };
        match self.direct() {
            None | Some(Direct::Second) => true,
            Some(Direct::Matrices(_)) => {
                let is_solved_for = self.function.inverse_dynamics.is_some();
                !is_solved_for && !derivative.by.iter().all(is_known)
            }
            Some(Direct::Function(_) | Direct::Solved) => false,
        }
    }
}
