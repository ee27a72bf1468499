//! Seeded random systems, as descriptions.
//!
//! In: a seed, sizes and a style. Out: a [`RandomSystem`] that the generator accepts, the same on every machine.
//! Afterwards: free coordinates, locked values, roots, numbering, gravity, order and runtime values are all random; some
//! bodies are points, some weigh nothing, some are fixed; with [`Style::Framed`] also frames on both sides of joints, their
//! kinds, charts, speeds, mechanics and what follows what. Candidates with a coordinate that moves no mass are skipped.

mod body;
mod draw;
mod joints;
pub(crate) mod rotation;
pub(crate) mod trees;
pub(crate) mod variants;

use body::{Body, Number, list};

use kane_codegen::{
    description::toml,
    diagnostic::Source,
    tree::{self, Tree},
};

/// Seeded numbers: splitmix64.
#[derive(Clone, Debug)]
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// A number in `[low, high)`, in steps of the interval's 2^-53.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        low + (high - low) * unit
    }

    /// A number in `[-1, 1)`.
    pub(crate) fn symmetric(&mut self) -> f64 {
        self.between(-1.0, 1.0)
    }

    /// As [`Self::between`], with the few digits that a person would write.
    fn written(&mut self, low: f64, high: f64) -> f64 {
        (self.between(low, high) * 1000.0).round() / 1000.0
    }

    fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.bits() % end as u64).expect("it is below a usize")
    }

    fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }
}

/// How large a random system may be.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sizes {
    pub(crate) bodies: usize,
    /// Once there are so many speeds, the bodies that follow are fixed.
    pub(crate) speeds: usize,
}

/// What joints are like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Style {
    /// Lists of free coordinates between the bodies' own frames.
    Plain,
    /// Whatever a description can say.
    Framed,
}

/// A system, in an outward numbering of its own.
#[derive(Clone, Debug)]
pub(crate) struct RandomSystem {
    pub(crate) name: String,
    gravity: [Number; 3],
    order: &'static str,
    bodies: Vec<Body>,
    /// The place of each body in the file.
    places: Vec<usize>,
}

impl RandomSystem {
    /// The first acceptable system of a seed.
    pub(crate) fn new(seed: u64, sizes: Sizes, style: Style) -> Self {
        (0..1000)
            .map(|attempt| draw::candidate(seed, attempt, sizes, style))
            .find(|system| tree(&system.toml()).is_some())
            .expect("one of a thousand candidates moves mass with every coordinate")
    }

    /// The same system under another name.
    pub(crate) fn named(&self, name: &str) -> Self {
        Self {
            name: name.to_owned(),
            ..self.clone()
        }
    }

    /// The same system, its bodies listed in another order.
    pub(crate) fn renumbered(&self, seed: u64) -> Self {
        let mut random = Random::new(seed);
        Self {
            places: shuffled(&mut random, self.bodies.len()),
            ..self.clone()
        }
    }

    /// The same system, its coordinates in this order: "body" or "notes".
    pub(crate) fn ordered(&self, order: &'static str) -> Self {
        Self {
            order,
            ..self.clone()
        }
    }

    /// The same system with every value runtime, or none.
    pub(crate) fn with_runtime(&self, runtime: bool) -> Self {
        self.map(|number| Number { runtime, ..number })
    }

    /// The same tree with a small number in place of every zero: what runtime values cost shows only where baking folds none.
    pub(crate) fn without_zeros(&self) -> Self {
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
    pub(crate) fn changed(&self, seed: u64) -> Self {
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

    fn map(&self, mut f: impl FnMut(Number) -> Number) -> Self {
        let mut mapped = self.clone();
        let mut put = |number: &mut Number| *number = f(*number);
        mapped.gravity.iter_mut().for_each(&mut put);
        for body in &mut mapped.bodies {
            body.each_number(&mut put);
        }
        mapped
    }

    /// The description.
    pub(crate) fn toml(&self) -> String {
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
pub(crate) fn tree(text: &str) -> Option<Tree> {
    let description = toml::parse(&Source::new("random.toml", text));
    tree::build(&description).ok().map(|checked| checked.tree)
}

fn shuffled(random: &mut Random, n: usize) -> Vec<usize> {
    let mut places: Vec<usize> = (0..n).collect();
    for last in (1..n).rev() {
        places.swap(last, random.below(last + 1));
    }
    places
}
