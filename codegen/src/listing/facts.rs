//! What is known of a system and its module, beside the functions.

use super::{Chart, Extent, Frame, Joint, Limits, Size, Sizes};
use crate::{
    functions::{Block, Declared, PACKED_LEN},
    id::BodyId,
    origin::Origin,
    passes::sines,
    tree::{Parameter, Tree},
};

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
    /// The row and column of each entry of a packed mass matrix, where a function writes one.
    pub packed: Option<Vec<[usize; 2]>>,
    /// The patterns of compact outputs, each once.
    pub patterns: Vec<Pattern>,
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
    pub entries: Vec<Block>,
}

/// Of which functions some are in a module.
#[derive(Clone, Debug, Default)]
pub(super) struct Wanted {
    /// Some are given sines and cosines.
    pub(super) angles: bool,
    /// Some write a packed mass matrix.
    pub(super) packed: bool,
    /// What those with compact outputs write, each once.
    pub(super) patterns: Vec<Pattern>,
}

impl Facts {
    pub(super) fn of(tree: &Tree, origin: Origin, fields: &[String], wanted: Wanted) -> Self {
        let coordinates = tree.coordinate_names();
        let angles = wanted.angles.then(|| angles(tree, &coordinates));
        let packed = wanted.packed.then(|| Vec::from_iter(tree.coupled_speeds()));
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
            sizes: sizes(
                tree,
                angles.as_ref().map(Vec::len),
                packed.as_ref().map(Vec::len),
                &wanted.patterns,
            ),
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
            patterns: wanted.patterns,
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
        joints.any(|joint| joint.chart == Chart::EulerParameters)
    }
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

fn sizes(
    tree: &Tree,
    n_angles: Option<usize>,
    n_packed: Option<usize>,
    patterns: &[Pattern],
) -> Sizes {
    let size = |name: &str, value, brief, more: &str| Size {
        name: name.to_owned(),
        value,
        doc: format!("{brief}{more}."),
        brief,
    };
    let mut sizes = vec![
        size("NB", tree.bodies.len(), "Number of bodies", ""),
        size(
            "NQ",
            tree.n_coordinates,
            "Number of generalized coordinates",
            ", the length of `q`",
        ),
        size(
            "NU",
            tree.n_speeds,
            "Number of generalized speeds",
            ", the length of `u`",
        ),
    ];
    let angles = "Number of angles among the coordinates";
    sizes.extend(n_angles.map(|n_angles| size("NA", n_angles, angles, "")));
    sizes.extend(n_packed.map(|n_packed| Size {
        name: PACKED_LEN.to_owned(),
        value: n_packed,
        doc: "Number of entries that `mass_matrix_packed` writes.".to_owned(),
        brief: "Number of entries of a packed mass matrix",
    }));
    sizes.extend(patterns.iter().map(|pattern| Size {
        name: pattern.columns.clone(),
        value: pattern.n_columns,
        doc: format!("Number of columns that `{}` writes.", pattern.function),
        brief: "Number of columns",
    }));
    Sizes(sizes)
}
