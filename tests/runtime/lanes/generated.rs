//! The bundled systems: each function of a group of states, lane by lane that of each state.

#![cfg(all(feature = "eight_body", feature = "cart_pole"))]

use kane::wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use kane::{Lanes, Real};

use super::entries::{Entries, State, lanes_of, same};
use kane_test_support::random::Random;

/// One test a type of lanes: the functions with their arguments.
macro_rules! same_bits {
    ($module:path, $lanes:ident: $($function:ident($($argument:ident),+);)+) => {{
        use $module as system;
        type Scalar = <$lanes as Lanes>::Scalar;
        type Of<R> = State<R, { system::NQ }, { system::NU }, { system::NB }>;

        let mut random = Random::new(super::SEED);
        let numbers: Vec<Vec<Scalar>> = (0..2_000)
            .map(|_| (0..$lanes::LANES).map(|_| Scalar::from_f64(random.symmetric())).collect())
            .collect();
        let mut given = numbers.iter();
        let packed = Of::<$lanes>::new(|| $lanes::load(given.next().unwrap()));
        let states: Vec<Of<Scalar>> = (0..$lanes::LANES)
            .map(|lane| {
                let mut given = numbers.iter();
                Of::new(|| given.next().unwrap()[lane])
            })
            .collect();
        let (prepared, single) = (
            system::Prepared::<$lanes>::nominal(),
            system::Prepared::<Scalar>::nominal(),
        );
        let (zero, zeros) = (Scalar::from_f64(0.0), $lanes::from_f64(0.0));
        $({
            let (mut output, mut found) = (Entries::filled(zeros), Vec::new());
            system::$function(&prepared, $(&packed.$argument,)+ &mut output);
            output.list(&mut found);
            for (lane, state) in states.iter().enumerate() {
                let (mut output, mut expected) = (Entries::filled(zero), Vec::new());
                system::$function(&single, $(&state.$argument,)+ &mut output);
                output.list(&mut expected);
                assert_eq!(found.len(), expected.len());
                for (place, (&found, expected)) in found.iter().zip(expected).enumerate() {
                    assert!(
                        same(lanes_of(found)[lane], expected),
                        "{}, entry {place}, lane {lane}", stringify!($function)
                    );
                }
            }
        })+
    }};
}

macro_rules! cart_pole {
    ($($name:ident: $lanes:ident;)+) => {$(
        #[test]
        fn $name() {
            same_bits!(kane::cart_pole, $lanes:
                rotation(q);
                mass_center_position(q);
                mass_matrix(q);
                q_dot(q, u);
                bias(q, u);
                inverse_dynamics(q, u, u_dot);
                forward_dynamics(q, u, tau);
                kinetic_energy(q, u);
                potential_energy(q);
            );
        }
    )+};
}

cart_pole! {
    a_cart_pole_in_two_f64: f64x2;
    a_cart_pole_in_four_f64: f64x4;
    a_cart_pole_in_eight_f64: f64x8;
    a_cart_pole_in_four_f32: f32x4;
    a_cart_pole_in_eight_f32: f32x8;
    a_cart_pole_in_sixteen_f32: f32x16;
}

macro_rules! eight_bodies {
    ($($name:ident: $lanes:ident;)+) => {$(
        #[test]
        fn $name() {
            with_a_large_stack(|| same_bits!(kane::eight_body, $lanes:
                relative_rotation(q);
                rotation(q);
                relative_angular_velocity(q, u);
                angular_velocity(q, u);
                angle_rates(q, w_rel);
                angular_acceleration(q, u, u_dot);
                partial_angular_velocity(q);
                partial_angular_velocity_dot(q, u);
                origin_position(q);
                mass_center_position(q);
                origin_velocity(q, u);
                mass_center_velocity(q, u);
                partial_velocity_origin(q);
                partial_velocity_origin_dot(q, u);
                partial_velocity(q);
                partial_velocity_dot(q, u);
                mass_center_acceleration(q, u, u_dot);
                generalized_forces(q, loads);
                mass_matrix(q);
                forcing(q, u, loads);
                q_dot(q, u);
                normalize(q);
                bias(q, u);
                inverse_dynamics(q, u, u_dot);
                forward_dynamics(q, u, tau);
                forward_dynamics_pivots(q);
                singularity(q);
                kinetic_energy(q, u);
                potential_energy(q);
                linear_momentum(q, u);
                angular_momentum(q, u);
                mass_matrix_product(q, u_dot);
                mass_matrix_solve(q, tau);
            ));
        }
    )+};
}

/// Without optimization each of ten thousand vectors has places of its own on the stack, several times that of a test.
fn with_a_large_stack(test: fn()) {
    let thread = std::thread::Builder::new().stack_size(1 << 28);
    thread.spawn(test).unwrap().join().unwrap();
}

// The others are made of the same parts, and each costs the compiler some seconds.
eight_bodies! {
    every_function_of_eight_bodies_in_eight_f64: f64x8;
    every_function_of_eight_bodies_in_four_f32: f32x4;
}
