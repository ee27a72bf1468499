//! What rustc makes of generated text: its tests run, and its machine code is read.
//!
//! These tests start compilers, each as many as there are processors.

mod beside;
#[cfg(all(feature = "object", target_arch = "x86_64", target_os = "linux"))]
mod object;
