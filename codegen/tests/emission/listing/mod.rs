//! What a module says and does, before any language.

mod extent;
mod stated;
mod verify;
