//! `equality`: linear ones between joints tie these; of the others those with motion capture are left out, and what the user
//! leaves out; the rest is refused.

use std::collections::{BTreeMap, BTreeSet};

use crate::description::LeftOut;
use crate::description::mjcf::bodies::{Captured, Found};
use crate::description::mjcf::contents::around::Around;
use crate::description::mjcf::joints::ties::{Equation, Ties};
use crate::description::mjcf::known;
use crate::description::mjcf::left_out::{advice, left_out};
use crate::description::mjcf::model::Model;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::defaults::{Class, ElementKind};
use crate::description::mjcf::model::models::Models;
use crate::description::mjcf::model::settings::{Switch, TRUTH};
use crate::description::xml::{Element, Reader};
use crate::diagnostic::{Diagnostic, NearNames, Spanned, shown};

/// What words call several of them.
const PLURAL: &str = "equalities that are left out";

/// Reads the equalities of all models: how joints are tied. As in MuJoCo, those of a model that is attached hold where all that
/// they name is attached, and those that name elements inside a `replicate` hold in each of its copies.
pub(super) fn read<'d>(reader: &mut Reader, models: &Models<'d>, found: &Found<'d>) -> Ties {
    let mut all = Equalities {
        models,
        names: Names::of(found),
        captured: &found.captured,
        copies: &found.copies,
        sections: BTreeMap::new(),
        copied: BTreeSet::new(),
        ties: Ties::default(),
    };
    for around in &found.copies {
        all.section(reader, around);
    }
    all.section(reader, &Around::world());
    check_names(reader, models.main(), &all.ties);
    all.ties
}

/// The equalities of all models.
struct Equalities<'d, 'f> {
    models: &'f Models<'d>,
    names: Names<'f>,
    captured: &'f Captured,
    /// What is around each copy.
    copies: &'f [Around],
    /// Those of each model, by its number.
    sections: BTreeMap<usize, Vec<Element<'d>>>,
    /// The places of those that hold in copies.
    copied: BTreeSet<usize>,
    ties: Ties,
}

/// What has a name: joints, bodies and sites.
struct Names<'f> {
    joints: BTreeSet<&'f str>,
    /// Bodies and sites.
    places: BTreeSet<String>,
}

impl<'f> Names<'f> {
    fn of(found: &'f Found<'_>) -> Self {
        let sites = found.sites.iter().filter_map(|site| site.inside.name());
        let bodies = found.bodies.given_names().map(str::to_owned);
        Self {
            joints: found.bodies.joint_names().collect(),
            places: sites.map(|name| name.value).chain(bodies).collect(),
        }
    }
}

impl<'d> Equalities<'d, '_> {
    /// Reads the equalities of a model, for a copy those alone that hold in it.
    fn section(&mut self, reader: &mut Reader, around: &Around) {
        let models = self.models;
        let model = &models.list[around.model];
        let elements = self.sections.remove(&around.model).unwrap_or_else(|| {
            let sections = model.named("equality").into_iter();
            let elements = sections.flat_map(|section| model.files.children(section));
            elements.collect()
        });
        for element in elements.iter().copied() {
            if around.is_copy() && !models.copies.count(reader, element.span()) {
                break;
            }
            reader.unknown_child(element, "`equality`", &known::EQUALITIES);
            if !known::EQUALITIES.contains(&element.name()) {
                continue;
            }
            let equality = Equality::of(reader, model, element, around);
            let place = element.span().start;
            let may_be_elsewhere = around.is_copy() || self.copied.contains(&place);
            if may_be_elsewhere && !equality.is_within(&self.names) {
                continue;
            }
            if around.is_copy() {
                self.copied.insert(place);
            }
            self.ties.equalities.extend(equality.name.clone());
            self.one(reader, model, &equality);
        }
        self.sections.insert(around.model, elements);
    }

    /// Ties joints, leaves an equality out, or refuses it.
    fn one(&mut self, reader: &mut Reader, model: &Model<'d>, equality: &Equality<'_, '_>) {
        let owner = &equality.owner;
        if !equality.active || model.settings.equalities == Switch::Off {
            return;
        }
        if equality.is_left_out(model) {
            equality.leave_out(reader, format!("{owner} is left out"));
        } else if equality.element.name() == "joint" {
            match self.in_copies(equality) {
                Some(fault) => reader.faults.push(fault),
                None => equality.tie(reader, &mut self.ties),
            }
        } else if equality.follows(self.captured) {
            let message = format!("{owner} with a body that follows motion capture is left out");
            equality.leave_out(reader, message);
        } else {
            let message = format!("{owner} is active");
            equality.refuse(reader, &message, "constraints like this are not supported");
        }
    }

    /// The fault of a joint that is there only under the names of its copies.
    fn in_copies(&self, equality: &Equality<'_, '_>) -> Option<Diagnostic> {
        let own = equality.around;
        let joints = ["joint1", "joint2"].into_iter();
        let mut joints = joints.filter_map(|name| equality.given.text(name));
        let joint = joints.find(|joint| !self.names.joints.contains(&*own.name(joint.value)))?;
        let copies = self.copies.iter();
        let copies = copies.filter(|copy| copy.model == own.model && copy.prefix == own.prefix);
        let names = copies.map(|copy| copy.name(joint.value));
        let mut names = names.filter(|name| self.names.joints.contains(name.as_str()));
        let first = names.next()?;
        let message = format!(
            "{} ties joint `{}`, which stands in a `replicate`; the first copy is called `{}`",
            equality.owner,
            shown(joint.value),
            shown(&first)
        );
        let fault = Diagnostic::error(message).at(joint.span, "expected the name of a copy");
        Some(
            fault.help(
                "an equality holds in each copy only if all that it names stands in that copy",
            ),
        )
    }
}

/// Every name by which something is to be left out is one.
fn check_names(reader: &mut Reader, model: &Model<'_>, ties: &Ties) {
    let kinds = LeftOut::NAMED.iter().map(|(name, _)| *name);
    let kinds: Vec<&str> = kinds.chain(known::EQUALITIES).collect();
    let mut near = NearNames::default();
    for name in &model.reading.leave_out {
        if kinds.contains(&name.as_str()) || ties.equalities.contains(name) {
            continue;
        }
        let single = ties.equalities.iter().map(String::as_str);
        let meant = near.nearest(name, kinds.iter().copied().chain(single));
        let help = meant.map_or_else(
            || {
                let list = LeftOut::NAMED.map(|(name, _)| format!("`{name}`"));
                format!("what can be left out are {}, the kinds of equalities, and single ones by their names", list.join(", "))
            },
            |meant| format!("did you mean `{}`?", shown(meant)),
        );
        let message = format!("there is no equality `{}` to leave out", shown(name));
        reader.faults.push(Diagnostic::error(message).help(help));
    }
}

/// An equality.
struct Equality<'d, 'a> {
    around: &'a Around,
    element: Element<'d>,
    given: Attributes<'d>,
    owner: String,
    name: Option<String>,
    active: bool,
}

impl<'d, 'a> Equality<'d, 'a> {
    fn of(
        reader: &mut Reader,
        model: &Model<'d>,
        element: Element<'d>,
        around: &'a Around,
    ) -> Self {
        let kind = element.name();
        let name = element.attribute("name");
        let name = name.filter(|name| !name.value.is_empty());
        let name = name.map(|name| around.name(name.value));
        let owner = match &name {
            Some(name) => format!("{kind} equality `{}`", shown(name)),
            None => format!("a {kind} equality"),
        };
        let given =
            model
                .defaults
                .attributes(reader, element, &owner, ElementKind::Equality, Class::MAIN);
        let active = given.keyword(reader, "active", &TRUTH);
        Self {
            around,
            active: active.is_none_or(|active| active.value == Switch::On),
            element,
            given,
            owner,
            name,
        }
    }

    fn is_left_out(&self, model: &Model<'_>) -> bool {
        let reading = model.reading;
        let named = |name: &str| reading.leave_out.contains(name);
        reading.leaves_out(LeftOut::Equalities)
            || named(self.element.name())
            || self.name.as_deref().is_some_and(named)
    }

    fn leave_out(&self, reader: &mut Reader, message: String) {
        let name = self.name.as_deref().unwrap_or(self.element.name());
        let span = self.element.span();
        left_out(reader, message, span, (PLURAL, name));
    }

    fn refuse(&self, reader: &mut Reader, message: &str, label: &str) {
        let fault = Diagnostic::error(format!("{message}; {label}"));
        let fault = fault.at(self.element.span(), "not supported");
        let kind = self.element.name();
        reader.faults.push(fault.help(match &self.name {
            Some(name) => advice(name),
            None => format!(
                "`--leave-out {kind}` leaves out all of its kind; with a `name` it can be left out alone"
            ),
        }));
    }

    /// True where all that the equality names is there.
    fn is_within(&self, names: &Names<'_>) -> bool {
        let named = |name: &str| {
            let text = self.given.text(name)?;
            // Neither is the name of something that is copied.
            let is_copied = !matches!(text.value, "" | "world");
            is_copied.then(|| self.around.name(text.value))
        };
        let joint = |name: &str| named(name).is_none_or(|name| names.joints.contains(&*name));
        let place = |name: &str| named(name).is_none_or(|name| names.places.contains(&name));
        joint("joint1")
            && joint("joint2")
            && ["body1", "body2", "site1", "site2"].into_iter().all(place)
    }

    /// True where one of the two ends is a body that follows motion capture.
    fn follows(&self, captured: &Captured) -> bool {
        let is_among = |name: &str, known: &BTreeSet<String>| {
            let text = self.given.text(name);
            text.is_some_and(|text| known.contains(&self.around.name(text.value)))
        };
        let is_body = |name| is_among(name, &captured.bodies);
        let is_site = |name| is_among(name, &captured.sites);
        ["body1", "body2"].into_iter().any(is_body) || ["site1", "site2"].into_iter().any(is_site)
    }

    /// Ties joints, where the equality is linear.
    fn tie(&self, reader: &mut Reader, ties: &mut Ties) {
        let Some(joint) = self.given.text("joint1") else {
            let message = format!("{} has no attribute `joint1`", self.owner);
            let fault = Diagnostic::error(message).at(self.element.span(), "`joint1` is missing");
            reader.faults.push(fault);
            return;
        };
        if joint.value.is_empty() {
            let message = format!("`joint1` of {} is empty", self.owner);
            let fault = Diagnostic::error(message).at(joint.span, "expected a hinge or a slide");
            reader.faults.push(fault);
            return;
        }
        let coefficients = self.given.up_to(reader, "polycoef", 5);
        if coefficients.is_none() && self.given.has("polycoef") {
            return;
        }
        // What is not given keeps its value: joints that move alike.
        let mut polynomial = [0.0, 1.0, 0.0, 0.0, 0.0];
        for (place, given) in polynomial.iter_mut().zip(coefficients.unwrap_or_default()) {
            *place = given.value;
        }
        let leader = self.given.text("joint2");
        let leader = leader.filter(|leader| !leader.value.is_empty());
        if leader.is_some() && polynomial[2..] != [0.0; 3] {
            let message = format!("{} is active and not linear", self.owner);
            self.refuse(reader, &message, "such constraints are not supported");
            return;
        }
        let owned = |name: Spanned<&str>| Spanned::new(self.around.name(name.value), name.span);
        ties.add(
            reader,
            &Equation {
                joint: owned(joint),
                leader: leader.map(owned),
                shift: polynomial[0],
                factor: polynomial[1],
                owner: self.owner.clone(),
                span: self.element.span(),
            },
        );
    }
}
