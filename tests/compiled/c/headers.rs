//! Headers alone.

use std::{fmt::Write as _, fs, process::Command};

use kane_codegen::{
    companions::{Abi, CompanionKind},
    config::Functions,
    description::no_includes,
    diagnostic::Source,
    functions::CATALOGUE,
    generate::{Generated, generate},
    options::Options,
};

use kane_test_support::tool::tools;

use super::{C, CPP, WARNINGS, folder, run};

/// A body that slides: without angles, parameters and partial angular velocities.
const SLIDE: &str = r#"
name = "slide"
lower_bodies = [0]

[[body]]
name = "block"
mass = 1.0
mass_center = [0.0, 0.0, 0.0]
inertia = { xx = 0.1, yy = 0.1, zz = 0.1, xy = 0.0, xz = 0.0, yz = 0.0 }
attachment = [0.0, 0.0, 0.0]
joint = ["s1"]
"#;

/// A body that floats and one that turns on it, with names that C and C++ have for themselves, and parameters.
pub(crate) const CLAW: &str = r#"
name = "claw"
gravity = [0.0, 0.0, { runtime = -9.81 }]
lower_bodies = [0, 1]

[[body]]
name = "int"
mass = { runtime = 2.0 }
mass_center = [0.01, 0.02, -0.5]
inertia = { xx = 0.3, yy = 0.2, zz = 0.25, xy = 0.01, xz = 0.0, yz = 0.02 }
attachment = [0.0, 0.1, 0.3]
joint = "free"
chart = "quaternion"

[[body]]
name = "operator"
mass = 1.5
mass_center = [0.1, 0.02, -0.4]
inertia = { xx = 0.1, yy = 0.1, zz = { runtime = 0.02 }, xy = 0.0, xz = 0.01, yz = 0.0 }
attachment = [0.2, 0.0, -1.0]
joint = "revolute"
axis = [0.0, 1.0, 0.0]
joint_name = "double"
damping = 0.1
"#;

/// A module with every function, some joined, some given sines and cosines, and all that can stand beside it.
pub(crate) fn module(name: &str, model: &str) -> Generated {
    let joined = [
        "mass_matrix+mass_matrix_packed+bias",
        "kinetic_energy+potential_energy",
        "inverse_dynamics(sin_cos)",
        "partial_velocity(sin_cos)",
    ];
    let functions = CATALOGUE.iter().map(|function| function.name);
    let functions = functions.chain(joined).map(str::to_owned);
    let functions = functions.chain(derivatives(model.contains("runtime")));
    let last = model.rsplit("[[body]]").next();
    let last = last.and_then(|body| body.split('"').nth(1));
    let last = last.expect("a body begins with its name");
    let of_frame = [
        format!("pose(\"{last}\")"),
        format!("velocity(\"{last}\")+pose(\"{last}\")"),
        format!("velocity(\"{last}\", local)"),
        format!("point_jacobian(\"{last}\")+jacobian_packed(\"{last}\", local)"),
        format!("generalized_force(\"{last}\")"),
    ];
    module_of(name, model, functions.chain(of_frame).collect())
}

/// A module with these functions, and all that can stand beside it.
pub(crate) fn module_of(name: &str, model: &str, functions: Vec<String>) -> Generated {
    let prescribed = (model == CLAW).then_some("double");
    let options = Options {
        functions: Functions::Named(functions),
        companions: [CompanionKind::Manifest, CompanionKind::Abi(Abi::C)].into(),
        module: name.to_owned(),
        prescribed: prescribed.into_iter().map(str::to_owned).collect(),
        ..Options::default()
    };
    let source = Source::new(format!("{name}.toml"), model);
    generate(&source, "models/claw.toml", &options, &no_includes).unwrap()
}

/// Those that steps need.
pub(crate) fn derivatives(has_parameters: bool) -> Vec<String> {
    let dynamics = [
        "forward_dynamics",
        "loaded_forward_dynamics",
        "hybrid_dynamics",
    ];
    let of_state = dynamics.iter().flat_map(|one| {
        [
            format!("{one}+d({one})/d(q, u, tau)"),
            format!("jvp({one}; q, u, tau)"),
            format!("vjp({one}; q, u, tau)"),
        ]
    });
    let by_parameters = [
        "d(forward_dynamics)/d(parameters)",
        "jvp(forward_dynamics; q, u, tau, parameters)",
        "vjp(forward_dynamics; q, u, tau, parameters)",
    ];
    let by_parameters = by_parameters.into_iter().filter(|_| has_parameters);
    of_state.chain(by_parameters.map(str::to_owned)).collect()
}

#[test]
fn headers_of_every_function_compile_together_without_warnings_and_without_a_library() {
    let folder = folder("headers");
    let mut source = String::new();
    // Once more: a header is read once.
    for (name, model) in [("slide", SLIDE), ("claw", CLAW), ("slide", SLIDE)] {
        for (path, text) in module(name, model).files(&folder.join(format!("{name}.rs"))) {
            fs::write(path, text).unwrap();
        }
        writeln!(source, "#include \"{name}.h\"").unwrap();
    }
    source += "int main(void) { return 0; }\n";
    let check = |compilers: [&str; 2], standards: [&str; 2], file: &str| {
        fs::write(folder.join(file), &source).unwrap();
        for compiler in tools(compilers, "headers by this compiler") {
            for standard in standards {
                let mut command = Command::new(compiler);
                command.args(WARNINGS).arg(format!("-std={standard}"));
                // A microcontroller's compiler may have no library.
                command.args(["-ffreestanding", "-nostdinc"]);
                run(command.arg("-fsyntax-only").arg(folder.join(file)));
            }
        }
    };
    check(C, ["c99", "gnu17"], "main.c");
    check(CPP, ["c++98", "c++17"], "main.cpp");
}
