//! Names of generated code that two things would have: names of frames and values are joined, and `a_b` and `c` make what `a` and
//! `b_c` do.

use std::collections::{BTreeMap, BTreeSet};

use crate::functions::{Part, Request, RequestError};

/// All functions that have the name of another, outputs that have that of another one of their function, and constants.
pub(super) fn faults(requests: &[Request]) -> Vec<RequestError> {
    let mut faults = Vec::new();
    let mut known: BTreeMap<String, &Request> = BTreeMap::new();
    for request in requests {
        let name = request.name();
        match known.get(&name) {
            Some(first) => faults.push(RequestError::SameName {
                first: first.text(),
                second: request.text(),
                name,
            }),
            None => _ = known.insert(name, request),
        }
        faults.extend(of_outputs(request));
    }
    faults.extend(of_constants(requests));
    faults
}

fn of_outputs(request: &Request) -> Option<RequestError> {
    let mut names = BTreeSet::new();
    let outputs = request.outputs().into_iter();
    let again = outputs
        .map(|own| own.name)
        .find(|name| !names.insert(name.clone()))?;
    Some(RequestError::SameOutput {
        request: request.text(),
        name: again.into_owned(),
    })
}

/// Constants belong to parts: each may be in several functions.
fn of_constants(requests: &[Request]) -> Vec<RequestError> {
    let mut known: BTreeMap<String, (String, &Request)> = BTreeMap::new();
    let mut faults = Vec::new();
    for request in requests {
        for (name, of) in request.parts().iter().flat_map(Part::constants) {
            let (first, in_request) = known.entry(name.clone()).or_insert((of.clone(), request));
            if *first != of {
                faults.push(RequestError::SameConstant {
                    requests: [in_request.text(), request.text()],
                    of: [first.clone(), of],
                    name,
                });
            }
        }
    }
    faults
}
