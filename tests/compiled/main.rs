//! What compilers make of the runtime and of generated text: machine code without branches, and the bits of Rust in C.

#[cfg(all(target_arch = "x86_64", not(miri)))]
mod assembly;
mod c;
