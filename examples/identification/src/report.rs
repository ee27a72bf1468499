//! What came of an identification, as numbers and as a table.

use std::fmt;

use crate::extremes::largest;

/// The places of a name in the table.
const NAME: usize = 52;
/// One parameter of so many is shown.
const SHOWN: usize = 8;

/// A parameter that can be identified: base parameter or coefficient of a drive.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Of what it is the sum.
    pub name: String,
    /// Its unit, that of all that follows.
    pub unit: &'static str,
    /// What it is.
    pub truth: f64,
    /// What the prior has.
    pub prior: f64,
    /// What least squares find,
    pub found: f64,
    /// and the standard deviation that follows from the torques'.
    pub deviation: f64,
    /// What the physically consistent arm has.
    pub consistent: f64,
}

/// Root mean squares of the error of predicted torques, where one is the standard deviation of the measured ones.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Against torques as they are measured: the least is one.
    pub measured: f64,
    /// Against torques as they are.
    pub exact: f64,
}

/// What came of an identification.
#[derive(Clone, Debug)]
pub struct Report {
    /// The arm's name.
    pub arm: &'static str,
    /// The condition number of the stacked regressors, in units of the torques' deviations.
    pub condition: f64,
    /// The number of columns of these.
    pub columns: usize,
    /// What can be identified of them.
    pub parameters: Vec<Parameter>,
    /// The greatest torque on both paths, as a part of the joint's limit.
    pub effort: f64,
    /// How well the prior predicts torques on the path that was not used,
    pub prior: Errors,
    /// and least squares,
    pub least_squares: Errors,
    /// and the consistent arm.
    pub consistent: Errors,
    /// Masses of the bodies: true, of the prior, of the consistent arm, kg.
    pub masses: [Vec<f64>; 3],
    /// The least of [`margin`](crate::pseudo_inertia::margin) over the consistent arm's bodies.
    pub margin: f64,
}

impl Report {
    /// Root mean square of what least squares miss, in standard deviations.
    pub fn missed(&self) -> f64 {
        let squares = self
            .parameters
            .iter()
            .map(|p| p.deviations(p.found).powi(2));
        (squares.sum::<f64>() / self.parameters.len() as f64).sqrt()
    }

    /// How many standard deviations least squares miss at most.
    pub fn missed_at_most(&self) -> f64 {
        largest(self.parameters.iter().map(|p| p.deviations(p.found)))
    }

    /// How many standard deviations the consistent arm is at most from least squares.
    pub fn moved_at_most(&self) -> f64 {
        largest(self.parameters.iter().map(Parameter::moved))
    }
}

impl Parameter {
    /// How many standard deviations a value is from the truth.
    fn deviations(&self, value: f64) -> f64 {
        (value - self.truth) / self.deviation
    }

    /// How many the consistent arm is from least squares.
    fn moved(&self) -> f64 {
        (self.consistent - self.found) / self.deviation
    }

    /// The name, cut where it is long.
    fn short(&self) -> String {
        if self.name.chars().count() <= NAME {
            return self.name.clone();
        }
        let first = self.name.split(' ').next().unwrap_or_default();
        let rotor = self.name.rfind(" + rotor").unwrap_or(self.name.len());
        format!("{first} + ..{}", &self.name[rotor..])
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rank = self.parameters.len();
        writeln!(
            f,
            "{}: {rank} parameters can be identified, {} rotors are part of others; condition number {:.0}, torque up to {:.0} % of the limits",
            self.arm,
            self.columns - rank,
            self.condition,
            1e2 * self.effort,
        )?;
        writeln!(
            f,
            "  {:NAME$} {:6} {:>9} {:>9} {:>9} {:>9} {:>9}",
            "", "", "true", "prior", "found", "std dev", "consist."
        )?;
        for p in self.parameters.iter().step_by(SHOWN) {
            writeln!(
                f,
                "  {:NAME$} {:6} {:9.4} {:9.4} {:9.4} {:9.4} {:9.4}",
                p.short(),
                p.unit,
                p.truth,
                p.prior,
                p.found,
                p.deviation,
                p.consistent
            )?;
        }
        writeln!(
            f,
            "  least squares miss the truth by {:.2} standard deviations, rms, {:.1} at most; the consistent arm is within {:.1} of least squares",
            self.missed(),
            self.missed_at_most(),
            self.moved_at_most(),
        )?;
        writeln!(
            f,
            "  masses of the bodies, kg, of which torques tell sums alone:"
        )?;
        for (masses, whose) in self.masses.iter().zip(["true", "prior", "consistent"]) {
            write!(f, "    {whose:10}")?;
            for mass in masses {
                write!(f, " {mass:6.3}")?;
            }
            writeln!(f)?;
        }
        for (errors, whose) in [
            (self.prior, "prior"),
            (self.least_squares, "least squares"),
            (self.consistent, "consistent"),
        ] {
            writeln!(
                f,
                "  torque error on another path, rms, {whose:13} {:6.3} times the noise, {:6.3} against torques without noise",
                errors.measured, errors.exact
            )?;
        }
        Ok(())
    }
}
