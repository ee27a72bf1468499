//! Calling a system's functions by name, through the runtime's traits.
//!
//! Outputs are filled with NaN before the call: what a function leaves unwritten shows.

use kane::{
    Array, Block, Load, Real, System, block,
    functions::{
        AngleRates, AngularAcceleration, AngularMomentum, AngularVelocity, Bias, Forcing,
        ForwardDynamics, ForwardDynamicsPivots, GeneralizedForces, GravityForces, InverseDynamics,
        KineticEnergy, LinearMomentum, MassCenterAcceleration, MassCenterPosition,
        MassCenterVelocity, MassMatrix, MassMatrixPacked, OriginPosition, OriginVelocity,
        PartialAngularVelocity, PartialAngularVelocityDot, PartialVelocity, PartialVelocityDot,
        PartialVelocityOrigin, PartialVelocityOriginDot, PotentialEnergy, RelativeAngularVelocity,
        RelativeRotation, Rotation, Singularity,
    },
};

/// A trait that stands for several others.
macro_rules! together {
    ($(#[$meaning:meta])* $name:ident: $($trait:ident),+ $(,)?) => {
        $(#[$meaning])*
        pub trait $name<R: Real>: $($trait<R> +)+ {}

        impl<R: Real, S: $($trait<R> +)+> $name<R> for S {}
    };
}

// Here, where it knows the macro.
mod further;

pub use further::{Further, Identified};

/// Everything that a function can be given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Coordinates.
    pub q: Vec<f64>,
    /// Speeds.
    pub u: Vec<f64>,
    /// Their derivatives.
    pub u_dot: Vec<f64>,
    /// Generalized forces.
    pub tau: Vec<f64>,
    /// Force and moment, body after body.
    pub loads: Vec<[f64; 6]>,
    /// Relative angular velocities.
    pub w_rel: Vec<[f64; 3]>,
}

together! {
    /// A system with the functions that have two formulations.
    Dynamics:
        GeneralizedForces,
        MassMatrix,
        MassMatrixPacked,
        Forcing,
        Bias,
        GravityForces,
        InverseDynamics,
        ForwardDynamics,
        ForwardDynamicsPivots,
        KineticEnergy,
        PotentialEnergy,
        LinearMomentum,
        AngularMomentum,
}

/// The state's arrays in a system's own types.
struct Arguments<R: Real, S: System<R>> {
    q: S::Q,
    u: S::U,
    u_dot: S::U,
    tau: S::U,
    loads: S::Loads,
    w_rel: S::Vectors,
}

impl<R: Real, S: System<R>> Arguments<R, S> {
    fn new(state: &State) -> Self {
        let three = |numbers: &[f64]| [0, 1, 2].map(|axis| R::from_f64(numbers[axis]));
        let speeds = |numbers: &[f64]| S::U::from_fn(|place| R::from_f64(numbers[place]));
        Self {
            q: S::Q::from_fn(|place| R::from_f64(state.q[place])),
            u: speeds(&state.u),
            u_dot: speeds(&state.u_dot),
            tau: speeds(&state.tau),
            loads: S::Loads::from_fn(|body| Load {
                force: three(&state.loads[body][..3]),
                moment: three(&state.loads[body][3..]),
            }),
            w_rel: S::Vectors::from_fn(|body| three(&state.w_rel[body])),
        }
    }
}

fn numbers<R: Real + Into<f64>>(values: &[R]) -> Vec<f64> {
    values.iter().map(|&value| value.into()).collect()
}

/// A function that has two formulations.
///
/// # Panics
/// If there is no such function.
pub fn dynamics<R: Real + Into<f64>, S: Dynamics<R>>(
    system: &S,
    function: &str,
    state: &State,
) -> Vec<f64> {
    let Arguments {
        q,
        u,
        u_dot,
        tau,
        loads,
        ..
    } = Arguments::<R, S>::new(state);
    let nan = R::from_f64(f64::NAN);
    let (mut out, mut vector, mut number) = (S::U::filled(nan), [nan; 3], nan);
    match function {
        "mass_matrix" => {
            let mut m = S::Matrix::filled(out);
            system.mass_matrix(&q, &mut m);
            return rows(m.as_ref());
        }
        "mass_matrix_packed" => {
            let mut entries = S::Entries::filled(nan);
            system.mass_matrix_packed(&q, &mut entries);
            return numbers(entries.as_ref());
        }
        "generalized_forces" => system.generalized_forces(&q, &loads, &mut out),
        "forcing" => system.forcing(&q, &u, &loads, &mut out),
        "bias" => system.bias(&q, &u, &mut out),
        "gravity_forces" => system.gravity_forces(&q, &mut out),
        "inverse_dynamics" => system.inverse_dynamics(&q, &u, &u_dot, &mut out),
        "forward_dynamics" => system.forward_dynamics(&q, &u, &tau, &mut out),
        "forward_dynamics_pivots" => system.forward_dynamics_pivots(&q, &mut out),
        "kinetic_energy" => system.kinetic_energy(&q, &u, &mut number),
        "potential_energy" => system.potential_energy(&q, &mut number),
        "linear_momentum" => system.linear_momentum(&q, &u, &mut vector),
        "angular_momentum" => system.angular_momentum(&q, &u, &mut vector),
        _ => unreachable!("`{function}` has no two formulations"),
    }
    match function {
        "kinetic_energy" | "potential_energy" => numbers(&[number]),
        "linear_momentum" | "angular_momentum" => numbers(&vector),
        _ => numbers(out.as_ref()),
    }
}

fn rows<R: Real + Into<f64>, Row: Array<R>>(rows: &[Row]) -> Vec<f64> {
    let rows = rows.iter();
    rows.flat_map(|row| numbers(row.as_ref())).collect()
}

/// Any function that has two formulations.
///
/// # Panics
/// If there is no such function.
pub fn both<R: Real + Into<f64>, S: Dynamics<R> + Further<R>>(
    system: &S,
    function: &str,
    state: &State,
) -> Vec<f64> {
    further::call(system, function, state).unwrap_or_else(|| dynamics(system, function, state))
}

/// Any function.
///
/// # Panics
/// If there is no such function.
pub fn every<R: Real + Into<f64>, S: All<R> + Further<R> + Identified<R>, const NU: usize>(
    system: &S,
    function: &str,
    state: &State,
) -> Vec<f64> {
    further::call(system, function, state)
        .or_else(|| further::identified(system, function, state))
        .unwrap_or_else(|| all::<R, S, NU>(system, function, state))
}

together! {
    /// A system with every function but the further ones.
    All:
        Dynamics,
        RelativeRotation,
        Rotation,
        RelativeAngularVelocity,
        AngularVelocity,
        AngleRates,
        AngularAcceleration,
        PartialAngularVelocity,
        PartialAngularVelocityDot,
        OriginPosition,
        MassCenterPosition,
        OriginVelocity,
        MassCenterVelocity,
        PartialVelocityOrigin,
        PartialVelocityOriginDot,
        PartialVelocity,
        PartialVelocityDot,
        MassCenterAcceleration,
        Singularity,
}

/// Any function but the further ones.
///
/// # Panics
/// If there is no such function.
pub fn all<R: Real + Into<f64>, S: All<R>, const NU: usize>(
    system: &S,
    function: &str,
    state: &State,
) -> Vec<f64> {
    let arguments = Arguments::<R, S>::new(state);
    of_coordinates(system, function, &arguments)
        .or_else(|| per_body(system, function, &arguments))
        .or_else(|| partial::<R, S, NU>(system, function, &arguments))
        .unwrap_or_else(|| dynamics(system, function, state))
}

fn of_coordinates<R: Real + Into<f64>, S: All<R>>(
    system: &S,
    function: &str,
    arguments: &Arguments<R, S>,
) -> Option<Vec<f64>> {
    let Arguments { q, u, .. } = arguments;
    match function {
        "q_dot" => {
            let mut q_dot = S::Q::filled(R::from_f64(f64::NAN));
            system.q_dot(q, u, &mut q_dot);
            Some(numbers(q_dot.as_ref()))
        }
        "normalize" => {
            let mut q = S::Q::from_fn(|place| q.as_ref()[place]);
            system.normalize(&mut q);
            Some(numbers(q.as_ref()))
        }
        _ => None,
    }
}

fn per_body<R: Real + Into<f64>, S: All<R>>(
    system: &S,
    function: &str,
    arguments: &Arguments<R, S>,
) -> Option<Vec<f64>> {
    let Arguments {
        q, u, u_dot, w_rel, ..
    } = arguments;
    let nan = R::from_f64(f64::NAN);
    let mut out = S::Vectors::filled([nan; 3]);
    let mut rotations = S::Rotations::filled([[nan; 3]; 3]);
    match function {
        "singularity" => {
            let mut distances = S::Scalars::filled(nan);
            system.singularity(q, &mut distances);
            return Some(numbers(distances.as_ref()));
        }
        "relative_rotation" => system.relative_rotation(q, &mut rotations),
        "rotation" => system.rotation(q, &mut rotations),
        "relative_angular_velocity" => system.relative_angular_velocity(q, u, &mut out),
        "angular_velocity" => system.angular_velocity(q, u, &mut out),
        "angle_rates" => system.angle_rates(q, w_rel, &mut out),
        "angular_acceleration" => system.angular_acceleration(q, u, u_dot, &mut out),
        "origin_position" => system.origin_position(q, &mut out),
        "mass_center_position" => system.mass_center_position(q, &mut out),
        "origin_velocity" => system.origin_velocity(q, u, &mut out),
        "mass_center_velocity" => system.mass_center_velocity(q, u, &mut out),
        "mass_center_acceleration" => system.mass_center_acceleration(q, u, u_dot, &mut out),
        _ => return None,
    }
    Some(if function.ends_with("rotation") {
        numbers(rotations.as_ref().as_flattened().as_flattened())
    } else {
        numbers(out.as_ref().as_flattened())
    })
}

fn partial<R: Real + Into<f64>, S: All<R>, const NU: usize>(
    system: &S,
    function: &str,
    arguments: &Arguments<R, S>,
) -> Option<Vec<f64>> {
    let Arguments { q, u, .. } = arguments;
    let nan = [R::from_f64(f64::NAN); 3];
    macro_rules! dense {
        ($method:ident($($argument:ident),+), $columns:ident, $blocks:ident) => {{
            let mut columns = S::$columns::filled(nan);
            system.$method($($argument,)+ &mut columns);
            expanded::<R, NU>(columns.as_ref(), S::$blocks, S::BODY_NAMES.len())
        }};
    }
    Some(match function {
        "partial_angular_velocity" => {
            dense!(
                partial_angular_velocity(q),
                PartialAngularVelocityColumns,
                PARTIAL_ANGULAR_VELOCITY_BLOCKS
            )
        }
        "partial_angular_velocity_dot" => dense!(
            partial_angular_velocity_dot(q, u),
            PartialAngularVelocityDotColumns,
            PARTIAL_ANGULAR_VELOCITY_DOT_BLOCKS
        ),
        "partial_velocity_origin" => {
            dense!(
                partial_velocity_origin(q),
                PartialVelocityOriginColumns,
                PARTIAL_VELOCITY_ORIGIN_BLOCKS
            )
        }
        "partial_velocity_origin_dot" => dense!(
            partial_velocity_origin_dot(q, u),
            PartialVelocityOriginDotColumns,
            PARTIAL_VELOCITY_ORIGIN_DOT_BLOCKS
        ),
        "partial_velocity" => dense!(
            partial_velocity(q),
            PartialVelocityColumns,
            PARTIAL_VELOCITY_BLOCKS
        ),
        "partial_velocity_dot" => {
            dense!(
                partial_velocity_dot(q, u),
                PartialVelocityDotColumns,
                PARTIAL_VELOCITY_DOT_BLOCKS
            )
        }
        _ => return None,
    })
}

/// The dense matrices of all bodies. The pattern covers the columns once each, or this is not the output's own.
fn expanded<R: Real + Into<f64>, const NU: usize>(
    columns: &[[R; 3]],
    blocks: &[Block],
    n_bodies: usize,
) -> Vec<f64> {
    let mut next = 0;
    for block in blocks {
        assert_eq!(block.first, next, "blocks follow one another");
        assert!(
            block.speed + block.columns <= NU && block.body < n_bodies,
            "{block:?} fits"
        );
        next += block.columns;
    }
    assert_eq!(next, columns.len(), "the pattern covers every column");
    (0..n_bodies)
        .flat_map(|body| {
            let mut dense = [[R::from_f64(f64::NAN); NU]; 3];
            block::expand(columns, blocks, body, &mut dense);
            numbers(dense.as_flattened())
        })
        .collect()
}
