//! A system with more coordinates than speeds must say which are whose: tests of what compiles.

/// With its joints it does.
///
/// ```
/// # #![allow(unused_must_use)]
/// # struct Ball;
/// # impl kane::System<f64> for Ball {
/// #     type Q = [f64; 4];
/// #     type U = [f64; 3];
/// #     type Matrix = [[f64; 3]; 3];
/// #     type Loads = [kane::Load<f64>; 1];
/// #     type Scalars = [f64; 1];
/// #     type Vectors = [[f64; 3]; 1];
/// #     type Rotations = [[[f64; 3]; 3]; 1];
/// #     const NAME: &'static str = "ball";
/// #     const BODY_NAMES: &'static [&'static str] = &["body"];
/// #     const COORDINATE_NAMES: &'static [&'static str] = &["e0", "e1", "e2", "e3"];
/// #     const SPEED_NAMES: &'static [&'static str] = &["w1", "w2", "w3"];
/// #     const LOWER_BODIES: &'static [usize] = &[0];
/// #     const SPEED_BODIES: &'static [usize] = &[0, 0, 0];
/// #     const JOINTS: &'static [kane::Joint] = &[kane::Joint {
/// #         name: "socket",
/// #         chart: kane::Chart::EulerParameters,
/// #         q: [Some(0), Some(1), Some(2), Some(3), None, None, None],
/// #         u: [Some(0), Some(1), Some(2), None, None, None],
/// #     }];
/// #     fn q_dot(&self, _: &[f64; 4], _: &[f64; 3], _: &mut [f64; 4]) {}
/// # }
/// kane::manifold::q_plus(&Ball, &[1.0, 0.0, 0.0, 0.0], &[0.0; 3]);
/// ```
struct Told;

/// Without, it does not.
///
/// ```compile_fail,E0080
/// # #![allow(unused_must_use)]
/// # struct Ball;
/// # impl kane::System<f64> for Ball {
/// #     type Q = [f64; 4];
/// #     type U = [f64; 3];
/// #     type Matrix = [[f64; 3]; 3];
/// #     type Loads = [kane::Load<f64>; 1];
/// #     type Scalars = [f64; 1];
/// #     type Vectors = [[f64; 3]; 1];
/// #     type Rotations = [[[f64; 3]; 3]; 1];
/// #     const NAME: &'static str = "ball";
/// #     const BODY_NAMES: &'static [&'static str] = &["body"];
/// #     const COORDINATE_NAMES: &'static [&'static str] = &["e0", "e1", "e2", "e3"];
/// #     const SPEED_NAMES: &'static [&'static str] = &["w1", "w2", "w3"];
/// #     const LOWER_BODIES: &'static [usize] = &[0];
/// #     const SPEED_BODIES: &'static [usize] = &[0, 0, 0];
/// #     fn q_dot(&self, _: &[f64; 4], _: &[f64; 3], _: &mut [f64; 4]) {}
/// # }
/// kane::manifold::q_plus(&Ball, &[1.0, 0.0, 0.0, 0.0], &[0.0; 3]);
/// ```
struct Untold;
