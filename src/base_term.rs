/// A term of a base parameter: base parameter number `base` holds `factor` times the inertial parameter.
///
/// All places are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BaseTerm {
    /// The base parameter, a column of `base_regressor`.
    pub base: usize,
    /// The body, an index into `BODY_NAMES`.
    pub body: usize,
    /// The parameter among the body's ten, in the order of [`Regressor`](crate::functions::Regressor).
    pub parameter: usize,
    /// The factor of the parameter: 1, or in the unit of the base parameter over the parameter's own.
    pub factor: f64,
}
