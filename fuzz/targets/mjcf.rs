//! Any text as a model in MJCF.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| kane_fuzz::read("model.xml", data));
