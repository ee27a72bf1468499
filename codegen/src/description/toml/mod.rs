//! Our own format, TOML.
//!
//! `name`, `lower_bodies` and of every `[[body]]` the `name`, `mass`, `mass_center`, `inertia`, `attachment` and
//! `joint` must be written, also where they are zero: physics has no hidden defaults. What else there is may be
//! absent, but for the `axis` of a joint that needs one, and the `name` of a `[[frame]]`.

mod body;
mod frame;
mod joint;
mod parse;
mod text;
mod value;
mod write;

pub use parse::parse;
pub use text::quoted;
pub use write::write;
