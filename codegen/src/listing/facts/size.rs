//! Lengths of arrays that have names.

use super::{
    base_parameters::BaseParameters, entries::PackedEntries, frame_speeds::FrameSpeeds,
    pattern::Pattern,
};
use crate::{
    functions::{Dimension, Length, N_BASE_PARAMETERS, N_PARAMETERS, Packed},
    tree::Tree,
};

/// The size that counts the angles among the coordinates.
pub(crate) const N_ANGLES: &str = "NA";

/// A size with a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Size {
    /// The name: `NQ`.
    pub name: String,
    /// The size.
    pub value: usize,
    /// What it is, beside the functions that have it.
    pub doc: String,
    /// What it is, where these are not in sight.
    pub brief: &'static str,
}

impl Size {
    /// One of which all is said in a few words.
    fn said(name: &str, value: usize, brief: &'static str) -> Self {
        Self {
            name: name.to_owned(),
            value,
            doc: format!("{brief}."),
            brief,
        }
    }
}

/// The sizes of a module.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sizes(pub Vec<Size>);

impl Sizes {
    /// The size with this name.
    pub fn named(&self, name: &str) -> Option<&Size> {
        self.0.iter().find(|size| size.name == name)
    }

    /// The number of elements of an array of this length.
    ///
    /// # Panics
    /// Where no size has the name: signatures and sizes are made from the same functions.
    pub fn length(&self, length: &Length) -> usize {
        let value = |name: &str| {
            let size = self.named(name);
            size.unwrap_or_else(|| unreachable!("listing: no size `{name}`"))
                .value
        };
        match length {
            Length::Number(number) => *number,
            Length::Constant(name) => value(name),
            Length::Twice(name) => 2 * value(name),
        }
    }
}

/// What arrays of every system count, in words, and what else is said of it beside the functions.
const COUNTED: [(Dimension, &str, &str); 3] = [
    (Dimension::Bodies, "Number of bodies", ""),
    (
        Dimension::Coordinates,
        "Number of generalized coordinates",
        ", the length of `q`",
    ),
    (
        Dimension::Speeds,
        "Number of generalized speeds",
        ", the length of `u`",
    ),
];

/// Those of every system.
pub(super) fn of_system(tree: &Tree) -> Vec<Size> {
    let counted = COUNTED.into_iter().filter_map(|(axis, brief, more)| {
        Some(Size {
            name: axis.constant()?.to_owned(),
            value: axis.length(tree)?,
            doc: format!("{brief}{more}."),
            brief,
        })
    });
    counted.collect()
}

/// How many angles are among the coordinates, where functions are given their sines and cosines.
pub(super) fn of_angles(n_angles: Option<usize>) -> Vec<Size> {
    let brief = "Number of angles among the coordinates";
    n_angles
        .map(|n| Size::said(N_ANGLES, n, brief))
        .into_iter()
        .collect()
}

/// How many entries each of these packed matrices has.
pub(super) fn of_packed(packed: &[(Packed, Vec<[usize; 2]>)]) -> Vec<Size> {
    let sizes = packed.iter().map(|(packed, places)| Size {
        name: packed.length_constant().to_owned(),
        value: places.len(),
        doc: format!("Number of entries that `{}` writes.", packed.function()),
        brief: packed.brief(),
    });
    sizes.collect()
}

/// How many base parameters there are, where a function writes them or their columns.
pub(super) fn of_base_parameters(base: Option<&BaseParameters>) -> Vec<Size> {
    let brief = "Number of base parameters";
    base.map(|base| Size::said(N_BASE_PARAMETERS, base.texts.len(), brief))
        .into_iter()
        .collect()
}

/// How many values are set at run time, where that is of use.
pub(super) fn of_values(n_values: Option<usize>) -> Vec<Size> {
    let brief = "Number of values set at run time";
    n_values
        .map(|n| Size::said(N_PARAMETERS, n, brief))
        .into_iter()
        .collect()
}

/// How many speeds move each frame.
pub(super) fn of_frames(frames: &[FrameSpeeds]) -> Vec<Size> {
    let sizes = frames.iter().map(|frame| Size {
        name: frame.length.clone(),
        value: frame.speeds.len(),
        doc: "Number of speeds that move the frame.".to_owned(),
        brief: "Number of speeds that move a frame",
    });
    sizes.collect()
}

/// How many entries each packed derivative has, and how many columns where these have colours.
pub(super) fn of_entries(entries: &[PackedEntries]) -> Vec<Size> {
    let sizes = entries.iter().flat_map(|entries| {
        let own = Size {
            name: entries.length.clone(),
            value: entries.places.len(),
            doc: format!("Number of entries that `{}` writes.", entries.of),
            brief: "Number of entries of a packed derivative",
        };
        let columns = entries.colors.iter().map(|colors| Size {
            name: colors.length.clone(),
            value: colors.colors.len(),
            doc: format!("Number of columns of `{}`.", entries.of),
            brief: "Number of columns of a packed derivative",
        });
        [own].into_iter().chain(columns)
    });
    sizes.collect()
}

/// How many columns each compact output has.
pub(super) fn of_patterns(patterns: &[Pattern]) -> Vec<Size> {
    let sizes = patterns.iter().map(|pattern| Size {
        name: pattern.columns.clone(),
        value: pattern.n_columns,
        doc: format!("Number of columns that `{}` writes.", pattern.function),
        brief: "Number of columns",
    });
    sizes.collect()
}
