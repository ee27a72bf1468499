//! Where a number stands in what a function is given or writes.

/// One number of an argument: `loads[2].force[1]` is an argument and three steps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The argument's place in the signature.
    pub argument: usize,
    /// What leads to the number, outermost first.
    pub steps: Vec<Step>,
}

/// A step toward a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// To an element of an array.
    Index(usize),
    /// To a member of a structure.
    Member(Member),
}

/// A member of a structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Member {
    /// The force of a load.
    Force,
    /// The moment of a load.
    Moment,
    /// The sines of all angles.
    Sines,
    /// Their cosines.
    Cosines,
    /// A value set at run time, by its place among [`Facts::parameters`](crate::listing::Facts::parameters).
    Parameter(usize),
    /// A value that depends on these alone, by its place among [`Facts::fields`](crate::listing::Facts::fields).
    Prepared(usize),
}
