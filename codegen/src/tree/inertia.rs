//! Masses and inertias: are they those of a real body.
//!
//! An inertia tensor about the mass centre has principal moments that are not negative and of which none exceeds
//! the sum of the two others. The first is required, up to 1e-9 of the largest moment, which covers the rounding of
//! the test itself; a breach of the second, beyond 1e-6, which covers data of six digits, is a warning.

use crate::description::{Description, Scalar, WrittenBody};
use crate::diagnostic::{Diagnostic, Span};
use crate::tree::names::shown;

/// How far below zero, relative to the largest, a principal moment may be.
const NEGATIVE: f64 = 1e-9;
/// By how much, relative to the largest, a principal moment may exceed the sum of the others.
const TRIANGLE: f64 = 1e-6;

/// Reports what no real body has; true where nothing is an error.
pub(crate) fn check(description: &Description, findings: &mut Vec<Diagnostic>) -> bool {
    let mut stands = true;
    for (index, body) in description.bodies.iter().enumerate() {
        let name = shown(description, index);
        if let Some(mass) = body.mass.filter(|mass| mass.value.nominal() < 0.0) {
            let fault = format!(
                "`mass` of {name} is {:?}; expected zero or more",
                mass.value.nominal()
            );
            findings.push(Diagnostic::error(fault).at(mass.span, "negative mass"));
            stands = false;
        }
        let Some((components, span)) = components(body) else {
            continue;
        };
        let mut moments = principal(components).0;
        moments.sort_by(f64::total_cmp);
        let [small, middle, large] = moments;
        let shown_moments = format!(
            "principal moments {}, {} and {}",
            short(small),
            short(middle),
            short(large)
        );
        if small < -NEGATIVE * large.abs().max(small.abs()) {
            let fault = Diagnostic::error(format!(
                "`inertia` of {name} has the {shown_moments}; expected none below zero"
            ));
            let help = "xy, xz and yz are components of the tensor: minus the products of inertia";
            findings.push(fault.at(span, "not positive semidefinite").help(help));
            stands = false;
        } else if large - middle - small > TRIANGLE * large {
            let fault = Diagnostic::warning(format!(
                "`inertia` of {name} has the {shown_moments}, which no rigid body has"
            ));
            let help = "no principal moment can exceed the sum of the two others; is it taken about the mass centre?";
            findings.push(
                fault
                    .at(span, "the largest exceeds the sum of the others")
                    .help(help),
            );
        }
    }
    stands
}

/// The nominal components, and the place of all of them.
fn components(body: &WrittenBody) -> Option<([f64; 6], Span)> {
    let mut components = [0.0; 6];
    let mut place: Option<Span> = None;
    for (component, given) in components.iter_mut().zip(&body.inertia) {
        let given = given.as_ref()?;
        *component = Scalar::nominal(given.value);
        let start = place.map_or(given.span.start, |place| place.start.min(given.span.start));
        let end = place.map_or(given.span.end, |place| place.end.max(given.span.end));
        place = Some(Span { start, end });
    }
    Some((components, place?))
}

/// Four digits are enough to see what is wrong.
fn short(number: f64) -> String {
    let rounded: f64 = format!("{number:.3e}").parse().unwrap_or(number);
    format!("{rounded:?}")
}

/// Principal moments and axes of the tensor with components xx, yy, zz, xy, xz, yz: `axes[i]` belongs to `moments[i]`.
///
/// Jacobi rotations, for they are accurate also where moments are equal or zero.
pub(crate) fn principal(components: [f64; 6]) -> ([f64; 3], [[f64; 3]; 3]) {
    let scale = components
        .iter()
        .fold(0.0, |largest: f64, component| largest.max(component.abs()));
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    if scale == 0.0 {
        return ([0.0; 3], axes);
    }
    let [xx, yy, zz, xy, xz, yz] = components.map(|component| component / scale);
    let mut a = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    // Convergence is quadratic: five sweeps suffice, the rest is reserve.
    for (i, j) in [(0, 1), (0, 2), (1, 2)].into_iter().cycle().take(3 * 12) {
        if a[i][j] == 0.0 {
            continue;
        }
        let half = (a[j][j] - a[i][i]) / (2.0 * a[i][j]);
        let tan = half.signum() / (half.abs() + (half * half + 1.0).sqrt());
        let cos = 1.0 / (tan * tan + 1.0).sqrt();
        let sin = tan * cos;
        for row in &mut a {
            (row[i], row[j]) = (cos * row[i] - sin * row[j], sin * row[i] + cos * row[j]);
        }
        for k in 0..3 {
            (a[i][k], a[j][k]) = (cos * a[i][k] - sin * a[j][k], sin * a[i][k] + cos * a[j][k]);
            (axes[i][k], axes[j][k]) = (
                cos * axes[i][k] - sin * axes[j][k],
                sin * axes[i][k] + cos * axes[j][k],
            );
        }
    }
    ([a[0][0] * scale, a[1][1] * scale, a[2][2] * scale], axes)
}

#[cfg(test)]
mod tests {
    use super::principal;

    #[test]
    fn principal_axes_rebuild_the_tensor() {
        let tensor = [2.0, 3.0, 4.0, 0.3, -0.2, 0.5];
        let (moments, axes) = principal(tensor);
        for (component, (i, j)) in
            tensor
                .into_iter()
                .zip([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)])
        {
            let rebuilt: f64 = (0..3).map(|k| moments[k] * axes[k][i] * axes[k][j]).sum();
            // Twelve sweeps of rotations, each a few roundings of numbers near 4.
            assert!(
                (rebuilt - component).abs() < 1e-14,
                "component {i}{j}: {rebuilt} for {component}"
            );
        }
    }

    #[test]
    fn a_tensor_of_rank_one_has_two_zero_moments() {
        let (mut moments, _) = principal([1.0, 4.0, 9.0, 2.0, 3.0, 6.0]);
        moments.sort_by(f64::total_cmp);
        assert!(
            moments[0].abs() < 1e-14
                && moments[1].abs() < 1e-14
                && (moments[2] - 14.0).abs() < 1e-13,
            "{moments:?}"
        );
    }
}
