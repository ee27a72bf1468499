//! What a user asks for, before a model is known.
//!
//! In: a text such as `bias`, `mass_matrix+pose(tool0)` or `bias(sin_cos)`. Out: a [`Parsed`] request. Afterwards: every
//! part is of the catalogue and of what it can be of, none is there twice, and what is joined has no compact output. Does
//! not: know which frames there are.

use std::ops::Range;

use super::{
    given_name, join_faults,
    parsed_subject::ParsedSubject,
    request_error::{RequestError, all_or_faults, each_once},
    syntax::{self, AT_SIN_COS, Kind, Product, Unexpected, Word, written},
};
use crate::{
    diagnostic::NearNames,
    functions::{
        derivatives::derivative::{Derivative, DerivativeKind},
        function::{Function, Of},
        part::{AskedPart, Part},
        request::Request,
        subject::View,
        variable::{self, Variable, holding},
    },
    tree::Tree,
};

/// A request without fault, of any model.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// As it was written: places count there.
    text: String,
    /// What the function is to be called.
    name: Option<String>,
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

/// Where a request stands in a module: by the first of these that differs from another's.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// True for what is not a function of the catalogue and of the system, as it is.
    is_other: bool,
    parts: Vec<PartPlace>,
    at_sin_cos: bool,
    name: Option<String>,
}

/// The same of a part.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct PartPlace {
    /// The place of its function in the catalogue.
    function: usize,
    frames: Option<(Vec<String>, View)>,
    /// What of its derivatives, and by what.
    derivative: Option<(DerivativeKind, Vec<String>)>,
}

impl Parsed {
    /// Reads a request; the grammar stands in the module `syntax`.
    ///
    /// # Errors
    /// All that is wrong with it, part by part; of how parts go together the first.
    pub fn read(text: &str) -> Result<Self, Vec<RequestError>> {
        let sum = syntax::read(text);
        let sum = sum.map_err(|unexpected| vec![RequestError::syntax(text, unexpected)])?;
        let mut faults = Vec::new();
        faults.extend(sum.name.as_ref().and_then(given_name::fault));
        let parts = sum.parts.iter();
        let parts = parts.map(|part| ParsedPart::of(text, part).map_err(|fault| vec![fault]));
        let parts = all_or_faults(parts);
        match &parts {
            Ok(parts) => {
                let asked: Vec<AskedPart<'_>> = parts.iter().map(ParsedPart::asked).collect();
                faults.extend(join_faults::first(text, &asked, join_faults::plain));
            }
            Err(more) => faults.extend(more.iter().cloned()),
        }
        let (Ok(parts), []) = (parts, &faults[..]) else {
            return Err(faults);
        };
        Ok(Self {
            text: text.to_owned(),
            name: sum.name.map(|name| name.text),
            parts,
            at_sin_cos: sum.at_sin_cos,
        })
    }

    /// The request on the tree of a model.
    ///
    /// # Errors
    /// All frames that the model lacks.
    pub fn on(&self, tree: &Tree) -> Result<Request, Vec<RequestError>> {
        self.on_with(tree, &mut NearNames::default())
    }

    /// The same for one of many requests; `near` looks for the frames that were meant, of all of them together.
    pub(crate) fn on_with(
        &self,
        tree: &Tree,
        near: &mut NearNames,
    ) -> Result<Request, Vec<RequestError>> {
        self.resolved(Some(tree), near)
    }

    /// The request, where it is the same of every model.
    ///
    /// # Errors
    /// A frame, which no system has without a model.
    pub fn of_any_model(&self) -> Result<Request, RequestError> {
        let request = self.resolved(None, &mut NearNames::default());
        request.map_err(|mut faults| faults.swap_remove(0))
    }

    fn resolved(
        &self,
        tree: Option<&Tree>,
        near: &mut NearNames,
    ) -> Result<Request, Vec<RequestError>> {
        let parts = self.parts.iter();
        let parts = parts.map(|part| part.on(&self.text, tree, near));
        let parts = all_or_faults(parts)?;
        let asked: Vec<AskedPart<'_>> = parts.iter().map(Part::asked).collect();
        match join_faults::first(&self.text, &asked, str::to_owned) {
            Some(fault) => Err(vec![fault]),
            None => Ok(Request::new(self.name.clone(), parts, self.at_sin_cos)),
        }
    }

    /// The functions of the whole system among the parts.
    pub fn functions(&self) -> impl Iterator<Item = &'static Function> {
        self.parts.iter().filter_map(ParsedPart::of_system)
    }

    /// The function of the whole system that it asks for, where it asks for one as the catalogue has it.
    pub fn catalogue_function(&self) -> Option<&'static Function> {
        match &self.parts[..] {
            [part] if !self.at_sin_cos && self.name.is_none() => part.of_system(),
            _ => None,
        }
    }

    /// As it is asked for, in one way of writing it: `mass_matrix+bias(sin_cos)`, `step = mass_matrix+bias`.
    pub fn text(&self) -> String {
        syntax::named(self.name.as_deref(), self.sum())
    }

    /// The same without a name that it is given.
    pub fn sum(&self) -> String {
        syntax::sum(self.parts.iter().map(ParsedPart::text), self.at_sin_cos)
    }

    /// A request without what does not matter, spaces and quotes; one with faults as it is.
    pub fn plain(request: &str) -> String {
        Self::read(request).map_or_else(|_| request.to_owned(), |parsed| parsed.text())
    }

    /// True where it joins the same parts, in whatever order.
    pub fn has_the_parts_of(&self, other: &Self) -> bool {
        let parts = |of: &Self| {
            let mut parts: Vec<String> = of.parts.iter().map(ParsedPart::text).collect();
            parts.sort_unstable();
            parts
        };
        self.at_sin_cos == other.at_sin_cos && parts(self) == parts(other)
    }

    /// What it says that the function is to be called.
    pub fn given_name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// Where it stands in a module: the catalogue's functions in their order, then the others.
    pub fn place(&self) -> Place {
        let parts = self.parts.iter().map(ParsedPart::place).collect();
        Place {
            is_other: self.catalogue_function().is_none(),
            parts,
            at_sin_cos: self.at_sin_cos,
            name: self.name.clone(),
        }
    }
}

impl ParsedPart {
    fn of(text: &str, part: &syntax::Part) -> Result<Self, RequestError> {
        match &part.kind {
            Kind::Named { name, of } => Self::named(text, (name, of), part.place.clone()),
            Kind::Derivative { of, by } => {
                Self::derivative(text, part, of, (DerivativeKind::Jacobian, by))
            }
            Kind::Packed { of: inner } => match &inner.kind {
                Kind::Derivative { of, by } => {
                    Self::derivative(text, part, of, (DerivativeKind::PackedJacobian, by))
                }
                _ => Err(not_packed(text, inner)),
            },
            Kind::Product { product, of, along } => {
                let kind = match product {
                    Product::Jvp => DerivativeKind::Jvp,
                    Product::Vjp => DerivativeKind::Vjp,
                    Product::Hessian => DerivativeKind::Hessian,
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
            return Err(no_derivative(
                text,
                of,
                "is a derivative itself (second ones are `hessian(F; X)`)",
            ));
        };
        let values = Self::named(text, (name, frames), part.place.clone())?;
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
            if word.text.is_empty() {
                let place = word.place.clone();
                let expected = "expected a variable";
                return Err(RequestError::syntax(text, Unexpected { expected, place }));
            }
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
        text: &str,
        (name, of): (&Word, &[Word]),
        place: Range<usize>,
    ) -> Result<Self, RequestError> {
        let syntax = |expected, place: &Range<usize>| {
            let place = place.clone();
            Err(RequestError::syntax(text, Unexpected { expected, place }))
        };
        if name.text.is_empty() {
            return syntax("expected the name of a function", &name.place);
        }
        let Some(function) = Function::find(&name.text) else {
            return Err(RequestError::Unknown {
                name: name.text.clone(),
            });
        };
        if let Some(empty) = of.iter().find(|word| word.text.is_empty())
            && function.of != Of::System
        {
            return syntax("expected the name of a frame", &empty.place);
        }
        let name = || name.text.clone();
        let subject = match (function.of, of) {
            (Of::System, []) => None,
            (Of::System, [word]) if word.is("sin_cos") => {
                let expected = "`(sin_cos)` stands last, behind the whole request";
                return syntax(expected, &word.place);
            }
            (Of::System, _) => {
                return Err(RequestError::FrameNotTaken {
                    name: name(),
                    place,
                });
            }
            (Of::Frame(_) | Of::Frames(_), []) => {
                return Err(RequestError::FrameMissing {
                    name: name(),
                    // Unquoted, it is no frame.
                    is_sin_cos: text.ends_with(AT_SIN_COS),
                    place,
                });
            }
            (Of::Frame(views), [frame, rest @ ..]) => {
                Some(ParsedSubject::new(function, frame, rest, views)?)
            }
            (Of::Frames(views), frames) => Some(ParsedSubject::of_several(text, frames, views)?),
        };
        Ok(Self {
            function,
            subject,
            derivative: None,
        })
    }

    fn on(
        &self,
        text: &str,
        tree: Option<&Tree>,
        near: &mut NearNames,
    ) -> Result<Part, Vec<RequestError>> {
        let subject = self.subject.as_ref();
        let is_jvp = |(kind, _): &(DerivativeKind, _)| *kind == DerivativeKind::Jvp;
        let is_jvp = self.derivative.as_ref().is_some_and(is_jvp);
        let variable = |word: &Word| {
            let (request, name, place) = (text.to_owned(), word.text.clone(), word.place.clone());
            match Variable::find(tree, &word.text) {
                Some(own) if is_jvp && own.direction().is_none() => {
                    Err(vec![RequestError::OneOfDirection {
                        request,
                        name,
                        place,
                    }])
                }
                Some(own) => Ok(own),
                None => Err(vec![RequestError::UnknownVariable {
                    request,
                    function: self.function.name,
                    entry_of: tree.and_then(|tree| holding(tree, &name)),
                    name,
                    known: variables(self.function, tree, is_jvp),
                    place,
                }]),
            }
        };
        let by = self.derivative.iter().flat_map(|(_, by)| by);
        let by = all_or_faults(by.map(variable)).and_then(|by| each_once(text, by));
        let subject = subject
            .map(|subject| subject.on(text, tree, near))
            .transpose();
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

    fn text(&self) -> String {
        self.asked().text()
    }

    fn asked(&self) -> AskedPart<'_> {
        let subject = self.subject.as_ref();
        let by = |by: &[Word]| {
            let words: Vec<String> = by.iter().map(|word| written(&word.text)).collect();
            words.join(", ")
        };
        let derivative = self.derivative.as_ref();
        AskedPart {
            function: self.function,
            subject: subject.map(|own| (own.names().collect(), own.view)),
            derivative: derivative.map(|(kind, words)| (*kind, by(words))),
        }
    }

    fn place(&self) -> PartPlace {
        let mut functions = Function::all();
        let position = functions.position(|function| function.name == self.function.name);
        let subject = self.subject.as_ref();
        PartPlace {
            function: position.expect("functions: a part is of the catalogue"),
            frames: subject
                .map(|subject| (subject.names().map(str::to_owned).collect(), subject.view)),
            derivative: self.derivative.as_ref().map(|(kind, by)| {
                let by = by.iter().map(|word| word.text.clone());
                (*kind, by.collect())
            }),
        }
    }
}

/// What `packed` does not take, and what has that name instead.
fn not_packed(text: &str, part: &syntax::Part) -> RequestError {
    let place = part.place.clone();
    let asked = &text[place.clone()];
    if let Kind::Named { name, .. } = &part.kind {
        let own = format!("{}_packed", name.text);
        if Function::find(&own).is_some() {
            return RequestError::PackedName {
                part: asked.to_owned(),
                own: own + &asked[name.place.end - place.start..],
                place,
            };
        }
    }
    let expected = match &part.kind {
        Kind::Product {
            product: Product::Hessian,
            ..
        } => "a `hessian` is packed without it",
        _ => "expected `d(PART)/d(VARIABLES)`",
    };
    RequestError::syntax(text, Unexpected { expected, place })
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
fn variables(function: &Function, tree: Option<&Tree>, is_jvp: bool) -> Vec<String> {
    let arguments = function.variables();
    let arguments = arguments.map(|argument| argument.name().to_owned());
    let parameters = tree.map_or(&[][..], |tree| &tree.parameters).iter();
    let all = parameters
        .clone()
        .take(1)
        .map(|_| variable::PARAMETERS.to_owned());
    // A direction is one of all values set at run time.
    let parameters = parameters.filter(|_| !is_jvp);
    let parameters = parameters.map(|parameter| parameter.name.clone());
    arguments.chain(all).chain(parameters).collect()
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
    /// assert_eq!(Request::parse("step = mass_matrix+bias").unwrap().name(), "step");
    /// assert!(Request::parse("mass_matrix+mass").is_err());
    /// ```
    ///
    /// # Errors
    /// The first thing that is wrong with it.
    pub fn parse(text: &str) -> Result<Self, RequestError> {
        let parsed = Parsed::read(text).map_err(|mut faults| faults.swap_remove(0));
        parsed?.of_any_model()
    }
}
