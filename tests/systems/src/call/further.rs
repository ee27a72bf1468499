//! What controllers call beside the dynamics: matrices, loads, mass centres, regressors. References are without these, for the
//! seconds of the compiler.

use kane::{
    Array, Real,
    functions::{
        BaseParameters, BaseRegressor, CenterOfMass, CenterOfMassJacobian,
        CenterOfMassJacobianDotU, CenterOfMassVelocity, CentroidalMomentumMatrix,
        CentroidalMomentumMatrixDotU, CoriolisMatrix, HybridDynamics, InertialParameters,
        JointRegressor, JointWrenches, KineticEnergies, LoadedForwardDynamics,
        LoadedInverseDynamics, MassMatrixDot, MassMatrixFactors, MassMatrixInverse,
        MassMatrixInversePacked, MassMatrixProduct, MassMatrixSolve, PotentialEnergies, Regressor,
        RegressorPacked,
    },
};

use super::{Arguments, State, numbers, rows};

together! {
    /// A system with these functions.
    Further:
        MassMatrixProduct,
        MassMatrixSolve,
        MassMatrixFactors,
        MassMatrixInverse,
        MassMatrixInversePacked,
        CoriolisMatrix,
        MassMatrixDot,
        LoadedInverseDynamics,
        LoadedForwardDynamics,
        KineticEnergies,
        PotentialEnergies,
        JointWrenches,
        HybridDynamics,
        CenterOfMass,
        CenterOfMassVelocity,
        CenterOfMassJacobian,
        CenterOfMassJacobianDotU,
        CentroidalMomentumMatrix,
        CentroidalMomentumMatrixDotU,
        Regressor,
        RegressorPacked,
        BaseRegressor,
}

together! {
    /// A system with what identification needs beside these, which has one formulation.
    Identified:
        InertialParameters,
        BaseParameters,
        JointRegressor,
}

/// What such a function writes; `None` for others.
pub(super) fn call<R: Real + Into<f64>, S: Further<R>>(
    system: &S,
    function: &str,
    state: &State,
) -> Option<Vec<f64>> {
    let arguments = Arguments::<R, S>::new(state);
    matrices(system, function, &arguments)
        .or_else(|| forces(system, function, &arguments))
        .or_else(|| of_center(system, function, &arguments))
        .or_else(|| regressor(system, function, &arguments))
}

fn matrices<R: Real + Into<f64>, S: Further<R>>(
    system: &S,
    function: &str,
    Arguments { q, u, .. }: &Arguments<R, S>,
) -> Option<Vec<f64>> {
    macro_rules! whole {
        ($trait:ident::$method:ident($($argument:ident),+)) => {{
            let nan = S::U::filled(R::from_f64(f64::NAN));
            let mut m = S::Matrix::filled(nan);
            system.$method($($argument,)+ &mut m);
            rows(m.as_ref())
        }};
    }
    macro_rules! packed {
        ($trait:ident::$method:ident) => {{
            let mut entries = <S as $trait<R>>::Entries::filled(R::from_f64(f64::NAN));
            system.$method(q, &mut entries);
            numbers(entries.as_ref())
        }};
    }
    Some(match function {
        "coriolis_matrix" => whole!(CoriolisMatrix::coriolis_matrix(q, u)),
        "mass_matrix_dot" => whole!(MassMatrixDot::mass_matrix_dot(q, u)),
        "mass_matrix_inverse" => whole!(MassMatrixInverse::mass_matrix_inverse(q)),
        "mass_matrix_inverse_packed" => {
            packed!(MassMatrixInversePacked::mass_matrix_inverse_packed)
        }
        "mass_matrix_factors" => packed!(MassMatrixFactors::mass_matrix_factors),
        _ => return None,
    })
}

fn forces<R: Real + Into<f64>, S: Further<R>>(
    system: &S,
    function: &str,
    arguments: &Arguments<R, S>,
) -> Option<Vec<f64>> {
    let Arguments {
        q,
        u,
        u_dot,
        tau,
        loads,
        ..
    } = arguments;
    let mut out = S::U::filled(R::from_f64(f64::NAN));
    match function {
        "mass_matrix_product" => system.mass_matrix_product(q, u_dot, &mut out),
        "mass_matrix_solve" => system.mass_matrix_solve(q, tau, &mut out),
        "loaded_inverse_dynamics" => {
            system.loaded_inverse_dynamics(q, u, u_dot, loads, &mut out);
        }
        "loaded_forward_dynamics" => {
            system.loaded_forward_dynamics(q, u, tau, loads, &mut out);
        }
        "joint_wrenches" => {
            let [mut force, mut moment] = [S::Vectors::filled([R::from_f64(f64::NAN); 3]); 2];
            system.joint_wrenches(q, u, u_dot, loads, &mut force, &mut moment);
            let parts = [force, moment].map(|part| numbers(part.as_ref().as_flattened()));
            return Some(parts.concat());
        }
        "hybrid_dynamics" => {
            let mut whole_tau = out;
            system.hybrid_dynamics(q, u, u_dot, tau, &mut out, &mut whole_tau);
            return Some([out, whole_tau].map(|part| numbers(part.as_ref())).concat());
        }
        _ => return energies(system, function, arguments),
    }
    Some(numbers(out.as_ref()))
}

fn energies<R: Real + Into<f64>, S: Further<R>>(
    system: &S,
    function: &str,
    Arguments { q, u, .. }: &Arguments<R, S>,
) -> Option<Vec<f64>> {
    let mut energies = S::Scalars::filled(R::from_f64(f64::NAN));
    match function {
        "kinetic_energies" => system.kinetic_energies(q, u, &mut energies),
        "potential_energies" => system.potential_energies(q, &mut energies),
        _ => return None,
    }
    Some(numbers(energies.as_ref()))
}

fn of_center<R: Real + Into<f64>, S: Further<R>>(
    system: &S,
    function: &str,
    Arguments { q, u, .. }: &Arguments<R, S>,
) -> Option<Vec<f64>> {
    let nan = R::from_f64(f64::NAN);
    let [mut first, mut second] = [[nan; 3]; 2];
    let [mut linear, mut angular] = [[S::U::filled(nan); 3]; 2];
    match function {
        "center_of_mass" => system.center_of_mass(q, &mut first),
        "center_of_mass_velocity" => system.center_of_mass_velocity(q, u, &mut first),
        "center_of_mass_jacobian_dot_u" => {
            system.center_of_mass_jacobian_dot_u(q, u, &mut first);
        }
        "centroidal_momentum_matrix_dot_u" => {
            system.centroidal_momentum_matrix_dot_u(q, u, &mut first, &mut second);
            return Some(numbers([first, second].as_flattened()));
        }
        "center_of_mass_jacobian" => {
            system.center_of_mass_jacobian(q, &mut linear);
            return Some(rows(&linear));
        }
        "centroidal_momentum_matrix" => {
            system.centroidal_momentum_matrix(q, &mut linear, &mut angular);
            return Some([rows(&linear), rows(&angular)].concat());
        }
        _ => return None,
    }
    Some(numbers(&first))
}

fn regressor<R: Real + Into<f64>, S: Further<R>>(
    system: &S,
    function: &str,
    Arguments { q, u, u_dot, .. }: &Arguments<R, S>,
) -> Option<Vec<f64>> {
    let nan = R::from_f64(f64::NAN);
    match function {
        "regressor" => {
            let row = <S as Regressor<R>>::Row::filled([nan; 10]);
            let mut y = <S as Regressor<R>>::Rows::filled(row);
            system.regressor(q, u, u_dot, &mut y);
            let rows = y.as_ref().iter();
            let numbers = rows.flat_map(|row| numbers(row.as_ref().as_flattened()));
            Some(numbers.collect())
        }
        "regressor_packed" => {
            let mut entries = <S as RegressorPacked<R>>::Entries::filled(nan);
            system.regressor_packed(q, u, u_dot, &mut entries);
            Some(numbers(entries.as_ref()))
        }
        "base_regressor" => {
            let row = <S as BaseRegressor<R>>::Row::filled(nan);
            let mut y = <S as BaseRegressor<R>>::Rows::filled(row);
            system.base_regressor(q, u, u_dot, &mut y);
            Some(rows(y.as_ref()))
        }
        _ => None,
    }
}

/// What such a function writes; `None` for others.
pub(super) fn identified<R: Real + Into<f64>, S: Identified<R>>(
    system: &S,
    function: &str,
    state: &State,
) -> Option<Vec<f64>> {
    let Arguments { q, u, u_dot, .. } = &Arguments::<R, S>::new(state);
    let nan = R::from_f64(f64::NAN);
    match function {
        "inertial_parameters" => {
            let mut pi = S::Inertial::filled([nan; 10]);
            system.inertial_parameters(&mut pi);
            Some(numbers(pi.as_ref().as_flattened()))
        }
        "base_parameters" => {
            let mut pi = S::Base::filled(nan);
            system.base_parameters(&mut pi);
            Some(numbers(pi.as_ref()))
        }
        "joint_regressor" => {
            let mut y = S::Terms::filled([nan; 3]);
            system.joint_regressor(q, u, u_dot, &mut y);
            Some(numbers(y.as_ref().as_flattened()))
        }
        _ => None,
    }
}
