//! One fault a file, each with its whole message: MJCF.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{fs, io};

use kane_codegen::description::{Reading, mjcf};
use kane_codegen::diagnostic::{Diagnostics, Source};

/// Makes a test of each file named, and the list of their names.
macro_rules! files {
    ($($name:ident)*) => {
        const FILES: &[&str] = &[$(stringify!($name)),*];

        $(#[test]
        fn $name() {
            is_refused(stringify!($name));
        })*
    };
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/invalid/mjcf")
}

/// The text of a file, whatever git made of its line ends; the same words for a missing one on every system.
fn text(path: &str) -> io::Result<String> {
    match fs::read_to_string(folder().join(path)) {
        Ok(text) => Ok(text.replace("\r\n", "\n")),
        Err(error) => Err(io::Error::new(error.kind(), "there is no such file")),
    }
}

fn is_refused(name: &str) {
    let path = format!("{name}.xml");
    let source = text(&path).expect("the file is listed because it is there");
    let source = Source::new(path, source);
    let include = |path: &str| text(path).map(String::into_bytes);
    let description = mjcf::parse(&source, &Reading::default(), &include);
    let faults = Diagnostics::new(description.source, description.faults);
    assert!(faults.has_error());
    insta::assert_snapshot!(name, faults);
}

files! {
    active_equality
    actuator_with_armature
    aligned_free_joint
    attached_bodies
    attached_to_itself
    axis_is_zero
    ball_with_stiffness
    child_class_unknown
    class_given_twice
    composite
    eulerseq_too_short
    flex
    fluid
    free_joint_beside_another
    free_joint_in_a_body
    fromto_of_a_point
    full_inertia_turned
    fused_by_name
    fused_within_bounds
    global_coordinates
    gravity_too_short
    height_field
    include_in_a_circle
    include_of_itself
    include_twice
    include_without_file
    included_file_is_malformed
    included_file_is_missing
    included_number
    inertial_without_inertia
    inertial_without_mass
    inherited_polynomial
    joint_in_the_world
    joint_type_unknown
    limited_without_range
    merged_options
    mesh_file_is_missing
    mesh_is_unknown
    models_in_a_circle
    negative_geom_mass
    negative_spring_damper
    not_closed
    numbers_with_commas
    outermost_class_named
    overflow
    overflow_beside_masses
    own_parts
    plane_that_moves
    polynomial_damping
    pos_beside_fromto
    quaternion_is_zero
    range_reversed
    range_without_limited
    replicate_of_joints
    robot
    several_faults
    shell
    sites_with_fromto
    size_is_zero
    size_too_short
    sphere_with_fromto
    spring_damper
    spring_that_yields
    springref_of_no_spring
    tendon_with_damping_of_a_class
    tendon_with_stiffness
    too_many_freedoms
    two_inertials
    two_orientations
    unknown_class
    unknown_types_with_fromto
    worldbody_misspelt
}

#[test]
fn every_file_is_listed() {
    let entries = fs::read_dir(folder()).expect("the folder is there");
    let found: BTreeSet<String> = entries
        .filter_map(|entry| {
            let path = entry.expect("the folder can be read").path();
            let name = path.file_stem()?.to_str()?.to_owned();
            path.is_file().then_some(name)
        })
        .collect();
    let listed: BTreeSet<String> = FILES.iter().map(|name| (*name).to_owned()).collect();
    assert_eq!(found, listed);
}
