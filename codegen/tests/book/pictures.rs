//! The pictures' numbers are those of the tables.

use std::fs;

use crate::page::repository;

#[test]
fn the_bars_have_the_numbers_of_the_table() {
    let picture = fs::read_to_string(repository("docs/pictures/operations.svg")).unwrap();
    let table = fs::read_to_string(repository("docs/performance.md")).unwrap();
    for robot in ["ur5", "panda", "solo12", "talos"] {
        let row = table
            .lines()
            .find(|line| line.starts_with(&format!("| {robot} |")));
        let cells: Vec<&str> = row.unwrap().split('|').map(str::trim).collect();
        for column in [2, 3, 6, 7] {
            let number = format!(">{}</text>", cells[column]);
            assert!(
                picture.contains(&number),
                "run docs/pictures/draw.py: {robot} has {}",
                cells[column]
            );
        }
    }
}
