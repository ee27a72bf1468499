//! Masses of meshes: against MuJoCo's (`tests/meshes/reference.json`, by `make.py` there), and against formulas.
#![allow(
    clippy::unwrap_used,
    reason = "functions of tests, which clippy takes for others"
)]

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{fs, io};

use kane_codegen::description::{Description, Reading, WrittenBody, mjcf};
use kane_codegen::diagnostic::{Diagnostics, Source};
use kane_test_support::compare::{Tolerance, assert_close};
use serde_json::Value;

use crate::mjcf_support::{faults, number, vector};

/// Mass and mass centre: the same algorithm.
const SAME: f64 = 1e-12;
/// Inertias: MuJoCo takes them apart into moments and axes, and stops at axes that are 5e-8 off.
const AXES: f64 = 2e-7;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes")
}

/// A model, with the mesh files of the folder.
pub(crate) fn described(text: &str) -> Description {
    let include = |path: &str| fs::read(folder().join(path));
    mjcf::parse(
        &Source::new("model.xml", text),
        &Reading::default(),
        &include,
    )
}

/// A model, with these files.
pub(crate) fn described_with(text: &str, files: &[(&str, &[u8])]) -> Description {
    let files: BTreeMap<&str, &[u8]> = files.iter().copied().collect();
    let include = |path: &str| {
        let bytes = files.get(path).map(|bytes| bytes.to_vec());
        bytes.ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "there is no such file"))
    };
    mjcf::parse(
        &Source::new("model.xml", text),
        &Reading::default(),
        &include,
    )
}

fn element(name: &str, attributes: &Value) -> String {
    let attributes = attributes.as_object().unwrap().iter();
    let attributes =
        attributes.map(|(name, value)| format!(" {name}=\"{}\"", value.as_str().unwrap()));
    format!("<{name}{}/>", attributes.collect::<String>())
}

/// A model of one floating body, with one geom and its mesh.
pub(crate) fn model(compiler: &str, mesh: &str, geom: &str) -> String {
    format!(
        "<mujoco>{compiler}<asset>{mesh}</asset>
<worldbody><body name=\"body\"><freejoint/>{geom}</body></worldbody></mujoco>"
    )
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().unwrap();
    list.iter().map(|number| number.as_f64().unwrap()).collect()
}

fn is_faultless(description: &Description) {
    let faults = Diagnostics::new(description.source.clone(), description.faults.clone());
    assert!(!faults.has_error(), "{faults}");
}

fn inertia(body: &WrittenBody) -> [f64; 6] {
    body.inertia.map(number)
}

/// Trace, sum of the squares and determinant: what no rotation changes, each with its dimension made that of a moment.
fn invariants(tensor: &[f64]) -> [f64; 3] {
    let [xx, yy, zz, xy, xz, yz] = tensor.try_into().unwrap();
    let squares = xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + xz * xz + yz * yz);
    let determinant =
        xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    [xx + yy + zz, squares.sqrt(), libm::cbrt(determinant)]
}

#[test]
fn meshes_weigh_what_they_weigh_in_mujoco() {
    let cases: Value =
        serde_json::from_str(&fs::read_to_string(folder().join("reference.json")).unwrap())
            .unwrap();
    let (mut weighed, mut refused) = (0, 0);
    for case in cases.as_array().unwrap() {
        let mut mesh = case["mesh"].clone();
        mesh["name"] = "m".into();
        let mut geom = case["geom"].clone();
        geom["mesh"] = "m".into();
        let text = model(
            &element("compiler", &case["compiler"]),
            &element("mesh", &mesh),
            &element("geom", &geom),
        );
        let found = described(&text);
        let reference = &case["reference"];
        if reference.get("refused").is_some() {
            assert!(faults(&found).has_error(), "{text}");
            refused += 1;
            continue;
        }
        is_faultless(&found);
        let body = &found.bodies[0];
        // Shapes as wide as meshes are so along the axes.
        let is_fitted = case["compiler"].get("fitaabb").is_some();
        let tolerance = if is_fitted { AXES } else { SAME };
        let mass = reference["mass"].as_f64().unwrap();
        let exactly = Tolerance::relative(tolerance);
        assert_close(&text, &[number(body.mass)], &[mass], exactly);
        let center = vector(body.mass_center);
        let of_size = Tolerance::relative_beyond(0.01, tolerance);
        assert_close(&text, &center, &numbers(&reference["center"]), of_size);
        let expected = numbers(&reference["inertia"]);
        let found = inertia(body);
        assert_close(&text, &found, &expected, Tolerance::relative(AXES));
        let principal = Tolerance::relative(tolerance);
        assert_close(
            &text,
            &invariants(&found),
            &invariants(&expected),
            principal,
        );
        weighed += 1;
    }
    assert!(weighed > 150 && refused > 3, "{weighed}, {refused}");
}

/// The only body of a model without a fault.
fn only(text: &str) -> WrittenBody {
    let mut found = described(text);
    assert!(found.faults.is_empty(), "{}", faults(&found));
    assert_eq!(found.bodies.len(), 1);
    found.bodies.remove(0)
}

/// The mass properties of two bodies are the same but for rounding.
fn assert_same(a: &WrittenBody, b: &WrittenBody) {
    let of = |body: &WrittenBody| {
        let mut all = vec![number(body.mass)];
        all.extend(vector(body.mass_center));
        all.extend(inertia(body));
        all
    };
    for (a, b) in of(a).into_iter().zip(of(b)) {
        assert_close(
            "the same",
            &[a],
            &[b],
            Tolerance::relative_beyond(1.0, 1e-12),
        );
    }
}

#[test]
fn mesh_of_a_box_is_the_box() {
    let place = "pos=\"1 -2 0.5\" euler=\"10 50 -70\"";
    let shape = only(&model(
        "",
        "",
        &format!("<geom type=\"box\" size=\"1 2 3\" {place}/>"),
    ));
    for filling in ["legacy", "exact", "convex"] {
        let mesh = format!("<mesh file=\"box.obj\" inertia=\"{filling}\"/>");
        let geom = format!("<geom type=\"mesh\" mesh=\"box\" {place}/>");
        assert_same(&only(&model("", &mesh, &geom)), &shape);
        let fitted = format!("<geom type=\"box\" mesh=\"box\" {place}/>");
        assert_same(&only(&model("", &mesh, &fitted)), &shape);
        let wide = "<compiler fitaabb=\"true\"/>";
        assert_same(&only(&model(wide, &mesh, &fitted)), &shape);
    }
}

#[test]
fn the_compiler_of_mujoco_3_may_say_that_meshes_are_filled_exactly() {
    let geom = "<geom type=\"mesh\" mesh=\"box\"/>";
    let told = |compiler: &str, inertia: &str| {
        let mesh = format!("<mesh name=\"box\" file=\"bent.obj\" {inertia}/>");
        only(&model(compiler, &mesh, geom)).inertia.map(number)
    };
    let exact = told("", "inertia=\"exact\"");
    let of_compiler = told("<compiler exactmeshinertia=\"true\"/>", "");
    assert_eq!(exact, of_compiler);
    assert_ne!(exact, told("", ""));
}

#[test]
fn shell_of_a_box_has_the_mass_of_its_sides() {
    let mesh = "<mesh file=\"box.obj\" inertia=\"shell\"/>";
    let body = only(&model(
        "",
        mesh,
        "<geom type=\"mesh\" mesh=\"box\" density=\"1\"/>",
    ));
    let [a, b, c] = [2.0, 4.0, 6.0];
    assert_close(
        "mass",
        &[number(body.mass)],
        &[2.0 * (a * b + b * c + a * c)],
        Tolerance::relative(1e-14),
    );
    // About x: sides across y at b/2, across z at c/2, and two across x.
    let x = 2.0 * a * c * (b * b / 4.0 + c * c / 12.0)
        + 2.0 * a * b * (c * c / 4.0 + b * b / 12.0)
        + 2.0 * b * c * (b * b + c * c) / 12.0;
    assert_close(
        "moment",
        &inertia(&body)[..1],
        &[x],
        Tolerance::relative(1e-13),
    );
}

#[test]
fn hull_of_points_of_a_sphere_nears_the_ball() {
    // A spiral, of which no four points lie in a plane but by chance, and the centre, which is inside.
    let count = 4000;
    let mut points = "0 0 0".to_owned();
    for i in 0..count {
        let z = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(count);
        let (sine, cosine) = libm::sincos(2.399_963_229_728_653 * f64::from(i));
        let radius = (1.0 - z * z).sqrt();
        write!(points, " {} {} {z}", radius * cosine, radius * sine).unwrap();
    }
    let mesh = format!("<mesh name=\"ball\" vertex=\"{points}\"/>");
    let body = only(&model(
        "",
        &mesh,
        "<geom type=\"mesh\" mesh=\"ball\" density=\"1\"/>",
    ));
    let volume = 4.0 / 3.0 * std::f64::consts::PI;
    assert_close(
        "volume",
        &[number(body.mass)],
        &[volume],
        // The hull of these points lacks 1.48e-3 of the ball; that of four in five of them would lack 2.4e-3.
        Tolerance::relative(1.5e-3),
    );
    let moment = 0.4 * volume;
    assert_close(
        "moments",
        &inertia(&body)[..3],
        &[moment; 3],
        // Five thirds of that, for a moment grows with the fifth power of the radius.
        Tolerance::relative(2.5e-3),
    );
}

#[test]
fn hull_of_a_grid_is_the_box_around_it() {
    // Most points lie in a plane with many others, and many on lines.
    let mut points = String::new();
    for x in 0..9 {
        for y in 0..7 {
            for z in 0..5 {
                write!(points, "{x} {y} {z} {x} {y} {z} ").unwrap();
            }
        }
    }
    let mesh = format!("<mesh name=\"grid\" vertex=\"{points}\"/>");
    let grid = only(&model(
        "",
        &mesh,
        "<geom type=\"mesh\" mesh=\"grid\" density=\"1\"/>",
    ));
    let shape = only(&model(
        "",
        "",
        "<geom type=\"box\" size=\"4 3 2\" pos=\"4 3 2\" density=\"1\"/>",
    ));
    assert_same(&grid, &shape);
}

#[test]
fn meshes_inherit_from_classes_and_have_the_names_of_their_files() {
    let text = "<mujoco>
  <compiler assetdir=\"away\" meshdir=\"some\\where\" strippath=\"true\"/>
  <default>
    <mesh scale=\"2 2 2\" inertia=\"exact\"/>
    <default class=\"half\"><mesh scale=\"0.5 0.5 0.5\"/></default>
  </default>
  <asset><mesh file=\"../folder\\box.obj\"/><mesh class=\"half\" file=\"a/half.box.OBJ\"/></asset>
  <worldbody>
    <body name=\"a\"><freejoint/><geom type=\"mesh\" mesh=\"box\"/></body>
    <body name=\"b\"><freejoint/><geom type=\"mesh\" mesh=\"half.box\"/></body>
  </worldbody>
</mujoco>";
    let bytes = fs::read(folder().join("box.obj")).unwrap();
    let files = [
        ("some/where/box.obj", &*bytes),
        ("some/where/half.box.OBJ", &*bytes),
    ];
    let found = described_with(text, &files);
    assert!(found.faults.is_empty(), "{}", faults(&found));
    let masses: Vec<f64> = found.bodies.iter().map(|body| number(body.mass)).collect();
    assert_close("masses", &masses, &[384e3, 6e3], Tolerance::relative(1e-14));
}

#[test]
fn mesh_files_are_read_once_and_only_where_mass_follows_from_them() {
    let text = "<mujoco>
  <compiler inertiagrouprange=\"0 2\"/>
  <asset><mesh file=\"box.obj\"/><mesh file=\"seen.obj\"/><mesh name=\"plug\"><plugin plugin=\"p\"/></mesh></asset>
  <worldbody>
    <geom type=\"mesh\" mesh=\"seen\"/>
    <body><geom type=\"mesh\" mesh=\"seen\"/></body>
    <body><freejoint/>
      <geom type=\"mesh\" mesh=\"box\"/>
      <geom type=\"mesh\" mesh=\"box\" pos=\"1 0 0\"/>
      <geom type=\"mesh\" mesh=\"seen\" density=\"0\"/>
      <geom type=\"mesh\" mesh=\"seen\" mass=\"0\"/>
      <geom type=\"mesh\" mesh=\"plug\" group=\"3\"/>
    </body>
    <body><freejoint/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/><geom type=\"mesh\" mesh=\"seen\"/></body>
  </worldbody>
</mujoco>";
    let read = RefCell::new(Vec::new());
    let include = |path: &str| {
        read.borrow_mut().push(path.to_owned());
        fs::read(folder().join(path))
    };
    let found = mjcf::parse(
        &Source::new("model.xml", text),
        &Reading::default(),
        &include,
    );
    is_faultless(&found);
    assert_eq!(*read.borrow(), ["box.obj"]);
    assert_close(
        "mass",
        &[number(found.bodies[1].mass)],
        &[96e3],
        Tolerance::relative(1e-14),
    );
}

#[test]
fn mesh_of_an_included_file_may_stand_beside_it() {
    let bytes = fs::read(folder().join("box.obj")).unwrap();
    let text = "<mujoco><include file=\"parts/arm.xml\"/></mujoco>";
    let arm: &[u8] =
        b"<mujocoinclude><compiler meshdir=\"meshes\"/><asset><mesh file=\"box.obj\"/></asset>
<worldbody><body name=\"a\"><freejoint/><geom type=\"mesh\" mesh=\"box\"/></body></worldbody></mujocoinclude>";
    for place in ["meshes/box.obj", "parts/box.obj"] {
        let found = described_with(text, &[("parts/arm.xml", arm), (place, &bytes)]);
        assert!(found.faults.is_empty(), "{}", faults(&found));
        assert_close(
            "mass",
            &[number(found.bodies[0].mass)],
            &[48e3],
            Tolerance::relative(1e-14),
        );
    }
}
