//! MSH, MuJoCo's binary format: four counts, points, normals, texture coordinates, faces.

use crate::description::mesh::fault::Fault;
use crate::description::mesh::surface::{Face, Point, Surface, no_point};

const HEADER: usize = 16;

/// Reads an MSH.
pub(super) fn read(bytes: &[u8]) -> Result<Surface, Fault> {
    let Some((header, rest)) = bytes.split_at_checked(HEADER) else {
        let found = format!("has {} bytes; an MSH has at least {HEADER}", bytes.len());
        return Err(Fault::new(found));
    };
    let word = |bytes: &[u8]| bytes.try_into().unwrap_or([0; 4]);
    let mut counts = header
        .chunks_exact(4)
        .map(|four| i64::from(i32::from_le_bytes(word(four))));
    let mut next = || counts.next().unwrap_or_default();
    let [n_points, n_normals, n_texture, n_faces] = [next(), next(), next(), next()];
    let fits = |count: i64| count == 0 || count == n_points;
    if n_points < 4 || n_faces < 0 || !fits(n_normals) || !fits(n_texture) {
        let found = format!(
            "says that it has {n_points} points, {n_normals} normals, {n_texture} texture coordinates and {n_faces} faces"
        );
        return Err(Fault::new(found)
            .help("expected at least 4 points, and as many of the others as points, or none"));
    }
    let expected = 12 * (n_points + n_normals + n_faces) + 8 * n_texture;
    if i64::try_from(rest.len()) != Ok(expected) {
        let found = format!(
            "has {} bytes; its counts ask for {}",
            bytes.len(),
            expected + 16
        );
        return Err(Fault::new(found).help("the file is cut short, or no MSH"));
    }
    // The counts are no larger than the file.
    let [skipped_from, skipped] =
        [12 * n_points, 12 * n_normals + 8 * n_texture].map(|n| usize::try_from(n).unwrap_or(0));
    let (points, others) = rest.split_at(skipped_from);
    let points = points
        .chunks_exact(12)
        .map(|twelve| [0, 4, 8].map(|at| f32::from_le_bytes(word(&twelve[at..at + 4]))));
    let faces = others[skipped..]
        .chunks_exact(12)
        .map(|twelve| [0, 4, 8].map(|at| i32::from_le_bytes(word(&twelve[at..at + 4]))));
    let points: Vec<Point> = points.collect();
    let mut checked: Vec<Face> = Vec::with_capacity(faces.len());
    for (number, face) in faces.enumerate() {
        if let Some(&below) = face.iter().find(|point| **point < 0) {
            return Err(no_point(number, i64::from(below), points.len()));
        }
        checked.push(face.map(i32::cast_unsigned));
    }
    Surface::new(points, checked)
}
