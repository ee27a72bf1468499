//! Polygons cut into triangles, in the way of the library by which MuJoCo reads OBJ, in single precision: corners of files lie
//! in a plane but for rounding, so that another cut is another volume.

use crate::description::mesh::effort::Effort;
use crate::description::mesh::fault::Fault;
use crate::description::mesh::surface::{Face, Point};

/// Cuts polygons of the same points.
pub(super) struct Cutter<'p> {
    points: &'p [Point],
    effort: &'p mut Effort,
    /// The triangles so far.
    pub(super) faces: Vec<Face>,
}

impl<'p> Cutter<'p> {
    pub(super) fn new(points: &'p [Point], effort: &'p mut Effort) -> Self {
        Self {
            points,
            effort,
            faces: Vec::new(),
        }
    }

    /// Cuts a polygon of at least three corners, all of which are points.
    pub(super) fn cut(&mut self, corners: &[u32]) -> Result<(), Fault> {
        match *corners {
            [a, b, c] => self.faces.push([a, b, c]),
            [a, b, c, d] => {
                let pair = if self.square(a, c) < self.square(b, d) {
                    [[a, b, c], [a, c, d]]
                } else {
                    [[a, b, d], [b, c, d]]
                };
                self.faces.extend(pair);
            }
            _ => self.ears(corners)?,
        }
        Ok(())
    }

    fn point(&self, number: u32) -> Point {
        self.points[number as usize]
    }

    /// The square of a distance.
    fn square(&self, a: u32, b: u32) -> f32 {
        let [x, y, z] = difference(self.point(b), self.point(a));
        x * x + y * y + z * z
    }

    /// Cuts off corners in which no other lies, until three are left.
    fn ears(&mut self, corners: &[u32]) -> Result<(), Fault> {
        let axes = self.plane(corners);
        let seen = |cutter: &Self, number: u32| axes.map(|axis| cutter.point(number)[axis]);
        let mut rest = corners.to_vec();
        let mut first = 0;
        let mut tries = rest.len();
        let mut before = rest.len();
        while rest.len() > 3 && tries > 0 {
            let n = rest.len();
            self.effort.spend(n)?;
            if first >= n {
                first -= n;
            }
            if before == n {
                tries -= 1;
            } else {
                before = n;
                tries = n;
            }
            let ear = [0, 1, 2].map(|k| rest[(first + k) % n]);
            let [a, b, c] = ear.map(|number| seen(self, number));
            let turn = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
            let area = (a[0] * b[1] - a[1] * b[0]) * 0.5;
            let is_inward = turn * area < 0.0;
            let mut others = (3..n).map(|k| rest[(first + k) % n]);
            if is_inward || others.any(|other| is_inside([a, b, c], seen(self, other))) {
                first += 1;
            } else {
                self.faces.push(ear);
                rest.remove((first + 1) % n);
            }
        }
        if let [a, b, c] = *rest {
            self.faces.push([a, b, c]);
        }
        Ok(())
    }

    /// The two axes along which a polygon is seen: those of its first corner that is one.
    fn plane(&self, corners: &[u32]) -> [usize; 2] {
        let n = corners.len();
        for k in 0..n {
            let [a, b, c] = [0, 1, 2].map(|i| self.point(corners[(k + i) % n]));
            let ([ax, ay, az], [bx, by, bz]) = (difference(b, a), difference(c, b));
            let x = (ay * bz - az * by).abs();
            let y = (az * bx - ax * bz).abs();
            let z = (ax * by - ay * bx).abs();
            if x > f32::EPSILON || y > f32::EPSILON || z > f32::EPSILON {
                return if x > y && x > z {
                    [1, 2]
                } else if z > x && z > y {
                    [0, 1]
                } else {
                    [0, 2]
                };
            }
        }
        [1, 2]
    }
}

fn difference(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|i| a[i] - b[i])
}

/// True for a point that a ray crosses the triangle's border once from.
fn is_inside(triangle: [[f32; 2]; 3], [x, y]: [f32; 2]) -> bool {
    let mut inside = false;
    for (i, j) in [(0, 2), (1, 0), (2, 1)] {
        let ([xi, yi], [xj, yj]) = (triangle[i], triangle[j]);
        if (yi > y) != (yj > y) && x < (xj - xi) * (y - yi) / (yj - yi) + xi {
            inside = !inside;
        }
    }
    inside
}
