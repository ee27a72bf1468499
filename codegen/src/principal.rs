//! Principal moments and axes of inertia tensors.

use crate::geometry::symmetric;

/// Principal moments and axes of the tensor with components xx, yy, zz, xy, xz, yz: `axes[i]` belongs to `moments[i]`.
///
/// Jacobi rotations, for they are accurate also where moments are equal or zero.
pub fn principal(components: [f64; 6]) -> ([f64; 3], [[f64; 3]; 3]) {
    let scale = components
        .iter()
        .fold(0.0, |largest: f64, component| largest.max(component.abs()));
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    if scale == 0.0 {
        return ([0.0; 3], axes);
    }
    let mut a = symmetric(components.map(|component| component / scale));
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
