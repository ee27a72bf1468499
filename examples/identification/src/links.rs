//! From the links of a URDF to the bodies of the generated module.

use nalgebra::{Matrix3, Matrix4, Rotation3, Vector3};

use crate::{Arm, pseudo_inertia};

/// What a URDF says of a link's mass.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// Its name.
    pub name: &'static str,
    /// kg.
    pub mass: f64,
    /// From the link's origin, along its axes, m.
    pub mass_center: [f64; 3],
    /// The tensor's components xx, yy, zz, xy, xz, yz about the mass centre, along the link's axes, kg m².
    pub inertia: [f64; 6],
}

impl Link {
    /// Its pseudo-inertia in the link's axes.
    fn pseudo_inertia(&self) -> Matrix4<f64> {
        let [xx, yy, zz, xy, xz, yz] = self.inertia;
        let about_center = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let center = Vector3::from(self.mass_center);
        pseudo_inertia::of_mass_center(self.mass, &center, &about_center)
    }
}

/// The pseudo-inertia of each body in its own axes: that of its link, and of all links that are fixed to it.
pub fn bodies<A: Arm>() -> Vec<Matrix4<f64>> {
    let mut bodies = vec![Matrix4::zeros(); A::BODY_NAMES.len()];
    for link in A::LINKS {
        let frame = A::FRAMES.iter().find(|frame| frame.name == link.name);
        let (body, place) = match frame {
            Some(frame) => (frame.body, place(&frame.rotation, &frame.position)),
            None => (
                A::BODY_NAMES.iter().position(|name| *name == link.name),
                Matrix4::identity(),
            ),
        };
        // What is fixed to the inertial frame does not move.
        if let Some(body) = body {
            bodies[body] += place * link.pseudo_inertia() * place.transpose();
        }
    }
    bodies
}

/// The homogeneous transformation to a body's axes from those of a frame on it, of which `rotation` and `position` say where it is.
fn place(rotation: &[[f64; 3]; 3], position: &[f64; 3]) -> Matrix4<f64> {
    let to_body = Rotation3::from_matrix_unchecked(Matrix3::from_fn(|i, j| rotation[j][i]));
    to_body
        .to_homogeneous()
        .append_translation(&Vector3::from(*position))
}
