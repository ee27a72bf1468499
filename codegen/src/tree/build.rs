//! From a description to a tree: every rule a description can break, all breaches reported at once.

use crate::description::Description;
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::tree::assembly::{Settled, assemble};
use crate::tree::changes::Changes;
use crate::tree::joints::{self, ResolvedJoint};
use crate::tree::rotations::{ConstantRotations, exact};
use crate::tree::system::Tree;
use crate::tree::{inertia, mobility, names, numbering};

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
    let tree = outward.as_ref().zip(joints.as_deref());
    let tree = tree.and_then(|(outward, joints)| {
        findings.extend(snapped.note(description, &outward.places));
        let settled = Settled {
            description,
            outward,
            joints,
            rotations: &rotations,
            snap: changes.snap,
        };
        assemble(settled, &mut findings)
    });
    // Whether anything moves no mass can be judged only where masses and joints are right.
    if let Some(tree) = tree.as_ref().filter(|_| bodies_stand) {
        mobility::check(tree, description, &mut findings);
    }
    if description.bodies.is_empty() && !findings.iter().any(Diagnostic::is_error) {
        findings.push(Diagnostic::error("the system has no bodies"));
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

/// The joints, if they stand.
fn joints_that_stand(
    description: &Description,
    rotations: &[ConstantRotations],
    changes: &Changes,
    findings: &mut Vec<Diagnostic>,
) -> Option<Vec<ResolvedJoint>> {
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
    joints::check_motions(description, &joints, findings);
    stand(findings).then_some(joints)
}
