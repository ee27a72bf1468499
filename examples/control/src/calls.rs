//! How long the controller's calls take.

use std::{fmt, hint::black_box, time::Instant};

use hdrhistogram::Histogram;

/// The greatest time told apart, ns: a second.
const GREATEST: u64 = 1_000_000_000;

/// Times of calls in a histogram, which allocates when it is made and never again.
#[derive(Clone, Debug)]
pub struct CallTimes {
    times: Histogram<u64>,
    /// Of the last call, ns.
    last: u64,
}

impl Default for CallTimes {
    fn default() -> Self {
        let digits = 3;
        let histogram = Histogram::new_with_max(GREATEST, digits);
        Self {
            times: histogram.expect("three digits up to a second are what a histogram can hold"),
            last: 0,
        }
    }
}

impl CallTimes {
    /// Makes a call and remembers how long it took, the clock's own tens of nanoseconds included.
    #[expect(
        clippy::disallowed_methods,
        reason = "the clock reaches the times of calls, and nothing that is computed"
    )]
    pub fn time<T>(&mut self, call: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = black_box(call());
        self.record(nanoseconds_since(start));
        result
    }

    /// The same without what `part` has timed in this call, once at most.
    #[expect(
        clippy::disallowed_methods,
        reason = "the clock reaches the times of calls, and nothing that is computed"
    )]
    pub fn time_without<T>(&mut self, part: &mut Self, call: impl FnOnce(&mut Self) -> T) -> T {
        let start = Instant::now();
        part.last = 0;
        let result = black_box(call(part));
        self.record(nanoseconds_since(start).saturating_sub(part.last));
        result
    }

    fn record(&mut self, nanoseconds: u64) {
        self.last = nanoseconds;
        self.times.saturating_record(nanoseconds);
    }

    /// The number of calls.
    pub fn calls(&self) -> u64 {
        self.times.len()
    }
}

impl fmt::Display for CallTimes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} calls of the controller:", self.calls())?;
        for (name, quantile) in [("p50", 0.5), ("p99", 0.99), ("p99.9", 0.999)] {
            write!(f, " {name} {} ns,", self.times.value_at_quantile(quantile))?;
        }
        write!(f, " max {} ns", self.times.max())
    }
}

fn nanoseconds_since(start: Instant) -> u64 {
    u64::try_from(start.elapsed().as_nanos()).unwrap_or(GREATEST)
}
