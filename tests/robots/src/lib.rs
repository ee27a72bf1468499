//! Generated robots, compiled: each behind a trait object that takes slices.
//!
//! `build.rs` generates them from the URDFs of this package and the models of `tests/mjcf`. The tests ask them for the
//! numbers that Pinocchio and MuJoCo have for the same files, and for one another's.

mod robot;
mod systems;

pub use robot::{Dynamics, Limits, Robot};
pub use systems::{Center, Hybrid, Identified};

macro_rules! modules {
    ($($(#[$meaning:meta])* $name:ident)+) => {$(
        $(#[$meaning])*
        #[allow(clippy::pedantic, reason = "names and digits are the model's; the rest of clippy is a test of what is generated")]
        pub mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
        }
    )+};
}

modules! {
    /// As its file is.
    cartpole
    /// Matrices over speeds.
    cartpole_matrices
    /// Snapped.
    cartpole_snapped
    /// In the notes' formulation.
    cartpole_notes
    /// As its file is.
    double_pendulum
    /// Matrices over speeds.
    double_pendulum_matrices
    /// Snapped.
    double_pendulum_snapped
    /// In the notes' formulation.
    double_pendulum_notes
    /// As its file is.
    double_pendulum_continuous
    /// Snapped.
    double_pendulum_continuous_snapped
    /// In the notes' formulation.
    double_pendulum_continuous_notes
    /// As its file is.
    ur5
    /// Matrices over speeds.
    ur5_matrices
    /// Snapped.
    ur5_snapped
    /// In the notes' formulation.
    ur5_notes
    /// As its file is.
    panda
    /// Matrices over speeds.
    panda_matrices
    /// Snapped.
    panda_snapped
    /// In the notes' formulation.
    panda_notes
    /// With fused multiply-add.
    panda_fused
    /// Two joints locked, one removed.
    panda_held
    /// With functions in one, and at sines and cosines.
    panda_joined
    /// Functions of its hand's frame.
    panda_frames
    /// As its file is.
    solo12
    /// Matrices over speeds.
    solo12_matrices
    /// With fused multiply-add.
    solo12_fused
    /// With functions in one, and at sines and cosines.
    solo12_joined
    /// Its base described by angles.
    solo12_angles
    /// As that, in the notes' formulation.
    solo12_angles_notes
    /// Snapped.
    solo12_snapped
    /// In the notes' formulation.
    solo12_notes
    /// As its file is.
    talos
    /// Matrices over speeds.
    #[cfg(every_system)]
    talos_matrices
    /// Derivatives of its forces.
    #[cfg(every_system)]
    talos_derivatives
    /// Its base described by angles.
    #[cfg(every_system)]
    talos_angles
    /// Snapped.
    #[cfg(every_system)]
    talos_snapped
    /// Functions of its mass centre.
    cartpole_center
    /// Functions of its mass centre.
    ur5_center
    /// Functions of its mass centre.
    panda_center
    /// Functions of its mass centre.
    solo12_center
    /// Functions of its mass centre.
    talos_center
    /// Its regressor.
    cartpole_regressor
    /// Its regressor.
    ur5_regressor
    /// Its regressor.
    panda_regressor
    /// Two joints prescribed.
    ur5_hybrid
    /// Three joints prescribed.
    panda_hybrid
    /// Joints of its legs prescribed.
    solo12_legs_hybrid
    /// Its base and joints of its legs prescribed.
    solo12_base_hybrid
    /// As `solo12_legs_hybrid`, its base described by angles.
    solo12_angles_legs_hybrid
    /// As `solo12_base_hybrid`, its base described by angles.
    solo12_angles_base_hybrid
    /// A joint and the two that follow it.
    gripper
    /// In the notes' formulation.
    gripper_notes
    /// With functions in one, and at sines and cosines.
    gripper_joined
    /// The same, where none follows.
    gripper_free
    /// In the notes' formulation.
    gripper_free_notes
}

/// The models of `tests/mjcf`.
pub mod mjcf {
    include!(concat!(env!("OUT_DIR"), "/mjcf.rs"));
}

/// Makes a robot with every function.
pub type Make = fn() -> Box<dyn Robot>;
/// Makes a robot with the functions that have two formulations.
pub type MakeDynamics = fn() -> Box<dyn Dynamics>;

macro_rules! make {
    ($name:ident) => {
        || Box::new(crate::$name::Prepared::nominal())
    };
}

/// A robot of the references.
#[derive(Clone, Copy, Debug)]
pub struct Compiled {
    /// The name of its folder.
    pub name: &'static str,
    /// As its file is; a floating base with a quaternion.
    pub plain: Make,
    /// A floating base described by angles.
    pub angles: Option<Make>,
    /// With constant rotations snapped by the default tolerance.
    pub snapped: Make,
    /// In the notes' formulation: of all but talos, whose literal sums alone take as long to compile as all others.
    pub notes: Option<MakeDynamics>,
}

macro_rules! compiled {
    ($plain:ident, $snapped:ident, $notes:expr, $angles:expr) => {
        Compiled {
            name: stringify!($plain),
            plain: make!($plain),
            angles: $angles,
            snapped: make!($snapped),
            notes: $notes,
        }
    };
}

/// The robots of the references.
pub const ROBOTS: [Compiled; 7] = [
    compiled!(
        cartpole,
        cartpole_snapped,
        Some(make!(cartpole_notes)),
        None
    ),
    compiled!(
        double_pendulum,
        double_pendulum_snapped,
        Some(make!(double_pendulum_notes)),
        None
    ),
    compiled!(
        double_pendulum_continuous,
        double_pendulum_continuous_snapped,
        Some(make!(double_pendulum_continuous_notes)),
        None
    ),
    compiled!(ur5, ur5_snapped, Some(make!(ur5_notes)), None),
    compiled!(panda, panda_snapped, Some(make!(panda_notes)), None),
    compiled!(
        solo12,
        solo12_snapped,
        Some(make!(solo12_notes)),
        Some(make!(solo12_angles))
    ),
    #[cfg(every_system)]
    compiled!(talos, talos_snapped, None, Some(make!(talos_angles))),
    #[cfg(not(every_system))]
    compiled!(talos, talos, None, None),
];

/// Makes a robot with the functions of its mass centre.
pub type MakeCenter = fn() -> Box<dyn Center>;
/// Makes a robot with its regressor.
pub type MakeIdentified = fn() -> Box<dyn Identified>;

/// Robots with the functions of their mass centres.
pub const CENTERS: [(&str, MakeCenter); 5] = [
    ("cartpole", make!(cartpole_center)),
    ("ur5", make!(ur5_center)),
    ("panda", make!(panda_center)),
    ("solo12", make!(solo12_center)),
    ("talos", make!(talos_center)),
];

/// Robots with their regressors.
pub const IDENTIFIED: [(&str, MakeIdentified); 3] = [
    ("cartpole", make!(cartpole_regressor)),
    ("ur5", make!(ur5_regressor)),
    ("panda", make!(panda_regressor)),
];

/// Makes a robot of which some joints are prescribed.
pub type MakeHybrid = fn() -> Box<dyn Hybrid>;

/// Robots of which some joints are prescribed, with the names of their references.
pub const HYBRIDS: [(&str, MakeHybrid); 6] = [
    ("ur5", make!(ur5_hybrid)),
    ("panda", make!(panda_hybrid)),
    ("solo12", make!(solo12_legs_hybrid)),
    ("solo12", make!(solo12_base_hybrid)),
    ("solo12", make!(solo12_angles_legs_hybrid)),
    ("solo12", make!(solo12_angles_base_hybrid)),
];

/// The panda with fused multiply-add.
pub const PANDA_FUSED: MakeDynamics = make!(panda_fused);
/// solo12 with fused multiply-add.
pub const SOLO12_FUSED: MakeDynamics = make!(solo12_fused);
/// solo12 with its base described by angles, in the notes' formulation.
pub const SOLO12_ANGLES_NOTES: MakeDynamics = make!(solo12_angles_notes);
/// The panda with `panda_joint3` locked at 0.4, `panda_joint6` at -0.7, and `panda_joint5` removed.
pub const PANDA_HELD: Make = make!(panda_held);
/// The gripper of which two joints follow a third.
pub const GRIPPER: Make = make!(gripper);
/// As [`GRIPPER`], in the notes' formulation.
pub const GRIPPER_NOTES: MakeDynamics = make!(gripper_notes);
/// As [`GRIPPER`], every joint free.
pub const GRIPPER_FREE: Make = make!(gripper_free);
/// As [`GRIPPER_FREE`], in the notes' formulation.
pub const GRIPPER_FREE_NOTES: MakeDynamics = make!(gripper_free_notes);
