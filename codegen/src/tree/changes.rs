//! What the user has changed of a description on its way to a tree.

/// What is changed of a description on its way to a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Changes {
    /// Entries of constant rotations that are as near as this to 0, 1 or -1 become that; 0 changes none.
    pub snap: f64,
    /// Coordinates to hold at a value, rad or m, by their names or those of their joints.
    pub lock: Vec<(String, f64)>,
    /// Joints to fix where their coordinates are zero, by their names or those of their bodies.
    pub remove: Vec<String>,
    /// Whether every motion that moves no mass is held at zero.
    pub remove_massless: bool,
}

impl Changes {
    /// What the list of [`lock`](Self::lock) is called in `kane.toml`, and by faults.
    pub const LOCK: &str = "lock";
    /// The same of [`remove`](Self::remove).
    pub const REMOVE: &str = "remove";
}

impl Default for Changes {
    /// Snapping at 1e-9, which covers right angles written with ten digits; nothing locked, nothing removed.
    fn default() -> Self {
        Self {
            snap: 1e-9,
            lock: Vec::new(),
            remove: Vec::new(),
            remove_massless: false,
        }
    }
}
