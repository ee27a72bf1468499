//! Names of what a program is given, from structure: the body, then the quantity, or a number counted within the body.

use std::collections::{BTreeMap, BTreeSet};

use crate::{
    expr::{Input, Node},
    id::BodyId,
    passes::{
        hoist::{Field, Preparation},
        sines,
    },
    tree::Tree,
};

/// The fields of `Prepared`, in the order of the prepared values: a parameter's own name, or the function, the body and
/// what it is there.
pub fn prepared_fields(preparation: &Preparation, tree: &Tree) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let mut counters: BTreeMap<_, usize> = BTreeMap::new();
    let name = |field: &Field| {
        let body = field
            .scope
            .map_or("system", |body| tree.body(body).identifier.as_str());
        let mut name = match (
            field.function.as_deref(),
            &field.label,
            preparation.graph.node(field.root.node()),
        ) {
            (_, _, Node::Input(input)) => InputNames::default().input(tree, input),
            (function, Some(label), _) => {
                format!("{}_{body}_{label}", function.unwrap_or_default())
            }
            (function, None, _) => {
                let counter = counters
                    .entry((field.function.clone(), field.scope))
                    .or_default();
                *counter += 1;
                format!("{}_{body}_k{counter}", function.unwrap_or_default())
            }
        };
        while !taken.insert(name.clone()) {
            name.push('_');
        }
        name
    };
    preparation.fields.iter().map(name).collect()
}

/// The names of coordinates, speeds and what belongs to these.
#[derive(Default)]
pub(crate) struct InputNames {
    q: Vec<String>,
    /// The body and axis of each angle: `hinge` and `3`.
    angles: Vec<(String, usize)>,
    u: Vec<String>,
    u_dot: Vec<String>,
    tau: Vec<String>,
}

impl InputNames {
    /// Those of a tree.
    pub(crate) fn of(tree: &Tree) -> Self {
        Self {
            q: tree.coordinate_names(),
            angles: sines::angles(tree)
                .into_iter()
                .map(|angle| (tree.body(angle.body).identifier.clone(), angle.axis + 1))
                .collect(),
            u: tree.speed_names(),
            u_dot: tree.along_speeds("_ddot", "_dot"),
            tau: tree.along_speeds("_tau", "_tau"),
        }
    }

    /// The name of an input.
    pub(crate) fn input(&self, tree: &Tree, input: Input) -> String {
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
            Input::Shared(place) => format!("shared_{place}"),
            Input::Side(place) => format!("side_{place}"),
            Input::CallResult(_) => unreachable!("program: what calls compute is no input"),
            Input::Product(of, place) => format!("product_{of}_{place}"),
            Input::Parameter(parameter) => tree.parameters[parameter.index()].name.clone(),
            Input::Prepared(place) => format!("prepared_{place}"),
        }
    }
}
