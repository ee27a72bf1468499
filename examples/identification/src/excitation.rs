//! The choice of a path on which torques tell much of every parameter.

use kane::Array;
use nalgebra::{DMatrix, DVector};

use crate::{
    Arm, Identifiable, Noise, Path,
    extremes::{largest, least},
    stack,
};

/// The states of a path by which it is judged: fewer than are measured.
const STATES: usize = 50;
/// The paths that are drawn first,
const DRAWN: usize = 60;
/// and how often the best is varied then.
const VARIED: usize = 400;
/// By which part of the joints' reach in the beginning, and how that shrinks with each variation that is no better.
const PART: f64 = 0.3;
const SHRINKING: f64 = 0.985;
/// The part of the joints' greatest torques that the path may need, as far as the prior can tell.
const EFFORT: f64 = 0.6;

/// Draws paths by chance and varies the best, by the condition number of the columns that can be identified; `prior` are the base parameters and
/// coefficients by which torques are predicted.
pub fn exciting<A: Arm>(arm: &A, period: f64, prior: &DVector<f64>, chance: &mut Noise) -> Path {
    let any = Path::random::<A>(period, chance);
    let columns = Identifiable::of(&stacked(arm, &any)).columns;
    let judge = |path: &Path| condition(&stacked(arm, path), &columns, prior);
    let (mut best, mut least) = (judge(&any), any);
    for _ in 0..DRAWN {
        let path = Path::random::<A>(period, chance);
        keep_better(&mut best, &mut least, judge(&path), path);
    }
    let mut part = PART;
    for _ in 0..VARIED {
        let path = least.varied::<A>(part, chance);
        if !keep_better(&mut best, &mut least, judge(&path), path) {
            part *= SHRINKING;
        }
    }
    least
}

fn keep_better(best: &mut f64, kept: &mut Path, condition: f64, path: Path) -> bool {
    let better = condition < *best;
    if better {
        (*best, *kept) = (condition, path);
    }
    better
}

/// `W`, in units of the joints' greatest torques.
fn stacked<A: Arm>(arm: &A, path: &Path) -> DMatrix<f64> {
    let effort = A::U::from_fn(|i| A::EFFORT_LIMITS[i]);
    stack(arm, &path.states(STATES), &effort)
}

/// The condition number of these columns; infinite where the torques are too much for the arm, or no numbers.
fn condition(w: &DMatrix<f64>, columns: &[usize], prior: &DVector<f64>) -> f64 {
    let effort = largest(&(w * prior));
    if effort.is_nan() || effort > EFFORT {
        return f64::INFINITY;
    }
    let independent = w.select_columns(columns);
    let values = independent.tr_mul(&independent).symmetric_eigenvalues();
    (largest(&values) / least(&values)).sqrt()
}
