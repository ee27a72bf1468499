//! Why what is asked for cannot be had.

use std::ops::Range;

use super::syntax::Unexpected;
use crate::{
    diagnostic::Escaped,
    functions::{
        names::dictionary::{advice, advice_on_variable},
        variable::Variable,
    },
};

/// Why a function cannot be had.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RequestError {
    /// A name that the catalogue does not hold.
    #[error("`{}` is no function; {}", name.escaped(), advice(name))]
    Unknown {
        /// The name.
        name: String,
    },
    /// A name that no function can be given.
    #[error("`{}` cannot be the name of a function: {why}", name.escaped())]
    Name {
        /// The name.
        name: String,
        /// Why not.
        why: String,
        /// Where in the request.
        place: Range<usize>,
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
    /// Two parts that are each given something of their own.
    #[error(
        "`{name}` and another part of `{request}` are each given a point, force, moment or multiplier of their own; ask for them apart"
    )]
    OwnArguments {
        /// What was asked for.
        request: String,
        /// The part.
        name: String,
    },
    /// What is no request at all.
    #[error("`{}` is no request: {expected}", request.escaped())]
    Syntax {
        /// What was asked for.
        request: String,
        /// What should stand there.
        expected: &'static str,
        /// Where in the request.
        place: Range<usize>,
    },
    /// A packed form that is a function of its own.
    #[error("`packed({part})` is the function `{own}`")]
    PackedName {
        /// What was to be packed.
        part: String,
        /// How that is asked for.
        own: String,
        /// Where in the request.
        place: Range<usize>,
    },
    /// A function of a frame, of none.
    #[error(
        "`{name}` is of a frame; expected `{name}(FRAME)`{}",
        if *is_sin_cos { ", of a frame of that name `(\"sin_cos\")`" } else { "" }
    )]
    FrameMissing {
        /// The function.
        name: String,
        /// Whether `(sin_cos)` stands behind the request, which names no frame.
        is_sin_cos: bool,
        /// Where in the request.
        place: Range<usize>,
    },
    /// A function of the whole system, of something.
    #[error(
        "`{name}` is of the whole system; expected nothing in brackets after it, or `(sin_cos)`{}",
        of_frame(name)
    )]
    FrameNotTaken {
        /// The function.
        name: String,
        /// Where in the request.
        place: Range<usize>,
    },
    /// What stands behind the frame is not understood.
    #[error("`{}` behind the frame of `{name}`: {expected}{seen}", found.escaped())]
    View {
        /// The function.
        name: String,
        /// What was found.
        found: String,
        /// What should stand there.
        expected: &'static str,
        /// What gives what is seen from another frame; empty where that is not meant.
        seen: &'static str,
        /// Where in the request.
        place: Range<usize>,
    },
    /// A frame that the model lacks.
    #[error("`{}` is no frame of the model; {advice}", name.escaped())]
    UnknownFrame {
        /// What was asked for.
        request: String,
        /// The frame.
        name: String,
        /// What was probably meant, or which frames there are.
        advice: String,
        /// Where in the request.
        place: Range<usize>,
    },
    /// What cannot be differentiated.
    #[error("`{}` {why}, and cannot be differentiated", part.escaped())]
    NoDerivative {
        /// The part of the request.
        part: String,
        /// What it is.
        why: &'static str,
        /// Where in the request.
        place: Range<usize>,
    },
    /// A variable that the function is not given.
    #[error(
        "`{name}` is not given `{variable}`; it can be differentiated by {}values set at run time",
        if known.is_empty() { String::new() } else { format!("{}, and by ", names(known)) }
    )]
    VariableNotTaken {
        /// The function.
        name: String,
        /// The variable.
        variable: &'static str,
        /// By what it can be differentiated.
        known: Vec<String>,
        /// Where in the request.
        place: Range<usize>,
    },
    /// What is no variable.
    #[error("`{}` is no variable of `{function}`; {} be differentiated by {}", name.escaped(), variables(function, name, known, *entry_of), names(known))]
    UnknownVariable {
        /// What was asked for.
        request: String,
        /// The function.
        function: &'static str,
        /// What was found.
        name: String,
        /// The variable of which it is an entry.
        entry_of: Option<&'static str>,
        /// By what the function can be differentiated.
        known: Vec<String>,
        /// Where in the request.
        place: Range<usize>,
    },
    /// One value set at run time as a direction, which only all are.
    #[error("`{}` alone is no direction; expected `parameters`, of which it is one", name.escaped())]
    OneOfDirection {
        /// What was asked for.
        request: String,
        /// The value.
        name: String,
        /// Where in the request.
        place: Range<usize>,
    },
    /// Two functions of one name.
    #[error("`{first}` and `{second}` would both be called `{name}` in generated code")]
    SameName {
        /// The one request.
        first: String,
        /// The other one.
        second: String,
        /// The name of both.
        name: String,
    },
    /// Two outputs of one name, in one function.
    #[error(
        "two outputs of `{request}` would be called `{name}` in generated code; ask for them in two functions"
    )]
    SameOutput {
        /// What was asked for.
        request: String,
        /// The name of both.
        name: String,
    },
    /// Two constants of one name.
    #[error("`{}` and `{}` would both have the constant `{name}` in generated code; rename one of the frames or values that they name", of[0], of[1])]
    SameConstant {
        /// What was asked for.
        requests: [String; 2],
        /// What the constants are of.
        of: [String; 2],
        /// The name of both.
        name: String,
    },
}

impl RequestError {
    pub(in crate::functions) fn syntax(request: &str, unexpected: Unexpected) -> Self {
        let Unexpected { expected, place } = unexpected;
        Self::Syntax {
            request: request.to_owned(),
            expected,
            place,
        }
    }

    /// Where in the request it is, in bytes; `None` where it is about all of it.
    pub fn place(&self) -> Option<Range<usize>> {
        match self {
            Self::Name { place, .. }
            | Self::Syntax { place, .. }
            | Self::PackedName { place, .. }
            | Self::FrameMissing { place, .. }
            | Self::FrameNotTaken { place, .. }
            | Self::View { place, .. }
            | Self::UnknownFrame { place, .. }
            | Self::NoDerivative { place, .. }
            | Self::VariableNotTaken { place, .. }
            | Self::UnknownVariable { place, .. }
            | Self::OneOfDirection { place, .. } => Some(place.clone()),
            Self::Unknown { .. }
            | Self::Repeated { .. }
            | Self::Compact { .. }
            | Self::OwnArguments { .. }
            | Self::SameName { .. }
            | Self::SameOutput { .. }
            | Self::SameConstant { .. } => None,
        }
    }
}

/// The most names that are listed.
const MOST_LISTED: usize = 20;

/// What to do about a name that is no variable, and how the list of variables begins.
fn variables(function: &str, name: &str, known: &[String], entry_of: Option<&str>) -> String {
    let advice = match entry_of {
        Some(whole) => format!("it is an entry of `{whole}`"),
        None => advice_on_variable(function, name, known),
    };
    let next = if advice.ends_with('?') {
        " It can"
    } else {
        "; it can"
    };
    advice + next
}

/// The first of them.
pub(super) fn names<S: AsRef<str>>(known: &[S]) -> String {
    let names = known.iter().take(MOST_LISTED);
    let names: Vec<String> = names
        .map(|name| format!("`{}`", name.as_ref().escaped()))
        .collect();
    if names.is_empty() {
        "nothing".to_owned()
    } else {
        names.join(", ")
    }
}

/// All of what is found, or all that is wrong.
pub(in crate::functions) fn all_or_faults<T>(
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

/// What is like a function of the system, of a single frame.
fn of_frame(name: &str) -> String {
    let of_frame = match name {
        "rotation" | "origin_position" | "mass_center_position" => "pose",
        "angular_velocity" | "origin_velocity" | "mass_center_velocity" => "velocity",
        "angular_acceleration" | "mass_center_acceleration" => "acceleration",
        "partial_angular_velocity" | "partial_velocity_origin" | "partial_velocity" => "jacobian",
        _ => return String::new(),
    };
    format!("; of a frame it is `{of_frame}(FRAME)`")
}

/// Variables, none of which is part of another.
pub(in crate::functions) fn each_once(
    request: &str,
    by: Vec<Variable>,
) -> Result<Vec<Variable>, Vec<RequestError>> {
    let has_all = by.contains(&Variable::Parameters);
    let again = by.iter().filter(|_| has_all).find_map(|own| match own {
        Variable::Parameter { name, .. } => Some(name.clone()),
        Variable::Given(_) | Variable::Parameters => None,
    });
    match again {
        None => Ok(by),
        Some(name) => Err(vec![RequestError::Repeated {
            request: request.to_owned(),
            name,
        }]),
    }
}
