//! What is lifted of weights.
//!
//! Where it is the same share of all, gravity itself is smaller to all forces, which costs no operation.

use crate::tree::body::{Body, RigidPart};
use crate::tree::value::Value;

const NOTHING: Value = Value::Baked(0.0);

/// The share that is lifted of every weight, where it is the same for all and then no part's own; else zero.
pub(crate) fn of_all(bodies: &mut [Body]) -> f64 {
    let parts = bodies.iter_mut().flat_map(|body| &mut body.parts);
    let mut heavy: Vec<&mut RigidPart> = Vec::new();
    for part in parts {
        if part.mass == NOTHING {
            part.lifted = NOTHING;
        } else {
            heavy.push(part);
        }
    }
    let Some(Value::Baked(share)) = heavy.first().map(|part| part.lifted) else {
        return 0.0;
    };
    if heavy.iter().any(|part| part.lifted != Value::Baked(share)) {
        return 0.0;
    }
    for part in heavy {
        part.lifted = NOTHING;
    }
    share
}
