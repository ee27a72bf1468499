//! Names of what a program is given, from structure: the body, then the quantity.

use crate::{expr::Input, id::BodyId, tree::Tree};

/// The names of coordinates, speeds and what belongs to these.
pub(super) struct InputNames {
    q: Vec<String>,
    /// The body and axis of each angle: `hinge` and `3`.
    angles: Vec<(String, usize)>,
    u: Vec<String>,
    u_dot: Vec<String>,
    tau: Vec<String>,
}

impl InputNames {
    /// Those of a tree.
    pub(super) fn of(tree: &Tree) -> Self {
        Self {
            q: tree.coordinate_names(),
            angles: tree
                .angles()
                .into_iter()
                .map(|angle| (tree.body(angle.body).identifier.clone(), angle.axis + 1))
                .collect(),
            u: tree.speed_names(),
            u_dot: tree.along_speeds("_ddot", "_dot"),
            tau: tree.along_speeds("_tau", "_tau"),
        }
    }

    /// The name of an input.
    pub(super) fn input(&self, tree: &Tree, input: Input) -> String {
        let of_frame =
            |quantity: &str, axis: usize| format!("{quantity}_{}", ["x", "y", "z"][axis]);
        let component = |body: BodyId, quantity: &str, axis: usize| {
            format!(
                "{}_{}",
                tree.body(body).identifier,
                of_frame(quantity, axis)
            )
        };
        let sine = |place: usize, function: &str| {
            let (body, axis) = &self.angles[place];
            format!("{body}_{function}{axis}")
        };
        match input {
            Input::Sine(place) => sine(place, "sin"),
            Input::Cosine(place) => sine(place, "cos"),
            Input::Q(coordinate) => self.q[coordinate.index()].clone(),
            Input::U(speed) => self.u[speed.index()].clone(),
            Input::UDot(speed) => self.u_dot[speed.index()].clone(),
            Input::Tau(speed) => self.tau[speed.index()].clone(),
            Input::Force(body, axis) => component(body, "force", axis),
            Input::Moment(body, axis) => component(body, "moment", axis),
            Input::RelativeAngularVelocity(body, axis) => component(body, "w_rel", axis),
            Input::Point(axis) => of_frame("point", axis),
            Input::FrameForce(axis) => of_frame("force", axis),
            Input::FrameMoment(axis) => of_frame("moment", axis),
            Input::Shared(_) | Input::Side(_) | Input::CallResult(_) => {
                unreachable!("listing: {input:?} is no input of a function")
            }
            Input::Product(of, place) => format!("product_{of}_{place}"),
            Input::Parameter(parameter) => tree.parameters[parameter.index()].name.clone(),
            Input::Prepared(place) => format!("prepared_{place}"),
        }
    }
}
