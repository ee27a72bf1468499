//! The tree and the pattern of the mass matrix as a drawing.
//!
//! In: a tree and a pattern. Out: SVG, to the left a line a body below the one that carries it, to the right a square for every
//! entry that is not zero, in the order of `u`. The text is the same on every machine.

use std::fmt::Write as _;

use crate::{diagnostic::printable, id::BodyId, tree::Tree};

/// From one body to the next one, and as far to the right on what it carries; units of the drawing.
const ROW: usize = 22;
/// The side of an entry of the pattern.
const CELL: usize = 10;
/// Around everything, and between the two.
const MARGIN: usize = 20;
/// A character of a name.
const CHARACTER: usize = 7;

/// The drawing; `pattern` has a row for each speed, or none where it is left out.
pub fn svg(tree: &Tree, pattern: &[Vec<bool>]) -> String {
    let depths = depths(tree);
    let names = tree.bodies.iter().map(|body| body.name.as_str());
    let ends = depths.iter().zip(names);
    let ends = ends.map(|(depth, name)| depth * ROW + (name.chars().count() + 4) * CHARACTER);
    let tree_width = ends.max().unwrap_or(0).max(16 * CHARACTER);
    let tree_height = (tree.bodies.len() + 1) * ROW;
    let side = pattern.len() * CELL;
    let width = 3 * MARGIN + tree_width + side;
    let height = 2 * MARGIN + tree_height.max(side + ROW);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n"
    );
    draw_tree(&mut text, tree, &depths);
    if !pattern.is_empty() {
        draw_pattern(&mut text, pattern, 2 * MARGIN + tree_width);
    }
    text + "</svg>\n"
}

/// How many bodies each stands on; that on the inertial frame has depth 1.
fn depths(tree: &Tree) -> Vec<usize> {
    let mut depths: Vec<usize> = Vec::with_capacity(tree.bodies.len());
    for body in tree.body_ids() {
        depths.push(1 + tree.lower(body).map_or(0, |lower| depths[lower.index()]));
    }
    depths
}

/// A dot and a name for each body, a line from the one that carries it.
fn draw_tree(text: &mut String, tree: &Tree, depths: &[usize]) {
    let mut rows = vec![0; tree.bodies.len()];
    for (row, body) in order(tree).into_iter().enumerate() {
        rows[body.index()] = row + 1;
    }
    let x = |depth: usize| MARGIN + depth * ROW;
    let y = |row: usize| MARGIN + row * ROW + ROW / 2;
    for body in tree.body_ids() {
        let (depth, row) = (depths[body.index()], rows[body.index()]);
        let lower = tree.lower(body).map_or(0, |lower| rows[lower.index()]);
        let (from, to) = (x(depth - 1), x(depth));
        line(text, &format!("M{from} {} V{} H{to}", y(lower), y(row)));
    }
    // Above the lines.
    node(text, x(0), y(0), "inertial frame");
    for body in tree.body_ids() {
        let (depth, row) = (depths[body.index()], rows[body.index()]);
        let name = format!("{} {}", body.index() + 1, tree.body(body).name);
        node(text, x(depth), y(row), &name);
    }
}

/// The bodies depth first, as they are drawn.
fn order(tree: &Tree) -> Vec<BodyId> {
    let roots = tree.body_ids().filter(|body| tree.lower(*body).is_none());
    let mut open: Vec<BodyId> = roots.collect();
    open.reverse();
    let mut order = Vec::with_capacity(tree.bodies.len());
    while let Some(body) = open.pop() {
        order.push(body);
        open.extend(tree.uppers(body).iter().rev());
    }
    order
}

fn node(text: &mut String, x: usize, y: usize, name: &str) {
    let (at, base) = (x + 8, y + 4);
    let name = escaped(name);
    writeln!(
        text,
        "<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/><text x=\"{at}\" y=\"{base}\">{name}</text>"
    )
    .expect("writing to a string does not fail");
}

fn line(text: &mut String, path: &str) {
    writeln!(text, "<path d=\"{path}\" fill=\"none\" stroke=\"gray\"/>")
        .expect("writing to a string does not fail");
}

/// A frame, and in it a square for each entry that is not zero.
fn draw_pattern(text: &mut String, pattern: &[Vec<bool>], left: usize) {
    let (side, top) = (pattern.len() * CELL, MARGIN + ROW);
    let base = MARGIN + ROW / 2 + 4;
    let nonzero = pattern.iter().flatten().filter(|entry| **entry).count();
    let entries = pattern.len() * pattern.len();
    let mut path = String::new();
    for (row, entries) in pattern.iter().enumerate() {
        for (column, _) in entries.iter().enumerate().filter(|(_, entry)| **entry) {
            let (x, y) = (left + column * CELL, top + row * CELL);
            write!(path, "M{x} {y}h{CELL}v{CELL}h-{CELL}z")
                .expect("writing to a string does not fail");
        }
    }
    writeln!(
        text,
        "<text x=\"{left}\" y=\"{base}\">mass matrix: {nonzero} of {entries}</text>\n\
         <path d=\"{path}\" fill=\"steelblue\" stroke=\"white\"/>\n\
         <rect x=\"{left}\" y=\"{top}\" width=\"{side}\" height=\"{side}\" fill=\"none\" stroke=\"gray\"/>"
    )
    .expect("writing to a string does not fail");
}

/// A name as text of XML.
fn escaped(name: &str) -> String {
    printable(name)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
