//! How functions are declared that a module has whatever is asked for.

use crate::functions::{
    Argument, Declared, Element, NOMINAL, PARAMETERS, PREPARE, PREPARED, SIN_COS, Signature,
};

/// Of nominal parameters.
pub(super) fn nominal() -> Signature {
    Signature {
        name: NOMINAL.to_owned(),
        doc: vec!["The model's nominal parameters.".to_owned()],
        arguments: vec![Declared::written(PARAMETERS, Element::Parameters)],
    }
}

/// Of the preparation of parameters.
pub(super) fn prepare() -> Signature {
    let doc = "Whatever depends on parameters alone: computed once, outside the control loop.";
    Signature {
        name: PREPARE.to_owned(),
        doc: vec![doc.to_owned()],
        arguments: vec![
            Declared::read(PARAMETERS, Element::Parameters, "values set at run time"),
            Declared::written(PREPARED, Element::Prepared),
        ],
    }
}

/// Of the function that others are given the result of.
pub(super) fn sin_cos() -> Signature {
    let doc = "Sines and cosines of the angles among the coordinates, for the functions whose names have `_at_sin_cos`.";
    Signature {
        name: SIN_COS.to_owned(),
        doc: vec![doc.to_owned()],
        arguments: vec![
            Declared::prepared(),
            Argument::Q.declared(),
            Declared::written(SIN_COS, Element::SinCos),
        ],
    }
}
