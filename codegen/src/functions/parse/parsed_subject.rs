//! Frames that a request names, and how they are seen: of any model, then on its tree.

use super::{
    request_error::{RequestError, all_or_faults},
    syntax::{LOCAL, Word},
    unknown_frame,
};
use crate::{
    diagnostic::NearNames,
    functions::{
        function::Function,
        subject::{Subject, SubjectFrame, View},
    },
    tree::Tree,
};

/// Frames that are named, before it is known whether the model has them.
#[derive(Clone, Debug)]
pub(in crate::functions) struct ParsedSubject {
    frames: Vec<Word>,
    pub(in crate::functions) view: View,
}

/// What may stand behind the frame of most functions.
const VIEW: &str = "expected `local`, for the frame's own axes";

/// What gives what such a function would be, seen from another frame.
fn from_another(function: &Function) -> &'static str {
    match function.name {
        "velocity" => "; seen from another frame it is `jacobian(F, G)` times `u`",
        "acceleration" => {
            "; seen from another frame it is `jacobian(F, G)` times `u_dot`, and `jvp(jacobian(F, G); q)`, with `u` for `q_direction`, times `u`"
        }
        "jacobian_dot_u" => {
            "; seen from another frame it is `jvp(jacobian(F, G); q)`, with `u` for `q_direction`, times `u`"
        }
        "generalized_force" => {
            "; of a wrench between two frames it is `jacobian(F, G)`, transposed, times the wrench"
        }
        _ => "",
    }
}

/// What several frames may be meant for.
const SEVERAL: &str = "expected no more than one frame, from which the motion is seen; functions of several frames are joined, \
    as `jacobian(F)+jacobian(G)`";

impl ParsedSubject {
    /// A frame, and what is said behind it of how it is seen.
    pub(in crate::functions) fn new(
        function: &Function,
        frame: &Word,
        rest: &[Word],
        views: &[View],
    ) -> Result<Self, RequestError> {
        let fault_seen = |word: &Word, expected, seen| {
            Err(RequestError::View {
                name: function.name.to_owned(),
                found: word.text.clone(),
                expected,
                seen,
                place: word.place.clone(),
            })
        };
        let fault = |word, expected| fault_seen(word, expected, "");
        let (has_local, has_other) = (views.contains(&View::Local), views.contains(&View::Other));
        let (frames, view) = match rest {
            [] => (vec![frame], View::Inertial),
            [word] if has_local && word.is(LOCAL) => (vec![frame], View::Local),
            [word] if has_other && word.is(LOCAL) => return fault(word, "expected another frame"),
            [other] if has_other => (vec![frame, other], View::Other),
            [word, ..] if views.len() == 1 => return fault(word, "expected nothing there"),
            [word] => return fault_seen(word, VIEW, from_another(function)),
            [_, word, ..] if has_other => return fault(word, SEVERAL),
            [_, word, ..] => return fault(word, "expected no more than `local`"),
        };
        let frames = frames.into_iter().cloned().collect();
        Ok(Self { frames, view })
    }

    /// Frames, and at the end perhaps that their own axes are meant.
    pub(in crate::functions) fn of_several(
        text: &str,
        words: &[Word],
        views: &[View],
    ) -> Result<Self, RequestError> {
        let has_local = views.contains(&View::Local);
        let (frames, view) = match words {
            [frames @ .., last] if has_local && last.is(LOCAL) && !frames.is_empty() => {
                (frames, View::Local)
            }
            frames => (frames, View::Inertial),
        };
        // Its matrix would be singular.
        let is_again = |at: &usize| frames[..*at].iter().any(|own| own.text == frames[*at].text);
        if let Some(again) = (0..frames.len()).find(is_again) {
            return Err(RequestError::Repeated {
                request: text.to_owned(),
                name: frames[again].text.clone(),
            });
        }
        Ok(Self {
            frames: frames.to_vec(),
            view,
        })
    }

    pub(in crate::functions) fn names(&self) -> impl Iterator<Item = &str> {
        self.frames.iter().map(|frame| frame.text.as_str())
    }

    pub(in crate::functions) fn on(
        &self,
        text: &str,
        tree: Option<&Tree>,
        near: &mut NearNames,
    ) -> Result<Subject, Vec<RequestError>> {
        let mut found = |word: &Word| {
            let frame = tree.and_then(|tree| SubjectFrame::find(tree, &word.text));
            frame.ok_or_else(|| {
                vec![RequestError::UnknownFrame {
                    request: text.to_owned(),
                    name: word.text.clone(),
                    advice: unknown_frame::advice(tree, &word.text, near),
                    place: word.place.clone(),
                }]
            })
        };
        let frames = all_or_faults(self.frames.iter().map(&mut found))?;
        Ok(Subject::new(tree, frames, self.view))
    }
}
