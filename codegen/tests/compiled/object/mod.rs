//! What is promised of generated functions, on their machine code: it holds, and a module that breaks it is found out.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

mod planted;
mod stages;
mod vectors;

use std::{
    fs,
    path::{Path, PathBuf},
    sync::OnceLock,
};

use kane_codegen::{
    config::Functions,
    description::{Base, Reading, no_includes},
    diagnostic::Source,
    generate,
    object::{OptLevel, Options, Report, Runtime, Scalar, What, verify},
    options,
};

use kane_test_support::systems::trees;

const RELEASE: Options = Options {
    scalar: Scalar::F64,
    opt_level: OptLevel::Three,
    target_cpu: None,
};

fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

fn runtime(options: &Options) -> Runtime {
    Runtime::new(&repository("src/lib.rs"), options).unwrap()
}

/// The runtime as a release build compiles it, compiled once.
fn released() -> &'static Runtime {
    static RUNTIME: OnceLock<Runtime> = OnceLock::new();
    RUNTIME.get_or_init(|| runtime(&RELEASE))
}

/// The report on a module's text, as a release build compiles it.
fn report(text: &str) -> Report {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("system.rs");
    fs::write(&path, text).unwrap();
    verify(released(), &path).unwrap()
}

fn assert_holds(report: &Report, what: &str) {
    let broken = report.all().filter(|own| !own.breaches.is_empty());
    let broken: Vec<_> = broken.map(|own| (&own.name, &own.breaches)).collect();
    assert!(broken.is_empty(), "{what}: {broken:#?}");
}

/// The module of a model.
fn module(source: &Source, base: Option<Base>, functions: Functions) -> String {
    let options = options::Options {
        functions,
        reading: Reading {
            base,
            ..Reading::default()
        },
        ..options::Options::default()
    };
    let module = generate::generate(source, "model", &options, &no_includes);
    module.unwrap().source
}

fn assert_bundled_holds(runtime: &Runtime, systems: &[&str], what: &str) {
    for system in systems {
        let path = repository(&format!("generated/{system}.rs"));
        let report = verify(runtime, &path).unwrap();
        let text = fs::read_to_string(path).unwrap();
        let written = text.split("#[inline(never)]").skip(1);
        let is_helper = |own: &str| own.contains("_lockstep_");
        let name = |own: &str| own.split_once('(').map_or("", |(name, _)| name).to_owned();
        let (helpers, functions): (Vec<String>, Vec<String>) =
            written.map(name).partition(|own| is_helper(own));
        let (found_helpers, found): (Vec<_>, Vec<_>) = report
            .functions
            .iter()
            .partition(|own| is_helper(&own.name));
        assert_eq!(found.len(), functions.len());
        // LLVM makes one function of helpers that are alike: those of a matrix and of the same packed.
        let n_helpers = found_helpers.len();
        assert!(n_helpers <= helpers.len() && 2 * n_helpers >= helpers.len());
        assert_holds(&report, &format!("{system}, {what}"));
    }
}

#[test]
fn bundled_systems_hold() {
    assert_bundled_holds(released(), &["cart_pole", "eight_body"], "release");
}

#[test]
fn bundled_systems_hold_in_single_precision_with_fewer_optimizations() {
    let options = Options {
        scalar: Scalar::F32,
        opt_level: OptLevel::Two,
        ..RELEASE
    };
    // The eight bodies hold the compiler up for long.
    let n_systems = if trees::all_seeds() { 2 } else { 1 };
    let systems = &["cart_pole", "eight_body"][..n_systems];
    assert_bundled_holds(&runtime(&options), systems, "single precision");
}

fn assert_robot_holds(name: &str, base: Base) {
    assert_functions_hold(name, base, Functions::default());
}

fn assert_functions_hold(name: &str, base: Base, functions: Functions) {
    let path = repository(&format!("tests/robots/{name}/{name}.urdf"));
    let source = Source::new(format!("{name}.urdf"), fs::read_to_string(path).unwrap());
    let text = module(&source, Some(base), functions);
    assert_holds(&report(&text), name);
}

#[test]
fn arms_hold() {
    assert_robot_holds("panda", Base::Fixed);
    assert_robot_holds("ur5", Base::Fixed);
}

#[test]
fn functions_of_frames_and_matrices_hold() {
    let functions = [
        "pose(FL_FOOT)+velocity(FL_FOOT)",
        "jacobian(FL_FOOT)+jacobian(FR_FOOT)+jacobian(HL_FOOT)+jacobian(HR_FOOT)",
        "jacobian(FL_FOOT, HR_FOOT)",
        "jacobian_packed(FL_FOOT)",
        "linear_jacobian(FL_FOOT, local)",
        "point_jacobian(FL_FOOT)",
        "acceleration(FL_FOOT, local)",
        "jacobian_dot_u(FL_FOOT)",
        "generalized_force(FL_FOOT)",
        "imu(base_link)",
        "operational_inverse_inertia(FL_FOOT, FR_FOOT)",
        "coriolis_matrix",
        "mass_matrix_dot",
        "mass_matrix_inverse",
        "mass_matrix_factors",
        "regressor",
        "regressor_packed",
        "base_regressor",
        "joint_wrenches",
    ];
    let functions = functions.map(str::to_owned).to_vec();
    assert_functions_hold("solo12", Base::Free, Functions::Named(functions));
}

#[test]
fn derivatives_hold() {
    let functions = [
        "inverse_dynamics+d(inverse_dynamics)/d(q, u)",
        "d(forward_dynamics)/d(q, u, tau)(sin_cos)",
        "d(jacobian(tool0))/d(q)",
        "packed(d(forward_dynamics)/d(q))",
        "jvp(inverse_dynamics; q, u, u_dot)",
        "vjp(forward_dynamics; q, u, tau)",
        "hessian(inverse_dynamics; q)",
    ];
    let functions = functions.map(str::to_owned).to_vec();
    assert_functions_hold("ur5", Base::Fixed, Functions::Named(functions));
}

#[test]
fn columns_and_branches_in_lockstep_hold() {
    let path = repository("tests/robots/solo12/solo12.urdf");
    let source = Source::new("solo12.urdf", fs::read_to_string(path).unwrap());
    let functions = [
        "forward_dynamics",
        "mass_matrix_inverse",
        "regressor_packed",
        "d(inverse_dynamics)/d(q, u, u_dot)",
        "d(forward_dynamics)/d(q, u)",
    ];
    let functions = functions.map(str::to_owned).to_vec();
    let text = module(&source, Some(Base::Free), Functions::Named(functions));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("solo12.rs");
    fs::write(&path, text).unwrap();
    let options = Options {
        scalar: Scalar::F32,
        opt_level: OptLevel::Two,
        ..RELEASE
    };
    for runtime in [released(), &runtime(&options)] {
        let report = verify(runtime, &path).unwrap();
        let helpers = report.functions.iter();
        let helpers = helpers.filter(|one| one.name.contains("_lockstep_"));
        assert!(helpers.count() > 8);
        assert_holds(&report, "solo12");
    }
}

#[test]
fn an_arm_holds_with_larger_vectors_and_fused_operations() {
    let path = repository("tests/robots/panda/panda.urdf");
    let source = Source::new("panda.urdf", fs::read_to_string(path).unwrap());
    let options = options::Options {
        fma: true,
        ..options::Options::default()
    };
    let module = generate::generate(&source, "model", &options, &no_includes);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("panda.rs");
    fs::write(&path, module.unwrap().source).unwrap();
    let options = Options {
        target_cpu: Some("haswell".to_owned()),
        ..RELEASE
    };
    let report = verify(&runtime(&options), &path).unwrap();
    assert_holds(&report, "panda");
    // These sines are compiled with the runtime.
    let names: Vec<&str> = report.sines.iter().map(|f| f.name.as_str()).collect();
    assert!(names.iter().any(|name| name.contains("eight")), "{names:?}");
}

#[test]
fn a_quadruped_holds() {
    assert_robot_holds("solo12", Base::Free);
}

#[test]
fn a_humanoid_holds() {
    assert_robot_holds("talos", Base::Free);
}

#[test]
fn functions_that_are_given_sines_hold_and_so_does_what_computes_these() {
    let path = repository("models/eight_body.toml");
    let source = Source::new("eight_body", fs::read_to_string(path).unwrap());
    let names = ["bias(sin_cos)", "q_dot+rotation"].map(str::to_owned);
    let report = report(&module(&source, None, Functions::Named(names.into())));
    let names: Vec<&str> = report.functions.iter().map(|f| f.name.as_str()).collect();
    assert!(names.contains(&"sin_cos"), "{names:?}");
    assert!(names.contains(&"bias_at_sin_cos"), "{names:?}");
    assert_holds(&report, "sines given");
}

/// What asks for sines and cosines of so many angles at once, and does with each something else.
fn sines_of(n_angles: usize) -> String {
    let angles: Vec<String> = (0..n_angles).map(|angle| format!("q[{angle}]")).collect();
    let stores = (0..n_angles).map(|angle| {
        let others = [7 * angle + 3, 5 * angle + 1].map(|place| place % n_angles);
        let [factor, cosine] = others;
        format!("o[{angle}] = sines[{angle}] * q[{factor}] + cosines[{cosine}] * q[{angle}];\n")
    });
    let (angles, stores) = (angles.join(", "), stores.collect::<String>());
    // What two functions call is a function of its own.
    let functions = ["one", "other"].map(|name| {
        format!(
            "#[inline(never)]\npub fn {name}_of_{n_angles}<R: kane::Real>(q: &[R; {n_angles}], o: &mut [R; {n_angles}]) {{\n\
             let (sines, cosines) = R::sin_cos_array([{angles}]);\n{stores}}}\n"
        )
    });
    functions.concat()
}

#[test]
fn sines_of_any_number_of_angles_hold() {
    let text: String = (1..=64).map(sines_of).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sines.rs");
    fs::write(&path, text).unwrap();
    let haswell = Some("haswell".to_owned());
    let holds = |runtime: &Runtime, what: &str| {
        let report = verify(runtime, &path).unwrap();
        assert_eq!(report.functions.len(), 2 * 64);
        assert_holds(&report, what);
    };
    holds(released(), "release");
    for (scalar, opt_level, target_cpu) in [
        (Scalar::F32, OptLevel::Three, None),
        (Scalar::F64, OptLevel::Two, None),
        (Scalar::F64, OptLevel::Two, haswell),
    ] {
        let options = Options {
            scalar,
            opt_level,
            target_cpu,
        };
        holds(&runtime(&options), &format!("{options:?}"));
    }
}

/// Every function of random trees; the variable `KANE_TREES_FOLDER` asks for their modules.
#[test]
#[expect(clippy::print_stdout, reason = "what was tried, for `tests/trees.sh`")]
fn random_trees_hold() {
    let folder = std::env::var_os("KANE_TREES_FOLDER").map(PathBuf::from);
    let (mut n_functions, mut text_bytes, mut most_stack) = (0, 0, 0);
    for (place, system) in trees::first(trees::count(1 + trees::share(3))).enumerate() {
        let text = module(
            &Source::new("random", system.toml()),
            None,
            Functions::All(Vec::new()),
        );
        if let Some(folder) = &folder {
            fs::write(folder.join(format!("tree_{place}.rs")), &text).unwrap();
        }
        let report = report(&text);
        assert_holds(&report, &format!("tree {place}"));
        for function in report.all() {
            n_functions += 1;
            text_bytes += function.text;
            most_stack = most_stack.max(function.stack);
        }
    }
    println!(
        "{n_functions} functions, {text_bytes} bytes of machine code, at most {most_stack} bytes of stack"
    );
}

#[test]
fn zeros_that_are_not_parted_are_found_as_a_call() {
    let path = repository("models/eight_body.toml");
    let source = Source::new("eight_body", fs::read_to_string(path).unwrap());
    let name = vec!["gravity_forces".to_owned()];
    let text = module(&source, None, Functions::Named(name));
    assert_holds(&report(&text), "with some zeros apart");
    let (apart, joined) = ("kane::store(", "self::store(");
    assert!(text.contains(apart));
    let store = "fn store<T>(place: &mut T, value: T) { *place = value; }";
    let report = report(&format!("{}{store}", text.replace(apart, joined)));
    let found = report.functions.iter().find(|f| f.name == "gravity_forces");
    let breaches = &found.unwrap().breaches;
    assert_eq!(breaches.len(), 1);
    assert_eq!(breaches[0].what, What::Call("memset".to_owned()));
}
