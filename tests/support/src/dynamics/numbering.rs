//! Arrays of one model in the numbering of another model of the same system.

use kane_codegen::{
    base_parameters,
    functions::{Dimension, Function, Packed, Shape},
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

/// The outputs of a function of one model, one after the other, in the numbering of another model of the same system.
pub fn renumbered_output(function: &Function, numbers: &[f64], from: &Tree, to: &Tree) -> Vec<f64> {
    let maps = Maps::new(from, to);
    let mut rest = numbers;
    let mut renumbered = Vec::with_capacity(numbers.len());
    for output in function.outputs {
        let packed = output.shape.packed();
        let pairs = packed.map(|packed| packed_pairs(packed, &maps, from, to));
        let own = Own {
            pairs: pairs.unwrap_or_default(),
            base: base_places(output.shape, to),
        };
        let places = places_of(output.shape, &maps, &own);
        let (own, others) = rest.split_at(places.len());
        renumbered.extend(places.into_iter().map(|place| own[place]));
        rest = others;
    }
    assert!(rest.is_empty(), "{}", function.name);
    renumbered
}

/// Places that belong to one output.
struct Own {
    pairs: Vec<usize>,
    base: Vec<usize>,
}

/// Those of base parameters: models that are compared have the same, in one order.
fn base_places(shape: Shape, tree: &Tree) -> Vec<usize> {
    if shape.has(Dimension::BaseParameters) {
        (0..base_parameters::of(tree).len()).collect()
    } else {
        Vec::new()
    }
}

/// For each number of an output its place in the other numbering.
fn places_of(shape: Shape, maps: &Maps, own: &Own) -> Vec<usize> {
    // The columns of a compact output are spread over all speeds.
    let dense = [Dimension::Bodies, Dimension::Three, Dimension::Speeds];
    let counted: &[Dimension] = if shape == Shape::COLUMNS {
        &dense
    } else {
        shape.dimensions
    };
    let all: Vec<usize> = (0..10).collect();
    let mut gathered = vec![0];
    for dimension in counted {
        let map: &[usize] = match dimension {
            Dimension::Three => &all[..3],
            Dimension::LoadComponents => &all[..6],
            Dimension::Values | Dimension::Entries => unreachable!("of a derivative"),
            Dimension::Parameters => &all,
            Dimension::Coordinates => &maps.coordinates,
            Dimension::Speeds => &maps.speeds,
            Dimension::Packed(_) => &own.pairs,
            Dimension::Bodies => &maps.bodies,
            Dimension::BaseParameters => &own.base,
            Dimension::Columns => unreachable!("spread over bodies and speeds"),
            Dimension::FrameSpeeds | Dimension::FrameComponents | Dimension::FramePoints => {
                unreachable!("of a frame")
            }
        };
        gathered = gathered
            .iter()
            .flat_map(|place| map.iter().map(move |index| place * map.len() + index))
            .collect();
    }
    gathered
}

/// For each place of a packed matrix of one model its place among those of another model of the same system.
fn packed_pairs(packed: Packed, maps: &Maps, from: &Tree, to: &Tree) -> Vec<usize> {
    let places = packed.places(from);
    let place = |pair: [usize; 2]| {
        let pair = if packed == Packed::Regressor {
            let [speed, column] = pair;
            [
                maps.speeds[speed],
                10 * maps.bodies[column / 10] + column % 10,
            ]
        } else {
            let [row, column] = pair.map(|speed| maps.speeds[speed]);
            [row.max(column), row.min(column)]
        };
        let found = places.iter().position(|place| *place == pair);
        found.expect("the trees are the same but for their order")
    };
    packed.places(to).into_iter().map(place).collect()
}
