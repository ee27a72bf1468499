//! What a dense matrix says: the velocities of all bodies, column by column, and the mass matrix.

use crate::description::CoordinateName;
use crate::expr::Input;
use crate::functions::{Formulation, Function};
use crate::id::BodyId;
use crate::random::Random;
use crate::tree::Tree;
use crate::tree::mobility::masses::own;
use crate::tree::mobility::rows::{Twist, dot, project_out};
use crate::tree::mobility::sweep::SweptJoint;
use crate::tree::mobility::units::Units;

/// The most that the mass matrix has in rank in a few states.
pub(super) fn rank_of_mass_matrix(tree: &Tree, seed: u64) -> usize {
    let function = Function::find("mass_matrix").unwrap();
    let derived = function.derive(
        tree,
        Formulation::Recursive,
        &crate::recursive::Plan::full(tree),
    );
    let of_state = |seed| {
        let mut random = Random::new(seed);
        let mut q: Vec<f64> = (0..tree.n_coordinates).map(|_| random.signed()).collect();
        for body in &tree.bodies {
            let all = body.joint.coordinates();
            let e: Vec<usize> = all
                .iter()
                .filter(|(kind, _)| kind.starts_with('e'))
                .map(|(_, at)| at.index())
                .collect();
            let length = e.iter().map(|&at| q[at] * q[at]).sum::<f64>().sqrt();
            for at in e {
                q[at] /= length;
            }
        }
        let m = derived.graph.evaluate(&derived.roots, |input| match input {
            Input::Q(at) => q[at.index()],
            other => unreachable!("{other:?} in a mass matrix of numbers"),
        });
        rank_of_energies(m.chunks(tree.n_speeds).map(<[f64]>::to_vec).collect())
    };
    (seed..seed + 3).map(of_state).max().unwrap()
}

/// The rank of a symmetric matrix that is not negative: Cholesky's pivots, the largest first.
fn rank_of_energies(mut m: Vec<Vec<f64>>) -> usize {
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

/// For each free coordinate, body by body, the root of the mass times the velocity of everything.
pub(super) fn velocities(
    tree: &Tree,
    units: &Units,
    joints: &[SweptJoint],
) -> Vec<((BodyId, CoordinateName), Vec<f64>)> {
    let mut columns = Vec::new();
    for moving in tree.body_ids() {
        for (coordinate, unit) in joints[moving.index()]
            .free
            .coordinates
            .iter()
            .zip(&joints[moving.index()].free.columns)
        {
            let mut twists: Vec<Twist> = Vec::new();
            let mut column = Vec::new();
            for body in tree.body_ids() {
                let lower = tree
                    .lower(body)
                    .map_or([0.0; 6], |lower| twists[lower.index()]);
                let carried = joints[body.index()].free.carried;
                let mut twist: Twist =
                    std::array::from_fn(|row| (0..6).map(|i| carried[i][row] * lower[i]).sum());
                if body == moving {
                    twist = *unit;
                }
                // Rotors move with their own speeds alone.
                for (other, rotor) in joints[body.index()]
                    .free
                    .coordinates
                    .iter()
                    .zip(&joints[body.index()].free.rotors)
                {
                    let is_own = body == moving && other == coordinate;
                    column.push(if is_own { *rotor } else { 0.0 });
                }
                column.extend(
                    own(tree, units, body)
                        .rows
                        .iter()
                        .map(|row| dot(row, &twist)),
                );
                twists.push(twist);
            }
            columns.push(((moving, *coordinate), column));
        }
    }
    columns
}

pub(super) fn rank(mut columns: Vec<Vec<f64>>) -> usize {
    let norm = |column: &Vec<f64>| dot(column, column).sqrt();
    let mut rank = 0;
    while let Some(largest) =
        (0..columns.len()).max_by(|a, b| norm(&columns[*a]).total_cmp(&norm(&columns[*b])))
    {
        let column = columns.swap_remove(largest);
        // Entries are of order one, so this is far above rounding and far below what chance leaves.
        if norm(&column) < 1e-7 {
            break;
        }
        let unit: Vec<f64> = column.iter().map(|entry| entry / norm(&column)).collect();
        for other in &mut columns {
            project_out(other, &unit);
        }
        rank += 1;
    }
    rank
}
