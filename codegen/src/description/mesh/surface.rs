//! Points and the triangles between them.

use crate::description::mesh::fault::{Fault, SIMPLIFY};
use crate::limits::{MESH_FACES, MESH_POINTS};

/// A point, in the file's own frame and units. MuJoCo keeps them in single precision.
pub(super) type Point = [f32; 3];

/// The numbers of a face's points, counter-clockwise seen from outside.
pub(super) type Face = [u32; 3];

/// Points and the triangles between them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surface {
    pub(super) points: Vec<Point>,
    /// None at all where the mesh is the convex hull of its points.
    pub(super) faces: Vec<Face>,
    /// Whether objects of the file are left out: MuJoCo takes the first alone.
    pub(crate) leaves_objects_out: bool,
    /// Whether faces of more than [`MOST_CORNERS`](super::MOST_CORNERS) are, which MuJoCo leaves out.
    pub(crate) leaves_faces_out: bool,
}

impl Surface {
    /// A surface of finite points, at least four, all of whose faces name points that are there.
    pub(crate) fn new(points: Vec<Point>, faces: Vec<Face>) -> Result<Self, Fault> {
        let n_points = points.len();
        check_sizes(n_points, faces.len())?;
        if n_points < 4 {
            let s = if n_points == 1 { "" } else { "s" };
            let found = format!("has {n_points} point{s}; expected at least 4");
            return Err(Fault::new(found));
        }
        let is_finite = |point: &Point| point.iter().all(|entry| entry.is_finite());
        if let Some(bad) = points.iter().position(|point| !is_finite(point)) {
            let found = format!("has a coordinate of point {bad} that is no finite number");
            return Err(Fault::new(found));
        }
        for (number, face) in faces.iter().enumerate() {
            if let Some(bad) = face.iter().find(|point| **point as usize >= n_points) {
                return Err(no_point(number, i64::from(*bad), n_points));
            }
        }
        Ok(Self {
            points,
            faces,
            leaves_objects_out: false,
            leaves_faces_out: false,
        })
    }
}

/// Refuses more points or faces than a mesh may have.
pub(super) fn check_sizes(n_points: usize, n_faces: usize) -> Result<(), Fault> {
    for (what, count, most) in [
        ("points", n_points, MESH_POINTS),
        ("faces", n_faces, MESH_FACES),
    ] {
        if count > most {
            return Err(Fault::new(format!("has more than {most} {what}")).help(SIMPLIFY));
        }
    }
    Ok(())
}

/// A face with the number of no point, both counted from 0.
pub(super) fn no_point(face: usize, point: i64, n_points: usize) -> Fault {
    Fault::new(format!(
        "has face {face} with point {point}; its points are 0 to {}",
        n_points - 1
    ))
}
