//! Text → a request with the places of its words, or every fault in it.

mod given_name;
mod join_faults;
pub(super) mod parsed;
pub(super) mod parsed_subject;
pub(super) mod request_error;
pub mod syntax;
mod unknown_frame;
