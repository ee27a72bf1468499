//! The text of a module, of any age, read once for all that is compared of it.
//!
//! In: a text. Out: a [`ReadModule`]. Syntax does not leave the thread that reads it, so what comparisons need is taken from it there.

use syn::File;

use super::{
    compare::{Comparison, compare, counted},
    declarations::{Declared, Redeclared, declared, redeclared},
    forms::{self, FormChange, Forms},
    held::{Array, arrays, held},
    meaning::Meaning,
    meanings::{Place, meanings, said},
    outline::{Outline, outline},
    places::{Base, Places},
};
use crate::{listing::Counted, rust};

/// Why a text has no outline.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ModuleError {
    /// It is not Rust.
    #[error("it is not Rust that can be read: {0}")]
    Syntax(#[from] syn::Error),
    /// It lacks what every generated module has.
    #[error("it is no generated module: it has no `{0}`")]
    Missing(&'static str),
}

/// What the text of a module says.
///
/// ```
/// use kane_codegen::report::ReadModule;
///
/// let module = |count: usize, arguments: &str| {
///     let text = format!("/// Energy.\n///\n/// Operations: {count} = {count} mul + 0 add + 0 div + 0 trig.\npub fn energy({arguments}) {{}}");
///     ReadModule::read(&text).unwrap()
/// };
/// let (old, new) = (module(7, "q: &[f64; 2], u: &[f64; 2]"), module(8, "u: &[f64; 2], q: &[f64; 2]"));
/// let changed = &old.compare(&new).changed[0];
/// assert_eq!([&changed.old, &changed.new].map(|of| of.operations.total()), [7, 8]);
/// let redeclared = &old.redeclared(&new)[0];
/// assert_eq!((&*redeclared.old, redeclared.new.as_deref()), ("q, u", Some("u, q")));
/// ```
#[derive(Debug)]
pub struct ReadModule {
    counted: Vec<(String, Counted)>,
    declared: Vec<Declared>,
    said: Vec<Place>,
    places: Places,
    base: Base,
    arrays: Vec<Array>,
    forms: Forms,
    outline: Result<Outline, &'static str>,
}

impl ReadModule {
    /// Reads a text. What it lacks is left out.
    ///
    /// # Errors
    /// A text that is not Rust.
    pub fn read(text: &str) -> Result<Self, syn::Error> {
        rust::read(text, |file| Self::of(&file))
    }

    fn of(file: &File) -> Self {
        Self {
            counted: counted(file),
            declared: declared(file),
            said: said(file),
            places: Places::of(file),
            base: Base::of(file),
            arrays: arrays(file),
            forms: forms::of_file(file),
            outline: outline(file),
        }
    }

    /// The functions that state their operations, in the module's order.
    pub fn counted(&self) -> &[(String, Counted)] {
        &self.counted
    }

    /// Its outline.
    ///
    /// # Errors
    /// It is no generated module.
    pub fn outline(&self) -> Result<&Outline, ModuleError> {
        let outline = self.outline.as_ref();
        outline.map_err(|&missing| ModuleError::Missing(missing))
    }

    /// What changed of its functions in a new module.
    pub fn compare(&self, new: &Self) -> Comparison {
        compare(&self.counted, &new.counted)
    }

    /// The public functions that are gone from a new module, or declared otherwise there.
    pub fn redeclared(&self, new: &Self) -> Vec<Redeclared> {
        redeclared(&self.declared, &new.declared)
    }

    /// The places that mean something else in a new module: units of coordinates, which speeds are prescribed, and which entries
    /// arrays have that leave some out.
    pub fn meanings(&self, new: &Self) -> Vec<Meaning> {
        let mut changed = meanings(&self.said, &new.said);
        changed.extend(self.places.changed(&new.places));
        changed
    }

    /// How the base parameters of a new module differ: their number, or the first that is another sum; `None` where they do not, or one
    /// module has none.
    pub fn base_parameters_changed(&self, new: &Self) -> Option<Meaning> {
        self.base.changed(&new.base)
    }

    /// The arrays that have one length in both modules, and hold something else in the new one.
    pub fn held(&self, new: &Self) -> Vec<Meaning> {
        held(&self.arrays, &new.arrays)
    }

    /// The functions of both modules that are written in another form in the new one.
    pub fn forms(&self, new: &Self) -> Vec<FormChange> {
        forms::forms(&self.forms, &new.forms)
    }
}
