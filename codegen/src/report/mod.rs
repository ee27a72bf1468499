//! What people ask about a system and about a change of its module, as data.
//!
//! In: a [`Tree`](crate::tree::Tree), or the texts of modules. Out: a picture, patterns, counts, what differs. The command
//! prints them; so can a build script or a test. Does not: touch files.

mod compare;
mod constants;
mod counts;
mod declarations;
mod differences;
mod forms;
mod held;
mod meaning;
mod meanings;
mod module;
mod outline;
mod partitions;
mod pattern;
mod picture;
mod places;
mod svg;
mod turned;

pub use crate::listing::Counted;
pub use compare::{Change, Comparison};
pub use counts::{Counts, count};
pub use declarations::Redeclared;
pub use differences::{Differences, LayoutChange, ValueChange, differences};
pub use forms::FormChange;
pub use meaning::Meaning;
pub use module::{ModuleError, ReadModule};
pub use outline::{Body, Layout, Outline, Values};
pub use partitions::{Cell, Partitions, partitions};
pub use pattern::mass_matrix_pattern;
pub use picture::picture;
pub use svg::svg;
pub use turned::turned;
