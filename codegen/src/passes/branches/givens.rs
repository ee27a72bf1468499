//! Which branch each input belongs to, and which inputs of different branches are alike.

use std::collections::BTreeMap;

use super::alike::{Branch, Branches};
use crate::{
    expr::Input,
    functions::{Argument, Shape},
    id::BodyId,
    tree::Tree,
};

/// An input of a branch: that of another branch of the team is alike if all but the lane is the same.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given {
    pub(super) branch: Branch,
    /// The argument that it stands in; sines come after these, then cosines.
    pub(super) argument: usize,
    /// The place of its body among those of the branch.
    pub(super) body: usize,
    /// Its own place among those of the body.
    pub(super) place: usize,
}

/// All inputs of branches.
pub(super) struct Givens(BTreeMap<Input, Given>);

impl Givens {
    pub(super) fn of(tree: &Tree, branches: &Branches, arguments: &[Argument]) -> Self {
        let angles = tree.angles();
        let mut sines: BTreeMap<BodyId, Vec<usize>> = BTreeMap::new();
        for (place, angle) in angles.iter().enumerate() {
            sines.entry(angle.body).or_default().push(place);
        }
        let mut givens = BTreeMap::new();
        for (branch, bodies) in branches.all() {
            for (body, &id) in bodies.iter().enumerate() {
                let mut add = |argument, inputs: Vec<Input>| {
                    let inputs = inputs.into_iter().enumerate();
                    givens.extend(inputs.map(|(place, input)| {
                        let given = Given {
                            branch,
                            argument,
                            body,
                            place,
                        };
                        (input, given)
                    }));
                };
                for (argument, own) in arguments.iter().enumerate() {
                    add(argument, inputs(tree, *own, id));
                }
                let of_angles = sines.get(&id).into_iter().flatten();
                add(
                    arguments.len(),
                    of_angles.clone().map(|place| Input::Sine(*place)).collect(),
                );
                add(
                    arguments.len() + 1,
                    of_angles.map(|place| Input::Cosine(*place)).collect(),
                );
            }
        }
        Self(givens)
    }

    /// What an input of a branch is.
    pub(super) fn get(&self, input: Input) -> Option<Given> {
        self.0.get(&input).copied()
    }
}

/// Those inputs of an argument that belong to a body.
fn inputs(tree: &Tree, argument: Argument, body: BodyId) -> Vec<Input> {
    let joint = &tree.body(body).joint;
    let shape = argument.shape();
    let places: Vec<usize> = if shape == Shape::COORDINATES {
        let coordinates = joint.coordinates().into_iter();
        coordinates.map(|(_, own)| own.index()).collect()
    } else if shape == Shape::SPEEDS {
        let speeds = joint.speeds().into_iter();
        speeds.map(|(_, own)| own.index()).collect()
    } else if shape == Shape::BODY_SCALARS || shape == Shape::BODY_VECTORS {
        let n_own = argument.n_numbers(tree) / tree.bodies.len();
        (body.index() * n_own..(body.index() + 1) * n_own).collect()
    } else {
        Vec::new()
    };
    let inputs = places.into_iter().map(|place| argument.input(place));
    inputs.collect()
}
