//! Which speeds move the frames that functions are of.

use std::collections::BTreeSet;

use crate::{compile::Emittable, diagnostic::Escaped, functions::Part, id::SpeedId, tree::Tree};

/// The speeds that move a frame as it is seen: all other columns of its Jacobian are zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameSpeeds {
    /// The name of the constant that says which.
    pub constant: String,
    /// The name of the constant that says how many.
    pub length: String,
    /// What that says.
    pub doc: String,
    /// Their places in `u`, in order.
    pub speeds: Vec<usize>,
}

impl FrameSpeeds {
    /// Those that the functions speak of, each once.
    pub(in crate::listing) fn of(tree: &Tree, functions: &[Emittable]) -> Vec<Self> {
        let mut known = BTreeSet::new();
        let parts = functions.iter().flat_map(|one| one.request.parts());
        let own = |part: &Part| {
            let subject = part
                .subject
                .as_ref()
                .filter(|_| part.function.has_frame_speeds())?;
            let frames: Vec<String> = subject
                .frames
                .iter()
                .map(|frame| format!("`{}`", frame.name.escaped()))
                .collect();
            let speeds = subject.speeds(tree).into_iter();
            Some(Self {
                constant: part.speeds_constant(),
                length: part.speeds_len_constant(),
                doc: format!(
                    "The speeds that move the frame {}, as places in `u`: the other columns of its Jacobian are zero.",
                    frames.join(" as it is seen from ")
                ),
                speeds: speeds.map(SpeedId::index).collect(),
            })
        };
        let all = parts.filter_map(own);
        all.filter(|one| known.insert(one.constant.clone()))
            .collect()
    }
}
