//! What is known of a model, for programs.

use kane_codegen::{
    functions::Formulation,
    id::BodyId,
    listing::Limits,
    program::Operations,
    report::{self, Cell, Counts, Partitions},
    tree::{self, Coordinate, Order, Tree},
};
use serde_json::{Map, Value, json};

use crate::cli::text::json;

use super::{
    facts::{gravity, is_default, is_pictured, lifted, lower_number},
    mechanics,
};

pub(super) fn value(tree: &Tree, counts: &[Counts]) -> Value {
    let order = match tree.order {
        Order::Body => "body",
        Order::Notes => "notes",
    };
    let bodies: Value = tree.body_ids().map(|body| body_value(tree, body)).collect();
    let counts: Value = counts.iter().map(counts_value).collect();
    let parameter = |parameter: &tree::Parameter| {
        let body = parameter.body.map(|body| body.index() + 1);
        json!({ "name": parameter.name, "body": body, "nominal": parameter.nominal, "unit": parameter.unit })
    };
    let mut value = json!({
        "name": tree.name,
        "gravity": gravity(tree),
        "order": order,
        "bodies": bodies,
        "coordinates": coordinates_value(tree),
        "speeds": tree.speed_names(),
        "limits": limits_value(&Limits::of(tree)),
        "frames": tree.frames.iter().map(frame_value).collect::<Value>(),
        "partitions": is_pictured(tree).then(|| partitions_value(&report::partitions(tree))),
        "parameters": tree.parameters.iter().map(parameter).collect::<Value>(),
        "functions": counts,
    });
    if !tree.markers.is_empty() {
        value["markers"] = tree.markers.iter().map(frame_value).collect();
    }
    value
}

fn body_value(tree: &Tree, id: BodyId) -> Value {
    let body = tree.body(id);
    let joint = &body.joint;
    let mut free = Vec::new();
    let mut locked = Map::new();
    let mut mimics = Map::new();
    for (motion, kind) in joint.motion_names().into_iter().enumerate() {
        match joint.coordinate_of(motion) {
            Some(Coordinate::Free { .. }) | None => free.push(kind),
            Some(Coordinate::Locked(value)) => {
                locked.insert(kind.to_owned(), value.into());
            }
            Some(Coordinate::Mimic {
                coordinate,
                multiplier,
                offset,
                ..
            }) => {
                let value = json!({ "coordinate": coordinate.index(), "multiplier": multiplier, "offset": offset });
                mimics.insert(kind.to_owned(), value);
            }
        }
    }
    let mut value = json!({
        "number": id.index() + 1,
        "user_number": body.user_number,
        "name": body.name,
        "identifier": body.identifier,
        "joint": joint.name,
        "lower_body": lower_number(tree, id),
        "free": free,
        "locked": locked,
        "mimics": mimics,
    });
    if let Some(share) = lifted(tree, id) {
        value["gravity_compensation"] = share.into();
    }
    for (kind, values) in mechanics::of_joint(tree, joint) {
        value[kind] = values.into();
    }
    value
}

fn frame_value(frame: &tree::Frame) -> Value {
    json!({
        "name": frame.name,
        "body": frame.body.map_or(0, |body| body.index() + 1),
        "rotation": frame.rotation,
        "position": frame.position,
    })
}

fn coordinates_value(tree: &Tree) -> Value {
    let mut values = vec![Value::Null; tree.n_coordinates];
    let names = tree.coordinate_names();
    for (body, number) in tree.bodies.iter().zip(1..) {
        for (kind, coordinate) in body.joint.coordinates() {
            let place = coordinate.index();
            values[place] = json!({ "place": place, "name": names[place], "body": number, "kind": kind.name(), "unit": kind.unit() });
        }
    }
    values.into()
}

/// As the constants of a module have them, by coordinates and by speeds; null where there is none.
fn limits_value(limits: &Limits) -> Value {
    json!({
        "lower": limits.lower,
        "upper": limits.upper,
        "velocity": limits.velocity,
        "effort": limits.effort,
        "friction": limits.friction,
    })
}

fn partitions_value(partitions: &Partitions) -> Value {
    let numbers = |cells: &Vec<Cell>| -> Value {
        let cells = cells.iter().zip(1_usize..);
        cells
            .filter(|(cell, _)| **cell != Cell::Zero)
            .map(|(_, number)| number)
            .collect()
    };
    let rows = partitions
        .angular
        .iter()
        .zip(&partitions.origin)
        .zip(&partitions.mass_center);
    rows.zip(1_usize..)
        .map(|(((angular, origin), mass_center), body)| {
            json!({ "body": body, "W": numbers(angular), "V_O": numbers(origin), "V_G": numbers(mass_center) })
        })
        .collect()
}

fn counts_value(counts: &Counts) -> Value {
    let formulation = |(formulation, operations): &(Formulation, Operations)| {
        (formulation.name().to_owned(), json::operations(operations))
    };
    let formulations: Map<String, Value> = counts.formulations.iter().map(formulation).collect();
    json!({
        "name": counts.function.text(),
        "default": is_default(counts),
        "formulations": formulations,
        "cheapest": counts.cheapest.map(Formulation::name),
    })
}
