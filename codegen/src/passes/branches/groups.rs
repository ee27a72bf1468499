//! Which operations go side by side.

use std::collections::BTreeMap;

use super::{
    alike::{Branch, Branches},
    signs::{Free, Price, Sign, Signs},
    traced::Traced,
};
use crate::expr::{Expr, ExprGraph, Node, NodeId};

/// One operation of each branch of a team, all alike.
pub(super) struct Group {
    pub(super) team: usize,
    /// By branch.
    pub(super) members: Vec<NodeId>,
    /// In the order of the first's.
    pub(super) operands: Vec<Operand>,
    /// The sign of each branch's, where that of the first is positive.
    signs: Vec<Sign>,
}

/// An operand of a group.
pub(super) struct Operand {
    /// By branch.
    pub(super) nodes: Vec<NodeId>,
    source: Source,
}

/// Where an operand comes from.
#[derive(Clone, Copy)]
enum Source {
    /// It is what another group computes.
    Group(usize),
    /// It is given to a team, and may be negated.
    Given(usize, Free),
}

impl Operand {
    /// The group that computes it, if one does for all branches.
    pub(super) fn group(&self) -> Option<usize> {
        match self.source {
            Source::Group(group) => Some(group),
            Source::Given(..) => None,
        }
    }
}

/// All groups.
pub(super) struct Groups {
    pub(super) all: Vec<Group>,
    /// For each node, its group.
    of: Vec<Option<usize>>,
    /// By team.
    signs: Vec<Signs>,
    given: BTreeMap<(usize, Vec<NodeId>), Free>,
}

impl Groups {
    pub(super) fn of(branches: &Branches, graph: &ExprGraph, traced: &Traced) -> Self {
        let mut groups = Self {
            all: Vec::new(),
            of: vec![None; graph.len()],
            signs: branches.lanes().map(Signs::new).collect(),
            given: BTreeMap::new(),
        };
        for (members, team) in candidates(branches, graph, traced) {
            groups.try_one(graph, traced, team, members);
        }
        groups
    }

    /// How many branches a group has.
    pub(super) fn lanes(&self, group: usize) -> usize {
        self.all[group].members.len()
    }

    /// The group that a node is in.
    pub(super) fn group(&self, id: NodeId) -> Option<usize> {
        self.of[id.index()]
    }

    /// True for a group that was not taken apart.
    pub(super) fn is_whole(&self, group: usize) -> bool {
        self.group(self.all[group].members[0]) == Some(group)
    }

    /// Takes a group apart.
    pub(super) fn dissolve(&mut self, group: usize) {
        for member in &self.all[group].members {
            self.of[member.index()] = None;
        }
    }

    /// True where the number that a branch computes is the negative of what the helper does.
    pub(super) fn is_negative(&self, group: usize, lane: usize) -> bool {
        let Group { team, signs, .. } = &self.all[group];
        self.signs[*team].is_negative(lane, &signs[lane])
    }

    /// True where an operand is a number of the model for each branch.
    pub(super) fn are_numbers(&self, operand: &Operand) -> bool {
        match operand.source {
            Source::Given(team, free) => {
                matches!(self.signs[team].price(free), Price::Number | Price::Equal)
            }
            Source::Group(_) => false,
        }
    }

    /// What the helper is given for an operand: for each branch.
    pub(super) fn given(&self, operand: &Operand) -> Vec<Expr> {
        let nodes = operand.nodes.iter().enumerate();
        let given = nodes.map(|(lane, &id)| {
            let is_negative = match operand.source {
                Source::Group(group) => self.is_negative(group, lane),
                Source::Given(team, free) => {
                    self.signs[team].is_negative(lane, &Sign::free(free, false))
                }
            };
            Expr::of(id).signed(is_negative)
        });
        given.collect()
    }

    /// Groups these, unless there are no signs with which they are alike.
    fn try_one(&mut self, graph: &ExprGraph, traced: &Traced, team: usize, members: Vec<NodeId>) {
        let places: Vec<Vec<Expr>> = members.iter().map(|id| operands(graph, *id)).collect();
        let first = &places[0];
        let color = |own: Expr| traced.colors[own.node().index()];
        let is_turned = |own: &[Expr]| {
            own.iter()
                .zip(first)
                .any(|(own, first)| color(*own) != color(*first))
        };
        let aligned: Vec<Vec<Expr>> = places
            .iter()
            .map(|own| {
                let mut own = own.clone();
                if is_turned(&own) {
                    own.reverse();
                }
                own
            })
            .collect();
        let mut operands = Vec::new();
        let mut signs = Vec::new();
        for place in 0..first.len() {
            let across: Vec<Expr> = aligned.iter().map(|own| own[place]).collect();
            let (operand, of_operand) = self.operand(graph, team, &across);
            operands.push(operand);
            signs.push(of_operand);
        }
        let signs = match (graph.node(members[0]), &signs[..]) {
            (Node::Add(..), [a, b]) => {
                let both = a.iter().zip(b).map(|(a, b)| a.times(b));
                let conditions: Vec<Sign> = both.skip(1).collect();
                if !self.signs[team].require_positive(&conditions) {
                    return;
                }
                a.clone()
            }
            (Node::Mul(..) | Node::Div(..), [a, b]) => {
                a.iter().zip(b).map(|(a, b)| a.times(b)).collect()
            }
            // An absolute value has none.
            _ => vec![Sign::default(); members.len()],
        };
        for member in &members {
            self.of[member.index()] = Some(self.all.len());
        }
        self.all.push(Group {
            team,
            members,
            operands,
            signs,
        });
    }

    /// An operand, and for each branch the sign of its term, where that of the first is as it is.
    fn operand(&mut self, graph: &ExprGraph, team: usize, across: &[Expr]) -> (Operand, Vec<Sign>) {
        let nodes: Vec<NodeId> = across.iter().map(|own| own.node()).collect();
        let of_first = self.group(nodes[0]);
        let source = match of_first {
            Some(group) if self.all[group].members == nodes => Source::Group(group),
            _ => Source::Given(team, self.free(graph, team, &nodes)),
        };
        let signs = across.iter().enumerate().map(|(lane, own)| {
            let turned = own.is_negative() ^ across[0].is_negative();
            match source {
                Source::Group(group) => self.all[group].signs[lane].clone().signed(turned),
                Source::Given(..) if lane == 0 => Sign::default(),
                Source::Given(_, free) => Sign::free(free, turned),
            }
        });
        let signs = signs.collect();
        (Operand { nodes, source }, signs)
    }

    /// The sign of what is given: a number has another wherever it stands.
    fn free(&mut self, graph: &ExprGraph, team: usize, nodes: &[NodeId]) -> Free {
        let mut numbers = nodes.iter().map(|id| graph.node(*id));
        let are_numbers = numbers.all(|node| matches!(node, Node::Number(_)));
        let are_equal = nodes.iter().all(|id| *id == nodes[0]);
        let price = match (are_numbers, are_equal) {
            (true, true) => Price::Equal,
            (true, false) => Price::Number,
            (false, true) => Price::Shared,
            (false, false) => Price::Side,
        };
        let signs = &mut self.signs[team];
        if are_numbers {
            return signs.add(price);
        }
        let given = self.given.entry((team, nodes.to_vec()));
        *given.or_insert_with(|| signs.add(price))
    }
}

/// The operands of an operation, with their signs in a sum.
fn operands(graph: &ExprGraph, id: NodeId) -> Vec<Expr> {
    match graph.node(id) {
        Node::Add(a, b) => vec![a, b],
        other => other.operands().map(Expr::of).collect(),
    }
}

/// For each node, whether an angle needs it: sines of all angles are taken together, before any call.
fn of_angles(graph: &ExprGraph, traced: &Traced) -> Vec<bool> {
    let needed = graph.ids().filter(|id| traced.needed[id.index()]);
    let angles = needed.filter_map(|id| match graph.node(id) {
        Node::Sin(angle) | Node::Cos(angle) => Some(Expr::of(angle)),
        _ => None,
    });
    graph.reachable(&angles.collect::<Vec<_>>())
}

/// Operations of one colour, one of each branch of a team, in the order of the first branch's; and the team.
fn candidates(
    branches: &Branches,
    graph: &ExprGraph,
    traced: &Traced,
) -> Vec<(Vec<NodeId>, usize)> {
    let mut by_color: BTreeMap<(usize, u32), Vec<Vec<NodeId>>> = BTreeMap::new();
    let of_angle = of_angles(graph, traced);
    let may = |id: &NodeId| traced.needed[id.index()] && !of_angle[id.index()];
    for id in graph.ids().filter(may) {
        let is_operation = matches!(
            graph.node(id),
            Node::Add(..) | Node::Mul(..) | Node::Div(..) | Node::Abs(_)
        );
        if let Some(Branch { team, lane }) = traced.branches[id.index()].filter(|_| is_operation) {
            let own = by_color.entry((team, traced.colors[id.index()]));
            own.or_insert_with(|| vec![Vec::new(); branches.lanes_of(team)])[lane].push(id);
        }
    }
    let mut found = Vec::new();
    for ((team, _), lanes) in by_color {
        let n_own = lanes[0].len();
        if lanes.iter().all(|own| own.len() == n_own) {
            let across = |place: usize| lanes.iter().map(|own| own[place]).collect();
            found.extend((0..n_own).map(|place| (across(place), team)));
        }
    }
    found.sort();
    found
}
