//! Models that nobody means well, and those that fuzzing invented: whatever is given, a model is generated or what is wrong
//! with it is told, in bounded time and memory.

#![expect(
    clippy::unwrap_used,
    reason = "a test stops where it fails, its helpers too"
)]

use std::{
    fs,
    path::{Path, PathBuf},
};

use kane_codegen::{
    companions::Kind,
    compile::Options,
    config::Functions,
    description::{self, Reading, no_includes},
    diagnostic::{Diagnostic, Source},
    generate::generate,
    limits, tree,
};
use kane_test_support::{
    models::{body, system},
    promises::{self, Files},
    random::Random,
};

/// Everything, with all that can stand beside a module.
fn everything() -> Options {
    Options {
        functions: Functions::All,
        companions: Kind::ALL.into(),
        module: "hostile".to_owned(),
        ..Options::default()
    }
}

fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The files of a folder and of those in it with this ending, with their names.
fn files(path: &str, ending: &str) -> Vec<(String, String)> {
    let mut files = Vec::new();
    let mut folders = vec![folder(path)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if path.is_dir() {
                folders.push(path);
            } else if name.ends_with(ending) {
                let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
                files.push((name, text));
            }
        }
    }
    files.sort();
    files
}

/// As many texts, one after the other.
fn numbered(count: usize, one: impl Fn(usize) -> String) -> String {
    (0..count).map(one).collect()
}

/// What is wrong with a model.
fn faults(name: &str, text: &str) -> String {
    let source = Source::new(name, text);
    let description = description::read(&source, &Reading::default(), &no_includes);
    tree::build(&description).unwrap_err().to_string()
}

#[test]
fn what_fuzzing_found_holds() {
    let found = files("tests/fuzzed", "");
    assert!(!found.is_empty());
    for (name, text) in found {
        let files = Files::new(&name, &text);
        promises::reading(&files, Reading::default());
        promises::generating(&files, &everything());
    }
}

/// Models of this repository in each format: folders, and how often each of their files is changed. Most of a faulty one is
/// right, and it leads to what right ones do not reach.
const MODELS: [(&str, &str, usize); 8] = [
    ("tests/models", ".toml", 30),
    ("../models", ".toml", 30),
    ("../tests/reference", ".toml", 30),
    ("../tests/robots", ".urdf", 30),
    ("../tests/mjcf", ".xml", 30),
    ("tests/invalid", ".toml", 3),
    ("tests/invalid", ".urdf", 3),
    ("tests/invalid", ".xml", 3),
];

#[test]
fn mutated_models_keep_all_promises() {
    let mut random = Random::new(7);
    let pieces = [
        "\"", "'", "<", ">", "/>", "&", "&#10;", "<!--", "]]>", "\0", "\r", "\u{9b}", "\u{202e}",
        "é", "1e999", "-", "nan", "0", "=", "{", "[", "runtime", "name", "inf", " ",
    ];
    for (path, ending, times) in MODELS {
        let models = files(path, ending);
        assert!(!models.is_empty(), "{path}");
        for (name, model) in models {
            for _ in 0..times {
                let mut text: Vec<char> = model.chars().collect();
                for _ in 0..=random.below(4) {
                    let start = random.below(text.len() + 1);
                    let end = (start + random.below(12)).min(text.len());
                    text.splice(start..end, pieces[random.below(pieces.len())].chars());
                }
                let text: String = text.into_iter().collect();
                promises::reading(&Files::new(&name, &text), Reading::default());
            }
        }
    }
}

/// Names that would leave a string, a comment, a format or a table, or are no identifiers.
const NAMES: [&str; 22] = [
    "fn", "self", "Self", "crate", "r#type", "_", "1", "", " ", "🦾", "é", "a b", "*/", "/*",
    "\"#", "\\", "{}", "{a}", "`|`", "<script>", "../x", "${HOME}",
];

/// A name as a string of TOML, and as an attribute of XML.
fn quoted(name: &str) -> [String; 2] {
    let toml = name.replace('\\', "\\\\").replace('"', "\\\"");
    let xml = name
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;");
    [toml, xml].map(|name| format!("\"{name}\""))
}

/// Models in each format with these names of the system, a body and a joint.
fn named(name: &str) -> [(&'static str, String); 3] {
    let [toml, xml] = quoted(name);
    let own = system("[0, 1]", &[("a", "[\"theta1\"]"), ("b", "[\"theta2\"]")]);
    let own = own
        .replace("\"system\"", &toml)
        .replace("\"b\"", &format!("{toml}\njoint_name = {toml}"));
    let inertial = "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
    let urdf = format!(
        "<robot name={xml}><link name='base'/><link name={xml}>{inertial}</link>\
        <joint name={xml} type='continuous'><parent link='base'/><child link={xml}/></joint></robot>"
    );
    let mjcf = format!(
        "<mujoco model={xml}><worldbody><body name={xml}><joint name={xml}/><geom size='1'/></body></worldbody></mujoco>"
    );
    [
        ("model.toml", own),
        ("model.urdf", urdf),
        ("model.xml", mjcf),
    ]
}

/// The name of the system in a module.
fn name_in(module: &str) -> Option<String> {
    let module = syn::parse_file(module).unwrap();
    module.items.iter().find_map(|item| match item {
        syn::Item::Const(constant) if constant.ident == "NAME" => match &*constant.expr {
            syn::Expr::Lit(syn::ExprLit {
                lit: syn::Lit::Str(text),
                ..
            }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    })
}

#[test]
fn names_reach_the_output_as_what_they_are_or_are_refused() {
    let options = Options {
        functions: Functions::Named(vec!["bias".to_owned()]),
        ..everything()
    };
    for name in NAMES {
        for (file, text) in named(name) {
            let files = Files::new(file, &text);
            promises::reading(&files, Reading::default());
            promises::generating(&files, &options);
            if !name.is_empty() {
                let generated = generate(&files.model, file, &options, &no_includes).unwrap();
                assert_eq!(name_in(&generated.source).as_deref(), Some(name));
            }
        }
    }
}

#[test]
fn names_that_cannot_be_shown_are_refused() {
    for character in [
        '\n', '\r', '\t', '\u{1b}', '\u{9b}', '\u{7f}', '\u{202e}', '\u{2066}', '\u{2028}',
    ] {
        let code = u32::from(character);
        let shown = format!("name holds the character U+{code:04X}, which cannot be shown");
        let own =
            system("[0]", &[("b", "[\"theta1\"]")]).replace("\"b\"", &format!("\"\\u{code:04x}\""));
        assert!(faults("model.toml", &own).contains(&shown));
        let [_, (_, urdf), (_, mjcf)] = named("NAME");
        let entity = format!("&#{code};");
        let faults = [("model.urdf", urdf), ("model.xml", mjcf)]
            .map(|(file, text)| faults(file, &text.replace("NAME", &entity)));
        for faults in faults {
            // XML refuses some of them itself.
            assert!(
                faults.contains(&shown) || faults.contains("not valid XML"),
                "{faults}"
            );
        }
    }
}

#[test]
fn long_name_is_refused() {
    let long = "é".repeat(1_000_000);
    for (file, text) in named(&long) {
        let shown = "name has 1000000 characters; expected at most 250\n";
        assert!(faults(file, &text).contains(shown), "{file}");
    }
}

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
fn chain(n_bodies: usize, joint: &str, more: &str) -> String {
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
        .replace("0.1,", "0.0,");
    assert!(faults("model.toml", &massless).contains("body `b0`"));
    for (joint, more) in [
        ("[]", ""),
        ("\"free\"", ""),
        ("[\"theta2\"]", "joint_name = \"a\"\n"),
    ] {
        let text = chain(n, joint, more);
        promises::generating(&Files::new("model.toml", &text), &Options::default());
    }
}

#[test]
fn what_would_be_too_large_is_told_before_it_is_derived() {
    let refused = |n: usize, options: Options| {
        let source = Source::new("model.toml", chain(n, "[\"theta2\"]", ""));
        let generated = generate(&source, "model.toml", &options, &no_includes);
        generated.unwrap_err().to_string()
    };
    let named = |name: &str| Options {
        functions: Functions::Named(vec![name.to_owned()]),
        ..Options::default()
    };
    let notes = Options {
        formulation: kane_codegen::config::Formulation::Notes,
        ..named("mass_matrix")
    };
    let tested = Options {
        companions: [Kind::Tests].into(),
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
                companions: [Kind::Tests].into(),
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
        assert_eq!(refused(n, options), why);
    }
}

#[test]
fn numbers_at_the_ends_of_what_there_is_are_generated_or_refused() {
    let text = system(
        "[0, 1]",
        &[
            ("a", "\"revolute\"\naxis = [0, 0, 1]"),
            ("b", "[\"theta1\", \"s1\"]"),
        ],
    );
    for number in [
        "1e400",
        "nan",
        "inf",
        "-inf",
        "-0.0",
        "1e-320",
        "5e-324",
        "1e-300",
        "1e300",
        "1.7976931348623157e308",
    ] {
        for place in ["2.0", "0.01", "0.1", "-0.5", "0.02", "0.3"] {
            for text in [text.replace(place, number), text.replacen(place, number, 1)] {
                promises::reading(&Files::new("model.toml", &text), Reading::default());
                promises::generating(&Files::new("model.toml", &text), &Options::default());
            }
        }
    }
}
