//! Two systems with their functions for C.

#[rustfmt::skip]
#[path = "../generated/cart_pole.rs"]
mod cart_pole;
#[rustfmt::skip]
#[path = "../generated/cart_pole_c.rs"]
mod cart_pole_c;
#[rustfmt::skip]
#[path = "../generated/panda.rs"]
mod panda;
#[rustfmt::skip]
#[path = "../generated/panda_c.rs"]
mod panda_c;
