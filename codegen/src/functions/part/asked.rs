//! How a part is asked for, on the tree of a model or before one is known.

use crate::functions::{
    derivatives::derivative::{Derivative, DerivativeKind},
    function::Function,
    parse::syntax::{LOCAL, written},
    subject::View,
};

/// What the text of a part says.
pub(in crate::functions) struct AskedPart<'a> {
    pub(in crate::functions) function: &'static Function,
    /// The frames and how they are seen; `None` of the whole system.
    pub(in crate::functions) subject: Option<(Vec<&'a str>, View)>,
    /// What of its derivatives, and by what.
    pub(in crate::functions) derivative: Option<(DerivativeKind, String)>,
}

impl AskedPart<'_> {
    /// `d(bias)/d(q, u)`, `velocity(tool0, local)`.
    pub(in crate::functions) fn text(&self) -> String {
        let of = self.text_of_values();
        match &self.derivative {
            None => of,
            Some((kind, by)) => Derivative::text(*kind, &of, by),
        }
    }

    /// The same, not differentiated.
    pub(in crate::functions) fn text_of_values(&self) -> String {
        let name = self.function.name;
        let Some((frames, view)) = &self.subject else {
            return name.to_owned();
        };
        let mut words: Vec<String> = frames.iter().copied().map(written).collect();
        words.extend((*view == View::Local).then(|| LOCAL.to_owned()));
        format!("{name}({})", words.join(", "))
    }
}
