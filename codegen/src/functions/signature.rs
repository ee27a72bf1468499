//! What a generated function is given and writes, argument by argument: every text that declares it follows from this.

use std::borrow::Cow;

use super::{
    argument::Argument,
    request::Request,
    shape::{Element, Length},
    unit::Unit,
};

/// The argument that is prepared once.
pub const PREPARED: &str = "p";
/// The argument with sines and cosines, and the function that writes it.
pub const SIN_COS: &str = "sin_cos";
/// The function that writes nominal parameters, in C.
pub const NOMINAL: &str = "nominal";
/// The function that prepares parameters, in C.
pub const PREPARE: &str = "prepare";
/// The same in Rust.
pub const PREPARED_NEW: &str = "Prepared::new";

/// What stands between the name of a function and the number of a stage.
pub const STAGE_INFIX: &str = "_stage_";

/// What stands between the name of a function and the number of a helper.
pub const HELPER_INFIX: &str = "_lockstep_";

/// A function as its callers see it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// Its name.
    pub name: String,
    /// Lines of documentation.
    pub doc: Vec<String>,
    /// The arguments, in order.
    pub arguments: Vec<Declared>,
}

/// An argument: an array, or one element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declared {
    /// Its name.
    pub name: String,
    /// What the array is of.
    pub element: Element,
    /// The lengths of the nested arrays, outermost first; none for one element.
    pub lengths: Vec<Length>,
    /// What is done with it.
    pub access: Access,
    /// What it means, in words.
    pub meaning: Cow<'static, str>,
    /// The units of its entries.
    pub unit: Unit,
}

/// What is done with an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// It is read.
    Read,
    /// It is written, whole.
    Written,
}

impl Signature {
    /// The arguments with which this is done.
    pub fn with(&self, access: Access) -> impl Iterator<Item = &Declared> {
        let arguments = self.arguments.iter();
        arguments.filter(move |argument| argument.access == access)
    }

    /// The documentation, and a line for each argument with its units, of which `units` tells those that the model has.
    pub fn lines(&self, units: impl Fn(&Unit) -> Vec<String>) -> Vec<String> {
        let arguments = self.arguments.iter();
        let arguments = arguments.map(|argument| argument.line(&units(&argument.unit)));
        let lines = self.doc.iter().cloned().chain([String::new()]);
        lines.chain(arguments).collect()
    }
}

impl Declared {
    /// One that is read.
    pub(crate) fn read(name: &str, element: Element, meaning: &'static str) -> Self {
        Self {
            name: name.to_owned(),
            element,
            lengths: Vec::new(),
            access: Access::Read,
            meaning: meaning.into(),
            unit: Unit::UNKNOWN,
        }
    }

    /// One that is written.
    pub(crate) fn written(name: &str, element: Element) -> Self {
        Self {
            access: Access::Written,
            ..Self::read(name, element, "")
        }
    }

    /// What is said of it below the documentation, which says already what is written.
    fn line(&self, units: &[String]) -> String {
        let (name, meaning) = (&self.name, &self.meaning);
        let units = self.unit.in_words(units);
        match self.access {
            Access::Read if units.is_empty() => format!("- `{name}`: {meaning}"),
            Access::Read => format!("- `{name}`: {meaning}, {units}"),
            Access::Written if units.is_empty() => format!("- `{name}`: is written, whole"),
            Access::Written => format!("- `{name}`: is written, whole: {units}"),
        }
    }

    /// One of its elements: of `[[R; n]; 3]`, `[R; n]`.
    #[must_use]
    pub fn row(&self) -> Self {
        let lengths = self.lengths.get(1..).unwrap_or_default();
        Self {
            lengths: lengths.to_vec(),
            ..self.clone()
        }
    }

    /// What is prepared once.
    pub(crate) fn prepared() -> Self {
        Self::read(PREPARED, Element::Prepared, "prepared parameters")
    }
}

impl Argument {
    /// How it is declared.
    pub fn declared(self) -> Declared {
        Declared {
            lengths: self.declared_lengths(),
            unit: self.unit(),
            ..Declared::read(self.name(), self.element(), self.meaning())
        }
    }
}

impl Request {
    /// How it is declared.
    pub fn signature(&self) -> Signature {
        let mut arguments = vec![Declared::prepared()];
        for argument in self.arguments() {
            arguments.push(argument.declared());
            if argument == Argument::Q && self.is_at_sin_cos() {
                let meaning = "what the function `sin_cos` writes from this `q`";
                arguments.push(Declared {
                    unit: Unit::ONE,
                    ..Declared::read(SIN_COS, Element::SinCos, meaning)
                });
            }
        }
        for part in self.parts() {
            let outputs = self.outputs_of(part).into_iter();
            arguments.extend(outputs.map(|output| {
                let own = |dimension| part.own_declared(dimension);
                Declared {
                    lengths: output.shape.declared(own),
                    meaning: part.meaning(&output).into(),
                    unit: output.unit,
                    ..Declared::written(&output.name, Element::Scalar)
                }
            }));
        }
        Signature {
            name: self.name(),
            doc: self.doc(),
            arguments,
        }
    }
}
