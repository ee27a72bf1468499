//! Base parameters, as data beside the function that writes them or their columns.

use crate::{
    base_parameters,
    compile::Emittable,
    functions::{Argument, Dimension, Shape},
    tree::{InertialParameter, Tree},
};

/// The base parameters of a module.
#[derive(Clone, Debug, PartialEq)]
pub struct BaseParameters {
    /// Each as text.
    pub texts: Vec<String>,
    /// All terms, one base parameter after the other.
    pub terms: Vec<BaseTerm>,
}

/// A term of a base parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BaseTerm {
    /// The place of the base parameter.
    pub base: usize,
    /// The place of the body.
    pub body: usize,
    /// The place of the parameter among the body's ten.
    pub parameter: usize,
    /// What it is multiplied with.
    pub factor: f64,
}

impl BaseParameters {
    /// Those of the tree, if some function writes them or their columns, or is given multipliers of these.
    pub(in crate::listing) fn of(tree: &Tree, functions: &[Emittable]) -> Option<Self> {
        let has = |own: &Emittable| {
            let request = &own.request;
            let mut written = request.outputs().into_iter().map(|output| output.shape);
            let mut given = request.arguments().into_iter().map(Argument::shape);
            let is_of_them = |shape: Shape| shape.has(Dimension::BaseParameters);
            written.any(is_of_them) || given.any(is_of_them)
        };
        functions.iter().any(has).then(|| Self::all(tree))
    }

    fn all(tree: &Tree) -> Self {
        let found = base_parameters::of(tree);
        let texts = found.iter().map(|own| base_parameters::text(tree, own));
        let terms = found.iter().enumerate().flat_map(|(base, own)| {
            let terms = own.terms.iter();
            terms.map(
                move |&(InertialParameter { body, place }, factor)| BaseTerm {
                    base,
                    body: body.index(),
                    parameter: place,
                    factor,
                },
            )
        });
        Self {
            texts: texts.collect(),
            terms: terms.collect(),
        }
    }
}
