//! Names of elements and attributes: those that are read, and those without influence on the dynamics of the tree.
//!
//! As in MuJoCo 4.0, with some of earlier versions. Of other names there is a warning.

mod elements;

pub(super) use elements::*;
