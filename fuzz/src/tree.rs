//! Trees of a few bodies from bytes, most of them right: in our own format.

use std::fmt::Write as _;

use arbitrary::{Result, Unstructured};

/// Most bodies of a tree.
const MOST_BODIES: u8 = 4;
/// Most frames beside them.
const MOST_FRAMES: u8 = 2;
/// Numbers that are often special, beside any other.
const NUMBERS: [f64; 16] = [
    0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    0.1,
    -0.3,
    1.25,
    9.81,
    1e-9,
    1e-6,
    1e9,
    1e300,
    5e-324,
    std::f64::consts::FRAC_PI_2,
    -3.0,
];
/// Names, some of which collide or cannot stand in code.
const NAMES: [&str; 12] = [
    "a",
    "b",
    "A",
    "fn",
    "self",
    "r#type",
    "a b",
    "é",
    "1",
    "🦾",
    "*/ \\\" #{}",
    "_",
];
const JOINTS: [&str; 16] = [
    "\"fixed\"",
    "\"revolute\"",
    "\"continuous\"",
    "\"prismatic\"",
    "\"cylindrical\"",
    "\"planar\"",
    "\"universal\"",
    "\"spherical\"",
    "\"free\"",
    "[\"theta1\"]",
    "[\"theta2\"]",
    "[\"theta3\", \"s1\"]",
    "[\"s1\", \"s2\", \"s3\"]",
    "[\"theta1\", \"theta3\"]",
    "[\"theta1\", \"theta2\", \"theta3\"]",
    "[]",
];
const AXES: [&str; 6] = [
    "[1, 0, 0]",
    "[0, 1, 0]",
    "[0, 0, 1]",
    "[0, 0, -2]",
    "[1, 1, 0]",
    "[0.3, -0.4, 1e-7]",
];
const ROTATIONS: [&str; 5] = [
    "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]",
    "[[1, 0, 0], [0, 0, 1], [0, -1, 0]]",
    "[[0, 1, 0], [0, 0, 1], [1, 0, 0]]",
    "[[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]]",
    "[[1, 3.67e-6, 0], [-3.67e-6, 1, 0], [0, 0, 1]]",
];

/// A description.
pub(crate) fn text(bytes: &mut Unstructured<'_>) -> Result<String> {
    let n_bodies = bytes.int_in_range(1..=MOST_BODIES)?;
    let lower: Vec<u8> = (0..n_bodies)
        .map(|body| bytes.int_in_range(0..=body))
        .collect::<Result<_>>()?;
    let mut text = format!(
        "name = \"tree\"\ngravity = {}\nlower_bodies = {lower:?}\n",
        vector(bytes)?
    );
    if bytes.ratio(1, 3)? {
        text += "order = \"notes\"\n";
    }
    let names: Vec<String> = (0..n_bodies)
        .map(|body| self::body(bytes, &mut text, body))
        .collect::<Result<_>>()?;
    for frame in 0..bytes.int_in_range(0..=MOST_FRAMES)? {
        self::frame(bytes, &mut text, frame, &names)?;
    }
    Ok(text)
}

/// Writes a `[[frame]]`.
fn frame(
    bytes: &mut Unstructured<'_>,
    text: &mut String,
    frame: u8,
    bodies: &[String],
) -> Result<()> {
    let name = name(bytes)?;
    let _ = writeln!(text, "\n[[frame]]\nname = \"{name} {frame}\"");
    if bytes.ratio(3, 4)? {
        let _ = writeln!(text, "body = \"{}\"", bytes.choose(bodies)?);
    }
    if bytes.ratio(3, 4)? {
        let _ = writeln!(text, "position = {}", vector(bytes)?);
    }
    let rotation = bytes.choose(&ROTATIONS)?;
    match bytes.int_in_range(0..=3)? {
        0 => {}
        1 => {
            let _ = writeln!(text, "rotation = {{ runtime = {rotation} }}");
        }
        _ => {
            let _ = writeln!(text, "rotation = {rotation}");
        }
    }
    Ok(())
}

/// A name, as it stands between quotes.
fn name(bytes: &mut Unstructured<'_>) -> Result<String> {
    let name = bytes.choose(&NAMES)?;
    Ok(name.replace('\\', "\\\\").replace('"', "\\\""))
}

/// Writes a `[[body]]`, and gives its name.
fn body(bytes: &mut Unstructured<'_>, text: &mut String, body: u8) -> Result<String> {
    let name = name(bytes)?;
    let mut line = |key: &str, value: &str| {
        writeln!(text, "{key} = {value}").map_err(|_| arbitrary::Error::IncorrectFormat)
    };
    line("\n[[body]]\nname", &format!("\"{name}{body}\""))?;
    line("mass", &scalar(bytes)?)?;
    line("mass_center", &vector(bytes)?)?;
    let mut inertia = Vec::new();
    for (component, (least, scale)) in ["xx", "yy", "zz", "xy", "xz", "yz"]
        .iter()
        .zip([(0.1, 0.01); 3].into_iter().chain([(0.0, 1e-4); 3]))
    {
        let number = least + scale * f64::from(bytes.arbitrary::<u8>()? % 8);
        inertia.push(format!("{component} = {}", bound(bytes, number)?));
    }
    line("inertia", &format!("{{ {} }}", inertia.join(", ")))?;
    line("attachment", &vector(bytes)?)?;
    let joint = bytes.choose_index(JOINTS.len())?;
    line("joint", JOINTS[joint])?;
    if (1..=5).contains(&joint) {
        line("axis", bytes.choose(&AXES)?)?;
    }
    for key in ["inertia_rotation", "attachment_rotation", "body_rotation"] {
        if bytes.ratio(1, 4)? {
            line(key, bytes.choose(&ROTATIONS)?)?;
        }
    }
    if bytes.ratio(1, 4)? {
        line("body_attachment", &vector(bytes)?)?;
    }
    for key in ["stiffness", "rest", "damping", "armature"] {
        if bytes.ratio(1, 5)? {
            line(key, &scalar(bytes)?)?;
        }
    }
    if [7, 8, 14].contains(&joint) && bytes.ratio(1, 2)? {
        line("chart", "\"quaternion\"")?;
    } else if [9, 10].contains(&joint) && bytes.ratio(1, 4)? {
        line(
            "locked",
            &format!(
                "{{ theta3 = {:?}, s2 = {:?} }}",
                number(bytes)?,
                number(bytes)?
            ),
        )?;
    }
    if body > 0 && bytes.ratio(1, 5)? {
        line("joint_name", "\"follower\"")?;
        let (multiplier, offset) = (number(bytes)?, number(bytes)?);
        line(
            "mimic",
            &format!(
                "{{ joint = \"{}0\", multiplier = {multiplier:?}, offset = {offset:?} }}",
                bytes.choose(&NAMES[..4])?
            ),
        )?;
    }
    Ok(format!("{name}{body}"))
}

fn vector(bytes: &mut Unstructured<'_>) -> Result<String> {
    let [x, y, z] = [scalar(bytes)?, scalar(bytes)?, scalar(bytes)?];
    Ok(format!("[{x}, {y}, {z}]"))
}

fn scalar(bytes: &mut Unstructured<'_>) -> Result<String> {
    let number = number(bytes)?;
    bound(bytes, number)
}

/// In one of its binding times.
fn bound(bytes: &mut Unstructured<'_>, number: f64) -> Result<String> {
    Ok(if bytes.ratio(1, 8)? {
        format!("{{ runtime = {number:?} }}")
    } else {
        format!("{number:?}")
    })
}

fn number(bytes: &mut Unstructured<'_>) -> Result<f64> {
    if bytes.ratio(1, 16)? {
        bytes.arbitrary()
    } else {
        Ok(*bytes.choose(&NUMBERS)?)
    }
}
