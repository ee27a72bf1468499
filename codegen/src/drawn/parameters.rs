//! Values of parameters beside the nominal ones: none is zero, for what a zero is multiplied with shows nothing, not even its
//! sign.

use crate::{
    id::ParameterId,
    random::Random,
    tree::{Parameter, RigidPart, Tree, Units, Value, principal},
};

/// What a moment of a real body may be below zero, relative to the largest: by rounding.
const ROUNDING: f64 = 1e-9;

/// How often a change of an inertia is halved before it is given up.
const HALVINGS: i32 = 8;

/// The values of the model.
pub(crate) fn nominal(tree: &Tree) -> Vec<f64> {
    let parameters = tree.parameters.iter();
    parameters.map(|parameter| parameter.nominal).collect()
}

/// Each value changed by a part of its own: of itself, or where it is zero of what the model has of its kind.
pub(crate) fn changed(tree: &Tree, seed: u64) -> Vec<f64> {
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
        "rad" => 1.0,
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
    let pairs = components.into_iter().zip(found.unwrap_or(nominal));
    let parameters = pairs.filter_map(|(component, value)| match component {
        Value::Baked(_) => None,
        Value::Runtime(parameter) => Some((parameter, value)),
    });
    parameters.collect()
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

/// True for the inertia of a real body: principal moments obey the triangle inequality, so none is negative.
fn is_real(tensor: [f64; 6]) -> bool {
    let (moments, _) = principal(second_moments(tensor));
    let largest = moments.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    moments.iter().all(|&moment| moment >= -ROUNDING * largest)
}

#[cfg(test)]
mod tests {
    use super::{changed, is_real, nominal};
    use crate::{
        description::toml,
        diagnostic::Source,
        tree::{Tree, build},
    };

    /// A body of which much is a parameter, and much zero.
    fn tree(inertia: &str) -> Tree {
        let text = format!(
            "name = \"one\"\n\
             gravity = [{{ runtime = 0.0 }}, 0.0, {{ runtime = -9.81 }}]\n\
             lower_bodies = [0]\n\
             [[body]]\n\
             name = \"one\"\n\
             mass = {{ runtime = 2.0 }}\n\
             mass_center = [{{ runtime = 0.0 }}, 0.0, {{ runtime = -0.5 }}]\n\
             inertia = {{ {inertia} }}\n\
             attachment = [0.0, 0.0, 0.0]\n\
             joint = [\"theta1\", \"s2\"]\n"
        );
        let checked = build(&toml::parse(&Source::new("one.toml", text)));
        checked.expect("a sound description").tree
    }

    const ALL: &str = "xx = { runtime = 0.0 }, yy = { runtime = 0.3 }, zz = { runtime = 0.3 }, \
                       xy = { runtime = 0.0 }, xz = { runtime = 0.0 }, yz = { runtime = 0.0 }";

    /// The components of the only part, xx first, with these values of the parameters.
    fn inertia(tree: &Tree, values: &[f64]) -> [f64; 6] {
        let mut given = tree.clone();
        for (parameter, &value) in given.parameters.iter_mut().zip(values) {
            parameter.nominal = value;
        }
        let of = &given.bodies[0].parts[0].inertia;
        [of.xx, of.yy, of.zz, of.xy, of.xz, of.yz].map(|component| given.nominal(component))
    }

    #[test]
    fn no_changed_value_is_zero_or_its_nominal_one() {
        let tree = tree(ALL);
        for seed in 1..100 {
            for (changed, nominal) in changed(&tree, seed).into_iter().zip(nominal(&tree)) {
                assert!(changed != 0.0, "zero for {nominal}");
                assert!((changed - nominal).abs() > 1e-4, "{changed} for {nominal}");
            }
        }
    }

    #[test]
    fn value_that_f64_cannot_hold_changed_stays_the_nominal_one() {
        let mut tree = tree(ALL);
        let largest = tree.parameters.iter().position(|one| one.unit == "kg");
        let largest = largest.expect("a mass");
        tree.parameters[largest].nominal = 1.75e308;
        assert_eq!(changed(&tree, 1)[largest], 1.75e308);
    }

    #[test]
    fn changed_inertias_are_those_of_real_bodies() {
        let rod = "xx = 0.0, yy = { runtime = 0.3 }, zz = { runtime = 0.3 }, xy = 0.0, xz = 0.0, yz = 0.0";
        let plate = "xx = 0.2, yy = 0.104, zz = 0.1, xy = { runtime = 0.0 }, xz = 0.0, yz = { runtime = 0.02 }";
        for tree in [ALL, rod, plate].map(tree) {
            for seed in 1..100 {
                let tensor = inertia(&tree, &changed(&tree, seed));
                assert!(is_real(tensor), "seed {seed}: {tensor:?}");
            }
        }
    }

    #[test]
    fn what_no_real_body_has_is_told() {
        assert!(is_real([0.0, 0.3, 0.3, 0.0, 0.0, 0.0]));
        assert!(!is_real([0.0, 0.3, 0.4, 0.0, 0.0, 0.0]));
        assert!(!is_real([0.1, 0.3, 0.3, 0.2, 0.0, 0.0]));
    }
}
