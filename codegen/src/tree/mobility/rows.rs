//! Rows on twists and the little algebra that the sweeps need of them.

/// Angular velocity, then velocity of the origin, both in the body's components; or a row that acts on these.
pub(crate) type Twist = [f64; 6];

/// Takes the part along `unit` out of `column`; twice, for the first time leaves what rounding leaves.
pub(crate) fn project_out(column: &mut [f64], unit: &[f64]) -> f64 {
    let mut along = 0.0;
    for _ in 0..2 {
        let part = dot(column, unit);
        column
            .iter_mut()
            .zip(unit)
            .for_each(|(entry, unit)| *entry -= part * unit);
        along += part;
    }
    along
}

/// At most six rows with the same sum of squares on every twist: the R of QR by Householder.
pub(crate) fn triangle(mut rows: Vec<Twist>) -> Vec<Twist> {
    for column in 0..6.min(rows.len()) {
        let below: Vec<f64> = rows[column..].iter().map(|row| row[column]).collect();
        let length = dot(&below, &below).sqrt();
        if length == 0.0 {
            continue;
        }
        let mut mirror = below;
        mirror[0] += length.copysign(mirror[0]);
        let square = dot(&mirror, &mirror);
        for other in column..6 {
            let along: f64 = rows[column..]
                .iter()
                .zip(&mirror)
                .map(|(row, m)| row[other] * m)
                .sum();
            rows[column..]
                .iter_mut()
                .zip(&mirror)
                .for_each(|(row, m)| row[other] -= 2.0 * along / square * m);
        }
    }
    rows.truncate(6);
    rows
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn join([a, b, c]: [f64; 3], [d, e, f]: [f64; 3]) -> Twist {
    [a, b, c, d, e, f]
}
