//! Stores that the compiler does not merge.

use core::sync::atomic::{Ordering, compiler_fence};

/// Writes a number as one store that the compiler does not merge with later writes.
///
/// Generated functions use it where vector stores, or a call that writes many zeros, would take longer. The fence is not an instruction.
#[expect(clippy::inline_always, reason = "a call would be more than the store")]
#[inline(always)]
pub fn store<T: Copy>(place: &mut T, value: T) {
    *place = value;
    compiler_fence(Ordering::Release);
}
