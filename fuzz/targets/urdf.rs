//! Any text as a model in URDF.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| kane_fuzz::read("model.urdf", data));
