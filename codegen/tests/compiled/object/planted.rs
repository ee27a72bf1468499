//! Faults that are planted in a function are found. All of them are compiled together, each in a copy of its own: `rustc`
//! takes longer to start than for any of them.

use std::{fs, sync::OnceLock};

use kane_codegen::object::{Report, What};

use super::{report, repository};

/// A function with a fault.
struct Planted {
    /// What is wrong, in words.
    of: &'static str,
    /// What stands before the function's own statements; `ADDRESS` is a number that nobody knows.
    fault: String,
    /// The promise that it breaks; `FUNCTION` is the function's name.
    what: What,
    /// True where it breaks no other promise.
    is_only: bool,
}

fn planted() -> Vec<Planted> {
    let one = |of, fault: &str, what| Planted {
        of,
        fault: fault.to_owned(),
        what,
        is_only: false,
    };
    let assembly = |of, instructions: &str, what| Planted {
        of,
        fault: format!("unsafe {{ core::arch::asm!({instructions}) }};"),
        what,
        is_only: true,
    };
    let mut planted = in_rust(one);
    planted.extend(of_the_stack(assembly));
    planted.extend(of_aligned_stacks(assembly));
    planted.extend(of_callees(assembly));
    planted.extend(strange(assembly));
    planted
}

fn in_rust(one: impl Fn(&'static str, &str, What) -> Planted) -> Vec<Planted> {
    let count = What::Static(Some("generated::module::FUNCTION::COUNT".to_owned()));
    vec![
        one("branch", "if ADDRESS & 64 == 0 { return; }", What::Jump),
        one(
            "loop",
            "for _ in 0..ADDRESS >> 3 & 7 { m[0][1] = m[0][1] * q[0]; }",
            What::Jump,
        ),
        one(
            "panic",
            "m[0][1] = q[ADDRESS >> 3 & 3];",
            What::Panic("core::panicking::panic_bounds_check".to_owned()),
        ),
        one(
            "call",
            "#[inline(never)] fn square<R: kane::Real>(x: R) -> R { x * x } m[0][1] = square(q[0]);",
            What::Call("generated::module::FUNCTION::square::<f64>".to_owned()),
        ),
        one(
            "pointer",
            "pub static HOOK: core::sync::atomic::AtomicUsize = core::sync::atomic::AtomicUsize::new(0);\n\
             unsafe { core::mem::transmute::<usize, fn()>(HOOK.load(core::sync::atomic::Ordering::Relaxed))() }",
            What::Call("?".to_owned()),
        ),
        one(
            "written static",
            "pub static COUNT: core::sync::atomic::AtomicU32 = core::sync::atomic::AtomicU32::new(0);\n\
             COUNT.store(1, core::sync::atomic::Ordering::Relaxed);",
            count.clone(),
        ),
        one(
            "read static",
            "pub static COUNT: core::sync::atomic::AtomicU32 = core::sync::atomic::AtomicU32::new(0);\n\
             m[0][1] = R::from_f64(f64::from(COUNT.load(core::sync::atomic::Ordering::Relaxed)));",
            count,
        ),
        one(
            "address from values",
            "m[0][1] = q[ADDRESS >> 3 & 1];",
            What::Computed,
        ),
        one(
            "fixed address",
            "unsafe { core::ptr::without_provenance_mut::<u32>(0x4000_0000).write_volatile(1) };",
            What::Absolute,
        ),
    ]
}

fn of_the_stack(assembly: impl Fn(&'static str, &str, What) -> Planted) -> Vec<Planted> {
    let mut planted = vec![
        assembly(
            "thread",
            "\"mov {}, qword ptr fs:[0]\", out(reg) _",
            What::Segment,
        ),
        assembly("caller", "\"mov qword ptr [rsp + 4096], 0\"", What::Stack),
        assembly("below", "\"mov qword ptr [rsp - 4096], 0\"", What::Stack),
    ];
    for mask in ["rcx", "0xff", "-24"] {
        let instructions = format!(
            "\"mov rax, rsp\", \"and rsp, {mask}\", \"mov qword ptr [rsp], 0\", \"mov rsp, rax\""
        );
        planted.push(assembly("moved", &instructions, What::Computed));
    }
    for instructions in ["\"push rax\"", "\"push ax\", \"add rsp, 8\""] {
        planted.push(Planted {
            is_only: false,
            ..assembly("not as it was", instructions, What::End)
        });
    }
    planted
}

/// On an aligned stack, of which `rax` keeps where it was.
fn of_aligned_stacks(assembly: impl Fn(&'static str, &str, What) -> Planted) -> Vec<Planted> {
    let addresses = ["rsp + 64", "rsp + 96", "rax - 16"].into_iter();
    let planted = addresses.map(|address| {
        let instructions = format!(
            "\"mov rax, rsp\", \"and rsp, -64\", \"sub rsp, 64\", \"mov qword ptr [rsp + 56], 0\", \
             \"mov qword ptr [{address}], 0\", \"mov rsp, rax\""
        );
        assembly("aligned", &instructions, What::Stack)
    });
    planted.collect()
}

/// Calls the sines of what `q` refers to, keeps `q` on the stack at an address meanwhile, and reads what is there; 64
/// bytes of sines and cosines are written. The function has 256 bytes of the stack, or a few more.
fn of_callees(assembly: impl Fn(&'static str, &str, What) -> Planted) -> Vec<Planted> {
    let across_sines = |kept: &str, written: &str| {
        format!(
            "\"mov rsi, {{q}}\", \"sub rsp, 256\", \"mov [{kept}], rsi\", \
             \"lea rdi, [{written}]\", \"call {{sines}}\", \"mov rax, [{kept}]\", \"mov rax, [rax]\", \
             \"add rsp, 256\", q = in(reg) q, sines = sym <f64 as kane::Real>::sin_cos_array::<4>, \
             clobber_abi(\"C\")"
        )
    };
    let kept = ["rsp + 32", "rsp + 64", "rsp + 88", "rsp - 64"].into_iter();
    let overwritten = kept.map(|kept| {
        let instructions = across_sines(kept, "rsp + 32");
        assembly("overwritten", &instructions, What::Computed)
    });
    let written = ["rsp - 64", "rsp + 512"].into_iter();
    let given = written.map(|written| {
        let instructions = across_sines("rsp + 16", written);
        assembly("given", &instructions, What::Stack)
    });
    overwritten.chain(given).collect()
}

fn strange(assembly: impl Fn(&'static str, &str, What) -> Planted) -> Vec<Planted> {
    let instructions = [
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
    ];
    let planted = instructions.map(|instruction| Planted {
        is_only: false,
        ..assembly("strange", &format!("\"{instruction}\""), What::Strange)
    });
    planted.into()
}

fn name(place: usize) -> String {
    format!("mass_matrix_{place}")
}

/// The report on the cart and the pole with a copy of `mass_matrix` for each fault.
fn faulty() -> &'static Report {
    static REPORT: OnceLock<Report> = OnceLock::new();
    REPORT.get_or_init(|| {
        let mut text = fs::read_to_string(repository("generated/cart_pole.rs")).unwrap();
        let start = text.find("#[inline(never)]\npub fn mass_matrix<").unwrap();
        let end = start + text[start..].find("\n}\n").unwrap() + 3;
        let function = text[start..end].to_owned();
        let first = "    m[0][0] = p.mass_matrix_cart_k1;\n";
        assert!(function.contains(first));
        for (place, Planted { fault, .. }) in planted().iter().enumerate() {
            let fault = fault.replace("ADDRESS", "core::ptr::from_ref(q).addr()");
            let own = format!("pub fn {}<", name(place));
            text += &function
                .replace("pub fn mass_matrix<", &own)
                .replace(first, &format!("{fault}\n{first}"));
        }
        report(&text)
    })
}

/// What is planted of this kind is found in its functions, as often as it is planted, and nothing in those that are sound.
fn assert_found(of: &str, times: usize) {
    let report = faulty();
    assert!(!report.holds());
    let mut found = 0;
    for (place, planted) in planted().into_iter().enumerate() {
        if planted.of != of {
            continue;
        }
        let name = name(place);
        let mut functions = report.functions.iter();
        let function = functions.find(|function| function.name == name).unwrap();
        let breaches = function.breaches.iter();
        let whats: Vec<What> = breaches.clone().map(|breach| breach.what.clone()).collect();
        let mut instructions = breaches.map(|breach| &breach.instruction);
        assert!(instructions.all(|instruction| !instruction.is_empty()));
        let expected = match planted.what {
            What::Call(text) => What::Call(text.replace("FUNCTION", &name)),
            What::Static(text) => What::Static(text.map(|text| text.replace("FUNCTION", &name))),
            what => what,
        };
        assert!(whats.contains(&expected), "{}: {whats:?}", planted.fault);
        let n_others = whats.len() - 1;
        assert!(
            !planted.is_only || n_others == 0,
            "{}: {whats:?}",
            planted.fault
        );
        found += 1;
    }
    assert_eq!(found, times);
    let sound = report
        .all()
        .filter(|function| !function.name.starts_with("mass_matrix_"));
    for function in sound {
        assert!(function.breaches.is_empty(), "{}", function.name);
    }
}

#[test]
fn a_branch_is_found() {
    assert_found("branch", 1);
}

#[test]
fn a_loop_is_found() {
    assert_found("loop", 1);
}

#[test]
fn a_panic_is_found() {
    assert_found("panic", 1);
}

#[test]
fn a_call_is_found() {
    assert_found("call", 1);
}

#[test]
fn a_call_through_a_pointer_is_found() {
    assert_found("pointer", 1);
}

#[test]
fn a_static_that_is_written_is_found() {
    assert_found("written static", 1);
}

#[test]
fn a_static_that_is_read_is_found() {
    assert_found("read static", 1);
}

#[test]
fn an_address_from_values_is_found() {
    assert_found("address from values", 1);
}

#[test]
fn a_fixed_address_is_found() {
    assert_found("fixed address", 1);
}

#[test]
fn memory_of_the_thread_is_found() {
    assert_found("thread", 1);
}

#[test]
fn the_caller_s_stack_is_found() {
    assert_found("caller", 1);
}

#[test]
fn what_is_far_below_the_stack_is_found() {
    assert_found("below", 1);
}

#[test]
fn a_stack_that_is_moved_by_a_value_is_found() {
    assert_found("moved", 3);
}

#[test]
fn what_an_aligned_stack_may_share_with_the_caller_is_found() {
    assert_found("aligned", 3);
}

#[test]
fn an_address_that_a_callee_has_overwritten_is_found() {
    assert_found("overwritten", 4);
}

#[test]
fn memory_that_a_callee_may_not_be_given_is_found() {
    assert_found("given", 2);
}

#[test]
fn a_stack_that_is_not_as_it_was_is_found() {
    assert_found("not as it was", 2);
}

#[test]
fn the_clock_and_the_rounding_are_found() {
    assert_found("strange", 13);
}
