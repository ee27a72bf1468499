//! A function of one number, applied to many side by side.

/// The two results of `f` for each of `angles`, in groups of eight, four, two and one written out.
///
/// The optimizer turns the lanes of a group into vector instructions; of a loop over single lanes as long as a
/// sine it does not, at the sizes that systems have. Fewer than sixteen lanes compile without a branch.
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

    /// Takes whole groups off the front of the three slices and evaluates to what is left of them.
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
