//! Meshes of which no mass follows, each with its message; and those of which it follows with a warning.
#![allow(
    clippy::unwrap_used,
    reason = "functions of tests, which clippy takes for others"
)]

use std::fs;
use std::path::Path;

use kane_codegen::description::{Description, Reading, mjcf};
use kane_codegen::diagnostic::Source;
use kane_codegen::limits;
use kane_test_support::random::Random;

use crate::meshes::{described, described_with, model};
use crate::mjcf_support::{faults, number};

const GEOM: &str = "<geom name=\"shell\" type=\"mesh\" mesh=\"m\"/>";

/// The first line of what is wrong, and the advice.
fn told(description: &Description) -> String {
    let all = faults(description).to_string();
    let lines = all.lines().filter_map(|line| {
        let line = line.trim_start();
        let is_told = ["error", "warning"]
            .iter()
            .any(|word| line.starts_with(word));
        is_told.then(|| line.to_owned()).or_else(|| {
            line.split_once("= help: ")
                .map(|(_, help)| format!("  {help}"))
        })
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// What is told of a mesh file with these bytes.
fn of_file(name: &str, bytes: &[u8]) -> String {
    let mesh = format!("<mesh name=\"m\" file=\"{name}\"/>");
    let found = described_with(&model("", &mesh, GEOM), &[(name, bytes)]);
    told(&found)
}

fn of_mesh(attributes: &str) -> String {
    let mesh = format!("<mesh name=\"m\" {attributes}/>");
    told(&described(&model("", &mesh, GEOM)))
}

/// A binary STL of triangles with these corners.
fn stl(corners: &[[f32; 3]]) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend(u32::try_from(corners.len() / 3).unwrap().to_le_bytes());
    for triangle in corners.chunks(3) {
        bytes.extend([0; 12]);
        bytes.extend(triangle.iter().flatten().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

const CORNERS: [[f32; 3]; 12] = [
    [0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 1.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
];

#[test]
fn broken_stl() {
    let whole = stl(&CORNERS);
    assert_eq!(of_file("m.stl", &whole), "");
    let mut far = CORNERS;
    far[5][1] = 2e9;
    let mut endless = CORNERS;
    endless[7][2] = f32::NAN;
    let mut many = whole.clone();
    many[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let told = [
        of_file("m.stl", b""),
        of_file("m.stl", b"too short"),
        of_file("m.stl", &whole[..whole.len() - 1]),
        of_file("m.stl", &[&whole[..], b"+"].concat()),
        of_file("m.stl", &[b"solid", &whole[5..], b"+"].concat()),
        of_file("m.stl", &many),
        of_file("m.stl", &stl(&[])),
        of_file("m.stl", &stl(&CORNERS[..3])),
        of_file("m.stl", &stl(&far)),
        of_file("m.stl", &stl(&endless)),
    ];
    insta::assert_snapshot!(told.join("\n"));
}

#[test]
fn pointers_of_git_lfs_are_told_as_such() {
    let pointer = b"version https://git-lfs.github.com/spec/v1\noid sha256:656b\nsize 2197848\n";
    for name in ["m.stl", "m.obj", "m.msh"] {
        let told = of_file(name, pointer);
        assert!(
            told.contains("is a Git LFS pointer, not the file"),
            "{told}"
        );
        assert!(told.contains("\n  run `git lfs pull`"), "{told}");
    }
}

#[test]
fn broken_stl_that_is_text() {
    let triangle = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\n";
    let told = [
        of_file("m.stl", format!("solid a\n{triangle}").as_bytes()),
        of_file("m.stl", format!("solid a\n{triangle}endsolid").as_bytes()),
        of_file(
            "m.stl",
            b"solid a\nouter loop\nvertex 0 0\nendloop\nendsolid",
        ),
        of_file(
            "m.stl",
            b"solid a\nouter loop\nvertex 0 0 zero\nendloop\nendsolid",
        ),
        of_file(
            "m.stl",
            b"solid a\nouter loop\nvertex 0 0 0\nendloop\nendsolid",
        ),
        of_file("m.stl", b"solid a\nvertex 0 0 0\nendsolid"),
        of_file("m.stl", b"solid a\nouter loop\nouter loop\nendsolid"),
        of_file("m.stl", b"solid a\nendsolid"),
        of_file("m.stl", b"solid a\n\xff\xfe\x00binary"),
    ];
    insta::assert_snapshot!(told.join("\n"));
}

#[test]
fn broken_msh() {
    let header = |counts: [i32; 4]| counts.map(i32::to_le_bytes).concat();
    let points: Vec<u8> = CORNERS[1..6]
        .iter()
        .flatten()
        .flat_map(|x| x.to_le_bytes())
        .collect();
    let face = [0_i32, 1, -1].map(i32::to_le_bytes).concat();
    let told = [
        of_file("m.msh", &[0; 15]),
        of_file("m.msh", &header([3, 0, 0, 0])),
        of_file("m.msh", &header([5, 4, 0, 0])),
        of_file("m.msh", &header([5, 0, 0, -1])),
        of_file("m.msh", &header([i32::MAX; 4])),
        of_file("m.msh", &[header([5, 0, 0, 1]), points.clone()].concat()),
        of_file("m.msh", &[header([5, 0, 0, 1]), points, face].concat()),
    ];
    insta::assert_snapshot!(told.join("\n"));
}

#[test]
fn meshes_of_too_many_points_are_refused() {
    let count = limits::MESH_POINTS + 1;
    let mut bytes = i32::try_from(count).unwrap().to_le_bytes().to_vec();
    bytes.resize(16 + 12 * count, 0);
    let expected = |file: &str, what: &str| {
        format!(
            "error: the mesh file `{file}` has more than 500000 {what}
  simplify the mesh, or give the body an `inertial`"
        )
    };
    assert_eq!(of_file("m.msh", &bytes), expected("m.msh", "points"));
    let points = "v 0 0 0\n".repeat(count);
    let told = of_file("m.obj", points.as_bytes());
    assert_eq!(told, expected("m.obj", "points"));
    let faces = "v 0 0 0\n".repeat(4) + &"f 1 2 3\n".repeat(limits::MESH_FACES + 1);
    let told = of_file("m.obj", faces.as_bytes());
    assert_eq!(told, expected("m.obj", "faces"));
}

#[test]
fn files_are_read_until_all_of_them_are_too_large() {
    let bytes = vec![0; limits::MESH_BYTES];
    let count = limits::MESHES_BYTES / limits::MESH_BYTES + 1;
    let names: Vec<String> = (0..=count).map(|place| format!("{place}.msh")).collect();
    let element = |name: &String| {
        let geom = format!("<geom name=\"of_{name}\" type=\"mesh\" mesh=\"{name}\"/>");
        (format!("<mesh name=\"{name}\" file=\"{name}\"/>"), geom)
    };
    let (meshes, geoms): (Vec<String>, Vec<String>) = names.iter().map(element).unzip();
    let files: Vec<(&str, &[u8])> = names
        .iter()
        .map(|name| (name.as_str(), &bytes[..]))
        .collect();
    let told = told(&described_with(
        &model("", &meshes.concat(), &geoms.concat()),
        &files,
    ));
    assert_eq!(told.matches("says that it has 0 points").count(), count - 1);
    let last = format!("the mesh files up to `{}` have ", names[count - 1]);
    assert_eq!(told.matches(&last).count(), 1, "{told}");
    assert_eq!(told.matches("error: ").count(), count);
}

#[test]
fn files_that_cannot_be_read_are_all_told() {
    let names: Vec<String> = (0..20).map(|place| format!("{place}.obj")).collect();
    let meshes = names
        .iter()
        .map(|name| format!("<mesh name=\"{name}\" file=\"{name}\"/>"));
    let geoms = names
        .iter()
        .map(|name| format!("<geom type=\"mesh\" mesh=\"{name}\"/>"));
    let text = model("", &meshes.collect::<String>(), &geoms.collect::<String>());
    let include = |_: &str| Err(std::io::ErrorKind::IsADirectory.into());
    let found = mjcf::parse(
        &Source::new("model.xml", text),
        &Reading::default(),
        &include,
    );
    assert_eq!(told(&found).matches("cannot be read").count(), names.len());
}

#[test]
fn text_with_a_byte_order_mark_or_with_other_ends_of_lines_is_the_same_mesh() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes");
    for name in ["l.obj", "l_text.stl"] {
        let text = fs::read_to_string(folder.join(name)).unwrap();
        let mesh = format!("<mesh name=\"m\" file=\"{name}\"/>");
        let mass = |text: &str| {
            let found = described_with(&model("", &mesh, GEOM), &[(name, text.as_bytes())]);
            assert_eq!(told(&found), "", "{name}");
            number(found.bodies[0].mass)
        };
        let expected = mass(&text);
        assert_eq!(mass(&format!("\u{feff}{text}")), expected);
        assert_eq!(mass(&text.replace('\n', "\r\n")), expected);
        assert_eq!(mass(&text.replace('\n', "\r")), expected);
        assert_eq!(mass(&text.replacen('\n', "\r", 7)), expected);
    }
}

#[test]
fn changed_files_are_read_or_refused() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes");
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    files.sort_unstable();
    let mut random = Random::new(11);
    for path in files {
        let name = path.file_name().unwrap().to_str().unwrap();
        let whole = fs::read(&path).unwrap();
        for filling in ["legacy", "exact", "convex", "shell"] {
            let mesh = format!("<mesh name=\"m\" file=\"{name}\" inertia=\"{filling}\"/>");
            for _ in 0..40 {
                let mut bytes = whole.clone();
                for _ in 0..=random.below(4) {
                    let place = random.below(bytes.len());
                    match random.below(3) {
                        0 => bytes[place] = u8::try_from(random.below(256)).unwrap(),
                        1 => bytes.truncate(place + 1),
                        _ => bytes[place] ^= 1 << random.below(8),
                    }
                }
                let found = described_with(&model("", &mesh, GEOM), &[(name, &bytes)]);
                let told = told(&found);
                let mass = found.bodies[0].mass.map(|mass| mass.value.nominal());
                let is_read = mass.is_some_and(|mass| mass.is_finite() && mass > 0.0);
                assert!(is_read || told.contains("error: "), "{name}: {told}");
            }
        }
    }
}

#[test]
fn broken_obj() {
    let points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    let with = |faces: &str| of_file("m.obj", format!("{points}{faces}").as_bytes());
    let told = [
        of_file("m.obj", b"v 0 0\n"),
        of_file("m.obj", b"v 0 0 x\n"),
        of_file("m.obj", b"\x00\xff\xfe"),
        with("f 1 2 5\n"),
        with("f 1 2 3 9\n"),
        with("f 1 2 0\n"),
        with("f 1 2 -5\n"),
        with("f 1 2 99999999999999999999\n"),
        with("f 1 2 x\n"),
        with("v 1e39 0 0\nf 1 2 3\n"),
        of_file("m.obj", b"v 1 1 1\nv 1 1 1\nv 1 1 1\nv 1 1 1\n"),
    ];
    insta::assert_snapshot!(told.join("\n"));
}

#[test]
fn meshes_without_a_mass() {
    let told = [
        of_mesh("file=\"inward.obj\" inertia=\"exact\""),
        of_mesh("file=\"one_inward.obj\" inertia=\"exact\""),
        of_mesh("file=\"flat.obj\""),
        of_mesh("file=\"flat.obj\" inertia=\"convex\""),
        of_mesh("file=\"l.obj\" scale=\"1 1 0\""),
        of_mesh("file=\"l.obj\" scale=\"1e200 1e200 1e200\""),
        of_mesh("file=\"l.obj\" scale=\"1e-6 1e-6 1e-6\""),
        of_mesh("file=\"l.obj\" inertia=\"convex\" maxhullvert=\"5\""),
        of_mesh("file=\"l.obj\" maxhullvert=\"3\""),
        of_mesh("file=\"l.obj\" refquat=\"0 0 0 0\""),
        of_mesh("file=\"l.obj\" inertia=\"hollow\""),
        of_mesh("file=\"l.obj\" vertex=\"0 0 0\""),
        of_mesh("file=\"l.ply\""),
        of_mesh("builtin=\"sphere\" params=\"2\""),
        of_mesh(""),
    ];
    insta::assert_snapshot!(told.join("\n"));
}

#[test]
fn points_and_faces_in_the_model() {
    let points = "vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\"";
    let told = [
        of_mesh("vertex=\"0 0 0 1\""),
        of_mesh("vertex=\"0 0 0 1 0 0 0 1 0\""),
        of_mesh("vertex=\"0 0 0 1 0 0 0 1 0 0 0 inf\""),
        of_mesh("vertex=\"0 0 0 1 0 0 0 1 0 0 0 z\""),
        of_mesh(&format!("{points} face=\"0 2 1 0 1\"")),
        of_mesh(&format!("{points} face=\"0 2 1 0 1 4\"")),
        of_mesh(&format!("{points} face=\"0 2 -1\"")),
    ];
    insta::assert_snapshot!(told.join("\n"));
    assert_eq!(of_mesh(points), "");
}

#[test]
fn geoms_that_do_not_go_with_their_mesh() {
    let of_geom = |attributes: &str| {
        let geom = format!("<geom name=\"shell\" {attributes}/>");
        let mesh = "<mesh name=\"m\" file=\"l.obj\"/><mesh name=\"twice\" file=\"l.obj\"/><mesh name=\"twice\" file=\"l.obj\"/>";
        told(&described(&model("", mesh, &geom)))
    };
    let told = [
        of_geom("type=\"mesh\""),
        of_geom("type=\"mesh\" mesh=\"n\""),
        of_geom("type=\"mesh\" mesh=\"twice\""),
        of_geom("type=\"mesh\" mesh=\"m\" shellinertia=\"true\""),
        of_geom("type=\"mesh\" mesh=\"m\" fromto=\"0 0 0 1 1 1\""),
        of_geom("type=\"box\" mesh=\"m\" fitscale=\"-1\""),
    ];
    insta::assert_snapshot!(told.join("\n"));
}

#[test]
fn files_outside_of_the_model_s_folder_are_warned_of() {
    let whole = stl(&CORNERS);
    for path in ["../m.stl", "a/../../m.stl", "/m.stl"] {
        let mesh = format!("<mesh name=\"m\" file=\"{path}\"/>");
        let found = described_with(&model("", &mesh, GEOM), &[(path, &whole)]);
        let expected = format!(
            "warning: the mesh file `{path}`, from which the mass of geom `shell` follows, is outside of the model's folder"
        );
        assert_eq!(told(&found), expected);
        assert!(number(found.bodies[0].mass) > 0.0);
    }
    let mesh = "<mesh name=\"m\" file=\"a/../b/m.stl\"/>";
    let found = described_with(&model("", mesh, GEOM), &[("a/../b/m.stl", &whole)]);
    assert_eq!(told(&found), "");
}

#[test]
fn what_mujoco_leaves_out_of_a_file_is_warned_of() {
    let told = [
        of_mesh("file=\"several.obj\""),
        of_mesh("file=\"round.obj\""),
        {
            let geom = "<geom name=\"shell\" type=\"mesh\" mesh=\"m\" mass=\"1\"/>";
            let mesh = "<mesh name=\"m\" file=\"l.obj\" scale=\"1e-5 1e-5 1e-5\"/>";
            told(&described(&model("", mesh, geom)))
        },
    ];
    insta::assert_snapshot!(told.join("\n"));
}
