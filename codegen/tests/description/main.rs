//! Reading: from the text of a model or of `kane.toml` to a tree, or to what is wrong with it.

mod config;
mod converted;
mod diagnostic;
mod invalid;
mod invalid_mjcf;
mod listed;
mod mass;
mod masses;
mod mended;
mod meshes;
mod meshes_faulty;
mod mjcf;
mod mjcf_equalities;
mod mjcf_files;
mod mjcf_geometry;
mod mjcf_reference;
mod mjcf_support;
mod mobility;
mod principal;
mod requests;
mod rotations;
mod snapping;
mod toml;
mod tree;
mod units;
mod urdf;
