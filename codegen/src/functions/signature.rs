//! What a generated function is given and writes, argument by argument: every text that declares it follows from this.

use super::{
    argument::Argument,
    function::Function,
    request::Request,
    shape::{Element, Length, PACKED_PLACES},
};

/// A function as its callers see it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// Its name.
    pub name: String,
    /// Lines of documentation.
    pub doc: Vec<String>,
    /// The module's tables that these speak of.
    pub tables: Vec<String>,
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
    pub meaning: &'static str,
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
    /// The documentation, and a line for each argument; names of the module's tables with `prefix` before them.
    pub fn lines(&self, prefix: &str) -> Vec<String> {
        let tables = self.tables.iter();
        let doc = self.doc.iter().map(|line| {
            tables.clone().fold(line.clone(), |line, table| {
                line.replace(&format!("`{table}`"), &format!("`{prefix}{table}`"))
            })
        });
        let arguments = self.arguments.iter().map(|argument| {
            let Declared { name, meaning, .. } = argument;
            format!("- `{name}`: {meaning}")
        });
        doc.chain([String::new()]).chain(arguments).collect()
    }

    /// The nominal parameters, as a function.
    pub fn nominal() -> Self {
        Self {
            name: "nominal".to_owned(),
            doc: vec!["The model's nominal parameters.".to_owned()],
            tables: Vec::new(),
            arguments: vec![Declared::written("parameters", Element::Parameters)],
        }
    }

    /// The preparation of parameters, as a function.
    pub fn prepare() -> Self {
        let doc = "Whatever depends on parameters alone: computed once, outside the control loop.";
        Self {
            name: "prepare".to_owned(),
            doc: vec![doc.to_owned()],
            tables: Vec::new(),
            arguments: vec![
                Declared::read("parameters", Element::Parameters, "values set at run time"),
                Declared::written("p", Element::Prepared),
            ],
        }
    }

    /// The function that others are given the result of.
    pub fn sin_cos() -> Self {
        let doc = "Sines and cosines of the angles among the coordinates, for the functions whose names end in `_at_sin_cos`.";
        Self {
            name: "sin_cos".to_owned(),
            doc: vec![doc.to_owned()],
            tables: Vec::new(),
            arguments: vec![
                Declared::prepared(),
                Argument::Q.declared(),
                Declared::written("sin_cos", Element::SinCos),
            ],
        }
    }
}

impl Declared {
    fn read(name: &str, element: Element, meaning: &'static str) -> Self {
        Self {
            name: name.to_owned(),
            element,
            lengths: Vec::new(),
            access: Access::Read,
            meaning,
        }
    }

    fn written(name: &str, element: Element) -> Self {
        Self {
            access: Access::Written,
            ..Self::read(name, element, "is written, whole")
        }
    }

    fn prepared() -> Self {
        Self::read("p", Element::Prepared, "prepared parameters")
    }
}

impl Argument {
    /// How it is declared.
    pub fn declared(self) -> Declared {
        Declared {
            lengths: self.shape().declared(String::new),
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
                let meaning = "what `sin_cos` writes from this `q`";
                arguments.push(Declared::read("sin_cos", Element::SinCos, meaning));
            }
        }
        let columns = || {
            let compact = self.compact();
            let compact = compact.expect("functions: its output is compact");
            compact.columns_constant()
        };
        arguments.extend(self.outputs().into_iter().map(|output| Declared {
            lengths: output.shape.declared(columns),
            ..Declared::written(&output.name, Element::Scalar)
        }));
        Signature {
            name: self.name(),
            doc: self.doc(),
            tables: self.tables(),
            arguments,
        }
    }
    fn tables(&self) -> Vec<String> {
        let compact = self.compact().map(Function::blocks_constant);
        let packed = self.is_packed().then(|| PACKED_PLACES.to_owned());
        compact.into_iter().chain(packed).collect()
    }
}
