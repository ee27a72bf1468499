//! Things, to be found by the magnitudes of their numbers.
//!
//! Millions are asked for, most of them in vain, and often by a generator that was compiled without optimization: so the common case
//! is a few instructions without a closure.

use crate::drawn::Field;

/// Things by the magnitudes of their numbers.
pub(super) struct Index<T> {
    /// For the last bits of a magnitude, the last entry that has them, counted from one; zero for none. A power of two of them.
    last: Box<[u32]>,
    entries: Vec<Entry<T>>,
}

struct Entry<T> {
    magnitude: u64,
    /// True where the number is the magnitude's negative.
    is_negative: bool,
    thing: T,
    /// The entry before it with the same hash, counted from one.
    before: u32,
}

impl<T: Copy + Ord> Index<T> {
    /// An empty one that will have up to so many things.
    pub(super) fn with_capacity(n_things: usize) -> Self {
        // Of those asked for in vain at most one in sixteen meets another.
        let n_bits = (n_things * 16).max(1 << 12).ilog2() + 1;
        Self {
            last: vec![0; 1 << n_bits].into(),
            entries: Vec::with_capacity(n_things),
        }
    }

    /// Adds a thing, unless its number is zero.
    pub(super) fn add(&mut self, value: Field, thing: T) {
        let (magnitude, is_negative) = value.magnitude();
        if magnitude == 0 {
            return;
        }
        let place = self.place(magnitude);
        let before = self.last[place];
        self.entries.push(Entry {
            magnitude,
            is_negative,
            thing,
            before,
        });
        self.last[place] = u32::try_from(self.entries.len()).expect("reuse: few things");
    }

    /// False if no thing has this number or its negative; true where some may have.
    pub(super) fn may_have(&self, value: Field) -> bool {
        let (magnitude, _) = value.magnitude();
        self.last[self.place(magnitude)] != 0
    }

    /// All things with this number or its negative, and whether it is that, in their order.
    pub(super) fn like(&self, value: Field) -> Vec<(T, bool)> {
        let (magnitude, is_negative) = value.magnitude();
        let mut next = self.last[self.place(magnitude)];
        let mut all = Vec::new();
        while next != 0 {
            let entry = &self.entries[next as usize - 1];
            if entry.magnitude == magnitude {
                all.push((entry.thing, entry.is_negative != is_negative));
            }
            next = entry.before;
        }
        all.sort_unstable();
        all
    }

    fn place(&self, magnitude: u64) -> usize {
        #[expect(clippy::cast_possible_truncation, reason = "only the last bits count")]
        let bits = magnitude as usize;
        bits & (self.last.len() - 1)
    }
}
