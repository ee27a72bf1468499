//! Compiled systems as models of which the identities can be asked.

use kane_codegen::id::SpeedId;
use kane_test_support::{
    dynamics::{Model, State, composition::Composition},
    systems::tree,
};
use kane_test_systems::{Call, Compiled, call};

/// A compiled system, and the tree that its description makes.
pub(crate) struct CompiledModel {
    pub(crate) name: &'static str,
    pub(crate) composition: Composition,
    pub(crate) call: Call,
}

impl CompiledModel {
    pub(crate) fn new(compiled: Compiled) -> Self {
        let mut tree = tree(compiled.model).expect("what was generated is accepted");
        let speeds = compiled.prescribed.iter().enumerate();
        let prescribed = speeds.filter(|(_, is_prescribed)| **is_prescribed);
        tree.prescribed = prescribed.map(|(place, _)| SpeedId::new(place)).collect();
        Self {
            name: compiled.name,
            composition: Composition::new(compiled.model, &tree),
            call: compiled.f64,
        }
    }

    /// The same system, called otherwise.
    pub(crate) fn called(&self, call: Call) -> Self {
        Self {
            name: self.name,
            composition: self.composition.clone(),
            call,
        }
    }
}

impl Model for CompiledModel {
    fn name(&self) -> String {
        self.name.to_owned()
    }

    fn composition(&self) -> &Composition {
        &self.composition
    }

    fn evaluate(&self, function: &str, state: &State) -> Vec<f64> {
        (self.call)(function, &given(state))
    }
}

/// A state as compiled systems take it.
pub(crate) fn given(state: &State) -> call::State {
    let State {
        q,
        u,
        u_dot,
        tau,
        loads,
        w_rel,
    } = state.clone();
    call::State {
        q,
        u,
        u_dot,
        tau,
        loads,
        w_rel,
    }
}
