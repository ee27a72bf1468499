//! Two systems with their functions for C.

#[rustfmt::skip]
mod cart_pole;
#[rustfmt::skip]
mod cart_pole_c;
#[rustfmt::skip]
mod panda;
#[rustfmt::skip]
mod panda_c;
