//! What the graph is made of: nodes, signed references to them, inputs, labels.

use crate::id::{BodyId, CoordinateId, ParameterId, SpeedId};

/// A node of an [`ExprGraph`](super::ExprGraph), in order of creation: operands have smaller ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub(super) u32);

/// A node or its negative. The sign costs nothing: it ends in a subtraction or in an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Expr {
    node: NodeId,
    negative: bool,
}

/// A value or an operation. Only [`ExprGraph`](super::ExprGraph) makes nodes, in canonical form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Node {
    /// A number, finite unless the graph has overflowed, not negative, by its bits.
    Number(u64),
    /// A value that the function is given.
    Input(Input),
    /// Sine of an angle.
    Sin(NodeId),
    /// Cosine of an angle.
    Cos(NodeId),
    /// Absolute value.
    Abs(NodeId),
    /// Sum; the first operand is not negative.
    Add(Expr, Expr),
    /// Product; a constant stands first.
    Mul(NodeId, NodeId),
    /// Quotient.
    Div(NodeId, NodeId),
}

/// A scalar that a function is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Input {
    /// An entry of `q`.
    Q(CoordinateId),
    /// The sine of an angle among the coordinates, by its place among these.
    Sine(usize),
    /// Its cosine.
    Cosine(usize),
    /// An entry of `u`.
    U(SpeedId),
    /// An entry of `u_dot`.
    UDot(SpeedId),
    /// An entry of `tau`.
    Tau(SpeedId),
    /// A component of a load's force at the mass centre, body components.
    Force(BodyId, usize),
    /// A component of a load's moment, body components.
    Moment(BodyId, usize),
    /// A component of a relative angular velocity, body components.
    RelativeAngularVelocity(BodyId, usize),
    /// A component of a point's position from a frame's origin, the frame's components.
    Point(usize),
    /// A component of a force at a frame's origin.
    FrameForce(usize),
    /// A component of a moment on a frame.
    FrameMoment(usize),
    /// In a helper of a lockstep: what all its columns share, by its place.
    Shared(usize),
    /// In a helper of a lockstep: what it is given of one column, by its place.
    Side(usize),
    /// What a call of a helper computes.
    CallResult(CallResult),
    /// A number of a direction or multiplier, which a product with derivatives is given: of which, and its place there.
    Product(usize, usize),
    /// A field of `Parameters`.
    Parameter(ParameterId),
    /// A field of `Prepared`, by its place in the module's list.
    Prepared(usize),
}

/// A call of a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CallId {
    /// The lockstep, by its number in the graph.
    pub lockstep: u16,
    /// The call, by its number there.
    pub call: u16,
}

/// One number that a call computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CallResult {
    /// The call.
    pub call: CallId,
    /// The column.
    pub lane: u16,
    /// Which of the helper's roots.
    pub place: u16,
}

/// When a value is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Binding {
    /// At generation.
    Number,
    /// When the parameters are set.
    Parameters,
    /// In the loop.
    State,
}

/// A name that a reader would know, such as `w_x` for a component of an angular velocity; the body stands before it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The quantity and component.
    pub text: String,
    /// True where the quantity is the negative of the node.
    pub negative: bool,
    /// True for a name that is good to have, but costs no operation: where the value falls away, so does the name.
    pub is_hint: bool,
}

impl NodeId {
    /// The index in order of creation.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl Expr {
    pub(super) fn new(node: NodeId, negative: bool) -> Self {
        Self { node, negative }
    }

    /// The node as an expression.
    pub fn of(node: NodeId) -> Self {
        Self::new(node, false)
    }

    /// The node, without the sign.
    pub fn node(self) -> NodeId {
        self.node
    }

    /// True for the negative of the node.
    pub fn is_negative(self) -> bool {
        self.negative
    }

    /// The same node, not negative.
    #[must_use]
    pub fn abs_sign(self) -> Self {
        Self::new(self.node, false)
    }

    /// The same, with the sign flipped where `negative`.
    #[must_use]
    pub fn signed(self, negative: bool) -> Self {
        Self::new(self.node, self.negative ^ negative)
    }
}

impl std::ops::Neg for Expr {
    type Output = Self;

    fn neg(self) -> Self {
        self.signed(true)
    }
}

/// What a sine costs, in other operations, where ways are compared: a way that needs one angle more must save that much.
pub const SINE: usize = 11;

impl Node {
    /// True for numbers, and for inputs other than what calls compute.
    pub(super) fn has_own_name(self) -> bool {
        match self {
            Self::Input(input) => !matches!(input, Input::CallResult(_)),
            node => matches!(node, Self::Number(_)),
        }
    }

    /// The operands.
    pub fn operands(self) -> impl Iterator<Item = NodeId> {
        let pair = match self {
            Self::Number(_) | Self::Input(_) => [None, None],
            Self::Sin(a) | Self::Cos(a) | Self::Abs(a) => [Some(a), None],
            Self::Add(a, b) => [Some(a.node()), Some(b.node())],
            Self::Mul(a, b) | Self::Div(a, b) => [Some(a), Some(b)],
        };
        pair.into_iter().flatten()
    }
}
