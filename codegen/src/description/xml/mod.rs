//! XML elements with their places, and the reading of their attributes.
//!
//! In: the text of a file. Out: a [`Document`] of [`Element`]s; checked values, `None` where there is none; the
//! faults gather in the [`Reader`]. Afterwards: numbers are finite, and every place is a span of the text, moved by
//! the document's base, so that several files can share one line of offsets. Does not: know what an element means.
//!
//! Document type declarations are refused, and with them every entity but those of XML itself.

mod document;
mod malformed;
mod markup;
mod mend;
mod numbers;
mod prolog;
mod reader;

pub(crate) use document::{Document, Element};
pub(crate) use mend::Mended;
pub(crate) use numbers::words;
pub(crate) use prolog::root_name;
pub(crate) use reader::{Known, Reader};
