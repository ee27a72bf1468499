//! What acts in joints: rotors, dampers and springs.

use kane_codegen::{
    description::{JointKind, PerCoordinate, Scalar},
    id::BodyId,
    tree::Orientation,
};

use super::{
    composition::{Composition, Link},
    state::State,
};

/// What acts along a motion of a joint.
#[derive(Clone, Copy, Debug)]
pub struct Acting {
    /// The body whose joint it is.
    body: BodyId,
    /// Where the motion's coordinate is; none for a component of an angular velocity.
    coordinate: Option<Link>,
    /// The place of its speed in `u`, and the motion's own speed for a unit of that.
    speed: usize,
    factor: f64,
    stiffness: f64,
    rest: f64,
    damping: f64,
    armature: f64,
}

impl Composition {
    /// What acts in the joints.
    pub fn acting(&self) -> Vec<Acting> {
        let mut all = Vec::new();
        for (place, body) in self.moving.iter().enumerate() {
            let Some(body) = *body else { continue };
            let (own, joint) = (self.joint(place), &self.tree.body(body).joint);
            let quantities = [&own.stiffness, &own.rest, &own.damping, &own.armature];
            let mut add = |motion: usize, coordinate: Option<Link>, speed: usize, factor: f64| {
                let [stiffness, rest, damping, armature] =
                    quantities.map(|quantity| at(quantity, motion));
                all.push(Acting {
                    body,
                    coordinate,
                    speed,
                    factor,
                    stiffness,
                    rest,
                    damping,
                    armature,
                });
            };
            if self.follows(place) {
                let link = self.link(place);
                let [_, speed] = link.places.expect("what moves follows what moves");
                let motion = match self.kind(place) {
                    JointKind::List(axes) => axes[0].value.index(),
                    _ => 0,
                };
                add(motion, Some(link), speed, link.multiplier);
                continue;
            }
            let is_rate =
                |motion: usize| motion > 2 || matches!(joint.orientation, Orientation::Rates(_));
            let mut coordinates = joint.coordinates();
            let n_rates = joint
                .speeds()
                .iter()
                .filter(|(motion, _)| is_rate(*motion))
                .count();
            let mut coordinates = coordinates
                .split_off(coordinates.len() - n_rates)
                .into_iter();
            for (motion, speed) in joint.speeds() {
                let coordinate = is_rate(motion).then(|| {
                    let (_, coordinate) = coordinates.next().expect("a rate has a coordinate");
                    Link {
                        places: Some([coordinate.index(), speed.index()]),
                        multiplier: 1.0,
                        offset: 0.0,
                    }
                });
                add(motion, coordinate, speed.index(), 1.0);
            }
        }
        all
    }
}

impl Acting {
    fn stretch(&self, q: &[f64]) -> f64 {
        self.coordinate
            .map_or(0.0, |link| link.value(q) - self.rest)
    }

    /// Energies of rotor and spring.
    pub fn energies(&self, state: &State) -> [f64; 2] {
        let (rate, stretch) = (self.factor * state.u[self.speed], self.stretch(&state.q));
        [
            0.5 * self.armature * rate * rate,
            0.5 * self.stiffness * stretch * stretch,
        ]
    }

    /// The speed, and the generalized forces there that rotor, damper and spring need.
    pub fn needed(&self, state: &State) -> (usize, [f64; 3]) {
        let rate = self.factor * state.u[self.speed];
        let second = self.factor * state.u_dot[self.speed];
        let needed = [
            self.armature * second,
            self.damping * rate,
            self.stiffness * self.stretch(&state.q),
        ];
        (self.speed, needed.map(|force| self.factor * force))
    }

    /// Damping and rotor inertia, as the speed feels them.
    pub fn felt(&self) -> [f64; 2] {
        let square = self.factor * self.factor;
        [square * self.damping, square * self.armature]
    }

    /// The body whose joint it is.
    pub fn body(&self) -> BodyId {
        self.body
    }

    pub fn has_rotor(&self) -> bool {
        self.armature != 0.0
    }

    pub fn speed(&self) -> usize {
        self.speed
    }
}

fn at(quantity: &PerCoordinate<Scalar>, motion: usize) -> f64 {
    match quantity {
        PerCoordinate::Absent => 0.0,
        PerCoordinate::Same(value) => value.value.nominal(),
        PerCoordinate::Each(values) => values
            .iter()
            .find(|(axis, _)| axis.value.index() == motion)
            .map_or(0.0, |(_, value)| value.value.nominal()),
    }
}
