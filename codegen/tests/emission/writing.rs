//! Writing descriptions: what is written is read as what it was, and written again as the same text.

use std::fs;
use std::path::Path;

use kane_codegen::description::{
    Carrier, Chart, CoordinateName, Description, FrameRotation, Given, JointKind, Limits, Mimic,
    Optional, PerCoordinate, Rotation, Scalar, Speeds, WrittenBody, WrittenFrame, WrittenJoint,
    toml,
};
use kane_codegen::diagnostic::{Diagnostic, Source, Span, Spanned};
use kane_codegen::tree::Order;

use kane_test_support::{models, random::Random};

/// All that a description says, without the places where it says it.
fn said(description: &Description) -> String {
    let Description {
        source: _,
        name,
        gravity,
        lower_bodies,
        order,
        bodies,
        frames,
        faults: _,
    } = description;
    let text =
        format!("{name:#?} {gravity:#?} {lower_bodies:#?} {order:#?} {bodies:#?} {frames:#?}");
    let mut text = text.lines();
    let mut said = String::new();
    while let Some(line) = text.next() {
        if line.trim_start().ends_with("Span {") || line.trim() == "span: Span {" {
            // Its start, its end, its brace.
            text.nth(2);
        } else {
            said.push_str(line);
            said.push('\n');
        }
    }
    said
}

/// A system as it is written.
fn system(lower_bodies: &str, bodies: &[(&str, &str)]) -> String {
    let text = models::system(lower_bodies, bodies);
    let (head, rest) = text
        .split_once("gravity = [0, 0, 0]\n")
        .expect("it has none");
    let (name, lower) = head.split_once('\n').expect("the name is a line");
    format!("{name}\ngravity = [0.0, 0.0, 0.0]\n{lower}\n{rest}")
}

fn parse(text: &str) -> Description {
    toml::parse(&Source::new("model.toml", text))
}

/// Writes, reads and writes again; the result is what was written.
fn survives_writing(description: &Description) -> String {
    let text = toml::write(description).expect("the description is whole");
    let read = parse(&text);
    assert!(read.faults.is_empty(), "{text}\n{:#?}", read.faults);
    assert_eq!(said(&read), said(description), "{text}");
    assert_eq!(toml::write(&read).expect("it was written before"), text);
    text
}

const EVERY_KEY: &str = r#"name = "every key"
gravity = [0.0, 0.0, { runtime = -9.81 }]
lower_bodies = [0, 1, 1]
order = "notes"

[[body]]
name = "palm"
mass = { runtime = 1.5 }
mass_center = [0.0, { runtime = 0.01 }, -0.25]
inertia = { xx = 0.1, yy = 0.1, zz = { runtime = 0.02 }, xy = 1e-5, xz = 0.0, yz = 0.0 }
inertia_rotation = [
    [ 0.6, 0.8, 0.0],
    [-0.8, 0.6, 0.0],
    [ 0.0, 0.0, 1.0],
]
gravity_compensation = { runtime = 0.5 }
attachment = [0.0, 0.0, { runtime = 0.3 }]
joint = "free"
joint_name = "base"
chart = "quaternion"
speeds = "angular_velocity"
damping = { theta2 = 0.1, s3 = { runtime = 3.0 } }

[[body]]
name = "finger \"1\""
mass = 0.1
mass_center = [0.0, 0.0, 0.02]
inertia = { xx = 1e-5, yy = 1e-5, zz = 1e-6, xy = 0.0, xz = 0.0, yz = 0.0 }
attachment = [0.0, 0.02, 0.05]
attachment_rotation = [
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 0.0],
]
body_attachment = [0.0, 0.0, { runtime = -0.01 }]
body_rotation = [
    [1.0,  0.0, 0.0],
    [0.0,  0.0, 1.0],
    [0.0, -1.0, 0.0],
]
joint = "revolute"
joint_name = "finger_1"
axis = [0.0, 0.0, -2.0]
stiffness = { runtime = 10.0 }
rest = -0.1
damping = 0.5
armature = 0.001
friction = 0.25
limits = { lower = -1.0, upper = 1.5, velocity = 2.0, effort = 87.0 }

[[body]]
name = "finger 2"
mass = 0.1
mass_center = [0.0, 0.0, 0.02]
inertia = { xx = 1e-5, yy = 1e-5, zz = 1e-6, xy = 0.0, xz = 0.0, yz = 0.0 }
attachment = [0.0, -0.02, 0.05]
joint = ["theta1", "s2"]
locked = { theta2 = 0.5, s3 = -0.01 }
chart = "angles"
speeds = "rates"
stiffness = { theta1 = 0.5, s2 = { runtime = 3.0 } }
rest = { theta1 = 0.1 }
armature = { s2 = 1e300 }
friction = { theta1 = 0.1, s2 = 3.0 }
limits = { theta1 = { lower = -1.0 }, s2 = { effort = 5.0 } }
mimic = { joint = "finger_1", multiplier = -2.0, offset = 0.1 }

[[frame]]
name = "stand"
position = [1.0, 0.0, { runtime = 2.0 }]
rotation = [
    [ 0.0, 1.0, 0.0],
    [-1.0, 0.0, 0.0],
    [ 0.0, 0.0, 1.0],
]

[[frame]]
name = "tool0"
body = "left \"finger\""
rotation = { runtime = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]] }
"#;

#[test]
fn every_key_is_written_as_it_was() {
    let description = parse(EVERY_KEY);
    assert!(description.faults.is_empty(), "{:#?}", description.faults);
    assert_eq!(survives_writing(&description), EVERY_KEY);
}

#[test]
fn models_survive() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut n_models = 0;
    for folder in ["../models", "tests/models", "../tests/reference"] {
        for entry in fs::read_dir(root.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path
                .extension()
                .is_some_and(|extension| extension == "toml")
            {
                survives_writing(&parse(&fs::read_to_string(&path).unwrap()));
                n_models += 1;
            }
        }
    }
    assert!(n_models >= 6);
}

#[test]
fn random_descriptions_survive() {
    for seed in 0..500 {
        survives_writing(&random_description(&mut Random::new(seed)));
    }
}

#[test]
fn what_is_absent_or_has_its_default_is_left_out() {
    let text = system("[0]", &[("a", "[]")]);
    let longer = format!("order = \"body\"\n{text}locked = {{}}\nlimits = {{}}\ndamping = {{}}\n");
    assert_eq!(toml::write(&parse(&longer)).unwrap(), text);
}

#[test]
fn coordinates_are_written_in_their_order() {
    let text = system("[0]", &[("a", "[\"s2\", \"theta1\"]")]);
    let text = |damping: &str| format!("{text}damping = {damping}\n");
    assert_eq!(
        toml::write(&parse(&text("{ s2 = 2, theta1 = 1 }"))).unwrap(),
        text("{ theta1 = 1.0, s2 = 2.0 }")
    );
}

#[test]
fn strings_keep_every_character() {
    let mut description = parse(&system("[0]", &[("a", "[]")]));
    let name = "q\"b\\t\tn\nr\r\0\u{7f}\u{85}é\u{202e}\u{2028}🤖'";
    description.name = Some(at(name.to_owned()));
    let text = survives_writing(&description);
    let first = text.lines().next().unwrap();
    assert_eq!(
        first,
        r#"name = "q\"b\\t\tn\nr\r\u0000\u007F\u0085é\u202E\u2028🤖'""#
    );
}

#[test]
fn numbers_keep_every_bit() {
    let numbers = [
        5e-324,
        f64::MIN_POSITIVE,
        f64::MAX,
        0.1 + 0.2,
        1e16,
        1e-7,
        -123_456_789.125,
    ];
    for number in numbers {
        let mut description = parse(&system("[0]", &[("a", "[]")]));
        description.bodies[0].mass = Some(at(Scalar::Baked(number)));
        let read = parse(&survives_writing(&description));
        let mass = read.bodies[0].mass.unwrap().value.nominal();
        assert_eq!(mass.to_bits(), number.to_bits());
    }
}

#[test]
fn description_with_faults_is_not_written() {
    let faults = toml::write(&parse("name = \"a\"")).unwrap_err().to_string();
    assert!(
        faults.contains("the file has no `lower_bodies`"),
        "{faults}"
    );
    let mut description = parse(&system("[0]", &[("a", "[]")]));
    description.faults.push(Diagnostic::warning("odd"));
    assert!(toml::write(&description).is_ok());
}

#[test]
fn description_that_lacks_something_is_not_written() {
    let mut description = parse(&system("[0]", &[("a", "[]")]));
    description.bodies[0].mass = None;
    description.bodies[0].joint.friction = PerCoordinate::Same(at(f64::NAN));
    let faults = toml::write(&description).unwrap_err();
    insta::assert_snapshot!(faults, @"
    error: `mass` of body 1 is missing or not finite, so the description cannot be written
    --> model.toml

    error: `friction` of body 1 is missing or not finite, so the description cannot be written
    --> model.toml
    ");
}

const PLACE: Span = Span { start: 0, end: 0 };

fn at<T>(value: T) -> Spanned<T> {
    Spanned::new(value, PLACE)
}

/// Often nothing.
fn perhaps<T>(random: &mut Random, value: impl FnOnce(&mut Random) -> T) -> Optional<T> {
    (random.below(3) == 0).then(|| at(value(random)))
}

fn number(random: &mut Random) -> f64 {
    let digits = random.below(2_000_001) as f64 - 1_000_000.0;
    [
        0.0,
        1.0,
        digits,
        digits / 7.0,
        digits * 1e-20,
        digits * 1e30,
    ][random.below(6)]
}

fn scalar(random: &mut Random) -> Scalar {
    let number = number(random);
    [Scalar::Baked(number), Scalar::Runtime(number)][random.below(2)]
}

fn vector(random: &mut Random) -> [Given<Scalar>; 3] {
    [(); 3].map(|()| Some(at(scalar(random))))
}

fn string(random: &mut Random) -> String {
    let pieces = [
        "a", "\"", "\\", "\n", " ", "é", "\u{1}", "'", "=", "#", "left_arm",
    ];
    let n = 1 + random.below(4);
    (0..n).map(|_| pieces[random.below(pieces.len())]).collect()
}

/// The matrix of a quaternion of small whole numbers.
fn rotation(random: &mut Random) -> Rotation {
    let [w, x, y, z] = [(); 4].map(|()| random.below(7) as f64 - 3.0);
    let norm = w * w + x * x + y * y + z * z;
    if norm == 0.0 {
        return [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    }
    let rows = [
        [
            w * w + x * x - y * y - z * z,
            2.0 * (x * y + w * z),
            2.0 * (x * z - w * y),
        ],
        [
            2.0 * (x * y - w * z),
            w * w - x * x + y * y - z * z,
            2.0 * (y * z + w * x),
        ],
        [
            2.0 * (x * z + w * y),
            2.0 * (y * z - w * x),
            w * w - x * x - y * y + z * z,
        ],
    ];
    // Zero has no sign in a description.
    rows.map(|row| row.map(|entry| entry / norm + 0.0))
}

/// Some of the coordinates, in their order.
fn axes(random: &mut Random) -> Vec<Spanned<CoordinateName>> {
    let some = CoordinateName::ALL
        .into_iter()
        .filter(|_| random.below(2) == 0);
    some.map(at).collect()
}

fn per_coordinate<T>(
    random: &mut Random,
    mut one: impl FnMut(&mut Random) -> T,
) -> PerCoordinate<T> {
    let mut axes = axes(random);
    axes.push(at(CoordinateName::S3));
    axes.dedup();
    match random.below(4) {
        0 => PerCoordinate::Same(at(one(random))),
        1 => {
            let each = axes.into_iter();
            let each = each.map(|axis| (axis, at(one(random))));
            PerCoordinate::Each(each.collect())
        }
        _ => PerCoordinate::Absent,
    }
}

fn limits(random: &mut Random) -> Limits {
    Limits {
        lower: perhaps(random, number),
        upper: perhaps(random, number),
        velocity: perhaps(random, number),
        effort: Some(at(number(random))),
    }
}

fn joint(random: &mut Random) -> WrittenJoint {
    let kind = match random.below(JointKind::NAMED.len() + 1) {
        0 => {
            let mut axes = axes(random);
            random.shuffle(&mut axes);
            JointKind::List(axes)
        }
        n => JointKind::NAMED[n - 1].1.clone(),
    };
    let axis = kind
        .has_axis()
        .then(|| at([number(random), number(random), 0.5]));
    let locked = axes(random).into_iter();
    WrittenJoint {
        kind: Some(at(kind)),
        name: perhaps(random, string),
        axis,
        attachment: vector(random),
        attachment_rotation: perhaps(random, rotation),
        body_attachment: perhaps(random, vector).map(|attachment| attachment.value),
        body_rotation: perhaps(random, rotation),
        locked: locked
            .map(|axis| (axis, Some(at(number(random)))))
            .collect(),
        chart: perhaps(random, |random| Chart::NAMED[random.below(2)].1),
        speeds: perhaps(random, |random| Speeds::NAMED[random.below(2)].1),
        stiffness: per_coordinate(random, scalar),
        rest: per_coordinate(random, scalar),
        damping: per_coordinate(random, scalar),
        armature: per_coordinate(random, scalar),
        friction: per_coordinate(random, number),
        limits: per_coordinate(random, limits),
        mimic: perhaps(random, |random| Mimic {
            joint: at(string(random)),
            multiplier: number(random),
            offset: number(random),
        }),
    }
}

fn random_description(random: &mut Random) -> Description {
    let n_bodies = 1 + random.below(3);
    let body = |random: &mut Random| WrittenBody {
        span: PLACE,
        name: Some(at(string(random))),
        mass: Some(at(scalar(random))),
        mass_center: vector(random),
        inertia: [(); 6].map(|()| Some(at(scalar(random)))),
        inertia_rotation: perhaps(random, rotation),
        gravity_compensation: perhaps(random, scalar),
        joint: joint(random),
    };
    let frame = |random: &mut Random| WrittenFrame {
        span: PLACE,
        name: Some(at(string(random))),
        body: match perhaps(random, string) {
            Some(body) => Carrier::Body(Some(body)),
            None => Carrier::Inertial,
        },
        position: vector(random),
        rotation: Some(at(match random.below(3) {
            0 => FrameRotation::Baked(kane_codegen::geometry::IDENTITY),
            1 => FrameRotation::Baked(rotation(random)),
            _ => FrameRotation::Runtime(rotation(random)),
        })),
    };
    let lower_bodies = (0..n_bodies).map(|_| Some(at([-1, 0, 1, 2, 3][random.below(5)])));
    Description {
        source: Source::new("random", ""),
        lower_bodies: Some(at(lower_bodies.collect())),
        name: Some(at(string(random))),
        gravity: vector(random),
        order: Some(at([Order::Body, Order::Notes][random.below(2)])),
        bodies: (0..n_bodies).map(|_| body(random)).collect(),
        frames: (0..random.below(3)).map(|_| frame(random)).collect(),
        faults: Vec::new(),
    }
}
