//! Numbers within nested arrays, and what tells them apart.

use kane::wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use kane::{Lanes, Load, Real};

/// A scalar whose bits can be compared.
pub(crate) trait Bits: Copy {
    fn bits(self) -> u64;
    /// The scalar with these bits, as far as it has so many.
    fn any(bits: u64) -> Self;
    fn is_nan(self) -> bool;
}

impl Bits for f64 {
    fn bits(self) -> u64 {
        self.to_bits()
    }

    fn any(bits: u64) -> Self {
        Self::from_bits(bits)
    }

    fn is_nan(self) -> bool {
        self.is_nan()
    }
}

impl Bits for f32 {
    fn bits(self) -> u64 {
        self.to_bits().into()
    }

    fn any(bits: u64) -> Self {
        Self::from_bits((bits >> 32) as u32)
    }

    fn is_nan(self) -> bool {
        self.is_nan()
    }
}

/// The same bits; NaN has many.
pub(crate) fn same<S: Bits>(a: S, b: S) -> bool {
    a.bits() == b.bits() || (a.is_nan() && b.is_nan())
}

pub(crate) fn lanes_of<L: Lanes>(lanes: L) -> Vec<L::Scalar> {
    let mut values = vec![L::Scalar::from_f64(0.0); L::LANES];
    lanes.store(&mut values);
    values
}

/// Numbers, or arrays of them: the outputs of the generated functions.
pub(crate) trait Entries<R> {
    fn filled(value: R) -> Self;
    fn list(&self, list: &mut Vec<R>);
}

macro_rules! entries {
    ($($scalar:ty),+) => {$(
        impl Entries<$scalar> for $scalar {
            fn filled(value: $scalar) -> Self {
                value
            }

            fn list(&self, list: &mut Vec<$scalar>) {
                list.push(*self);
            }
        }
    )+};
}

entries!(f64, f64x2, f64x4, f64x8, f32, f32x4, f32x8, f32x16);

impl<R: Copy, T: Entries<R>, const N: usize> Entries<R> for [T; N] {
    fn filled(value: R) -> Self {
        core::array::from_fn(|_| T::filled(value))
    }

    fn list(&self, list: &mut Vec<R>) {
        for entry in self {
            entry.list(list);
        }
    }
}

/// Every argument that a function can have.
pub(crate) struct State<R, const NQ: usize, const NU: usize, const NB: usize> {
    pub(crate) q: [R; NQ],
    pub(crate) u: [R; NU],
    pub(crate) u_dot: [R; NU],
    pub(crate) tau: [R; NU],
    pub(crate) w_rel: [[R; 3]; NB],
    pub(crate) loads: [Load<R>; NB],
}

impl<R: Real, const NQ: usize, const NU: usize, const NB: usize> State<R, NQ, NU, NB> {
    /// Of numbers that are asked for in order.
    pub(crate) fn new(mut number: impl FnMut() -> R) -> Self {
        Self {
            q: [(); NQ].map(|()| number()),
            u: [(); NU].map(|()| number()),
            u_dot: [(); NU].map(|()| number()),
            tau: [(); NU].map(|()| number()),
            w_rel: [(); NB].map(|()| [(); 3].map(|()| number())),
            loads: [(); NB].map(|()| Load {
                force: [(); 3].map(|()| number()),
                moment: [(); 3].map(|()| number()),
            }),
        }
    }
}
