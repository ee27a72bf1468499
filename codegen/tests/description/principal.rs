//! Principal moments and axes of inertia tensors.

use kane_codegen::tree::principal;

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
        moments[0].abs() < 1e-14 && moments[1].abs() < 1e-14 && (moments[2] - 14.0).abs() < 1e-13,
        "{moments:?}"
    );
}
