//! Derivatives for which the runtime has a trait, so that generic code can hold them: one table.

use crate::functions::request::Request;

/// What is asked for, and its trait.
pub const TRAITS: [(&str, &str); 20] = [
    (
        "d(forward_dynamics)/d(q, u, tau)",
        "ForwardDynamicsDerivatives",
    ),
    (
        "forward_dynamics+d(forward_dynamics)/d(q, u, tau)",
        "ForwardDynamicsAndDerivatives",
    ),
    (
        "d(forward_dynamics)/d(parameters)",
        "ForwardDynamicsByParameters",
    ),
    ("jvp(forward_dynamics; q, u, tau)", "ForwardDynamicsJvp"),
    (
        "jvp(forward_dynamics; q, u, tau, parameters)",
        "ForwardDynamicsParametersJvp",
    ),
    ("vjp(forward_dynamics; q, u, tau)", "ForwardDynamicsVjp"),
    (
        "vjp(forward_dynamics; q, u, tau, parameters)",
        "ForwardDynamicsParametersVjp",
    ),
    (
        "loaded_forward_dynamics+d(loaded_forward_dynamics)/d(q, u, tau)",
        "LoadedForwardDynamicsAndDerivatives",
    ),
    (
        "jvp(loaded_forward_dynamics; q, u, tau)",
        "LoadedForwardDynamicsJvp",
    ),
    (
        "vjp(loaded_forward_dynamics; q, u, tau)",
        "LoadedForwardDynamicsVjp",
    ),
    (
        "hybrid_dynamics+d(hybrid_dynamics)/d(q, u, tau)",
        "HybridDynamicsAndDerivatives",
    ),
    ("jvp(hybrid_dynamics; q, u, tau)", "HybridDynamicsJvp"),
    ("vjp(hybrid_dynamics; q, u, tau)", "HybridDynamicsVjp"),
    (
        "d(inverse_dynamics)/d(q, u, u_dot)",
        "InverseDynamicsDerivatives",
    ),
    (
        "inverse_dynamics+d(inverse_dynamics)/d(q, u, u_dot)",
        "InverseDynamicsAndDerivatives",
    ),
    (
        "d(inverse_dynamics)/d(parameters)",
        "InverseDynamicsByParameters",
    ),
    ("jvp(inverse_dynamics; q, u, u_dot)", "InverseDynamicsJvp"),
    (
        "jvp(inverse_dynamics; q, u, u_dot, parameters)",
        "InverseDynamicsParametersJvp",
    ),
    ("vjp(inverse_dynamics; q, u, u_dot)", "InverseDynamicsVjp"),
    (
        "vjp(inverse_dynamics; q, u, u_dot, parameters)",
        "InverseDynamicsParametersVjp",
    ),
];

/// A trait of the runtime.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DerivativeTrait {
    /// Its name.
    pub name: &'static str,
    /// The name of its method.
    pub method: String,
}

impl Request {
    /// The runtime's trait for these derivatives, where it has one: of these variables, in this order.
    pub fn derivative_trait(&self) -> Option<DerivativeTrait> {
        let sum = self.sum();
        let mut traits = TRAITS.into_iter();
        let (_, name) = traits.find(|(known, _)| *known == sum)?;
        let method = self.name_of_parts();
        Some(DerivativeTrait { name, method })
    }
}
