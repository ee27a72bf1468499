//! Arrays, loads, blocks and views: what surrounds the generated functions.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops where it cannot go on"
)]

use crate::common::CartPole;
use kane::functions::{Bias, MassMatrix};
use kane::{Array, Block, Load, Real, System, block};

/// `tau = M u_dot + bias`, for any system that has both.
fn inverse_dynamics<R: Real, S: MassMatrix<R> + Bias<R>>(
    system: &S,
    q: &S::Q,
    u: &S::U,
    u_dot: &S::U,
) -> S::U {
    let zero = S::U::filled(R::from_f64(0.0));
    let mut m = S::Matrix::filled(zero);
    let mut tau = zero;
    system.mass_matrix(q, &mut m);
    system.bias(q, u, &mut tau);
    for row in 0..S::U::LEN {
        for column in 0..S::U::LEN {
            tau[row] = tau[row] + m[row][column] * u_dot[column];
        }
    }
    tau
}

#[test]
fn generic_code_needs_no_turbofish() {
    let system = CartPole {
        mass: 0.4,
        gravity: 9.81,
    };
    let tau = inverse_dynamics(&system, &[0.0, 0.0], &[0.0, 3.0], &[1.0, 2.0]);
    assert!(
        (tau[0] - 2.2).abs() < 1e-15 && (tau[1] - 1.2).abs() < 1e-15,
        "{tau:?}"
    );
}

#[test]
#[cfg(feature = "cart_pole")]
fn model_and_costs_of_a_generated_system_are_known_to_generic_code() {
    fn total<S: System<f64>>(_: &S, function: &str) -> usize {
        assert_ne!(S::FINGERPRINT, 0);
        let cost = S::OPERATIONS.iter().find(|cost| cost.function == function);
        cost.unwrap().total()
    }
    let system = kane::cart_pole::Prepared::<f64>::nominal();
    assert_eq!(total(&system, "mass_matrix"), 3);
    assert_eq!(total(&system, "Prepared::new"), 9);
}

#[test]
fn names_and_sizes_belong_to_the_system() {
    fn lengths<R: Real, S: System<R>>(_: &S) -> [usize; 3] {
        assert_eq!(S::Q::LEN, S::COORDINATE_NAMES.len());
        assert_eq!(S::U::LEN, S::SPEED_NAMES.len());
        assert_eq!(S::Scalars::LEN, S::BODY_NAMES.len());
        [S::Q::LEN, S::U::LEN, S::Loads::LEN]
    }
    assert_eq!(
        lengths(&CartPole {
            mass: 0.4_f32,
            gravity: 9.81
        }),
        [2, 2, 2]
    );
}

#[test]
fn no_load_is_the_default() {
    let load = Load::<f32>::default();
    assert_eq!(
        load,
        Load {
            force: [0.0; 3],
            moment: [0.0; 3]
        }
    );
}

#[test]
fn arrays_are_filled_and_built() {
    assert_eq!(<[f64; 3]>::filled(2.0), [2.0; 3]);
    assert_eq!(
        <[usize; 3] as Array<usize>>::from_fn(|index| index * index),
        [0, 1, 4]
    );
}

/// Two bodies, five speeds: body 0 has two free angles, body 1 turns with it and slides along two axes.
const BLOCKS: &[Block] = &[
    Block {
        body: 0,
        partition: 0,
        speed: 0,
        columns: 2,
        first: 0,
    },
    Block {
        body: 1,
        partition: 0,
        speed: 0,
        columns: 2,
        first: 2,
    },
    Block {
        body: 1,
        partition: 3,
        speed: 3,
        columns: 2,
        first: 4,
    },
];

fn columns() -> [[f64; 3]; 6] {
    core::array::from_fn(|column| core::array::from_fn(|row| (10 * column + row) as f64))
}

#[test]
fn blocks_expand_to_their_place_and_zeros_elsewhere() {
    let mut dense = [[7.0; 5]; 3];
    block::expand(&columns(), BLOCKS, 0, &mut dense);
    assert_eq!(dense[0], [0.0, 10.0, 0.0, 0.0, 0.0]);
    assert_eq!(dense[2], [2.0, 12.0, 0.0, 0.0, 0.0]);
    block::expand(&columns(), BLOCKS, 1, &mut dense);
    assert_eq!(dense[0], [20.0, 30.0, 0.0, 40.0, 50.0]);
    assert_eq!(dense[1], [21.0, 31.0, 0.0, 41.0, 51.0]);
    block::expand(&columns(), BLOCKS, 2, &mut dense);
    assert_eq!(dense, [[0.0; 5]; 3]);
}

#[test]
fn blocks_that_do_not_fit_are_passed_over() {
    let mut dense = [[7.0; 4]; 3];
    block::expand(&columns()[..4], BLOCKS, 1, &mut dense);
    assert_eq!(dense[0], [20.0, 30.0, 0.0, 0.0]);
}

// Cholesky and dynamically sized matrices are there with std only.
#[cfg(all(feature = "nalgebra", feature = "std"))]
mod nalgebra_views {
    use super::*;
    use kane::view;
    use nalgebra::{DMatrix, Matrix3x5, SMatrix, Vector2, Vector3};

    const ROWS: [[f64; 3]; 2] = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]];

    #[test]
    fn a_matrix_has_its_rows() {
        let matrix = view::matrix(&ROWS);
        assert_eq!((matrix[(0, 2)], matrix[(1, 0)]), (3.0, 4.0));
        assert_eq!(
            matrix * Vector3::new(1.0, 0.0, -1.0),
            Vector2::new(-2.0, -2.0)
        );
        assert_eq!(view::to_rows(&matrix), ROWS);
    }

    #[test]
    fn a_transposed_view_has_rows_as_columns() {
        let view = view::transposed(&ROWS);
        assert_eq!(
            (view.shape(), view[(2, 0)], view[(0, 1)]),
            ((3, 2), 3.0, 4.0)
        );
        assert_eq!(
            view * Vector2::new(1.0, -1.0),
            Vector3::new(-3.0, -3.0, -3.0)
        );
    }

    #[test]
    fn a_mutable_transposed_view_writes_rows() {
        let mut rows = ROWS;
        let mut view = view::transposed_mut(&mut rows);
        view[(1, 0)] = 9.0;
        view *= 2.0;
        assert_eq!(rows, [[2.0, 18.0, 6.0], [8.0, 10.0, 12.0]]);
    }

    #[test]
    fn vectors_are_views_and_convert_back() {
        let mut q = [1.0, 2.0, 3.0];
        view::vector_mut(&mut q).scale_mut(2.0);
        assert_eq!(q, [2.0, 4.0, 6.0]);
        assert_eq!(view::vector(&q).dot(&Vector3::new(1.0, 1.0, 0.0)), 6.0);
        let copied: [f64; 3] = (view::vector(&q) * 0.5).into();
        assert_eq!(copied, [1.0, 2.0, 3.0]);
    }

    #[test]
    fn a_rotation_turns_inertial_into_body_components() {
        // A body turned by +90° about x sees the inertial y axis along its -z axis.
        let rotation = view::rotation(&[[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]);
        let y = Vector3::y();
        assert_eq!(rotation * y, -Vector3::z());
        assert_eq!(rotation.inverse() * (rotation * y), y);
    }

    #[test]
    fn blocks_expand_into_matrices_and_views() {
        let mut rows = [[7.0; 5]; 3];
        block::expand(&columns(), BLOCKS, 1, &mut rows);
        let mut matrix = Matrix3x5::repeat(7.0);
        block::expand_matrix(&columns(), BLOCKS, 1, &mut matrix);
        assert_eq!(matrix, view::matrix(&rows));

        let mut all = DMatrix::repeat(6, 5, 7.0);
        block::expand_matrix(&columns(), BLOCKS, 1, &mut all.fixed_rows_mut::<3>(3));
        assert_eq!(all.fixed_rows::<3>(3), matrix);
        assert_eq!(all.fixed_rows::<3>(0), SMatrix::<f64, 3, 5>::repeat(7.0));
    }

    #[test]
    fn a_mass_matrix_is_symmetric_and_positive_definite() {
        let system = CartPole {
            mass: 0.4,
            gravity: 9.81,
        };
        let mut m = [[0.0; 2]; 2];
        system.mass_matrix(&[0.0, 0.7], &mut m);
        let m = view::matrix(&m);
        assert_eq!(m, m.transpose());
        assert!(m.cholesky().is_some());
    }
}
