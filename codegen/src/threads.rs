//! The same work on each of several things, on as many threads as the machine runs at once; the results come in the order of
//! the things.

use std::{
    num::NonZero,
    panic,
    sync::atomic::{AtomicUsize, Ordering},
    thread,
};

/// As a main thread has on common systems.
const STACK: usize = 8 << 20;

/// What `work` makes of each of `items`. The last are begun first: of functions these are derivatives, which take longest.
///
/// # Panics
/// Where `work` does.
pub fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let begun = AtomicUsize::new(0);
    let next = || {
        let place = begun.fetch_add(1, Ordering::Relaxed);
        items.len().checked_sub(place + 1)
    };
    let share = || -> Vec<(usize, R)> {
        let places = std::iter::from_fn(next);
        places.map(|place| (place, work(&items[place]))).collect()
    };
    let n_threads = thread::available_parallelism().map_or(1, NonZero::get);
    let mut results = thread::scope(|scope| {
        let started: Vec<_> = (0..n_threads.min(items.len()))
            .map_while(|_| {
                let builder = thread::Builder::new().stack_size(STACK);
                builder.spawn_scoped(scope, share).ok()
            })
            .collect();
        // Where no thread can be had, this one does the work.
        let mut results = if started.is_empty() {
            share()
        } else {
            Vec::new()
        };
        for thread in started {
            results.extend(
                thread
                    .join()
                    .unwrap_or_else(|panic| panic::resume_unwind(panic)),
            );
        }
        results
    });
    results.sort_unstable_by_key(|&(place, _)| place);
    results.into_iter().map(|(_, result)| result).collect()
}
