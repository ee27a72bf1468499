//! What the program of the comparison loads: for each robot and function one C function and what it works on.
//!
//! Arrays are as long as the robot's coordinates and speeds. The third, `x`, is `u_dot` for inverse dynamics, its
//! derivatives and the regressor, `tau` for forward dynamics and its derivatives. Neither library is told that its arguments
//! are finite, and both are called as a user calls them.

use std::{
    ffi::{CStr, c_char, c_void},
    ptr,
};

mod dynibo;
mod generated;

/// A function with its object first, then `q`, `u`, `x` and the output.
type Call = unsafe extern "C" fn(*mut c_void, *const f64, *const f64, *const f64, *mut f64);

/// A function and its object, which lives as long as the process; both null where there is none.
#[repr(C)]
pub struct Candidate {
    call: Option<Call>,
    object: *mut c_void,
}

impl Candidate {
    const NONE: Self = Self {
        call: None,
        object: ptr::null_mut(),
    };

    fn new<T>(call: Call, object: T) -> Self {
        Self {
            call: Some(call),
            object: Box::into_raw(Box::new(object)).cast(),
        }
    }
}

/// A function of the comparison, by the number by which the program calls it.
#[derive(Clone, Copy)]
enum Function {
    InverseDynamics,
    MassMatrix,
    ForwardDynamics,
    Jacobian,
    CoriolisMatrix,
    MassMatrixInverse,
    Regressor,
    InverseDynamicsDerivatives,
    ForwardDynamicsDerivatives,
}

impl Function {
    fn new(number: u32) -> Option<Self> {
        match number {
            0 => Some(Self::InverseDynamics),
            1 => Some(Self::MassMatrix),
            2 => Some(Self::ForwardDynamics),
            3 => Some(Self::Jacobian),
            4 => Some(Self::CoriolisMatrix),
            5 => Some(Self::MassMatrixInverse),
            6 => Some(Self::Regressor),
            7 => Some(Self::InverseDynamicsDerivatives),
            8 => Some(Self::ForwardDynamicsDerivatives),
            _ => None,
        }
    }

    /// How its name in a generated module ends; before that stands a frame's, if anything.
    fn name(self) -> &'static str {
        match self {
            Self::InverseDynamics => "inverse_dynamics",
            Self::MassMatrix => "mass_matrix",
            Self::ForwardDynamics => "forward_dynamics",
            Self::Jacobian => "jacobian",
            Self::CoriolisMatrix => "coriolis_matrix",
            Self::MassMatrixInverse => "mass_matrix_inverse",
            Self::Regressor => "regressor",
            Self::InverseDynamicsDerivatives => "d_inverse_dynamics_d_q_u_u_dot",
            Self::ForwardDynamicsDerivatives => "d_forward_dynamics_d_q_u_tau",
        }
    }
}

/// A function of a generated robot; matrices row by row, whole, of the Jacobian the linear rows first, of derivatives those by
/// `q`, then by `u`, then by `x`.
///
/// # Safety
/// `robot` is a C string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kane_candidate(robot: *const c_char, function: u32) -> Candidate {
    // SAFETY: as the caller promises.
    let robot = unsafe { CStr::from_ptr(robot) };
    let found = Function::new(function).zip(robot.to_str().ok());
    found.map_or(Candidate::NONE, |(function, robot)| {
        generated::candidate(robot, function)
    })
}

/// The operations of a function of a generated robot, 0 where there is none.
///
/// # Safety
/// `robot` is a C string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kane_operations(robot: *const c_char, function: u32) -> usize {
    // SAFETY: as the caller promises.
    let robot = unsafe { CStr::from_ptr(robot) }.to_string_lossy();
    Function::new(function).map_or(0, |function| generated::operations(&robot, function))
}

/// The packed form of a function of a generated robot, where it has one.
///
/// # Safety
/// `robot` is a C string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kane_packed_candidate(robot: *const c_char, function: u32) -> Candidate {
    // SAFETY: as the caller promises.
    let robot = unsafe { CStr::from_ptr(robot) }.to_string_lossy();
    let function = Function::new(function);
    function.map_or(Candidate::NONE, |function| {
        generated::packed_candidate(&robot, function)
    })
}

/// Writes the whole of a generated robot's packed matrix, row by row.
///
/// # Safety
/// `robot` is a C string of a robot that is there, the arrays are as long as its matrices.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kane_unpack(
    robot: *const c_char,
    function: u32,
    entries: *const f64,
    m: *mut f64,
) {
    // SAFETY: as the caller promises.
    unsafe {
        let robot = CStr::from_ptr(robot).to_string_lossy();
        if let Some(function) = Function::new(function) {
            generated::unpack(&robot, function, entries, m);
        }
    }
}

/// A function of the robot that dynibo reads from a URDF; the mass matrix column by column, whole.
///
/// # Safety
/// `urdf` is a C string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dynibo_candidate(
    urdf: *const c_char,
    floating: bool,
    function: u32,
) -> Candidate {
    // SAFETY: as the caller promises.
    let urdf = unsafe { CStr::from_ptr(urdf) };
    let found = Function::new(function).zip(urdf.to_str().ok());
    found.map_or(Candidate::NONE, |(function, urdf)| {
        dynibo::candidate(urdf, floating, function)
    })
}

/// The place among dynibo's joints of the joint with this name, -1 where there is none.
///
/// # Safety
/// Both are C strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dynibo_joint(urdf: *const c_char, name: *const c_char) -> isize {
    // SAFETY: as the caller promises.
    let (urdf, name) = unsafe { (CStr::from_ptr(urdf), CStr::from_ptr(name)) };
    let place = dynibo::joint(&urdf.to_string_lossy(), &name.to_string_lossy());
    place.map_or(-1, usize::cast_signed)
}
