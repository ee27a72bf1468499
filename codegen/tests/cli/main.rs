//! The command `kane`, run as its users run it: in a folder, with arguments, watching what it says and leaves behind.
#![expect(
    clippy::unwrap_used,
    reason = "a test stops where it fails, its helpers too"
)]

mod budget;
mod changes;
mod check;
mod check_layout;
mod companions;
mod convert;
mod diff;
mod diff_of_names;
mod diff_of_places;
mod diff_of_texts;
mod eval;
mod eval_state;
mod generate;
#[cfg(unix)]
mod hostile;
#[cfg(unix)]
mod hosts;
mod info;
mod info_mechanics;
mod interface;
#[cfg(unix)]
mod kills;
mod manifest;
mod new;
#[cfg(unix)]
mod outputs;
mod ownership;
mod prescribed;
mod project;
mod requests;
mod revisions;
mod unlisted;
mod verify;
mod versions;
