//! STL as text, which MuJoCo does not read.

use crate::description::mesh::fault::Fault;
use crate::description::mesh::surface::Point;
use crate::description::mesh::text;

/// The corners of all triangles.
pub(super) fn corners(bytes: &[u8]) -> Result<Vec<Point>, Fault> {
    let text = text::of(bytes);
    let mut corners: Vec<Point> = Vec::new();
    // How many corners of the triangle that is open are there.
    let mut open = None;
    let mut is_closed = false;
    for (at, mut words) in text::lines(&text) {
        let Some(word) = words.next() else {
            continue;
        };
        match word.to_ascii_lowercase().as_str() {
            "solid" => is_closed = false,
            "endsolid" => is_closed = true,
            "facet" | "endfacet" => {}
            "outer" if open.is_some() => {
                return Err(Fault::new(format!("has a loop within a loop in line {at}")));
            }
            "outer" => open = Some(0),
            "vertex" => {
                let Some(count) = &mut open else {
                    return Err(Fault::new(format!(
                        "has a vertex outside of a loop in line {at}"
                    )));
                };
                *count += 1;
                corners.push(point(words, at)?);
            }
            "endloop" => {
                let count = open.take().unwrap_or(0);
                if count != 3 {
                    let found = format!(
                        "has a loop of {count} vertices that ends in line {at}; expected 3"
                    );
                    return Err(Fault::new(found));
                }
            }
            _ => {
                let found = format!("has `{}` in line {at}, which no STL has", text::shown(word));
                return Err(Fault::new(found));
            }
        }
    }
    if !is_closed || open.is_some() {
        return Err(Fault::new("ends before `endsolid`").help("the file is cut short"));
    }
    Ok(corners)
}

fn point<'t>(words: impl Iterator<Item = &'t str>, line: usize) -> Result<Point, Fault> {
    let numbers: Option<Vec<f32>> = words.map(|word| word.parse().ok()).collect();
    numbers
        .and_then(|numbers| Point::try_from(numbers).ok())
        .ok_or_else(|| {
            Fault::new(format!(
                "has no three numbers after `vertex` in line {line}"
            ))
        })
}
