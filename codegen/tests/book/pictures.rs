//! Numbers that are shown twice are the same: those of pictures, and those that README.md takes from the comparison with other tools.

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

/// The time, ns, of independent calls of a function, and how many times as long `CasADi` and Pinocchio take.
fn measured(robot: &str, function: &str) -> [String; 3] {
    let page = fs::read_to_string(repository("benches/peers/README.md")).unwrap();
    let start = format!("| {robot} | {function} | independent |");
    let row = page.lines().find(|line| line.starts_with(&start)).unwrap();
    let cells: Vec<&str> = row.split('|').map(str::trim).collect();
    let times = |cell: usize| {
        let times = 1.0 / cells[cell].parse::<f64>().unwrap();
        if times >= 10.0 {
            format!("{times:.0}")
        } else if times >= 1.0 {
            format!("{times:.1}")
        } else {
            format!("{times:.2}")
        }
    };
    [cells[4].to_owned(), times(5), times(6)]
}

#[test]
fn the_readme_has_the_times_of_the_comparison() {
    let readme = fs::read_to_string(repository("README.md")).unwrap();
    for (start, robot, function) in [
        ("Panda, inverse dynamics", "panda", "inverse_dynamics"),
        ("Panda, forward dynamics", "panda", "forward_dynamics"),
        ("Talos, forward dynamics", "talos", "forward_dynamics"),
        (
            "Talos, derivatives of forward dynamics",
            "talos",
            "d_forward_dynamics_d_q_u_tau",
        ),
        ("Talos, regressor", "talos", "regressor"),
    ] {
        let row = readme
            .lines()
            .find(|line| line.starts_with(&format!("| {start}: time |")));
        let cells: Vec<&str> = row.unwrap().split('|').map(str::trim).collect();
        // The number is the first word of a cell; asterisks make it bold.
        let found = [2, 3, 4].map(|cell: usize| {
            let word = cells[cell].split(' ').next().unwrap();
            word.trim_matches('*').to_owned()
        });
        assert_eq!(found, measured(robot, function), "{start}");
    }
}

#[test]
fn the_readme_has_the_operations_of_the_tables() {
    let readme = fs::read_to_string(repository("README.md")).unwrap();
    let table = fs::read_to_string(repository("docs/performance.md")).unwrap();
    for (start, robot, column) in [
        ("Panda, inverse dynamics", "panda", 2),
        ("Panda, forward dynamics", "panda", 6),
        ("Talos, forward dynamics", "talos", 6),
    ] {
        let row = table
            .lines()
            .find(|line| line.starts_with(&format!("| {robot} |")));
        let cells: Vec<&str> = row.unwrap().split('|').map(str::trim).collect();
        let expected = format!(
            "| {start}: operations | {} | {} |",
            cells[column],
            cells[column + 1]
        );
        assert!(readme.contains(&expected), "README.md lacks {expected}");
    }
}

#[test]
fn the_readme_says_how_long_derivatives_become() {
    let readme = fs::read_to_string(repository("README.md")).unwrap();
    let table = fs::read_to_string(repository("docs/performance.md")).unwrap();
    let (_, derivatives) = table
        .split_once("| system | inverse dynamics | CasADi | forward dynamics | CasADi |")
        .unwrap();
    let row = derivatives
        .lines()
        .find(|line| line.starts_with("| talos |"));
    let cells: Vec<&str> = row.unwrap().split('|').map(str::trim).collect();
    let thousands = (cells[4].parse::<f64>().unwrap() / 1000.0).round();
    let expected = format!("Talos's forward dynamics are {thousands},000 operations");
    assert!(readme.contains(&expected), "README.md lacks {expected}");
}
