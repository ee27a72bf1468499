//! A body of a random system, and its text.

use crate::rotation::Rotation;

/// A number, and whether it is written as a runtime value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Number {
    pub(crate) value: f64,
    pub(crate) runtime: bool,
}

#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// What it is called by, as is its joint.
    pub(crate) number: usize,
    pub(crate) lower: Option<usize>,
    pub(crate) mass: Number,
    pub(crate) mass_center: [Number; 3],
    /// xx, yy, zz, xy, xz, yz.
    pub(crate) inertia: [Number; 6],
    pub(crate) inertia_rotation: Option<Rotation>,
    /// The share of the weight that is lifted.
    pub(crate) lifted: Option<Number>,
    pub(crate) joint: Joint,
}

#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) attachment: [Number; 3],
    pub(crate) attachment_rotation: Option<Rotation>,
    pub(crate) body_attachment: Option<[Number; 3]>,
    pub(crate) body_rotation: Option<Rotation>,
    pub(crate) kind: Kind,
    pub(crate) locked: [f64; 6],
    pub(crate) has_name: bool,
    pub(crate) chart: Option<&'static str>,
    pub(crate) speeds: Option<&'static str>,
    /// Of each of [`MECHANICS`].
    pub(crate) mechanics: [Quantity; 4],
    pub(crate) mimic: Option<Mimic>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    List([bool; 6]),
    Named(&'static str),
    /// About or along an axis.
    Along(&'static str, [f64; 3]),
}

/// What a joint has of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Quantity {
    Absent,
    Same(Number),
    Each([Option<Number>; 6]),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mimic {
    pub(crate) leader: usize,
    pub(crate) multiplier: f64,
    pub(crate) offset: f64,
}

pub(crate) const AXES: [&str; 6] = ["theta1", "theta2", "theta3", "s1", "s2", "s3"];
pub(crate) const MECHANICS: [&str; 4] = ["stiffness", "rest", "damping", "armature"];
const COMPONENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];

impl Number {
    pub(crate) fn baked(value: f64) -> Self {
        Self {
            value,
            runtime: false,
        }
    }

    fn toml(self) -> String {
        if self.runtime {
            format!("{{ runtime = {:?} }}", self.value)
        } else {
            format!("{:?}", self.value)
        }
    }
}

impl Kind {
    /// The free ones of the six coordinates; of a joint with an axis none that could be named.
    pub(crate) fn free(self) -> [bool; 6] {
        match self {
            Self::List(free) => free,
            Self::Named("universal") => [true, true, false, false, false, false],
            Self::Named("spherical") => [true, true, true, false, false, false],
            Self::Named("free") => [true; 6],
            Self::Named(_) | Self::Along(..) => [false; 6],
        }
    }

    pub(crate) fn n_motions(self) -> usize {
        match self {
            Self::Along("cylindrical", _) => 2,
            Self::Along("planar", _) => 3,
            Self::Along(..) => 1,
            _ => self.free().into_iter().filter(|free| *free).count(),
        }
    }

    /// True where the body can be turned anyhow.
    pub(crate) fn is_ball(self) -> bool {
        self.free()[..3] == [true; 3]
    }

    fn toml(self) -> String {
        match self {
            Self::List(free) => {
                let free: Vec<&str> = (0..6).filter(|&i| free[i]).map(|i| AXES[i]).collect();
                format!("joint = {free:?}\n")
            }
            Self::Named(name) => format!("joint = \"{name}\"\n"),
            Self::Along(name, axis) => format!("joint = \"{name}\"\naxis = {axis:?}\n"),
        }
    }
}

impl Quantity {
    fn numbers(&mut self) -> impl Iterator<Item = &mut Number> {
        let (same, each) = match self {
            Self::Absent => (None, None),
            Self::Same(number) => (Some(number), None),
            Self::Each(numbers) => (None, Some(numbers)),
        };
        same.into_iter()
            .chain(each.into_iter().flatten().filter_map(Option::as_mut))
    }

    fn toml(&self, key: &str) -> String {
        match self {
            Self::Absent => String::new(),
            Self::Same(number) => format!("{key} = {}\n", number.toml()),
            Self::Each(numbers) => {
                let given = AXES.iter().zip(numbers);
                let given: Vec<String> = given
                    .filter_map(|(axis, number)| Some(format!("{axis} = {}", (*number)?.toml())))
                    .collect();
                format!("{key} = {{ {} }}\n", given.join(", "))
            }
        }
    }
}

impl Joint {
    /// Free coordinates between frames that are the bodies' own.
    pub(crate) fn plain(attachment: [Number; 3], free: [bool; 6], locked: [f64; 6]) -> Self {
        Self {
            attachment,
            attachment_rotation: None,
            body_attachment: None,
            body_rotation: None,
            kind: Kind::List(free),
            locked,
            has_name: false,
            chart: None,
            speeds: None,
            mechanics: [Quantity::Absent; 4],
            mimic: None,
        }
    }

    pub(crate) fn is_fixed(&self) -> bool {
        self.kind.n_motions() == 0
    }

    /// True where the speeds are components of an angular velocity.
    pub(crate) fn has_angular_velocity(&self) -> bool {
        self.chart == Some("quaternion") || self.speeds == Some("angular_velocity")
    }

    fn toml(&self) -> String {
        let mut text = format!("attachment = {}\n", list(&self.attachment));
        if let Some(rotation) = &self.attachment_rotation {
            text += &line("attachment_rotation", &format!("{rotation:?}"));
        }
        if let Some(attachment) = &self.body_attachment {
            text += &line("body_attachment", &list(attachment));
        }
        if let Some(rotation) = &self.body_rotation {
            text += &line("body_rotation", &format!("{rotation:?}"));
        }
        text += &self.kind.toml();
        if !matches!(self.kind, Kind::Along(..)) {
            let free = self.kind.free();
            let locked: Vec<String> = (0..6)
                .filter(|&axis| !free[axis] && self.locked[axis] != 0.0)
                .map(|axis| format!("{} = {:?}", AXES[axis], self.locked[axis]))
                .collect();
            text += &line("locked", &format!("{{ {} }}", locked.join(", ")));
        }
        for (key, choice) in [("chart", self.chart), ("speeds", self.speeds)] {
            text += &choice.map_or_else(String::new, |choice| format!("{key} = \"{choice}\"\n"));
        }
        for (key, quantity) in MECHANICS.iter().zip(&self.mechanics) {
            text += &quantity.toml(key);
        }
        text
    }
}

impl Body {
    /// Calls `f` on every number that may be a runtime value.
    pub(crate) fn each_number(&mut self, f: &mut impl FnMut(&mut Number)) {
        f(&mut self.mass);
        self.mass_center.iter_mut().for_each(&mut *f);
        self.inertia.iter_mut().for_each(&mut *f);
        let joint = &mut self.joint;
        joint.attachment.iter_mut().for_each(&mut *f);
        joint.body_attachment.iter_mut().flatten().for_each(&mut *f);
        let mechanics = joint.mechanics.iter_mut();
        mechanics.flat_map(Quantity::numbers).for_each(&mut *f);
        self.lifted.iter_mut().for_each(f);
    }

    /// The name of a body's joint is its own, or that of the body.
    pub(crate) fn joint_name(&self) -> String {
        let letter = if self.joint.has_name { 'j' } else { 'b' };
        format!("{letter}{}", self.number)
    }

    /// The table; `leader` is the name of the joint that its own follows.
    pub(crate) fn toml(&self, leader: Option<String>) -> String {
        let inertia: Vec<String> = COMPONENTS
            .iter()
            .zip(&self.inertia)
            .map(|(name, component)| format!("{name} = {}", component.toml()))
            .collect();
        let mut text = format!(
            "\n[[body]]\nname = \"b{}\"\nmass = {}\nmass_center = {}\ninertia = {{ {} }}\n",
            self.number,
            self.mass.toml(),
            list(&self.mass_center),
            inertia.join(", "),
        );
        if let Some(rotation) = &self.inertia_rotation {
            text += &line("inertia_rotation", &format!("{rotation:?}"));
        }
        if let Some(lifted) = self.lifted {
            text += &line("gravity_compensation", &lifted.toml());
        }
        if self.joint.has_name {
            text += &line("joint_name", &format!("\"{}\"", self.joint_name()));
        }
        text += &self.joint.toml();
        if let Some((mimic, leader)) = self.joint.mimic.zip(leader) {
            let numbers = format!(
                "multiplier = {:?}, offset = {:?}",
                mimic.multiplier, mimic.offset
            );
            text += &line("mimic", &format!("{{ joint = \"{leader}\", {numbers} }}"));
        }
        text
    }
}

fn line(key: &str, value: &str) -> String {
    format!("{key} = {value}\n")
}

pub(crate) fn list(numbers: &[Number]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|number| number.toml()).collect();
    format!("[{}]", numbers.join(", "))
}
