//! How results and what is told beside them are written.

pub(super) mod json;
pub(super) mod lines;
mod only;
pub(super) mod operations;
pub(super) mod pipe;
pub(super) mod text_diff;
pub(super) mod voice;
