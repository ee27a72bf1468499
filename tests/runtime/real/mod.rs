//! Sine and cosine of `f64` and `f32`: error, range, symmetry, and the same bits lane by lane.
//!
//! Errors are in ulp of the exact result, against big floats of 128 bits, a table of 32 digits by another
//! program, and for `f32` against the `f64` pair. The bounds are those that the documentation states.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops where it cannot go on"
)]

mod astro;
mod table;

use core::f64::consts::FRAC_PI_2;

use kane::Real;
use kane_test_support::{
    compare::{assert_within, distance, larger},
    random::Random,
};

/// The largest error stated for `f64` below 16384, ulp.
const BOUND_F64: f64 = 0.85;
/// The largest error stated for `f32` below 10000, ulp.
const BOUND_F32: f64 = 0.8;
const SEED: u64 = 20_261_121;

/// The largest errors of sine and cosine seen, ulp, and where.
#[derive(Debug, Default)]
struct Worst {
    sine: (f64, f64),
    cosine: (f64, f64),
}

impl Worst {
    fn note(&mut self, x: f64, sine: f64, cosine: f64) {
        for (worst, error) in [(&mut self.sine, sine), (&mut self.cosine, cosine)] {
            assert!(error.is_finite(), "error {error} at {x:e}");
            if error > worst.0 {
                *worst = (error, x);
            }
        }
    }

    #[expect(
        clippy::print_stderr,
        reason = "shown where the bound is breached, and on request"
    )]
    fn require(&self, bound: f64) {
        eprintln!("{self:?} (seed {SEED})");
        assert!(
            self.sine.0 < bound && self.cosine.0 < bound,
            "{self:?} above {bound}"
        );
    }
}

/// One unit in the last place of an `f64`, from its binade; the least subnormal for 0.
fn ulp_f64(x: f64) -> f64 {
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    if exponent > 52 {
        f64::from_bits((exponent - 52) << 52)
    } else {
        f64::from_bits(1 << exponent.saturating_sub(1))
    }
}

/// One unit in the last place that an `f32` near `x` has.
fn ulp_f32(x: f64) -> f64 {
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    // 2^-149 is the least subnormal of f32.
    f64::from_bits(exponent.saturating_sub(23).max(1023 - 149) << 52)
}

fn against_big_floats(points: impl Iterator<Item = f64>) -> Worst {
    let mut reference = astro::Reference::new();
    let mut worst = Worst::default();
    for x in points {
        let (sine, cosine) = <f64 as Real>::sin_cos(x);
        let [sine, cosine] = reference.errors(x, sine, cosine);
        worst.note(x, sine.ulp, cosine.ulp);
    }
    worst
}

#[test]
fn f64_error_at_random_angles_is_below_the_bound() {
    let mut random = Random::new(SEED);
    let uniform = (0..50_000).map(move |_| 16384.0 * random.symmetric());
    against_big_floats(uniform).require(BOUND_F64);
}

#[test]
fn f64_error_at_random_magnitudes_is_below_the_bound() {
    let mut random = Random::new(SEED + 1);
    // Every binade from 2^-40 to 2^14 alike.
    let points = (0..50_000).map(move |_| {
        let exponent = random.symmetric().mul_add(27.0, -13.0);
        exponent.exp2() * random.symmetric().signum()
    });
    against_big_floats(points).require(BOUND_F64);
}

#[test]
fn f64_error_near_multiples_of_a_right_angle_is_below_the_bound() {
    // Around 0 the neighbours are subnormal, which big floats do not know.
    let points = (-6367_i32..=6367).filter(|&n| n != 0).flat_map(|n| {
        let nearest = f64::from(n) * FRAC_PI_2;
        [nearest.next_down(), nearest, nearest.next_up()]
    });
    against_big_floats(points).require(BOUND_F64);
}

#[test]
fn f64_error_where_the_quadrant_changes_is_below_the_bound() {
    let points = (-6367_i32..=6367).flat_map(|n| {
        let turn = (f64::from(n) + 0.5) * FRAC_PI_2;
        [turn.next_down(), turn, turn.next_up()]
    });
    against_big_floats(points).require(BOUND_F64);
}

#[test]
fn f64_error_of_tiny_angles_is_below_the_bound() {
    let mut random = Random::new(SEED + 2);
    // From 2^-1000 to 2^-26 in the normal range; big floats know no subnormals.
    let points = (0..5_000).map(move |_| random.symmetric().mul_add(487.0, -513.0).exp2());
    against_big_floats(points).require(BOUND_F64);
}

#[test]
fn the_largest_known_errors_of_f64_are_below_the_bound() {
    // Found among 8e8 angles whose squares round badly.
    let known = [
        0x40ab_eca8_deb3_857d,
        0x40a4_9f6a_0c9c_e573,
        0x40bb_6fd2_20da_eaec,
    ];
    let worst = against_big_floats(known.into_iter().map(f64::from_bits));
    assert!(worst.sine.0 > 0.8 && worst.cosine.0 > 0.8, "{worst:?}");
    worst.require(BOUND_F64);
}

#[test]
fn f64_agrees_with_the_table() {
    let mut worst = Worst::default();
    for &[x, sine, sine_tail, cosine, cosine_tail] in table::TABLE {
        let (s, c) = <f64 as Real>::sin_cos(x);
        let error = |value: f64, head: f64, tail: f64| {
            // A tail toward zero from a power of two: the exact value lies in the binade below.
            let exact = if head * tail < 0.0 {
                head * (1.0 - f64::EPSILON / 2.0)
            } else {
                head
            };
            ((value - head) - tail).abs() / ulp_f64(exact)
        };
        worst.note(x, error(s, sine, sine_tail), error(c, cosine, cosine_tail));
    }
    worst.require(BOUND_F64);
}

#[test]
fn f64_error_beyond_the_range_is_that_of_a_neighbouring_angle() {
    let mut reference = astro::Reference::new();
    let mut random = Random::new(SEED + 3);
    for _ in 0..5_000 {
        let x = random.symmetric().mul_add(8.0, 22.0).exp2();
        let (sine, cosine) = <f64 as Real>::sin_cos(x);
        let [sine, cosine] = reference.errors(x, sine, cosine);
        let error = larger(sine.absolute, cosine.absolute);
        assert_within(x, error, 0.5 * ulp_f64(x) + 1e-16);
    }
}

#[test]
fn f32_error_beyond_the_range_is_that_of_a_neighbouring_angle() {
    let mut random = Random::new(SEED + 9);
    for _ in 0..100_000 {
        let x = <f32 as Real>::from_f64(65_536.0 * random.symmetric());
        let (sine, cosine) = <f32 as Real>::sin_cos(x);
        let (s, c) = <f64 as Real>::sin_cos(f64::from(x));
        let error = distance(&[f64::from(sine), f64::from(cosine)], &[s, c]);
        assert_within(x, error, 0.5 * ulp_f32(f64::from(x)) + 1e-7);
    }
}

fn note_f32(worst: &mut Worst, x: f32) {
    let (sine, cosine) = <f32 as Real>::sin_cos(x);
    let (s, c) = <f64 as Real>::sin_cos(f64::from(x));
    let error = |value: f32, exact: f64| (f64::from(value) - exact).abs() / ulp_f32(exact);
    worst.note(f64::from(x), error(sine, s), error(cosine, c));
}

#[test]
fn f32_error_is_below_the_bound() {
    let mut worst = Worst::default();
    // A prime stride through the bits of every float from 0 to 1e4, subnormals included.
    for bits in (0..=10_000_f32.to_bits()).step_by(997) {
        note_f32(&mut worst, f32::from_bits(bits));
        note_f32(&mut worst, -f32::from_bits(bits));
    }
    worst.require(BOUND_F32);
}

#[test]
fn f32_error_near_multiples_of_half_a_right_angle_is_below_the_bound() {
    let mut worst = Worst::default();
    for n in -12_732_i32..=12_732 {
        let turn = <f32 as Real>::from_f64(f64::from(n) * FRAC_PI_2 / 2.0);
        for x in [turn.next_down(), turn, turn.next_up()] {
            note_f32(&mut worst, x);
        }
    }
    worst.require(BOUND_F32);
}

#[test]
fn results_of_finite_arguments_lie_between_minus_one_and_one() {
    let mut random = Random::new(SEED + 4);
    let special = [
        1e300,
        f64::MAX,
        f64::MIN,
        1e22,
        1_073_741_824.0,
        f64::MIN_POSITIVE,
    ];
    let any = core::iter::repeat_with(|| f64::from_bits(random.bits()));
    for x in special
        .into_iter()
        .chain(any.take(500_000))
        .filter(|x| x.is_finite())
    {
        let (s, c) = <f64 as Real>::sin_cos(x);
        assert!(s.abs() <= 1.0 && c.abs() <= 1.0, "{x:e}: {s} {c}");
    }
    let special = [1e30, f32::MAX, f32::MIN, 65_536.0];
    let any = core::iter::repeat_with(|| f32::from_bits((random.bits() >> 32) as u32));
    for x in special
        .into_iter()
        .chain(any.take(500_000))
        .filter(|x| x.is_finite())
    {
        let (s, c) = <f32 as Real>::sin_cos(x);
        assert!(s.abs() <= 1.0 && c.abs() <= 1.0, "{x:e}: {s} {c}");
    }
}

#[test]
fn results_between_the_range_and_the_cut_stay_on_the_unit_circle() {
    let mut random = Random::new(SEED + 5);
    for _ in 0..100_000 {
        let x = 1_073_741_824.0 * random.symmetric();
        let (s, c) = <f64 as Real>::sin_cos(x);
        assert!((s * s + c * c - 1.0).abs() < 1e-15, "{x}");
        let x = <f32 as Real>::from_f64(65_536.0 * random.symmetric());
        let (s, c) = <f32 as Real>::sin_cos(x);
        assert!((s * s + c * c - 1.0).abs() < 5e-7, "{x}: {s} {c}");
    }
}

#[test]
fn infinities_and_nan_give_nan() {
    for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -f64::NAN] {
        let (s, c) = <f64 as Real>::sin_cos(x);
        assert!(s.is_nan() && c.is_nan(), "{x}");
        let (s, c) = <f32 as Real>::sin_cos(<f32 as Real>::from_f64(x));
        assert!(s.is_nan() && c.is_nan(), "{x}");
    }
}

#[test]
fn tiny_angles_are_their_own_sine() {
    for x in [
        0.0,
        -0.0,
        5e-324,
        -5e-324,
        1e-310,
        f64::MIN_POSITIVE,
        -1e-300,
        1e-9,
    ] {
        let (s, c) = <f64 as Real>::sin_cos(x);
        assert_eq!((s.to_bits(), c), (x.to_bits(), 1.0), "{x:e}");
    }
    for x in [
        0.0,
        -0.0,
        1e-45,
        -1e-45,
        1e-40,
        f32::MIN_POSITIVE,
        -1e-30,
        1e-5,
    ] {
        let (s, c) = <f32 as Real>::sin_cos(x);
        assert_eq!((s.to_bits(), c), (x.to_bits(), 1.0), "{x:e}");
    }
}

#[test]
fn sine_is_odd_and_cosine_even() {
    let mut random = Random::new(SEED + 6);
    for _ in 0..100_000 {
        let x = 20_000.0 * random.symmetric();
        let ((s, c), (t, d)) = (<f64 as Real>::sin_cos(x), <f64 as Real>::sin_cos(-x));
        assert_eq!(
            (s.to_bits(), c.to_bits()),
            ((-t).to_bits(), d.to_bits()),
            "{x}"
        );
        let x = <f32 as Real>::from_f64(x);
        let ((s, c), (t, d)) = (<f32 as Real>::sin_cos(x), <f32 as Real>::sin_cos(-x));
        assert_eq!(
            (s.to_bits(), c.to_bits()),
            ((-t).to_bits(), d.to_bits()),
            "{x}"
        );
    }
}

fn lanes_are_scalars<const N: usize>(random: &mut Random) {
    let angles: [f64; N] = core::array::from_fn(|_| 1e4 * random.symmetric());
    let (sines, cosines) = f64::sin_cos_array(angles);
    for (lane, angle) in angles.into_iter().enumerate() {
        let (s, c) = <f64 as Real>::sin_cos(angle);
        assert_eq!(
            (sines[lane].to_bits(), cosines[lane].to_bits()),
            (s.to_bits(), c.to_bits())
        );
    }
    let angles = angles.map(<f32 as Real>::from_f64);
    let (sines, cosines) = f32::sin_cos_array(angles);
    for (lane, angle) in angles.into_iter().enumerate() {
        let (s, c) = <f32 as Real>::sin_cos(angle);
        assert_eq!(
            (sines[lane].to_bits(), cosines[lane].to_bits()),
            (s.to_bits(), c.to_bits())
        );
    }
}

#[test]
fn arrays_have_the_bits_of_their_lanes() {
    let mut random = Random::new(SEED + 7);
    for _ in 0..1_000 {
        lanes_are_scalars::<0>(&mut random);
        lanes_are_scalars::<1>(&mut random);
        lanes_are_scalars::<2>(&mut random);
        lanes_are_scalars::<3>(&mut random);
        lanes_are_scalars::<4>(&mut random);
        lanes_are_scalars::<7>(&mut random);
        lanes_are_scalars::<9>(&mut random);
        lanes_are_scalars::<10>(&mut random);
        lanes_are_scalars::<12>(&mut random);
        lanes_are_scalars::<16>(&mut random);
        lanes_are_scalars::<18>(&mut random);
        lanes_are_scalars::<20>(&mut random);
        lanes_are_scalars::<31>(&mut random);
    }
}

/// `x = 1 + 2^-30` has a square that f64 does not hold, and `1 + 2^-15` one that f32 does not.
#[test]
fn mul_add_rounds_once_exactly_where_the_hardware_does() {
    let (x, y) = (1.0 + (-30_f64).exp2(), 1.0 + (-15_f32).exp2());
    let fused = cfg!(all(
        feature = "std",
        any(target_feature = "fma", target_arch = "aarch64")
    ));
    assert_eq!(Real::mul_add(x, x, -(x * x)) != 0.0, fused);
    assert_eq!(Real::mul_add(y, y, -(y * y)) != 0.0, fused);
}

#[test]
fn mul_add_of_exact_products_is_the_same_everywhere() {
    let mut random = Random::new(SEED + 10);
    for _ in 0..10_000 {
        // 26 bits and 11 bits: their products are exact.
        let half = |random: &mut Random| (random.symmetric() * 67_108_864.0).trunc();
        let (a, b, c) = (half(&mut random), half(&mut random), random.symmetric());
        assert_eq!(Real::mul_add(a, b, c).to_bits(), (a * b + c).to_bits());
        let short =
            |random: &mut Random| <f32 as Real>::from_f64((random.symmetric() * 2048.0).trunc());
        let (a, b) = (short(&mut random), short(&mut random));
        let c = <f32 as Real>::from_f64(c);
        assert_eq!(Real::mul_add(a, b, c).to_bits(), (a * b + c).to_bits());
    }
}

/// The bits themselves: another machine or compiler must give the same.
#[test]
fn bits_are_the_same_everywhere() {
    let mut random = Random::new(SEED + 8);
    let mut hash = 0_u64;
    for _ in 0..100_000 {
        let x = 1e4 * random.symmetric();
        let (s, c) = <f64 as Real>::sin_cos(x);
        let (t, d) = <f32 as Real>::sin_cos(<f32 as Real>::from_f64(x));
        for bits in [
            s.to_bits(),
            c.to_bits(),
            u64::from(t.to_bits()),
            u64::from(d.to_bits()),
        ] {
            hash = (hash.rotate_left(5) ^ bits).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        }
    }
    assert_eq!(hash, 0xefca_99b9_0acc_d2b2, "{hash:#x}");
}
