//! The same work on each of several things, on as many threads; the results come in the order of the things.

use std::thread;

/// As a main thread has on common systems.
const STACK: usize = 8 << 20;

/// What `work` makes of each of `items`.
///
/// # Panics
/// Where `work` does.
pub fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let work = &work;
    thread::scope(|scope| {
        let started: Vec<_> = items
            .iter()
            .map(|item| {
                let builder = thread::Builder::new().stack_size(STACK);
                let started = builder.spawn_scoped(scope, move || work(item));
                // Where no thread can be had, this one does the work.
                started.map_err(|_| work(item))
            })
            .collect();
        let results = started.into_iter().map(|started| match started {
            Ok(thread) => thread
                .join()
                .unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            Err(result) => result,
        });
        results.collect()
    })
}
