mod dense;
mod followers;
mod sweeps;
mod trees;
