//! Sines and cosines in big floats.

use astro_float_num::{BigFloat, Consts, RoundingMode, WORD_BIT_SIZE};

const PRECISION: usize = 128;

pub(crate) struct Reference {
    constants: Consts,
}

impl Reference {
    pub(crate) fn new() -> Self {
        Self {
            constants: Consts::new().unwrap(),
        }
    }

    /// How far `sine` and `cosine` are from those of `x`: the errors, and the same in ulp.
    pub(crate) fn errors(&mut self, x: f64, sine: f64, cosine: f64) -> [Error; 2] {
        let mode = RoundingMode::ToEven;
        let angle = BigFloat::from_f64(x, PRECISION);
        let exact = [
            angle.sin(PRECISION, mode, &mut self.constants),
            angle.cos(PRECISION, mode, &mut self.constants),
        ];
        [error(&exact[0], sine), error(&exact[1], cosine)]
    }
}

/// How far a result is from the exact one.
pub(crate) struct Error {
    pub(crate) absolute: f64,
    /// In units in the last place that an `f64` in the exact result's binade has.
    pub(crate) ulp: f64,
}

fn error(exact: &BigFloat, value: f64) -> Error {
    let mode = RoundingMode::ToEven;
    let absolute = magnitude(&exact.sub(&BigFloat::from_f64(value, PRECISION), PRECISION, mode));
    // The exact result lies in [2^(exponent - 1), 2^exponent).
    let ulp = f64::from(exact.exponent().unwrap() - 53).exp2();
    Error {
        absolute,
        ulp: absolute / ulp,
    }
}

/// `|number|`, to f64's precision: its leading word, scaled.
fn magnitude(number: &BigFloat) -> f64 {
    let (words, _, _, exponent, _) = number.as_raw_parts().unwrap();
    let leading = words.last().copied().unwrap_or(0) as f64;
    leading * f64::from(exponent - i32::try_from(WORD_BIT_SIZE).unwrap()).exp2()
}
