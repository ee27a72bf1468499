//! XML elements with their places, and the reading of their attributes.

mod markup;
mod reader;

pub(crate) use reader::{Document, Element, Known, Reader, root_name, shown};
