//! From a description to a tree: every rule a description can break, all breaches reported at once.

use crate::description::{Body as Written, Description, Given, INERTIA_COMPONENTS, Scalar};
use crate::diagnostic::{Diagnostic, Diagnostics, Severity, Spanned};
use crate::id::{BodyId, CoordinateId, ParameterId, SpeedId};
use crate::tree::{
    Body, Changes, Coordinate, Inertia, Joint, Order, Parameter, Tree, Value, inertia, joints,
    mobility, names, numbering,
};

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
pub fn build_with(description: &Description, _changes: &Changes) -> Result<Checked, Diagnostics> {
    let mut findings = description.faults.clone();
    names::check(description, &mut findings);
    let order = numbering::order(description, &mut findings);
    let joints_stand = joints::check(description, &mut findings);
    let bodies_stand = inertia::check(description, &mut findings);
    let tree = order.and_then(|order| assemble(description, &order, &mut findings));
    // Whether anything moves no mass can be judged only where masses and joints are right.
    if let Some(tree) = tree.as_ref().filter(|_| joints_stand && bodies_stand) {
        mobility::check(tree, description, &mut findings);
    }
    let is_error = |finding: &Diagnostic| finding.severity == Severity::Error;
    if description.bodies.is_empty() && !findings.iter().any(is_error) {
        findings.push(Diagnostic::error("the system has no bodies"));
    }
    if findings.iter().any(is_error) {
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

/// The tree of a description in which nothing is missing.
pub(crate) fn assemble(
    description: &Description,
    order: &[usize],
    findings: &mut Vec<Diagnostic>,
) -> Option<Tree> {
    let lower_bodies = &description.lower_bodies.as_ref()?.value;
    let written: Vec<&Written> = order
        .iter()
        .map(|place| &description.bodies[*place])
        .collect();
    let names: Vec<Spanned<String>> = written
        .iter()
        .map(|body| body.name.clone())
        .collect::<Option<_>>()?;
    let identifiers = names::identifiers(&names, findings);
    let mut new_places = vec![0; order.len()];
    for (new, old) in order.iter().enumerate() {
        new_places[*old] = new;
    }

    let mut parameters = Parameters::default();
    let gravity = parameters.vector(&description.gravity, "gravity", None, "m/s^2")?;
    let mut bodies = Vec::with_capacity(order.len());
    for (new, (body, name)) in written.iter().zip(names).enumerate() {
        let identifier = identifiers[new].clone();
        let id = Some(BodyId::new(new));
        let user_number = order[new] + 1;
        let lower = usize::try_from(lower_bodies.get(order[new])?.as_ref()?.value).ok()?;
        let quantity = |quantity: &str| format!("{identifier}_{quantity}");
        bodies.push(Body {
            lower: lower.checked_sub(1).map(|old| BodyId::new(new_places[old])),
            user_number,
            mass: parameters.value(body.mass, quantity("mass"), id, "kg")?,
            mass_center: parameters.vector(&body.mass_center, &quantity("mass_center"), id, "m")?,
            inertia: parameters.inertia(&body.inertia, &quantity("inertia"), id)?,
            attachment: parameters.vector(
                &body.joint.attachment,
                &quantity("attachment"),
                id,
                "m",
            )?,
            joint: locked_joint(body)?,
            name: name.value,
            identifier,
        });
    }
    let order = description.order?.value;
    let n_free = number_coordinates(&mut bodies, order);
    let name = description.name.as_ref()?.value.clone();
    Some(Tree {
        name,
        gravity,
        order,
        bodies,
        parameters: parameters.list,
        n_coordinates: n_free,
        n_speeds: n_free,
    })
}

/// The joint with its free coordinates not yet numbered.
fn locked_joint(body: &Written) -> Option<Joint> {
    let mut coordinates = [Coordinate::Locked(0.0); 6];
    for (axis, value) in &body.joint.locked {
        coordinates[axis.value.index()] = Coordinate::Locked(value.as_ref()?.value);
    }
    body.joint.kind.as_ref()?;
    for axis in joints::free_axes(body) {
        coordinates[axis.value.index()] = Coordinate::Free {
            coordinate: CoordinateId::new(0),
            speed: SpeedId::new(0),
        };
    }
    let [t1, t2, t3, s1, s2, s3] = coordinates;
    Some(Joint {
        angles: [t1, t2, t3],
        translations: [s1, s2, s3],
    })
}

/// Numbers the free coordinates and their speeds; the result is how many there are.
fn number_coordinates(bodies: &mut [Body], order: Order) -> usize {
    let mut next = 0;
    let mut number = |coordinates: &mut [Coordinate; 3]| {
        for coordinate in coordinates
            .iter_mut()
            .filter(|coordinate| coordinate.is_free())
        {
            *coordinate = Coordinate::Free {
                coordinate: CoordinateId::new(next),
                speed: SpeedId::new(next),
            };
            next += 1;
        }
    };
    match order {
        Order::Body => {
            for body in bodies {
                number(&mut body.joint.angles);
                number(&mut body.joint.translations);
            }
        }
        Order::Notes => {
            for body in bodies.iter_mut() {
                number(&mut body.joint.angles);
            }
            for body in bodies {
                number(&mut body.joint.translations);
            }
        }
    }
    next
}

/// The runtime values met so far.
#[derive(Default)]
struct Parameters {
    list: Vec<Parameter>,
}

impl Parameters {
    fn value(
        &mut self,
        given: Given<Scalar>,
        name: String,
        body: Option<BodyId>,
        unit: &'static str,
    ) -> Option<Value> {
        Some(match given?.value {
            Scalar::Baked(number) => Value::Baked(number),
            Scalar::Runtime(nominal) => {
                self.list.push(Parameter {
                    name,
                    body,
                    nominal,
                    unit,
                });
                Value::Runtime(ParameterId::new(self.list.len() - 1))
            }
        })
    }

    fn vector(
        &mut self,
        given: &[Given<Scalar>; 3],
        name: &str,
        body: Option<BodyId>,
        unit: &'static str,
    ) -> Option<[Value; 3]> {
        let [x, y, z] = given;
        Some([
            self.value(*x, format!("{name}_x"), body, unit)?,
            self.value(*y, format!("{name}_y"), body, unit)?,
            self.value(*z, format!("{name}_z"), body, unit)?,
        ])
    }

    fn inertia(
        &mut self,
        given: &[Given<Scalar>; 6],
        name: &str,
        body: Option<BodyId>,
    ) -> Option<Inertia> {
        let mut components = [Value::Baked(0.0); 6];
        for (index, component) in components.iter_mut().enumerate() {
            *component = self.value(
                given[index],
                format!("{name}_{}", INERTIA_COMPONENTS[index]),
                body,
                "kg m^2",
            )?;
        }
        let [xx, yy, zz, xy, xz, yz] = components;
        Some(Inertia {
            xx,
            yy,
            zz,
            xy,
            xz,
            yz,
        })
    }
}
