//! Motions of unit time: against integrated rates, back again, and their derivatives against differences of order 12.

use kane::manifold::{TangentMap, q_minus, q_plus, scale_quaternions};
use kane::{Real, System};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    numeric::derivative,
    random::Random,
};

use crate::common::Turning;

type Q = [f64; 11];
type U = [f64; 10];
type Map = TangentMap<f64, Turning>;

/// Rounding of a few dozen operations on numbers about one.
const ROUNDED: Tolerance = Tolerance::absolute(4e-15);

/// Differences lose a digit and a half to the sums that they are of.
const DIFFERENCED: Tolerance = Tolerance::absolute(1e-11);

fn coordinates(random: &mut Random) -> Q {
    let mut q = [0; 11].map(|_| 1.2 * random.symmetric());
    let length = q[4..8].iter().map(|e| e * e).sum::<f64>().sqrt();
    for entry in &mut q[4..8] {
        *entry /= length;
    }
    q
}

/// A direction whose turns and shifts are of this size.
fn direction(random: &mut Random, size: f64) -> U {
    let mut d = [0; 10].map(|_| random.symmetric());
    for entries in [0..3, 3..6] {
        let length = d[entries.clone()].iter().map(|e| e * e).sum::<f64>().sqrt();
        for entry in &mut d[entries] {
            *entry *= size / length;
        }
    }
    for entry in &mut d[6..] {
        *entry *= size;
    }
    d
}

/// `q` after unit time by 2000 steps of order four.
fn integrated(q: &Q, u: &U) -> Q {
    let rate = |q: &Q| {
        let mut q_dot = [0.0; 11];
        Turning.q_dot(q, u, &mut q_dot);
        q_dot
    };
    let moved = |q: &Q, by: f64, rate: &Q| std::array::from_fn(|i| q[i] + by * rate[i]);
    let (mut q, dt) = (*q, 1.0 / 2000.0);
    for _ in 0..2000 {
        let a = rate(&q);
        let b = rate(&moved(&q, dt / 2.0, &a));
        let c = rate(&moved(&q, dt / 2.0, &b));
        let d = rate(&moved(&q, dt, &c));
        q = std::array::from_fn(|i| q[i] + dt / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
    }
    q
}

#[test]
fn unit_time_at_constant_speeds_leads_where_q_plus_does() {
    let mut random = Random::new(1);
    for size in [0.0, 1e-9, 0.01, 0.3, 0.7] {
        let mut q = coordinates(&mut random);
        // Where the angles stay clear of their singularity.
        q[1] *= 0.4;
        let u = direction(&mut random, size);
        let found = q_plus(&Turning, &q, &u);
        // The integration's own error: dt^4 times fifth derivatives, which the factor 1/cos(theta_2) makes some hundreds.
        let tolerance = Tolerance::absolute(1e-11);
        assert_close(size, &found, &integrated(&q, &u), tolerance);
    }
}

#[test]
fn q_minus_is_the_way_that_q_plus_went() {
    let mut random = Random::new(2);
    let sizes = [
        1e-300, 1e-40, 1e-16, 1e-12, 1e-8, 1e-4, 0.1, 1.0, 2.0, 3.0, 3.13,
    ];
    for size in sizes {
        for _ in 0..20 {
            let (q, d) = (coordinates(&mut random), direction(&mut random, size));
            let mut there = q_plus(&Turning, &q, &d);
            let found = q_minus(&Turning, &q, &there);
            assert_close(size, &found[3..], &d[3..], ROUNDED);
            for entry in &mut there[4..8] {
                *entry = -*entry;
            }
            let negative = q_minus(&Turning, &q, &there);
            assert_close(size, &negative[3..], &d[3..], ROUNDED);
            // A few roundings more, and near their singularity angles lose digits.
            let away = kane::Real::sin_cos(there[1]).1.abs();
            assert_close(
                size,
                &found[..3],
                &d[..3],
                Tolerance::absolute(1e-14 / away),
            );
        }
    }
}

/// The turn about x of an orientation whose scalar part is this small, as its sign tells.
fn half_turn<R: Real + Into<f64>>(scalar: f64) -> [f64; 3] {
    let numbers = |e: [f64; 4]| {
        let mut q = [R::from_f64(0.0); 11];
        for (place, entry) in q[4..8].iter_mut().zip(e) {
            *place = R::from_f64(entry);
        }
        q
    };
    let (from, to) = (
        numbers([1.0, 0.0, 0.0, 0.0]),
        numbers([scalar, 1.0, 0.0, 0.0]),
    );
    let direction = q_minus(&Turning, &from, &to);
    [direction[3], direction[4], direction[5]].map(Into::into)
}

#[test]
fn half_a_turn_goes_the_way_that_the_sign_of_a_tiny_number_tells() {
    let pi = std::f64::consts::PI;
    for tiny in [
        0.0,
        5e-324,
        1e-310,
        1e-300,
        1e-290,
        1e-45,
        1e-40,
        1e-30,
        1e-25,
        1.234_567_89e-20,
        1.234_567_9e-20,
        1e-19,
        1e-17,
    ] {
        let double = Tolerance::absolute(2e-15);
        let single = Tolerance::absolute(1e-6);
        for (scalar, way) in [(tiny, pi), (-tiny, if tiny > 0.0 { -pi } else { pi })] {
            let expected = [way, 0.0, 0.0];
            let what = format!("{scalar:e}");
            assert_close(&what, &half_turn::<f64>(scalar), &expected, double);
            // What single precision rounds to zero has no sign.
            #[expect(
                clippy::cast_possible_truncation,
                reason = "what single precision holds"
            )]
            let is_zero = scalar as f32 == 0.0;
            let expected = [if is_zero { pi } else { way }, 0.0, 0.0];
            assert_close(&what, &half_turn::<f32>(scalar), &expected, single);
        }
    }
}

#[test]
fn lengths_of_quaternions_do_not_matter() {
    let mut random = Random::new(6);
    for size in [1e-25, 1e-12, 1e12, 1e100] {
        let (q, d) = (coordinates(&mut random), direction(&mut random, 2.0));
        let mut there = q_plus(&Turning, &q, &d);
        for sign in [1.0, -1.0] {
            for entry in &mut there[4..8] {
                *entry *= sign * size;
            }
            let found = q_minus(&Turning, &q, &there);
            assert_close(size, &found[3..6], &d[3..6], ROUNDED);
            for entry in &mut there[4..8] {
                *entry /= size;
            }
        }
    }
}

#[test]
fn quaternions_of_any_length_are_scaled_to_one() {
    let mut random = Random::new(8);
    for size in [1e-28, 1e-12, 0.01, 1.0, 3.0, 1e12, 1e200, 1e307] {
        let unit = coordinates(&mut random);
        let mut q = unit;
        for entry in &mut q[4..8] {
            *entry *= size;
        }
        scale_quaternions(&Turning, &mut q);
        assert_close(size, &q[4..8], &unit[4..8], ROUNDED);
        assert_eq!(
            (&q[..4], &q[8..]),
            (&unit[..4], &unit[8..]),
            "all others stay"
        );
    }
    let mut none: Q = [0.0; 11];
    scale_quaternions(&Turning, &mut none);
    assert_eq!(none, [0.0; 11], "no orientation stays none");
    let mut single = [
        0.0_f32, 0.0, 0.0, 0.0, 3e-20, 0.0, -4e-20, 0.0, 0.0, 0.0, 0.0,
    ];
    scale_quaternions(&Turning, &mut single);
    // A few roundings of single precision.
    let tolerance = Tolerance::absolute(3e-7);
    assert_close(
        "single",
        &single[4..7]
            .iter()
            .map(|&e| f64::from(e))
            .collect::<Vec<_>>(),
        &[0.6, 0.0, -0.8],
        tolerance,
    );
}

#[test]
fn small_turns_keep_all_their_digits() {
    let q: Q = [0.1, 0.2, 0.3, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    for size in [1e-12, 1e-8, 1e-5, 1e-3] {
        let d: U = [
            0.0,
            0.0,
            0.0,
            size,
            -2.0 * size,
            0.5 * size,
            0.0,
            0.0,
            0.0,
            0.0,
        ];
        let found = q_minus(&Turning, &q, &q_plus(&Turning, &q, &d));
        assert_close(size, &found[3..6], &d[3..6], Tolerance::relative(2e-15));
    }
}

#[test]
fn half_a_turn_and_many_turns_are_finite_and_right() {
    let q: Q = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let half = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    let found = q_minus(&Turning, &q, &half);
    let size = found[3..6]
        .iter()
        .map(|entry| entry * entry)
        .sum::<f64>()
        .sqrt();
    assert_close("half", &[size], &[std::f64::consts::PI], ROUNDED);
    // Sines of large angles are exact: so are turns. 16 whole turns and an eighth.
    let angle = 16.125 * std::f64::consts::TAU;
    let mut d: U = [0.0; 10];
    d[4] = angle;
    let found = q_plus(&Turning, &q, &d);
    let (sine, cosine) = kane::Real::sin_cos(angle / 2.0);
    assert_close("many", &found[4..8], &[cosine, 0.0, sine, 0.0], ROUNDED);
}

#[test]
fn angles_go_on_beyond_a_half_turn() {
    let mut q = [0.0; 11];
    (q[0], q[4]) = (3.0, 1.0);
    let mut d = [0.0; 10];
    d[0] = 0.5;
    let found = q_plus(&Turning, &q, &d);
    assert_close("on", &found[..3], &[3.5, 0.0, 0.0], ROUNDED);
    // Beyond the singularity too they stay on their side.
    q[1] = 3.0;
    let found = q_plus(&Turning, &q, &d);
    let back = q_minus(&Turning, &q, &found);
    assert_close("beyond", &back, &d, ROUNDED);
    assert!(kane::Real::sin_cos(found[1]).1 < 0.0, "{found:?}");
}

/// The columns of a map, one after the other.
fn columns(map: &Map) -> Vec<f64> {
    let columns =
        (0..10).flat_map(|place| map.times(&std::array::from_fn(|i| f64::from(i == place))));
    columns.collect()
}

/// The same by differences of a function of a direction, about zero.
fn differenced(f: impl Fn(&U) -> U) -> Vec<f64> {
    let columns = (0..10).flat_map(|place| {
        derivative(|t| f(&std::array::from_fn(|i| if i == place { t } else { 0.0 })).to_vec())
    });
    columns.collect()
}

#[test]
fn maps_are_the_derivatives_on_both_sides() {
    let mut random = Random::new(3);
    for size in [1e-9, 1e-3, 0.5, 1.5, 2.5] {
        let mut q = coordinates(&mut random);
        q[1] *= 0.3;
        let mut d = direction(&mut random, size);
        // The angles' turn is small, for they are singular not far away.
        for entry in &mut d[..3] {
            *entry *= 0.2;
        }
        let there = q_plus(&Turning, &q, &d);
        let plus = |q: &Q, d: &U| q_plus(&Turning, q, d);
        let minus = |q: &Q, other: &Q| q_minus(&Turning, q, other);
        for (what, map, along) in [
            (
                "plus, q",
                Map::of_q_plus_by_q(&d),
                differenced(|t| minus(&there, &plus(&plus(&q, t), &d))),
            ),
            (
                "plus, direction",
                Map::of_q_plus_by_direction(&d),
                differenced(|t| minus(&there, &plus(&q, &std::array::from_fn(|i| d[i] + t[i])))),
            ),
            (
                "minus, q",
                Map::of_q_minus_by_q(&d),
                differenced(|t| minus(&plus(&q, t), &there)),
            ),
            (
                "minus, q_other",
                Map::of_q_minus_by_q_other(&d),
                differenced(|t| minus(&q, &plus(&there, t))),
            ),
        ] {
            assert_close(
                format!("{size}, {what}"),
                &columns(&map),
                &along,
                DIFFERENCED,
            );
            let rows: [U; 10] = map.matrix();
            let transposed: Vec<f64> = (0..100).map(|i| rows[i % 10][i / 10]).collect();
            assert_eq!(transposed, columns(&map), "{what}");
        }
    }
}

#[test]
fn single_precision_is_as_near() {
    let mut random = Random::new(4);
    // The smallest three show that nothing is divided by zero: their turns are within the tolerance.
    for size in [0.0, 1e-20, 1e-6, 1e-3, 1.0, 3.0] {
        let q = coordinates(&mut random).map(<f32 as kane::Real>::from_f64);
        let d =
            direction(&mut random, 1.0).map(|entry| <f32 as kane::Real>::from_f64(size * entry));
        let found = q_minus(&Turning, &q, &q_plus(&Turning, &q, &d));
        let (found, d) = (found.map(f64::from), d.map(f64::from));
        // A few roundings of numbers about one.
        assert_close(size, &found[3..], &d[3..], Tolerance::absolute(3e-6));
        let at =
            direction(&mut random, 1.0).map(|entry| <f32 as kane::Real>::from_f64(size * entry));
        // A turn goes on about its own axis.
        let map = TangentMap::<f32, Turning>::of_q_plus_by_direction(&at);
        let (mapped, at) = (map.times(&at).map(f64::from), at.map(f64::from));
        assert_close(size, &mapped, &at, Tolerance::absolute(3e-6));
    }
}

#[cfg(feature = "wide")]
#[test]
fn each_lane_has_the_bits_of_its_own() {
    use kane::Lanes;
    use kane::wide::f64x4;
    let mut random = Random::new(5);
    let states: Vec<(Q, U)> = [0.0, 1e-9, 0.3, 3.0]
        .map(|size| {
            let q = coordinates(&mut random);
            (q, direction(&mut random, 1.0).map(|entry| size * entry))
        })
        .to_vec();
    let q: [f64x4; 11] =
        std::array::from_fn(|i| Lanes::load(&[0, 1, 2, 3].map(|k| states[k].0[i])));
    let d: [f64x4; 10] =
        std::array::from_fn(|i| Lanes::load(&[0, 1, 2, 3].map(|k| states[k].1[i])));
    let there = q_plus(&Turning, &q, &d);
    let back = q_minus(&Turning, &q, &there);
    for (lane, (q, d)) in states.iter().enumerate() {
        let own = q_plus(&Turning, q, d);
        let own_back = q_minus(&Turning, q, &own);
        assert_eq!(
            there.map(|entry| entry.to_array()[lane].to_bits()),
            own.map(f64::to_bits)
        );
        assert_eq!(
            back.map(|entry| entry.to_array()[lane].to_bits()),
            own_back.map(f64::to_bits)
        );
    }
}
