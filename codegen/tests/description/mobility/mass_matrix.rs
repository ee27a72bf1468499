//! What the mass matrix says: its rank, and that of its parts.

use kane_codegen::expr::Input;
use kane_codegen::functions::{Formulation, Function};
use kane_codegen::recursive::Plan;
use kane_codegen::tree::Tree;
use kane_test_support::dynamics::State;

type Matrix = Vec<Vec<f64>>;

/// The mass matrix in a few states.
pub(crate) struct MassMatrices(Vec<Matrix>);

impl MassMatrices {
    pub(crate) fn of(tree: &Tree, seed: u64) -> Self {
        Self(matrices(tree, seed))
    }

    /// The most that it has in rank.
    pub(crate) fn rank(&self) -> usize {
        let ranks = self.0.iter().map(|m| rank_of_energies(m.clone()));
        ranks.max().unwrap()
    }

    /// The most that the rows and columns of these speeds have in rank.
    pub(crate) fn rank_of(&self, speeds: &[usize]) -> usize {
        let part = |m: &Matrix| -> Matrix {
            let row = |&row: &usize| speeds.iter().map(|&column| m[row][column]).collect();
            speeds.iter().map(row).collect()
        };
        let ranks = self.0.iter().map(|m| rank_of_energies(part(m)));
        ranks.max().unwrap()
    }
}

fn matrices(tree: &Tree, seed: u64) -> Vec<Matrix> {
    let function = Function::find("mass_matrix").unwrap();
    let derived = function.derive(tree, Formulation::Recursive, &Plan::full(tree));
    let of_state = |seed| {
        let q = State::random(tree, seed).q;
        let m = derived.graph.evaluate(&derived.roots, |input| match input {
            Input::Q(at) => q[at.index()],
            other => unreachable!("{other:?} in a mass matrix of numbers"),
        });
        m.chunks(tree.n_speeds).map(<[f64]>::to_vec).collect()
    };
    (seed..seed + 3).map(of_state).collect()
}

/// The rank of a symmetric matrix that is not negative: Cholesky's pivots, the largest first.
fn rank_of_energies(mut m: Matrix) -> usize {
    let mut left: Vec<usize> = (0..m.len()).collect();
    let mut rank = 0;
    while let Some(at) =
        (0..left.len()).max_by(|&a, &b| m[left[a]][left[a]].total_cmp(&m[left[b]][left[b]]))
    {
        let pivot = left.remove(at);
        // Energies are of order one, so this is far above rounding and below what chance leaves.
        if m[pivot][pivot] < 1e-10 {
            break;
        }
        for &row in &left {
            let factor = m[row][pivot] / m[pivot][pivot];
            for &column in &left {
                m[row][column] -= factor * m[pivot][column];
            }
        }
        rank += 1;
    }
    rank
}
