//! The identities with their tolerances, each as a test.

/// A test for every identity. Where it stands, `EXACT` and `DIFFERENTIATED` are its
/// tolerances, and `hold(tolerance, identity)` tries an identity on all systems.
#[macro_export]
macro_rules! test_every_identity {
    () => {
        $crate::test_every_identity! {
            forces,
            mass_matrix_is_symmetric: 0.0;
            packed_mass_matrix_is_the_lower_triangle: EXACT;
            mass_matrix_is_positive_definite: EXACT;
            inverse_dynamics_is_linear: EXACT;
            forward_dynamics_undoes_inverse_dynamics: EXACT;
            forcing_is_loads_less_bias: EXACT;
            generalized_forces_are_projected_loads: EXACT;
            inverse_dynamics_is_newton_euler: EXACT;
            gravity_forces_hold_the_weight: EXACT;
        }
        $crate::test_every_identity! {
            operators,
            mass_matrix_product_is_the_product: EXACT;
            mass_matrix_solve_undoes_the_product: EXACT;
            mass_matrix_inverse_is_symmetric: 0.0;
            mass_matrix_inverse_is_the_inverse: EXACT;
            packed_inverse_is_the_lower_triangle: EXACT;
            mass_matrix_factors_make_the_mass_matrix: EXACT;
        }
        $crate::test_every_identity! {
            coriolis,
            coriolis_matrix_makes_the_bias: EXACT;
            rate_of_the_mass_matrix_is_twice_the_symmetric_part: EXACT;
            mass_matrix_dot_is_the_rate_of_the_mass_matrix: DIFFERENTIATED;
            coriolis_matrix_is_that_of_the_christoffel_symbols: DIFFERENTIATED;
        }
        $crate::test_every_identity! {
            energies,
            power_is_the_rate_of_energy: DIFFERENTIATED;
            bias_follows_from_the_energies: DIFFERENTIATED;
            bias_at_rest_is_the_gradient_of_potential_energy: DIFFERENTIATED;
            energies_and_momenta_are_sums_over_bodies: EXACT;
            energies_by_body_are_those_of_bodies: EXACT;
            momenta_of_a_floating_tree_change_by_external_loads: DIFFERENTIATED;
        }
        $crate::test_every_identity! {
            loaded,
            loads_take_their_generalized_forces_off: EXACT;
            loaded_forward_dynamics_undoes_loaded_inverse_dynamics: EXACT;
            joint_wrenches_balance_bodies: EXACT;
            joint_wrenches_along_motions_are_the_forces: EXACT;
        }
        $crate::test_every_identity! {
            hybrid,
            hybrid_dynamics_keeps_a_motion_and_its_forces: EXACT;
            whole_forces_are_those_of_whole_accelerations: EXACT;
        }
        $crate::test_every_identity! {
            center,
            the_mass_center_moves_as_all_mass_does: EXACT;
            the_centroidal_momentum_matrix_gives_momentum: EXACT;
            the_mass_center_s_jacobian_is_linear_momentum_s: EXACT;
            centroidal_momentum_changes_as_its_matrix_says: DIFFERENTIATED;
        }
        $crate::test_every_identity! {
            regressor,
            inertial_parameters_are_those_of_the_description: EXACT;
            base_parameters_make_the_forces_of_inertial_ones: FITTED;
            the_regressor_is_linear_in_inertial_parameters: EXACT;
            the_packed_regressor_has_all_that_is_not_zero: EXACT;
            the_joint_regressor_is_linear_in_dampers_and_rotors: EXACT;
        }
        $crate::test_every_identity! {
            kinematics,
            velocities_are_rates_of_positions: DIFFERENTIATED;
            accelerations_are_rates_of_velocities: DIFFERENTIATED;
            partial_velocities_make_velocities: DIFFERENTIATED;
            rotations_are_rotations: EXACT;
            positions_are_those_of_the_description: EXACT;
            angle_rates_undo_relative_angular_velocity: EXACT;
            singularity_is_the_cosine_of_the_second_angle: EXACT;
            rates_of_coordinates_follow_from_the_speeds: EXACT;
            normalized_quaternions_have_length_one: EXACT;
        }
    };
    ($module:ident, $($name:ident: $tolerance:expr;)+) => {$(
        #[test]
        fn $name() {
            hold($tolerance, $crate::dynamics::$module::$name);
        }
    )+};
}
