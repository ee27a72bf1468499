//! Lanes: every one has the bits of its scalar, in arithmetic, sines and generated functions.

#![allow(clippy::unwrap_used, reason = "a test stops where it cannot go on")]

mod entries;
mod generated;

use entries::{Bits, lanes_of, same};
use kane::wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use kane::{Lanes, Real};
use kane_test_support::random::Random;

const SEED: u64 = 20_261_122;

/// Numbers of which one in four is special: zeros, infinities, NaN, subnormals, the largest; one in four any at all; one
/// in four near a multiple of half a right angle, where the sines change their quadrant or vanish.
fn number<S: Real + Bits>(random: &mut Random) -> S {
    let special = [
        0.0,
        -0.0,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        5e-324,
        -1e-310,
        -1e-40,
        f64::MAX,
        1e38,
        -1e30,
        1_073_741_825.0,
        65_537.0,
    ];
    let half_right = core::f64::consts::FRAC_PI_4;
    match random.bits() % 4 {
        0 => S::from_f64(special[usize::try_from(random.bits() % 13).unwrap()]),
        1 => S::any(random.bits()),
        2 => S::from_f64((random.symmetric() * 10_000.0).round() * half_right),
        _ => S::from_f64(random.symmetric() * 10.0),
    }
}

fn check<L: Lanes>()
where
    L::Scalar: Bits,
{
    let mut random = Random::new(SEED);
    for _ in 0..20_000 {
        let mut numbers = || -> Vec<L::Scalar> {
            let numbers = (0..L::LANES).map(|_| number(&mut random));
            numbers.collect()
        };
        let (a, b, c) = (numbers(), numbers(), numbers());
        let [x, y, z] = [&a, &b, &c].map(|numbers| L::load(numbers));
        let (sine, cosine) = x.sin_cos();
        let (sines, cosines) = L::sin_cos_array([y, x, z]);
        for lane in 0..L::LANES {
            let [a, b, c] = [&a, &b, &c].map(|numbers| numbers[lane]);
            let (s, d) = a.sin_cos();
            for (what, found, expected) in [
                ("sine", sine, s),
                ("cosine", cosine, d),
                ("sine of an array", sines[1], s),
                ("cosine of an array", cosines[1], d),
                ("sum", x + y, a + b),
                ("difference", x - y, a - b),
                ("product", x * y, a * b),
                ("quotient", x / y, a / b),
                ("negative", -x, -a),
                ("magnitude", x.abs(), a.abs()),
                ("fused", x.mul_add(y, z), a.mul_add(b, c)),
            ] {
                let found = lanes_of(found)[lane];
                assert!(
                    same(found, expected),
                    "{what} of {a:?}, {b:?}, {c:?} is {expected:?}, in lane {lane} {found:?}"
                );
            }
        }
    }
    for value in [0.1, -0.0, 1e300, 1e-300] {
        let expected = L::Scalar::from_f64(value);
        let found = lanes_of(L::from_f64(value));
        assert!(found.iter().all(|&found| same(found, expected)), "{value}");
    }
}

macro_rules! bits_of_each {
    ($($name:ident: $lanes:ident;)+) => {$(
        #[test]
        fn $name() {
            check::<$lanes>();
        }
    )+};
}

bits_of_each! {
    two_f64_have_the_bits_of_each: f64x2;
    four_f64_have_the_bits_of_each: f64x4;
    eight_f64_have_the_bits_of_each: f64x8;
    four_f32_have_the_bits_of_each: f32x4;
    eight_f32_have_the_bits_of_each: f32x8;
    sixteen_f32_have_the_bits_of_each: f32x16;
}

fn loaded<L: Lanes<Scalar = f64>>() {
    let values: Vec<f64> = (1..=2 * L::LANES).map(|value| value as f64).collect();
    for n in 0..=values.len() {
        let lanes = lanes_of(L::load(&values[..n]));
        for (lane, &found) in lanes.iter().enumerate() {
            assert_eq!(
                found,
                lane.min(n.wrapping_sub(1)).wrapping_add(1).min(n) as f64
            );
        }
        let mut stored = vec![0.0; n];
        L::load(&values).store(&mut stored);
        let written = n.min(L::LANES);
        assert_eq!(stored[..written], values[..written]);
        assert!(stored[written..].iter().all(|&value| value == 0.0));
    }
}

#[test]
fn missing_values_are_the_last_one_and_no_value_is_written_where_there_is_no_room() {
    loaded::<f64>();
    loaded::<f64x2>();
    loaded::<f64x4>();
    loaded::<f64x8>();
}
