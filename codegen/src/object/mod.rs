//! Promises about generated functions, checked on the machine code that rustc makes of them.
//!
//! In: a generated module and the crate `kane`, as files. Out: of each generated function its size, its stack, its
//! instructions, and every promise that it breaks, with the instruction.
//!
//! The promises concern every `pub fn` with `#[inline(never)]`, for a scalar that the hardware computes with:
//! - It has no jump but those of loops whose length is a number in the code: over the pages of a large stack, or the columns of a helper. So each call executes the same instructions.
//! - It calls nothing but the runtime's sines and cosines, the stages of a long function and its helpers, which keep the same promises. So it cannot panic.
//! - It uses no memory but that of its arguments, its stack and constants, and no address depends on a number that it computes.
//!
//! Needs: `rustc`, and machine code of x86-64 in ELF. Does not: say how long an instruction takes; compile for other
//! scalars, for vectors, or with the optimizations of a linker, which see more than a function.

// What is compiled, and how.
mod compile;
mod roots;
// What comes out.
mod file;
// What an instruction does to the registers and the stack, and what it must not do.
mod instruction;
mod state;
mod vectors;
mod verify;

use std::{fmt, io, path::PathBuf};

pub use compile::Runtime;
pub use verify::verify;

/// How a module is compiled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// The scalar of its functions.
    pub scalar: Scalar,
    /// Optimizations, rustc's `opt-level`.
    pub opt_level: OptLevel,
    /// rustc's `target-cpu`; its default where there is none.
    pub target_cpu: Option<String>,
}

/// A scalar that the hardware holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    /// Double precision.
    F64,
    /// Single precision.
    F32,
}

impl Scalar {
    /// All of them, by name.
    pub const ALL: [(&'static str, Self); 2] = [("f64", Self::F64), ("f32", Self::F32)];
}

/// Optimizations without which nothing is promised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptLevel {
    /// `opt-level = 2`.
    Two,
    /// `opt-level = 3`, that of a release build.
    Three,
}

impl OptLevel {
    /// All of them, by name.
    pub const ALL: [(&'static str, Self); 2] = [("2", Self::Two), ("3", Self::Three)];
}

/// What was found in a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The generated functions, as they stand in the module.
    pub functions: Vec<FunctionReport>,
    /// What these call of the runtime's sines and cosines, by name.
    pub sines: Vec<FunctionReport>,
}

impl Report {
    /// Every function.
    pub fn all(&self) -> impl Iterator<Item = &FunctionReport> {
        self.functions.iter().chain(&self.sines)
    }

    /// True where no promise is broken.
    pub fn holds(&self) -> bool {
        self.all().all(|function| function.breaches.is_empty())
    }
}

/// A function's machine code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FunctionReport {
    /// Its name: in the module, or with its path where it is not of the module.
    pub name: String,
    /// Its own bytes.
    pub text: u64,
    /// The most bytes of stack below its return address, with what it calls.
    pub stack: u64,
    /// How many instructions a call executes, with what it calls.
    pub instructions: u64,
    /// The promises that it breaks, by address.
    pub breaches: Vec<Breach>,
}

/// A broken promise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Breach {
    /// Where the instruction is, in bytes from the function's first.
    pub offset: u64,
    /// The instruction.
    pub instruction: String,
    /// What it does.
    pub what: What,
}

/// What no instruction may do.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum What {
    /// Going elsewhere.
    Jump,
    /// A call that ends in a panic.
    Panic(String),
    /// A call of anything but the runtime's sines and cosines, or a part of the function.
    Call(String),
    /// Memory that is no constant and belongs to nobody's arguments.
    Static(Option<String>),
    /// Memory of the thread, or of the processor.
    Segment,
    /// Memory at an address that is a number in the code.
    Absolute,
    /// Memory at an address that was computed from values.
    Computed,
    /// Memory of the caller's stack, or below the function's own.
    Stack,
    /// Neither arithmetic nor a move: an interrupt, a trap, a repetition, a privileged instruction.
    Strange,
    /// The function ends without a return, or leaves the stack as it was not.
    End,
}

impl fmt::Display for What {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Jump => f.write_str("jumps"),
            Self::Panic(name) => write!(f, "can panic, in `{name}`"),
            Self::Call(name) => write!(f, "calls `{name}`"),
            Self::Static(Some(name)) => write!(f, "reads or writes `{name}`, no constant"),
            Self::Static(None) => f.write_str("reads or writes what is no constant"),
            Self::Segment => f.write_str("reads or writes memory of the thread"),
            Self::Absolute => f.write_str("reads or writes memory at a fixed address"),
            Self::Computed => f.write_str("reads or writes memory at an address from values"),
            Self::Stack => f.write_str("reads or writes outside of its part of the stack"),
            Self::Strange => f.write_str("does what is neither arithmetic nor a move"),
            Self::End => f.write_str("does not return with the stack as it was"),
        }
    }
}

/// Why nothing could be verified.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file could not be read or written.
    #[error("cannot access `{}`", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A path that source text cannot name.
    #[error("`{}` is not Unicode: rustc cannot be told of it", path.display())]
    Path {
        /// The path.
        path: PathBuf,
    },
    /// A file that is not Rust.
    #[error("`{}` is not Rust that can be read: {message}; expected a generated module", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        message: String,
    },
    /// A module without a function to verify.
    #[error("`{}` has no `pub fn` with `#[inline(never)]`: it is no generated module", path.display())]
    NoFunctions {
        /// The file.
        path: PathBuf,
    },
    /// The compiler could not be started.
    #[error("cannot run rustc")]
    NoCompiler(#[source] io::Error),
    /// The compiler refused.
    #[error("rustc does not compile `{}`:\n{message}", path.display())]
    Refused {
        /// The file.
        path: PathBuf,
        /// What rustc said.
        message: String,
    },
    /// Machine code of another kind.
    #[error(
        "rustc compiles for {found} here; only machine code of x86-64 in ELF can be read, that of Linux for instance"
    )]
    Target {
        /// The kind, in words.
        found: String,
    },
    /// Machine code that is not as rustc makes it.
    #[error("the machine code cannot be read: {0}")]
    Object(String),
}
