//! The models of `tests/mjcf`.

/// Hands the names of the models to a macro, in their order.
#[macro_export]
macro_rules! mjcf_models {
    ($then:ident) => {
        $then! {
            adjusted_inertias
            ant
            attached
            ball_joint_arm
            bounded
            cart_with_springs
            cheetah
            extrinsic_angles
            frames
            free_bodies
            humanoid
            inertias
            legged
            lifted
            mixed_angles
            no_gravity
            orientations
            own_parts
            replicated
            several_joints
            sites
            spring_dampers
            two_link_arm
            walker
            weightless
            welded
        }
    };
}
