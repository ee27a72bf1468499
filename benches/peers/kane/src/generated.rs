//! The generated robots.

use std::{ffi::c_void, slice};

use kane::{
    System,
    functions::{
        CoriolisMatrix, ForwardDynamics, ForwardDynamicsDerivatives, InverseDynamics,
        InverseDynamicsDerivatives, Jacobian, JacobianPacked, MassMatrix, MassMatrixInverse,
        MassMatrixInversePacked, MassMatrixPacked, Regressor, RegressorPacked,
    },
};

use crate::{Call, Candidate, Function};

macro_rules! robots {
    ($($name:ident: $link:ident;)*) => {
        $(mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
        })*

        pub(crate) fn candidate(robot: &str, function: Function) -> Candidate {
            match robot {
                $(stringify!($name) => {
                    let call = call::<$name::Prepared<f64>, $name::frames::$link>(function);
                    Candidate::new(call, $name::Prepared::<f64>::nominal())
                })*
                _ => Candidate::NONE,
            }
        }

        pub(crate) fn operations(robot: &str, function: Function) -> usize {
            match robot {
                $(stringify!($name) => total::<$name::Prepared<f64>>(function),)*
                _ => 0,
            }
        }

        pub(crate) fn packed_candidate(robot: &str, function: Function) -> Candidate {
            match robot {
                $(stringify!($name) => {
                    let call = packed_call::<$name::Prepared<f64>, $name::frames::$link>(function);
                    call.map_or(Candidate::NONE, |call| {
                        Candidate::new(call, $name::Prepared::<f64>::nominal())
                    })
                })*
                _ => Candidate::NONE,
            }
        }

        pub(crate) unsafe fn unpack(robot: &str, function: Function, entries: *const f64, m: *mut f64) {
            let (places, length) = match robot {
                $(stringify!($name) => {
                    let places = places::<$name::Prepared<f64>, $name::frames::$link>(function);
                    let columns = if matches!(function, Function::Regressor) { 10 * $name::NB } else { $name::NU };
                    let rows = if matches!(function, Function::Jacobian) { 6 } else { $name::NU };
                    (places, [rows, columns])
                })*
                _ => return,
            };
            let [rows, columns] = length;
            // SAFETY: the arrays are as long as the robot's.
            let (entries, m) = unsafe {
                (slice::from_raw_parts(entries, places.len()), slice::from_raw_parts_mut(m, rows * columns))
            };
            m.fill(0.0);
            for (&entry, &[row, column]) in entries.iter().zip(&places) {
                m[row * columns + column] = entry;
                if matches!(function, Function::MassMatrix | Function::MassMatrixInverse) {
                    m[column * columns + row] = entry;
                }
            }
        }
    };
}

robots! {
    ur5: Wrist_3Link;
    panda: PandaLink7;
    solo12: FlLowerLeg;
    talos: ArmLeft_7Link;
}

fn call<S, F>(function: Function) -> Call
where
    S: InverseDynamics<f64>
        + MassMatrix<f64>
        + ForwardDynamics<f64>
        + Jacobian<f64, F>
        + CoriolisMatrix<f64>
        + MassMatrixInverse<f64>
        + Regressor<f64>
        + InverseDynamicsDerivatives<f64>
        + ForwardDynamicsDerivatives<f64>,
{
    match function {
        Function::InverseDynamics => inverse_dynamics::<S>,
        Function::MassMatrix => mass_matrix::<S>,
        Function::ForwardDynamics => forward_dynamics::<S>,
        Function::Jacobian => jacobian::<S, F>,
        Function::CoriolisMatrix => coriolis_matrix::<S>,
        Function::MassMatrixInverse => mass_matrix_inverse::<S>,
        Function::Regressor => regressor::<S>,
        Function::InverseDynamicsDerivatives => d_inverse_dynamics_d_q_u_u_dot::<S>,
        Function::ForwardDynamicsDerivatives => d_forward_dynamics_d_q_u_tau::<S>,
    }
}

/// What leaves out the entries that the tree makes zero.
fn packed_call<S, F>(function: Function) -> Option<Call>
where
    S: MassMatrixPacked<f64>
        + MassMatrixInversePacked<f64>
        + RegressorPacked<f64>
        + JacobianPacked<f64, F>,
{
    match function {
        Function::MassMatrix => Some(mass_matrix_packed::<S>),
        Function::MassMatrixInverse => Some(mass_matrix_inverse_packed::<S>),
        Function::Regressor => Some(regressor_packed::<S>),
        Function::Jacobian => Some(jacobian_packed::<S, F>),
        _ => None,
    }
}

/// The row and the column of each entry of it.
fn places<S, F>(function: Function) -> Vec<[usize; 2]>
where
    S: MassMatrixPacked<f64>
        + MassMatrixInversePacked<f64>
        + RegressorPacked<f64>
        + JacobianPacked<f64, F>,
{
    match function {
        Function::MassMatrix => <S as MassMatrixPacked<f64>>::PLACES.to_vec(),
        Function::MassMatrixInverse => <S as MassMatrixInversePacked<f64>>::PLACES.to_vec(),
        Function::Regressor => <S as RegressorPacked<f64>>::PLACES.to_vec(),
        Function::Jacobian => {
            let of_row = |row| S::SPEEDS.iter().map(move |speed| [row, *speed]);
            (0..6).flat_map(of_row).collect()
        }
        _ => Vec::new(),
    }
}

fn total<S: System<f64>>(function: Function) -> usize {
    let name = function.name();
    let of = |found: &str| found == name || found.ends_with(&format!("_{name}"));
    let cost = S::OPERATIONS.iter().find(|cost| of(cost.function));
    cost.map_or(0, kane::Cost::total)
}

/// What is given to all, of which each takes the first.
macro_rules! calls {
    ($($method:ident: $trait:ident, [$($given:tt)*];)*) => {$(
        unsafe extern "C" fn $method<S: $trait<f64>>(
            object: *mut c_void,
            q: *const f64,
            u: *const f64,
            x: *const f64,
            out: *mut f64,
        ) {
            let given = (q, u, x);
            // SAFETY: the object is of this type, the arrays are as long as the robot's.
            unsafe { (*object.cast::<S>()).$method($(&*given.$given.cast(),)* &mut *out.cast()) }
        }
    )*};
}

calls! {
    inverse_dynamics: InverseDynamics, [0 1 2];
    forward_dynamics: ForwardDynamics, [0 1 2];
    regressor: Regressor, [0 1 2];
    regressor_packed: RegressorPacked, [0 1 2];
    coriolis_matrix: CoriolisMatrix, [0 1];
    mass_matrix: MassMatrix, [0];
    mass_matrix_packed: MassMatrixPacked, [0];
    mass_matrix_inverse: MassMatrixInverse, [0];
    mass_matrix_inverse_packed: MassMatrixInversePacked, [0];
}

/// Functions of a frame, which write two matrices of three rows.
macro_rules! calls_of_frame {
    ($($method:ident: $trait:ident, $row:ident;)*) => {$(
        unsafe extern "C" fn $method<S: $trait<f64, F>, F>(
            object: *mut c_void,
            q: *const f64,
            _: *const f64,
            _: *const f64,
            rows: *mut f64,
        ) {
            let rows: *mut [S::$row; 3] = rows.cast();
            // SAFETY: the object is of this type, the arrays are as long as the robot's, and there are six rows.
            unsafe {
                let (linear, angular) = (&mut *rows, &mut *rows.add(1));
                (*object.cast::<S>()).$method(&*q.cast(), linear, angular);
            }
        }
    )*};
}

calls_of_frame! {
    jacobian: Jacobian, U;
    jacobian_packed: JacobianPacked, Columns;
}

/// Derivatives, which are three matrices.
macro_rules! calls_of_derivatives {
    ($($method:ident: $trait:ident;)*) => {$(
        unsafe extern "C" fn $method<S: $trait<f64>>(
            object: *mut c_void,
            q: *const f64,
            u: *const f64,
            x: *const f64,
            by: *mut f64,
        ) {
            let by: *mut S::Matrix = by.cast();
            // SAFETY: the object is of this type, the arrays are as long as the robot's, and there are three matrices.
            unsafe {
                let [by_q, by_u, by_x] = [0, 1, 2].map(|block| &mut *by.add(block));
                (*object.cast::<S>()).$method(&*q.cast(), &*u.cast(), &*x.cast(), by_q, by_u, by_x);
            }
        }
    )*};
}

calls_of_derivatives! {
    d_inverse_dynamics_d_q_u_u_dot: InverseDynamicsDerivatives;
    d_forward_dynamics_d_q_u_tau: ForwardDynamicsDerivatives;
}
