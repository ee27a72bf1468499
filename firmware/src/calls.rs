//! The one source of what is called, here and there: functions, states, and what is printed of them.
//!
//! A line for each call, all numbers in hexadecimal, the last of them the bits of the output:
//! ```text
//! panda::inverse_dynamics f32 STATE ADDRESS INSTRUCTIONS STACK 3F800000 BF000000 ...
//! ```

use core::{array, hint::black_box};

use kane::{Real, cart_pole, eight_body};

/// Generated from the robot's description by the build script.
#[allow(
    clippy::pedantic,
    reason = "generated: nobody wrote these lines, and nobody will polish them"
)]
mod panda {
    include!(concat!(env!("OUT_DIR"), "/panda.rs"));
}

/// The cart and the pole, with what a step's derivatives are made of.
#[allow(
    clippy::pedantic,
    reason = "generated: nobody wrote these lines, and nobody will polish them"
)]
mod cart_pole_steps {
    include!(concat!(env!("OUT_DIR"), "/cart_pole_steps.rs"));
}

mod regulator;

// Random trees, where the build script was asked for some.
include!(concat!(env!("OUT_DIR"), "/trees.rs"));

/// Where the functions are called.
pub(crate) trait Machine {
    /// Calls, and says what that cost.
    fn measure(&mut self, call: impl FnOnce()) -> Cost;
    /// Prints, and does not end the line.
    fn print(&mut self, text: &[u8]);
}

/// What a call costs; zeros where that is not measured.
#[derive(Clone, Copy, Default)]
pub(crate) struct Cost {
    pub(crate) instructions: usize,
    /// Bytes.
    pub(crate) stack: usize,
}

/// Calls every function with every scalar at every state.
pub(crate) fn run(machine: &mut impl Machine) {
    with_scalar::<f32>(machine);
    with_scalar::<f64>(machine);
}

fn with_scalar<R: Scalar>(machine: &mut impl Machine) {
    if option_env!("FIRMWARE_TREES").is_some() {
        trees::<R>(machine);
    } else {
        bundled::<R>(machine);
    }
}

#[allow(
    unused,
    clippy::extra_unused_type_parameters,
    reason = "most often there are no trees"
)]
fn trees<R: Scalar>(machine: &mut impl Machine) {
    macro_rules! call {
        ($tree:ident) => {
            let system = $tree::Prepared::<R>::nominal();
            let function = Function {
                name: concat!(stringify!($tree), "::inverse_dynamics"),
                address: $tree::inverse_dynamics::<R> as *const (),
            };
            function.at_states(machine, |state: &State<R, { $tree::NQ }, _>, [tau]| {
                $tree::inverse_dynamics(&system, &state.q, &state.u, &state.u_dot, tau);
            });
            let function = Function {
                name: concat!(stringify!($tree), "::mass_matrix"),
                address: $tree::mass_matrix::<R> as *const (),
            };
            function.at_states(machine, |state: &State<R, { $tree::NQ }, _>, m| {
                $tree::mass_matrix(&system, &state.q, m);
            });
            let function = Function {
                name: concat!(stringify!($tree), "::forward_dynamics"),
                address: $tree::forward_dynamics::<R> as *const (),
            };
            function.at_states(machine, |state: &State<R, { $tree::NQ }, _>, [u_dot]| {
                $tree::forward_dynamics(&system, &state.q, &state.u, &state.tau, u_dot);
            });
        };
    }
    each_tree!(call);
}

fn bundled<R: Scalar>(machine: &mut impl Machine) {
    let system = panda::Prepared::<R>::nominal();
    let function = Function {
        name: "panda::inverse_dynamics",
        address: panda::inverse_dynamics::<R> as *const (),
    };
    function.at_states(machine, |state: &State<R, _, _>, [tau]| {
        panda::inverse_dynamics(&system, &state.q, &state.u, &state.u_dot, tau);
    });

    let function = Function {
        name: "panda::panda_hand_tcp_jacobian",
        address: panda::panda_hand_tcp_jacobian::<R> as *const (),
    };
    function.at_states(
        machine,
        |state: &State<R, _, { panda::NU }>, rows: &mut [_; 6]| {
            if let [linear, angular] = rows.as_chunks_mut::<3>().0 {
                panda::panda_hand_tcp_jacobian(&system, &state.q, linear, angular);
            }
        },
    );
    let function = Function {
        name: "panda::coriolis_matrix",
        address: panda::coriolis_matrix::<R> as *const (),
    };
    function.at_states(machine, |state: &State<R, _, _>, c| {
        panda::coriolis_matrix(&system, &state.q, &state.u, c);
    });

    panda_derivatives::<R>(machine, &system);

    let system = cart_pole::Prepared::<R>::nominal();
    let function = Function {
        name: "cart_pole::forward_dynamics",
        address: cart_pole::forward_dynamics::<R> as *const (),
    };
    function.at_states(machine, |state: &State<R, _, _>, [u_dot]| {
        cart_pole::forward_dynamics(&system, &state.q, &state.u, &state.tau, u_dot);
    });

    let system = cart_pole_steps::Prepared::<R>::nominal();
    let function = Function {
        name: "regulator::gains",
        address: regulator::gains::<R> as *const (),
    };
    // The states do not matter: the gains are those near upright.
    function.at_states(machine, |_: &State<R, 2, 2>, gains| {
        *gains = regulator::gains(&system);
    });
    let function = Function {
        name: "regulator::held",
        address: regulator::held::<R> as *const (),
    };
    let gains = regulator::gains(&system);
    function.at_states(machine, |_: &State<R, 2, 2>, state| {
        *state = regulator::held(&system, black_box(&gains));
    });

    cart_pole_derivatives::<R>(machine, &system);

    let system = eight_body::Prepared::<R>::nominal();
    let function = Function {
        name: "eight_body::mass_matrix",
        address: eight_body::mass_matrix::<R> as *const (),
    };
    function.at_states(machine, |state: &State<R, _, _>, m| {
        eight_body::mass_matrix(&system, &state.q, m);
    });
}

fn panda_derivatives<R: Scalar>(machine: &mut impl Machine, system: &panda::Prepared<R>) {
    let function = Function {
        name: "panda::d_inverse_dynamics_d_q_u_u_dot",
        address: panda::d_inverse_dynamics_d_q_u_u_dot::<R> as *const (),
    };
    function.at_states(
        machine,
        |state: &State<R, _, _>, rows: &mut [_; 3 * panda::NU]| {
            if let [by_q, by_u, by_u_dot] = rows.as_chunks_mut::<{ panda::NU }>().0 {
                let State { q, u, u_dot, .. } = state;
                panda::d_inverse_dynamics_d_q_u_u_dot(system, q, u, u_dot, by_q, by_u, by_u_dot);
            }
        },
    );
    let function = Function {
        name: "panda::d_forward_dynamics_d_q_u_tau",
        address: panda::d_forward_dynamics_d_q_u_tau::<R> as *const (),
    };
    // Its columns are solved in lockstep.
    function.at_states(
        machine,
        |state: &State<R, _, _>, rows: &mut [_; 3 * panda::NU]| {
            if let [by_q, by_u, by_tau] = rows.as_chunks_mut::<{ panda::NU }>().0 {
                let State { q, u, tau, .. } = state;
                panda::d_forward_dynamics_d_q_u_tau(system, q, u, tau, by_q, by_u, by_tau);
            }
        },
    );
    let function = Function {
        name: "panda::vjp_forward_dynamics_q_u_tau",
        address: panda::vjp_forward_dynamics_q_u_tau::<R> as *const (),
    };
    function.at_states(machine, |state: &State<R, _, _>, [by_q, by_u, by_tau]| {
        let State { q, u, u_dot, tau } = state;
        panda::vjp_forward_dynamics_q_u_tau(system, q, u, tau, u_dot, by_q, by_u, by_tau);
    });
}

fn cart_pole_derivatives<R: Scalar>(
    machine: &mut impl Machine,
    system: &cart_pole_steps::Prepared<R>,
) {
    let function = Function {
        name: "cart_pole_steps::d_forward_dynamics_d_q_tau_packed",
        address: cart_pole_steps::d_forward_dynamics_d_q_tau_packed::<R> as *const (),
    };
    function.at_states(machine, |state: &State<R, _, 2>, rows: &mut [_; 4]| {
        let State { q, u, tau, .. } = state;
        const { assert!(cart_pole_steps::D_FORWARD_DYNAMICS_D_Q_TAU_PACKED_LEN <= 8) };
        if let Some(entries) = rows.as_flattened_mut().first_chunk_mut() {
            cart_pole_steps::d_forward_dynamics_d_q_tau_packed(system, q, u, tau, entries);
        }
    });
    let function = Function {
        name: "cart_pole_steps::hessian_inverse_dynamics_q_u",
        address: cart_pole_steps::hessian_inverse_dynamics_q_u::<R> as *const (),
    };
    function.at_states(machine, |state: &State<R, _, 2>, rows: &mut [_; 2]| {
        let State { q, u, u_dot, tau } = state;
        const { assert!(cart_pole_steps::HESSIAN_INVERSE_DYNAMICS_Q_U_LEN <= 4) };
        if let Some(entries) = rows.as_flattened_mut().first_chunk_mut() {
            cart_pole_steps::hessian_inverse_dynamics_q_u(system, q, u, u_dot, tau, entries);
        }
    });
}

/// A generated function; its address tells it from others of its name in the linked program.
struct Function {
    name: &'static str,
    address: *const (),
}

impl Function {
    /// `call` writes one row of numbers or several.
    fn at_states<R: Scalar, const NQ: usize, const NU: usize, const ROWS: usize>(
        &self,
        machine: &mut impl Machine,
        call: impl Fn(&State<R, NQ, NU>, &mut [[R; NU]; ROWS]),
    ) {
        for (number, numbers) in (0..).zip(&STATES) {
            let state = State::new(numbers);
            let mut output = [[R::from_f64(0.0); NU]; ROWS];
            let cost = machine.measure(|| call(black_box(&state), black_box(&mut output)));

            machine.print(self.name.as_bytes());
            machine.print(b" ");
            machine.print(R::NAME.as_bytes());
            print_hexadecimal(machine, &[number]);
            print_hexadecimal(machine, &self.address.addr().to_be_bytes());
            print_hexadecimal(machine, &cost.instructions.to_be_bytes());
            print_hexadecimal(machine, &cost.stack.to_be_bytes());
            for number in output.as_flattened() {
                print_hexadecimal(machine, number.to_bytes().as_ref());
            }
            machine.print(b"\n");
        }
    }
}

/// Prints a space and a number, the most significant byte first. `core::fmt` could panic, and would be most of the program.
fn print_hexadecimal(machine: &mut impl Machine, bytes: &[u8]) {
    machine.print(b" ");
    for byte in bytes {
        let digits = [byte >> 4, byte & 15];
        machine.print(&digits.map(|digit| b"0123456789ABCDEF"[usize::from(digit)]));
    }
}

/// A scalar whose bits can be printed.
pub(crate) trait Scalar: Real {
    const NAME: &str;
    /// Its bits, the most significant byte first.
    fn to_bytes(self) -> impl AsRef<[u8]>;
}

macro_rules! scalars {
    ($($float:ident)+) => {$(
        impl Scalar for $float {
            const NAME: &str = stringify!($float);
            fn to_bytes(self) -> impl AsRef<[u8]> {
                self.to_be_bytes()
            }
        }
    )+};
}

scalars!(f32 f64);

/// All that the functions are given.
struct State<R, const NQ: usize, const NU: usize> {
    q: [R; NQ],
    u: [R; NU],
    u_dot: [R; NU],
    tau: [R; NU],
}

impl<R: Scalar, const NQ: usize, const NU: usize> State<R, NQ, NU> {
    fn new([q, u, u_dot, tau]: &Numbers) -> Self {
        Self {
            q: first(q),
            u: first(u),
            u_dot: first(u_dot),
            tau: first(tau),
        }
    }
}

fn first<R: Scalar, const N: usize>(numbers: &[f64; LONGEST]) -> [R; N] {
    array::from_fn(|place| R::from_f64(numbers[place]))
}

/// The length of the longest argument.
const LONGEST: usize = eight_body::NQ;

/// As many `q`, `u`, `u_dot` and `tau` as any system takes.
type Numbers = [[f64; LONGEST]; 4];

/// The bounds of the numbers of each state: at rest, several ordinary ones, many turns.
const BOUNDS: [f64; 8] = [0.0, 0.01, 1.0, 3.2, 3.2, 3.2, 3.2, 1000.0];

/// The states, numbers of a linear congruential sequence; the compiler evaluates them.
#[expect(clippy::cast_precision_loss, reason = "53 bits are what an `f64` has")]
static STATES: [Numbers; BOUNDS.len()] = {
    let mut states = [[[0.0; LONGEST]; 4]; BOUNDS.len()];
    let mut seed: u64 = 1;
    let mut place = 0;
    while place < 4 * LONGEST * BOUNDS.len() {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let (state, place_in_state) = (place / (4 * LONGEST), place % (4 * LONGEST));
        // From -1 to 1.
        let number = (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0;
        states[state][place_in_state / LONGEST][place_in_state % LONGEST] = BOUNDS[state] * number;
        place += 1;
    }
    states
};
