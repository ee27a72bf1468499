//! A function of one number, applied to many side by side.

/// The most angles computed in place. More gain from a function of eight, with AVX and with SSE2; other processors are not measured.
const MOST_OF_FEW: usize = if cfg!(target_feature = "avx") {
    2
} else if cfg!(target_feature = "sse2") {
    4
} else {
    15
};

/// The two results of `f`, which has no branch, for each of `angles`, all of them scalars.
///
/// A few angles are lanes of [`each`]. Of more, eight at a time go to a separate function:
/// if the optimizer sees the use of the lanes, it packs some of them with one another and with results, and five sines
/// and cosines took as long as one after the other (LLVM 22). The rest is filled up to eight, or goes by four, two or one.
///
/// Up to a hundred angles compile without a loop. This function is inlined: a call would copy `angles`, or many
/// results, by `memcpy`.
#[expect(
    clippy::inline_always,
    reason = "a call would copy its results by `memcpy`"
)]
#[inline(always)]
pub(crate) fn scalars<T: Copy, const N: usize>(
    angles: [T; N],
    f: impl Fn(T) -> (T, T) + Copy,
) -> ([T; N], [T; N]) {
    let left = N % 8;
    if N <= MOST_OF_FEW {
        return few(angles, f);
    }
    let mut both = ([angles[0]; N], [angles[0]; N]);
    let (xs, x) = angles.as_chunks();
    let (ss, s) = both.0.as_chunks_mut();
    let (cs, c) = both.1.as_chunks_mut();
    for ((&x, s), c) in xs.iter().zip(ss).zip(cs) {
        let [sines, cosines] = eight(x, f);
        (*s, *c) = (sines.0, cosines.0);
    }
    if left == 3 || left > 4 {
        let mut filled = [x[0]; 8];
        filled[..left].copy_from_slice(x);
        let [sines, cosines] = eight(filled, f);
        s.copy_from_slice(&sines.0[..left]);
        c.copy_from_slice(&cosines.0[..left]);
    } else if let [a, b, d, e] = *x {
        let (sines, cosines) = each([a, b, d, e], f);
        s.copy_from_slice(&sines);
        c.copy_from_slice(&cosines);
    } else if let [a, b] = *x {
        let (sines, cosines) = each([a, b], f);
        s.copy_from_slice(&sines);
        c.copy_from_slice(&cosines);
    } else if let [a] = *x {
        (s[0], c[0]) = f(a);
    }
    both
}

/// The results of few angles. The optimizer decides whether to inline it, because so few results need no `memcpy`.
#[inline]
fn few<T: Copy, const N: usize>(
    angles: [T; N],
    f: impl Fn(T) -> (T, T) + Copy,
) -> ([T; N], [T; N]) {
    each(angles, f)
}

/// Eight numbers in one cache line. They are written as one vector and read one by one, which takes longer across two lines.
#[repr(align(64))]
struct Line<T>([T; 8]);

/// The two results of eight angles.
///
/// The call passes the angles one by one, in registers if the processor's calling convention has eight. In an array they would be
/// written number by number and read as a vector, and such a read waits for all stores before it.
#[expect(clippy::inline_always, reason = "it only passes registers on")]
#[inline(always)]
fn eight<T: Copy>(x: [T; 8], f: impl Fn(T) -> (T, T)) -> [Line<T>; 2] {
    let [a, b, d, e, g, h, i, j] = x;
    eight_in_registers(a, b, d, e, g, h, i, j, f)
}

#[expect(
    clippy::too_many_arguments,
    reason = "an array would be passed in memory"
)]
#[inline(never)]
fn eight_in_registers<T: Copy>(
    a: T,
    b: T,
    d: T,
    e: T,
    g: T,
    h: T,
    i: T,
    j: T,
    f: impl Fn(T) -> (T, T),
) -> [Line<T>; 2] {
    let (sines, cosines) = each([a, b, d, e, g, h, i, j], f);
    [Line(sines), Line(cosines)]
}

/// The two results of `f` for each of `angles`, in groups of eight, four, two and one written out.
///
/// The optimizer turns the lanes of a group into vector instructions. It does not do so for a loop over single lanes
/// as long as a sine, at the sizes of systems. Fewer than sixteen lanes compile without a branch.
#[expect(
    clippy::inline_always,
    reason = "a call here would keep the lanes apart"
)]
#[inline(always)]
pub(crate) fn each<T: Copy, const N: usize>(
    angles: [T; N],
    f: impl Fn(T) -> (T, T),
) -> ([T; N], [T; N]) {
    let mut sines = angles;
    let mut cosines = angles;
    let (x, s, c) = (&angles[..], &mut sines[..], &mut cosines[..]);

    /// Takes whole groups off the front of the three slices and evaluates to the rest of them.
    macro_rules! groups {
        ($x:ident, $s:ident, $c:ident; $size:literal: $($lane:ident)+) => {{
            let ((xs, x), (ss, s), (cs, c)) =
                ($x.as_chunks::<$size>(), $s.as_chunks_mut::<$size>(), $c.as_chunks_mut::<$size>());
            for ((&[$($lane),+], s), c) in xs.iter().zip(ss).zip(cs) {
                $(let $lane = f($lane);)+
                *s = [$($lane.0),+];
                *c = [$($lane.1),+];
            }
            (x, s, c)
        }};
    }
    let (x, s, c) = groups!(x, s, c; 8: a b c d e g h i);
    let (x, s, c) = groups!(x, s, c; 4: a b c d);
    let (x, s, c) = groups!(x, s, c; 2: a b);
    let _ = groups!(x, s, c; 1: a);
    (sines, cosines)
}
