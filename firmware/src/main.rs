//! Generated functions at stored states: on a microcontroller it prints the bits of their results and what they cost, on the
//! host it has the same results and compares.

#![cfg_attr(target_os = "none", no_std, no_main)]

mod calls;

#[cfg(target_os = "none")]
mod board;

#[cfg(not(target_os = "none"))]
mod elf;
#[cfg(not(target_os = "none"))]
mod host;

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    host::main()
}
