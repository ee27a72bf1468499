//! The rates of coordinates, from speeds.

use kane_codegen::tree::{ChartCoordinates, Orientation, Tree};

use crate::rotation::{Vector, cross, dot, hamilton, rate_columns};

/// The rates of all coordinates.
pub(super) fn q_dot(tree: &Tree, q: &[f64], u: &[f64]) -> Vec<f64> {
    let mut rates = vec![0.0; q.len()];
    for body in &tree.bodies {
        let joint = &body.joint;
        let mut coordinates: Vec<usize> = joint
            .coordinates()
            .iter()
            .map(|(_, at)| at.index())
            .collect();
        let mut speeds: Vec<usize> = joint.speeds().iter().map(|(_, at)| at.index()).collect();
        if let Orientation::AngularVelocity {
            chart,
            speeds: turns,
        } = joint.orientation
        {
            let w = turns.map(|turn| u[turn.index()]);
            speeds.drain(..3);
            match chart {
                ChartCoordinates::EulerParameters(places) => {
                    let e = places.map(|place| q[place.index()]);
                    let e_dot = hamilton(e, [0.0, w[0], w[1], w[2]]);
                    for (place, rate) in places.into_iter().zip(e_dot) {
                        rates[place.index()] = 0.5 * rate;
                    }
                    coordinates.drain(..4);
                }
                ChartCoordinates::Angles(places) => {
                    let columns = rate_columns(places.map(|place| q[place.index()]));
                    for (place, rate) in places.into_iter().zip(solved(&columns, w)) {
                        rates[place.index()] = rate;
                    }
                    coordinates.drain(..3);
                }
            }
        }
        for (coordinate, speed) in coordinates.into_iter().zip(speeds) {
            rates[coordinate] = u[speed];
        }
    }
    rates
}

/// `x` with `x_1 a + x_2 b + x_3 c = v`: Cramer's rule.
fn solved(&[a, b, c]: &[Vector; 3], v: Vector) -> Vector {
    let volume = |a, b, c| dot(a, cross(b, c));
    let whole = volume(a, b, c);
    [volume(v, b, c), volume(a, v, c), volume(a, b, v)].map(|part| part / whole)
}
