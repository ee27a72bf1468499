//! Coordinates that follow others: each is traced to the free coordinate at the end of its chain.

use std::collections::BTreeMap;

use crate::description::{Description, Mimic, cycles::cycles};
use crate::diagnostic::{Diagnostic, Escaped, NearNames};
use crate::tree::joints::resolved::{Freedom, ResolvedJoint};
use crate::tree::names::{by_joints, joint_name, joint_named, meant, shown_joint};

/// The most joints of a cycle that are named behind the first.
const MOST_TOLD: usize = 8;

/// The joints with every mimicking coordinate following a free one, or held where that one is held.
pub(crate) fn follow(
    description: &Description,
    joints: Vec<ResolvedJoint>,
    findings: &mut Vec<Diagnostic>,
) -> Vec<ResolvedJoint> {
    let followers = followers(description, &joints, findings);
    let joints = joints.into_iter().zip(followers);
    joints
        .map(|(joint, follower)| match follower {
            Some((place, follows)) => {
                joint.with_motions(
                    |motion, freedom| {
                        if motion == place { follows } else { freedom }
                    },
                )
            }
            None => joint,
        })
        .collect()
}

/// Of every joint the place of the motion that mimics another, and what it does; `None` where none does.
fn followers(
    description: &Description,
    joints: &[ResolvedJoint],
    findings: &mut Vec<Diagnostic>,
) -> Vec<Option<(usize, Freedom)>> {
    let mut names = JointNames::of(description);
    let links: Vec<Option<Mimicking>> = (0..joints.len())
        .map(|body| link(description, joints, body, &mut names, findings))
        .collect();
    let leaders: Vec<Option<usize>> = links
        .iter()
        .map(|link| Some(link.as_ref()?.leader))
        .collect();
    let mut is_on_cycle = vec![false; links.len()];
    for chain in cycles(&leaders) {
        findings.push(cycle(description, &chain));
        for body in chain {
            is_on_cycle[body] = true;
        }
    }
    let followers = (0..joints.len()).map(|body| {
        let followed = followed(&links, &is_on_cycle, body)?;
        let (motion, freedom) = follower(joints, body, followed)?;
        if is_finite(freedom) {
            return Some((motion, freedom));
        }
        findings.push(too_large(description, body));
        None
    });
    followers.collect()
}

/// What a joint follows at the end of its chain; nothing where it mimics none, or the chain runs in a circle.
fn followed(links: &[Option<Mimicking>], is_on_cycle: &[bool], body: usize) -> Option<Mimicking> {
    let mut to = links[body].filter(|_| !is_on_cycle[body])?;
    while let Some(next) = links[to.leader] {
        if is_on_cycle[to.leader] {
            return None;
        }
        to.offset += to.multiplier * next.offset;
        to.multiplier *= next.multiplier;
        to.leader = next.leader;
    }
    Some(to)
}

/// What the joint of a body does that follows another's; nothing where it is held.
fn follower(
    joints: &[ResolvedJoint],
    body: usize,
    followed: Mimicking,
) -> Option<(usize, Freedom)> {
    let Mimicking {
        motion,
        leader,
        multiplier,
        offset,
    } = followed;
    let leading = joints[leader].leading?;
    let span = match joints[body].motions[motion] {
        Freedom::Free(span) | Freedom::Follows { span, .. } => span,
        Freedom::Locked(_) => return None,
    };
    let freedom = match joints[leader].motions[leading] {
        Freedom::Locked(value) => Freedom::Locked(multiplier * value + offset + 0.0),
        _ if multiplier == 0.0 => Freedom::Locked(offset),
        _ => Freedom::Follows {
            body: leader,
            motion: leading,
            multiplier,
            offset,
            span,
        },
    };
    Some((motion, freedom))
}

/// Whether the numbers of a chain fit.
fn is_finite(freedom: Freedom) -> bool {
    match freedom {
        Freedom::Free(_) => true,
        Freedom::Locked(value) => value.is_finite(),
        Freedom::Follows {
            multiplier, offset, ..
        } => multiplier.is_finite() && offset.is_finite(),
    }
}

/// The names by which joints can be followed.
struct JointNames<'d> {
    /// Of each name the first body whose joint has it.
    places: BTreeMap<&'d str, usize>,
    /// Of names that are none, the one that was meant.
    near: NearNames,
}

impl<'d> JointNames<'d> {
    fn of(description: &'d Description) -> Self {
        let mut places = BTreeMap::new();
        for body in by_joints(description) {
            if let Some(name) = joint_name(description, body) {
                places.entry(name).or_insert(body);
            }
        }
        Self {
            places,
            near: NearNames::default(),
        }
    }

    /// What to say of a name that is none: whose joint is called otherwise, which was probably meant, or which there are, of those that
    /// can be followed.
    fn meant(
        &mut self,
        description: &Description,
        name: &str,
        can_be_followed: impl Fn(usize) -> bool,
    ) -> Option<String> {
        let of_body = joint_named(description, name).and_then(|body| joint_name(description, body));
        if let Some(joint) = of_body {
            let (name, joint) = (name.escaped(), joint.escaped());
            return Some(format!("the joint of the body `{name}` is `{joint}`"));
        }
        let known = self
            .places
            .iter()
            .filter(|(_, body)| can_be_followed(**body));
        let known: Vec<&str> = known.map(|(name, _)| *name).collect();
        meant(
            name,
            &known,
            &mut self.near,
            "the joints that it can follow",
        )
    }
}

/// A coordinate and the joint that it names.
#[derive(Clone, Copy)]
struct Mimicking {
    motion: usize,
    leader: usize,
    multiplier: f64,
    offset: f64,
}

/// What the joint of a body follows, if it can.
fn link(
    description: &Description,
    joints: &[ResolvedJoint],
    body: usize,
    names: &mut JointNames<'_>,
    findings: &mut Vec<Diagnostic>,
) -> Option<Mimicking> {
    let mimic = description.bodies[body].joint.mimic.as_ref()?;
    let Mimic {
        joint,
        multiplier,
        offset,
    } = &mimic.value;
    if joints[body].is_fixed() {
        return None;
    }
    let name = shown_joint(description, body);
    let Some(motion) = joints[body].leading else {
        let fault = format!("{name} mimics another, but has more than one free coordinate");
        findings
            .push(Diagnostic::error(fault).at(mimic.span, "one coordinate can follow one other"));
        return None;
    };
    let Some(&leader) = names.places.get(joint.value.as_str()) else {
        let fault = format!(
            "{name} mimics `{}`, which is no joint",
            joint.value.escaped()
        );
        let help = names.meant(description, &joint.value, |other| {
            other != body && joints[other].leading.is_some()
        });
        let fault = Diagnostic::error(fault).at(joint.span, "unknown joint");
        findings.push(fault.help_if(help));
        return None;
    };
    let kind = description.bodies[leader].joint.kind.as_ref();
    let is_fixed = kind.is_some_and(|kind| kind.value.is_fixed());
    if joints[leader].leading.is_none() {
        let has = if is_fixed {
            "no coordinate"
        } else {
            "more than one coordinate"
        };
        let fault = format!("{name} mimics `{}`, which has {has}", joint.value.escaped());
        findings.push(
            Diagnostic::error(fault).at(joint.span, "expected a joint with one free coordinate"),
        );
        return None;
    }
    Some(Mimicking {
        motion,
        leader,
        multiplier: *multiplier,
        offset: *offset,
    })
}

/// A joint that follows another by numbers that do not fit.
fn too_large(description: &Description, body: usize) -> Diagnostic {
    let name = shown_joint(description, body);
    let fault =
        format!("{name} follows another by numbers whose products do not fit a 64-bit float");
    let fault = Diagnostic::error(fault);
    let mimic = description.bodies[body].joint.mimic.as_ref();
    fault.at_if(mimic.map(|mimic| mimic.span), "expected smaller numbers")
}

fn cycle(description: &Description, chain: &[usize]) -> Diagnostic {
    let name = |body: &usize| {
        joint_name(description, *body)
            .map_or_else(String::new, |name| format!("`{}`", name.escaped()))
    };
    let [first, rest @ ..] = chain else {
        return Diagnostic::error("joints mimic one another");
    };
    let others: Vec<String> = rest.iter().take(MOST_TOLD).map(name).collect();
    let others = match rest.len().saturating_sub(MOST_TOLD) {
        0 => others.join(", which mimics "),
        more => format!(
            "{}, and so on for {more} more",
            others.join(", which mimics ")
        ),
    };
    let fault = match rest {
        [] => format!("{} mimics itself", name(first)),
        _ => format!(
            "joints mimic one another: {first} mimics {others}, which mimics {first}",
            first = name(first)
        ),
    };
    let places = chain.iter().take(MOST_TOLD).filter_map(|body| {
        let mimic = description.bodies[*body].joint.mimic.as_ref()?;
        Some((mimic.value.joint.span, *body))
    });
    let fault = places.fold(Diagnostic::error(fault), |fault, (span, body)| {
        fault.at(span, format!("mimicked by {}", name(&body)))
    });
    fault.help("one joint of the cycle must be free")
}
