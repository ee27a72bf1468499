//! Names of generated code that two things would have: names of frames and values are joined, and `a_b` and `c` make what `a` and
//! `b_c` do.

use std::collections::BTreeMap;

use crate::functions::{Part, Request, RequestError};

/// Refuses two functions of one name, two outputs of one function, and two constants.
pub(super) fn check(requests: &[Request]) -> Result<(), RequestError> {
    let mut known: BTreeMap<String, &Request> = BTreeMap::new();
    for request in requests {
        if let Some(first) = known.insert(request.name(), request) {
            return Err(RequestError::SameName {
                first: first.text(),
                second: request.text(),
                name: request.name(),
            });
        }
        check_outputs(request)?;
    }
    check_constants(requests)
}

fn check_outputs(request: &Request) -> Result<(), RequestError> {
    let mut names: Vec<_> = request.outputs().into_iter().map(|own| own.name).collect();
    names.sort_unstable();
    match names.windows(2).find(|pair| pair[0] == pair[1]) {
        None => Ok(()),
        Some(pair) => Err(RequestError::SameOutput {
            request: request.text(),
            name: pair[0].to_string(),
        }),
    }
}

/// Constants belong to parts: each may be in several functions.
fn check_constants(requests: &[Request]) -> Result<(), RequestError> {
    let mut known: BTreeMap<String, (String, &Request)> = BTreeMap::new();
    for request in requests {
        for (constant, of) in request.parts().iter().flat_map(Part::constants) {
            match known.get(&constant) {
                Some((first, in_request)) if *first != of => {
                    return Err(RequestError::SameConstant {
                        requests: [in_request.text(), request.text()],
                        of: [first.clone(), of],
                        name: constant,
                    });
                }
                Some(_) => {}
                None => {
                    known.insert(constant, (of, request));
                }
            }
        }
    }
    Ok(())
}
