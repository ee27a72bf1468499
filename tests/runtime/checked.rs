//! Checked forward dynamics: the same bits where it answers, and who is to blame where it does not.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops where it cannot go on"
)]

use kane_test_support::random::Random;

use crate::common::{CartPole, Gimbal};
use kane::Real;
use kane::checked::{CheckError, Limits, forward_dynamics};
use kane::functions::ForwardDynamics;

const SOUND: Gimbal<f64> = Gimbal {
    pivots: [4.0, 3.0, 2.0, 1.0],
};

fn check(system: &Gimbal<f64>, theta_2: f64, limits: &Limits) -> Result<[f64; 4], CheckError> {
    let mut u_dot = [9.0; 4];
    let q = [0.0, 0.0, theta_2, 0.0];
    let result = forward_dynamics(system, &q, &[0.0; 4], &[12.0; 4], &mut u_dot, limits);
    if result.is_err() {
        assert_eq!(u_dot, [9.0; 4], "u_dot was written in spite of the error");
    }
    result.map(|()| u_dot)
}

#[test]
fn a_sound_state_gives_the_unchecked_bits() {
    assert_eq!(
        check(&SOUND, 0.3, &Limits::default()),
        Ok([3.0, 4.0, 6.0, 12.0])
    );

    let system = CartPole {
        mass: 0.4,
        gravity: 9.81,
    };
    let mut random = Random::new(1);
    for _ in 0..100 {
        let [q, u, tau]: [[f64; 2]; 3] =
            core::array::from_fn(|_| core::array::from_fn(|_| 3.0 * random.symmetric()));
        let (mut checked, mut unchecked) = ([0.0; 2], [0.0; 2]);
        forward_dynamics(&system, &q, &u, &tau, &mut checked, &Limits::default()).unwrap();
        system.forward_dynamics(&q, &u, &tau, &mut unchecked);
        assert_eq!(checked.map(f64::to_bits), unchecked.map(f64::to_bits));
    }
}

#[test]
fn single_precision_is_checked_too() {
    let system = Gimbal {
        pivots: [1.0_f32, 1.0, -1.0, 1.0],
    };
    let mut u_dot = [9.0_f32; 4];
    let zero = [0.0; 4];
    let result = forward_dynamics(&system, &zero, &zero, &zero, &mut u_dot, &Limits::default());
    assert!(
        matches!(
            result,
            Err(CheckError::Pivot {
                speed: "rotor_theta2_dot",
                ..
            })
        ),
        "{result:?}"
    );
}

#[test]
fn angles_near_their_singularity_are_named() {
    let error = check(&SOUND, core::f64::consts::FRAC_PI_2, &Limits::default()).unwrap_err();
    let text = error.to_string();
    assert!(
        text.starts_with(
            "the angles of body `rotor` are 6.123233995736766e-17 from their singularity"
        ),
        "{text}"
    );
    assert!(text.ends_with("at least 1e-2 is required"), "{text}");
}

#[test]
fn the_caller_chooses_the_least_distance() {
    let theta_2 = 1.57;
    let distance = <f64 as Real>::sin_cos(theta_2).1;
    let limits = |least_distance| Limits {
        least_distance,
        ..Limits::default()
    };
    assert!(check(&SOUND, theta_2, &limits(distance)).is_ok());
    let least = distance.next_up();
    let expected = CheckError::Singularity {
        body: "rotor",
        distance,
        least,
    };
    assert_eq!(check(&SOUND, theta_2, &limits(least)), Err(expected));
}

#[test]
fn a_pivot_that_is_not_positive_is_named() {
    for pivot in [-1.0, 0.0, -0.0] {
        let system = Gimbal {
            pivots: [4.0, 3.0, 2.0, pivot],
        };
        let expected = CheckError::Pivot {
            body: "rotor",
            speed: "rotor_theta3_dot",
            pivot,
            least: 0.0,
        };
        assert_eq!(check(&system, 0.0, &Limits::default()), Err(expected));
        assert_eq!(
            expected.to_string(),
            format!(
                "the mass matrix has the pivot {pivot:e} at speed `rotor_theta3_dot` of body `rotor`, \
                 more than 0e0 is required"
            )
        );
    }
}

#[test]
fn the_first_of_several_is_named() {
    let system = Gimbal {
        pivots: [-1.0, -1.0, 1.0, -1.0],
    };
    let result = check(&system, 0.0, &Limits::default());
    assert!(
        matches!(result, Err(CheckError::Pivot { body: "frame", .. })),
        "{result:?}"
    );
}

#[test]
fn the_caller_chooses_the_least_pivot() {
    let limits = Limits {
        least_pivot: 1.0,
        ..Limits::default()
    };
    let result = check(&SOUND, 0.0, &limits);
    assert!(
        matches!(
            result,
            Err(CheckError::Pivot {
                pivot: 1.0,
                least: 1.0,
                ..
            })
        ),
        "{result:?}"
    );
}

#[test]
fn nan_and_infinity_never_pass() {
    let not_a_number = check(&SOUND, f64::NAN, &Limits::default());
    assert!(matches!(
        not_a_number,
        Err(CheckError::Singularity { body: "rotor", .. })
    ));
    for pivot in [f64::NAN, f64::INFINITY] {
        let result = check(
            &Gimbal {
                pivots: [1.0, pivot, 1.0, 1.0],
            },
            0.0,
            &Limits::default(),
        );
        assert!(matches!(
            result,
            Err(CheckError::Pivot {
                speed: "rotor_theta1_dot",
                ..
            })
        ));
    }
    let nan_limit = Limits {
        least_distance: f64::NAN,
        ..Limits::default()
    };
    assert!(check(&SOUND, 0.0, &nan_limit).is_err());

    let mut u_dot = [9.0; 4];
    let tau = [0.0, f64::NAN, 0.0, 0.0];
    let result = forward_dynamics(
        &SOUND,
        &[0.0; 4],
        &[0.0; 4],
        &tau,
        &mut u_dot,
        &Limits::default(),
    );
    let error = result.unwrap_err();
    assert_eq!(u_dot, [9.0; 4]);
    assert_eq!(
        error.to_string(),
        "the derivative of speed `rotor_theta1_dot` of body `rotor` is NaN, a finite number is required"
    );
}

#[test]
fn results_that_are_infinite_are_refused() {
    let largest = f64::MAX;
    for (tau, pivot) in [(f64::INFINITY, 1.0), (-largest, 0.5)] {
        let system = Gimbal {
            pivots: [1.0, 1.0, 1.0, pivot],
        };
        let (tau, mut u_dot) = ([0.0, 0.0, 0.0, tau], [9.0; 4]);
        let (q, u) = ([0.0; 4], [0.0; 4]);
        let result = forward_dynamics(&system, &q, &u, &tau, &mut u_dot, &Limits::default());
        let expected = CheckError::NotFinite {
            body: "rotor",
            speed: "rotor_theta3_dot",
            u_dot: f64::INFINITY.copysign(tau[3]),
        };
        assert_eq!(result, Err(expected));
        assert_eq!(u_dot, [9.0; 4]);
    }
    // The largest numbers are numbers.
    let (tau, mut u_dot) = ([largest; 4], [9.0; 4]);
    let (system, zero) = (Gimbal { pivots: [1.0; 4] }, [0.0; 4]);
    let result = forward_dynamics(&system, &zero, &zero, &tau, &mut u_dot, &Limits::default());
    assert_eq!(result, Ok(()));
    assert_eq!(u_dot, [largest; 4]);
}
