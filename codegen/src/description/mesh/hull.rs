//! The convex hull: points are added one by one, in a seeded order of chance, to a hull that begins as a tetrahedron.
//!
//! Each point outside knows the faces that see it, so that no work is done for one that is inside; the expected time grows as
//! `n log n` for whatever points (Clarkson and Shor; de Berg, Computational Geometry, chapter 11). On which side of a face a
//! point lies is found without error (crate `robust`), and one in a face's plane is not outside of it: so what a point sees is
//! always one patch, with one border, and no face degenerates.

use robust::{Coord3D, orient3d};

use crate::description::mesh::effort::Effort;
use crate::description::mesh::fault::Fault;
use crate::description::mesh::surface::{Face, Point};
use crate::random::Random;

const SEED: u64 = 3;
const NONE: u32 = u32::MAX;

/// A face of the hull so far.
struct Facet {
    corners: Face,
    /// The facets across the edges, each of which begins at the corner of the same place.
    neighbours: [u32; 3],
    /// The points outside that see it.
    seen_by: Vec<u32>,
    is_alive: bool,
}

struct Hull<'p> {
    points: &'p [Point],
    effort: &'p mut Effort,
    facets: Vec<Facet>,
    /// The facets that each point sees, and those it saw.
    sees: Vec<Vec<u32>>,
    /// The last facet for which a point was tried.
    tried: Vec<u32>,
    /// The new facet whose outer edge begins at a point.
    begins: Vec<u32>,
}

/// The faces of the convex hull, counter-clockwise seen from outside.
pub(super) fn hull(points: &[Point], effort: &mut Effort) -> Result<Vec<Face>, Fault> {
    let Some(first) = tetrahedron(points) else {
        let found = "has all its points in a plane, so that it has no convex hull";
        return Err(Fault::new(found).help("use a thin box in its place"));
    };
    let mut hull = Hull {
        points,
        effort,
        facets: Vec::new(),
        sees: vec![Vec::new(); points.len()],
        tried: vec![NONE; points.len()],
        begins: vec![NONE; points.len()],
    };
    hull.begin(first)?;
    for point in order(points) {
        hull.add(point)?;
    }
    let alive = hull.facets.iter().filter(|facet| facet.is_alive);
    Ok(alive.map(|facet| facet.corners).collect())
}

fn coordinate([x, y, z]: Point) -> Coord3D<f64> {
    let [x, y, z] = [x, y, z].map(f64::from);
    Coord3D { x, y, z }
}

/// Positive where the fourth point lies on the side from which the others are clockwise.
fn side(points: &[Point], [a, b, c]: Face, d: u32) -> f64 {
    let [a, b, c, d] = [a, b, c, d].map(|number| coordinate(points[number as usize]));
    orient3d(a, b, c, d)
}

fn number(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(NONE)
}

/// The point for which a quantity is largest.
fn farthest(points: &[Point], measure: impl Fn(Point) -> f64) -> Option<usize> {
    let measured = points.iter().map(|point| measure(*point)).enumerate();
    let best = measured.max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    Some(best.0)
}

/// Four points that do not lie in a plane, the last on the inner side of the others.
fn tetrahedron(points: &[Point]) -> Option<[u32; 4]> {
    let away = |from: usize| {
        let from = points[from].map(f64::from);
        move |point: Point| [0, 1, 2].map(|i| f64::from(point[i]) - from[i])
    };
    let square = |v: [f64; 3]| v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    let a = farthest(points, |point| -f64::from(point[0]))?;
    let from_a = away(a);
    let b = farthest(points, |point| square(from_a(point)))?;
    let along = from_a(points[b]);
    let c = farthest(points, |point| {
        square(crate::geometry::cross(along, from_a(point)))
    })?;
    let base = [a, b, c].map(number);
    let d = farthest(points, |point| {
        let [a, b, c] = base.map(|corner| coordinate(points[corner as usize]));
        orient3d(a, b, c, coordinate(point)).abs()
    })?;
    let [a, b, c] = base;
    let d = number(d);
    let found = side(points, base, d);
    if found == 0.0 {
        return None;
    }
    Some(if found > 0.0 {
        [a, b, c, d]
    } else {
        [a, c, b, d]
    })
}

/// All points: those that are extreme in some directions, beside which most of the others are inside; then by chance.
fn order(points: &[Point]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..points.len()).map(number).collect();
    let mut random = Random::new(SEED);
    for last in (1..order.len()).rev() {
        order.swap(last, random.below(last + 1));
    }
    let mut extreme = Vec::new();
    for code in 0..27_u8 {
        let direction = [code / 9, code / 3 % 3, code % 3].map(|digit| f64::from(digit) - 1.0);
        extreme.extend(farthest(points, |point| {
            (0..3).map(|i| f64::from(point[i]) * direction[i]).sum()
        }));
    }
    extreme.into_iter().map(number).chain(order).collect()
}

impl Hull<'_> {
    /// The tetrahedron, of which each face looks away from the fourth point.
    fn begin(&mut self, [a, b, c, d]: [u32; 4]) -> Result<(), Fault> {
        let faces = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]];
        let neighbours = [[1, 2, 3], [3, 2, 0], [1, 3, 0], [2, 1, 0]];
        for (corners, neighbours) in faces.into_iter().zip(neighbours) {
            let all = (0..self.points.len()).map(number);
            let facet = self.facet(corners, neighbours, all)?;
            self.facets.push(facet);
        }
        Ok(())
    }

    /// A facet, with those of the candidates that see it.
    fn facet(
        &mut self,
        corners: Face,
        neighbours: [u32; 3],
        candidates: impl Iterator<Item = u32>,
    ) -> Result<Facet, Fault> {
        let own = number(self.facets.len());
        let mut seen_by = Vec::new();
        let mut tried = 1;
        for candidate in candidates {
            let index = candidate as usize;
            if self.tried[index] != own {
                self.tried[index] = own;
                tried += 1;
                if side(self.points, corners, candidate) < 0.0 {
                    seen_by.push(candidate);
                    self.sees[index].push(own);
                }
            }
        }
        self.effort.spend(tried)?;
        Ok(Facet {
            corners,
            neighbours,
            seen_by,
            is_alive: true,
        })
    }

    /// Replaces what a point sees by facets to the point.
    fn add(&mut self, point: u32) -> Result<(), Fault> {
        let mut seen = std::mem::take(&mut self.sees[point as usize]);
        seen.retain(|facet| self.facets[*facet as usize].is_alive);
        for facet in &seen {
            self.facets[*facet as usize].is_alive = false;
        }
        let first = self.facets.len();
        for facet in &seen {
            for edge in 0..3 {
                let inner = &self.facets[*facet as usize];
                let outer = inner.neighbours[edge];
                if self.facets[outer as usize].is_alive && (outer as usize) < first {
                    let ends = [inner.corners[edge], inner.corners[(edge + 1) % 3]];
                    self.connect(ends, *facet, outer, point)?;
                }
            }
        }
        for index in first..self.facets.len() {
            let [_, end, _] = self.facets[index].corners;
            let next = self.begins[end as usize];
            self.facets[index].neighbours[1] = next;
            self.facets[next as usize].neighbours[2] = number(index);
        }
        for facet in seen {
            self.facets[facet as usize].seen_by = Vec::new();
        }
        Ok(())
    }

    /// A facet from an edge of the border between `inner`, which goes, and `outer`, which stays, to the point.
    fn connect(
        &mut self,
        [start, end]: [u32; 2],
        inner: u32,
        outer: u32,
        point: u32,
    ) -> Result<(), Fault> {
        let own = number(self.facets.len());
        // Who sees it saw one of the two.
        let inner_seen = std::mem::take(&mut self.facets[inner as usize].seen_by);
        let outer_seen = std::mem::take(&mut self.facets[outer as usize].seen_by);
        let candidates = inner_seen.iter().chain(&outer_seen).copied();
        let candidates = candidates.filter(|candidate| *candidate != point);
        let facet = self.facet([start, end, point], [outer, NONE, NONE], candidates)?;
        self.facets.push(facet);
        self.facets[inner as usize].seen_by = inner_seen;
        let across = &mut self.facets[outer as usize];
        across.seen_by = outer_seen;
        for edge in 0..3 {
            if across.corners[edge] == end {
                across.neighbours[edge] = own;
            }
        }
        self.begins[start as usize] = own;
        Ok(())
    }
}
