//! A part of a request: a function of the catalogue, and what it is of.

mod asked;
mod derive;
mod doc;
mod route;
mod rows;
mod size;
mod told;

use std::{borrow::Cow, sync::Arc};

use super::{
    argument::Argument,
    derivatives::{
        derivative::{Derivative, DerivativeKind},
        sparsity::Sparsity,
    },
    derived::Derived,
    formulation::Formulation,
    function::{Function, Output},
    parse::syntax::{LOCAL, written},
    shape::Dimension,
    subject::{Subject, View},
};
use crate::{base_parameters, recursive::Plan, tree::Tree};

pub(super) use asked::AskedPart;
pub(super) use route::Direct;
pub use rows::Rows;

/// A part of a request, on the tree of a model.
#[derive(Clone, Debug)]
pub struct Part {
    /// The function of the catalogue.
    pub function: &'static Function,
    /// The frames that it is of; `None` of the whole system.
    pub subject: Option<Subject>,
    /// By what it is differentiated; `None` for its values.
    pub derivative: Option<Derivative>,
}

impl Part {
    /// As it is asked for.
    pub fn text(&self) -> String {
        self.asked().text()
    }

    /// What its text says.
    pub(super) fn asked(&self) -> AskedPart<'_> {
        let subject = self.subject.as_ref();
        let derivative = self.derivative.as_ref();
        AskedPart {
            function: self.function,
            subject: subject.map(|own| (own.names().collect(), own.view)),
            derivative: derivative.map(|own| (own.kind, own.joined(", "))),
        }
    }

    /// Its name in generated code: `bias`, `tool0_velocity_local`.
    pub fn name(&self) -> String {
        let of = self.name_of(self.function.name);
        match &self.derivative {
            None => of,
            Some(derivative) => derivative.name(&of),
        }
    }

    /// The same, not differentiated.
    #[must_use]
    pub fn values(&self) -> Self {
        Self {
            derivative: None,
            ..self.clone()
        }
    }

    /// What its frames and how they are seen make of a name.
    fn name_of(&self, name: &str) -> String {
        let Some(subject) = &self.subject else {
            return name.to_owned();
        };
        let frames = subject.frames.iter();
        let frames: Vec<&str> = frames.map(|frame| frame.identifier.as_str()).collect();
        match (subject.view, &frames[..]) {
            (View::Other, [frame, other]) => format!("{frame}_{name}_from_{other}"),
            (View::Local, frames) => format!("{}_{name}_{LOCAL}", frames.join("_")),
            (_, frames) => format!("{}_{name}", frames.join("_")),
        }
    }

    /// The constant that says which speeds move the frame that it is of.
    pub fn speeds_constant(&self) -> String {
        self.name_of("speeds").to_uppercase()
    }

    /// The constant that says how many these are.
    pub fn speeds_len_constant(&self) -> String {
        self.name_of("speeds_len").to_uppercase()
    }

    /// The constants that a module with it has, each with what it is of.
    pub fn constants(&self) -> Vec<(String, String)> {
        let subject = self.subject.as_ref();
        let speeds = subject.filter(|_| self.function.has_frame_speeds());
        let speeds = speeds.map(|subject| {
            let frames = subject.frames.iter().map(|frame| written(&frame.name));
            let frames: Vec<String> = frames.collect();
            (self.speeds_constant(), frames.join(", "))
        });
        let derivative = self.derivative.as_ref();
        let places = derivative.filter(|own| own.kind.is_packed());
        let places = places.map(|_| (self.places_constant(), self.text()));
        speeds.into_iter().chain(places).collect()
    }

    /// What it is given besides the parameters.
    pub(super) fn arguments(&self) -> Vec<Argument> {
        let derivative = self.derivative.iter();
        let own = derivative.flat_map(|derivative| {
            derivative.arguments(self.function.outputs, self.subject_length())
        });
        let arguments = self.function.arguments.iter().copied();
        arguments.chain(own).collect()
    }

    /// The length of the dimensions of its values that its subject decides, zero where none is.
    fn subject_length(&self) -> usize {
        let mut written = Dimension::OF_SUBJECTS.into_iter();
        let written = written.find(|dimension| self.function.writes(*dimension));
        let length = |subject: &Subject| subject.length(written?);
        self.subject.as_ref().and_then(length).unwrap_or(0)
    }

    /// True where second derivatives are asked for.
    pub(super) fn is_second_derivative(&self) -> bool {
        let derivative = self.derivative.as_ref();
        derivative.is_some_and(|derivative| derivative.kind == DerivativeKind::Hessian)
    }

    /// Which entries of a packed derivative it writes; `None` where it is none.
    pub fn sparsity(&self, tree: &Tree) -> Option<Arc<Sparsity>> {
        let derivative = self.derivative.as_ref()?;
        if self.function.writes(Dimension::BaseParameters) {
            // Which there are follows from the model's own numbers: the trees of drawn numbers take them over.
            base_parameters::find_now(tree);
        }
        let of = (self.function.outputs, self.subject_length());
        derivative.sparsity(tree, of, |tree| {
            let mut derived = Derived::default();
            let plan = Plan::plain(tree);
            self.derive_values(&mut derived, tree, Formulation::Recursive, &plan);
            derived
        })
    }

    /// The constant that says which they are.
    pub fn places_constant(&self) -> String {
        format!("{}_PLACES", self.name().to_uppercase())
    }

    /// The constant that says how many.
    pub fn len_constant(&self) -> String {
        format!("{}_LEN", self.name().to_uppercase())
    }

    /// The constant that holds the colours of columns.
    pub fn colors_constant(&self) -> String {
        format!("{}_COLORS", self.name().to_uppercase())
    }

    /// The constant that says how many columns there are.
    pub fn columns_constant(&self) -> String {
        format!("{}_COLUMNS", self.name().to_uppercase())
    }

    /// What it writes, in order.
    pub fn outputs(&self) -> Cow<'static, [Output]> {
        match &self.derivative {
            None => self.function.outputs.into(),
            Some(derivative) => derivative.outputs(self.function.outputs).into(),
        }
    }
}
