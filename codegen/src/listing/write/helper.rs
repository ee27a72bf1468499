//! How helpers are declared, and where they find what they are given.

use super::InputPlaces;
use crate::listing::{Role, Step};
use crate::{
    expr::Input,
    functions::{Declared, Element, HELPER_INFIX, Length, Signature},
    program::{Helper, Program, ValueFacts},
};

/// How the helper at this place of a function is declared, for one column, and what its arguments are.
pub(super) fn declared(of: &str, place: usize, helper: &Helper) -> (Vec<Role>, Signature) {
    let Helper {
        lanes,
        n_shared,
        n_sides,
        program,
    } = helper;
    let lengths = [
        (Role::Shared, *n_shared),
        (Role::Sides, *n_sides),
        (Role::Solved, program.stores.len()),
    ];
    // Where columns share nothing, no argument is for that.
    let own = |(role, length): &(Role, usize)| *role != Role::Shared || *length > 0;
    let arguments = lengths.into_iter().filter(own);
    let (roles, arguments) = arguments
        .map(|(role, length)| (role, argument(role, length)))
        .unzip();
    let doc = format!(
        "Helper of `{of}`: what {lanes} columns or branches go through alike, for all of them side by side. Names are those of the first. `--without lockstep` writes them out."
    );
    let signature = Signature {
        name: format!("{of}{HELPER_INFIX}{}", place + 1),
        doc: vec![doc],
        arguments,
    };
    (roles, signature)
}

/// So many numbers that a helper is given or computes.
fn argument(role: Role, length: usize) -> Declared {
    let (name, element) = (role.name(), Element::Scalar);
    let one = match role {
        Role::Shared => Declared::read(name, element, "what all share"),
        Role::Sides => Declared::read(name, element, "the numbers of each"),
        Role::Solved => Declared::written(name, element),
    };
    Declared {
        lengths: vec![Length::Number(length)],
        ..one
    }
}

/// Where the program of a helper finds what it is given.
pub(super) fn entries(program: &Program) -> InputPlaces {
    let inputs = program.values.iter().filter_map(ValueFacts::input);
    let entries = inputs.map(|input| {
        let (role, place) = match input {
            Input::Shared(place) => (Role::Shared, place),
            Input::Side(place) => (Role::Sides, place),
            other => unreachable!("listing: a helper is not given {other:?}"),
        };
        (input, (role.name(), vec![Step::Index(place)]))
    });
    entries.collect()
}
