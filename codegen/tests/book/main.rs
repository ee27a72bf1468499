//! What people read: README.md, the pages of `docs`, and what stands beside them. Links lead somewhere, and code does what the
//! text says: tutorials are run as they are written, step after step, in a fresh folder.
#![expect(
    clippy::panic,
    clippy::unwrap_used,
    reason = "a test stops where it fails, its helpers too"
)]

mod blocks;
mod dictionary;
mod links;
mod modules;
mod page;
mod pictures;
mod schemas;
#[cfg(unix)]
mod tutorials;
