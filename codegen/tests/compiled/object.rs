//! What is promised of generated functions, on their machine code: it holds, and a module that breaks it is found out.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::{
    fs,
    path::{Path, PathBuf},
    sync::OnceLock,
};

use kane_codegen::{
    compile,
    config::Functions,
    description::{Base, Reading, no_includes},
    diagnostic::Source,
    generate,
    object::{OptLevel, Options, Report, Runtime, Scalar, What, verify},
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

/// The report on a module's text, as a release build compiles it.
fn report(text: &str) -> Report {
    static RUNTIME: OnceLock<Runtime> = OnceLock::new();
    let runtime = RUNTIME.get_or_init(|| runtime(&RELEASE));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("system.rs");
    fs::write(&path, text).unwrap();
    verify(runtime, &path).unwrap()
}

fn assert_holds(report: &Report, what: &str) {
    for function in report.all() {
        let (name, breaches) = (&function.name, &function.breaches);
        assert!(breaches.is_empty(), "{what}, {name}: {breaches:#?}");
    }
}

/// The module of a model.
fn module(source: &Source, base: Option<Base>, functions: Functions) -> String {
    let options = compile::Options {
        functions,
        reading: Reading {
            base,
            ..Reading::default()
        },
        ..compile::Options::default()
    };
    let module = generate::generate(source, "model", &options, &no_includes);
    module.unwrap().source
}

fn assert_bundled_holds(scalar: Scalar, opt_level: OptLevel) {
    let options = Options {
        scalar,
        opt_level,
        ..RELEASE
    };
    let runtime = runtime(&options);
    for system in ["cart_pole", "eight_body"] {
        let path = repository(&format!("generated/{system}.rs"));
        let report = verify(&runtime, &path).unwrap();
        let n_functions = fs::read_to_string(path).unwrap();
        let n_functions = n_functions.matches("#[inline(never)]").count();
        assert_eq!(report.functions.len(), n_functions);
        assert_holds(&report, &format!("{system}, {options:?}"));
    }
}

#[test]
fn bundled_systems_hold() {
    assert_bundled_holds(Scalar::F64, OptLevel::Three);
}

#[test]
fn bundled_systems_hold_in_single_precision_with_fewer_optimizations() {
    assert_bundled_holds(Scalar::F32, OptLevel::Two);
}

fn assert_robot_holds(name: &str, base: Base) {
    assert_functions_hold(name, base, Functions::Default);
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
    ];
    let functions = functions.map(str::to_owned).to_vec();
    assert_functions_hold("ur5", Base::Fixed, Functions::Named(functions));
}

#[test]
fn an_arm_holds_with_larger_vectors_and_fused_operations() {
    let path = repository("tests/robots/panda/panda.urdf");
    let source = Source::new("panda.urdf", fs::read_to_string(path).unwrap());
    let options = compile::Options {
        fma: true,
        ..compile::Options::default()
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
    format!(
        "#[inline(never)]\npub fn of_{n_angles}<R: kane::Real>(q: &[R; {n_angles}], o: &mut [R; {n_angles}]) {{\n\
         let (sines, cosines) = R::sin_cos_array([{}]);\n{}}}\n",
        angles.join(", "),
        stores.collect::<String>()
    )
}

#[test]
fn sines_of_any_number_of_angles_hold() {
    let text: String = (1..=18).chain([24, 26, 33, 64]).map(sines_of).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sines.rs");
    fs::write(&path, text).unwrap();
    let haswell = Some("haswell".to_owned());
    for (scalar, opt_level, target_cpu) in [
        (Scalar::F64, OptLevel::Three, None),
        (Scalar::F32, OptLevel::Three, None),
        (Scalar::F64, OptLevel::Two, None),
        (Scalar::F64, OptLevel::Two, haswell),
    ] {
        let options = Options {
            scalar,
            opt_level,
            target_cpu,
        };
        let report = verify(&runtime(&options), &path).unwrap();
        assert_eq!(report.functions.len(), 22);
        assert_holds(&report, &format!("{options:?}"));
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

/// The functions of the cart and the pole that break a promise, each with what it does, where this stands in
/// `mass_matrix`; `ADDRESS` is a number that nobody knows.
fn broken(fault: &str) -> Vec<(String, What)> {
    let text = fs::read_to_string(repository("generated/cart_pole.rs")).unwrap();
    let place = "    m[0][0] = p.mass_matrix_cart_k1;\n";
    assert!(text.contains(place));
    let fault = fault.replace("ADDRESS", "core::ptr::from_ref(q).addr()");
    let report = report(&text.replace(place, &format!("{fault}\n{place}")));
    assert!(!report.holds());
    let functions = report.all().filter(|f| !f.breaches.is_empty());
    let breaches = functions.flat_map(|f| f.breaches.iter().map(|b| (f.name.clone(), b)));
    breaches
        .map(|(name, breach)| {
            assert!(!breach.instruction.is_empty());
            (name, breach.what.clone())
        })
        .collect()
}

fn of_mass_matrix(what: What) -> (String, What) {
    ("mass_matrix".to_owned(), what)
}

fn assert_breaks(fault: &str, what: What) {
    let broken = broken(fault);
    let expected = of_mass_matrix(what);
    assert!(broken.contains(&expected), "{fault}: {broken:?}");
    assert!(broken.iter().all(|(function, _)| *function == expected.0));
}

#[test]
fn a_branch_is_found() {
    assert_breaks("if ADDRESS & 64 == 0 { return; }", What::Jump);
}

#[test]
fn a_loop_is_found() {
    assert_breaks(
        "for _ in 0..ADDRESS >> 3 & 7 { m[0][1] = m[0][1] * q[0]; }",
        What::Jump,
    );
}

#[test]
fn a_panic_is_found() {
    let name = "core::panicking::panic_bounds_check".to_owned();
    assert_breaks("m[0][1] = q[ADDRESS >> 3 & 3];", What::Panic(name));
}

#[test]
fn a_call_is_found() {
    assert_breaks(
        "#[inline(never)] fn square<R: kane::Real>(x: R) -> R { x * x } m[0][1] = square(q[0]);",
        What::Call("generated::module::mass_matrix::square::<f64>".to_owned()),
    );
}

#[test]
fn a_call_through_a_pointer_is_found() {
    assert_breaks(
        "pub static HOOK: core::sync::atomic::AtomicUsize = core::sync::atomic::AtomicUsize::new(0);\n\
         unsafe { core::mem::transmute::<usize, fn()>(HOOK.load(core::sync::atomic::Ordering::Relaxed))() }",
        What::Call("?".to_owned()),
    );
}

#[test]
fn zeros_that_are_not_parted_are_found_as_a_call() {
    let path = repository("models/eight_body.toml");
    let source = Source::new("eight_body", fs::read_to_string(path).unwrap());
    let name = vec!["gravity_forces".to_owned()];
    let text = module(&source, None, Functions::Named(name));
    let fence = "core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);";
    assert!(text.contains(fence));
    assert_holds(&report(&text), "with fences");
    let report = report(&text.replace(fence, ""));
    let found = report.functions.iter().find(|f| f.name == "gravity_forces");
    let breaches = &found.unwrap().breaches;
    assert_eq!(breaches.len(), 1);
    assert_eq!(breaches[0].what, What::Call("memset".to_owned()));
}

#[test]
fn a_static_that_is_written_is_found() {
    assert_breaks(
        "pub static COUNT: core::sync::atomic::AtomicU32 = core::sync::atomic::AtomicU32::new(0);\n\
         COUNT.store(1, core::sync::atomic::Ordering::Relaxed);",
        What::Static(Some("generated::module::mass_matrix::COUNT".to_owned())),
    );
}

#[test]
fn a_static_that_is_read_is_found() {
    assert_breaks(
        "pub static COUNT: core::sync::atomic::AtomicU32 = core::sync::atomic::AtomicU32::new(0);\n\
         m[0][1] = R::from_f64(f64::from(COUNT.load(core::sync::atomic::Ordering::Relaxed)));",
        What::Static(Some("generated::module::mass_matrix::COUNT".to_owned())),
    );
}

#[test]
fn an_address_from_values_is_found() {
    assert_breaks("m[0][1] = q[ADDRESS >> 3 & 1];", What::Computed);
}

#[test]
fn a_fixed_address_is_found() {
    assert_breaks(
        "unsafe { core::ptr::without_provenance_mut::<u32>(0x4000_0000).write_volatile(1) };",
        What::Absolute,
    );
}

#[test]
fn memory_of_the_thread_is_found() {
    assert_breaks(
        "unsafe { core::arch::asm!(\"mov {}, qword ptr fs:[0]\", out(reg) _) };",
        What::Segment,
    );
}

#[test]
fn the_caller_s_stack_is_found() {
    assert_breaks(
        "unsafe { core::arch::asm!(\"mov qword ptr [rsp + 4096], 0\") };",
        What::Stack,
    );
}

#[test]
fn what_is_far_below_the_stack_is_found() {
    assert_breaks(
        "unsafe { core::arch::asm!(\"mov qword ptr [rsp - 4096], 0\") };",
        What::Stack,
    );
}

#[test]
fn a_stack_that_is_moved_by_a_value_is_found() {
    for mask in ["rcx", "0xff", "-24"] {
        let fault = format!(
            "unsafe {{ core::arch::asm!(\"mov rax, rsp\", \"and rsp, {mask}\", \
             \"mov qword ptr [rsp], 0\", \"mov rsp, rax\") }};"
        );
        assert_eq!(broken(&fault), [of_mass_matrix(What::Computed)], "{mask}");
    }
}

/// What does this to an aligned stack, of which `rax` keeps where it was.
fn on_an_aligned_stack(instruction: &str) -> String {
    format!(
        "unsafe {{ core::arch::asm!(\"mov rax, rsp\", \"and rsp, -64\", \"sub rsp, 64\", \
         \"mov qword ptr [rsp + 56], 0\", \"{instruction}\", \"mov rsp, rax\") }};"
    )
}

#[test]
fn what_an_aligned_stack_may_share_with_the_caller_is_found() {
    for address in ["rsp + 64", "rsp + 96", "rax - 16"] {
        let fault = on_an_aligned_stack(&format!("mov qword ptr [{address}], 0"));
        let expected = [of_mass_matrix(What::Stack)];
        assert_eq!(broken(&fault), expected, "{address}");
    }
}

/// Calls the sines of what `q` refers to, keeps `q` on the stack at an address meanwhile, and reads what is there; 64
/// bytes of sines and cosines are written. The function has 256 bytes of the stack, or a few more.
fn kept_across_sines(kept: &str, written: &str) -> String {
    format!(
        "unsafe {{ core::arch::asm!(\"mov rsi, {{q}}\", \"sub rsp, 256\", \"mov [{kept}], rsi\", \
         \"lea rdi, [{written}]\", \"call {{sines}}\", \"mov rax, [{kept}]\", \"mov rax, [rax]\", \
         \"add rsp, 256\", q = in(reg) q, sines = sym <f64 as kane::Real>::sin_cos_array::<4>, \
         clobber_abi(\"C\")) }};"
    )
}

#[test]
fn an_address_that_a_callee_has_overwritten_is_found() {
    for kept in ["rsp + 32", "rsp + 64", "rsp + 88", "rsp - 64"] {
        let fault = kept_across_sines(kept, "rsp + 32");
        assert_eq!(broken(&fault), [of_mass_matrix(What::Computed)], "{kept}");
    }
}

#[test]
fn memory_that_a_callee_may_not_be_given_is_found() {
    for written in ["rsp - 64", "rsp + 512"] {
        let fault = kept_across_sines("rsp + 16", written);
        assert_eq!(broken(&fault), [of_mass_matrix(What::Stack)], "{written}");
    }
}

#[test]
fn a_stack_that_is_not_as_it_was_is_found() {
    for instructions in ["\"push rax\"", "\"push ax\", \"add rsp, 8\""] {
        let fault = format!("unsafe {{ core::arch::asm!({instructions}) }};");
        assert_breaks(&fault, What::End);
    }
}

#[test]
fn the_clock_and_the_rounding_are_found() {
    for instruction in [
        "rdtsc",
        "ldmxcsr dword ptr [rsp - 8]",
        "fxsave64 [rdi]",
        "stmxcsr dword ptr [rsp - 8]",
        "fnstcw word ptr [rsp - 8]",
        "rdpid rax",
        "mfence",
        "std",
        "prefetcht0 byte ptr [rdi]",
        "mov eax, ds",
        "bt qword ptr [rdi], rcx",
        "ret 8",
        "rep stosb",
    ] {
        assert_breaks(
            &format!("unsafe {{ core::arch::asm!(\"{instruction}\") }};"),
            What::Strange,
        );
    }
}
