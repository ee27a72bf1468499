//! What functions are given besides the parameters: one table.
//!
//! In: an [`Argument`]. Out: its name, what array it is, what it means, and which inputs of the equations stand in it, entry
//! by entry. Whatever reads, writes, declares or samples arguments follows from this.

use super::shape::{Element, Shape};
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
}

/// A row of the table.
struct Row {
    name: &'static str,
    element: Element,
    shape: Shape,
    meaning: &'static str,
    /// The constant that holds its samples in the tests beside a module; `None` for what `kane::self_test::State` holds.
    sampled: Option<&'static str>,
    /// The input that stands at a place, all entries one after the other.
    input: fn(usize) -> Input,
}

impl Row {
    /// Numbers that `kane::self_test::State` holds.
    fn of_state(
        name: &'static str,
        shape: Shape,
        meaning: &'static str,
        input: fn(usize) -> Input,
    ) -> Self {
        Self {
            name,
            element: Element::Scalar,
            shape,
            meaning,
            sampled: None,
            input,
        }
    }
}

impl Argument {
    /// All of them, in the order in which functions are given them.
    pub const ALL: [Self; 9] = [
        Self::Q,
        Self::U,
        Self::UDot,
        Self::Tau,
        Self::Loads,
        Self::RelativeAngularVelocity,
        Self::Point,
        Self::Force,
        Self::Moment,
    ];

    fn row(self) -> Row {
        match self {
            Self::Q => Row::of_state(
                "q",
                Shape::COORDINATES,
                "coordinates, rad and m; quaternions have no unit",
                |place| Input::Q(CoordinateId::new(place)),
            ),
            Self::U => Row::of_state("u", Shape::SPEEDS, "speeds, rad/s and m/s", |place| {
                Input::U(SpeedId::new(place))
            }),
            Self::UDot => Row::of_state(
                "u_dot",
                Shape::SPEEDS,
                "rates of the speeds, rad/s^2 and m/s^2",
                |place| Input::UDot(SpeedId::new(place)),
            ),
            Self::Tau => Row {
                name: "tau",
                element: Element::Scalar,
                shape: Shape::SPEEDS,
                meaning: "generalized forces, N m and N",
                sampled: Some("FORCES"),
                input: |place| Input::Tau(SpeedId::new(place)),
            },
            Self::Loads => Row {
                name: "loads",
                element: Element::Load,
                shape: Shape::BODY_SCALARS,
                meaning: "force at the mass centre and moment on each body, body components, N and N m",
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
            Self::RelativeAngularVelocity => Row {
                name: "w_rel",
                element: Element::Scalar,
                shape: Shape::BODY_VECTORS,
                meaning: "angular velocity of each body relative to its lower body, body components, rad/s",
                sampled: Some("RELATIVE_ANGULAR_VELOCITIES"),
                input: |place| Input::RelativeAngularVelocity(BodyId::new(place / 3), place % 3),
            },
            Self::Point => Row {
                name: "point",
                element: Element::Scalar,
                shape: Shape::VECTOR,
                meaning: "from the frame's origin, along the frame's axes, m",
                sampled: Some("POINTS"),
                input: Input::Point,
            },
            Self::Force => Row {
                name: "force",
                element: Element::Scalar,
                shape: Shape::VECTOR,
                meaning: "force at the frame's origin, N",
                sampled: Some("FRAME_FORCES"),
                input: Input::FrameForce,
            },
            Self::Moment => Row {
                name: "moment",
                element: Element::Scalar,
                shape: Shape::VECTOR,
                meaning: "moment on the frame, N m",
                sampled: Some("FRAME_MOMENTS"),
                input: Input::FrameMoment,
            },
        }
    }

    /// The argument's name in generated code.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// What the array is of.
    pub fn element(self) -> Element {
        self.row().element
    }

    /// The array.
    pub fn shape(self) -> Shape {
        self.row().shape
    }

    /// What it means, in words.
    pub fn meaning(self) -> &'static str {
        self.row().meaning
    }

    /// The constant that holds its samples in the tests beside a module; `None` for what `kane::self_test::State` holds.
    pub fn sampled(self) -> Option<&'static str> {
        self.row().sampled
    }

    /// The lengths of its nested arrays, outermost first.
    pub fn lengths(self, tree: &Tree) -> Vec<usize> {
        let of_tree = |axis| unreachable!("functions: an argument has no axis {axis:?}");
        self.shape().lengths(tree, of_tree)
    }

    /// True for what belongs to the frame that a function is of: two functions cannot share it.
    pub fn is_of_frame(self) -> bool {
        matches!(self, Self::Point | Self::Force | Self::Moment)
    }

    /// How many numbers it holds.
    pub fn n_numbers(self, tree: &Tree) -> usize {
        self.lengths(tree).iter().product::<usize>() * self.element().n_numbers()
    }

    /// The input that stands at a place, all numbers counted one after the other.
    pub fn input(self, place: usize) -> Input {
        (self.row().input)(place)
    }

    /// The inputs that stand in it, one after the other.
    pub fn inputs(self, tree: &Tree) -> impl Iterator<Item = Input> + use<> {
        (0..self.n_numbers(tree)).map(self.row().input)
    }
}
