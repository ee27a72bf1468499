//! [`Array`]: the trait by which generic code uses the fixed-size arrays in a system's signatures.
//!
//! The sizes of a system are associated types, not const generics: stable Rust cannot compute one array length from another, and
//! with associated types no call needs a turbofish.

use core::fmt::Debug;
use core::ops::{Index, IndexMut};

/// A plain array `[T; N]` whose length is part of the type but not of the name.
///
/// Implemented for every `[T; N]`, and not meant for other types.
///
/// ```
/// use kane::Array;
///
/// fn sum<A: Array<f64>>(array: &A) -> f64 {
///     (0..A::LEN).map(|index| array[index]).sum()
/// }
/// assert_eq!(sum(&[1.0, 2.0, 3.0]), 6.0);
/// ```
pub trait Array<T>:
    Copy
    + Debug
    + Send
    + Sync
    + AsRef<[T]>
    + AsMut<[T]>
    + Index<usize, Output = T>
    + IndexMut<usize>
    + 'static
{
    /// The number of elements.
    const LEN: usize;

    /// The array with every element `value`.
    fn filled(value: T) -> Self;

    /// The array with element `i` equal to `element(i)`.
    fn from_fn(element: impl FnMut(usize) -> T) -> Self;
}

impl<T: Copy + Debug + Send + Sync + 'static, const N: usize> Array<T> for [T; N] {
    const LEN: usize = N;

    #[inline]
    fn filled(value: T) -> Self {
        [value; N]
    }

    #[inline]
    fn from_fn(element: impl FnMut(usize) -> T) -> Self {
        core::array::from_fn(element)
    }
}
