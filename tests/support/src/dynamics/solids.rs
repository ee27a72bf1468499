//! What every body weighs with all that is fixed to it.

use super::composition::{Composition, Placed, nominal, rotation, vector};
use crate::rotation::{Rotation, Vector, cross, dot, product, scaled, sum, times, transposed};

/// A body of the tree with all that is fixed to it, in the user's axes.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    pub mass: f64,
    /// From the body's origin.
    pub center: Vector,
    /// About the mass centre.
    pub inertia: Rotation,
    /// How much of the mass is lifted.
    pub lifted: f64,
    /// Its first moment about the mass centre.
    pub lifted_moment: Vector,
}

impl Solid {
    /// Force and moment of what is left of the weight, about the mass centre, where gravity is `g` in its axes.
    pub fn weight(&self, g: Vector) -> [Vector; 2] {
        [
            scaled(self.mass - self.lifted, g),
            cross(g, self.lifted_moment),
        ]
    }

    /// The potential energy of that, with the mass centre at `center`.
    pub fn potential(&self, g: Vector, center: Vector) -> f64 {
        dot(g, self.lifted_moment) - (self.mass - self.lifted) * dot(g, center)
    }
}

impl Composition {
    /// The bodies of the tree with all that is fixed to them.
    pub fn solids(&self) -> Vec<Solid> {
        // Where the coordinates are does not matter between frames that are fixed to one another.
        let placed = self.placed(&vec![0.5; self.tree.n_coordinates]);
        let mut parts: Vec<Vec<usize>> = vec![Vec::new(); self.tree.bodies.len()];
        for place in 0..placed.len() {
            let mut host = Some(place);
            while let Some(fixed) = host.filter(|host| self.moving[*host].is_none()) {
                host = self.lower(fixed);
            }
            if let Some(body) = host.and_then(|host| self.moving[host]) {
                parts[body.index()].push(place);
            }
        }
        self.tree
            .body_ids()
            .map(|body| {
                let own = placed[self.tree.body(body).user_number - 1];
                self.solid(&own, &parts[body.index()], &placed)
            })
            .collect()
    }

    fn solid(&self, own: &Placed, parts: &[usize], placed: &[Placed]) -> Solid {
        let mut solid = Solid {
            mass: 0.0,
            center: [0.0; 3],
            inertia: [[0.0; 3]; 3],
            lifted: 0.0,
            lifted_moment: [0.0; 3],
        };
        let of_part = |&place: &usize| {
            let body = &self.description.bodies[place];
            let turn = product(&own.rotation, &transposed(&placed[place].rotation));
            let apart = sum(placed[place].origin, scaled(-1.0, own.origin));
            let center = sum(
                times(&own.rotation, apart),
                times(&turn, vector(&body.mass_center)),
            );
            (nominal(body.mass.as_ref()), center, turn)
        };
        for (mass, center, _) in parts.iter().map(of_part) {
            solid.mass += mass;
            solid.center = sum(solid.center, scaled(mass, center));
        }
        solid.center = if solid.mass > 0.0 {
            scaled(1.0 / solid.mass, solid.center)
        } else {
            // What weighs nothing is as if alone.
            vector(&self.description.bodies[parts[0]].mass_center)
        };
        for place in parts {
            let (mass, center, turn) = of_part(place);
            let body = &self.description.bodies[*place];
            let [xx, yy, zz, xy, xz, yz] =
                body.inertia.each_ref().map(|part| nominal(part.as_ref()));
            let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
            // From the axes of the tensor to the body's.
            let turn = product(
                &turn,
                &transposed(&rotation(body.inertia_rotation.as_ref())),
            );
            let turned = product(&product(&turn, &tensor), &transposed(&turn));
            let d = sum(center, scaled(-1.0, solid.center));
            let share = body.gravity_compensation;
            let lifted = mass * share.map_or(0.0, |share| share.value.nominal());
            solid.lifted += lifted;
            solid.lifted_moment = sum(solid.lifted_moment, scaled(lifted, d));
            for i in 0..3 {
                for j in 0..3 {
                    let around = if i == j { dot(d, d) } else { 0.0 };
                    solid.inertia[i][j] += turned[i][j] + mass * (around - d[i] * d[j]);
                }
            }
        }
        solid
    }
}
