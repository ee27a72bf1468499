//! Steps and their derivatives against differences, and what the examples achieve.

mod achievements;
mod steps;
