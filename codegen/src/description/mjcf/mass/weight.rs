//! What a body weighs: what its `inertial` says, or its geoms together.

use crate::description::mjcf::contents::around::Around;
use crate::description::mjcf::contents::{Contents, Inside};
use crate::description::mjcf::known;
use crate::description::mjcf::mass::geoms::{self, Counted};
use crate::description::mjcf::mass::inertial::{self, MassProperties};
use crate::description::mjcf::mass::solid::{Solid, together};
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::models::Models;
use crate::description::mjcf::model::settings::FromGeoms;
use crate::description::mjcf::placement::Placement;
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Span};

/// What a body weighs.
#[derive(Debug)]
pub(in crate::description::mjcf) enum Weight {
    /// Nothing: it is there for a joint alone.
    Nothing,
    /// What its `inertial` says, or nothing; `None` where that is faulty.
    Written(Option<Box<MassProperties>>),
    OfGeoms(Box<MassProperties>),
}

/// A body that is weighed.
pub(in crate::description::mjcf) struct Weighed<'b, 'd> {
    /// The words for it.
    pub(in crate::description::mjcf) owner: &'b str,
    pub(in crate::description::mjcf) span: Span,
    pub(in crate::description::mjcf) around: &'b Around,
    pub(in crate::description::mjcf) contents: &'b Contents<'d>,
    /// Where it stands in what it is written in.
    pub(in crate::description::mjcf) place: &'b Placement,
    pub(in crate::description::mjcf) moves: bool,
}

impl Weight {
    /// None at all.
    pub(in crate::description::mjcf) fn zero(span: Span) -> Self {
        Self::Written(Some(Box::new(MassProperties::massless(span))))
    }

    /// `None` where it is nothing, or faulty.
    pub(in crate::description::mjcf) fn properties(&self) -> Option<&MassProperties> {
        match self {
            Self::Nothing => None,
            Self::Written(properties) => properties.as_deref(),
            Self::OfGeoms(properties) => Some(properties),
        }
    }

    pub(in crate::description::mjcf) fn is_of_geoms(&self) -> bool {
        matches!(self, Self::OfGeoms(_))
    }
}

impl Weighed<'_, '_> {
    /// What the body weighs.
    pub(in crate::description::mjcf) fn weight(
        &self,
        reader: &mut Reader,
        models: &Models<'_>,
    ) -> Weight {
        let settings = &models.list[self.around.model].settings;
        let inertial = self.inertial(reader).map(|inside| {
            let owner = format!("`inertial` of {}", self.owner);
            let given = Attributes::of(reader, inside.element, &owner, &known::INERTIAL);
            // As in MuJoCo a body with a joint of its own has an inertia.
            let may_lack = settings.least_inertia.is_some() || self.contents.joints.is_empty();
            inertial::read(reader, &given, settings, &inside.around.frame, may_lack)
        });
        let infers = match settings.from_geoms {
            FromGeoms::Always => true,
            FromGeoms::Auto => inertial.is_none(),
            FromGeoms::Never => false,
        };
        let solids = self.solids(reader, models, infers);
        let adjusted = |mut properties: MassProperties| {
            properties.adjust(settings);
            Box::new(properties)
        };
        if let Some(solid) = together(&solids) {
            return Weight::OfGeoms(adjusted(MassProperties::of(&solid, self.span)));
        }
        let properties = inertial.unwrap_or_else(|| {
            let (owner, place) = (self.owner, self.place);
            Some(MassProperties::bounded(
                reader, settings, owner, place, self.span,
            ))
        });
        Weight::Written(properties.map(adjusted))
    }

    /// The body's `inertial`, if it has one.
    fn inertial(&self, reader: &mut Reader) -> Option<&Inside<'_>> {
        let (first, others) = self.contents.inertials.split_first()?;
        for other in others {
            let fault = Diagnostic::error(format!("{} has two `inertial`", self.owner));
            let fault = fault.at(other.element.span(), "the second one");
            reader.faults.push(fault);
        }
        Some(first)
    }

    /// What the body's geoms weigh, if that is asked; their attributes are looked at in any case.
    fn solids(&self, reader: &mut Reader, models: &Models<'_>, infers: bool) -> Vec<Solid> {
        let settings = &models.list[self.around.model].settings;
        let counted = Counted {
            // With a total to reach, every mass counts.
            moves: self.moves,
            mass_matters: self.moves || settings.total_mass.is_some(),
            groups: settings.groups,
        };
        let mut solids = Vec::new();
        for inside in &self.contents.geoms {
            let given = geoms::attributes(reader, models, inside, self.owner);
            let model = &models.list[inside.around.model];
            if infers {
                let frame = &inside.around.frame;
                solids.extend(geoms::solid(reader, &given, model, frame, counted));
            }
        }
        solids
    }
}
