//! One fault a file, each with its whole message.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use kane_codegen::diagnostic::Source;
use kane_codegen::{config, description, tree};

/// Makes a test of each file named, and the list of their names.
macro_rules! files {
    ($list:ident, $check:ident: $($name:ident)*) => {
        const $list: &[&str] = &[$(stringify!($name)),*];

        $(#[test]
        fn $name() {
            $check(stringify!($name));
        })*
    };
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/invalid")
}

/// The file with this name below the folder, shown under its name alone.
fn source(name: &str) -> Source {
    file(&format!("{name}.toml"))
}

/// The same, with the ending in its name.
fn file(name: &str) -> Source {
    let path = folder().join(name);
    // Whatever git made of the line ends, columns and messages are the same; but a raw return would be shown.
    let text = fs::read_to_string(&path)
        .expect("the file is listed because it is there")
        .replace("\r\n", "\n");
    Source::new(name, text)
}

fn description_is_refused(name: &str) {
    let faults =
        tree::build(&description::toml::parse(&source(name))).expect_err("the file has a fault");
    assert!(faults.has_error());
    insta::assert_snapshot!(name, faults);
}

/// In a module of its own, for some faults are common to both kinds of file.
mod config_file {
    use super::{Source, config, source};

    fn is_refused(name: &str) {
        let file: Source = source(&format!("config/{name}"));
        let faults = config::parse(&file).expect_err("the file has a fault");
        insta::assert_snapshot!(format!("config_{name}"), faults);
    }

    files! { FILES, is_refused:
        abi_of_a_module_without_a_name
        keys_of_other_tools
        absolute_path
        all_and_more
        backslash
        budget_is_fraction
        budget_is_negative
        budget_is_number
        budget_of_a_function_that_is_not_generated
        budget_of_a_function_without_limit
        budget_of_unknown_function
        budget_of_unknown_kind
        compact_part_of_a_function
        empty_path
        fma_is_string
        frame_of_a_function_of_the_system
        function_without_its_frame
        functions_is_string
        lock_is_list
        locked_at_text
        manifest_is_string
        missing_model
        missing_output
        no_functions
        no_systems
        output_is_no_rust_file
        pose_along_local_axes
        remove_is_string
        removed_twice
        repeated_function
        repeated_joined_function
        repeated_part_of_a_function
        request_by_what_is_not_given
        request_for_a_second_derivative
        request_that_is_not_closed
        several_faults
        several_faults_of_changes
        snap_is_negative
        snap_too_large
        two_systems_one_output
        unknown_abi
        unknown_base
        unknown_chart
        unknown_formulation
        unknown_function
        unknown_function_far_from_any
        unknown_key
        unknown_part_of_a_function
        unknown_root_key
        unknown_technique
        velocity_along_unknown_axes
    }

    #[test]
    fn every_file_is_listed() {
        super::same("config", ".toml", FILES);
    }
}

/// In a module of its own, for some faults are common to both kinds of file.
mod urdf_file {
    use kane_codegen::description::{Reading, urdf};
    use kane_codegen::diagnostic::{Diagnostics, Severity};

    use super::{file, tree};

    /// All but notes: that a URDF has no gravity is no fault of these files.
    fn faults(name: &str) -> Diagnostics {
        let source = file(&format!("urdf/{name}.urdf"));
        let mut faults = urdf::parse(&source, &Reading::default()).faults;
        faults.retain(|fault| fault.severity != Severity::Note);
        Diagnostics::new(source, faults)
    }

    fn is_refused(name: &str) {
        let faults = faults(name);
        assert!(faults.has_error());
        insta::assert_snapshot!(format!("urdf_{name}"), faults);
    }

    fn is_warned_of(name: &str) {
        let faults = faults(name);
        assert!(!faults.has_error() && !faults.is_empty());
        insta::assert_snapshot!(format!("urdf_{name}"), faults);
    }

    files! { FILES, is_refused:
        axis_too_short
        bare_ampersand
        cycle
        cycle_beside_the_root
        damping_is_text
        doctype
        empty_file
        file_ends_early
        git_lfs_pointer
        inertia_is_nan
        inertia_without_components
        inertial_without_inertia
        joint_without_child
        joint_without_name
        joint_without_parent
        joint_without_type
        limit_is_nan
        link_on_itself
        link_with_empty_name
        link_without_name
        mass_is_empty
        mass_is_no_number
        mass_is_text
        mass_too_large
        mass_without_value
        mimic_without_joint
        missing_link
        misspelt_child
        misspelt_joint_type
        misspelt_link
        no_link
        parent_without_link
        raw_character
        repeated_attribute
        repeated_joint
        repeated_link
        robot_not_closed
        robot_without_name
        root_is_no_robot
        rpy_in_words
        rpy_too_long
        second_parent_missing
        several_faults
        several_roots
        tag_never_ends
        two_parents
        unknown_joint_type
        unexpanded
        world_not_declared
        wrong_end_tag
        xyz_too_short
        xyz_with_commas
        zero_axis
    }

    files! { WARNINGS, is_warned_of:
        inertial_without_mass
        robot_with_empty_name
        limit_of_a_planar_joint
        limit_without_range
        mimic_by_a_fixed_joint
        missing_limit
        repeated_elements
        rpy_in_degrees
        unknown_attributes
        unknown_elements
        xacro_leftovers
    }

    /// What is read without a fault, but is no tree.
    fn is_refused_by_the_tree(name: &str) {
        assert!(faults(name).is_empty(), "{}", faults(name));
        let faults = built(name).expect_err("the file has a fault");
        insta::assert_snapshot!(format!("urdf_{name}"), faults);
    }

    fn the_tree_warns_of(name: &str) {
        assert!(faults(name).is_empty(), "{}", faults(name));
        let warnings = built(name).expect("the file has no error").warnings;
        let mut list = warnings.list().to_vec();
        list.retain(|fault| fault.severity != Severity::Note);
        assert!(!list.is_empty());
        let warnings = Diagnostics::new(warnings.source().clone(), list);
        insta::assert_snapshot!(format!("urdf_{name}"), warnings);
    }

    fn built(name: &str) -> Result<tree::Checked, Diagnostics> {
        let source = file(&format!("urdf/{name}.urdf"));
        tree::build(&urdf::parse(&source, &Reading::default()))
    }

    files! { OF_THE_TREE, is_refused_by_the_tree:
        link_name_with_line_end
        massless_joints
        massless_robot
        massless_tip
        mimic_cycle
        mimic_of_fixed_joint
        mimic_of_itself
        mimic_of_unknown_joint
        negative_mass
    }

    files! { WARNINGS_OF_THE_TREE, the_tree_warns_of:
        indefinite_inertia
        indefinite_product_of_inertia
        inertia_breaks_the_triangle_inequality
        limit_of_no_range
        limits_in_degrees
        millimetres
        negative_limits
    }

    #[test]
    fn every_file_is_listed() {
        super::same(
            "urdf",
            ".urdf",
            &[FILES, WARNINGS, OF_THE_TREE, WARNINGS_OF_THE_TREE].concat(),
        );
    }
}

files! { FILES, description_is_refused:
    all_bodies_fixed
    angular_velocity_of_two_angles
    armature_of_no_coordinate
    armature_of_one_component
    attachment_too_large
    attachment_whose_square_is_too_large
    axis_at_run_time
    axis_is_zero
    axis_missing
    axis_not_expected
    body_attachment_too_short
    body_is_number
    body_as_a_table_twice
    body_is_one_table
    closed_loop
    damping_of_an_empty_list
    joint_that_is_a_screw
    body_on_itself
    cycle
    damping_by_coordinate_beside_an_axis
    damping_is_string
    damping_of_a_locked_coordinate
    damping_of_unknown_coordinate
    empty_name
    frame_at_infinity
    frame_called_as_a_body
    frame_in_unknown_body
    frame_that_is_no_rotation
    frame_that_is_no_rotation_at_run_time
    frame_twice
    frame_with_entries_at_run_time
    frame_with_unknown_key
    frame_without_name
    frames_with_several_faults
    friction_at_run_time
    gravity_is_number
    gravity_too_long
    incomplete_inertias
    joint_entry_is_number
    joint_is_number
    joint_name_is_number
    joints_that_contradict_their_names
    keys_of_other_places
    less_than_no_mass
    limit_at_run_time
    limits_is_number
    limits_of_unknown_coordinate
    limits_with_unknown_key
    locked_and_free
    locked_at_run_time
    locked_at_singular_angle
    locked_beside_an_axis
    locked_is_list
    locked_unknown_coordinate
    lower_bodies_is_number
    lower_body_is_fraction
    lower_body_too_large
    mass_center_too_short
    mass_is_infinite
    mass_is_nan
    mass_is_string
    massless_body_on_a_parallel_axis
    massless_slides_in_a_row
    massless_tip
    mimic_cycle
    mimic_into_a_cycle
    mimic_is_string
    mimic_of_a_fixed_joint
    mimic_of_a_joint_with_two
    mimic_of_no_joint_that_is_near
    mimic_of_the_body_of_a_joint
    mimic_of_two_coordinates
    mimic_of_unknown_joint
    mimic_too_large
    mimic_without_joint
    missing_attachment
    missing_bodies
    missing_body_name
    missing_inertia
    missing_inertia_component
    missing_joint
    missing_lower_bodies
    missing_mass
    missing_mass_center
    missing_name
    misspelt_axis
    misspelt_body_key
    misspelt_joint
    name_is_number
    name_that_turns_the_writing
    name_with_line_end
    negative_armature
    negative_lower_body
    negative_mass
    no_bodies
    no_free_coordinate
    no_keys
    no_root
    not_toml
    numbers_with_units
    point_mass_all_angles_at_its_center
    point_mass_on_its_axis
    quaternion_of_one_angle
    rates_of_a_quaternion
    rates_of_a_quaternion_of_one_angle
    repeated_coordinate
    repeated_key
    repeated_name
    rotation_is_not_orthogonal
    rotation_is_not_quite_orthogonal
    rotation_is_reflection
    rotation_is_too_large
    rotation_by_angles
    rotation_row_is_number
    rotation_with_two_rows
    runtime_is_string
    runtime_key_misspelt
    runtime_with_another_key
    several_faults
    several_joint_faults
    spring_of_a_floating_body
    spring_of_an_angular_velocity
    stiffness_of_all_and_of_one
    thin_rod_about_itself
    thin_rod_with_all_angles
    too_few_lower_bodies
    too_many_lower_bodies
    two_coordinates_of_one_name
    two_joints_of_one_name
    unclosed_list
    unknown_body_key
    unknown_chart
    unknown_coordinate
    unknown_inertia_key
    unknown_joint
    unknown_lower_body
    unknown_order
    unknown_root_key
    unknown_speeds
}

#[test]
fn every_file_is_listed() {
    same("", ".toml", FILES);
}

fn same(below: &str, ending: &str, listed: &[&str]) {
    let names = fs::read_dir(folder().join(below))
        .expect("the folder is in the repository")
        .map(|entry| entry.expect("a folder can be read to its end").file_name());
    let found: BTreeSet<String> = names
        .filter_map(|name| Some(name.to_str()?.strip_suffix(ending)?.to_owned()))
        .collect();
    let listed: BTreeSet<String> = listed.iter().map(|name| (*name).to_owned()).collect();
    assert_eq!(found, listed);
}
