//! What a module says and does, before any language.

mod extent;
mod limits;
mod stages;
mod stated;
mod verify;
