//! Systems small enough to write by hand.

mod arrays;
mod cart_pole;
mod faulty;
mod gimbal;
mod one_coordinate;
mod oscillator;
mod pendulum;
mod turning;

pub(crate) use arrays::arrays;
pub(crate) use cart_pole::CartPole;
pub(crate) use faulty::{Faulty, Wrong};
pub(crate) use gimbal::Gimbal;
pub(crate) use one_coordinate::one_coordinate;
pub(crate) use oscillator::Oscillator;
pub(crate) use pendulum::Pendulum;
pub(crate) use turning::Turning;
