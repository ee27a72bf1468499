//! The numbers of a tree, in their binding times.

use crate::id::{BodyId, ParameterId};

/// A number of the description, in one of its binding times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Baked into the generated code.
    Baked(f64),
    /// A field of `Parameters`, with a nominal value.
    Runtime(ParameterId),
}

/// A value that the user sets at run time.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The field's name in `Parameters`: body identifier and quantity, such as `hub_mass` or `hub_inertia_xy`; `gravity_z`.
    pub name: String,
    /// The body that it belongs to; `None` for gravity, and for what is fixed to the inertial frame.
    pub body: Option<BodyId>,
    /// The value in the description.
    pub nominal: f64,
    /// The unit, for doc comments: "kg", "m", "kg m^2", "m/s^2", "N m s/rad".
    pub unit: &'static str,
}

impl Value {
    /// The number itself, or its nominal value among these parameters.
    pub fn nominal(self, parameters: &[Parameter]) -> f64 {
        match self {
            Self::Baked(number) => number,
            Self::Runtime(parameter) => parameters[parameter.index()].nominal,
        }
    }
}
