//! What a user asks for, before a model is known.
//!
//! In: a text such as `bias`, `mass_matrix+pose(tool0)` or `bias(sin_cos)`. Out: a [`Parsed`] request. Afterwards: every
//! part is of the catalogue and of what it can be of, none is there twice, and what is joined has no compact output. Does
//! not: know which frames there are.

use std::ops::Range;

use super::{
    catalogue::{CATALOGUE, OF_FRAMES},
    function::{FrameFunction, Function},
    part::{LOCAL, Part, text_of},
    request::Request,
    request_error::RequestError,
    subject::{Axes, Subject},
    syntax::{self, AT_SIN_COS, Kind, Word},
};
use crate::{diagnostic, tree::Tree};

/// A request without fault, of any model.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// As it was written: places count there.
    text: String,
    parts: Vec<ParsedPart>,
    at_sin_cos: bool,
}

#[derive(Clone, Debug)]
enum ParsedPart {
    System(&'static Function),
    Frame {
        function: &'static FrameFunction,
        frame: String,
        axes: Axes,
        /// Where the frame is named.
        place: Range<usize>,
    },
}

/// Where a request stands in a module: whether it is the catalogue's, its parts, whether it is given sines and cosines.
pub type Place = (bool, Vec<(usize, Option<(String, Axes)>)>, bool);

impl Parsed {
    /// Reads a request; the grammar stands in the module `syntax`.
    ///
    /// # Errors
    /// The first thing that is wrong with it.
    pub fn read(text: &str) -> Result<Self, RequestError> {
        let sum = syntax::read(text);
        let sum = sum.map_err(|unexpected| RequestError::syntax(text, unexpected))?;
        let mut parts: Vec<ParsedPart> = Vec::new();
        for part in &sum.parts {
            let part = ParsedPart::of(text, part)?;
            if parts.iter().any(|known| known.text() == part.text()) {
                return Err(RequestError::Repeated {
                    request: text.to_owned(),
                    name: part.text(),
                });
            }
            parts.push(part);
        }
        let mut functions = parts.iter().filter_map(ParsedPart::function);
        let compact = functions.find(|function| function.is_compact());
        if let Some(function) = compact.filter(|_| parts.len() > 1) {
            return Err(RequestError::Compact {
                request: text.to_owned(),
                name: function.name.to_owned(),
            });
        }
        Ok(Self {
            text: text.to_owned(),
            parts,
            at_sin_cos: sum.at_sin_cos,
        })
    }

    /// The request on the tree of a model.
    ///
    /// # Errors
    /// A frame that the model lacks.
    pub fn on(&self, tree: &Tree) -> Result<Request, RequestError> {
        self.resolved(Some(tree))
    }

    /// The request, where it is the same of every model.
    ///
    /// # Errors
    /// A frame, which no system has without a model.
    pub fn of_any_model(&self) -> Result<Request, RequestError> {
        self.resolved(None)
    }

    fn resolved(&self, tree: Option<&Tree>) -> Result<Request, RequestError> {
        let parts = self.parts.iter().map(|part| part.on(&self.text, tree));
        let parts = parts.collect::<Result<_, _>>()?;
        Ok(Request::new(parts, self.at_sin_cos))
    }

    /// The functions of the whole system among the parts.
    pub fn functions(&self) -> impl Iterator<Item = &'static Function> {
        self.parts.iter().filter_map(ParsedPart::function)
    }

    /// The function of the catalogue, where it is one as it stands there.
    pub fn alone(&self) -> Option<&'static Function> {
        match &self.parts[..] {
            [part] if !self.at_sin_cos => part.function(),
            _ => None,
        }
    }

    /// As it is asked for, without white space: `mass_matrix+bias(sin_cos)`.
    pub fn text(&self) -> String {
        let parts: Vec<String> = self.parts.iter().map(ParsedPart::text).collect();
        parts.join("+") + if self.at_sin_cos { AT_SIN_COS } else { "" }
    }

    /// Where it stands in a module: the catalogue's functions in their order, then the others.
    pub fn place(&self) -> Place {
        let parts = self.parts.iter().map(ParsedPart::place).collect();
        (self.alone().is_none(), parts, self.at_sin_cos)
    }
}

impl ParsedPart {
    fn of(text: &str, part: &syntax::Part) -> Result<Self, RequestError> {
        let place = part.place.clone();
        let Kind::Named { name, of } = &part.kind else {
            return Err(RequestError::NotAvailable {
                part: text[place.clone()].to_owned(),
                place,
            });
        };
        if let Some(function) = Function::find(&name.text) {
            return match of[..] {
                [] => Ok(Self::System(function)),
                _ => Err(RequestError::FrameNotTaken {
                    name: name.text.clone(),
                    place,
                }),
            };
        }
        let Some(function) = FrameFunction::of_frame(&name.text) else {
            return Err(RequestError::Unknown {
                name: name.text.clone(),
            });
        };
        let Some((frame, rest)) = of.split_first() else {
            return Err(RequestError::FrameMissing {
                name: name.text.clone(),
                place,
            });
        };
        Ok(Self::Frame {
            function,
            frame: frame.text.clone(),
            axes: axes(function, rest)?,
            place: frame.place.clone(),
        })
    }

    fn on(&self, text: &str, tree: Option<&Tree>) -> Result<Part, RequestError> {
        match self {
            Self::System(function) => Ok(Part::System(function)),
            Self::Frame {
                function,
                frame,
                axes,
                place,
            } => {
                let subject = tree.and_then(|tree| Subject::find(tree, frame, *axes));
                let subject = subject.ok_or_else(|| RequestError::UnknownFrame {
                    request: text.to_owned(),
                    name: frame.clone(),
                    known: tree.map_or_else(Vec::new, |tree| nearest_first(tree, frame)),
                    place: place.clone(),
                })?;
                Ok(Part::Frame(function, subject))
            }
        }
    }

    fn function(&self) -> Option<&'static Function> {
        match self {
            Self::System(function) => Some(function),
            Self::Frame { .. } => None,
        }
    }

    fn text(&self) -> String {
        match self {
            Self::System(function) => function.name.to_owned(),
            Self::Frame {
                function,
                frame,
                axes,
                ..
            } => text_of(function, frame, *axes),
        }
    }

    fn place(&self) -> (usize, Option<(String, Axes)>) {
        match self {
            Self::System(function) => (position(&CATALOGUE, function.name), None),
            Self::Frame {
                function,
                frame,
                axes,
                ..
            } => {
                let place = CATALOGUE.len() + position(&OF_FRAMES, function.name);
                (place, Some((frame.clone(), *axes)))
            }
        }
    }
}

/// The axes that are named behind a frame.
fn axes(function: &FrameFunction, rest: &[Word]) -> Result<Axes, RequestError> {
    let fault = |word: &Word, expected| {
        Err(RequestError::Axes {
            name: function.name.to_owned(),
            found: word.text.clone(),
            expected,
            place: word.place.clone(),
        })
    };
    match rest {
        [] => Ok(Axes::Inertial),
        [word, ..] if !function.has_local => fault(word, "expected nothing there"),
        [word] if word.text == LOCAL => Ok(Axes::Local),
        [word] => fault(word, "expected `local`, for the frame's own axes"),
        [_, word, ..] => fault(word, "expected no more than `local`"),
    }
}

/// The frames of the model, the nearest name first.
fn nearest_first(tree: &Tree, name: &str) -> Vec<String> {
    let frames = tree.named_frames();
    let mut known: Vec<&str> = frames.map(|frame| tree.frame_name(frame)).collect();
    if let Some(nearest) = diagnostic::nearest(name, &known) {
        // False sorts before true, and what is equal keeps its order.
        known.sort_by_key(|known| *known != nearest);
    }
    known.into_iter().map(str::to_owned).collect()
}

fn position<R>(functions: &[Function<R>], name: &str) -> usize {
    let mut functions = functions.iter();
    let position = functions.position(|function| function.name == name);
    position.expect("functions: a part is of the catalogue")
}

impl Request {
    /// Reads names of the catalogue with `+` between them, and `(sin_cos)` after them where the function is to be given the
    /// sines and cosines of the angles among the coordinates. What is of a frame needs a model: [`Parsed::on`].
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
        Parsed::read(text)?.of_any_model()
    }
}
