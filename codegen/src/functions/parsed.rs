//! What a user asks for, before a model is known.
//!
//! In: a text such as `bias`, `mass_matrix+pose(tool0)` or `bias(sin_cos)`. Out: a [`Parsed`] request. Afterwards: every
//! part is of the catalogue and of what it can be of, none is there twice, and what is joined has no compact output. Does
//! not: know which frames there are.

use super::{
    catalogue::{CATALOGUE, OF_FRAMES},
    derivative::{Derivative, DerivativeKind},
    function::{Function, Of},
    part::{LOCAL, Part, text_of},
    request::Request,
    request_error::RequestError,
    subject::{Subject, SubjectFrame, View},
    syntax::{self, AT_SIN_COS, Kind, Word, written},
    variable::{self, Variable},
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
struct ParsedPart {
    function: &'static Function,
    subject: Option<ParsedSubject>,
    /// What of its derivatives is asked for, and by what it is differentiated.
    derivative: Option<(DerivativeKind, Vec<Word>)>,
}

/// Frames that are named, before it is known whether the model has them.
#[derive(Clone, Debug)]
struct ParsedSubject {
    frames: Vec<Word>,
    view: View,
}

/// Where a request stands in a module: whether it is the catalogue's, its parts, whether it is given sines and cosines.
pub type Place = (bool, Vec<PartPlace>, bool);

/// The same of a part: its place in the catalogue, its frames, what it is differentiated by.
pub(super) type PartPlace = (
    usize,
    Option<(Vec<String>, View)>,
    Option<(DerivativeKind, Vec<String>)>,
);

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
        let mut functions = parts.iter().map(|part| part.function);
        let compact = functions.find(|function| function.is_compact());
        if let Some(function) = compact.filter(|_| parts.len() > 1) {
            return Err(RequestError::Compact {
                request: text.to_owned(),
                name: function.name.to_owned(),
            });
        }
        // What is given to one function is the same for its values and its derivatives.
        let mut own = parts.iter().filter(|part| part.has_own_arguments());
        let first = own.next().map(ParsedPart::text_of_values);
        if let Some(other) = own.find(|part| Some(part.text_of_values()) != first) {
            return Err(RequestError::OwnArguments {
                request: text.to_owned(),
                name: other.text(),
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
    /// All frames that the model lacks.
    pub fn on(&self, tree: &Tree) -> Result<Request, Vec<RequestError>> {
        self.resolved(Some(tree))
    }

    /// The request, where it is the same of every model.
    ///
    /// # Errors
    /// A frame, which no system has without a model.
    pub fn of_any_model(&self) -> Result<Request, RequestError> {
        let request = self.resolved(None);
        request.map_err(|mut faults| faults.swap_remove(0))
    }

    fn resolved(&self, tree: Option<&Tree>) -> Result<Request, Vec<RequestError>> {
        let parts = self.parts.iter().map(|part| part.on(&self.text, tree));
        let parts = all_or_faults(parts)?;
        Ok(Request::new(parts, self.at_sin_cos))
    }

    /// The functions of the whole system among the parts.
    pub fn functions(&self) -> impl Iterator<Item = &'static Function> {
        self.parts.iter().filter_map(ParsedPart::of_system)
    }

    /// The function of the whole system, where it is one alone.
    pub fn alone(&self) -> Option<&'static Function> {
        match &self.parts[..] {
            [part] if !self.at_sin_cos => part.of_system(),
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
        match &part.kind {
            Kind::Named { name, of } => Self::named((name, of), part.place.clone()),
            Kind::Derivative { of, by, is_packed } => {
                let kind = if *is_packed {
                    DerivativeKind::Packed
                } else {
                    DerivativeKind::Whole
                };
                Self::derivative(text, part, of, (kind, by))
            }
            Kind::Product { name, of, along } => {
                let kind = match name.text.as_str() {
                    "jvp" => DerivativeKind::Forward,
                    "vjp" => DerivativeKind::Reverse,
                    _ => DerivativeKind::Hessian,
                };
                Self::derivative(text, part, of, (kind, along))
            }
        }
    }

    fn derivative(
        text: &str,
        part: &syntax::Part,
        of: &syntax::Part,
        (kind, by): (DerivativeKind, &[Word]),
    ) -> Result<Self, RequestError> {
        let Kind::Named { name, of: frames } = &of.kind else {
            return Err(no_derivative(text, of, "is a derivative itself"));
        };
        let values = Self::named((name, frames), part.place.clone())?;
        if values.function.is_compact() {
            return Err(no_derivative(text, of, "has a compact output"));
        }
        values.differentiated(text, (kind, by))
    }

    /// The same, differentiated.
    fn differentiated(
        self,
        text: &str,
        (kind, by): (DerivativeKind, &[Word]),
    ) -> Result<Self, RequestError> {
        let name = self.function.name;
        for (at, word) in by.iter().enumerate() {
            if by[..at].iter().any(|known| known.text == word.text) {
                return Err(RequestError::Repeated {
                    request: text.to_owned(),
                    name: word.text.clone(),
                });
            }
            if let Some(Variable::Given(argument)) = Variable::find(None, &word.text)
                && !self.function.arguments.contains(&argument)
            {
                return Err(RequestError::VariableNotTaken {
                    name: name.to_owned(),
                    variable: argument.name(),
                    known: variables(self.function, None, false),
                    place: word.place.clone(),
                });
            }
        }
        Ok(Self {
            derivative: Some((kind, by.to_vec())),
            ..self
        })
    }

    fn named(
        (name, of): (&Word, &[Word]),
        place: std::ops::Range<usize>,
    ) -> Result<Self, RequestError> {
        let Some(function) = Function::find(&name.text) else {
            return Err(RequestError::Unknown {
                name: name.text.clone(),
            });
        };
        let name = || name.text.clone();
        let subject = match (function.of, of) {
            (Of::System, []) => None,
            (Of::System, _) => {
                return Err(RequestError::FrameNotTaken {
                    name: name(),
                    place,
                });
            }
            (Of::Frame(_) | Of::Frames(_), []) => {
                return Err(RequestError::FrameMissing {
                    name: name(),
                    place,
                });
            }
            (Of::Frame(views), [frame, rest @ ..]) => {
                Some(ParsedSubject::new(function, frame, rest, views)?)
            }
            (Of::Frames(views), frames) => Some(ParsedSubject::of_several(frames, views)),
        };
        Ok(Self {
            function,
            subject,
            derivative: None,
        })
    }

    fn on(&self, text: &str, tree: Option<&Tree>) -> Result<Part, Vec<RequestError>> {
        let subject = self.subject.as_ref();
        let is_forward = |(kind, _): &(DerivativeKind, _)| *kind == DerivativeKind::Forward;
        let is_forward = self.derivative.as_ref().is_some_and(is_forward);
        let variable = |word: &Word| {
            let variable = Variable::find(tree, &word.text);
            // A direction is one of all values set at run time.
            let variable = variable.filter(|own| !is_forward || own.direction().is_some());
            variable.ok_or_else(|| {
                vec![RequestError::UnknownVariable {
                    request: text.to_owned(),
                    function: self.function.name,
                    name: word.text.clone(),
                    known: variables(self.function, tree, is_forward),
                    place: word.place.clone(),
                }]
            })
        };
        let by = self.derivative.iter().flat_map(|(_, by)| by);
        let by = all_or_faults(by.map(variable));
        let subject = subject.map(|subject| subject.on(text, tree)).transpose();
        let (by, subject) = match (by, subject) {
            (Ok(by), Ok(subject)) => (by, subject),
            (by, subject) => {
                let faults = [by.err(), subject.err()].into_iter().flatten();
                return Err(faults.flatten().collect());
            }
        };
        Ok(Part {
            function: self.function,
            subject,
            derivative: self
                .derivative
                .as_ref()
                .map(|&(kind, _)| Derivative::new(kind, by)),
        })
    }

    /// The function, where it is of the whole system.
    fn of_system(&self) -> Option<&'static Function> {
        let is_plain = self.subject.is_none() && self.derivative.is_none();
        is_plain.then_some(self.function)
    }

    fn text_of_values(&self) -> String {
        match &self.subject {
            None => self.function.name.to_owned(),
            Some(subject) => text_of(self.function, subject.names(), subject.view),
        }
    }

    fn text(&self) -> String {
        let of = self.text_of_values();
        let Some((kind, by)) = &self.derivative else {
            return of;
        };
        let by: Vec<String> = by.iter().map(|word| written(&word.text)).collect();
        Derivative::text(*kind, &of, &by.join(", "))
    }

    /// True where it is given what no other part can be given beside it.
    fn has_own_arguments(&self) -> bool {
        let is_weighted = |(kind, _): &(DerivativeKind, _)| {
            matches!(kind, DerivativeKind::Reverse | DerivativeKind::Hessian)
        };
        let mut arguments = self.function.arguments.iter();
        self.derivative.as_ref().is_some_and(is_weighted)
            || arguments.any(|argument| argument.is_of_frame())
    }

    fn place(&self) -> PartPlace {
        let mut functions = CATALOGUE.iter().chain(&OF_FRAMES);
        let position = functions.position(|function| function.name == self.function.name);
        let subject = self.subject.as_ref();
        (
            position.expect("functions: a part is of the catalogue"),
            subject.map(|subject| (subject.names().map(str::to_owned).collect(), subject.view)),
            self.derivative.as_ref().map(|(kind, by)| {
                let by = by.iter().map(|word| word.text.clone());
                (*kind, by.collect())
            }),
        )
    }
}

impl ParsedSubject {
    /// A frame, and what is said behind it of how it is seen.
    fn new(
        function: &Function,
        frame: &Word,
        rest: &[Word],
        views: &[View],
    ) -> Result<Self, RequestError> {
        let fault = |word: &Word, expected| {
            Err(RequestError::View {
                name: function.name.to_owned(),
                found: word.text.clone(),
                expected,
                place: word.place.clone(),
            })
        };
        let (has_local, has_other) = (views.contains(&View::Local), views.contains(&View::Other));
        let (frames, view) = match rest {
            [] => (vec![frame], View::Inertial),
            [word] if has_local && word.is(LOCAL) => (vec![frame], View::Local),
            [word] if has_other && word.is(LOCAL) => return fault(word, "expected another frame"),
            [other] if has_other => (vec![frame, other], View::Other),
            [word, ..] if views.len() == 1 => return fault(word, "expected nothing there"),
            [word] => return fault(word, "expected `local`, for the frame's own axes"),
            [_, word, ..] if has_other => return fault(word, "expected no more than one word"),
            [_, word, ..] => return fault(word, "expected no more than `local`"),
        };
        let frames = frames.into_iter().cloned().collect();
        Ok(Self { frames, view })
    }

    /// Frames, and at the end perhaps that their own axes are meant.
    fn of_several(words: &[Word], views: &[View]) -> Self {
        let has_local = views.contains(&View::Local);
        let (frames, view) = match words {
            [frames @ .., last] if has_local && last.is(LOCAL) && !frames.is_empty() => {
                (frames, View::Local)
            }
            frames => (frames, View::Inertial),
        };
        Self {
            frames: frames.to_vec(),
            view,
        }
    }

    fn names(&self) -> impl Iterator<Item = &str> {
        self.frames.iter().map(|frame| frame.text.as_str())
    }

    fn on(&self, text: &str, tree: Option<&Tree>) -> Result<Subject, Vec<RequestError>> {
        let found = |word: &Word| {
            let frame = tree.and_then(|tree| SubjectFrame::find(tree, &word.text));
            frame.ok_or_else(|| {
                vec![RequestError::UnknownFrame {
                    request: text.to_owned(),
                    name: word.text.clone(),
                    known: tree.map_or_else(Vec::new, |tree| nearest_first(tree, &word.text)),
                    place: word.place.clone(),
                }]
            })
        };
        let frames = all_or_faults(self.frames.iter().map(found))?;
        Ok(Subject::new(tree, frames, self.view))
    }
}

/// What cannot be differentiated.
fn no_derivative(text: &str, part: &syntax::Part, why: &'static str) -> RequestError {
    let place = part.place.clone();
    RequestError::NoDerivative {
        part: text[place.clone()].to_owned(),
        why,
        place,
    }
}

/// By what a function can be differentiated.
fn variables(function: &Function, tree: Option<&Tree>, is_forward: bool) -> Vec<String> {
    let arguments = variable::ARGUMENTS.into_iter();
    let arguments = arguments.filter(|argument| function.arguments.contains(argument));
    let arguments = arguments.map(|argument| argument.name().to_owned());
    let parameters = tree.map_or(&[][..], |tree| &tree.parameters).iter();
    let all = parameters
        .clone()
        .take(1)
        .map(|_| variable::PARAMETERS.to_owned());
    // A direction is one of all values set at run time.
    let parameters = parameters.filter(|_| !is_forward);
    let parameters = parameters.map(|parameter| parameter.name.clone());
    arguments.chain(all).chain(parameters).collect()
}

/// All of what is found, or all that is wrong.
fn all_or_faults<T>(
    results: impl Iterator<Item = Result<T, Vec<RequestError>>>,
) -> Result<Vec<T>, Vec<RequestError>> {
    let (mut found, mut faults) = (Vec::new(), Vec::new());
    for result in results {
        match result {
            Ok(one) => found.push(one),
            Err(more) => faults.extend(more),
        }
    }
    if faults.is_empty() {
        Ok(found)
    } else {
        Err(faults)
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
