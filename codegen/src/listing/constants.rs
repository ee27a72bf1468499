//! The constants of a module: their names, what they mean, what they hold. Printers write them in this order; what compares
//! committed modules finds them by the same names.

use std::borrow::Cow;

use super::{
    BaseTerm, Facts, Frame, Function, Joint, N_ANGLES, PackedEntries, Pattern, Size,
    facts::units::by_place,
};
use crate::functions::{
    CompactBlock, ELIMINATION, N_BASE_PARAMETERS, N_BODIES, N_COORDINATES, N_PARAMETERS, N_SPEEDS,
    PARAMETER_NAMES, PRESCRIBED,
};

/// The system's name.
pub(crate) const NAME: &str = "NAME";
/// The lower body of each body.
pub(crate) const LOWER_BODIES: &str = "LOWER_BODIES";
/// The bodies' names.
pub(crate) const BODY_NAMES: &str = "BODY_NAMES";
/// The coordinates' names.
pub(crate) const COORDINATE_NAMES: &str = "COORDINATE_NAMES";
/// The speeds' names.
pub(crate) const SPEED_NAMES: &str = "SPEED_NAMES";
/// Where coordinates and speeds of joints stand.
pub(crate) const JOINTS: &str = "JOINTS";
/// Frames that are fixed in bodies.
pub(crate) const FRAMES: &str = "FRAMES";
/// Combinations of inertial parameters, as text.
pub(crate) const BASE_PARAMETERS: &str = "BASE_PARAMETERS";
/// What they are made of.
pub(crate) const BASE_PARAMETER_TERMS: &str = "BASE_PARAMETER_TERMS";
/// Hash of the model.
pub(crate) const FINGERPRINT: &str = "FINGERPRINT";
/// What functions cost.
pub(crate) const OPERATIONS: &str = "OPERATIONS";

/// A constant.
#[derive(Clone, Debug)]
pub struct Constant<'a> {
    /// Its name.
    pub name: &'a str,
    /// What it means.
    pub doc: Cow<'a, str>,
    /// What it holds.
    pub data: Data<'a>,
}

/// What a constant holds; lists with the name of their length, where it has one.
#[derive(Clone, Debug)]
pub enum Data<'a> {
    /// A size.
    Size(usize),
    /// A hash.
    Hash(u64),
    /// A name.
    Text(&'a str),
    /// Names.
    Texts(&'static str, Vec<&'a str>),
    /// For each whether something is true.
    Truths(&'static str, &'a [bool]),
    /// Whole numbers.
    Integers(&'a str, Vec<usize>),
    /// Numbers; some may be infinite.
    Numbers(&'static str, &'a [f64]),
    /// Rows and columns.
    Places(&'a str, &'a [[usize; 2]]),
    /// Joints.
    Joints(&'static str, &'a [Joint]),
    /// Frames.
    Frames(&'a [Frame]),
    /// Terms of base parameters.
    Terms(&'a [BaseTerm]),
    /// Non-zero partitions.
    Blocks(&'a [CompactBlock]),
    /// Functions with their operations.
    Costs(Vec<&'a Function>),
}

/// What names of coordinates mean that end in a letter and a number.
pub(crate) const COORDINATES: &str = "theta in rad, about the x, y, z of the joint's axes, body-fixed in the order 1-2-3; e of a unit quaternion, scalar first, from the body's axes to the lower body's; s in m, along the joint's axes in the lower body.";

/// The same of speeds.
pub(crate) const SPEEDS: &str = "w is a component of the angular velocity relative to the lower body, along the joint's axes as they move with the body: the body's own, if the joint has none.";

impl Facts {
    /// The constants of every module, but for its hash and costs.
    pub fn constants(&self) -> Vec<Constant<'_>> {
        let sizes = [N_BODIES, N_COORDINATES, N_SPEEDS].into_iter();
        let sizes = sizes.filter_map(|name| self.sizes.named(name));
        let mut constants: Vec<Constant<'_>> = sizes.map(size).collect();
        constants.extend(self.tree());
        constants.extend(self.limits());
        constants
    }

    /// All constants whose names and places other languages have, in one list; those of prescribed motions apart.
    pub fn all_constants(&self) -> Vec<Constant<'_>> {
        let patterns = self.patterns.iter();
        let patterns = patterns.flat_map(|pattern| self.pattern_constants(pattern));
        [
            self.constants(),
            self.angle_constants(),
            self.output_constants(),
            patterns.collect(),
        ]
        .concat()
    }

    /// Who is who, and where.
    fn tree(&self) -> Vec<Constant<'_>> {
        let lower = self.bodies.iter();
        let lower = lower.map(|body| body.lower.map_or(0, |lower| lower + 1));
        let bodies = self.bodies.iter().map(|body| body.name.as_str());
        vec![
            constant(NAME, "The system's name.", Data::Text(&self.name)),
            constant(
                LOWER_BODIES,
                "The body-connection array: the number of each body's lower body (parent), counted from 1; 0 is the inertial frame.",
                Data::Integers(N_BODIES, lower.collect()),
            ),
            constant(
                BODY_NAMES,
                "The bodies' names.",
                Data::Texts(N_BODIES, bodies.collect()),
            ),
            constant(
                COORDINATE_NAMES,
                format!(
                    "The coordinates' names: {COORDINATES} {}.",
                    by_place(&self.units.coordinates)
                ),
                texts(N_COORDINATES, &self.coordinates),
            ),
            constant(
                SPEED_NAMES,
                format!(
                    "The speeds' names; {SPEEDS} {}.",
                    by_place(&self.units.speeds)
                ),
                texts(N_SPEEDS, &self.speeds),
            ),
            constant(
                "SPEED_BODIES",
                "The body that each speed moves relative to its lower body, as an index into `BODY_NAMES`.",
                Data::Integers(N_SPEEDS, self.speed_bodies.clone()),
            ),
            constant(
                JOINTS,
                "Each body's joint: the places of its coordinates and speeds.",
                Data::Joints(N_BODIES, &self.joints),
            ),
            constant(
                FRAMES,
                "Frames of the model's bodies that are fixed to others, and part of them.",
                Data::Frames(&self.frames),
            ),
        ]
    }

    fn limits(&self) -> [Constant<'_>; 5] {
        let limits = &self.limits;
        [
            constant(
                "LOWER_LIMITS",
                "The least value of each coordinate, rad, m: data only.",
                Data::Numbers(N_COORDINATES, &limits.lower),
            ),
            constant(
                "UPPER_LIMITS",
                "The greatest value of each coordinate, rad, m: data only.",
                Data::Numbers(N_COORDINATES, &limits.upper),
            ),
            constant(
                "VELOCITY_LIMITS",
                "The greatest magnitude of each speed, rad/s, m/s: data only.",
                Data::Numbers(N_SPEEDS, &limits.velocity),
            ),
            constant(
                "EFFORT_LIMITS",
                "The greatest magnitude of each generalized force, N m, N: data only.",
                Data::Numbers(N_SPEEDS, &limits.effort),
            ),
            constant(
                "FRICTION",
                "Coulomb friction along each speed, N m, N: data only, no part of any function.",
                Data::Numbers(N_SPEEDS, &limits.friction),
            ),
        ]
    }

    /// The constants of modules in which functions are given sines and cosines.
    pub fn angle_constants(&self) -> Vec<Constant<'_>> {
        let angles = self.angles.iter().map(|angles| {
            let names = angles.iter().map(|angle| angle.name.as_str());
            constant(
                "ANGLE_NAMES",
                "The names of the angles among the coordinates, in the order of `q`.",
                Data::Texts(N_ANGLES, names.collect()),
            )
        });
        let n_angles = self.sizes.named(N_ANGLES).map(size);
        n_angles.into_iter().chain(angles).collect()
    }

    /// The constants that say how outputs are to be read: which entries packed ones have, and what their columns belong to.
    pub fn output_constants(&self) -> Vec<Constant<'_>> {
        [
            self.packed_constants(),
            self.base_parameter_constants(),
            self.parameter_constants(),
            self.frame_speed_constants(),
            self.entry_constants(),
        ]
        .concat()
    }

    /// The constants of modules in which matrices are packed, or factors of them.
    fn packed_constants(&self) -> Vec<Constant<'_>> {
        let packed = self.packed.iter().flat_map(|(packed, places)| {
            let length = self.sizes.named(packed.length_constant()).map(size);
            let places = constant(
                packed.places_constant(),
                packed.written(),
                Data::Places(packed.length_constant(), places),
            );
            length.into_iter().chain([places])
        });
        let order = self.elimination.iter().map(|order| {
            constant(
                ELIMINATION,
                "The speeds in the order in which `mass_matrix_factors` eliminates them.",
                Data::Integers(N_SPEEDS, order.clone()),
            )
        });
        packed.chain(order).collect()
    }

    /// The constants of a base regressor: which combinations its columns belong to.
    pub fn base_parameter_constants(&self) -> Vec<Constant<'_>> {
        let Some(base) = &self.base_parameters else {
            return Vec::new();
        };
        let length = self.sizes.named(N_BASE_PARAMETERS).map(size);
        let names = constant(
            BASE_PARAMETERS,
            "The base parameters, in the order of the columns of `base_regressor`: sums of the bodies' inertial parameters, those of `regressor`.",
            texts(N_BASE_PARAMETERS, &base.texts),
        );
        let terms = constant(
            BASE_PARAMETER_TERMS,
            "The terms of the base parameters, one after the other; the first of each is the parameter whose column is the base parameter's.",
            Data::Terms(&base.terms),
        );
        length.into_iter().chain([names, terms]).collect()
    }

    /// The constants of modules with values set at run time, or derivatives by all of them: what these are called.
    pub fn parameter_constants(&self) -> Vec<Constant<'_>> {
        let Some(length) = self.sizes.named(N_PARAMETERS) else {
            return Vec::new();
        };
        let names = self.parameters.iter();
        let names = names.map(|parameter| parameter.name.as_str()).collect();
        let names = constant(
            PARAMETER_NAMES,
            "The fields of `Parameters`, in the order of its arrays and of the columns of derivatives by them.",
            Data::Texts(N_PARAMETERS, names),
        );
        vec![size(length), names]
    }

    /// The constant of modules in which accelerations of some speeds are given, and forces of the others.
    pub fn prescribed_constant(&self) -> Option<Constant<'_>> {
        let prescribed = self.prescribed.as_ref()?;
        Some(constant(
            PRESCRIBED,
            "True for each speed whose acceleration `hybrid_dynamics` is given, and whose force it finds.",
            Data::Truths(N_SPEEDS, prescribed),
        ))
    }

    /// The constants of Jacobians: which speeds move the frames.
    fn frame_speed_constants(&self) -> Vec<Constant<'_>> {
        let frames = self.frame_speeds.iter();
        let constants = frames.flat_map(|frame| {
            let speeds = Data::Integers(&frame.length, frame.speeds.clone());
            let length = self.sizes.named(&frame.length).map(size);
            let speeds = constant(&frame.constant, frame.doc.as_str(), speeds);
            length.into_iter().chain([speeds])
        });
        constants.collect()
    }

    /// The constants of packed derivatives: which entries they have.
    fn entry_constants(&self) -> Vec<Constant<'_>> {
        let all = self.entries.iter();
        all.flat_map(|entries| self.constants_of(entries)).collect()
    }

    fn constants_of<'a>(&'a self, entries: &'a PackedEntries) -> Vec<Constant<'a>> {
        let length = self.sizes.named(&entries.length).map(size);
        let places = Data::Places(&entries.length, &entries.places);
        let places = constant(&entries.constant, entries.doc.as_str(), places);
        let mut constants: Vec<Constant<'_>> = length.into_iter().chain([places]).collect();
        if let Some(own) = &entries.colors {
            let colors = Data::Integers(&own.length, own.colors.clone());
            constants.extend(self.sizes.named(&own.length).map(size));
            constants.push(constant(&own.constant, own.doc.as_str(), colors));
        }
        constants
    }

    /// The constants of a compact output.
    pub fn pattern_constants<'a>(&'a self, pattern: &'a Pattern) -> Vec<Constant<'a>> {
        let blocks = constant(
            &pattern.blocks,
            pattern.doc.as_str(),
            Data::Blocks(&pattern.entries),
        );
        let columns = self.sizes.named(&pattern.columns).map(size);
        columns.into_iter().chain([blocks]).collect()
    }
}

pub(super) fn constant<'a>(
    name: &'a str,
    doc: impl Into<Cow<'a, str>>,
    data: Data<'a>,
) -> Constant<'a> {
    let doc = doc.into();
    Constant { name, doc, data }
}

fn size(size: &Size) -> Constant<'_> {
    constant(&size.name, size.doc.as_str(), Data::Size(size.value))
}

fn texts<'a>(length: &'static str, texts: &'a [String]) -> Data<'a> {
    Data::Texts(length, texts.iter().map(String::as_str).collect())
}
