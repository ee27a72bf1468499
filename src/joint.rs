//! [`Joint`] and [`Frame`]: the places of a joint's coordinates, and frames fixed in bodies.
//!
//! Generated modules hold constants of these types, for code that works with any system: conversion between charts, tools, logs.

use crate::{Real, three::transposed_times};

/// The orientation coordinates of a joint, and its rotational speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Chart {
    /// The free ones of three 1-2-3 body-fixed angles, rad; the speeds are their rates, Eq. (44).
    AngleRates,
    /// Three angles, rad; the speeds are the relative angular velocity, components along the axes on the body's side of the
    /// joint, rad/s, Eqs. (8), (9).
    Angles,
    /// Euler parameters, a unit quaternion, scalar first, Hamilton's product: it maps components on the body's side of
    /// the joint to those on the lower body's. The speeds are those of [`Chart::Angles`].
    EulerParameters,
}

/// The places of a joint's coordinates and speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Joint {
    /// The joint's name in the model, or its body's if it has none.
    pub name: &'static str,
    /// Its orientation coordinates.
    pub chart: Chart,
    /// Places in `q`, from 0: `theta_1`, `theta_2`, `theta_3` and none, or `e_0` to `e_3`; then `s_1`, `s_2`, `s_3`. None
    /// for a coordinate that is locked or mimics another joint's.
    pub q: [Option<usize>; 7],
    /// Places in `u`, from 0: the three rotations, then the three translations.
    pub u: [Option<usize>; 6],
}

impl Joint {
    /// The places, in `q` and in `u`, of coordinates whose rates are speeds.
    pub(crate) fn rates(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let skipped = match self.chart {
            Chart::AngleRates => 0,
            Chart::Angles | Chart::EulerParameters => 3,
        };
        // Of the seven places the fourth is a quaternion's.
        let places = self.q[..3].iter().chain(&self.q[4..]);
        let pairs = places.zip(&self.u).skip(skipped);
        pairs.filter_map(|(q, u)| Some(((*q)?, (*u)?)))
    }
}

/// A frame fixed in a body. In the model it is a body of its own, fixed to the other one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The name in the model.
    pub name: &'static str,
    /// The index, from 0, of the body that it is part of; none for the inertial frame.
    pub body: Option<usize>,
    /// Rotation matrix, row by row: components in that body's axes to components in the frame's.
    pub rotation: [[f64; 3]; 3],
    /// From that body's origin to the frame's, that body's components, m; at the parameters' nominal values.
    pub position: [f64; 3],
}

impl Frame {
    /// The rotation matrix from inertial components to the frame's, row by row; `rotations` are those of all bodies, Eqs. (2)-(5).
    ///
    /// # Panics
    /// If `rotations` is not of the frame's system.
    #[must_use]
    pub fn rotation<R: Real>(&self, rotations: &[[[R; 3]; 3]]) -> [[R; 3]; 3] {
        let own = self.rotation.map(|row| row.map(R::from_f64));
        let Some(body) = self.body else {
            return own;
        };
        let body = &rotations[body];
        own.map(|row| transposed_times(body, row))
    }

    /// The position of the frame's origin from the inertial origin, inertial components, m; `rotations` and `origins` are
    /// those of all bodies, Eqs. (2)-(5), (22).
    ///
    /// # Panics
    /// If `rotations` or `origins` are not of the frame's system.
    #[must_use]
    pub fn position<R: Real>(&self, rotations: &[[[R; 3]; 3]], origins: &[[R; 3]]) -> [R; 3] {
        let own = self.position.map(R::from_f64);
        let Some(body) = self.body else {
            return own;
        };
        let (rotation, origin) = (&rotations[body], &origins[body]);
        let ([x, y, z], [own_x, own_y, own_z]) = (*origin, own);
        transposed_times(rotation, [x + own_x, y + own_y, z + own_z])
    }
}
