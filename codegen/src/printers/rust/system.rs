//! The trait that every system has, and that of systems with parameters.

use quote::quote;
use syn::{Item, parse_quote};

use super::text::ident;
use crate::{
    functions::{N_PARAMETERS, PARAMETER_NAMES},
    listing::Facts,
};

/// Its implementation by `Prepared`.
pub(super) fn item(facts: &Facts) -> Item {
    let normalize = facts.has_quaternions().then(|| {
        quote! {
            #[inline]
            fn normalize(&self, q: &mut [R; NQ]) {
                let given = *q;
                self::normalize(self, &given, q);
            }
        }
    });
    parse_quote! {
        impl<R: kane::Real> kane::System<R> for Prepared<R> {
            type Q = [R; NQ];
            type U = [R; NU];
            type Matrix = [[R; NU]; NU];
            type Loads = [kane::Load<R>; NB];
            type Scalars = [R; NB];
            type Vectors = [[R; 3]; NB];
            type Rotations = [[[R; 3]; 3]; NB];
            const NAME: &'static str = NAME;
            const LOWER_BODIES: &'static [usize] = &LOWER_BODIES;
            const BODY_NAMES: &'static [&'static str] = &BODY_NAMES;
            const COORDINATE_NAMES: &'static [&'static str] = &COORDINATE_NAMES;
            const SPEED_NAMES: &'static [&'static str] = &SPEED_NAMES;
            const SPEED_BODIES: &'static [usize] = &SPEED_BODIES;
            const JOINTS: &'static [kane::Joint] = &JOINTS;
            const FRAMES: &'static [kane::Frame] = &FRAMES;
            const LOWER_LIMITS: &'static [f64] = &LOWER_LIMITS;
            const UPPER_LIMITS: &'static [f64] = &UPPER_LIMITS;
            const VELOCITY_LIMITS: &'static [f64] = &VELOCITY_LIMITS;
            const EFFORT_LIMITS: &'static [f64] = &EFFORT_LIMITS;
            const FRICTION: &'static [f64] = &FRICTION;
            const FINGERPRINT: u64 = FINGERPRINT;
            const OPERATIONS: &'static [kane::Cost] = &OPERATIONS;
            #[inline]
            fn q_dot(&self, q: &[R; NQ], u: &[R; NU], q_dot: &mut [R; NQ]) {
                self::q_dot(self, q, u, q_dot);
            }
            #normalize
        }
    }
}

/// The values set at run time as an array, in modules that have some, or derivatives by them.
pub(super) fn parametric(facts: &Facts) -> Option<Item> {
    let length = ident(&facts.sizes.named(N_PARAMETERS)?.name);
    let names = ident(PARAMETER_NAMES);
    Some(parse_quote! {
        impl<R: kane::Real> kane::Parametric<R> for Prepared<R> {
            type Values = [R; #length];
            type ByParameters = [[R; #length]; NU];
            const PARAMETER_NAMES: &'static [&'static str] = &#names;
            #[inline]
            fn nominal_values() -> [R; #length] {
                Parameters::default().to_array()
            }
            #[inline]
            fn with_values(values: &[R; #length]) -> Self {
                Self::new(&Parameters::from_array(*values))
            }
        }
    })
}
