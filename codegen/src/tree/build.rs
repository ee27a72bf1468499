//! From a description to a tree: every rule a description can break, all breaches reported at once.

use crate::description::Description;
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::tree::assembly::{Settled, assemble};
use crate::tree::changes::Changes;
use crate::tree::joints::{self, ResolvedJoint};
use crate::tree::rotations::{ConstantRotations, Snapped, exact};
use crate::tree::system::Tree;
use crate::tree::{inertia, massless, mobility, names, nonzeros, numbering, units};

/// What rounding alone leaves of a zero in a rotation.
const ROUNDING: f64 = 1e-15;

/// A tree, and what the user should know about it.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The tree.
    pub tree: Tree,
    /// Warnings and notes; never errors.
    pub warnings: Diagnostics,
}

/// Checks a description and numbers its bodies, coordinates and speeds.
///
/// ```
/// use kane_codegen::description::toml;
/// use kane_codegen::diagnostic::Source;
///
/// let text = r#"
/// name = "pendulum"
/// gravity = [0.0, 0.0, -9.81]
/// lower_bodies = [0]
///
/// [[body]]
/// name = "bob"
/// mass = { runtime = 2.0 }
/// mass_center = [0.0, 0.0, -0.5]
/// inertia = { xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0 }
/// attachment = [0.0, 0.0, 0.0]
/// joint = ["theta1"]
/// "#;
/// let checked = kane_codegen::tree::build(&toml::parse(&Source::new("pendulum.toml", text))).unwrap();
/// assert!(checked.warnings.is_empty());
/// assert_eq!(checked.tree.parameters[0].name, "bob_mass");
///
/// // A point mass on its axis: the fault is shown with its line.
/// let text = text.replace("theta1", "theta3");
/// let faults = kane_codegen::tree::build(&toml::parse(&Source::new("pendulum.toml", text))).unwrap_err();
/// assert!(faults.to_string().starts_with("error: `theta3` of body `bob` moves no mass\n  --> pendulum.toml:12:10"));
/// ```
///
/// # Errors
/// Every rule that the description breaks, with what was wrong already while reading it, and the warnings.
pub fn build(description: &Description) -> Result<Checked, Diagnostics> {
    build_with(description, &Changes::default())
}

/// As [`build`], with changes to the description.
///
/// # Errors
/// As [`build`]; and changes that name what is not there.
pub fn build_with(description: &Description, changes: &Changes) -> Result<Checked, Diagnostics> {
    let mut findings = description.faults.clone();
    names::check(description, &mut findings);
    names::check_frames(description, &mut findings);
    let outward = numbering::outward(description, &mut findings);
    let (rotations, snapped) = exact(description, changes.snap);
    let joints = joints_that_stand(description, &rotations, changes, &mut findings);
    let bodies_stand = inertia::check(description, &mut findings);
    units::check(description, &mut findings);
    let tree = outward.as_ref().zip(joints.as_deref());
    let tree = tree.and_then(|(outward, joints)| {
        let settled = Settled {
            description,
            outward,
            joints,
            rotations: &rotations,
            snap: changes.snap,
        };
        let held = changes.remove_massless && bodies_stand;
        let held = held.then(|| massless::hold(settled, &mut findings));
        let joints = held.as_deref().unwrap_or(joints);
        if changes.remove_massless && !motions_stand(description, joints, changes, &mut findings) {
            return None;
        }
        let settled = Settled { joints, ..settled };
        let tree = assemble(settled, &mut findings)?;
        if saved(settled, &snapped, &tree) {
            findings.extend(snapped.note(description, &outward.places));
        }
        Some(tree)
    });
    // Whether anything moves no mass can be judged only where masses and joints are right, and all of the file was read.
    let all_read = !description.faults.iter().any(Diagnostic::is_error);
    if let Some(tree) = tree.as_ref().filter(|_| bodies_stand && all_read) {
        mobility::check(tree, description, changes, &mut findings);
    }
    if description.bodies.is_empty() && !findings.iter().any(Diagnostic::is_error) {
        findings.push(Diagnostic::error("the system has no bodies"));
    }
    if tree.is_none() && !findings.iter().any(Diagnostic::is_error) {
        let lacking = "the description lacks what readers demand, such as a mass or an axis";
        findings.push(Diagnostic::error(lacking));
    }
    if findings.iter().any(Diagnostic::is_error) {
        // What was decided about names and numbers is no news while there is no tree.
        findings.retain(|finding| finding.severity != Severity::Note);
    }
    let findings = Diagnostics::new(description.source.clone(), findings);
    match tree {
        Some(tree) if !findings.has_error() => Ok(Checked {
            tree,
            warnings: findings,
        }),
        _ => Err(findings),
    }
}

/// Whether fewer numbers are left for what was snapped. Beyond rounding: that a right angle in all digits is one is no news.
fn saved(settled: Settled<'_>, snapped: &Snapped, tree: &Tree) -> bool {
    if snapped.is_nothing() || snapped.has_axis() {
        return !snapped.is_nothing();
    }
    let before = Settled {
        rotations: &exact(settled.description, ROUNDING).0,
        snap: ROUNDING,
        ..settled
    };
    let before = assemble(before, &mut Vec::new());
    before.is_none_or(|before| nonzeros::count(tree) < nonzeros::count(&before))
}

/// The joints, if they stand; motions that may yet be held are not judged.
fn joints_that_stand(
    description: &Description,
    rotations: &[ConstantRotations],
    changes: &Changes,
    findings: &mut Vec<Diagnostic>,
) -> Option<Vec<ResolvedJoint>> {
    let is_unread = description.bodies.is_empty() && findings.iter().any(Diagnostic::is_error);
    if is_unread {
        // Names of what is changed would all be unknown.
        return None;
    }
    let joints = joints::joints(description, rotations);
    let before = findings.len();
    joints::check(description, &joints, findings);
    let stand = |findings: &[Diagnostic]| !findings[before..].iter().any(Diagnostic::is_error);
    let joints: Vec<ResolvedJoint> = joints.into_iter().collect::<Option<_>>()?;
    if !stand(findings) {
        return None;
    }
    let joints = joints::change(description, joints, changes, findings);
    let joints = joints::follow(description, joints, findings);
    let all_held =
        changes.remove_massless || motions_stand(description, &joints, changes, findings);
    (all_held && stand(findings)).then_some(joints)
}

/// Whether motions can be what they are, once all that is held is held.
fn motions_stand(
    description: &Description,
    joints: &[ResolvedJoint],
    changes: &Changes,
    findings: &mut Vec<Diagnostic>,
) -> bool {
    let before = findings.len();
    joints::check_motions(description, joints, changes, findings);
    !findings[before..].iter().any(Diagnostic::is_error)
}
