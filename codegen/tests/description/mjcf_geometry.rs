//! MJCF becomes the description that MuJoCo means: orientations, and masses of shapes, against formulas of their own.

use std::f64::consts::PI;

use kane_test_support::compare::larger;

use crate::mjcf_support::{
    SAME, Vector, attachment_rotation, close, elementary, faults, number, only, oriented, parse,
    product, read, transposed, vector,
};

#[test]
fn axis_and_angle_turn_as_rodrigues_says() {
    let body = only("", "<body axisangle=\"2 -1 2 40\"/>");
    let [x, y, z] = [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0];
    let (s, c) = libm::sincos(40.0 * PI / 180.0);
    let cross = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let square = product(&cross, &cross);
    let expected = [0, 1, 2]
        .map(|i| [0, 1, 2].map(|j| SAME[i][j] + s * cross[i][j] + (1.0 - c) * square[i][j]));
    oriented(&body, &expected);
    let radian = only(
        "<compiler angle=\"radian\"/>",
        "<body axisangle=\"2 -1 2 0.6981317007977318\"/>",
    );
    oriented(&radian, &expected);
    // The same as a quaternion, three times as long.
    let (s, c) = libm::sincos(20.0 * PI / 180.0);
    let [x, y, z] = [x, y, z].map(|entry| 3.0 * s * entry);
    oriented(
        &only("", &format!("<body quat=\"{} {x} {y} {z}\"/>", 3.0 * c)),
        &expected,
    );
}

#[test]
fn lengths_beyond_a_float_have_directions() {
    // Their squares overflow.
    for [large, small] in [
        ["axisangle=\"0 3e200 4e200 40\"", "axisangle=\"0 3 4 40\""],
        ["zaxis=\"1e308 1e308 0\"", "zaxis=\"1 1 0\""],
        [
            "xyaxes=\"1e308 0 0 1e308 1e308 0\"",
            "xyaxes=\"1 0 0 1 1 0\"",
        ],
        ["quat=\"1e308 0 -1e308 0\"", "quat=\"1 0 -1 0\""],
    ] {
        let [large, small] = [large, small].map(|turned| only("", &format!("<body {turned}/>")));
        oriented(&large, &transposed(&attachment_rotation(&small)));
    }
    let body = only(
        "",
        "<body><joint axis=\"0 1e200 0\"/><geom size=\"0.1\"/></body>",
    );
    assert_eq!(body.joint.axis.unwrap().value, [0.0, 1e200, 0.0]);
}

#[test]
fn euler_angles_turn_in_any_sequence() {
    let [a, b, c] = [0.3, -0.8, 1.9];
    for sequence in ["xyz", "zyx", "XYZ", "ZXY", "zXz", "xYx", "XyZ", "zzX"] {
        let mut expected = SAME;
        for (letter, angle) in sequence.chars().zip([a, b, c]) {
            let turn = elementary(letter.to_ascii_lowercase(), angle);
            expected = if letter.is_ascii_lowercase() {
                product(&expected, &turn)
            } else {
                product(&turn, &expected)
            };
        }
        let compiler = format!("<compiler angle=\"radian\" eulerseq=\"{sequence}\"/>");
        let body = only(&compiler, &format!("<body euler=\"{a} {b} {c}\"/>"));
        oriented(&body, &expected);
    }
}

#[test]
fn two_axes_are_made_orthogonal() {
    let body = only("", "<body xyaxes=\"0 2 0 3 1 0\"/>");
    let [x, y, z] = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]];
    assert_eq!(attachment_rotation(&body), [x, y, z]);
}

#[test]
fn z_axis_is_reached_by_the_least_rotation() {
    let body = only("", "<body zaxis=\"1 2 -2\"/>");
    let rotation = attachment_rotation(&body);
    close(&rotation[2], &[1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0]);
    // The angle of a rotation follows from the trace; here it is that between the two axes.
    let trace = rotation[0][0] + rotation[1][1] + rotation[2][2];
    close(&[(trace - 1.0) / 2.0], &[-2.0 / 3.0]);
    close(
        product(&rotation, &transposed(&rotation)).as_flattened(),
        SAME.as_flattened(),
    );
    let down = attachment_rotation(&only("", "<body zaxis=\"0 0 -2\"/>"));
    assert_eq!(down, [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]);
    // Nearly so, as numbers of 32 bits have it, MuJoCo 4 turns about x, too.
    let nearly = attachment_rotation(&only("", "<body zaxis=\"3e-8 0 -1\"/>"));
    assert_eq!(nearly, down);
}

#[test]
fn right_angles_leave_no_crumbs() {
    let quarter = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    for orientation in [
        "euler=\"0 0 90\"",
        "euler=\"0 0 -270\"",
        "euler=\"0 0 450\"",
        "axisangle=\"0 0 3 90\"",
        "quat=\"0.707107 0 0 0.707107\"",
        "xyaxes=\"0 7 0 -3 0 0\"",
    ] {
        let body = only("", &format!("<body {orientation}/>"));
        assert_eq!(attachment_rotation(&body), quarter, "{orientation}");
    }
    let none = only("", "<body euler=\"0 0 360\"/>");
    assert_eq!(none.joint.attachment_rotation, None);
}

#[test]
fn geom_has_the_mass_of_its_shape() {
    let geom = |attributes: &str| {
        let body = only("", &format!("<body><geom {attributes}/></body>"));
        let mut numbers = vec![number(body.mass)];
        numbers.extend(vector(body.mass_center));
        numbers.extend(body.inertia.map(number));
        assert_eq!(body.inertia_rotation, None);
        numbers
    };
    let about = |mass: f64, moments: Vector| {
        let mut numbers = vec![mass, 0.0, 0.0, 0.0];
        numbers.extend(moments.map(|moment| mass * moment));
        numbers.extend([0.0; 3]);
        numbers
    };
    let sphere = 4.0 / 3.0 * PI * 8.0 * 1000.0;
    close(&geom("size=\"2\""), &about(sphere, [1.6; 3]));
    close(
        &geom("size=\"2\" mass=\"3\" density=\"7\""),
        &about(3.0, [1.6; 3]),
    );
    close(
        &geom("type=\"box\" size=\"1 2 3\" density=\"2\""),
        &about(96.0, [13.0 / 3.0, 10.0 / 3.0, 5.0 / 3.0]),
    );
    close(
        &geom("type=\"ellipsoid\" size=\"1 2 3\" density=\"1\""),
        &about(8.0 * PI, [13.0 / 5.0, 10.0 / 5.0, 5.0 / 5.0]),
    );
    close(
        &geom("type=\"cylinder\" size=\"1 2\" density=\"1\""),
        &about(4.0 * PI, [(3.0 + 16.0) / 12.0, (3.0 + 16.0) / 12.0, 0.5]),
    );
    // Turned by a right angle, and at a place: the tensor follows, and no corner of it is left over.
    let mut turned = about(96.0, [5.0 / 3.0, 10.0 / 3.0, 13.0 / 3.0]);
    turned[1..4].copy_from_slice(&[4.0, 5.0, 6.0]);
    close(
        &geom("type=\"box\" size=\"1 2 3\" density=\"2\" pos=\"4 5 6\" euler=\"0 90 0\""),
        &turned,
    );
}

#[test]
fn capsule_is_the_sum_of_its_slices() {
    let (radius, half): (f64, f64) = (0.3, 0.7);
    let body = only(
        "",
        "<body><geom type=\"capsule\" size=\"0.3 0.7\" density=\"1\"/></body>",
    );
    let (mut mass, mut along, mut across) = (0.0, 0.0, 0.0);
    let slices = 200_000;
    let height = 2.0 * (half + radius) / f64::from(slices);
    for slice in 0..slices {
        let z = (f64::from(slice) + 0.5) * height - half - radius;
        let beyond = larger(z.abs() - half, 0.0);
        let square = radius * radius - beyond * beyond;
        let disc = PI * square * height;
        mass += disc;
        along += disc * square / 2.0;
        across += disc * (square / 4.0 + z * z);
    }
    let found = [
        number(body.mass),
        number(body.inertia[0]),
        number(body.inertia[2]),
    ];
    for (found, expected) in found.iter().zip([mass, across, along]) {
        assert!(
            (found / expected - 1.0).abs() < 1e-8,
            "{found}, expected {expected}"
        );
    }
}

#[test]
fn geoms_of_a_body_are_one_solid() {
    // Two small spheres at 1 and 4 on a line: a mass of 3 at 3, with 1 · 2² + 2 · 1² about it. MuJoCo lets no smaller ones have a mass.
    let body = only(
        "",
        "<body>
           <geom size=\"2e-5\" pos=\"1 0 0\" mass=\"1\"/>
           <geom size=\"2e-5\" pos=\"4 0 0\" mass=\"2\"/>
           <geom size=\"9\" mass=\"0\"/>
         </body>",
    );
    assert_eq!(number(body.mass), 3.0);
    assert_eq!(vector(body.mass_center), [3.0, 0.0, 0.0]);
    let own = 3.0 * 0.4 * 2e-5 * 2e-5;
    let moments = [own, 6.0 + own, 6.0 + own, 0.0, 0.0, 0.0];
    close(&body.inertia.map(number), &moments);
}

#[test]
fn segment_places_a_geom() {
    let body = only(
        "",
        "<body><geom type=\"cylinder\" size=\"0.1 9\" fromto=\"1 0 1 1 4 1\" mass=\"12\"/></body>",
    );
    assert_eq!(vector(body.mass_center), [1.0, 2.0, 1.0]);
    let across = 3.0 * 0.01 + 16.0;
    close(
        &body.inertia.map(number),
        &[across, 0.06, across, 0.0, 0.0, 0.0],
    );
}

#[test]
fn inertial_keeps_its_own_axes() {
    let body = only(
        "",
        "<body>
           <inertial pos=\"1 2 3\" euler=\"90 0 0\" mass=\"4\" diaginertia=\"5 6 7\"/>
           <geom size=\"1\"/>
         </body>",
    );
    assert_eq!(number(body.mass), 4.0);
    assert_eq!(vector(body.mass_center), [1.0, 2.0, 3.0]);
    assert_eq!(body.inertia.map(number), [5.0, 6.0, 7.0, 0.0, 0.0, 0.0]);
    let axes = body.inertia_rotation.unwrap().value;
    assert_eq!(axes, [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]);
    let full = only(
        "",
        "<body><inertial pos=\"0 0 0\" mass=\"1\" fullinertia=\"5 6 7 0.1 0.2 0.3\"/></body>",
    );
    assert_eq!(full.inertia.map(number), [5.0, 6.0, 7.0, 0.1, 0.2, 0.3]);
}

#[test]
fn settings_say_when_geoms_count() {
    let body = "<body>
        <inertial pos=\"0 0 0\" mass=\"4\" diaginertia=\"5 6 7\"/>
        <geom size=\"1\" mass=\"2\" group=\"1\"/>
        <geom size=\"1\" mass=\"1\" group=\"3\"/>
      </body>";
    let mass = |compiler: &str| number(only(compiler, body).mass);
    assert_eq!(mass(""), 4.0);
    assert_eq!(mass("<compiler inertiafromgeom=\"true\"/>"), 3.0);
    assert_eq!(
        mass("<compiler inertiafromgeom=\"true\" inertiagrouprange=\"0 2\"/>"),
        2.0
    );
    assert_eq!(
        mass("<compiler inertiafromgeom=\"true\" inertiagrouprange=\"4 5\"/>"),
        4.0
    );
    let bare = only(
        "<compiler inertiafromgeom=\"false\"/>",
        "<body><geom size=\"1\"/></body>",
    );
    assert_eq!(number(bare.mass), 0.0);
}

#[test]
fn first_entries_of_a_list_leave_the_others_to_the_default() {
    let default = "<default><geom type=\"box\" size=\"1 2 3\" density=\"2\"/>\
                   <default class=\"a\"><geom size=\"4 5\"/></default></default>";
    let body = only(default, "<body><geom class=\"a\" size=\"0.5\"/></body>");
    let whole = only(
        "",
        "<body><geom type=\"box\" size=\"0.5 5 3\" density=\"2\"/></body>",
    );
    assert_eq!(body.inertia.map(number), whole.inertia.map(number));
}

/// The masses of bodies, of a model with these settings.
fn masses(compiler: &str, bodies: &str) -> Vec<f64> {
    let text = format!(
        "<mujoco><compiler fusestatic=\"true\" {compiler}/><worldbody>{bodies}</worldbody></mujoco>"
    );
    let bodies = read(&text).bodies.into_iter();
    bodies.map(|body| number(body.mass)).collect()
}

#[test]
fn bodies_that_mujoco_fuses_have_the_mass_that_it_gives_them_together() {
    let inertial = "<inertial pos=\"1 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>";
    let geom = "<geom size=\"0.1\" mass=\"2\"/>";
    let pair = |one: &str, other: &str| format!("<body><joint/>{one}<body>{other}</body></body>");
    let always = "inertiafromgeom=\"true\"";
    for (compiler, bodies, expected) in [
        (always, pair(inertial, geom), [0.0, 2.0]),
        (always, pair(geom, inertial), [2.0, 0.0]),
        (always, pair(inertial, inertial), [1.0, 0.0]),
        (always, pair(geom, geom), [2.0, 2.0]),
        ("", pair(inertial, geom), [1.0, 2.0]),
        // What moves by itself is not fused.
        (
            always,
            pair(inertial, &format!("<joint/>{geom}")),
            [1.0, 2.0],
        ),
        (
            always,
            pair(inertial, &format!("<frame><joint/></frame>{geom}")),
            [1.0, 2.0],
        ),
    ] {
        assert_eq!(masses(compiler, &bodies), expected, "{bodies}");
    }
}

#[test]
fn what_mujoco_fuses_with_the_world_is_no_part_of_the_total_mass() {
    let geom = "<geom size=\"0.1\" mass=\"1\"/>";
    let arm = format!("<body><joint/>{geom}</body>");
    let total = "settotalmass=\"10\"";
    let table = format!("<body>{geom}<body>{geom}</body></body>{arm}");
    assert_eq!(masses(total, &table)[2], 10.0);
    for apart in ["mocap=\"true\"", "fuse=\"false\""] {
        let bodies = format!("<body {apart}>{geom}</body>{arm}");
        assert_eq!(masses(total, &bodies), [5.0, 5.0]);
    }
}

#[test]
fn models_of_other_settings_are_not_fused_with_one_another() {
    let part = "<mujoco><compiler inertiafromgeom=\"true\"/><worldbody><body name=\"tool\">\
        <inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/></body></worldbody></mujoco>";
    let text = "<mujoco><compiler fusestatic=\"true\"/><asset><model name=\"part\" file=\"part.xml\"/></asset>\
        <worldbody><body><joint/><geom size=\"0.1\"/><attach model=\"part\" body=\"tool\" prefix=\"a\"/></body></worldbody></mujoco>";
    let told = faults(&parse(text, &[("part.xml", part)])).to_string();
    assert!(told.contains("models are attached"), "{told}");
}

#[test]
fn own_orientation_stands_for_the_inherited_one() {
    let body = only(
        "<default><geom type=\"box\" size=\"1 2 3\" mass=\"3\" euler=\"90 0 0\"/></default>",
        "<body><geom zaxis=\"0 0 1\"/></body>",
    );
    close(&body.inertia.map(number), &[13.0, 10.0, 5.0, 0.0, 0.0, 0.0]);
}
