//! Which branches of the tree are alike.

use std::collections::BTreeMap;

use crate::{
    id::BodyId,
    tree::{CoordinateKind, Joint, Tree},
};

/// One is alone.
const FEWEST: usize = 2;

/// More branches are split among several teams: longer vectors are rare.
const MOST: usize = 8;

/// Longer branches stay apart: what their signs depend on grows with each body, and time with its square.
const MOST_BODIES: usize = 32;

/// Branches on one body, or on the inertial frame, that are alike and go side by side: the bodies of each.
type Team = Vec<Vec<BodyId>>;

/// A branch of a team.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Branch {
    /// Its team.
    pub(super) team: usize,
    /// Its lane there.
    pub(super) lane: usize,
}

/// All teams; no two share a body.
pub(super) struct Branches(Vec<Team>);

/// By which coordinates and speeds a joint moves.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Moves {
    coordinates: Vec<CoordinateKind>,
    /// Which of the six motions have a speed.
    motions: Vec<usize>,
    /// True where those about axes are components of an angular velocity, false where they are rates.
    has_angular_velocity: bool,
}

impl Moves {
    fn of(joint: &Joint) -> Self {
        let coordinates = joint.coordinates().into_iter();
        let motions = joint.speeds().into_iter();
        Self {
            coordinates: coordinates.map(|(kind, _)| kind).collect(),
            motions: motions.map(|(motion, _)| motion).collect(),
            has_angular_velocity: joint.angular_velocity().is_some(),
        }
    }
}

impl Branches {
    /// Branches within those of a team go with these.
    pub(super) fn of(tree: &Tree) -> Self {
        let mut teams: Vec<Team> = Vec::new();
        let kinds = kinds(tree);
        let is_root = |body: &BodyId| tree.lower(*body).is_none();
        let roots: Vec<BodyId> = tree.body_ids().filter(is_root).collect();
        let mut is_taken = vec![false; tree.bodies.len()];
        let bodies = tree.body_ids().map(Some);
        for lower in std::iter::once(None).chain(bodies) {
            let uppers = match lower {
                None => &roots[..],
                Some(lower) if is_taken[lower.index()] => continue,
                Some(lower) => tree.uppers(lower),
            };
            for own in teams_of(tree, &kinds, uppers) {
                for body in own.iter().flatten() {
                    is_taken[body.index()] = true;
                }
                teams.push(own);
            }
        }
        Self(teams)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many branches each team has.
    pub(super) fn lanes(&self) -> impl Iterator<Item = usize> {
        self.0.iter().map(Vec::len)
    }

    /// How many branches a team has.
    pub(super) fn lanes_of(&self, team: usize) -> usize {
        self.0[team].len()
    }

    /// The branch of each body that is in one, and its place there.
    pub(super) fn by_body(&self) -> BTreeMap<BodyId, (Branch, usize)> {
        let places = self.all().flat_map(|(branch, bodies)| {
            let bodies = bodies.iter().enumerate();
            bodies.map(move |(place, body)| (*body, (branch, place)))
        });
        places.collect()
    }

    /// Each branch with its bodies, which are in the same order for all of a team.
    pub(super) fn all(&self) -> impl Iterator<Item = (Branch, &[BodyId])> {
        self.0.iter().enumerate().flat_map(|(team, branches)| {
            let branches = branches.iter().enumerate();
            branches.map(move |(lane, bodies)| (Branch { team, lane }, &bodies[..]))
        })
    }
}

/// The teams of branches that begin with these bodies.
fn teams_of(tree: &Tree, kinds: &[usize], uppers: &[BodyId]) -> Vec<Team> {
    let mut by_kind: BTreeMap<usize, Vec<BodyId>> = BTreeMap::new();
    for &upper in uppers {
        let own = by_kind.entry(kinds[upper.index()]);
        own.or_default().push(upper);
    }
    let mut alike: Vec<Vec<BodyId>> = by_kind.into_values().collect();
    let bodies = |first| branch(tree, kinds, first);
    alike.retain(|own| own.len() >= FEWEST && bodies(own[0]).len() <= MOST_BODIES);
    alike.sort();
    let teams = alike.iter().flat_map(|own| {
        let n_teams = own.len().div_ceil(MOST);
        let start = move |team: usize| team * own.len() / n_teams;
        (0..n_teams).map(move |team| {
            let own = &own[start(team)..start(team + 1)];
            own.iter().map(|&first| bodies(first)).collect()
        })
    });
    teams.collect()
}

/// For each body, what kind of branch it begins: by its joint, and by the kinds of those that begin on it.
fn kinds(tree: &Tree) -> Vec<usize> {
    let mut known: BTreeMap<(Moves, Vec<usize>), usize> = BTreeMap::new();
    let mut kinds = vec![0; tree.bodies.len()];
    for body in tree.body_ids().rev() {
        let uppers = tree.uppers(body).iter();
        let mut uppers: Vec<usize> = uppers.map(|upper| kinds[upper.index()]).collect();
        uppers.sort_unstable();
        let next = known.len();
        let kind = (Moves::of(&tree.body(body).joint), uppers);
        kinds[body.index()] = *known.entry(kind).or_insert(next);
    }
    kinds
}

/// The bodies of a branch: those of one that is alike come in the same order.
fn branch(tree: &Tree, kinds: &[usize], first: BodyId) -> Vec<BodyId> {
    let mut bodies = Vec::new();
    let mut open = vec![first];
    while let Some(body) = open.pop() {
        bodies.push(body);
        let mut uppers = tree.uppers(body).to_vec();
        uppers.sort_by_key(|upper| kinds[upper.index()]);
        open.extend(uppers.into_iter().rev());
    }
    bodies
}
