//! Models too deep, too long, too many, or at the ends of what numbers there are.

use kane_codegen::{
    companions::{Abi, CompanionKind},
    config::Functions,
    description::{self, Reading, no_includes},
    diagnostic::{Diagnostic, Source},
    generate::generate,
    limits,
    options::Options,
};
use kane_test_support::{
    models::{body, system},
    promises::{self, Files},
};

use crate::common::{faults, numbered};

#[test]
fn entities_are_not_expanded_and_no_file_is_read_for_one() {
    let laughs = numbered(12, |n| {
        format!("<!ENTITY l{} \"&l{n};&l{n};&l{n};\">", n + 1)
    });
    for declared in [
        laughs,
        "<!ENTITY l12 SYSTEM \"file:///etc/passwd\">".to_owned(),
        format!("<!ENTITY l12 \"{}\">", "a".repeat(100_000)),
    ] {
        for (file, root) in [("model.urdf", "robot"), ("model.xml", "mujoco")] {
            let text = format!(
                "<!DOCTYPE {root} [<!ENTITY l0 \"ha\">{declared}]>\n<{root} name='{}'/>",
                "&l12;".repeat(100)
            );
            let faults = faults(file, &text);
            assert!(
                faults.contains("a document type declaration is not accepted"),
                "{faults}"
            );
        }
    }
}

#[test]
fn markup_that_takes_its_square_to_parse_is_refused() {
    let attributes = numbered(200_000, |n| format!(" a{n}=''"));
    let spaces = numbered(20_000, |n| format!("<a xmlns:n{n}='u{n}'>"));
    let classes = numbered(20_000, |n| format!("<default class='c{n}'/>"));
    for (file, root) in [("model.urdf", "robot"), ("model.xml", "mujoco")] {
        let text = format!("<{root} name='a'{attributes}/>");
        assert!(
            faults(file, &text).contains("the element has 200001 attributes; expected at most 250")
        );
        let text = format!("<{root} name='a'>{spaces}</{root}>");
        assert!(faults(file, &text).contains("more than 100 namespaces are declared"));
        let text = format!(
            "<{root}>{}</{root}>",
            "<a/>".repeat(limits::XML_NODES as usize)
        );
        assert!(
            faults(file, &text).contains("it has more than 1000000 elements, comments and texts")
        );
    }
    let text = format!("<mujoco><default>{classes}</default></mujoco>");
    assert!(
        faults("model.xml", &text)
            .contains("the number of default classes is 10001; expected at most 10000")
    );
}

#[test]
fn deep_nesting_does_not_reach_the_end_of_the_stack() {
    let many = |text: &str| text.repeat(1_000_000);
    for (file, text) in [
        ("model.toml", format!("name = {}", many("["))),
        ("model.toml", format!("name = {}", many("{a="))),
        ("model.toml", many("a.")),
        ("model.urdf", format!("<robot>{}", many("<a>"))),
        (
            "model.urdf",
            format!("<robot name='a'>{}{}</robot>", many("<a>"), many("</a>")),
        ),
        (
            "model.xml",
            format!("<mujoco>{}{}</mujoco>", many("<a>"), many("</a>")),
        ),
        (
            "model.xml",
            format!(
                "<mujoco><worldbody>{}{}</worldbody></mujoco>",
                many("<body>"),
                many("</body>")
            ),
        ),
    ] {
        assert!(faults(file, &text).starts_with("error: "));
    }
}

#[test]
fn very_many_faults_are_told_soon() {
    let keys = numbered(150_000, |n| format!("k{n} = 1\n"));
    let unknown = numbered(200_000, |n| format!("<linx{n}/>"));
    let geoms = format!(
        "<default>{}</default><worldbody><body>{}</body></worldbody>",
        "<default class='a'/>".repeat(2),
        "<geom class='b'/>".repeat(100_000)
    );
    for (file, text) in [
        ("model.toml", keys),
        ("model.toml", "a = 1\n".repeat(150_000)),
        ("model.toml", "a\n\n".repeat(150_000)),
        (
            "model.toml",
            format!("name = \"{}\"\nq = 1", "x".repeat(5_000_000)),
        ),
        (
            "model.toml",
            format!("lower_bodies = [{}]", "[],".repeat(300_000)),
        ),
        ("model.toml", "[[body]]\n".repeat(150_000)),
        ("model.urdf", format!("<robot>{unknown}</robot>")),
        (
            "model.urdf",
            format!("<robot>{}</robot>", "<link/>".repeat(150_000)),
        ),
        (
            "model.urdf",
            format!("<robot><link name='{}'/></robot>", "q".repeat(5_000_000)),
        ),
        (
            "model.xml",
            format!(
                "<mujoco><worldbody>{}</worldbody></mujoco>",
                "<body/>".repeat(200_000)
            ),
        ),
        (
            "model.xml",
            format!(
                "<mujoco><worldbody><body>{}</body></worldbody></mujoco>",
                "<joint/>".repeat(200_000)
            ),
        ),
        ("model.xml", format!("<mujoco>{geoms}</mujoco>")),
    ] {
        let faults = faults(file, &text);
        assert!(faults.len() < 200_000, "{} bytes", faults.len());
    }
}

#[test]
fn of_very_many_faults_the_first_are_told() {
    let many = |text: &str| text.repeat(5_000);
    let keys = numbered(1_000, |n| format!("k{n} = 1\n"));
    let body =
        |n: usize| format!("<link name='l{n}'><inertial><mass value='x'/></inertial></link>");
    for (file, text) in [
        ("model.toml", format!("[[body]]\n{keys}").repeat(100)),
        (
            "model.toml",
            format!("[[body]]\njoint = [{}]\n", many("1, ")).repeat(20),
        ),
        (
            "model.toml",
            format!("[[body]]\nmass_center = [{}]\n", many("[], ")).repeat(20),
        ),
        (
            "model.toml",
            format!("[[body]]\nlocked = {{ {} }}\n", keys.replace('\n', ", ")).repeat(20),
        ),
        (
            "model.urdf",
            format!("<robot name='a'>{}</robot>", numbered(5_000, body)),
        ),
        (
            "model.xml",
            format!(
                "<mujoco><worldbody>{}</worldbody></mujoco>",
                many("<body pos='x'/>")
            ),
        ),
        (
            "model.xml",
            format!(
                "<mujoco>{}<worldbody><body pos='x'/></worldbody></mujoco>",
                many("<a/>")
            ),
        ),
    ] {
        let source = Source::new(file, text);
        let description = description::read(&source, &Reading::default(), &no_includes);
        let is_error = description.faults.iter().map(Diagnostic::is_error);
        let n_errors = is_error.filter(|is_error| *is_error).count();
        let n_others = description.faults.len() - n_errors;
        assert!((1..=limits::TOLD).contains(&n_errors), "{n_errors} errors");
        assert!(n_others <= limits::TOLD, "{n_others} warnings");
    }
}

/// A chain of bodies of which each has these keys besides.
pub(crate) fn chain(n_bodies: usize, joint: &str, more: &str) -> String {
    let lower: Vec<usize> = (0..n_bodies).collect();
    let bodies = (0..n_bodies).map(|number| {
        let joint = if number == 0 { "[\"theta1\"]" } else { joint };
        let more = if number == 0 { "" } else { more };
        body(&format!("b{number}"), joint) + more
    });
    format!(
        "name = \"chain\"\nlower_bodies = {lower:?}\n{}",
        bodies.collect::<String>()
    )
}

#[test]
fn ten_thousand_bodies_of_any_kind_are_read_or_refused_soon() {
    let n = limits::BODIES;
    let runtime = chain(n, "[]", "").replace("0.3]", "{ runtime = 0.3 }]");
    assert!(
        faults("model.toml", &runtime)
            .contains("values that are set at run time; expected at most 2000")
    );
    let following = chain(n, "[\"theta2\"]", "mimic = { joint = \"b0\" }\n");
    let many = "in which joints follow others, has 10000 bodies that move and 1 speeds; expected at most 250 of each";
    assert!(faults("model.toml", &following).contains(many));
    let massless = chain(n, "[\"theta2\"]", "")
        .replace("mass = 2.0", "mass = 0.0")
        .replace("0.1,", "0.0,")
        .replace("0.02", "0.0")
        .replace("0.01", "0.0");
    let told = faults("model.toml", &massless);
    assert!(told.contains("nothing that moves has a mass"), "{told}");
    for (joint, more) in [
        ("[]", ""),
        ("\"free\"", ""),
        ("[\"theta2\"]", "joint_name = \"a\"\n"),
    ] {
        let text = chain(n, joint, more);
        promises::generating(&Files::new("model.toml", &text), &Options::default());
    }
}

/// Why nothing is generated of a chain of so many hinges.
fn refused(n: usize, options: &Options) -> String {
    let source = Source::new("model.toml", chain(n, "[\"theta2\"]", ""));
    let generated = generate(&source, "model.toml", options, &no_includes);
    generated.unwrap_err().to_string()
}

pub(crate) fn named(name: &str) -> Options {
    Options {
        functions: Functions::Named(vec![name.to_owned()]),
        ..Options::default()
    }
}

#[test]
fn inverse_of_thousands_of_speeds_is_told_before_its_places_are_found() {
    let inverse = refused(5000, &named("mass_matrix_inverse_packed"));
    assert_eq!(
        inverse,
        "the functions, `mass_matrix_inverse_packed` most of all, write 12507500 numbers; expected at most 250000"
    );
    let all = Options {
        functions: Functions::All(Vec::new()),
        ..Options::default()
    };
    let all = refused(5000, &all);
    assert!(all.starts_with("the functions, `"), "{all}");
}

#[test]
fn whatever_factorises_is_told_before_it_is_derived() {
    for name in [
        "mass_matrix_factors",
        "forward_dynamics_pivots",
        "operational_inverse_inertia(b5)",
    ] {
        assert_eq!(
            refused(200, &named(name)),
            format!("factorising for `{name}` takes 2766100 updates; expected at most 1000000")
        );
        let notes = Options {
            formulation: kane_codegen::config::Formulation::Notes,
            ..named(name)
        };
        assert_eq!(
            refused(200, &notes),
            format!("the notes' sums for `{name}` have 1353400 terms; expected at most 100000")
        );
    }
}

#[test]
fn notes_of_what_a_path_moves_are_told_before_they_are_derived() {
    for (name, terms) in [
        ("jacobian(b449)", 101_025),
        ("jacobian_packed(b449, local)", 101_025),
        ("point_jacobian(b449)", 101_025),
        ("generalized_force(b449)", 101_025),
        ("gravity_forces", 101_475),
    ] {
        let notes = Options {
            formulation: kane_codegen::config::Formulation::Notes,
            ..named(name)
        };
        assert_eq!(
            refused(450, &notes),
            format!("the notes' sums for `{name}` have {terms} terms; expected at most 100000")
        );
    }
}

#[test]
fn plans_are_not_compared_for_longer_where_all_folds() {
    // Two hundred hinges about one line: few nodes, however many sums are asked for. Without a bound on these it took minutes.
    let text = chain(200, "[\"theta3\"]", "")
        .replace("\"theta1\"", "\"theta3\"")
        .replace("0.1, 0.3]", "0.0, 0.3]");
    let source = Source::new("model.toml", text);
    let generated = generate(&source, "model.toml", &named("mass_matrix"), &no_includes);
    assert!(generated.is_ok());
}

#[test]
fn what_would_be_too_large_is_told_before_it_is_derived() {
    let notes = Options {
        formulation: kane_codegen::config::Formulation::Notes,
        ..named("mass_matrix")
    };
    let tested = Options {
        companions: [CompanionKind::Tests].into(),
        module: "module".to_owned(),
        ..named("mass_matrix_packed")
    };
    let factorised = Options {
        without: [kane_codegen::recursive::Technique::Articulated].into(),
        ..named("forward_dynamics")
    };
    let fixed = Source::new("model.toml", chain(5001, "[]", ""));
    let fixed = generate(&fixed, "model.toml", &named("bias"), &no_includes);
    let many = "the bodies have 5001 parts; expected at most 5000";
    assert_eq!(fixed.unwrap_err().to_string(), many);
    for (n, options, why) in [
        (
            5001,
            named("bias"),
            "the system has 5001 speeds; expected at most 5000",
        ),
        (
            200,
            named("d(bias)/d(q, u)"),
            "`d(bias)/d(q, u)` writes 80000 numbers of derivatives; expected at most 20000",
        ),
        (
            200,
            named("hessian(bias; q, u)"),
            "`hessian(bias; q, u)` writes 80200 numbers of derivatives; expected at most 20000",
        ),
        (
            1000,
            named("vjp(mass_matrix; q)"),
            "what `vjp(mass_matrix; q)` differentiates has 1000000 numbers; expected at most 250000",
        ),
        (
            200,
            named("vjp(mass_matrix_inverse; q)"),
            "what `vjp(mass_matrix_inverse; q)` differentiates has 40000 numbers of solutions; expected at most 20000",
        ),
        (
            600,
            named("mass_matrix"),
            "the functions, `mass_matrix` most of all, write 360600 numbers; expected at most 250000",
        ),
        (
            200,
            notes,
            "the notes' sums for `mass_matrix` have 1353400 terms; expected at most 100000",
        ),
        (
            300,
            tested,
            "the functions, `mass_matrix_packed` most of all, have for the tests 4906300 terms; expected at most 4000000",
        ),
        (
            1200,
            Options {
                companions: [CompanionKind::Tests].into(),
                module: "module".to_owned(),
                ..named("q_dot")
            },
            "the functions, `inverse_dynamics` most of all, have for the tests 5764800 terms; expected at most 4000000",
        ),
        (
            200,
            factorised,
            "factorising for `forward_dynamics` takes 2766100 updates; expected at most 1000000",
        ),
    ] {
        assert_eq!(refused(n, &options), why);
    }
}

#[test]
fn numbers_at_the_ends_of_what_there_is_are_generated_or_refused() {
    let mimic = |joint: &str| {
        format!(
            "\"revolute\"\naxis = [0, 1, 0]\nmimic = {{ joint = \"{joint}\", multiplier = 1.5, offset = 0.25 }}"
        )
    };
    let text = system(
        "[0, 1, 1, 3, 4]",
        &[
            ("a", "\"revolute\"\naxis = [0, 0, 1]"),
            ("b", "[\"theta1\", \"s1\"]"),
            ("c", &mimic("a")),
            ("d", &mimic("c")),
            ("e", "[]"),
        ],
    );
    let text = text + "[[frame]]\nname = \"mark\"\nbody = \"e\"\nposition = [0.7, 0.0, 0.0]\n";
    // What reads little of the model: nothing else is in the way of a number that does not fit.
    let little = Options {
        companions: [CompanionKind::Manifest, CompanionKind::Abi(Abi::C)].into(),
        module: "module".to_owned(),
        ..named("q_dot")
    };
    for number in [
        "1e400",
        "nan",
        "inf",
        "-inf",
        "-0.0",
        "1e-320",
        "5e-324",
        "1e-300",
        "1e155",
        "1e300",
        "1.7976931348623157e308",
    ] {
        for place in [
            "2.0", "0.01", "0.1", "-0.5", "0.02", "0.3", "1.5", "0.25", "0.7",
        ] {
            for text in [text.replace(place, number), text.replacen(place, number, 1)] {
                let files = Files::new("model.toml", &text);
                promises::reading(&files, &Reading::default());
                promises::generating(&files, &Options::default());
                promises::generating(&files, &little);
            }
        }
    }
}

#[test]
fn defaults_that_are_given_again_and_again_take_no_longer_each_time() {
    let sizes = "<geom size='1'/>".repeat(300_000);
    let bodies = "<body><joint/><geom size='0.1'/></body>".repeat(1_000);
    let text = format!(
        "<mujoco><default><geom type='box' size='1 2 3'/>{sizes}</default><worldbody>{bodies}</worldbody></mujoco>"
    );
    let source = Source::new("model.xml", text);
    let description = description::read(&source, &Reading::default(), &no_includes);
    assert_eq!(description.bodies.len(), 1_000);
    assert!(!description.faults.iter().any(Diagnostic::is_error));
}
