//! The emitted text of the smallest systems, whole: what a user reads and reviews.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::{collections::BTreeSet, fs};

use kane_codegen::{
    config::Functions,
    description::{Base, Chart, Reading, no_includes},
    diagnostic::Source,
    error::Error,
    generate::{self, Generated, OUTPUT_FORMAT},
    options::Options,
    program::Operations,
    report,
    tree::Changes,
};
use kane_test_support::models::system;

/// The module of a model that stands alone.
pub(crate) fn generate(
    source: &Source,
    shown: &str,
    options: &Options,
) -> Result<Generated, Error> {
    generate::generate(source, shown, options, &no_includes)
}

fn module(name: &str, functions: Functions) -> String {
    let path = format!("{}/tests/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let source = Source::new(format!("{name}.toml"), fs::read_to_string(path).unwrap());
    let options = Options {
        functions,
        ..Options::default()
    };
    generate(&source, &format!("models/{name}.toml"), &options)
        .unwrap()
        .source
}

pub(crate) fn named(names: &[&str]) -> Functions {
    Functions::Named(names.iter().map(ToString::to_string).collect())
}

#[test]
fn a_pendulum_with_runtime_parameters() {
    insta::assert_snapshot!(module("pendulum", Functions::default()));
}

#[test]
fn a_cart_pole() {
    insta::assert_snapshot!(module(
        "cart_pole",
        named(&["mass_matrix", "bias", "forward_dynamics", "singularity"])
    ));
}

#[test]
fn a_pattern_of_partitions() {
    insta::assert_snapshot!(module("cart_pole", named(&["partial_velocity"])));
}

#[test]
fn only_what_is_asked_for_is_generated() {
    let text = module("cart_pole", named(&["bias"]));
    let functions: Vec<&str> = text
        .lines()
        .filter_map(|line| line.strip_prefix("pub fn "))
        .collect();
    let names: Vec<&str> = functions
        .iter()
        .map(|line| line.split('<').next().unwrap())
        .collect();
    // The runtime's trait `System` needs `q_dot`.
    assert_eq!(names, ["q_dot", "bias"]);
}

#[test]
fn a_function_s_text_does_not_depend_on_what_else_is_asked_for() {
    let text_of = |module: &str| {
        let start = module.find("pub fn bias<").unwrap();
        module[start..start + module[start..].find("\n}\n").unwrap()].to_owned()
    };
    let alone = module("cart_pole", named(&["bias"]));
    let among_all = module("cart_pole", Functions::All(Vec::new()));
    assert_eq!(text_of(&alone), text_of(&among_all));
}

#[test]
fn derivatives_that_generic_code_can_hold_have_their_trait() {
    let traits = |requests: &str| -> Vec<String> {
        let requests: Vec<&str> = requests.split("; ").collect();
        let text = module("cart_pole", named(&requests));
        let lines = text.lines();
        let begins = "impl<R: kane::Real> kane::functions::";
        let traits = lines.filter_map(|line| line.trim_start().strip_prefix(begins));
        let names = traits.map(|line| line.split('<').next().unwrap().to_owned());
        names.collect()
    };
    assert_eq!(
        traits("d( forward_dynamics )/d(q, u, tau)"),
        ["ForwardDynamicsDerivatives"]
    );
    // Joined, it is not the derivatives alone; in another order or by other variables it is a function of the module.
    assert_eq!(
        traits("forward_dynamics+d(forward_dynamics)/d(q, u, tau)"),
        ["ForwardDynamicsAndDerivatives"]
    );
    assert!(traits("d(forward_dynamics)/d(u, q, tau)").is_empty());
    assert!(traits("vjp(inverse_dynamics;q)").is_empty());
    // Whatever it is called, and once.
    assert_eq!(
        traits("step = d(forward_dynamics)/d(q, u, tau); other = d(forward_dynamics)/d(q, u, tau)"),
        ["ForwardDynamicsDerivatives"]
    );
    assert_eq!(traits("other = bias; bias"), ["Bias"]);
}

#[test]
fn every_number_reads_back_bit_for_bit() {
    for number in [
        0.1,
        1.0 / 3.0,
        1e-300,
        5e-324,
        1.797_693_134_862_315_7e308,
        123_456_789.0,
        1e21,
    ] {
        let text = fs::read_to_string(format!(
            "{}/tests/models/cart_pole.toml",
            env!("CARGO_MANIFEST_DIR")
        ))
        .unwrap();
        let text = text.replace("mass = 2.0", &format!("mass = {number:e}"));
        let options = Options {
            functions: named(&["mass_matrix"]),
            ..Options::default()
        };
        let source = Source::new("cart_pole.toml", text);
        // The pole's mass is added to the cart's.
        let expected = format!("{:?}", number + 0.5);
        let generated = generate(&source, "cart_pole.toml", &options)
            .unwrap()
            .source;
        assert!(
            generated.contains(&format!("R::from_f64({expected})")),
            "{expected} is not in\n{generated}"
        );
    }
}

/// A body with this mass on a hinge, its mass centre this far from it.
fn hinged(mass: f64, distance: f64) -> Result<String, String> {
    let text = format!(
        "name = \"h\"\nlower_bodies = [0]\n[[body]]\nname = \"a\"\nmass = {mass:e}\nmass_center = [{distance:e}, 0, 0]\n\
         inertia = {{ xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0 }}\nattachment = [0.0, 0.0, 0.0]\njoint = [\"theta3\"]\n"
    );
    let generated = generate(&Source::new("h.toml", text), "h.toml", &Options::default());
    generated
        .map(|generated| generated.source)
        .map_err(|error| error.to_string())
}

#[test]
fn numbers_that_f64_does_not_hold_are_an_error() {
    assert!(hinged(1.0, 1.0).is_ok());
    for (mass, distance) in [(1e300, 1e10), (5e-324, 1.0), (1e-200, 1e-70)] {
        let error = hinged(mass, distance).unwrap_err();
        assert!(
            error.contains("too large or too small"),
            "{mass:e} kg at {distance:e} m: {error}"
        );
    }
}

#[test]
fn masses_that_add_up_to_more_than_f64_holds_are_an_error() {
    let body = |name: &str, joint: &str| {
        format!(
            "[[body]]\nname = \"{name}\"\nmass = 1.5e308\nmass_center = [0, 0, 0]\n\
             inertia = {{ xx = 1.0, yy = 1.0, zz = 1.0, xy = 0.0, xz = 0.0, yz = 0.0 }}\nattachment = [0, 0, 0]\njoint = {joint}\n"
        )
    };
    let text = format!(
        "name = \"h\"\nlower_bodies = [0, 1]\n{}{}",
        body("a", "[\"s1\"]"),
        body("b", "[]")
    );
    for function in ["mass_matrix", "forward_dynamics"] {
        let options = Options {
            functions: named(&[function]),
            ..Options::default()
        };
        let error = generate(&Source::new("h.toml", &*text), "h.toml", &options)
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("too large or too small"),
            "{function}: {error}"
        );
    }
}

#[test]
fn costs_as_data_are_those_of_the_documentation() {
    let text = module(
        "cart_pole",
        named(&["mass_matrix+bias(sin_cos)", "mass_matrix_packed"]),
    );
    let (_, table) = text.split_once("pub const OPERATIONS: ").unwrap();
    let (_, table) = table.split_once("] = [\n").unwrap();
    let (table, _) = table.split_once("];").unwrap();
    let module = report::ReadModule::read(&text).unwrap();
    let stated = module.counted().iter();
    let stated: Vec<String> = stated
        .map(|(name, counted)| {
            let Operations {
                mul,
                add,
                div,
                trig,
            } = counted.operations;
            format!("kane::Cost::new(\"{name}\", [{mul}, {add}, {div}, {trig}]),")
        })
        .collect();
    let table: Vec<&str> = table.lines().map(str::trim).collect();
    assert_eq!(table, stated);
    assert_eq!(table.len(), 5);
    assert!(text.contains(&format!(
        "pub const OPERATIONS: [kane::Cost; {}]",
        table.len()
    )));
}

#[test]
fn banner_shows_every_change_and_its_hash_covers_them() {
    let path = format!("{}/tests/models/cart_pole.toml", env!("CARGO_MANIFEST_DIR"));
    let source = Source::new("cart_pole.toml", fs::read_to_string(path).unwrap());
    let banner = |changes: Changes| {
        let options = Options {
            functions: named(&["bias"]),
            changes,
            ..Options::default()
        };
        let generated = generate(&source, "cart_pole.toml", &options).unwrap();
        let line = generated.source.lines().nth(1).unwrap().to_owned();
        let (hash, options) = line
            .split_once(&format!(
                ", format {OUTPUT_FORMAT}; functions: bias; formulation: cheapest; "
            ))
            .unwrap();
        (hash.to_owned(), options.to_owned())
    };
    let default = Changes::default;
    let banners = [
        (default(), "snap: 1e-9."),
        (
            Changes {
                snap: 1e-5,
                ..default()
            },
            "snap: 1e-5.",
        ),
        (
            Changes {
                lock: vec![("pole".to_owned(), 0.5)],
                ..default()
            },
            "snap: 1e-9; lock: \"pole\" = 0.5.",
        ),
        (
            Changes {
                remove: vec!["pole".to_owned()],
                ..default()
            },
            "snap: 1e-9; remove: \"pole\".",
        ),
    ];
    let mut hashes = BTreeSet::new();
    for (changes, expected) in banners {
        let (hash, options) = banner(changes);
        assert_eq!(options, expected);
        assert!(hashes.insert(hash), "{expected}");
    }
}

#[test]
fn tolerances_and_values_that_are_none_are_an_error() {
    let error = |changes: Changes| {
        let options = Options {
            changes,
            ..Options::default()
        };
        let error = generate(&Source::new("a.toml", ""), "a.toml", &options).unwrap_err();
        error.to_string()
    };
    for snap in [f64::NAN, -1e-9, 0.01] {
        let changes = Changes {
            snap,
            ..Changes::default()
        };
        assert_eq!(
            error(changes),
            format!("the snap tolerance is {snap:?}; expected at least 0 and less than 0.01")
        );
    }
    let lock = vec![("elbow".to_owned(), f64::INFINITY)];
    let changes = Changes {
        lock,
        ..Changes::default()
    };
    assert_eq!(
        error(changes),
        "`elbow` is locked at inf; expected a finite number"
    );
    let lock = vec![("elbow".to_owned(), 0.5), ("elbow".to_owned(), 0.7)];
    let changes = Changes {
        lock,
        ..Changes::default()
    };
    assert_eq!(error(changes), "`elbow` is locked twice");
}

#[test]
fn model_that_says_it_itself_is_not_told_its_base_or_chart() {
    let options = Options {
        reading: Reading {
            base: Some(Base::Free),
            chart: Some(Chart::Angles),
            ..Reading::default()
        },
        ..Options::default()
    };
    let text = fs::read_to_string(format!(
        "{}/tests/models/pendulum.toml",
        env!("CARGO_MANIFEST_DIR")
    ));
    let source = Source::new("pendulum.toml", text.unwrap());
    let error = generate(&source, "pendulum.toml", &options).unwrap_err();
    insta::assert_snapshot!(error, @r#"
    error: the base can be chosen for a URDF alone: this model says itself by which joints its bodies hang from the inertial frame; one that floats has `joint = "free"` and `chart = "quaternion"`
    --> pendulum.toml

    error: the chart can be chosen for a URDF or MJCF alone: each joint of this model says it itself, with the key `chart`
    --> pendulum.toml
    "#);
}

#[test]
fn frames_at_numbers_that_f64_does_not_hold_are_refused() {
    let body = |name: &str, joint: &str, at: &str| {
        format!(
            "[[body]]\nname = \"{name}\"\nmass = 1.0\nmass_center = [0.0, 0.0, 0.1]\nattachment = [{at}, 0.0, 0.0]\n\
             inertia = {{ xx = 1.0, yy = 1.0, zz = 1.0, xy = 0.0, xz = 0.0, yz = 0.0 }}\njoint = {joint}\n"
        )
    };
    let text = [
        "name = \"s\"\nlower_bodies = [0, 1, 2]\n".to_owned(),
        body("a", "[\"theta1\"]", "0.0"),
        body("b", "\"fixed\"", "1.5e308"),
        body("c", "\"fixed\"", "1.5e308"),
    ];
    let options = Options {
        functions: Functions::Named(vec!["q_dot".to_owned()]),
        ..Options::default()
    };
    let source = Source::new("far.toml", text.concat());
    let error = generate(&source, "far.toml", &options).unwrap_err();
    assert!(matches!(error, Error::Unrepresentable { .. }), "{error}");
}

/// A chain of hinges about z, each at its own place.
pub(crate) fn hinges(n_bodies: usize) -> String {
    let lower: Vec<String> = (0..n_bodies).map(|body| body.to_string()).collect();
    let head = format!("name = \"chain\"\nlower_bodies = [{}]\n", lower.join(", "));
    let bodies = (1..=n_bodies).map(|body| {
        format!(
            "[[body]]\nname = \"b{body}\"\nmass = 1.0\nmass_center = [0.{body}, 0.0, 0.1]\nattachment = [0.2, 0.{body}, 0.0]\n\
             inertia = {{ xx = 1.0, yy = 1.0, zz = 1.0, xy = 0.0, xz = 0.0, yz = 0.0 }}\njoint = [\"theta3\"]\n"
        )
    });
    head + &bodies.collect::<String>()
}

#[test]
fn friction_of_joints_that_follow_is_felt_by_the_speed_that_moves_them() {
    let bodies = hinges(3);
    let [head, a, b, c] = bodies.split("[[body]]").collect::<Vec<_>>()[..] else {
        panic!("three bodies")
    };
    let text = format!(
        "{head}[[body]]{a}friction = 0.5\n[[body]]{b}friction = 0.125\nmimic = {{ joint = \"b1\", multiplier = -2.0 }}\n\
         [[body]]{c}friction = 0.25\n"
    );
    let options = Options {
        functions: named(&["q_dot"]),
        ..Options::default()
    };
    let source = Source::new("gripper.toml", text);
    let text = generate(&source, "gripper.toml", &options).unwrap().source;
    assert!(text.contains("FRICTION: [f64; NU] = [0.75, 0.25];"));
}

#[test]
fn unknown_function_is_told_with_what_was_meant() {
    let options = Options {
        functions: named(&["jacobain(b1)"]),
        ..Options::default()
    };
    let source = Source::new("chain.toml", hinges(1));
    let error = generate(&source, "chain.toml", &options).unwrap_err();
    let told = error.to_string();
    assert_eq!(told, "`jacobain` is no function; did you mean `jacobian`?");
}

#[test]
fn computed_neighbours_stay_apart_unless_they_are_products_with_the_same_factors() {
    let options = Options {
        functions: named(&["forward_dynamics", "d(forward_dynamics)/d(u, tau)"]),
        ..Options::default()
    };
    let source = Source::new("chain.toml", hinges(2));
    let text = generate(&source, "chain.toml", &options).unwrap().source;
    assert!(text.contains("kane::store(&mut u_dot[1], "));
    assert!(text.contains("    du_dot_dtau[1][1] = "), "{text}");
    assert!(!text.contains("kane::store(&mut du_dot_dtau"));
}

#[test]
fn few_zeros_side_by_side_are_joined() {
    let options = Options {
        functions: named(&["gravity_forces", "mass_matrix"]),
        ..Options::default()
    };
    // Without gravity all its forces are zero.
    let source = Source::new("chain.toml", hinges(10));
    let text = generate(&source, "chain.toml", &options).unwrap().source;
    let (_, function) = text.split_once("pub fn gravity_forces<").unwrap();
    let (function, rest) = function.split_once("\n}\n").unwrap();
    let (_, body) = function.split_once(" {\n").unwrap();
    let joined: Vec<usize> = body
        .split("kane::store(")
        .map(|run| run.matches(" = R::from_f64(0.0);").count())
        .collect();
    assert_eq!(joined, [3, 3, 2]);
    assert!(
        !rest.contains("R::from_f64(0.0)"),
        "a full matrix has no zeros"
    );
}

#[test]
fn no_two_frames_become_one_type() {
    let names = ["tool0", "tool_0", "left_foot", "leftfoot", "a_b_1"];
    let types = ["Tool0", "Tool_0", "LeftFoot", "Leftfoot", "AB_1"];
    let frames = names.map(|name| {
        format!("[[frame]]\nname = \"{name}\"\nbody = \"arm\"\nposition = [0.0, 0.0, 1.0]\n")
    });
    let text = system("[0]", &[("arm", "[\"theta1\"]")]) + &frames.concat();
    let options = Options {
        functions: named(
            &names
                .map(|name| format!("pose({name})"))
                .each_ref()
                .map(String::as_str),
        ),
        ..Options::default()
    };
    let module = generate(&Source::new("arm.toml", text), "arm.toml", &options).unwrap();
    for (name, of) in names.into_iter().zip(types) {
        let declared = format!("pub struct {of};");
        let doc = format!("/// The frame `{name}`.");
        let place = module.source.find(&doc).unwrap();
        let line = module.source[place..]
            .lines()
            .find(|line| line.contains("struct"));
        assert_eq!(line.map(str::trim), Some(declared.as_str()));
    }
}
