//! Names that would leave where they are written, and those that cannot be shown.

use kane_codegen::{
    config::Functions,
    description::{Reading, no_includes},
    generate::{Generated, generate},
    options::Options,
};
use kane_test_support::{
    models::system,
    promises::{self, Files},
};

use crate::common::{everything, faults};

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
    // The system's own name stands in every module.
    let small = Options {
        functions: Functions::Named(vec!["q_dot".to_owned()]),
        ..Options::default()
    };
    for name in NAMES {
        let asked = [vec!["bias".to_owned()], promises::of_frame(name)];
        let options = Options {
            functions: Functions::Named(asked.concat()),
            ..everything()
        };
        for (file, text) in named(name) {
            let files = Files::new(file, &text);
            promises::reading(&files, &Reading::default());
            promises::generating(&files, &options);
            if !name.is_empty() {
                let generated = generate(&files.model, file, &small, &no_includes).unwrap();
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

/// What is said of these functions on a model whose joined names meet.
fn asked(functions: &[&str]) -> Result<Generated, String> {
    let masses = "mass = { runtime = 2.0 }";
    let joint = "[\"theta1\", \"theta2\"]";
    let bodies = ["a", "a_b", "c", "b_c", "b", "a_mass_b"].map(|name| (name, joint));
    let model = system("[0, 0, 0, 0, 0, 0]", &bodies).replace("mass = 2.0", masses);
    let files = Files::new("model.toml", &model);
    let options = Options {
        functions: Functions::Named(functions.iter().map(|&name| name.to_owned()).collect()),
        ..Options::default()
    };
    let generated = generate(&files.model, "model.toml", &options, &no_includes);
    generated.map_err(|fault| fault.to_string())
}

#[test]
fn names_that_meet_where_they_are_joined_are_refused() {
    let inertia = |of: &str| format!("operational_inverse_inertia({of})");
    let (one, other) = (inertia("a, b_c"), inertia("a_b, c"));
    let by_q = |name: &str, of: &str| format!("{name} = packed(d({of})/d(q))");
    let constant = "D_A_B_C_OPERATIONAL_INVERSE_INERTIA_D_Q_PACKED_PLACES";
    let [x, y] = [by_q("x", &one), by_q("y", &other)];
    let fault = asked(&[&x, &y]).unwrap_err();
    assert!(
        fault.contains(&format!("both have the constant `{constant}`")),
        "{fault}"
    );
    let masses = [
        "x = hessian(bias; a_mass_b_mass)",
        "y = hessian(bias; a_mass, b_mass)",
    ];
    let fault = asked(&masses).unwrap_err();
    assert!(
        fault.contains("`HESSIAN_BIAS_A_MASS_B_MASS_PLACES`"),
        "{fault}"
    );
    let fault = asked(&[&format!("{one}+{other}")]).unwrap_err();
    let output = "would be called `a_b_c_operational_inverse_inertia`";
    assert!(fault.contains(output), "{fault}");
    let fault = asked(&[&one, &other]).unwrap_err();
    let function = "would both be called `a_b_c_operational_inverse_inertia`";
    assert!(fault.contains(function), "{fault}");
    // One constant of one thing, in two functions.
    let again = x.replace("x = ", "z = ") + "+bias";
    let module = asked(&[&x, &again]).unwrap().source;
    assert_eq!(module.matches(&format!("pub const {constant}:")).count(), 1);
}

#[test]
fn modules_that_call_a_frame_differently_have_another_input() {
    let generated = |frames: &[&str]| {
        let frames = frames.iter().map(|name| {
            format!("[[frame]]\nname = \"{name}\"\nbody = \"b\"\nposition = [0, 0, 0.1]\n")
        });
        let model = system("[0]", &[("b", "[\"theta1\"]")]) + &frames.collect::<String>();
        let files = Files::new("model.toml", &model);
        let options = Options {
            functions: Functions::Named(vec!["pose(Tool-0)".to_owned()]),
            ..Options::default()
        };
        let generated = generate(&files.model, "model.toml", &options, &no_includes);
        generated.unwrap().source
    };
    let [alone, second] = [generated(&["Tool-0"]), generated(&["tool 0", "Tool-0"])];
    assert!(alone.contains("pub fn tool_0_pose<"));
    assert!(second.contains("pub fn tool_0_2_pose<"));
    let input = |module: &str| module.lines().nth(1).map(str::to_owned);
    assert!(input(&alone).is_some());
    assert_ne!(input(&alone), input(&second));
}
