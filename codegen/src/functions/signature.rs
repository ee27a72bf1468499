//! What a generated function is given and writes, argument by argument: every text that declares it follows from this.

use super::{Argument, Function, Request, Shape};

/// The constant that holds the length of a packed mass matrix.
pub const PACKED_LEN: &str = "MASS_MATRIX_PACKED_LEN";
/// The constant that holds where its entries stand.
pub const PACKED_PLACES: &str = "MASS_MATRIX_PACKED_PLACES";

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

/// What an array is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A number.
    Scalar,
    /// The load on a body.
    Load,
    /// Values set at run time.
    Parameters,
    /// What depends on these alone.
    Prepared,
    /// Sines and cosines.
    SinCos,
}

/// The length of an array.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Length {
    /// The components of a vector.
    Three,
    /// A constant of the module: `NQ`.
    Constant(String),
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
    fn declared(self) -> Declared {
        let (element, shape, meaning) = match self {
            Self::Q => (
                Element::Scalar,
                Shape::Coordinates,
                "coordinates, rad and m; quaternions have no unit",
            ),
            Self::U => (Element::Scalar, Shape::Speeds, "speeds, rad/s and m/s"),
            Self::UDot => (
                Element::Scalar,
                Shape::Speeds,
                "rates of the speeds, rad/s^2 and m/s^2",
            ),
            Self::Tau => (
                Element::Scalar,
                Shape::Speeds,
                "generalized forces, N m and N",
            ),
            Self::Loads => (
                Element::Load,
                Shape::BodyScalars,
                "force at the mass centre and moment on each body, body components, N and N m",
            ),
            Self::RelativeAngularVelocity => (
                Element::Scalar,
                Shape::BodyVectors,
                "angular velocity of each body relative to its lower body, body components, rad/s",
            ),
        };
        Declared {
            lengths: shape.named_lengths(String::new),
            ..Declared::read(self.name(), element, meaning)
        }
    }
}

impl Shape {
    /// The lengths of the nested arrays, outermost first; `columns` names that of a compact output.
    fn named_lengths(self, columns: impl FnOnce() -> String) -> Vec<Length> {
        let constant = |name: &str| Length::Constant(name.to_owned());
        match self {
            Self::Scalar => vec![],
            Self::Vector => vec![Length::Three],
            Self::Coordinates => vec![constant("NQ")],
            Self::Speeds => vec![constant("NU")],
            Self::SpeedMatrix => vec![constant("NU"), constant("NU")],
            Self::SpeedPairs => vec![constant(PACKED_LEN)],
            Self::BodyScalars => vec![constant("NB")],
            Self::BodyVectors => vec![constant("NB"), Length::Three],
            Self::BodyMatrices => vec![constant("NB"), Length::Three, Length::Three],
            Self::Columns => vec![Length::Constant(columns()), Length::Three],
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
            lengths: output.shape.named_lengths(columns),
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
