//! Arrays of one model in the numbering of another model of the same system.

use kane_codegen::{
    functions::{Axis, Function, Shape},
    tree::Tree,
};

/// For each body, coordinate and speed of one model its place in another model of the same system, by their names.
#[derive(Clone, Debug)]
pub struct Maps {
    pub bodies: Vec<usize>,
    pub coordinates: Vec<usize>,
    pub speeds: Vec<usize>,
}

impl Maps {
    pub fn new(from: &Tree, to: &Tree) -> Self {
        Self {
            bodies: Self::of_bodies(from, to),
            coordinates: places(&from.coordinate_names(), &to.coordinate_names()),
            speeds: places(&from.speed_names(), &to.speed_names()),
        }
    }

    /// Of models that may differ in what their coordinates are.
    pub fn of_bodies(from: &Tree, to: &Tree) -> Vec<usize> {
        let names = |tree: &Tree| {
            tree.bodies
                .iter()
                .map(|body| body.name.clone())
                .collect::<Vec<_>>()
        };
        places(&names(from), &names(to))
    }
}

fn places(from: &[String], to: &[String]) -> Vec<usize> {
    let place = |name: &String| {
        from.iter()
            .position(|other| other == name)
            .expect("the same names")
    };
    to.iter().map(place).collect()
}

/// The output of a function of one model in the numbering of another model of the same system.
pub fn renumbered_output(function: &Function, output: &[f64], from: &Tree, to: &Tree) -> Vec<f64> {
    let Maps {
        bodies,
        coordinates,
        speeds,
    } = Maps::new(from, to);
    let axes: Vec<usize> = (0..3).collect();
    let pairs = speed_pairs(&speeds, from, to);
    let shape = function.outputs[0].shape;
    // The columns of a compact output are spread over all speeds.
    let dense = [Axis::Bodies, Axis::Three, Axis::Speeds];
    let counted: &[Axis] = if shape == Shape::COLUMNS {
        &dense
    } else {
        shape.axes
    };
    let map = |axis: &Axis| match axis {
        Axis::Three => &axes,
        Axis::Coordinates => &coordinates,
        Axis::Speeds => &speeds,
        Axis::SpeedPairs => &pairs,
        Axis::Bodies => &bodies,
        Axis::Columns => unreachable!("spread over bodies and speeds"),
    };
    let maps: Vec<&Vec<usize>> = counted.iter().map(map).collect();
    let mut gathered = vec![0];
    for map in maps {
        gathered = gathered
            .iter()
            .flat_map(|place| map.iter().map(move |index| place * map.len() + index))
            .collect();
    }
    gathered.into_iter().map(|place| output[place]).collect()
}

/// For each pair of coupled speeds of one model its place among those of another model of the same system.
fn speed_pairs(speeds: &[usize], from: &Tree, to: &Tree) -> Vec<usize> {
    let places: Vec<[usize; 2]> = from.coupled_speeds().into_iter().collect();
    let place = |pair: [usize; 2]| {
        let [row, column] = pair.map(|speed| speeds[speed]);
        let pair = [row.max(column), row.min(column)];
        let found = places.iter().position(|place| *place == pair);
        found.expect("the trees are the same but for their order")
    };
    to.coupled_speeds().into_iter().map(place).collect()
}
