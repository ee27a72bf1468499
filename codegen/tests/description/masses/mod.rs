//! Robots whose masses no rigid body has, or that have next to none, beside Pinocchio, which takes them as they are.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

mod removed;

use std::{fs, path::Path};

use kane_codegen::{
    description::{self, Reading, no_includes, urdf},
    diagnostic::{Diagnostics, Severity, Source},
    expr::Input,
    functions::{Formulation, Function},
    recursive::Plan,
    tree::{self, Checked, Tree, Value},
};
use kane_test_support::{compare::relative, json::flat};

fn text(file: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/description/masses");
    fs::read_to_string(folder.join(file)).unwrap()
}

fn robot(name: &str) -> Checked {
    let source = Source::new(format!("{name}.urdf"), text(&format!("{name}.urdf")));
    tree::build(&urdf::parse(&source, &Reading::default())).unwrap()
}

/// All but notes.
fn warnings(checked: &Checked) -> String {
    let mut list = checked.warnings.list().to_vec();
    list.retain(|finding| finding.severity != Severity::Note);
    Diagnostics::new(checked.warnings.source().clone(), list).to_string()
}

fn mass_matrix(tree: &Tree, q: &[f64]) -> Vec<f64> {
    let function = Function::find("mass_matrix").unwrap();
    let derived = function.derive(tree, Formulation::Recursive, &Plan::full(tree));
    derived.graph.evaluate(&derived.roots, |input| match input {
        Input::Q(at) => q[at.index()],
        other => unreachable!("{other:?} in a mass matrix of numbers"),
    })
}

#[test]
fn mass_matrices_are_those_of_pinocchio() {
    let reference: serde_json::Value = serde_json::from_str(&text("reference.json")).unwrap();
    for name in ["negative", "tiny", "without_mass"] {
        let tree = robot(name).tree;
        for state in reference[name].as_array().unwrap() {
            let found = mass_matrix(&tree, &flat(&state["q"]));
            // Some hundred roundings; what counts as zero is a part in 1e14.
            let error = relative(&found, &flat(&state["mass_matrix"]));
            assert!(error < 2e-14, "{name}: {error:e}");
        }
    }
}

#[test]
fn principal_moments_below_zero_are_a_warning() {
    insta::assert_snapshot!(warnings(&robot("negative")));
}

#[test]
fn what_counts_as_zero_is_zero_and_a_warning() {
    let checked = robot("tiny");
    insta::assert_snapshot!(warnings(&checked));
    let part = &checked.tree.bodies[1].parts[0];
    let own = [
        part.mass,
        part.inertia.xx,
        part.inertia.yy,
        part.inertia.zz,
        part.inertia.xy,
        part.inertia.xz,
    ];
    assert_eq!(own, [Value::Baked(0.0); 6]);
    // A crumb beside what counts is gone too, and nothing is said of it.
    assert_eq!(
        checked.tree.bodies[2].parts[0].inertia.xy,
        Value::Baked(0.0)
    );
}

#[test]
fn components_that_count_beside_others_of_a_small_inertia_count() {
    let link = |name: &str, inertia: &str| {
        format!(
            "<link name=\"{name}\"><inertial><mass value=\"1\"/><inertia {inertia}/></inertial></link>"
        )
    };
    let heavy = "ixx=\"1.2\" iyy=\"1.2\" izz=\"1.2\" ixy=\"0\" ixz=\"0\" iyz=\"0\"";
    let light =
        "ixx=\"2e-14\" iyy=\"2e-14\" izz=\"2e-14\" ixy=\"-1.1e-14\" ixz=\"1e-30\" iyz=\"0\"";
    let text = format!(
        "<robot name=\"r\">{}{}<joint name=\"j\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/>\
         <axis xyz=\"1 1 0\"/></joint></robot>",
        link("a", heavy),
        link("b", light)
    );
    let source = Source::new("r.urdf", text);
    let checked = tree::build(&urdf::parse(&source, &Reading::default())).unwrap();
    // About (1, 1, 0): (xx + yy) / 2 + xy.
    let found = mass_matrix(&checked.tree, &[0.3]);
    assert!(relative(&found, &[0.9e-14]) < 1e-14, "{found:?}");
}

/// The errors of a file, each by its first line.
fn errors(file: &str, text: &str) -> Vec<String> {
    let source = Source::new(file, text);
    let description = description::read(&source, &Reading::default(), &no_includes);
    let faults = tree::build(&description).unwrap_err();
    let errors = faults.list().iter().filter(|fault| fault.is_error());
    errors.map(|fault| fault.message.clone()).collect()
}

#[test]
fn what_could_not_be_read_is_not_said_to_have_no_mass() {
    let text = "<mujoco><default><default class=\"heavy\"><geom type=\"capsule\" size=\"0.1 0.5\"/></default></default>\
        <worldbody><body name=\"a\" childclass=\"haevy\"><joint axis=\"0 1 0\"/><geom size=\"0.1\" mass=\"0\"/></body></worldbody></mujoco>";
    assert_eq!(errors("a.xml", text), ["there is no default class `haevy`"]);
}

#[test]
fn a_frame_is_not_said_to_be_in_no_body_where_the_bodies_were_not_read() {
    let text = "name = \"s\"\nlower_bodies = [0]\n[[bodys]]\nname = \"a\"\n[[frame]]\nname = \"tool\"\nbody = \"a\"\n\
        position = [0, 0, 0]\n";
    assert_eq!(errors("s.toml", text), ["unknown key `bodys`"]);
}
