//! What a module says and does, before any language.

mod extent;
mod stages;
mod stated;
mod verify;
