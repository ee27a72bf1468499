//! What functions are given besides the parameters: one table.
//!
//! In: an [`Argument`]. Out: its name, what array it is, what it means, and which inputs of the equations stand in it, entry
//! by entry. Whatever reads, writes, declares or samples arguments follows from this.

use std::borrow::Cow;

use super::{
    multiplier::Multiplier,
    shape::{Element, Length, Shape},
    unit::Unit,
};
use crate::{
    expr::Input,
    id::{BodyId, CoordinateId, SpeedId},
    tree::Tree,
};

/// An argument of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Argument {
    /// `q: &[R; NQ]`.
    Q,
    /// `u: &[R; NU]`.
    U,
    /// `u_dot: &[R; NU]`.
    UDot,
    /// `tau: &[R; NU]`.
    Tau,
    /// `loads: &[Load<R>; NB]`.
    Loads,
    /// `w_rel: &[[R; 3]; NB]`.
    RelativeAngularVelocity,
    /// `point: &[R; 3]`.
    Point,
    /// `force: &[R; 3]`.
    Force,
    /// `moment: &[R; 3]`.
    Moment,
    /// `q_direction: &[R; NU]`.
    QDirection,
    /// `u_direction: &[R; NU]`.
    UDirection,
    /// `u_dot_direction: &[R; NU]`.
    UDotDirection,
    /// `tau_direction: &[R; NU]`.
    TauDirection,
    /// `loads_direction: &[Load<R>; NB]`.
    LoadsDirection,
    /// `parameters_direction: &[R; PARAMETERS_LEN]`.
    ParametersDirection,
    /// `multiplier: &[R; 3]`, or an array like another output.
    Multiplier(Multiplier),
}

/// The first [`Input::Product`] of multipliers: those of directions stand before it. A function has one for each of its
/// outputs, so that different functions' arguments may be the same inputs.
const MULTIPLIERS: usize = 6;

/// A row of the table.
struct Row {
    name: &'static str,
    element: Element,
    shape: Shape,
    /// Without the unit.
    meaning: &'static str,
    unit: Unit,
    /// The constant that holds its samples in the tests beside a module; `None` for what `kane::self_test::State` holds.
    sampled: Option<&'static str>,
    /// The input that stands at a place, all entries one after the other.
    input: fn(usize) -> Input,
}

impl Row {
    /// Numbers of which the tests beside a module hold samples.
    fn sampled(
        name: &'static str,
        shape: Shape,
        (meaning, unit): (&'static str, Unit),
        (sampled, input): (&'static str, fn(usize) -> Input),
    ) -> Self {
        Self {
            name,
            element: Element::Scalar,
            shape,
            meaning,
            unit,
            sampled: Some(sampled),
            input,
        }
    }

    /// Numbers that `kane::self_test::State` holds.
    fn of_state(
        name: &'static str,
        shape: Shape,
        (meaning, unit): (&'static str, Unit),
        input: fn(usize) -> Input,
    ) -> Self {
        Self {
            name,
            element: Element::Scalar,
            shape,
            meaning,
            unit,
            sampled: None,
            input,
        }
    }
}

impl Argument {
    /// All but multipliers, in the order in which functions are given them, which is that of the variants; multipliers come last, in
    /// the order of the outputs.
    pub const ALL: [Self; 15] = [
        Self::Q,
        Self::U,
        Self::UDot,
        Self::Tau,
        Self::Loads,
        Self::RelativeAngularVelocity,
        Self::Point,
        Self::Force,
        Self::Moment,
        Self::QDirection,
        Self::UDirection,
        Self::UDotDirection,
        Self::TauDirection,
        Self::LoadsDirection,
        Self::ParametersDirection,
    ];

    /// The direction along which this one changes.
    pub(super) fn direction(self) -> Option<Self> {
        Some(match self {
            Self::Q => Self::QDirection,
            Self::U => Self::UDirection,
            Self::UDot => Self::UDotDirection,
            Self::Tau => Self::TauDirection,
            Self::Loads => Self::LoadsDirection,
            _ => return None,
        })
    }

    fn row(self) -> Row {
        self.of_direction().unwrap_or_else(|| self.of_function())
    }

    fn multiplier(self) -> Option<Multiplier> {
        match self {
            Self::Multiplier(own) => Some(own),
            _ => None,
        }
    }

    /// The rows of directions.
    fn of_direction(self) -> Option<Row> {
        let direction = Row::sampled;
        Some(match self {
            Self::QDirection => direction(
                "q_direction",
                Shape::SPEEDS,
                (
                    "the change of `q` along the motion of each speed",
                    Unit::DIRECTIONS,
                ),
                ("Q_DIRECTIONS", |place| Input::Product(0, place)),
            ),
            Self::UDirection => direction(
                "u_direction",
                Shape::SPEEDS,
                ("the change of `u`", Unit::SPEEDS),
                ("U_DIRECTIONS", |place| Input::Product(1, place)),
            ),
            Self::UDotDirection => direction(
                "u_dot_direction",
                Shape::SPEEDS,
                ("the change of `u_dot`", Unit::ACCELERATIONS),
                ("U_DOT_DIRECTIONS", |place| Input::Product(2, place)),
            ),
            Self::TauDirection => direction(
                "tau_direction",
                Shape::SPEEDS,
                ("the change of `tau`", Unit::FORCES),
                ("TAU_DIRECTIONS", |place| Input::Product(3, place)),
            ),
            Self::LoadsDirection => Row {
                element: Element::Load,
                ..direction(
                    "loads_direction",
                    Shape::BODY_SCALARS,
                    ("the change of `loads`", Self::Loads.unit()),
                    ("LOADS_DIRECTIONS", |place| Input::Product(4, place)),
                )
            },
            Self::ParametersDirection => direction(
                "parameters_direction",
                Shape::VALUES,
                (
                    "the change of the values set at run time, in the order of `PARAMETER_NAMES`",
                    Unit::UNKNOWN,
                ),
                ("PARAMETERS_DIRECTIONS", |place| Input::Product(5, place)),
            ),
            _ => return None,
        })
    }

    /// The rows of all others.
    fn of_function(self) -> Row {
        match self {
            Self::Q => Row::of_state(
                "q",
                Shape::COORDINATES,
                ("coordinates", Unit::COORDINATES),
                |place| Input::Q(CoordinateId::new(place)),
            ),
            Self::U => Row::of_state("u", Shape::SPEEDS, ("speeds", Unit::SPEEDS), |place| {
                Input::U(SpeedId::new(place))
            }),
            Self::UDot => Row::of_state(
                "u_dot",
                Shape::SPEEDS,
                ("rates of the speeds", Unit::ACCELERATIONS),
                |place| Input::UDot(SpeedId::new(place)),
            ),
            Self::Tau => Row::sampled(
                "tau",
                Shape::SPEEDS,
                ("generalized forces", Unit::FORCES),
                ("FORCES", |place| Input::Tau(SpeedId::new(place))),
            ),
            Self::Loads => Row {
                name: "loads",
                element: Element::Load,
                shape: Shape::BODY_SCALARS,
                meaning: "force at the mass centre and moment on each body, body components",
                unit: Unit::Of(&["N", "N m"]),
                sampled: Some("LOADS"),
                input: |place| {
                    let (body, component) = (BodyId::new(place / 6), place % 6);
                    if component < 3 {
                        Input::Force(body, component)
                    } else {
                        Input::Moment(body, component - 3)
                    }
                },
            },
            Self::RelativeAngularVelocity => Row::sampled(
                "w_rel",
                Shape::BODY_VECTORS,
                (
                    "angular velocity of each body relative to its lower body, body components",
                    Unit::Of(&["rad/s"]),
                ),
                ("RELATIVE_ANGULAR_VELOCITIES", |place| {
                    Input::RelativeAngularVelocity(BodyId::new(place / 3), place % 3)
                }),
            ),
            Self::Point => Row::sampled(
                "point",
                Shape::VECTOR,
                (
                    "from the frame's origin, along the frame's axes",
                    Unit::Of(&["m"]),
                ),
                ("POINTS", Input::Point),
            ),
            Self::Force => Row::sampled(
                "force",
                Shape::VECTOR,
                (
                    "force at the frame's origin, inertial components, or the frame's own for `local`",
                    Unit::Of(&["N"]),
                ),
                ("FRAME_FORCES", Input::FrameForce),
            ),
            Self::Moment => Row::sampled(
                "moment",
                Shape::VECTOR,
                (
                    "moment on the frame, components likewise",
                    Unit::Of(&["N m"]),
                ),
                ("FRAME_MOMENTS", Input::FrameMoment),
            ),
            _ => unreachable!("functions: {self:?} is of a product"),
        }
    }

    /// The argument's name in generated code.
    pub fn name(self) -> &'static str {
        let own = self.multiplier().map(Multiplier::name);
        own.unwrap_or_else(|| self.row().name)
    }

    /// What the array is of.
    pub fn element(self) -> Element {
        let own = self.multiplier().map(|_| Element::Scalar);
        own.unwrap_or_else(|| self.row().element)
    }

    /// The array.
    pub fn shape(self) -> Shape {
        let own = self.multiplier().map(Multiplier::shape);
        own.unwrap_or_else(|| self.row().shape)
    }

    /// What it means, in words.
    pub fn meaning(self) -> &'static str {
        let own = self.multiplier().map(Multiplier::meaning);
        own.unwrap_or_else(|| self.row().meaning)
    }

    /// The units of its entries. A multiplier has those that whoever calls gives it: entries of different units are added.
    pub fn unit(self) -> Unit {
        let own = self.multiplier().map(|_| Unit::UNKNOWN);
        own.unwrap_or_else(|| self.row().unit)
    }

    /// The constant that holds its samples in the tests beside a module; `None` for what `kane::self_test::State` holds.
    pub fn sampled(self) -> Option<Cow<'static, str>> {
        match self {
            Self::Multiplier(own) => Some(own.sampled().into()),
            _ => self.row().sampled.map(Cow::Borrowed),
        }
    }

    /// The lengths of its nested arrays, outermost first.
    pub fn lengths(self, tree: &Tree) -> Vec<usize> {
        let of_tree = |dimension| unreachable!("functions: an argument has no {dimension:?}");
        match self {
            Self::Multiplier(own) => own.lengths(tree),
            _ => self.shape().lengths(tree, of_tree),
        }
    }

    /// The same as generated code names them.
    pub(super) fn declared_lengths(self) -> Vec<Length> {
        let of_tree = |dimension| unreachable!("functions: an argument has no {dimension:?}");
        match self {
            Self::Multiplier(own) => own.declared(),
            _ => self.shape().declared(of_tree),
        }
    }

    /// True for what belongs to the frame that a function is of.
    pub fn is_of_frame(self) -> bool {
        matches!(self, Self::Point | Self::Force | Self::Moment)
    }

    /// True for a direction or multiplier.
    pub fn is_of_product(self) -> bool {
        self.multiplier().is_some() || self.of_direction().is_some()
    }

    /// How many numbers it holds.
    pub fn n_numbers(self, tree: &Tree) -> usize {
        self.lengths(tree).iter().product::<usize>() * self.element().n_numbers()
    }

    /// The input that stands at a place, all numbers counted one after the other.
    pub fn input(self, place: usize) -> Input {
        match self {
            Self::Multiplier(own) => Input::Product(MULTIPLIERS + own.place(), place),
            _ => (self.row().input)(place),
        }
    }

    /// The inputs that stand in it, one after the other.
    pub fn inputs(self, tree: &Tree) -> impl Iterator<Item = Input> + use<> {
        (0..self.n_numbers(tree)).map(move |place| self.input(place))
    }
}
