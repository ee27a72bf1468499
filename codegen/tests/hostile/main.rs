//! Models that nobody means well, and those that fuzzing invented: whatever is given, a model is generated or what is wrong
//! with it is told, in bounded time and memory.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops where it fails, its helpers too"
)]

mod common;
mod invented;
mod names;
mod sizes;
mod unknown;
mod wholes;
