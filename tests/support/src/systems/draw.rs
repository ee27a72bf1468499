//! The drawing of bodies, in lists of free coordinates; [`joints`] makes of these whatever else a joint can be.

use super::{
    body::{Body, Joint, Number},
    joints,
    system::{RandomSystem, Sizes, Style, tree},
};
use crate::random::Random;

impl RandomSystem {
    /// The first acceptable system of a seed.
    pub fn new(seed: u64, sizes: Sizes, style: Style) -> Self {
        (0..1000)
            .map(|attempt| candidate(seed, attempt, sizes, style))
            .find(|system| tree(&system.toml()).is_some())
            .expect("one of a thousand candidates moves mass with every coordinate")
    }
}

fn candidate(seed: u64, attempt: u64, sizes: Sizes, style: Style) -> RandomSystem {
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
        bodies.push(body(random, number, lower, free));
    }
    let gravity = match random.below(4) {
        0 => [0.0; 3],
        1 => [0.0, 0.0, -9.81],
        _ => [0; 3].map(|_| random.written(-9.81, 9.81)),
    };
    let places = if random.chance(0.5) {
        (0..sizes.bodies).collect()
    } else {
        random.order(sizes.bodies)
    };
    let order = ["body", "notes"][random.below(2)];
    if style == Style::Framed {
        joints::frame(&mut bodies, random, sizes.speeds);
    }
    lift(&mut bodies, Random::new(seed));
    let system = RandomSystem {
        name: format!("random_{seed}"),
        gravity: gravity.map(Number::baked),
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

/// Lifts the weights of some bodies of some systems, or those of all alike.
fn lift(bodies: &mut [Body], mut random: Random) {
    let chance = match random.below(8) {
        0 => 0.5,
        1 => 1.0,
        _ => return,
    };
    let share = random.written(0.0, 1.5);
    for body in bodies {
        if random.chance(chance) {
            body.lifted = Some(Number::baked(if chance < 1.0 && random.chance(0.5) {
                random.written(-0.5, 1.0)
            } else {
                share
            }));
        }
    }
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

fn body(random: &mut Random, number: usize, lower: Option<usize>, free: [bool; 6]) -> Body {
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
    let attachment = attachment.map(Number::baked);
    Body {
        number,
        lower,
        mass: Number::baked(mass),
        mass_center: mass_center.map(Number::baked),
        inertia: inertia.map(Number::baked),
        inertia_rotation: None,
        lifted: None,
        joint: Joint::plain(attachment, free, locked),
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
