//! OBJ: points, and polygons between them. Of several objects the first one that has faces counts, as in MuJoCo; all points do.

use crate::description::mesh::effort::Effort;
use crate::description::mesh::fault::Fault;
use crate::description::mesh::surface::{self, Face, Point, Surface};
use crate::description::mesh::{polygon, text};

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
    let text = text::of(bytes);
    let mut object = Object::default();
    let mut leaves_objects_out = false;
    let mut is_over = false;
    for (number, mut words) in text::lines(&text) {
        let fault = |found: String| Fault::new(format!("has {found} in line {number}"));
        match words.next() {
            Some("v") => {
                let point = point(words);
                let point = point.ok_or_else(|| fault("no three numbers after `v`".to_owned()));
                object.points.push(point?);
            }
            Some("o" | "g") => is_over |= !object.ends.is_empty(),
            Some("f") if is_over => leaves_objects_out = true,
            Some("f") => object.face(words).map_err(|word| {
                let word = text::shown(word);
                fault(format!("a face with `{word}`, the number of no point,"))
            })?,
            _ => {}
        }
        surface::check_sizes(object.points.len(), object.ends.len())?;
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
    /// Takes over a polygon; of one with less than three corners nothing. The word that is the number of no point, where there is one.
    fn face<'t>(&mut self, words: impl Iterator<Item = &'t str>) -> Result<(), &'t str> {
        let start = self.corners.len();
        for word in words {
            // Behind the slashes stand texture coordinates and normals.
            let number = word.split('/').next().unwrap_or_default();
            let count = i64::try_from(self.points.len()).unwrap_or_default();
            let number = match number.parse::<i64>() {
                Ok(number) if number > 0 => number - 1,
                Ok(number) if number < 0 => count + number,
                _ => return Err(word),
            };
            self.corners.push(u32::try_from(number).map_err(|_| word)?);
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
        Ok(())
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
