//! Generated systems, compiled: each behind one function from names and numbers to numbers.
//!
//! `build.rs` generates them. The tests of this package ask any of them, in any scalar, for any function by its name, as
//! they ask the generator's own evaluation of it.

pub mod call;
pub mod platform;

use call::State;
use kane::Real;
use platform::Libm;

macro_rules! systems {
    ($($(#[$meaning:meta])* $name:ident)+) => {$(
        $(#[$meaning])*
        #[allow(clippy::pedantic, reason = "names and digits are the model's; the rest of clippy is a test of what is generated")]
        pub mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
        }
    )+};
}

systems! {
    /// Reference.
    one_body
    /// Reference.
    chain3
    /// Reference.
    star5
    /// Reference.
    two_roots
    /// Reference.
    #[cfg(every_system)]
    tree12
    /// Reference, in the notes' formulation.
    one_body_notes
    /// Reference, in the notes' formulation.
    chain3_notes
    /// Reference, in the notes' formulation.
    star5_notes
    /// Reference, in the notes' formulation.
    two_roots_notes
    /// Reference, in the notes' formulation.
    #[cfg(every_system)]
    tree12_notes
    /// Reference, in the notes' formulation; the other one is bundled with `kane`.
    eight_body_notes
    /// Random, seed 100.
    random_100
    /// Random, seed 101.
    random_101
    /// Random, seed 102.
    random_102
    /// Random, seed 103.
    random_103
    /// Random, seed 104.
    random_104
    /// Random, seed 105.
    #[cfg(every_system)]
    random_105
    /// Random, seed 106.
    random_106
    /// Random, seed 107.
    #[cfg(every_system)]
    random_107
    /// Random, joints of every kind, seed 500.
    random_500
    /// Random, joints of every kind, seed 501.
    random_501
    /// Random, joints of every kind, seed 502.
    random_502
    /// Random, seed 200, in body order.
    body_order
    /// Random, seed 200, in the notes' order.
    notes_order
    /// Random, seed 200, in another numbering.
    renumbered
    /// Random, seed 200, in another numbering and the notes' formulation.
    renumbered_notes
    /// Random, seed 300, no value runtime.
    baked
    /// Random, seed 300, every value runtime.
    runtime
    /// Random, seed 300, other values.
    changed
}

/// A function of a system in `f64` or `f32`, by its name: its output, row-major, partial velocities dense.
pub type Call = fn(function: &str, state: &State) -> Vec<f64>;

/// A compiled system.
#[derive(Clone, Copy, Debug)]
pub struct Compiled {
    /// The module's name.
    pub name: &'static str,
    /// Its description.
    pub model: &'static str,
    /// For each speed whether its acceleration is prescribed.
    pub prescribed: &'static [bool],
    /// In `f64`.
    pub f64: Call,
}

/// A reference's name, and its modules in both formulations and two scalars.
#[derive(Clone, Copy, Debug)]
pub struct Reference {
    /// The name in `tests/reference`.
    pub name: &'static str,
    /// Its description.
    pub model: &'static str,
    /// Along the tree: `f64`.
    pub f64: Call,
    /// Along the tree: `f32`.
    pub f32: Call,
    /// The notes' formulation: `f64`.
    pub notes_f64: Call,
    /// The notes' formulation: `f32`.
    pub notes_f32: Call,
}

macro_rules! call {
    (all, $name:path, $scalar:ty) => {{
        use $name as module;
        |function, state| {
            call::all::<$scalar, _, { module::NU }>(&module::Prepared::nominal(), function, state)
        }
    }};
    (every, $name:path, $scalar:ty) => {{
        use $name as module;
        |function, state| {
            call::every::<$scalar, _, { module::NU }>(&module::Prepared::nominal(), function, state)
        }
    }};
    ($which:ident, $name:path, $scalar:ty) => {{
        use $name as module;
        |function, state| call::$which::<$scalar, _>(&module::Prepared::nominal(), function, state)
    }};
}

macro_rules! reference {
    ($name:literal, $folder:literal, $of:ident $module:path, $of_notes:ident $notes:path) => {
        Reference {
            name: $name,
            model: include_str!(concat!("../../../", $folder, "/", $name, ".toml")),
            f64: call!($of, $module, f64),
            f32: call!($of, $module, f32),
            notes_f64: call!($of_notes, $notes, f64),
            notes_f32: call!($of_notes, $notes, f32),
        }
    };
}

/// The systems with reference values, without the further functions.
pub const REFERENCES: &[Reference] = &[
    reference!("one_body", "tests/reference", all crate::one_body, dynamics crate::one_body_notes),
    reference!("chain3", "tests/reference", all crate::chain3, dynamics crate::chain3_notes),
    reference!("star5", "tests/reference", all crate::star5, dynamics crate::star5_notes),
    reference!("eight_body", "models", all kane::eight_body, dynamics crate::eight_body_notes),
    reference!("two_roots", "tests/reference", all crate::two_roots, dynamics crate::two_roots_notes),
    #[cfg(every_system)]
    reference!("tree12", "tests/reference", all crate::tree12, dynamics crate::tree12_notes),
];

macro_rules! compiled {
    ($($(#[$condition:meta])? $name:ident),+) => {[$(
        $(#[$condition])?
        Compiled {
            name: stringify!($name),
            model: include_str!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".toml")),
            prescribed: &crate::$name::PRESCRIBED,
            f64: call!(every, crate::$name, f64),
        },
    )+]};
}

/// The random systems; the two largest where all are compiled.
pub const RANDOM: &[Compiled] = &compiled![
    random_100,
    random_101,
    random_102,
    random_103,
    random_104,
    #[cfg(every_system)]
    random_105,
    random_106,
    #[cfg(every_system)]
    random_107
];

/// The random systems with joints of every kind, some of which are prescribed.
pub const FRAMED: [Compiled; 3] = compiled![random_500, random_501, random_502];

/// One system: in body order, in the notes' order, in other numbers.
pub const TWINS: [Compiled; 3] = compiled![body_order, notes_order, renumbered];

/// One system: baked, runtime, and baked with other values.
pub const BAKED_RUNTIME_CHANGED: [Compiled; 3] = compiled![baked, runtime, changed];

/// The renumbered system in the notes' formulation.
pub const RENUMBERED_NOTES: Call = call!(both, crate::renumbered_notes, f64);

/// The system with runtime values, given those of the changed one.
pub const RUNTIME_GIVEN_CHANGED: Call = |function, state| {
    let prepared = runtime::Prepared::new(&changed_parameters());
    call::every::<f64, _, { runtime::NU }>(&prepared, function, state)
};

/// The renumbered system, with the sines that the generator evaluates with: its results are the same to the bit.
pub const RENUMBERED_LIBM: Call = call!(every, crate::renumbered, Libm);

/// As [`RENUMBERED_LIBM`], of the first two systems with joints of every kind.
pub const FRAMED_LIBM: [Call; 2] = [
    call!(every, crate::random_500, Libm),
    call!(every, crate::random_501, Libm),
];

/// As [`RENUMBERED_LIBM`], in the notes' formulation.
pub const RENUMBERED_NOTES_LIBM: Call = call!(both, crate::renumbered_notes, Libm);

/// As [`RENUMBERED_LIBM`], of the system with runtime values.
pub const RUNTIME_LIBM: Call = call!(every, crate::runtime, Libm);

/// The values with which the changed system is baked.
#[allow(clippy::unreadable_literal, reason = "the digits are the model's")]
pub fn changed_parameters<R: Real>() -> runtime::Parameters<R> {
    use runtime::Parameters;
    include!(concat!(env!("OUT_DIR"), "/changed_parameters.rs"))
}
