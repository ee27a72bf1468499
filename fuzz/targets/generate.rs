//! The whole path: any text, or any tree of a few bodies, to a module.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| kane_fuzz::generate(data));
