//! Any text as a model in our own format, TOML.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| kane_fuzz::read("model.toml", data));
