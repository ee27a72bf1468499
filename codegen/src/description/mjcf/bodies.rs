//! `worldbody`: the bodies, depth first, in the order of the file.

use std::collections::BTreeSet;

use crate::description::mjcf::chain::{Bodies, JointedBody};
use crate::description::mjcf::contents::around::Around;
use crate::description::mjcf::contents::{Contents, Inside, gather};
use crate::description::mjcf::fused;
use crate::description::mjcf::joints::joint_type::JointType;
use crate::description::mjcf::joints::{self, JointElement};
use crate::description::mjcf::known;
use crate::description::mjcf::lifted;
use crate::description::mjcf::mass::geoms;
use crate::description::mjcf::mass::weight::Weighed;
use crate::description::mjcf::model::Model;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::defaults::ElementKind;
use crate::description::mjcf::model::models::Models;
use crate::description::mjcf::model::settings::{Switch, TRUTH};
use crate::description::mjcf::names::Wish;
use crate::description::mjcf::orientation::placement;
use crate::description::mjcf::placement::Placement;
use crate::description::mjcf::sites::Site;
use crate::description::too_many;
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Span, shown};
use crate::limits::BODIES;

/// A body that is still to be read.
struct Pending<'d> {
    inside: Inside<'d>,
    /// The number of its lower body.
    lower: usize,
    lower_moves: bool,
}

/// The bodies of all models, and what stands on them.
#[derive(Default)]
pub(super) struct Found<'d> {
    pub(super) bodies: Bodies,
    pub(super) sites: Vec<Site<'d>>,
    /// The bodies that follow motion capture.
    pub(super) captured: Captured,
    /// What is around each copy of elements, and each model that is attached.
    pub(super) copies: Vec<Around>,
    /// Where joints leave it to actuators to lift weights.
    by_actuators: Vec<Span>,
}

/// Names of bodies that follow motion capture, and of the sites on them.
#[derive(Default)]
pub(super) struct Captured {
    pub(super) bodies: BTreeSet<String>,
    pub(super) sites: BTreeSet<String>,
}

/// Reads the bodies of all `worldbody` elements, and the sites in them.
pub(super) fn read<'d>(reader: &mut Reader, models: &Models<'d>) -> Found<'d> {
    let mut found = Found::default();
    let mut pending = Vec::new();
    for world in models.main().named("worldbody").into_iter().rev() {
        let contents = gather(reader, models, world, "the world", Around::world());
        for inside in contents.joints.iter().chain(&contents.inertials) {
            let message = format!(
                "the world has a `{}`; expected it in a body",
                inside.element.name()
            );
            let fault = Diagnostic::error(message).at(inside.element.span(), "in the world");
            reader.faults.push(fault);
        }
        for geom in &contents.geoms {
            geoms::attributes(reader, models, geom, "the world");
        }
        let bodies = found.keep(contents);
        push(&mut pending, bodies, 0, false);
    }
    while let Some(next) = pending.pop() {
        if models.copies.is_exhausted() {
            break;
        }
        let count = found.bodies.count();
        if let Some(fault) = too_many("the number of bodies is at least", count + 1) {
            let place = next.inside.element.span();
            reader.faults.push(fault.at(place, "one too many"));
            break;
        }
        let (contents, moves) = body(reader, models, &next, &mut found);
        let bodies = found.keep(contents);
        push(&mut pending, bodies, found.bodies.count(), moves);
    }
    fused::settle(reader, models, &mut found.bodies);
    lifted::settle(reader, &mut found.bodies, &found.by_actuators);
    found
}

impl<'d> Found<'d> {
    /// True where another model is attached.
    pub(super) fn attaches(&self) -> bool {
        self.copies.iter().any(|around| around.model != 0)
    }

    /// Keeps what stands in the last body; gives the bodies in it, which are still to be read.
    fn keep(&mut self, contents: Contents<'d>) -> Vec<Inside<'d>> {
        let body = self.bodies.count();
        let sites = contents.sites.into_iter();
        self.sites.extend(sites.map(|inside| Site { inside, body }));
        self.copies.extend(contents.copies);
        contents.bodies
    }
}

/// The first comes out first.
fn push<'d>(
    pending: &mut Vec<Pending<'d>>,
    bodies: Vec<Inside<'d>>,
    lower: usize,
    lower_moves: bool,
) {
    pending.extend(bodies.into_iter().rev().map(|inside| Pending {
        inside,
        lower,
        lower_moves,
    }));
}

/// Reads a body, and adds it, behind those that its joints make: what stands in it, and whether it moves.
fn body<'d>(
    reader: &mut Reader,
    models: &Models<'d>,
    next: &Pending<'d>,
    found: &mut Found<'_>,
) -> (Contents<'d>, bool) {
    let element = next.inside.element;
    let name = next.inside.name();
    let owner = match &name {
        Some(name) => format!("body `{}`", shown(&name.value)),
        None => "a body without a name".to_owned(),
    };
    let given = Attributes::of(reader, element, &owner, &known::BODY);
    let around = &next.inside.around;
    let model = &models.list[around.model];
    let inner = Around {
        frame: Placement::SAME,
        class: model.child_class(reader, &given, around.class),
        ..around.clone()
    };
    let contents = gather(reader, models, element, &owner, inner);
    let own = placement(reader, &given, &model.settings);
    let place = around.frame.then(&own);
    let is_captured = warn_of_mocap(reader, &given);
    if is_captured {
        let body = name.iter().map(|name| name.value.clone());
        found.captured.bodies.extend(body);
        let sites = contents.sites.iter().filter_map(Inside::name);
        found.captured.sites.extend(sites.map(|name| name.value));
    }
    let joints: Vec<JointElement> = contents
        .joints
        .iter()
        .take(BODIES + 1)
        .map(|inside| joint(reader, &models.list[inside.around.model], inside, &owner))
        .collect();
    check_freedoms(reader, &joints, &owner);
    check_free(reader, model, &joints, next, &contents.bodies, &owner);
    let moves = next.lower_moves || !joints.is_empty();
    let wish = match name {
        Some(name) => Wish::Given(name),
        None => Wish::None(element.span()),
    };
    let own_word = given.keyword(reader, "fuse", &TRUTH);
    let is_apart = own_word.is_some_and(|own| own.value == Switch::Off);
    let fuses = models.main().settings.fuse.is_some();
    let is_fused = fuses && joints.is_empty() && !is_captured && !is_apart;
    let weighed = Weighed {
        owner: &owner,
        span: element.span(),
        around,
        contents: &contents,
        place: &own,
        moves,
    };
    let weight = weighed.weight(reader, models);
    let lifted = lifted::of_body(reader, models.main(), &given);
    let by_actuators = joints.iter().filter_map(JointElement::by_actuator);
    found.by_actuators.extend(by_actuators);
    found.bodies.add(JointedBody {
        joints,
        place,
        span: given.span,
        lower: next.lower,
        wish,
        weight,
        is_fused,
        lifted,
    });
    (contents, moves)
}

/// Whether a body follows motion capture, with a warning.
fn warn_of_mocap(reader: &mut Reader, given: &Attributes<'_>) -> bool {
    let mocap = given.keyword(reader, "mocap", &TRUTH);
    let mocap = mocap.filter(|mocap| mocap.value == Switch::On);
    if let Some(mocap) = &mocap {
        let message = format!(
            "{} follows motion capture; it is taken as fixed",
            given.owner
        );
        let warning = Diagnostic::warning(message).at(mocap.span, "fixed");
        let plural = "bodies that follow motion capture are taken as fixed";
        let warning = warning.one_of(plural, &*given.owner);
        reader.faults.push(warning);
    }
    mocap.is_some()
}

fn joint(reader: &mut Reader, model: &Model<'_>, inside: &Inside<'_>, body: &str) -> JointElement {
    let element = inside.element;
    let owner = inside.owner("joint", body);
    for child in model.files.children(element) {
        reader.unknown_child(child, &owner, &[]);
    }
    if element.name() == "freejoint" {
        let given = Attributes::of(reader, element, &owner, &known::FREE_JOINT);
        let joint = joints::read_free(reader, &given, model.reading.chart);
        return joint.named(inside.name());
    }
    let given = model.defaults.attributes(
        reader,
        element,
        &owner,
        ElementKind::Joint,
        inside.around.class,
    );
    let joint = joints::read(
        reader,
        &given,
        &model.settings,
        &inside.around.frame,
        model.reading.chart,
    );
    joint.named(inside.name())
}

/// As in MuJoCo a body has no more than six freedoms, and no joint turns it after a ball joint.
fn check_freedoms(reader: &mut Reader, joints: &[JointElement], owner: &str) {
    let freedoms = |joint: &JointElement| match joint.kind {
        JointType::Hinge | JointType::Slide => 1,
        JointType::Ball => 3,
        JointType::Free => 6,
    };
    // A free joint beside others is told below.
    let others = joints.iter().filter(|joint| joint.kind != JointType::Free);
    let (mut count, mut after_ball) = (0, false);
    for joint in others {
        count += freedoms(joint);
        let message = if count > 6 {
            format!("the joints of {owner} have more than six freedoms")
        } else if after_ball && matches!(joint.kind, JointType::Hinge | JointType::Ball) {
            format!("{owner} has a hinge or ball joint after a ball joint")
        } else {
            after_ball |= joint.kind == JointType::Ball;
            continue;
        };
        let fault = Diagnostic::error(message).at(joint.span, "MuJoCo refuses this joint");
        reader.faults.push(fault);
        return;
    }
}

/// A free joint is alone, and joins a body to the world.
fn check_free(
    reader: &mut Reader,
    model: &Model<'_>,
    joints: &[JointElement],
    next: &Pending<'_>,
    carries: &[Inside<'_>],
    owner: &str,
) {
    let Some(free) = joints.iter().find(|joint| joint.kind == JointType::Free) else {
        return;
    };
    let mut refuse = |message: String, label: &str| {
        let fault = Diagnostic::error(message).at(free.span, label);
        reader.faults.push(fault);
    };
    if next.lower != 0 {
        refuse(
            format!("{owner} has a free joint, but does not stand in the world"),
            "expected another joint",
        );
    }
    if joints.len() > 1 {
        refuse(
            format!("{owner} has a free joint beside other joints"),
            "expected no other joint",
        );
    }
    // MuJoCo aligns only bodies that carry no other.
    let aligned = free.align.unwrap_or(model.settings.align_free);
    if aligned == Switch::On && carries.is_empty() {
        refuse(
            format!(
                "the free joint of {owner} is aligned with its inertia, which is not supported"
            ),
            "write `align=\"false\"`",
        );
    }
}
