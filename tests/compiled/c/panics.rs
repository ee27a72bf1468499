//! The functions for C, optimized, and what they call of the runtime cannot panic: nothing of a panic is linked into their program.

use std::{fs, path::Path, process::Command};

use super::{folder, headers, run};

/// What a name of every function that panics has in it: those of `core::panicking`.
const PANICKING: &[u8] = b"panicking";

#[test]
fn functions_for_c_of_a_floating_robot_cannot_panic() {
    let folder = folder("panics");
    let generated = headers::module_of("claw", headers::CLAW, headers::derivatives(true));
    for (path, text) in generated.files(&folder.join("claw.rs")) {
        fs::write(path, text).unwrap();
    }
    let source = folder.join("lib.rs");
    fs::write(&source, "#![no_std]\npub mod claw;\npub mod claw_c;\n").unwrap();
    for level in ["2", "s"] {
        let object = object(&source, &folder.join(level), level);
        let has = |name: &[u8]| object.windows(name.len()).any(|part| part == name);
        assert!(has(b"claw_rk4_linearized_f64"));
        assert!(!has(PANICKING), "`opt-level = \"{level}\"`");
    }
}

/// The machine code of a library with modules, and with what they call of the runtime, where a panic aborts.
fn object(source: &Path, folder: &Path, level: &str) -> Vec<u8> {
    fs::create_dir_all(folder).unwrap();
    let rustc = |name: &str, source: &Path, emit: &str| {
        let mut command = Command::new("rustc");
        command
            .args(["--edition=2024", "--crate-type=lib", "--cap-lints=allow"])
            .args(["-Cpanic=abort", "-Ccodegen-units=1", "--crate-name", name])
            .args([&format!("-Copt-level={level}"), emit, "--out-dir"])
            .args([folder, source])
            .arg("--extern")
            .arg(format!("kane={}", folder.join("libkane.rmeta").display()));
        run(&mut command);
    };
    let runtime = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs");
    rustc("kane", &runtime, "--emit=metadata,obj");
    rustc("claw", source, "--emit=obj");
    fs::read(folder.join("claw.o")).unwrap()
}
