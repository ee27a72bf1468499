//! How the links hang from one another.
//!
//! In: links and joints, in the order of the file. Out: of each link the joint by which it hangs, and the links depth
//! first from the root, where they form a tree. Afterwards: every breach of the tree is among the faults, but for
//! those that another one explains: a link whose joint names it wrongly is no second root.

use std::collections::BTreeMap;

use crate::description::cycles::cycles;
use crate::description::urdf::joint::JointElement;
use crate::description::urdf::link::LinkElement;
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, NearNames, Spanned, shown};

/// The most links of a cycle, or roots, that a message names.
const MOST_NAMED: usize = 8;

/// The link that some readers know without its being declared.
const WORLD: &str = "world";

/// How the links hang from one another.
pub(super) struct Hung {
    /// Of each link the place of the joint by which it hangs; `None` for a root.
    pub(super) joint_of: Vec<Option<usize>>,
    /// The links depth first; `None` where they form no tree.
    pub(super) order: Option<Vec<HungLink>>,
}

/// A link among the bodies.
pub(super) struct HungLink {
    /// The place in the file.
    pub(super) link: usize,
    /// The number of the lower body from 1, or 0 for the inertial frame.
    pub(super) lower: usize,
}

/// Hangs the links from one another by the joints.
pub(super) fn hang(
    reader: &mut Reader,
    links: &[LinkElement<'_>],
    joints: &[JointElement<'_>],
) -> Hung {
    let mut ends = Ends::new(links);
    let mut joint_of: Vec<Option<usize>> = vec![None; links.len()];
    let mut lower_of: Vec<Option<usize>> = vec![None; links.len()];
    let mut joints_on: Vec<Vec<usize>> = vec![Vec::new(); links.len()];
    let mut child_of: Vec<Option<usize>> = Vec::with_capacity(joints.len());
    let mut is_single = true;
    for (place, joint) in joints.iter().enumerate() {
        let lower = ends.find(reader, joint, joint.parent, "parent");
        let link = ends.find(reader, joint, joint.child, "child");
        child_of.push(link);
        let Some(link) = link else { continue };
        if let Some(first) = joint_of[link] {
            is_single = false;
            reader.faults.push(two_parents(&joints[first], joint));
            continue;
        }
        joint_of[link] = Some(place);
        lower_of[link] = lower;
        if let Some(lower) = lower {
            joints_on[lower].push(place);
        }
    }
    let cycles = cycles(&lower_of);
    for cycle in &cycles {
        reader
            .faults
            .push(hang_in_a_cycle(cycle, links, joints, &joint_of));
    }
    let roots: Vec<usize> = (0..links.len())
        .filter(|link| joint_of[*link].is_none())
        .collect();
    // A link that a joint fails to name is a root without meaning it.
    // A link with two parents may have the one that another should have.
    if ends.all_found && is_single && roots.len() > 1 {
        reader.faults.push(several_roots(&roots, links));
    }
    let is_tree = ends.all_found && is_single && cycles.is_empty();
    let order = match roots.as_slice() {
        [root] if is_tree => {
            for on in &mut joints_on {
                on.sort_by_key(|joint| joints[*joint].name.map(|name| name.value));
            }
            Some(depth_first(*root, &lower_of, &joints_on, &child_of))
        }
        _ => None,
    };
    Hung { joint_of, order }
}

/// Looks up the links that joints name.
struct Ends<'d> {
    places: BTreeMap<&'d str, usize>,
    /// True where every link has a name of its own: else one that is not found may be that of a link without.
    all_named: bool,
    /// True while every name was that of a link, and every link has one.
    all_found: bool,
    /// Of names that are not that of a link, the one that was meant.
    near: NearNames,
}

impl<'d> Ends<'d> {
    fn new(links: &[LinkElement<'d>]) -> Self {
        let names = links.iter().map(|link| link.name);
        let places = names.enumerate();
        let places = places.filter_map(|(place, name)| Some((name?.value, place)));
        let places: BTreeMap<&str, usize> = places.collect();
        let all_named = places.len() == links.len();
        Self {
            places,
            all_named,
            all_found: all_named,
            near: NearNames::default(),
        }
    }

    fn find(
        &mut self,
        reader: &mut Reader,
        joint: &JointElement<'_>,
        name: Option<Spanned<&str>>,
        end: &str,
    ) -> Option<usize> {
        let place = name.and_then(|name| self.places.get(name.value).copied());
        self.all_found &= place.is_some();
        if let (Some(name), None, true) = (name, place, self.all_named) {
            let link = shown(name.value);
            let fault = format!(
                "`{end}` of {} is link `{link}`, which is not defined",
                joint.words
            );
            let mut fault = Diagnostic::error(fault).at(name.span, "unknown link");
            if name.value == WORLD && end == "parent" {
                fault = fault.help(format!("add `<link name=\"{WORLD}\"/>`"));
            } else if let Some(near) = self.near.nearest(name.value, self.places.keys().copied()) {
                fault = fault.help(format!("did you mean `{near}`?"));
            }
            reader.faults.push(fault);
        }
        place
    }
}

fn two_parents(first: &JointElement<'_>, second: &JointElement<'_>) -> Diagnostic {
    let link = shown(second.child.map_or("", |name| name.value));
    let parent = |joint: &JointElement<'_>| match joint.parent {
        Some(name) => format!("`{}` by {}", shown(name.value), joint.words),
        None => format!("that of {}", joint.words),
    };
    let [first_parent, second_parent] = [first, second].map(parent);
    let fault = Diagnostic::error(format!(
        "link `{link}` has two parents, {first_parent} and {second_parent}; expected one"
    ));
    let fault = fault.help(
        "closed loops are not supported: leave one of the joints out, and close the loop where the module is called",
    );
    let labels = [(second, "the second one"), (first, "the first one")];
    labels.into_iter().fold(fault, |fault, (joint, label)| {
        let name = joint.child.or(joint.parent);
        fault.at_if(name.map(|name| name.span), label)
    })
}

fn hang_in_a_cycle(
    cycle: &[usize],
    links: &[LinkElement<'_>],
    joints: &[JointElement<'_>],
    joint_of: &[Option<usize>],
) -> Diagnostic {
    let name = |link: &usize| format!("`{}`", shown(links[*link].name.map_or("", |n| n.value)));
    let mut named: Vec<String> = cycle.iter().skip(1).take(MOST_NAMED).map(name).collect();
    if cycle.len() > MOST_NAMED + 1 {
        named.push(format!("{} more", cycle.len() - MOST_NAMED - 1));
    }
    named.extend(cycle.first().map(name));
    let first = cycle.first().map(name).unwrap_or_default();
    let fault = Diagnostic::error(format!(
        "the links form a cycle: {first} hangs from {}",
        named.join(", that from ")
    ));
    let hung_by = cycle
        .iter()
        .take(MOST_NAMED)
        .filter_map(|link| joint_of[*link]);
    let fault = hung_by.fold(fault, |fault, joint| {
        let JointElement { parent, words, .. } = &joints[joint];
        fault.at_if(parent.map(|name| name.span), format!("parent of {words}"))
    });
    fault.help("closed loops are not supported: every link hangs from one root link")
}

fn several_roots(roots: &[usize], links: &[LinkElement<'_>]) -> Diagnostic {
    let named = roots.iter().take(MOST_NAMED).map(|root| &links[*root]);
    let mut names: Vec<String> = named
        .clone()
        .map(|link| format!("`{}`", shown(link.name.map_or("", |name| name.value))))
        .collect();
    if roots.len() > MOST_NAMED {
        names.push(format!("{} more", roots.len() - MOST_NAMED));
    }
    let fault = Diagnostic::error(format!(
        "the robot has {} root links, {}; expected one, from which all others hang",
        roots.len(),
        names.join(", ")
    ));
    named.fold(fault, |fault, link| {
        fault.at(link.span(), "no joint has this link as its child")
    })
}

/// The links from the root on, each followed by all that hangs from it, in the order of the joints on it.
fn depth_first(
    root: usize,
    lower_of: &[Option<usize>],
    joints_on: &[Vec<usize>],
    child_of: &[Option<usize>],
) -> Vec<HungLink> {
    let mut numbers = vec![0; lower_of.len()];
    let mut order = Vec::with_capacity(lower_of.len());
    let mut waiting = vec![root];
    while let Some(link) = waiting.pop() {
        let lower = lower_of[link].map_or(0, |lower| numbers[lower]);
        order.push(HungLink { link, lower });
        numbers[link] = order.len();
        waiting.extend(
            joints_on[link]
                .iter()
                .rev()
                .filter_map(|joint| child_of[*joint]),
        );
    }
    order
}
