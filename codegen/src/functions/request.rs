//! What a user asks for: a function of the catalogue, or several in one that shares their work.
//!
//! In: a text such as `bias`, `mass_matrix+bias` or `bias(sin_cos)`. Out: a [`Request`]. Afterwards: every part is of the
//! catalogue, none is there twice, and what is joined has no compact output.

use super::{Argument, CATALOGUE, Derived, Formulation, Function, Shape, terms};
use crate::{expr::ExprGraph, recursive::Plan, tree::Tree};

/// What stands after the name of a function that is given sines and cosines.
const AT_SIN_COS: &str = "(sin_cos)";

/// A function to generate.
#[derive(Clone, Debug)]
pub struct Request {
    parts: Vec<&'static Function>,
    at_sin_cos: bool,
}

/// An output of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// The argument's name.
    pub name: String,
    /// The shape.
    pub shape: Shape,
}

/// Why a function cannot be had.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RequestError {
    /// A name that the catalogue does not hold.
    #[error("`{}` is no function", name.escape_debug())]
    Unknown {
        /// The name.
        name: String,
    },
    /// A part that is there twice.
    #[error("`{request}` names `{name}` twice")]
    Repeated {
        /// What was asked for.
        request: String,
        /// The part.
        name: String,
    },
    /// A compact output beside others.
    #[error("`{request}` joins `{name}` to others, which no function with a compact output can be")]
    Compact {
        /// What was asked for.
        request: String,
        /// The part.
        name: String,
    },
}

impl Request {
    /// Reads names of the catalogue with `+` between them, and `(sin_cos)` after them where the function is to be given the
    /// sines and cosines of the angles among the coordinates.
    ///
    /// ```
    /// use kane_codegen::functions::Request;
    ///
    /// let request = Request::parse("mass_matrix+bias").unwrap();
    /// assert_eq!(request.name(), "mass_matrix_and_bias");
    /// assert_eq!(Request::parse("bias(sin_cos)").unwrap().name(), "bias_at_sin_cos");
    /// assert!(Request::parse("mass_matrix+mass").is_err());
    /// ```
    ///
    /// # Errors
    /// The first thing that is wrong with it.
    pub fn parse(text: &str) -> Result<Self, RequestError> {
        let mut parts: Vec<&'static Function> = Vec::new();
        let names = text.strip_suffix(AT_SIN_COS);
        for name in names.unwrap_or(text).split('+') {
            let part = Function::find(name).ok_or_else(|| RequestError::Unknown {
                name: name.to_owned(),
            })?;
            if parts.iter().any(|known| known.name == name) {
                return Err(RequestError::Repeated {
                    request: text.to_owned(),
                    name: name.to_owned(),
                });
            }
            parts.push(part);
        }
        let compact = parts.iter().find(|part| part.shape == Shape::Columns);
        match compact {
            Some(part) if parts.len() > 1 => Err(RequestError::Compact {
                request: text.to_owned(),
                name: part.name.to_owned(),
            }),
            _ => Ok(Self {
                parts,
                at_sin_cos: names.is_some(),
            }),
        }
    }

    /// The functions of the catalogue that it is made of, in the order asked for.
    pub fn parts(&self) -> &[&'static Function] {
        &self.parts
    }

    /// The function of the catalogue, where it is one as it stands there.
    pub fn alone(&self) -> Option<&'static Function> {
        match self.parts[..] {
            [function] if !self.at_sin_cos => Some(function),
            _ => None,
        }
    }

    /// The function of a compact output.
    pub fn compact(&self) -> Option<&'static Function> {
        let mut parts = self.parts.iter();
        parts.find(|part| part.shape == Shape::Columns).copied()
    }

    /// True where a packed mass matrix is among the outputs.
    pub fn is_packed(&self) -> bool {
        self.parts
            .iter()
            .any(|part| part.shape == Shape::SpeedPairs)
    }

    /// True where the sines and cosines of the angles among the coordinates are given, after `q`.
    pub fn is_at_sin_cos(&self) -> bool {
        self.at_sin_cos
    }

    /// As it is asked for: `mass_matrix+bias(sin_cos)`.
    pub fn text(&self) -> String {
        self.joined("+") + self.suffix(AT_SIN_COS)
    }

    /// The generated function's name: `mass_matrix_and_bias_at_sin_cos`.
    pub fn name(&self) -> String {
        self.joined("_and_") + self.suffix("_at_sin_cos")
    }

    fn joined(&self, between: &str) -> String {
        let names: Vec<&str> = self.parts.iter().map(|part| part.name).collect();
        names.join(between)
    }

    fn suffix<'a>(&self, at_sin_cos: &'a str) -> &'a str {
        if self.at_sin_cos { at_sin_cos } else { "" }
    }

    /// Where it stands in a module: the catalogue's functions in their order, then the others.
    pub fn place(&self) -> (usize, Vec<usize>, bool) {
        let place = |part: &&Function| {
            let found = CATALOGUE.iter().position(|known| known.name == part.name);
            found.expect("functions: a part is of the catalogue")
        };
        let kind = usize::from(self.alone().is_none());
        let parts = self.parts.iter().map(place).collect();
        (kind, parts, self.at_sin_cos)
    }

    /// What it is given besides the parameters: whatever one of its parts is given, in the order of all functions.
    pub fn arguments(&self) -> Vec<Argument> {
        let is_given = |argument: &Argument| {
            let mut parts = self.parts.iter();
            parts.any(|part| part.arguments.contains(argument))
        };
        Argument::ALL.into_iter().filter(is_given).collect()
    }

    /// What it writes, in the order asked for. An output that has the name of another one or of an argument goes by the
    /// name of its function.
    pub fn outputs(&self) -> Vec<Output> {
        let arguments = self.arguments();
        let is_free = |name: &str| {
            let among = self.parts.iter().filter(|part| part.output == name);
            among.count() == 1 && arguments.iter().all(|argument| argument.name() != name)
        };
        let output = |part: &&Function| {
            let own = is_free(part.output) || self.parts.len() == 1;
            Output {
                name: if own { part.output } else { part.name }.to_owned(),
                shape: part.shape,
            }
        };
        self.parts.iter().map(output).collect()
    }

    /// Lines of documentation.
    pub fn doc(&self) -> Vec<String> {
        let mut lines = self.meaning();
        if self.at_sin_cos {
            lines.push(String::new());
            lines.push(
                "`sin_cos` holds what the function `sin_cos` computes from this `q`, once for all that are called there."
                    .to_owned(),
            );
        }
        lines
    }

    fn meaning(&self) -> Vec<String> {
        if let [function] = self.parts[..] {
            return function.doc.iter().map(ToString::to_string).collect();
        }
        let names = self.joined("` and `");
        let mut lines = vec![format!("`{names}` in one: what they share is done once.")];
        for (part, output) in self.parts.iter().zip(self.outputs()) {
            lines.push(String::new());
            let mut doc = part.doc.iter();
            let first = doc.next().map_or("", |line| line);
            lines.push(format!("`{}`: {first}", output.name));
            lines.extend(doc.map(ToString::to_string));
        }
        lines
    }

    /// True where accelerations are solved for.
    pub fn solves(&self) -> bool {
        self.arguments().contains(&Argument::Tau)
    }

    /// The formulations in which the function can be derived.
    pub fn formulations(&self) -> &'static [Formulation] {
        let lists = self.parts.iter().map(|part| part.formulations());
        lists
            .max_by_key(|list| list.len())
            .expect("functions: a request has a part")
    }

    /// How many terms the notes' sums have at least: as [`Function::literal_terms`]; parts may have all theirs in common.
    pub fn literal_terms(&self, tree: &Tree) -> usize {
        let terms = self.parts.iter().map(|part| part.literal_terms(tree));
        terms.max().unwrap_or(0)
    }

    /// How many numbers it writes, or somewhat more, where joints follow others.
    pub fn n_numbers(&self, tree: &Tree) -> usize {
        let of_part = |part: &&Function| match part.shape {
            Shape::Columns => 3 * terms::of_vector(tree),
            Shape::SpeedPairs => terms::pairs(tree),
            shape => shape.lengths(tree, 0).iter().product(),
        };
        self.parts.iter().map(of_part).sum()
    }

    /// Derives all parts in one graph, where what they share is built once. A part that has a single formulation takes no
    /// notice of `formulation`, and only the recursive one of `plan`.
    pub fn derive(&self, tree: &Tree, formulation: Formulation, plan: &Plan) -> Derived {
        let mut derived = Derived {
            graph: ExprGraph::default(),
            roots: Vec::new(),
            blocks: Vec::new(),
        };
        for part in &self.parts {
            derived.graph.enter(None);
            part.derive_in(&mut derived, tree, formulation, plan);
        }
        derived
    }
}

impl From<&'static Function> for Request {
    fn from(function: &'static Function) -> Self {
        Self {
            parts: vec![function],
            at_sin_cos: false,
        }
    }
}
