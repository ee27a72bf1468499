//! Energies and momenta.

use crate::{Real, System};

function_traits! {
    /// Kinetic energy in the inertial frame, J.
    "`{Self}` was generated without `kinetic_energy`; name it in `functions`, alone and not in a sum, and generate again"
    KineticEnergy: kinetic_energy(q: &Self::Q, u: &Self::U, energy: &mut R);

    /// Potential energy, J: that of weight, zero at the inertial origin, and that of springs, zero at rest.
    "`{Self}` was generated without `potential_energy`; name it in `functions`, alone and not in a sum, and generate again"
    PotentialEnergy: potential_energy(q: &Self::Q, energy: &mut R);

    /// Linear momentum of the whole system, inertial components, kg m/s.
    "`{Self}` was generated without `linear_momentum`; name it in `functions`, alone and not in a sum, and generate again"
    LinearMomentum: linear_momentum(q: &Self::Q, u: &Self::U, out: &mut [R; 3]);

    /// Angular momentum of the whole system about the inertial origin, inertial components, kg m²/s.
    "`{Self}` was generated without `angular_momentum`; name it in `functions`, alone and not in a sum, and generate again"
    AngularMomentum: angular_momentum(q: &Self::Q, u: &Self::U, out: &mut [R; 3]);

    /// Kinetic energy of each body in the inertial frame, including the rotors of its joint, J.
    "`{Self}` was generated without `kinetic_energies`; name it in `functions`, alone and not in a sum, and generate again"
    KineticEnergies: kinetic_energies(q: &Self::Q, u: &Self::U, energies: &mut Self::Scalars);

    /// Potential energy of each body, including the springs of its joint, J: that of weight is zero at the inertial
    /// origin, that of a spring at rest.
    "`{Self}` was generated without `potential_energies`; name it in `functions`, alone and not in a sum, and generate again"
    PotentialEnergies: potential_energies(q: &Self::Q, energies: &mut Self::Scalars);
}
