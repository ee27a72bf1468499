//! Generated robots, compiled: each behind a trait object that takes slices.
//!
//! `build.rs` generates them from the URDFs of this package and the models of `tests/mjcf`. The tests ask them for the
//! numbers that Pinocchio and MuJoCo have for the same files, and for one another's.

mod robot;

pub use robot::{Dynamics, Limits, Robot};

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
    /// Snapped.
    cartpole_snapped
    /// In the notes' formulation.
    cartpole_notes
    /// As its file is.
    double_pendulum
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
    /// Snapped.
    ur5_snapped
    /// In the notes' formulation.
    ur5_notes
    /// As its file is.
    panda
    /// Snapped.
    panda_snapped
    /// In the notes' formulation.
    panda_notes
    /// Two joints locked, one removed.
    panda_held
    /// As its file is.
    solo12
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
    /// Its base described by angles.
    talos_angles
    /// Snapped.
    talos_snapped
    /// A joint and the two that follow it.
    gripper
    /// In the notes' formulation.
    gripper_notes
    /// The same, where none follows.
    gripper_free
    /// In the notes' formulation.
    gripper_free_notes
}

/// The models of `tests/mjcf`.
pub mod mjcf {
    use super::MakeDynamics;

    modules! {
        /// As its file is.
        adjusted_inertias
        /// As its file is.
        ant
        /// As its file is.
        ball_joint_arm
        /// As its file is.
        cart_with_springs
        /// As its file is.
        cheetah
        /// As its file is.
        extrinsic_angles
        /// As its file is.
        frames
        /// As its file is.
        free_bodies
        /// As its file is.
        humanoid
        /// As its file is.
        inertias
        /// As its file is.
        legged
        /// As its file is.
        mixed_angles
        /// As its file is.
        no_gravity
        /// As its file is.
        orientations
        /// As its file is.
        several_joints
        /// As its file is.
        two_link_arm
        /// As its file is.
        walker
        /// As its file is.
        welded
    }

    /// Each model with the name of its folder.
    pub const MODELS: [(&str, MakeDynamics); 18] = [
        ("adjusted_inertias", || {
            Box::new(adjusted_inertias::Prepared::nominal())
        }),
        ("ant", || Box::new(ant::Prepared::nominal())),
        ("ball_joint_arm", || {
            Box::new(ball_joint_arm::Prepared::nominal())
        }),
        ("cart_with_springs", || {
            Box::new(cart_with_springs::Prepared::nominal())
        }),
        ("cheetah", || Box::new(cheetah::Prepared::nominal())),
        ("extrinsic_angles", || {
            Box::new(extrinsic_angles::Prepared::nominal())
        }),
        ("frames", || Box::new(frames::Prepared::nominal())),
        ("free_bodies", || Box::new(free_bodies::Prepared::nominal())),
        ("humanoid", || Box::new(humanoid::Prepared::nominal())),
        ("inertias", || Box::new(inertias::Prepared::nominal())),
        ("legged", || Box::new(legged::Prepared::nominal())),
        ("mixed_angles", || {
            Box::new(mixed_angles::Prepared::nominal())
        }),
        ("no_gravity", || Box::new(no_gravity::Prepared::nominal())),
        ("orientations", || {
            Box::new(orientations::Prepared::nominal())
        }),
        ("several_joints", || {
            Box::new(several_joints::Prepared::nominal())
        }),
        ("two_link_arm", || {
            Box::new(two_link_arm::Prepared::nominal())
        }),
        ("walker", || Box::new(walker::Prepared::nominal())),
        ("welded", || Box::new(welded::Prepared::nominal())),
    ];
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
    compiled!(talos, talos_snapped, None, Some(make!(talos_angles))),
];

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
