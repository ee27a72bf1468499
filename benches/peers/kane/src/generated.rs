//! The generated robots.

use std::ffi::c_void;

use kane::functions::{self, ForwardDynamics, InverseDynamics, MassMatrix, MassMatrixPacked};

use crate::{Call, Candidate, Function};

macro_rules! robots {
    ($($name:ident)*) => {
        $(mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
        })*

        pub(crate) fn candidate(robot: &str, function: Function) -> Candidate {
            match robot {
                $(stringify!($name) => {
                    Candidate::new(call::<$name::Prepared<f64>>(function), $name::Prepared::<f64>::nominal())
                })*
                _ => Candidate::NONE,
            }
        }

        pub(crate) fn packed_candidate(robot: &str) -> Candidate {
            match robot {
                $(stringify!($name) => {
                    Candidate::new(mass_matrix_packed::<$name::Prepared<f64>>, $name::Prepared::<f64>::nominal())
                })*
                _ => Candidate::NONE,
            }
        }

        pub(crate) unsafe fn unpack(robot: &str, entries: *const f64, m: *mut f64) {
            match robot {
                $(stringify!($name) => {
                    // SAFETY: the arrays are as long as the robot's.
                    let (entries, m): (&[f64; $name::MASS_MATRIX_PACKED_LEN], &mut [[f64; $name::NU]; $name::NU]) =
                        unsafe { (&*entries.cast(), &mut *m.cast()) };
                    functions::unpack(entries, $name::MASS_MATRIX_PACKED_PLACES, m);
                })*
                _ => {}
            }
        }
    };
}

robots!(ur5 panda solo12 talos);

fn call<S>(function: Function) -> Call
where
    S: InverseDynamics<f64> + MassMatrix<f64> + ForwardDynamics<f64>,
{
    match function {
        Function::InverseDynamics => inverse_dynamics::<S>,
        Function::MassMatrix => mass_matrix::<S>,
        Function::ForwardDynamics => forward_dynamics::<S>,
    }
}

unsafe extern "C" fn inverse_dynamics<S: InverseDynamics<f64>>(
    object: *mut c_void,
    q: *const f64,
    u: *const f64,
    u_dot: *const f64,
    tau: *mut f64,
) {
    // SAFETY: the object is of this type, the arrays are as long as the robot's.
    unsafe {
        (*object.cast::<S>()).inverse_dynamics(
            &*q.cast(),
            &*u.cast(),
            &*u_dot.cast(),
            &mut *tau.cast(),
        );
    }
}

unsafe extern "C" fn mass_matrix<S: MassMatrix<f64>>(
    object: *mut c_void,
    q: *const f64,
    _: *const f64,
    _: *const f64,
    m: *mut f64,
) {
    // SAFETY: the object is of this type, the arrays are as long as the robot's.
    unsafe { (*object.cast::<S>()).mass_matrix(&*q.cast(), &mut *m.cast()) }
}

unsafe extern "C" fn mass_matrix_packed<S: MassMatrixPacked<f64>>(
    object: *mut c_void,
    q: *const f64,
    _: *const f64,
    _: *const f64,
    entries: *mut f64,
) {
    // SAFETY: the object is of this type, the arrays are as long as the robot's.
    unsafe { (*object.cast::<S>()).mass_matrix_packed(&*q.cast(), &mut *entries.cast()) }
}

unsafe extern "C" fn forward_dynamics<S: ForwardDynamics<f64>>(
    object: *mut c_void,
    q: *const f64,
    u: *const f64,
    tau: *const f64,
    u_dot: *mut f64,
) {
    // SAFETY: the object is of this type, the arrays are as long as the robot's.
    unsafe {
        (*object.cast::<S>()).forward_dynamics(
            &*q.cast(),
            &*u.cast(),
            &*tau.cast(),
            &mut *u_dot.cast(),
        );
    }
}
