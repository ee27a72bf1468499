//! STL: triangles, each with its own points. Equal points become one.

use std::collections::BTreeMap;

use crate::description::mesh::fault::Fault;
use crate::description::mesh::stl_text;
use crate::description::mesh::surface::{Face, Point, Surface};
use crate::description::mesh::text::without_mark;

/// Bytes before the first triangle, and of a triangle.
const HEADER: usize = 84;
const TRIANGLE: usize = 50;

/// The largest coordinate that MuJoCo takes.
const LARGEST: f32 = 1_073_741_824.0;

/// Reads a binary STL, or one that is text.
pub(super) fn read(bytes: &[u8]) -> Result<Surface, Fault> {
    let (corners, fault) = match binary(bytes) {
        Ok(corners) => (corners, None),
        Err(fault) => (Vec::new(), Some(fault)),
    };
    let Some(fault) = fault else {
        return joined(&corners);
    };
    // Many a binary file begins with `solid`, too: its size has told, or that it has what no text has.
    match without_mark(bytes).trim_ascii_start().get(..5) {
        Some(word) if word.eq_ignore_ascii_case(b"solid") && !bytes.contains(&0) => {
            joined(&stl_text::corners(bytes)?)
        }
        _ => Err(fault),
    }
}

/// The corners of all triangles.
fn binary(bytes: &[u8]) -> Result<Vec<Point>, Fault> {
    let Some(count) = bytes.get(80..HEADER).and_then(|four| four.try_into().ok()) else {
        let found = format!("has {} bytes; an STL has at least {HEADER}", bytes.len());
        return Err(Fault::new(found));
    };
    let count = u32::from_le_bytes(count) as usize;
    let body = &bytes[HEADER..];
    if Some(body.len()) != count.checked_mul(TRIANGLE) {
        let found = format!(
            "has {} bytes and says that it has {count} triangles, of which each takes {TRIANGLE} after the first {HEADER}",
            bytes.len()
        );
        return Err(Fault::new(found).help("the file is cut short, or no STL"));
    }
    let number = |bytes: &[u8]| bytes.try_into().map_or(f32::NAN, f32::from_le_bytes);
    let triangles = body.chunks_exact(TRIANGLE);
    // The first three numbers are the normal, which follows from the corners.
    let corners = triangles.flat_map(|triangle| triangle[12..48].chunks_exact(12));
    Ok(corners
        .map(|corner| [0, 1, 2].map(|i| number(&corner[4 * i..4 * i + 4])))
        .collect())
}

/// The triangles, three corners each, between points of which no two are the same.
fn joined(corners: &[Point]) -> Result<Surface, Fault> {
    if corners.is_empty() {
        return Err(Fault::new("has no triangles"));
    }
    let mut numbers: BTreeMap<[u32; 3], u32> = BTreeMap::new();
    let mut points = Vec::new();
    let mut faces = Vec::with_capacity(corners.len() / 3);
    for triangle in corners.chunks_exact(3) {
        let mut face: Face = [0; 3];
        for (corner, number) in triangle.iter().zip(&mut face) {
            if corner.iter().any(|entry| entry.abs() > LARGEST) {
                let found = "has a coordinate beyond 2^30, the largest that an STL may have";
                return Err(Fault::new(found));
            }
            let next = u32::try_from(points.len()).unwrap_or(u32::MAX);
            *number = *numbers.entry(corner.map(f32::to_bits)).or_insert_with(|| {
                points.push(*corner);
                next
            });
        }
        faces.push(face);
    }
    Surface::new(points, faces)
}
