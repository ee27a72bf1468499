//! Functions of a listing that need no program: nominal parameters, sines and cosines.

use super::{signatures, statements::MOST_ANGLES};
use crate::listing::{Code, Entry, Expression, Facts, Function, Statement, Step, function::places};
use crate::{functions::Argument, program::Operations};

/// Writes the nominal parameters.
pub(in crate::listing) fn nominal(facts: &Facts) -> Function {
    let signature = signatures::nominal();
    let places = places(&signature, facts);
    let stores = places.into_iter().zip(&facts.parameters);
    let stores = stores.map(|(place, parameter)| Statement::Store {
        place,
        value: Expression::Number(parameter.nominal),
        is_apart: false,
    });
    let code = Code {
        statements: stores.collect(),
        ..Code::default()
    };
    Function::plain(signature, Operations::default(), code)
}

/// Writes the sines and cosines of the angles among the coordinates.
pub(in crate::listing) fn sin_cos(facts: &Facts) -> Function {
    let signature = signatures::sin_cos();
    let angles = facts.angles.as_deref().unwrap_or_default();
    let mut arguments = signature.arguments.iter();
    let q = arguments.position(|argument| argument.name == Argument::Q.name());
    let q = q.expect("listing: sines are those of coordinates");
    let places = places(&signature, facts);
    let (sines, cosines) = places.split_at(angles.len());
    let calls = angles
        .chunks(MOST_ANGLES)
        .zip(sines.chunks(MOST_ANGLES).zip(cosines.chunks(MOST_ANGLES)));
    let calls = calls.map(|(angles, (sines, cosines))| Statement::StoreSinCos {
        angles: angles
            .iter()
            .map(|angle| {
                Expression::Entry(Entry {
                    argument: q,
                    steps: vec![Step::Index(angle.coordinate)],
                })
            })
            .collect(),
        sines: sines.to_vec(),
        cosines: cosines.to_vec(),
    });
    let operations = Operations {
        trig: 2 * angles.len(),
        ..Operations::default()
    };
    let code = Code {
        statements: calls.collect(),
        ..Code::default()
    };
    Function::plain(signature, operations, code)
}
