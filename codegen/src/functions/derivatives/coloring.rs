//! Colours of columns: those of one colour share no row, so that one direction gives all their entries at once.

use std::collections::BTreeSet;

/// A colour for each column, from 0, of a matrix that is zero but at these places. Greedy, the column with most rows first (Welsh
/// and Powell 1967), of equals the one that stands first.
pub fn colors(places: &[[usize; 2]], n_columns: usize) -> Vec<usize> {
    let mut rows_of = vec![Vec::new(); n_columns];
    let n_rows = places.iter().map(|[row, _]| row + 1).max().unwrap_or(0);
    for &[row, column] in places {
        rows_of[column].push(row);
    }
    let mut order: Vec<usize> = (0..n_columns).collect();
    order.sort_by_key(|&column| std::cmp::Reverse(rows_of[column].len()));
    let mut taken: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); n_rows];
    // Of each row, up to where all colours are taken.
    let mut first_free = vec![0; n_rows];
    let mut colors = vec![0; n_columns];
    for column in order {
        let rows = &rows_of[column];
        let is_free = |color: &usize| rows.iter().all(|&row| !taken[row].contains(color));
        let from = rows.iter().map(|&row| first_free[row]).max().unwrap_or(0);
        let color = (from..n_columns).find(is_free);
        let color = color.expect("coloring: as many colours as columns");
        for &row in rows {
            taken[row].insert(color);
            while taken[row].contains(&first_free[row]) {
                first_free[row] += 1;
            }
        }
        colors[column] = color;
    }
    colors
}
