//! Reading descriptions: every place is right, no order of keys matters, and no file stops the program.

use kane_codegen::tree::canonical;

use kane_test_support::{
    models::{build, system},
    random::Random,
};

/// The place that the first fault of a file is shown at.
fn place(text: &str) -> String {
    let shown = build(text).expect_err("the text has a fault").to_string();
    let line = shown
        .lines()
        .find_map(|line| line.trim_start().strip_prefix("--> "))
        .expect("every fault shows its file");
    line.to_owned()
}

#[test]
fn words_of_other_formats_are_known() {
    let arm = system("[0]", &[("a", "[\"theta1\"]")]);
    for (ours, theirs, expected) in [
        (
            "joint = [\"theta1\"]",
            "joint = \"hinge\"",
            "did you mean `revolute`?",
        ),
        (
            "joint = [\"theta1\"]",
            "joint = \"ball\"",
            "did you mean `spherical`?",
        ),
        (
            "joint = [\"theta1\"]",
            "joint = \"theta1\"",
            "a motion stands in a list: `[\"theta1\"]`",
        ),
        ("lower_bodies", "parents", "did you mean `lower_bodies`?"),
        ("mass_center", "com", "did you mean `mass_center`?"),
        ("joint = ", "joint_type = ", "did you mean `joint`?"),
        ("xx = ", "ixx = ", "did you mean `xx`?"),
        (
            "joint = ",
            "parent = \"b\"\njoint = ",
            "`lower_bodies`, at the top of a model, says which body carries which",
        ),
        (
            "joint = ",
            "limits = { max = 1.0 }\njoint = ",
            "did you mean `upper`?",
        ),
        (
            "joint = ",
            "limits = [-1.0, 1.0]\njoint = ",
            "write for example `limits = { lower = -1.0, upper = 1.0 }`",
        ),
    ] {
        let faults = build(&arm.replacen(ours, theirs, 1))
            .unwrap_err()
            .to_string();
        let helps: Vec<&str> = faults.split("= help: ").skip(1).collect();
        assert!(
            matches!(helps[..], [help] if help.trim_end() == expected),
            "{faults}"
        );
    }
}

#[test]
fn list_of_systems_is_no_model() {
    insta::assert_snapshot!(build("[[system]]\nmodel = \"arm.toml\"\n").unwrap_err());
}

/// A hinge with these limits.
fn limited(limits: &str) -> String {
    system("[0]", &[("a", "\"revolute\"\naxis = [0, 1, 0]")])
        + &format!("limits = {{ {limits} }}\n")
}

#[test]
fn infinite_limits_are_none() {
    let of = |text: &str| build(text).unwrap().tree.bodies[0].joint.mechanics;
    let limits = "lower = -1.0, upper = inf, velocity = +inf, effort = 3.0";
    let without = "lower = -1.0, effort = 3.0";
    assert_eq!(of(&limited(limits)), of(&limited(without)));
    let none = limited("lower = -inf, upper = inf, velocity = inf, effort = inf");
    let without = none.lines().filter(|line| !line.starts_with("limits"));
    let without = of(&without.collect::<Vec<_>>().join("\n"));
    assert_eq!(of(&none), without);
    assert_eq!(of(&none.replace("revolute", "continuous")), without);
    for limit in [
        "lower = inf",
        "upper = -inf",
        "effort = -inf",
        "velocity = nan",
    ] {
        assert!(build(&limited(limit)).is_err(), "{limit}");
    }
}

#[test]
fn columns_count_characters_not_bytes() {
    let text = system("[0]", &[("Gelenkkörper", "[\"theta1\"]")]);
    let text = text.replace(
        "name = \"Gelenkkörper\"\nmass = 2.0",
        "\"name\" = \"Gelenkkörper\"",
    );
    assert_eq!(place(&text), "model.toml:4:1");
    let text = system("[0]", &[("a", "[\"theta1\"]")]).replace("theta1", "θ1\", \"thetå1");
    insta::assert_snapshot!(build(&text).unwrap_err(), @r#"
    error: `joint` of body `a` names `θ1`, which is no coordinate
      --> model.toml:10:10
       |
    10 | joint = ["θ1", "thetå1"]
       |          ^^^^ unknown coordinate
       |
       = help: the coordinates are `theta1`, `theta2`, `theta3`, `s1`, `s2`, `s3`

    error: `joint` of body `a` names `thetå1`, which is no coordinate
      --> model.toml:10:16
       |
    10 | joint = ["θ1", "thetå1"]
       |                ^^^^^^^^ unknown coordinate
       |
       = help: did you mean `theta1`? The coordinates are `theta1`, `theta2`, `theta3`, `s1`, `s2`, `s3`
    "#);
}

#[test]
fn line_ends_of_windows_leave_the_places_where_they_are() {
    let text = system("[0]", &[("ä", "[\"theta1\", \"theta9\"]")]);
    assert_eq!(place(&text), "model.toml:10:20");
    assert_eq!(place(&text.replace('\n', "\r\n")), "model.toml:10:20");
}

#[test]
fn byte_order_mark_is_no_character() {
    assert_eq!(place("\u{feff}nam = \"a\""), "model.toml");
    let text = format!("\u{feff}{}", system("[0]", &[("a", "[\"theta1\"]")]));
    assert!(build(&text).is_ok());
    assert_eq!(
        place(&text.replace("name = \"system\"", "name = 3")),
        "model.toml:1:8"
    );
}

/// One of these.
fn one<'a>(random: &mut Random, ways: &[&'a str]) -> &'a str {
    ways[random.below(ways.len())]
}

/// A vector, of each entry one spelling.
fn vector(random: &mut Random, entries: [[&str; 3]; 3]) -> String {
    let entries = entries.map(|ways| one(random, &ways));
    let between = one(random, &[", ", ",", "\n  , ", ", # why not\n"]);
    format!(
        "[{}{}]",
        entries.join(between),
        one(random, &["", ",", "\n"])
    )
}

/// A body's keys in any order, each in any spelling.
fn shuffled_body(random: &mut Random, name: &str, mass: &[&str]) -> String {
    let inertia = [
        ["xx", "0.1"],
        ["yy", "1e-1"],
        ["zz", "0.1"],
        ["xy", "0"],
        ["xz", "0.0"],
        ["yz", "-0"],
    ];
    let mut inertia = inertia.map(|[key, value]| format!("{key} = {value}"));
    random.shuffle(&mut inertia);
    let center = [
        ["1", "1.0", "1e0"],
        ["2", "2.0", "0.2e1"],
        ["3", "3.0", "0x3"],
    ];
    let attachment = [
        ["1", "1.0", "1_0e-1"],
        ["2", "2.0", "0b10"],
        ["3", "3.0", "0o3"],
    ];
    let equals = one(random, &["=", " =", "= ", " = ", "\t=\t"]);
    let mut keys = vec![
        format!("name{equals}{name}"),
        format!("mass{equals}{}", one(random, mass)),
        format!("mass_center{equals}{}", vector(random, center)),
        format!("attachment{equals}{}", vector(random, attachment)),
        format!(
            "joint{equals}{}",
            one(random, &["[\"theta1\", \"s2\"]", "['s2', \"theta1\"]"])
        ),
        format!(
            "locked{equals}{}",
            one(
                random,
                &[
                    "{ theta2 = 0.5, s1 = 1 }",
                    "{ s1 = 1.0, theta2 = 5e-1, s3 = 0 }"
                ]
            )
        ),
    ];
    let mut table = String::new();
    if random.below(2) == 0 {
        table = format!("[body.inertia]\n{}\n", inertia.join("\n"));
    } else {
        keys.push(format!("inertia{equals}{{ {} }}", inertia.join(", ")));
    }
    random.shuffle(&mut keys);
    let lines = keys.join(one(random, &["\n", "\n\n", "   # said\n"]));
    format!("[[body]]\n{lines}\n{table}")
}

/// One description, its keys in any order, each in any spelling.
fn shuffled(random: &mut Random) -> String {
    let gravity = [
        ["0", "0.0", "-0.0"],
        ["0", "+0", "0e3"],
        ["-9.81", "-981e-2", "-9.810"],
    ];
    let mut keys = vec![
        format!("name={}", one(random, &["'sys'", "\"s\\u0079s\""])),
        format!("gravity = {}", vector(random, gravity)),
        format!("lower_bodies = {}", one(random, &["[2, 0x0]", "[\n2,0]"])),
        "\"order\" = \"notes\"".to_owned(),
    ];
    random.shuffle(&mut keys);
    let tip = shuffled_body(random, "\"tip\"", &["{ runtime = 2 }", "{runtime=2.0}"]);
    let base = shuffled_body(random, "'''base'''", &["2", "2.0"]);
    let text = format!("{}\n{tip}{base}", keys.join("\n"));
    if random.below(2) == 0 {
        text.replace('\n', "\r\n")
    } else {
        text
    }
}

#[test]
fn order_of_keys_and_formatting_leave_the_canonical_text_as_it_is() {
    let text = |seed: u64| {
        let text = shuffled(&mut Random::new(seed));
        canonical(
            &build(&text)
                .unwrap_or_else(|faults| panic!("seed {seed}: {faults}\n{text}"))
                .tree,
        )
    };
    let first = text(0);
    for seed in 1..200 {
        assert_eq!(text(seed), first, "seed {seed}");
    }
}

#[test]
fn canonical_text_tells_values_names_and_binding_times_apart() {
    let text = system("[0, 1]", &[("a", "[\"theta1\"]"), ("b", "[\"theta2\"]")]);
    let first = canonical(&build(&text).unwrap().tree);
    let changes = [
        ("mass = 2.0", "mass = 2.0000000000000004"),
        ("mass = 2.0", "mass = { runtime = 2.0 }"),
        ("\"system\"", "\"System\""),
        ("\"a\"", "\"A\""),
        ("[0, 1]", "[0, 0]"),
        ("theta2", "theta3"),
        ("lower_bodies", "order = \"notes\"\nlower_bodies"),
        ("gravity = [0, 0, 0]", "gravity = [0, 0, 1e-300]"),
        ("yz = 0.0", "yz = 0.001"),
        ("0.1, 0.3]", "0.1, 0.25]"),
    ];
    for (from, to) in changes {
        assert_ne!(
            canonical(&build(&text.replacen(from, to, 1)).unwrap().tree),
            first,
            "{from} to {to}"
        );
    }
}

/// Reads, builds and shows whatever there is to show.
fn does_not_panic(text: &str) {
    match build(text) {
        Ok(checked) => {
            let _ = (canonical(&checked.tree), checked.warnings.to_string());
        }
        Err(faults) => assert!(
            faults.has_error() && !faults.to_string().is_empty(),
            "{text}"
        ),
    }
}

#[test]
fn hostile_files_are_refused() {
    let body = "name='a'\nlower_bodies=[0]\n[[body]]\nname='a'\nmass=";
    let hostile = [
        String::new(),
        "\u{feff}".to_owned(),
        "\0".to_owned(),
        "name = \"\0\"".to_owned(),
        "\r".to_owned(),
        "a = 1e400\n".to_owned(),
        "=".repeat(5000),
        format!("a = {}", "[".repeat(100_000)),
        format!("a = {}", "{a=".repeat(100_000)),
        format!("body = {}{}", "[".repeat(70), "]".repeat(70)),
        format!("{}a = 1", "a.".repeat(100_000)),
        format!("[{}a]", "a.".repeat(70)),
        format!("{}body]]", "[[body]]\n".repeat(20_000)),
        format!(
            "lower_bodies = [{}]\n{}",
            "1,".repeat(20_000),
            "[[body]]\n".repeat(20_000)
        ),
        format!("{body}{}", "9".repeat(10_000)),
        format!("{body}1e-{}", "9".repeat(10_000)),
        format!("{body}0x{}", "f".repeat(10_000)),
        format!("{}= 1", "é".repeat(10_000)),
        format!("\"{}\" = 1", "x".repeat(10_000)),
        "lower_bodies = [9223372036854775807, -9223372036854775808]\n[[body]]\n[[body]]".to_owned(),
    ];
    for text in &hostile {
        assert!(build(text).is_err());
        does_not_panic(text);
    }
}

#[test]
fn extreme_numbers_do_not_panic() {
    let text = system(
        "[0, 1]",
        &[("a", "\"free\""), ("b", "[\"theta1\", \"s1\"]")],
    );
    let numbers = [
        "1e308",
        "-1e308",
        "5e-324",
        "nan",
        "-nan",
        "inf",
        "1e-200",
        "9007199254740993",
        "-0.0",
        "1e400",
        "true",
        "1979-05-27",
    ];
    for from in ["2.0", "0.01", "0.1", "-0.5", "0.02", "0.3", "[0, 1]"] {
        for to in numbers {
            does_not_panic(&text.replace(from, to));
            does_not_panic(&text.replacen(from, to, 1));
            does_not_panic(&(text.clone() + &format!("locked = {{ theta2 = {to}, s2 = {to} }}")));
        }
    }
}

#[test]
fn truncated_files_do_not_panic() {
    let text = shuffled(&mut Random::new(5));
    for end in (0..text.len()).filter(|end| text.is_char_boundary(*end)) {
        does_not_panic(&text[..end]);
    }
}

#[test]
fn mutated_files_do_not_panic() {
    let mut random = Random::new(11);
    let pieces = [
        "\"", "'", "[", "]", "{", "}", "=", "\n", "#", ".", ",", "é", "\0", "\r", "nan",
        "[[body]]", "9", "-", "e",
    ];
    for _ in 0..2000 {
        let mut text = shuffled(&mut Random::new(random.below(20) as u64));
        for _ in 0..=random.below(4) {
            let mut ends = [random.below(text.len()), random.below(text.len())].map(|at| {
                (0..=at)
                    .rev()
                    .find(|at| text.is_char_boundary(*at))
                    .unwrap()
            });
            ends.sort_unstable();
            // Mostly short cuts, now and then a long one.
            let end = if random.below(4) == 0 {
                ends[1]
            } else {
                (ends[0] + 3).min(text.len())
            };
            let end = (ends[0]..=end)
                .rev()
                .find(|at| text.is_char_boundary(*at))
                .unwrap();
            text.replace_range(ends[0]..end, pieces[random.below(pieces.len())]);
            if text.is_empty() {
                break;
            }
        }
        does_not_panic(&text);
    }
}
