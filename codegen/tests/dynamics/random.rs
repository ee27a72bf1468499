//! Seeded random systems, as descriptions.
//!
//! In: a seed and sizes. Out: a [`RandomSystem`] that the generator accepts, the same on every machine. Afterwards: free
//! coordinates, locked values, roots, numbering, gravity, order and runtime values are all random; some bodies are
//! points, some weigh nothing, some are fixed. Candidates with a coordinate that moves no mass are skipped.

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

/// A number, and whether it is written as a runtime value.
#[derive(Clone, Copy, Debug)]
struct Number {
    value: f64,
    runtime: bool,
}

#[derive(Clone, Debug)]
struct Body {
    lower: Option<usize>,
    mass: Number,
    mass_center: [Number; 3],
    /// xx, yy, zz, xy, xz, yz.
    inertia: [Number; 6],
    attachment: [Number; 3],
    free: [bool; 6],
    locked: [f64; 6],
}

const AXES: [&str; 6] = ["theta1", "theta2", "theta3", "s1", "s2", "s3"];
const COMPONENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];

impl RandomSystem {
    /// The first acceptable system of a seed.
    pub(crate) fn new(seed: u64, sizes: Sizes) -> Self {
        (0..1000)
            .map(|attempt| candidate(seed, attempt, sizes))
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
            fill(&mut body.attachment, 0.1, 1.0);
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
            scale(&mut body.attachment, true);
        }
        changed
    }

    fn map(&self, f: impl Fn(Number) -> Number) -> Self {
        let mut mapped = self.clone();
        mapped.gravity = mapped.gravity.map(&f);
        for body in &mut mapped.bodies {
            body.mass = f(body.mass);
            body.mass_center = body.mass_center.map(&f);
            body.inertia = body.inertia.map(&f);
            body.attachment = body.attachment.map(&f);
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
            text += &self.bodies[body].toml(body);
        }
        text
    }
}

/// The tree of a description, unless it is refused.
pub(crate) fn tree(text: &str) -> Option<Tree> {
    let description = toml::parse(&Source::new("random.toml", text));
    tree::build(&description).ok().map(|checked| checked.tree)
}

impl Body {
    fn toml(&self, number: usize) -> String {
        let free: Vec<&str> = (0..6)
            .filter(|&axis| self.free[axis])
            .map(|axis| AXES[axis])
            .collect();
        let locked: Vec<String> = (0..6)
            .filter(|&axis| !self.free[axis] && self.locked[axis] != 0.0)
            .map(|axis| format!("{} = {:?}", AXES[axis], self.locked[axis]))
            .collect();
        let inertia: Vec<String> = COMPONENTS
            .iter()
            .zip(&self.inertia)
            .map(|(name, component)| format!("{name} = {}", component.toml()))
            .collect();
        format!(
            "\n[[body]]\nname = \"b{number}\"\nmass = {}\nmass_center = {}\ninertia = {{ {} }}\nattachment = {}\njoint = {free:?}\nlocked = {{ {} }}\n",
            self.mass.toml(),
            list(&self.mass_center),
            inertia.join(", "),
            list(&self.attachment),
            locked.join(", ")
        )
    }
}

impl Number {
    fn toml(self) -> String {
        if self.runtime {
            format!("{{ runtime = {:?} }}", self.value)
        } else {
            format!("{:?}", self.value)
        }
    }
}

fn list(numbers: &[Number]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|number| number.toml()).collect();
    format!("[{}]", numbers.join(", "))
}

fn shuffled(random: &mut Random, n: usize) -> Vec<usize> {
    let mut places: Vec<usize> = (0..n).collect();
    for last in (1..n).rev() {
        places.swap(last, random.below(last + 1));
    }
    places
}

fn candidate(seed: u64, attempt: u64, sizes: Sizes) -> RandomSystem {
    let mut random = Random::new(seed.wrapping_mul(1000).wrapping_add(attempt));
    let random = &mut random;
    let is_runtime = [0.0, 0.3, 1.0][random.below(3)];
    // Long chains, bushes, and what lies between.
    let reach = [1, 3, sizes.bodies][random.below(3)];
    let mut n_speeds = 0;
    let mut bodies: Vec<Body> = Vec::new();
    for number in 0..sizes.bodies {
        let lower = if number == 0 || random.chance(0.1) {
            None
        } else {
            Some(number - 1 - random.below(reach.min(number)))
        };
        let free = free(random, lower.is_none(), sizes.speeds - n_speeds);
        n_speeds += free.iter().filter(|free| **free).count();
        bodies.push(body(random, lower, free));
    }
    let gravity = match random.below(4) {
        0 => [0.0; 3],
        1 => [0.0, 0.0, -9.81],
        _ => [0; 3].map(|_| random.written(-9.81, 9.81)),
    };
    let places = if random.chance(0.5) {
        (0..sizes.bodies).collect()
    } else {
        shuffled(random, sizes.bodies)
    };
    let order = ["body", "notes"][random.below(2)];
    let system = RandomSystem {
        name: format!("random_{seed}"),
        gravity: gravity.map(baked),
        order,
        bodies,
        places,
    };
    // Drawn by a generator of its own: the numbers do not depend on which of them are runtime values.
    let runtime = std::cell::RefCell::new(Random::new(!seed));
    system.map(|number| Number {
        runtime: runtime.borrow_mut().chance(is_runtime),
        ..number
    })
}

fn free(random: &mut Random, is_root: bool, most: usize) -> [bool; 6] {
    let kind = random.between(0.0, 1.0);
    let mut free = if kind < if is_root { 0.4 } else { 0.08 } {
        [true; 6]
    } else if kind < 0.5 {
        let axis = random.below(6);
        [0, 1, 2, 3, 4, 5].map(|other| other == axis)
    } else if kind < 0.6 {
        [true, true, true, false, false, false]
    } else {
        [0; 6].map(|_| random.chance(0.33))
    };
    let mut n_free = 0;
    for axis in &mut free {
        n_free += usize::from(*axis);
        *axis &= n_free <= most;
    }
    free
}

fn body(random: &mut Random, lower: Option<usize>, free: [bool; 6]) -> Body {
    let kind = random.between(0.0, 1.0);
    let (mass, inertia) = if kind < 0.06 {
        (0.0, [0.0; 6])
    } else if kind < 0.12 {
        (random.written(0.5, 4.0), [0.0; 6])
    } else {
        (random.written(0.5, 4.0), inertia(random))
    };
    let mut vector = |most: f64| {
        [0; 3].map(|_| {
            let value = random.written(-most, most);
            if random.chance(0.25) { 0.0 } else { value }
        })
    };
    let (mass_center, attachment) = (vector(0.5), vector(1.0));
    let locked = [0; 6].map(|_| {
        let value = random.written(-1.0, 1.0);
        if random.chance(0.5) { 0.0 } else { value }
    });
    Body {
        lower,
        mass: baked(mass),
        mass_center: mass_center.map(baked),
        inertia: inertia.map(baked),
        attachment: attachment.map(baked),
        free,
        locked,
    }
}

/// The tensor of three pairs of points on random axes: `trace(P) - P` for a positive definite `P`.
fn inertia(random: &mut Random) -> [f64; 6] {
    if random.chance(0.2) {
        let [a, b, c] = [0; 3].map(|_| random.written(0.02, 0.2));
        return [b + c, a + c, a + b, 0.0, 0.0, 0.0];
    }
    let l = [0; 3].map(|_| [0; 3].map(|_| random.written(-0.4, 0.4)));
    let p = |i: usize, j: usize| {
        let sum: f64 = (0..3).map(|k| l[i][k] * l[j][k]).sum();
        sum + if i == j { 0.02 } else { 0.0 }
    };
    let trace = p(0, 0) + p(1, 1) + p(2, 2);
    [
        trace - p(0, 0),
        trace - p(1, 1),
        trace - p(2, 2),
        -p(0, 1),
        -p(0, 2),
        -p(1, 2),
    ]
}

fn baked(value: f64) -> Number {
    Number {
        value,
        runtime: false,
    }
}
