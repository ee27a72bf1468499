//! Whether faces look the same way: two that share an edge pass it in opposite directions.

use crate::description::mesh::fault::Fault;
use crate::description::mesh::sums::triangle;
use crate::description::mesh::surface::Surface;
use crate::geometry::Vector;

/// Faces with a smaller area, in the file's unit squared, have no direction, as in MuJoCo.
const SMALL: f64 = 3.162_277_660_168_379e-8;

/// Refuses a surface of which an edge is passed twice in the same direction.
pub(super) fn check(surface: &Surface, points: &[Vector]) -> Result<(), Fault> {
    let mut edges = Vec::with_capacity(3 * surface.faces.len());
    for [a, b, c] in &surface.faces {
        let corners = [a, b, c].map(|number| points[*number as usize]);
        if triangle(corners).area > SMALL {
            edges.extend([(*a, *b), (*b, *c), (*c, *a)]);
        }
    }
    edges.sort_unstable();
    let twice = edges.windows(2).find(|pair| pair[0] == pair[1]);
    match twice {
        Some(pair) => {
            let (a, b) = pair[0];
            let point = |number: u32| {
                #[expect(clippy::cast_possible_truncation, reason = "files have as many digits")]
                let [x, y, z] = points[number as usize].map(|entry| entry as f32);
                format!("({x}, {y}, {z})")
            };
            let found = format!(
                "has two faces that pass the edge from {} to {} in the same direction",
                point(a),
                point(b)
            );
            Err(Fault::new(found).help("let all faces look outward, or write `inertia=\"convex\"`"))
        }
        None => Ok(()),
    }
}
