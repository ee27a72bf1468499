//! Real robots: their joints are those of the reference, which other software has read from the same files.

use std::path::Path;

use kane_codegen::{
    description::{self, Base, JointKind, Reading},
    diagnostic::Source,
    tree,
};

use super::{body_names, kind, limits, lower_bodies, parse_well};

/// The moving joints, in order, as the reference has them.
fn robot_agrees(name: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../tests/robots")
        .join(name);
    let text = |file: &str| {
        std::fs::read_to_string(folder.join(file)).expect("the file is in the repository")
    };
    let reference: serde_json::Value =
        serde_json::from_str(&text("reference.json")).expect("the reference is JSON");
    let reading = Reading {
        base: (reference["base"] == "floating").then_some(Base::Free),
        ..Reading::default()
    };
    let description = parse_well(&text(&format!("{name}.urdf")), &reading);
    let lower = lower_bodies(&description);
    let names = body_names(&description);

    let links = reference["links"].as_array().expect("it lists links");
    assert_eq!(
        names,
        links
            .iter()
            .map(|link| link.as_str().expect("it is a name"))
            .collect::<Vec<_>>()
    );
    let joints = reference["joints"].as_array().expect("it lists joints");
    let moving: Vec<usize> = (0..names.len())
        .filter(|body| *kind(&description.bodies[*body]) != JointKind::Fixed)
        .collect();
    assert_eq!(moving.len(), joints.len());
    for (body, joint) in moving.into_iter().zip(joints) {
        let read = &description.bodies[body].joint;
        assert_eq!(
            read.name.as_ref().expect("it has one").value,
            joint["name"].as_str().expect("it has one")
        );
        assert_eq!(names[body], joint["child_link"]);
        if lower[body] == 0 {
            assert_eq!(joint["type"], "floating");
            continue;
        }
        let parent = usize::try_from(lower[body] - 1).expect("it is a place");
        assert_eq!(names[parent], joint["parent_link"]);
        let kind = match joint["type"].as_str() {
            Some("revolute") => JointKind::Revolute,
            Some("continuous") => JointKind::Continuous,
            Some("prismatic") => JointKind::Prismatic,
            other => unreachable!("{other:?}"),
        };
        assert_eq!(read.kind.as_ref().expect("it has one").value, kind);
        let number = |value: &serde_json::Value| value.as_f64();
        let axis = joint["axis"]
            .as_array()
            .expect("it has one")
            .iter()
            .map(number);
        let read_axis = read.axis.expect("it has one").value;
        assert!(
            axis.eq(read_axis.into_iter().map(Some)),
            "{name} {read_axis:?}"
        );
        let [lower, upper, velocity, effort] = limits(read).unwrap_or_default();
        let limit = &joint["limit"];
        if kind != JointKind::Continuous {
            assert_eq!(
                [lower, upper],
                [number(&limit["lower"]), number(&limit["upper"])]
            );
        }
        assert_eq!(
            [velocity, effort],
            [number(&limit["velocity"]), number(&limit["effort"])]
        );
    }
}

/// Makes a test of each robot named.
macro_rules! robots {
    ($($name:ident)*) => {
        $(#[test]
        fn $name() {
            robot_agrees(stringify!($name));
        })*
    };
}

robots! {
    cartpole
    double_pendulum
    double_pendulum_continuous
    panda
    solo12
    talos
    ur5
}

/// Users map `q` by it: the order is the file's, not the alphabet's.
#[test]
fn the_order_of_coordinates_is_told() {
    let text = std::fs::read_to_string(format!(
        "{}/../tests/robots/panda/panda.urdf",
        env!("CARGO_MANIFEST_DIR")
    ));
    let source = Source::new("panda.urdf", text.unwrap());
    let reading = Reading::default();
    let description = description::read(&source, &reading, &description::no_includes);
    let checked = tree::build(&description).unwrap();
    let told = checked.warnings.to_string();
    let expected = "the coordinates, in order, are panda_joint1, panda_joint2, panda_joint3, panda_joint4, panda_joint5, \
                    panda_joint6, panda_joint7";
    assert!(told.contains(expected), "{told}");
}
