//! What pages for people say of counts: it must be what is counted.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;

/// A page, by its path from the top of the repository.
pub(crate) struct Page {
    path: &'static str,
    text: String,
}

pub(crate) fn functions() -> Page {
    Page::read("docs/functions.md")
}

pub(crate) fn performance() -> Page {
    Page::read("docs/performance.md")
}

pub(crate) fn comparison() -> Page {
    Page::read("benches/peers/README.md")
}

impl Page {
    fn read(path: &'static str) -> Self {
        let from_here = format!("{}/../{path}", env!("CARGO_MANIFEST_DIR"));
        let text = fs::read_to_string(from_here).unwrap();
        Self { path, text }
    }

    /// Requires that the page has these words, wherever its lines break.
    pub(crate) fn says(&self, words: &str) {
        let flowing = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let is_there = flowing(&self.text).contains(&flowing(words));
        assert!(is_there, "{} does not say: {words}", self.path);
    }

    /// Requires a row of so many cells, the empty ones at its ends among them, with this name first, and with these numbers in
    /// these cells: alone, or before a comma and another's.
    pub(crate) fn has_row(&self, name: &str, n_cells: usize, numbers: &[(usize, &str)]) {
        let rows = self.text.lines().map(|line| line.split('|').map(str::trim));
        let is_there = rows.map(Iterator::collect::<Vec<_>>).any(|cells| {
            let has = |&(cell, number): &(usize, &str)| {
                cells[cell]
                    .split(',')
                    .next()
                    .is_some_and(|own| own == number)
            };
            cells.len() == n_cells && cells[1] == name && numbers.iter().all(has)
        });
        assert!(is_there, "{} lacks {name}: {numbers:?}", self.path);
    }

    /// The same for each of the robots, by a text that has the counts of functions after each robot's name.
    pub(crate) fn has_robots(&self, text: &str, n_cells: usize, functions: &[(usize, &str)]) {
        for robot in ["ur5", "panda", "solo12", "talos"] {
            let own = text.split_once(&format!("{robot}\n")).unwrap().1;
            let own = format!("\n{own}");
            let number = |&(cell, function)| {
                let count = own.split_once(&format!("\n{function}: ")).unwrap().1;
                (cell, count.split_once(' ').unwrap().0)
            };
            let numbers: Vec<_> = functions.iter().map(number).collect();
            self.has_row(robot, n_cells, &numbers);
        }
    }
}
