//! Strokes: cyclic motions of two angles, which leave the hub turned.

use std::f64::consts::TAU;

use kane::{Real, eight_body::NU};
use nalgebra::{Matrix3, Vector3};

use crate::{Desired, desired::progress};

/// The strokes to choose from, two places of angles each: the shoulder's first and second, its third and first, and the boom's
/// second and third. The turns that they leave are not in one plane.
const CIRCLES: [[usize; 2]; 3] = [[3, 4], [5, 3], [19, 20]];
/// The radius with which strokes are rehearsed, and the greatest, rad.
const REHEARSED: f64 = 0.4;
const GREATEST: f64 = 0.6;

/// A circle of two angles that begins and ends at zero and at rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stroke {
    angles: [usize; 2],
    /// rad; the other way round where it is negative.
    radius: f64,
}

impl Stroke {
    /// How long it takes, s.
    pub(super) const DURATION: f64 = 4.0;

    /// Where to be, `t` after its beginning, s.
    pub(super) fn desired(&self, t: f64) -> Desired<f64, NU> {
        let progress = progress(t, Self::DURATION);
        let (r, turn) = (self.radius.abs(), TAU.copysign(self.radius));
        let (sine, cosine) = Real::sin_cos(turn * progress.s);
        let (rate, change) = (turn * progress.s_dot, turn * progress.s_ddot);
        let on_circle = |x: f64, y: f64| {
            let mut values = [0.0; NU];
            self.angles
                .into_iter()
                .zip([x, y])
                .for_each(|(i, value)| values[i] = r * value);
            values
        };
        Desired {
            q: on_circle(sine, 1.0 - cosine),
            u: on_circle(cosine * rate, sine * rate),
            u_dot: on_circle(
                cosine * change - sine * rate.powi(2),
                sine * change + cosine * rate.powi(2),
            ),
        }
    }
}

/// What the strokes are good for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Repertoire {
    /// The turns that the rehearsed strokes leave, a column each, rad.
    turns: Matrix3<f64>,
}

impl Repertoire {
    /// Rehearses every stroke; `turn_of` says how it leaves the hub turned, rad, the hub's axes.
    pub(super) fn rehearse(turn_of: impl Fn(&Stroke) -> Vector3<f64>) -> Self {
        let radius = REHEARSED;
        let turns = CIRCLES.map(|angles| turn_of(&Stroke { angles, radius }));
        Self {
            turns: Matrix3::from_columns(&turns),
        }
    }

    /// The stroke that makes most of a turn, rad, the hub's axes; what it leaves grows as the circle's area.
    pub(super) fn best(&self, turn: &Vector3<f64>) -> Stroke {
        let parts = self.turns.lu().solve(turn).unwrap_or_default();
        let best = parts.icamax();
        let radius = (REHEARSED * parts[best].abs().sqrt()).min(GREATEST);
        Stroke {
            angles: CIRCLES[best],
            radius: radius.copysign(parts[best]),
        }
    }
}
