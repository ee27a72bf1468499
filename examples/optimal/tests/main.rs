//! Derivatives held by traits, steps and their derivatives against differences, and what the examples achieve.

mod achievements;
mod steps;
mod traits;
