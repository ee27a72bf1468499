//! Things, to be found by the magnitudes of their numbers.

use crate::drawn::Field;

/// Things by the magnitudes of their numbers.
pub(super) struct Index<T> {
    /// Which hashes of magnitudes there are.
    filter: Vec<u64>,
    /// How many bits a hash has.
    n_bits: u32,
    /// In order of magnitudes; true where the number is the magnitude's negative.
    sorted: Vec<(u64, T, bool)>,
}

impl<T: Copy + Ord> Index<T> {
    pub(super) fn of(all: impl Iterator<Item = (Field, T)>) -> Self {
        let mut sorted: Vec<_> = all
            .map(|(value, thing)| {
                let (magnitude, negative) = value.magnitude();
                (magnitude, thing, negative)
            })
            .collect();
        sorted.retain(|(magnitude, ..)| *magnitude != 0);
        sorted.sort_unstable();
        // At most one of sixteen searches in vain passes the filter.
        let n_bits = (sorted.len() * 16).max(1 << 12).ilog2() + 1;
        let mut index = Self {
            filter: vec![0; 1 << (n_bits - 6)],
            n_bits,
            sorted: Vec::new(),
        };
        for (magnitude, ..) in &sorted {
            let bit = index.bit(*magnitude);
            index.filter[bit >> 6] |= 1 << (bit & 63);
        }
        Self { sorted, ..index }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.sorted.is_empty()
    }

    /// All things with this number or its negative, and whether it is that.
    pub(super) fn like(&self, value: Field) -> impl Iterator<Item = (T, bool)> + use<'_, T> {
        let (magnitude, is_negative) = value.magnitude();
        let bit = self.bit(magnitude);
        let is_there = self.filter[bit >> 6] & (1 << (bit & 63)) != 0;
        let first = if is_there {
            self.sorted
                .partition_point(|(other, ..)| *other < magnitude)
        } else {
            self.sorted.len()
        };
        let same = self.sorted[first..].iter().copied();
        same.take_while(move |(other, ..)| *other == magnitude)
            .map(move |(_, thing, negative)| (thing, negative != is_negative))
    }

    fn bit(&self, magnitude: u64) -> usize {
        let hash = magnitude.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (64 - self.n_bits);
        usize::try_from(hash).expect("reuse: a place in the filter")
    }
}
