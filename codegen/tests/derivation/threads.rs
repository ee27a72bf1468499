//! Work side by side.

use kane_codegen::threads;

#[test]
fn results_are_in_the_order_of_the_items() {
    let items: Vec<u64> = (0..20).collect();
    // The first take longest.
    let squares = threads::map(&items, |item| {
        std::thread::sleep(std::time::Duration::from_millis(20 - item));
        item * item
    });
    assert!(squares.into_iter().eq((0..20).map(|item| item * item)));
}
