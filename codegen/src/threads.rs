//! The same work on each of several things, on as many threads; the results come in the order of the things.

use std::thread;

/// As a main thread has on common systems.
const STACK: usize = 8 << 20;

/// What `work` makes of each of `items`.
///
/// # Panics
/// Where `work` does.
pub(crate) fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
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

#[cfg(test)]
mod tests {
    #[test]
    fn results_are_in_the_order_of_the_items() {
        let items: Vec<u64> = (0..20).collect();
        // The first take longest.
        let squares = super::map(&items, |item| {
            std::thread::sleep(std::time::Duration::from_millis(20 - item));
            item * item
        });
        assert!(squares.into_iter().eq((0..20).map(|item| item * item)));
    }
}
