//! OBJ: points, and polygons between them. Of several objects the first one that has faces counts, as in MuJoCo; all points do.

use crate::description::mesh::effort::Effort;
use crate::description::mesh::fault::Fault;
use crate::description::mesh::polygon;
use crate::description::mesh::surface::{Face, Point, Surface};
use crate::limits::{MESH_FACES, MESH_POINTS};

/// A polygon of more corners is left out, as MuJoCo does.
pub(crate) const MOST_CORNERS: usize = 100;

/// The object of the file that counts.
#[derive(Default)]
struct Object {
    /// Whether polygons had too many corners.
    leaves_faces_out: bool,
    points: Vec<Point>,
    /// The corners of all polygons, and where each of them ends.
    corners: Vec<u32>,
    ends: Vec<usize>,
}

/// Reads an OBJ.
pub(super) fn read(bytes: &[u8], effort: &mut Effort) -> Result<Surface, Fault> {
    let text = String::from_utf8_lossy(bytes);
    let mut object = Object::default();
    let mut leaves_objects_out = false;
    let mut is_over = false;
    for (index, line) in text.lines().enumerate() {
        let mut words = line.split_ascii_whitespace();
        let fault = |found: &str| Err(Fault::new(format!("has {found} in line {}", index + 1)));
        match words.next() {
            Some("v") => {
                let Some(point) = point(words) else {
                    return fault("no three numbers after `v`");
                };
                object.points.push(point);
            }
            Some("o" | "g") => is_over |= !object.ends.is_empty(),
            Some("f") if is_over => leaves_objects_out = true,
            Some("f") if !object.face(words) => {
                return fault("a face with a point that is not there");
            }
            _ => {}
        }
        if object.points.len() > MESH_POINTS || object.corners.len() > 4 * MESH_FACES {
            let found = format!("has more than {MESH_POINTS} points or {MESH_FACES} faces");
            return Err(Fault::new(found).help("simplify the mesh, or give the body an `inertial`"));
        }
    }
    let faces = object.triangles(effort)?;
    let leaves_faces_out = object.leaves_faces_out;
    let surface = Surface::new(object.points, faces)?;
    Ok(Surface {
        leaves_objects_out,
        leaves_faces_out,
        ..surface
    })
}

/// The first three numbers; a weight or a colour may follow.
fn point<'t>(words: impl Iterator<Item = &'t str>) -> Option<Point> {
    let numbers: Vec<f64> = words.take(3).filter_map(|word| word.parse().ok()).collect();
    let point: [f64; 3] = numbers.try_into().ok()?;
    #[expect(
        clippy::cast_possible_truncation,
        reason = "MuJoCo keeps points in single precision; what is infinite then is a fault"
    )]
    Some(point.map(|entry| entry as f32))
}

impl Object {
    /// Takes over a polygon; of one with less than three corners nothing. False where a corner is no point.
    fn face<'t>(&mut self, words: impl Iterator<Item = &'t str>) -> bool {
        let start = self.corners.len();
        for word in words {
            // Behind the slashes stand texture coordinates and normals.
            let number = word.split('/').next().unwrap_or_default();
            let count = i64::try_from(self.points.len()).unwrap_or_default();
            let number = match number.parse::<i64>() {
                Ok(number) if number > 0 => number - 1,
                Ok(number) if number < 0 => count + number,
                _ => return false,
            };
            let Ok(number) = u32::try_from(number) else {
                return false;
            };
            self.corners.push(number);
        }
        let count = self.corners.len() - start;
        if count < 3 {
            self.corners.truncate(start);
        } else if count > MOST_CORNERS {
            self.corners.truncate(start);
            self.leaves_faces_out = true;
        } else {
            self.ends.push(self.corners.len());
        }
        true
    }

    fn triangles(&self, effort: &mut Effort) -> Result<Vec<Face>, Fault> {
        let mut cutter = polygon::Cutter::new(&self.points, effort);
        let mut start = 0;
        for (number, end) in self.ends.iter().enumerate() {
            let corners = &self.corners[start..*end];
            let n_points = self.points.len();
            if let Some(bad) = corners.iter().find(|corner| **corner as usize >= n_points) {
                let found = format!(
                    "has face {} with point {}; its points are 1 to {n_points}",
                    number + 1,
                    u64::from(*bad) + 1
                );
                return Err(Fault::new(found));
            }
            cutter.cut(corners)?;
            start = *end;
        }
        Ok(cutter.faces)
    }
}
