//! Lets a UR5 and a Panda learn what they are like, and prints what they have found.

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_identification::{
    experiment::{LAP, LAPS, POINTS},
    measurement::TORQUE_NOISE,
    panda, run, ur5,
};

fn main() {
    const SEED: u64 = 1;
    println!(
        "torques at {POINTS} points of a path of {LAP} s, {LAPS} times, with noise of {:.0} % of the joints' limits\n",
        1e2 * TORQUE_NOISE
    );
    println!("{}", run::<ur5::Prepared<f64>>(SEED));
    print!("{}", run::<panda::Prepared<f64>>(SEED));
}
