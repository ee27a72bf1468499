//! Eight free bodies hold their formation: 48 speeds, 96 numbers of state, by one linear-quadratic regulator.
//!
//! Their accelerations are long functions, and derivatives as a whole ten times as long: `A` and `B` are made here of products with
//! directions, a column each. At rest without gravity nothing brings the bodies back, and nothing drives them apart: all
//! eigenvalues of `A` are one. With the regulator's forces all are within the unit circle.

use kane::discrete::{Change, euler};
use nalgebra::{Complex, DMatrix, DVector};

use crate::eight_body::{NQ, NU, Prepared};
use crate::riccati::regulator;

/// The time of a step, s.
pub const DT: f64 = 0.02;

/// Ten seconds.
const N_STEPS: usize = 500;

/// What came of it.
#[derive(Clone, Debug)]
pub struct Report {
    /// Eigenvalues of the step without forces.
    pub alone: Vec<Complex<f64>>,
    /// The same with the regulator.
    pub held: Vec<Complex<f64>>,
    /// The root of the sum of squares of all coordinates' distances from the formation, rad and m, at the start and at the end.
    pub away: [f64; 2],
}

/// The formation that is held, rad and m.
pub fn formation() -> [f64; NQ] {
    std::array::from_fn(|place| 0.3 * f64::from(u8::try_from(place * 7 % 11).unwrap_or(0)) / 10.0)
}

/// The derivatives of a step at rest, by the state and by the forces.
pub fn linearized(system: &Prepared<f64>, q: &[f64; NQ]) -> (DMatrix<f64>, DMatrix<f64>) {
    let unit = |first: usize, column: usize| {
        std::array::from_fn(|place| if first + place == column { 1.0 } else { 0.0 })
    };
    let mut columns = DMatrix::zeros(2 * NU, 3 * NU);
    for column in 0..3 * NU {
        let (mut q, mut u) = (*q, [0.0; NU]);
        let mut change = Change {
            q: unit(0, column),
            u: unit(NU, column),
        };
        let along = (&mut change, &unit(2 * NU, column));
        euler::forward(system, &[0.0; NU], DT, (&mut q, &mut u), along);
        let both = change.q.into_iter().chain(change.u);
        columns.set_column(column, &DVector::from_iterator(2 * NU, both));
    }
    let b = columns.columns(2 * NU, NU).into_owned();
    (columns.columns(0, 2 * NU).into_owned(), b)
}

/// Lets the regulator bring the bodies back to their formation; `None` where it has no solution.
pub fn run() -> Option<Report> {
    let system = Prepared::nominal();
    let at = formation();
    let (a, b) = linearized(&system, &at);
    let (q_cost, f_cost) = (DMatrix::identity(2 * NU, 2 * NU), DMatrix::identity(NU, NU));
    let (gains, _) = regulator(&a, &b, &q_cost, &(0.001 * f_cost))?;

    let (mut q, mut u) = (at, [0.0; NU]);
    for (place, q) in q.iter_mut().enumerate() {
        *q += if place % 2 == 0 { 0.15 } else { -0.1 };
    }
    let away = |q: &[f64; NQ]| {
        let ways = q.iter().zip(&at).map(|(q, at)| (q - at).powi(2));
        ways.sum::<f64>().sqrt()
    };
    let start = away(&q);
    for _ in 0..N_STEPS {
        let ways = q.iter().zip(&at).map(|(q, at)| q - at);
        let state = DVector::from_iterator(2 * NU, ways.chain(u));
        let forces = -&gains * state;
        let tau = std::array::from_fn(|place| forces[place]);
        euler::step(&system, &tau, DT, &mut q, &mut u);
    }
    let values = |matrix: DMatrix<f64>| matrix.complex_eigenvalues().iter().copied().collect();
    Some(Report {
        held: values(&a - b * gains),
        alone: values(a),
        away: [start, away(&q)],
    })
}
