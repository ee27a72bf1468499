//! Values of parameters beside the nominal ones: none is zero, for what a zero is multiplied with shows nothing, not even its
//! sign.

use crate::{
    geometry,
    id::ParameterId,
    random::Random,
    tree::{Parameter, RigidPart, Tree, Units, Value, principal},
};

/// What a moment of a real body may be below zero, relative to the largest: by rounding.
const ROUNDING: f64 = 1e-9;

/// How often a change of an inertia is halved before it is given up.
const HALVINGS: i32 = 8;

/// The values of the model.
pub fn nominal(tree: &Tree) -> Vec<f64> {
    let parameters = tree.parameters.iter();
    parameters.map(|parameter| parameter.nominal).collect()
}

/// Each value changed by a part of its own: of itself, or where it is zero of what the model has of its kind. Inertias stay those
/// of real bodies, and rotations stay rotations.
pub fn changed(tree: &Tree, seed: u64) -> Vec<f64> {
    let (units, mut random) = (Units::of(tree), Random::new(seed));
    let changed = |parameter: &Parameter| match parameter.nominal {
        0.0 => random.part() * scale(tree, &units, parameter.unit),
        nominal => nominal * (1.0 + random.part()),
    };
    let mut values: Vec<f64> = tree.parameters.iter().map(changed).collect();
    for part in tree.bodies.iter().flat_map(|body| &body.parts) {
        for (parameter, value) in inertia(tree, &units, part, &mut random) {
            values[parameter.index()] = value;
        }
    }
    for turn in tree.markers.iter().filter_map(|frame| frame.turn) {
        for (parameter, value) in turned(tree, turn, &mut random) {
            values[parameter.index()] = value;
        }
    }
    let pairs = values.into_iter().zip(nominal(tree));
    let held = pairs.map(|(changed, nominal)| {
        if changed.is_finite() {
            changed
        } else {
            nominal
        }
    });
    held.collect()
}

/// What a model has of a unit. States turn by about a radian in a second, so the unit of time is the second.
fn scale(tree: &Tree, units: &Units, unit: &str) -> f64 {
    match unit {
        "rad" | "1" => 1.0,
        "m" => units.length,
        "kg" | "N/m" | "N s/m" => units.mass,
        "m/s^2" => {
            let components = tree.gravity.iter();
            let sizes = components.map(|&component| tree.nominal(component).abs());
            let largest = sizes.fold(0.0, f64::max);
            if largest > 0.0 { largest } else { 9.81 }
        }
        _ => units.mass * units.length * units.length,
    }
}

/// The entries of a rotation that are parameters, turned once more: about half a radian, and about no axis of its own.
fn turned(tree: &Tree, turn: [[Value; 3]; 3], random: &mut Random) -> Vec<(ParameterId, f64)> {
    let nominal = turn.map(|row| row.map(|entry| tree.nominal(entry)));
    let [x, y, z] = [0; 3].map(|_| random.part());
    let more = geometry::of_quaternion([1.0, x, y, z]).expect("its length is at least one");
    let turned = geometry::then(&nominal, &more);
    of_parameters(turn.as_flattened(), turned.as_flattened())
}

/// Those of the values that are parameters, with their numbers.
fn of_parameters(values: &[Value], numbers: &[f64]) -> Vec<(ParameterId, f64)> {
    let pairs = values.iter().zip(numbers);
    let parameters = pairs.filter_map(|(value, &number)| match value {
        Value::Baked(_) => None,
        Value::Runtime(parameter) => Some((*parameter, number)),
    });
    parameters.collect()
}

/// The components of a part's inertia that are parameters, changed as far as the part stays a real one.
fn inertia(
    tree: &Tree,
    units: &Units,
    part: &RigidPart,
    random: &mut Random,
) -> Vec<(ParameterId, f64)> {
    let of = part.inertia;
    let components = [of.xx, of.yy, of.zz, of.xy, of.xz, of.yz];
    let nominal = components.map(|component| tree.nominal(component));
    let largest = nominal.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let scale = if largest > 0.0 {
        largest
    } else {
        scale(tree, units, "kg m^2")
    };
    let factors = [0; 3].map(|_| 1.0 + random.part());
    let rod = [0; 3].map(|_| random.part() * libm::sqrt(scale));
    let stretched = stretched(nominal, factors, rod);
    // With components that are baked in, the whole change may lead to no body.
    let candidates = (0..HALVINGS).map(|halvings| {
        let step = 0.5_f64.powi(halvings);
        std::array::from_fn(|place| match components[place] {
            Value::Baked(number) => number,
            Value::Runtime(_) => nominal[place] + step * (stretched[place] - nominal[place]),
        })
    });
    let found = candidates.into_iter().find(|&tensor| is_real(tensor));
    of_parameters(&components, &found.unwrap_or(nominal))
}

/// The inertia of a body that is stretched along each axis, and has a rod laid through it: whatever it was, it stays one of a
/// real body, and no component stays zero.
fn stretched(tensor: [f64; 6], factors: [f64; 3], rod: [f64; 3]) -> [f64; 6] {
    let [x, y, z, xy, xz, yz] = second_moments(tensor);
    let square =
        |axis: usize, moment: f64| factors[axis] * factors[axis] * moment + rod[axis] * rod[axis];
    let product =
        |i: usize, j: usize, moment: f64| factors[i] * factors[j] * moment + rod[i] * rod[j];
    let [x, y, z] = [square(0, x), square(1, y), square(2, z)];
    let [xy, xz, yz] = [product(0, 1, xy), product(0, 2, xz), product(1, 2, yz)];
    [y + z, x + z, x + y, -xy, -xz, -yz]
}

/// The integrals of the products of coordinates, of which an inertia is made.
fn second_moments([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [f64; 6] {
    let half = (xx + yy + zz) / 2.0;
    [half - xx, half - yy, half - zz, -xy, -xz, -yz]
}

/// True for the inertia of a real body, xx, yy, zz, xy, xz, yz, kg m²: principal moments obey the triangle inequality, so none is negative.
pub fn is_real(tensor: [f64; 6]) -> bool {
    let (moments, _) = principal(second_moments(tensor));
    let largest = moments.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    moments.iter().all(|&moment| moment >= -ROUNDING * largest)
}
