//! Several numbers that one instruction reads: their distances from an address are constants, or nobody knows where they are.

use kane_codegen::object::{Report, What};

use super::{assert_holds, report};

/// A function with an instruction that reads two numbers at distances in `xmm0`, which comes from `load`.
fn gathering(load: &str, operands: &str) -> Report {
    report(&format!(
        "static DISTANCES: [i32; 4] = [8, 0, 8, 0];\n\
         #[inline(never)]\npub fn both<R: kane::Real>(q: &[R; 2], o: &mut [R; 1]) {{\n\
         unsafe {{ core::arch::asm!(\"{load}\", \"vpcmpeqd xmm2, xmm2, xmm2\", \"vgatherdpd xmm1, [{{q}} + xmm0], xmm2\", \
         q = in(reg) q, {operands} out(\"xmm0\") _, out(\"xmm1\") _, out(\"xmm2\") _) }};\n\
         o[0] = q[0];\n}}\n"
    ))
}

#[test]
fn distances_that_are_constants_are_known() {
    let report = gathering(
        "vmovdqu xmm0, [rip + {distances}]",
        "distances = sym DISTANCES,",
    );
    assert_holds(&report, "distances in a constant");
}

#[test]
fn distances_that_are_computed_are_not() {
    for load in [
        "vmovdqu xmm0, [{q}]",
        "vmovdqu xmm0, [rip + {distances}]\", \"vpaddd xmm0, xmm0, xmm0",
    ] {
        let operands = if load.contains("distances") {
            "distances = sym DISTANCES,"
        } else {
            ""
        };
        let report = gathering(load, operands);
        let breaches = report.functions[0].breaches.iter();
        let what: Vec<&What> = breaches.map(|breach| &breach.what).collect();
        assert_eq!(what, [&What::Computed], "{load}");
    }
}
