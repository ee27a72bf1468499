//! What is known of a system and its module, beside the functions.

use std::collections::BTreeSet;

use crate::{
    functions::{CompactBlock, Declared, Dimension, N_BASE_PARAMETERS, N_PARAMETERS, Packed},
    id::{BodyId, SpeedId},
    origin::Origin,
    passes::sines,
    solve,
    tree::{Parameter, Tree},
};

mod base_parameters;
mod entries;
mod extent;
mod frame_speeds;
mod joint;
mod limits;
mod size;
mod stated;

pub use base_parameters::{BaseParameters, BaseTerm};
pub use entries::{Colors, Entries};
pub use extent::Extent;
pub use frame_speeds::FrameSpeeds;
pub use joint::{Frame, Joint, JointChart};
pub use limits::Limits;
pub(crate) use size::N_ANGLES;
pub use size::{Size, Sizes};
pub use stated::{Counted, nominal, read_nominal};

/// The facts of a module.
#[derive(Clone, Debug)]
pub struct Facts {
    /// Where it comes from.
    pub origin: Origin,
    /// The system's name.
    pub name: String,
    /// All sizes: of the system, then of what the functions write.
    pub sizes: Sizes,
    /// The bodies; a lower body comes before those above it.
    pub bodies: Vec<Body>,
    /// The coordinates' names, in the order of `q`.
    pub coordinates: Vec<String>,
    /// The speeds' names, in the order of `u`.
    pub speeds: Vec<String>,
    /// The body that each speed moves, by its place.
    pub speed_bodies: Vec<usize>,
    /// The joint of each body.
    pub joints: Vec<Joint>,
    /// Frames that are fixed in bodies.
    pub frames: Vec<Frame>,
    /// Limits and friction.
    pub limits: Limits,
    /// What is set at run time, with nominal values.
    pub parameters: Vec<Parameter>,
    /// The names of what is prepared from these, sorted.
    pub fields: Vec<String>,
    /// The angles among the coordinates, where functions are given their sines and cosines.
    pub angles: Option<Vec<Angle>>,
    /// The row and column of each entry of the packed matrices that functions write.
    pub packed: Vec<(Packed, Vec<[usize; 2]>)>,
    /// The speeds in the order of their elimination, where a function writes factors of a mass matrix.
    pub elimination: Option<Vec<usize>>,
    /// The base parameters, where a function writes their columns.
    pub base_parameters: Option<BaseParameters>,
    /// For every speed whether its acceleration is prescribed, where a function asks.
    pub prescribed: Option<Vec<bool>>,
    /// The patterns of compact outputs, each once.
    pub patterns: Vec<Pattern>,
    /// The speeds that move frames, each frame's once.
    pub frame_speeds: Vec<FrameSpeeds>,
    /// The entries of packed derivatives, each once.
    pub entries: Vec<Entries>,
}

/// A body of the system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Body {
    /// Its name, as the user wrote it.
    pub name: String,
    /// What stands for it in names.
    pub identifier: String,
    /// Its lower body (parent), by its place; `None` is the inertial frame.
    pub lower: Option<usize>,
}

/// An angle among the coordinates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Angle {
    /// The coordinate's name.
    pub name: String,
    /// Its place in `q`.
    pub coordinate: usize,
}

/// Which columns of a whole a compact output has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// The function that writes it.
    pub function: &'static str,
    /// The name of the constant that says how many columns there are.
    pub columns: String,
    /// The name of the constant that says which.
    pub blocks: String,
    /// What that says.
    pub doc: String,
    /// How many columns there are.
    pub n_columns: usize,
    /// The non-zero partitions, body after body.
    pub entries: Vec<CompactBlock>,
}

/// Of which functions some are in a module.
#[derive(Clone, Debug, Default)]
pub(super) struct Wanted {
    /// Some are given sines and cosines.
    pub(super) angles: bool,
    /// The packed matrices that some write, each once.
    pub(super) packed: BTreeSet<Packed>,
    /// The base parameters, where some function writes their columns.
    pub(super) base_parameters: Option<BaseParameters>,
    /// Some ask which speeds are prescribed.
    pub(super) prescribed: bool,
    /// Values are set at run time, or some function is differentiated by all of them.
    pub(super) values: bool,
    /// What those with compact outputs write, each once.
    pub(super) patterns: Vec<Pattern>,
    /// The speeds that move the frames of Jacobians, each frame's once.
    pub(super) frame_speeds: Vec<FrameSpeeds>,
    /// The entries of packed derivatives, each once.
    pub(super) entries: Vec<Entries>,
}

impl Facts {
    pub(super) fn of(tree: &Tree, origin: Origin, fields: &[String], wanted: Wanted) -> Self {
        let coordinates = tree.coordinate_names();
        let angles = wanted.angles.then(|| angles(tree, &coordinates));
        let elimination = wanted.packed.contains(&Packed::Factors);
        let elimination = elimination.then(|| solve::elimination(tree));
        let packed = wanted.packed.iter().copied();
        let packed = packed.map(|packed| (packed, packed.places(tree)));
        let packed: Vec<_> = packed.collect();
        let bodies = tree.body_ids().map(|id| Body {
            name: tree.body(id).name.clone(),
            identifier: tree.body(id).identifier.clone(),
            lower: tree.lower(id).map(BodyId::index),
        });
        let speed_bodies = tree.speed_bodies().into_iter();
        let mut fields = fields.to_vec();
        fields.sort();
        Self {
            origin,
            name: tree.name.clone(),
            sizes: sizes(tree, angles.as_ref().map(Vec::len), &packed, &wanted),
            bodies: bodies.collect(),
            coordinates,
            speeds: tree.speed_names(),
            speed_bodies: speed_bodies.map(BodyId::index).collect(),
            joints: tree
                .bodies
                .iter()
                .map(|body| Joint::of(&body.joint))
                .collect(),
            frames: tree.frames.iter().map(Frame::of).collect(),
            limits: Limits::of(tree),
            parameters: tree.parameters.clone(),
            fields,
            angles,
            packed,
            elimination,
            base_parameters: wanted.base_parameters,
            prescribed: wanted.prescribed.then(|| prescribed(tree)),
            patterns: wanted.patterns,
            frame_speeds: wanted.frame_speeds,
            entries: wanted.entries,
        }
    }

    /// What an argument holds.
    pub fn extent(&self, argument: &Declared) -> Extent {
        let (n_parameters, n_fields) = (self.parameters.len(), self.fields.len());
        Extent::of(argument, &self.sizes, n_parameters, n_fields)
    }

    /// True where `q` holds quaternions, which a function normalizes.
    pub fn has_quaternions(&self) -> bool {
        let mut joints = self.joints.iter();
        joints.any(|joint| joint.chart == JointChart::EulerParameters)
    }
}

fn prescribed(tree: &Tree) -> Vec<bool> {
    let speeds = (0..tree.n_speeds).map(SpeedId::new);
    speeds
        .map(|speed| tree.prescribed.contains(&speed))
        .collect()
}

fn angles(tree: &Tree, coordinates: &[String]) -> Vec<Angle> {
    let angles = sines::angles(tree).into_iter();
    let angles = angles.map(|angle| angle.coordinate.index());
    angles
        .map(|coordinate| Angle {
            name: coordinates[coordinate].clone(),
            coordinate,
        })
        .collect()
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

fn sizes(
    tree: &Tree,
    n_angles: Option<usize>,
    packed: &[(Packed, Vec<[usize; 2]>)],
    wanted: &Wanted,
) -> Sizes {
    let counted = COUNTED.into_iter().filter_map(|(axis, brief, more)| {
        Some(Size {
            name: axis.constant()?.to_owned(),
            value: axis.length(tree)?,
            doc: format!("{brief}{more}."),
            brief,
        })
    });
    let mut sizes: Vec<Size> = counted.collect();
    sizes.extend(n_angles.map(|n_angles| Size {
        name: N_ANGLES.to_owned(),
        value: n_angles,
        doc: "Number of angles among the coordinates.".to_owned(),
        brief: "Number of angles among the coordinates",
    }));
    sizes.extend(packed.iter().map(|(packed, places)| Size {
        name: packed.length_constant().to_owned(),
        value: places.len(),
        doc: format!("Number of entries that `{}` writes.", packed.function()),
        brief: packed.brief(),
    }));
    sizes.extend(wanted.base_parameters.iter().map(|base| Size {
        name: N_BASE_PARAMETERS.to_owned(),
        value: base.texts.len(),
        doc: "Number of base parameters.".to_owned(),
        brief: "Number of base parameters",
    }));
    sizes.extend(wanted.values.then(|| Size {
        name: N_PARAMETERS.to_owned(),
        value: tree.parameters.len(),
        doc: "Number of values set at run time.".to_owned(),
        brief: "Number of values set at run time",
    }));
    sizes.extend(wanted.frame_speeds.iter().map(|frame| Size {
        name: frame.length.clone(),
        value: frame.speeds.len(),
        doc: "Number of speeds that move the frame.".to_owned(),
        brief: "Number of speeds that move a frame",
    }));
    sizes.extend(wanted.entries.iter().flat_map(entry_sizes));
    sizes.extend(wanted.patterns.iter().map(|pattern| Size {
        name: pattern.columns.clone(),
        value: pattern.n_columns,
        doc: format!("Number of columns that `{}` writes.", pattern.function),
        brief: "Number of columns",
    }));
    Sizes(sizes)
}

/// How many entries a packed derivative has, and how many columns where these have colours.
fn entry_sizes(entries: &Entries) -> Vec<Size> {
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
    [own].into_iter().chain(columns).collect()
}
