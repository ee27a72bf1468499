//! [`Cost`]: what one call of a generated function costs.
//!
//! Constants of a generated module, for code that adds up the cost of a loop, or rejects a module that costs too much.

/// The operations of one call, in every state: generated functions have no branch, and only loops of fixed length.
///
/// Signs, absolute values, copies and stores do not count. A fused multiply-add counts as a multiplication and an addition.
///
/// ```
/// # #[cfg(feature = "cart_pole")] {
/// use kane::{Cost, cart_pole::OPERATIONS};
///
/// let needed = ["mass_matrix", "bias"];
/// let costs = OPERATIONS.iter().filter(|cost| needed.contains(&cost.function));
/// assert!(costs.map(|cost| cost.total()).sum::<usize>() < 100);
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Cost {
    /// The function's name; `Prepared::new` for the part computed once, outside the loop.
    pub function: &'static str,
    /// Multiplications.
    pub mul: usize,
    /// Additions and subtractions.
    pub add: usize,
    /// Divisions.
    pub div: usize,
    /// Sines and cosines: 2 for both of one angle.
    pub trig: usize,
}

impl Cost {
    /// The cost of a function, from its multiplications, additions and subtractions, divisions, sines and cosines.
    pub const fn new(function: &'static str, [mul, add, div, trig]: [usize; 4]) -> Self {
        Self {
            function,
            mul,
            add,
            div,
            trig,
        }
    }

    /// All operations.
    pub const fn total(&self) -> usize {
        self.mul + self.add + self.div + self.trig
    }
}
