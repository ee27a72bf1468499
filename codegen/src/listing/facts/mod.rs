//! What is known of a system and its module, beside the functions.

use std::collections::BTreeSet;

use crate::{
    compile::Compiled,
    functions::{Declared, Packed, Request},
    id::{BodyId, SpeedId},
    origin::Origin,
    solve,
    tree::{self, Parameter, Tree},
};

mod base_parameters;
mod entries;
mod extent;
mod frame;
mod frame_speeds;
mod joint;
mod limits;
mod pattern;
mod size;
mod stated;
pub(super) mod units;

pub use base_parameters::{BaseParameters, BaseTerm};
pub use entries::{Colors, PackedEntries};
pub use extent::Extent;
pub use frame::{Frame, Moved, Turned};
pub use frame_speeds::FrameSpeeds;
pub use joint::{Joint, JointChart, Mimic};
pub use limits::Limits;
pub use pattern::Pattern;
pub(crate) use size::N_ANGLES;
pub use size::{Size, Sizes};
pub use stated::{Counted, nominal, read_nominal};
pub use units::Units;

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
    /// The units of coordinates, speeds and forces.
    pub units: Units,
    /// Frames of bodies that are fixed to others.
    pub frames: Vec<Frame>,
    /// Frames that only mark places.
    pub markers: Vec<Frame>,
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
    pub entries: Vec<PackedEntries>,
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

impl Facts {
    /// Those of a tree, and what its functions ask for.
    pub(super) fn of(tree: &Tree, origin: Origin, compiled: &Compiled) -> Self {
        let functions = &compiled.functions[..];
        let any = |is: fn(&Request) -> bool| functions.iter().any(|one| is(&one.request));
        let coordinates = tree.coordinate_names();
        let angles = any(Request::is_at_sin_cos).then(|| angles(tree, &coordinates));
        let has_values = any(Request::is_by_parameters) || !tree.parameters.is_empty();
        let written = functions.iter().flat_map(|one| one.request.packed());
        let written: BTreeSet<Packed> = written.collect();
        let elimination = written.contains(&Packed::Factors);
        let packed = written.into_iter();
        let packed: Vec<_> = packed.map(|packed| (packed, packed.places(tree))).collect();
        let base_parameters = BaseParameters::of(tree, functions);
        let frame_speeds = FrameSpeeds::of(tree, functions);
        let entries = PackedEntries::of(tree, functions);
        let patterns = Pattern::of(functions);
        let sizes = [
            size::of_system(tree),
            size::of_angles(angles.as_deref().map(<[_]>::len)),
            size::of_packed(&packed),
            size::of_base_parameters(base_parameters.as_ref()),
            size::of_values(has_values.then_some(tree.parameters.len())),
            size::of_frames(&frame_speeds),
            size::of_entries(&entries),
            size::of_patterns(&patterns),
        ];
        let mut fields = compiled.fields.clone();
        fields.sort();
        let joints: Vec<Joint> = tree.body_ids().map(|id| Joint::of(tree, id)).collect();
        let frames = |own: &[tree::Frame]| own.iter().map(|one| Frame::of(tree, one)).collect();
        Self {
            origin,
            name: tree.name.clone(),
            sizes: Sizes(sizes.concat()),
            bodies: bodies(tree),
            coordinates,
            speeds: tree.speed_names(),
            speed_bodies: tree.speed_bodies().into_iter().map(BodyId::index).collect(),
            units: Units::of(&joints, tree.n_coordinates, tree.n_speeds),
            joints,
            frames: frames(&tree.frames),
            markers: frames(&tree.markers),
            limits: Limits::of(tree),
            parameters: tree.parameters.clone(),
            fields,
            angles,
            packed,
            elimination: elimination.then(|| solve::elimination(tree)),
            base_parameters,
            prescribed: any(Request::prescribes).then(|| prescribed(tree)),
            patterns,
            frame_speeds,
            entries,
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

fn bodies(tree: &Tree) -> Vec<Body> {
    let bodies = tree.body_ids().map(|id| Body {
        name: tree.body(id).name.clone(),
        identifier: tree.body(id).identifier.clone(),
        lower: tree.lower(id).map(BodyId::index),
    });
    bodies.collect()
}

fn prescribed(tree: &Tree) -> Vec<bool> {
    let speeds = (0..tree.n_speeds).map(SpeedId::new);
    speeds
        .map(|speed| tree.prescribed.contains(&speed))
        .collect()
}

fn angles(tree: &Tree, coordinates: &[String]) -> Vec<Angle> {
    let angles = tree.angles().into_iter();
    let angles = angles.map(|angle| angle.coordinate.index());
    angles
        .map(|coordinate| Angle {
            name: coordinates[coordinate].clone(),
            coordinate,
        })
        .collect()
}
