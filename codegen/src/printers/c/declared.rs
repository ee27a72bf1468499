//! How functions of the runtime crate are declared.

use crate::functions::{Access, Declared, Element, Signature};

/// The same afterwards.
pub(super) fn after(of: &Declared) -> Declared {
    Declared {
        name: format!("{}_after", of.name),
        access: Access::Written,
        meaning: format!("{} afterwards", of.meaning).into(),
        ..of.clone()
    }
}

pub(super) fn written(name: &str, meaning: &'static str) -> Declared {
    Declared {
        meaning: meaning.into(),
        ..Declared::written(name, Element::Scalar)
    }
}

/// Of a function that is given what is prepared, and these.
pub(super) fn signature(
    name: &str,
    doc: &[&str],
    own: impl IntoIterator<Item = Declared>,
) -> Signature {
    Signature {
        name: name.to_owned(),
        doc: doc.iter().map(|&line| line.to_owned()).collect(),
        arguments: [Declared::prepared()].into_iter().chain(own).collect(),
    }
}
