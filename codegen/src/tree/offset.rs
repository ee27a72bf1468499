//! Vectors between points fixed in a body, of which any part may be set at run time.

use crate::geometry::{self, Rotation};
use crate::tree::value::{Parameter, Value};

/// A vector fixed in a body: a sum of steps, each given in axes of its own.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Offset {
    steps: Vec<Step>,
}

/// One step of an [`Offset`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// From the axes of the whole to those of the step.
    pub rotation: Rotation,
    /// Along the step's axes, m.
    pub vector: [Value; 3],
    /// True where the step is taken backward.
    pub negative: bool,
}

impl Offset {
    /// One step, along axes to which `rotation` leads.
    pub fn new(rotation: Rotation, vector: [Value; 3]) -> Self {
        Self::default().plus(Step {
            rotation,
            vector,
            negative: false,
        })
    }

    /// The same and one more step.
    #[must_use]
    pub fn plus(mut self, step: Step) -> Self {
        if let Some(numbers) = baked(&step) {
            let last = self.steps.last_mut().filter(|step| baked(step).is_some());
            if let Some(last) = last {
                let before = baked(last).unwrap_or_default();
                let sum = std::array::from_fn(|i| before[i] + numbers[i]);
                *last = number(sum);
            } else {
                self.steps.push(number(numbers));
            }
        } else {
            self.steps.push(step);
        }
        self
    }

    /// The steps; none for a point that is the origin whatever the values.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The same vector in axes from which `rotation` leads to the present ones.
    #[must_use]
    pub fn before(&self, rotation: &Rotation) -> Self {
        self.with_rotations(|own| geometry::then(rotation, own))
    }

    /// Both vectors, one after the other; `other` backward where `negative`.
    #[must_use]
    pub fn join(self, other: &Self, negative: bool) -> Self {
        other.steps.iter().fold(self, |sum, step| {
            sum.plus(Step {
                negative: step.negative ^ negative,
                ..*step
            })
        })
    }

    /// This vector less another one. Steps that both have cancel.
    #[must_use]
    pub fn less(&self, other: &Self) -> Self {
        let mut rest = self.clone();
        let mut backward = Self::default();
        for step in &other.steps {
            match rest.steps.iter().position(|own| own == step) {
                Some(place) => {
                    rest.steps.remove(place);
                }
                None => backward.steps.push(*step),
            }
        }
        rest.join(&backward, true)
    }

    /// The same with other rotations of its steps.
    #[must_use]
    pub(crate) fn with_rotations(&self, of: impl Fn(&Rotation) -> Rotation) -> Self {
        let turned = |step: &Step| Step {
            rotation: of(&step.rotation),
            ..*step
        };
        self.steps
            .iter()
            .fold(Self::default(), |sum, step| sum.plus(turned(step)))
    }

    /// The vector at the nominal values of these parameters.
    pub fn nominal(&self, parameters: &[Parameter]) -> [f64; 3] {
        self.steps.iter().fold([0.0; 3], |sum, step| {
            let vector = step.vector.map(|value| value.nominal(parameters));
            let turned = signed(step, vector);
            std::array::from_fn(|i| sum[i] + turned[i])
        })
    }
}

/// A step of which no part is set at run time, in the axes of the whole.
fn baked(step: &Step) -> Option<[f64; 3]> {
    let mut numbers = [0.0; 3];
    for (number, value) in numbers.iter_mut().zip(step.vector) {
        let Value::Baked(baked) = value else {
            return None;
        };
        *number = baked;
    }
    Some(signed(step, numbers))
}

fn signed(step: &Step, vector: [f64; 3]) -> [f64; 3] {
    let turned = geometry::apply(&geometry::transposed(&step.rotation), vector);
    turned.map(|part| if step.negative { 0.0 - part } else { part })
}

fn number(vector: [f64; 3]) -> Step {
    Step {
        rotation: geometry::IDENTITY,
        vector: vector.map(Value::Baked),
        negative: false,
    }
}
