//! The tree of a description in which nothing is missing: bodies with all that is fixed to them, in axes of our choice.

use crate::description::{Body as Written, Chart as ChartKind, Description, Rotation};
use crate::diagnostic::{Diagnostic, Spanned};
use crate::geometry;
use crate::id::{BodyId, CoordinateId, SpeedId};
use crate::limits::{FOLLOWING, PARAMETERS};
use crate::tree::resolve::{Freedom, Resolved};
use crate::tree::snapping::Snapping;
use crate::tree::values::Parameters;
use crate::tree::{
    Body, Changes, Chart, Coordinate, Frame, Joint, Offset, Orientation, Part, Pose, Step, Tree,
    Value, coupled, mechanics, names, numbering, places, rotation,
};

/// Where a written body's own frame is: in which body of the tree, and where there.
#[derive(Clone)]
struct Placed {
    host: Option<BodyId>,
    pose: Pose,
}

/// The tree; `order` holds the places of bodies in the user's list, from the inertial frame outward.
pub(crate) fn assemble(
    description: &Description,
    order: &[usize],
    joints: &[Resolved],
    changes: &Changes,
    findings: &mut Vec<Diagnostic>,
) -> Option<Tree> {
    let lower_bodies = &description.lower_bodies.as_ref()?.value;
    let names: Vec<Spanned<String>> = order
        .iter()
        .map(|place| description.bodies[*place].name.clone())
        .collect::<Option<_>>()?;
    let identifiers = names::identifiers(&names, findings);

    let mut builder = Builder {
        snapping: Snapping::new(changes.snap),
        parameters: Parameters::default(),
        bodies: Vec::new(),
        frames: Vec::new(),
    };
    let gravity = builder
        .parameters
        .vector(&description.gravity, "gravity", None, "m/s^2")?;
    let mut placed: Vec<Option<Placed>> = vec![None; order.len()];
    for ((old, name), identifier) in order.iter().zip(names).zip(identifiers) {
        let lower = usize::try_from(lower_bodies.get(*old)?.as_ref()?.value).ok()?;
        let below = match lower.checked_sub(1) {
            None => Placed {
                host: None,
                pose: Pose {
                    rotation: geometry::IDENTITY,
                    origin: Offset::default(),
                },
            },
            Some(lower) => placed.get(lower)?.clone()?,
        };
        let new = New {
            written: &description.bodies[*old],
            joint: &joints[*old],
            user_number: old + 1,
            name: name.value,
            identifier,
        };
        placed[*old] = Some(builder.place(new, &below)?);
        let n_parameters = builder.parameters.list.len();
        if n_parameters > PARAMETERS {
            let fault = format!(
                "the model has at least {n_parameters} values that are set at run time; expected at most {PARAMETERS}"
            );
            let place = description.bodies[*old].span;
            findings.push(Diagnostic::error(fault).at(place, "too many"));
            return None;
        }
    }
    let host = |old: usize| placed[old].as_ref().and_then(|placed| placed.host);
    let mut bodies = builder.bodies;
    let numbers = places::number(&mut bodies, description.order?.value);
    places::follow(&mut bodies, joints, &host);

    builder.snapping.report(findings);
    numbering::note_moved(description, &bodies, findings);
    let mut tree = Tree {
        name: description.name.as_ref()?.value.clone(),
        gravity,
        order: description.order?.value,
        bodies,
        frames: Vec::new(),
        snap: changes.snap,
        parameters: builder.parameters.list,
        n_coordinates: numbers.coordinates,
        n_speeds: numbers.speeds,
    };
    let (n_bodies, n_speeds) = (tree.bodies.len(), tree.n_speeds);
    if coupled::has_followers(&tree) && n_bodies.max(n_speeds) > FOLLOWING {
        findings.push(Diagnostic::error(format!(
            "the system, in which joints follow others, has {n_bodies} bodies that move and {n_speeds} speeds; \
            expected at most {FOLLOWING} of each"
        )));
        return None;
    }
    tree.frames = frames(&tree, &builder.frames);
    note_merged(&tree, findings);
    names::check_coordinates(&tree, findings);
    names::note_order(&tree, findings);
    Some(tree)
}

/// A body on its way into the tree.
struct New<'a> {
    written: &'a Written,
    joint: &'a Resolved,
    user_number: usize,
    name: String,
    identifier: String,
}

struct Builder {
    snapping: Snapping,
    parameters: Parameters,
    bodies: Vec<Body>,
    /// Names, identifiers and poses of what is part of another body.
    frames: Vec<(String, String, Placed)>,
}

impl Builder {
    /// Adds a body to the tree, or to the body that it is fixed to.
    fn place(&mut self, new: New<'_>, below: &Placed) -> Option<Placed> {
        let New { written, joint, .. } = new;
        let moving = !joint.is_fixed();
        let id = BodyId::new(self.bodies.len());
        let host = if moving { Some(id) } else { below.host };
        let part = self.part(written, &new.identifier, host)?;
        let (attachment, body_attachment) = self.attachments(written, &new.identifier, host)?;
        let axis = format!("`axis` of `{}`", shown(written));
        self.snapping.axis(joint.axis_change, axis);
        let to_joint = self.rotation_to_joint(&new, below);
        let to_body = self.rotation_to_body(&new);
        let point = below
            .pose
            .origin
            .clone()
            .join(&Offset::new(below.pose.rotation, attachment), false);

        let mut pose = if moving {
            Pose {
                rotation: to_body,
                origin: Offset::default(),
            }
        } else {
            let turned = geometry::body_fixed_123(joint.locked(0));
            let turned = geometry::then(&geometry::then(&to_joint, &turned), &to_body);
            let shift = joint.locked(3);
            let origin = if shift == [0.0; 3] {
                point.clone()
            } else {
                let shift = Offset::new(to_joint, shift.map(Value::Baked));
                point.clone().join(&shift, false)
            };
            Pose {
                rotation: self.snapping.quietly(&turned),
                origin,
            }
        };
        if let Some(vector) = body_attachment {
            pose.origin = pose.origin.plus(Step {
                rotation: pose.rotation,
                vector,
                negative: true,
            });
        }
        let part = Part {
            mass_center: pose
                .origin
                .clone()
                .join(&part.mass_center.before(&pose.rotation), false),
            axes: self
                .snapping
                .quietly(&geometry::then(&pose.rotation, &part.axes)),
            ..part
        };
        let placed = Placed {
            host,
            pose: pose.clone(),
        };
        if moving {
            let body = self.body(new, id, below.host, (to_joint, point), (part, pose));
            self.bodies.push(body);
            if let Some(lower) = below.host {
                self.bodies[lower.index()].uppers.push(id);
            }
        } else {
            self.frames.push((new.name, new.identifier, placed.clone()));
            if let Some(host) = host {
                self.bodies[host.index()].parts.push(part);
            }
        }
        Some(placed)
    }

    /// The body itself, in its own axes.
    fn part(&mut self, written: &Written, identifier: &str, host: Option<BodyId>) -> Option<Part> {
        let quantity = |quantity: &str| format!("{identifier}_{quantity}");
        let parameters = &mut self.parameters;
        let mass = parameters.value(written.mass, quantity("mass"), host, "kg")?;
        let center = quantity("mass_center");
        let center = parameters.vector(&written.mass_center, &center, host, "m")?;
        let inertia = parameters.inertia(&written.inertia, &quantity("inertia"), host)?;
        let axes = written.inertia_rotation.map(|axes| {
            let what = format!("`inertia_rotation` of `{}`", shown(written));
            self.snapping.of(&axes.value, what)
        });
        Some(Part {
            mass,
            mass_center: Offset::new(geometry::IDENTITY, center),
            inertia,
            axes: axes.unwrap_or(geometry::IDENTITY),
        })
    }

    /// Where the joint sits in the lower body, and in the body if not in its origin.
    fn attachments(
        &mut self,
        written: &Written,
        identifier: &str,
        host: Option<BodyId>,
    ) -> Option<([Value; 3], Option<[Value; 3]>)> {
        let joint = &written.joint;
        let name = format!("{identifier}_attachment");
        let lower = self
            .parameters
            .vector(&joint.attachment, &name, host, "m")?;
        let Some(given) = &joint.body_attachment else {
            return Some((lower, None));
        };
        let name = format!("{identifier}_body_attachment");
        Some((
            lower,
            Some(self.parameters.vector(given, &name, host, "m")?),
        ))
    }

    /// From the internal axes of the body below to those of the joint's coordinates.
    fn rotation_to_joint(&mut self, new: &New<'_>, below: &Placed) -> Rotation {
        let own = new.written.joint.attachment_rotation.map(|own| {
            let what = format!("`attachment_rotation` of `{}`", shown(new.written));
            self.snapping.of(&own.value, what)
        });
        let own = geometry::then(&own.unwrap_or(geometry::IDENTITY), &new.joint.align);
        self.snapping
            .quietly(&geometry::then(&below.pose.rotation, &own))
    }

    /// From the axes of the joint's coordinates, moved, to the body's.
    fn rotation_to_body(&mut self, new: &New<'_>) -> Rotation {
        let own = new.written.joint.body_rotation.map(|own| {
            let what = format!("`body_rotation` of `{}`", shown(new.written));
            self.snapping.of(&own.value, what)
        });
        let back = geometry::transposed(&new.joint.align);
        let own = own.unwrap_or(geometry::IDENTITY);
        self.snapping.quietly(&geometry::then(&back, &own))
    }

    fn body(
        &mut self,
        new: New<'_>,
        id: BodyId,
        lower: Option<BodyId>,
        (rotation, attachment): (Rotation, Offset),
        (part, pose): (Part, Pose),
    ) -> Body {
        let New { written, joint, .. } = new;
        let mechanics = mechanics::of(&mut self.parameters, &written.joint, joint, id);
        let own_name = written.joint.name.as_ref();
        let joint = Joint {
            name: own_name.map_or_else(|| new.name.clone(), |name| name.value.clone()),
            identifier: joint.identifier.clone(),
            is_named: own_name.is_some(),
            rotation,
            attachment,
            orientation: orientation(joint),
            translations: [3, 4, 5].map(|motion| coordinate(joint.motions[motion])),
            mechanics,
        };
        Body {
            name: new.name,
            identifier: new.identifier,
            user_number: new.user_number,
            lower,
            uppers: Vec::new(),
            parts: vec![part],
            joint,
            pose,
        }
    }
}

fn shown(written: &Written) -> String {
    written
        .name
        .as_ref()
        .map_or_else(String::new, |name| name.value.escape_debug().to_string())
}

/// A place in `q` that is given later, when all bodies are there.
fn no_coordinate() -> CoordinateId {
    CoordinateId::new(0)
}

/// The same in `u`.
fn no_speed() -> SpeedId {
    SpeedId::new(0)
}

fn coordinate(freedom: Freedom) -> Coordinate {
    match freedom {
        Freedom::Locked(value) => Coordinate::Locked(value),
        Freedom::Free(_) => Coordinate::Free {
            coordinate: no_coordinate(),
            speed: no_speed(),
        },
        Freedom::Follows {
            multiplier, offset, ..
        } => Coordinate::Mimic {
            coordinate: no_coordinate(),
            speed: no_speed(),
            multiplier,
            offset,
        },
    }
}

fn orientation(joint: &Resolved) -> Orientation {
    if !joint.has_angular_velocity() {
        return Orientation::Rates([0, 1, 2].map(|motion| coordinate(joint.motions[motion])));
    }
    let chart = match joint.chart {
        ChartKind::Angles => Chart::Angles([no_coordinate(); 3]),
        ChartKind::Quaternion => Chart::EulerParameters([no_coordinate(); 4]),
    };
    Orientation::AngularVelocity {
        chart,
        speeds: [no_speed(); 3],
    }
}

/// The frames of bodies that are part of others, in the user's axes of those.
fn frames(tree: &Tree, frames: &[(String, String, Placed)]) -> Vec<Frame> {
    let inertial = Pose {
        rotation: geometry::IDENTITY,
        origin: Offset::default(),
    };
    frames
        .iter()
        .map(|(name, identifier, Placed { host, pose })| {
            let base = host.map_or(&inertial, |host| &tree.body(host).pose);
            let from = pose.origin.clone().join(&base.origin, true).nominal(tree);
            let back = geometry::transposed(&base.rotation);
            Frame {
                name: name.clone(),
                identifier: identifier.clone(),
                body: *host,
                rotation: rotation::snapped(&geometry::then(&back, &pose.rotation), tree.snap).0,
                position: geometry::apply(&base.rotation, from),
                pose: pose.clone(),
            }
        })
        .collect()
}

/// Tells which bodies are part of others.
fn note_merged(tree: &Tree, findings: &mut Vec<Diagnostic>) {
    let merged: Vec<String> = tree
        .frames
        .iter()
        .map(|frame| {
            let name = frame.name.escape_debug();
            match frame.body {
                Some(body) => format!("`{name}` of `{}`", tree.body(body).name.escape_debug()),
                None => format!("`{name}` of the inertial frame"),
            }
        })
        .collect();
    if !merged.is_empty() {
        findings.push(Diagnostic::note(format!(
            "bodies that are fixed are part of what they are fixed to: {}",
            merged.join(", ")
        )));
    }
}
