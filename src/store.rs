//! Stores that stay apart.

use core::sync::atomic::{Ordering, compiler_fence};

/// Writes a number, and keeps the compiler from joining this with writes that follow: it stays one store. Generated functions do so where
/// vectors of neighbours, or a call that writes many zeros, would take longer. The fence is no instruction.
#[expect(clippy::inline_always, reason = "a call would be more than the store")]
#[inline(always)]
pub fn store<T: Copy>(place: &mut T, value: T) {
    *place = value;
    compiler_fence(Ordering::Release);
}
