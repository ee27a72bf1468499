//! A random system, and its text.

use kane_codegen::{
    description::toml,
    diagnostic::Source,
    tree::{self, Tree},
};

use super::body::{Body, Number, list};
use crate::random::Random;

/// How large a random system may be.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    pub bodies: usize,
    /// Once there are so many speeds, the bodies that follow are fixed.
    pub speeds: usize,
}

/// What joints are like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Lists of free coordinates between the bodies' own frames.
    Plain,
    /// Whatever a description can say.
    Framed,
}

/// A system, in an outward numbering of its own.
#[derive(Clone, Debug)]
pub struct RandomSystem {
    pub name: String,
    pub(super) gravity: [Number; 3],
    pub(super) order: &'static str,
    pub(super) bodies: Vec<Body>,
    /// The place of each body in the file.
    pub(super) places: Vec<usize>,
}

impl RandomSystem {
    /// The same system under another name.
    #[must_use]
    pub fn named(&self, name: &str) -> Self {
        Self {
            name: name.to_owned(),
            ..self.clone()
        }
    }

    /// The same system, its bodies listed in another order.
    #[must_use]
    pub fn renumbered(&self, seed: u64) -> Self {
        Self {
            places: Random::new(seed).order(self.bodies.len()),
            ..self.clone()
        }
    }

    /// The same system, its coordinates in this order: "body" or "notes".
    #[must_use]
    pub fn ordered(&self, order: &'static str) -> Self {
        Self {
            order,
            ..self.clone()
        }
    }

    /// The same system with every value runtime, or none.
    #[must_use]
    pub fn with_runtime(&self, runtime: bool) -> Self {
        self.map(|number| Number { runtime, ..number })
    }

    /// The same tree with a small number in place of every zero: what runtime values cost shows only where baking folds none.
    #[must_use]
    pub fn without_zeros(&self) -> Self {
        let mut filled = self.clone();
        let mut next = Random::new(self.bodies.len() as u64);
        let mut fill = |numbers: &mut [Number], low: f64, high: f64| {
            for number in numbers.iter_mut().filter(|number| number.value == 0.0) {
                number.value = next.written(low, high);
            }
        };
        fill(&mut filled.gravity, -9.81, 9.81);
        for body in &mut filled.bodies {
            fill(std::slice::from_mut(&mut body.mass), 0.5, 4.0);
            fill(&mut body.mass_center, 0.1, 0.5);
            // Nearly equal moments and small products: those of a body.
            fill(&mut body.inertia[..3], 0.05, 0.06);
            fill(&mut body.inertia[3..], 0.001, 0.004);
            let joint = &mut body.joint;
            fill(&mut joint.attachment, 0.1, 1.0);
            if let Some(attachment) = &mut joint.body_attachment {
                fill(attachment, 0.1, 1.0);
            }
        }
        filled
    }

    /// The same tree with every length, mass and inertia some per cent away.
    #[must_use]
    pub fn changed(&self, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let mut changed = self.map(|number| number);
        let mut scale = |numbers: &mut [Number], of_each: bool| {
            let mut factor = random.between(0.8, 1.25);
            for number in numbers {
                number.value *= factor;
                if of_each {
                    factor = random.between(0.8, 1.25);
                }
            }
        };
        scale(&mut changed.gravity, true);
        for body in &mut changed.bodies {
            scale(std::slice::from_mut(&mut body.mass), true);
            scale(&mut body.mass_center, true);
            // One factor for the tensor: it stays that of a body.
            scale(&mut body.inertia, false);
            scale(&mut body.joint.attachment, true);
        }
        changed
    }

    pub(super) fn map(&self, mut f: impl FnMut(Number) -> Number) -> Self {
        let mut mapped = self.clone();
        let mut put = |number: &mut Number| *number = f(*number);
        mapped.gravity.iter_mut().for_each(&mut put);
        for body in &mut mapped.bodies {
            body.each_number(&mut put);
        }
        mapped
    }

    /// The description.
    pub fn toml(&self) -> String {
        let mut at = vec![0; self.bodies.len()];
        for (body, place) in self.places.iter().enumerate() {
            at[*place] = body;
        }
        let lower: Vec<usize> = at
            .iter()
            .map(|&body| {
                self.bodies[body]
                    .lower
                    .map_or(0, |lower| self.places[lower] + 1)
            })
            .collect();
        let mut text = format!(
            "name = \"{}\"\ngravity = {}\nlower_bodies = {lower:?}\norder = \"{}\"\n",
            self.name,
            list(&self.gravity),
            self.order
        );
        for body in at {
            let body = &self.bodies[body];
            let leader = body.joint.mimic.map(|mimic| mimic.leader);
            text += &body.toml(leader.map(|leader| self.bodies[leader].joint_name()));
        }
        text
    }
}

/// The tree of a description, unless it is refused.
pub fn tree(text: &str) -> Option<Tree> {
    let description = toml::parse(&Source::new("random.toml", text));
    tree::build(&description).ok().map(|checked| checked.tree)
}
