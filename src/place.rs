//! Places in arrays, by name.

/// The place of a name in a generated module's `COORDINATE_NAMES`, `SPEED_NAMES`, `BODY_NAMES` or `PARAMETER_NAMES`; `None` where it has
/// none.
///
/// In `PARAMETER_NAMES` it is the column of derivatives by `parameters`, and the place in the arrays of `Parameters`.
///
/// In a constant it costs nothing, and a name that the module does not have is an error of the compiler:
///
/// ```
/// # #[cfg(feature = "cart_pole")] {
/// use kane::cart_pole::{COORDINATE_NAMES, PARAMETER_NAMES, Parameters};
///
/// const POLE: usize = kane::place(&COORDINATE_NAMES, "pole_theta2").unwrap();
/// assert_eq!(POLE, 1);
///
/// const MASS: usize = kane::place(&PARAMETER_NAMES, "pole_mass").unwrap();
/// let mut values = Parameters::<f64>::default().to_array();
/// values[MASS] = 0.6;
/// assert_eq!(Parameters::from_array(values).pole_mass, 0.6);
/// # }
/// ```
#[must_use]
pub const fn place(names: &[&str], name: &str) -> Option<usize> {
    let mut place = 0;
    while place < names.len() {
        if is_same(names[place].as_bytes(), name.as_bytes()) {
            return Some(place);
        }
        place += 1;
    }
    None
}

/// True if the bytes are the same, in constants too.
pub(crate) const fn is_same(one: &[u8], other: &[u8]) -> bool {
    if one.len() != other.len() {
        return false;
    }
    let mut i = 0;
    while i < one.len() {
        if one[i] != other[i] {
            return false;
        }
        i += 1;
    }
    true
}
