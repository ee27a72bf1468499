//! dynibo, which reads the URDF when it runs.
//!
//! A floating base comes first in every array: position and quaternion (x, y, z, w) in `q`; angular, then linear components,
//! both in inertial axes, in the others. Its state is made from these within the call, a copy of nineteen numbers.

use std::{ffi::c_void, slice};

use dynibo::{BaseState, Error, FloatingRobot, Frame, Robot, RobotModel, Twist};
use nalgebra::{Quaternion, Translation3, UnitQuaternion, Vector3};

use crate::{Candidate, Function};

/// What a call works on.
struct Object {
    robot: Model,
    function: Quantity,
    n_coordinates: usize,
    n_speeds: usize,
}

/// What dynibo and this comparison have in common.
#[derive(Clone, Copy)]
enum Quantity {
    InverseDynamics,
    MassMatrix,
    ForwardDynamics,
}

impl Quantity {
    fn new(function: Function) -> Option<Self> {
        match function {
            Function::InverseDynamics => Some(Self::InverseDynamics),
            Function::MassMatrix => Some(Self::MassMatrix),
            Function::ForwardDynamics => Some(Self::ForwardDynamics),
            _ => None,
        }
    }
}

enum Model {
    Fixed(Robot),
    Floating(FloatingRobot),
}

pub(crate) fn candidate(urdf: &str, floating: bool, function: Function) -> Candidate {
    let Some(function) = Quantity::new(function) else {
        return Candidate::NONE;
    };
    object(urdf, floating, function).map_or_else(
        |error| {
            eprintln!("dynibo does not take {urdf}: {error}");
            Candidate::NONE
        },
        |object| Candidate::new(call, object),
    )
}

fn object(urdf: &str, floating: bool, function: Quantity) -> Result<Object, Error> {
    let model = RobotModel::from_urdf(urdf)?;
    let n = model.joint_count();
    let (robot, n_coordinates, n_speeds) = if floating {
        (Model::Floating(model.floating_robot()?), n + 7, n + 6)
    } else {
        (Model::Fixed(model.robot()), n, n)
    };
    Ok(Object {
        robot,
        function,
        n_coordinates,
        n_speeds,
    })
}

pub(crate) fn joint(urdf: &str, name: &str) -> Option<usize> {
    let model = RobotModel::from_urdf(urdf).ok()?;
    (0..model.joint_count()).find(|i| model.joint_name(*i).is_ok_and(|found| found == name))
}

unsafe extern "C" fn call(
    object: *mut c_void,
    q: *const f64,
    u: *const f64,
    x: *const f64,
    out: *mut f64,
) {
    // SAFETY: the object is one of ours, and the arrays are as long as the robot's; those that a function has no use for too.
    let (object, q, u, x) = unsafe {
        let object = &mut *object.cast::<Object>();
        let (n_coordinates, n_speeds) = (object.n_coordinates, object.n_speeds);
        (
            object,
            slice::from_raw_parts(q, n_coordinates),
            slice::from_raw_parts(u, n_speeds),
            slice::from_raw_parts(x, n_speeds),
        )
    };
    let n_out = match object.function {
        Quantity::MassMatrix => object.n_speeds * object.n_speeds,
        Quantity::InverseDynamics | Quantity::ForwardDynamics => object.n_speeds,
    };
    // SAFETY: as above.
    let out = unsafe { slice::from_raw_parts_mut(out, n_out) };
    let done = match &mut object.robot {
        Model::Fixed(robot) => match object.function {
            Quantity::InverseDynamics => robot.inverse_dynamics(q, u, x, &[], out),
            Quantity::MassMatrix => robot.mass_matrix(q, out),
            Quantity::ForwardDynamics => robot.forward_dynamics(q, u, x, &[], out),
        },
        Model::Floating(robot) => floating(robot, object.function, [q, u, x], out),
    };
    if let Err(error) = done {
        panic!("dynibo: {error}");
    }
}

fn floating(
    robot: &mut FloatingRobot,
    function: Quantity,
    [q, u, x]: [&[f64]; 3],
    out: &mut [f64],
) -> Result<(), Error> {
    let frame = Frame::from_parts(
        Translation3::from(vector(q)),
        UnitQuaternion::new_unchecked(Quaternion::new(q[6], q[3], q[4], q[5])),
    );
    let (q, joints) = (&q[7..], &u[6..]);
    match function {
        Quantity::InverseDynamics => {
            let base = BaseState::new(frame, twist(u), twist(x))?;
            robot.inverse_dynamics(&base, q, joints, &x[6..], &[], out)
        }
        Quantity::MassMatrix => robot.mass_matrix(&BaseState::stationary(frame)?, q, out),
        Quantity::ForwardDynamics => {
            let base = BaseState::new(frame, twist(u), Twist::zeros())?;
            robot.forward_dynamics(&base, q, joints, x, &[], out)
        }
    }
}

fn vector(from: &[f64]) -> Vector3<f64> {
    Vector3::new(from[0], from[1], from[2])
}

fn twist(from: &[f64]) -> Twist {
    Twist::new(vector(from), vector(&from[3..]))
}
