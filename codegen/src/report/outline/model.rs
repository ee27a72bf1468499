//! The outline of a model.

use toml::{Table, Value};

use super::{
    motions,
    system::{Body, INERTIAL, LOWER, Layout, Outline, Values},
};
use crate::{
    description::{Description, toml as our_format},
    diagnostic::Diagnostics,
    origin,
    tree::Tree,
};

impl Outline {
    /// The outline of a model; the tree is that of the description.
    ///
    /// # Errors
    /// What the description lacks; nothing where it made a tree.
    pub fn of_model(description: &Description, tree: &Tree) -> Result<Self, Diagnostics> {
        let text = our_format::write(description)?;
        let mut system: Table = text.parse().expect("what we write is TOML");
        let lower_bodies = system.remove("lower_bodies");
        let lower_bodies = lower_bodies.as_ref().and_then(Value::as_array);
        let [bodies, frames] = ["body", "frame"].map(|key| system.remove(key));
        let [tables, frames] = [&bodies, &frames].map(|list| tables_of(list.as_ref()));
        let name = |table: &Table| table["name"].as_str().unwrap_or_default().to_owned();
        let lower = |number: &Value| {
            let number = usize::try_from(number.as_integer()?).ok()?;
            let below = number.checked_sub(1).and_then(|place| tables.get(place));
            Some(below.map_or_else(|| INERTIAL.to_owned(), |table| name(table)))
        };
        let lower_bodies = lower_bodies.into_iter().flatten();
        let mut motions = motions::by_body(tree);
        let bodies = tables.iter().zip(lower_bodies).map(|(table, number)| {
            let mut values = Values::new();
            for (key, value) in table.iter().filter(|(key, _)| *key != "name") {
                flatten(key, value, &mut values);
            }
            values.extend(lower(number).map(|lower| (LOWER.to_owned(), lower)));
            let name = name(table);
            Body {
                motions: motions.remove(&name),
                name,
                values,
            }
        });
        let bodies = bodies.collect();
        let mut values = Values::new();
        for (key, value) in &system {
            flatten(key, value, &mut values);
        }
        for frame in frames {
            for (key, value) in frame.iter().filter(|(key, _)| *key != "name") {
                let key = format!("frame {}: {key}", name(frame));
                flatten(&key, value, &mut values);
            }
            let body = format!("frame {}: body", name(frame));
            values.entry(body).or_insert_with(|| INERTIAL.to_owned());
        }
        let names = tree.bodies.iter().map(|body| body.name.clone());
        let parameters = tree
            .parameters
            .iter()
            .map(|parameter| parameter.name.clone());
        Ok(Self {
            fingerprint: Some(origin::fingerprint(tree)),
            values,
            bodies,
            layouts: vec![
                (Layout::Bodies, names.collect()),
                (Layout::Coordinates, tree.coordinate_names()),
                (Layout::Speeds, tree.speed_names()),
                (Layout::Parameters, parameters.collect()),
            ],
        })
    }
}

/// The tables of a list.
fn tables_of(list: Option<&Value>) -> Vec<&Table> {
    let list = list.and_then(Value::as_array);
    let tables = list.into_iter().flatten();
    tables.filter_map(Value::as_table).collect()
}

/// Keys of tables with dots between them; a number in its binding time is one value.
fn flatten(key: &str, value: &Value, values: &mut Values) {
    match value {
        Value::Table(table) => match table.get("runtime") {
            Some(nominal) => {
                values.insert(key.to_owned(), format!("{nominal} at run time"));
            }
            None => {
                for (part, value) in table {
                    flatten(&format!("{key}.{part}"), value, values);
                }
            }
        },
        Value::String(text) => {
            values.insert(key.to_owned(), text.clone());
        }
        plain => {
            values.insert(key.to_owned(), plain.to_string());
        }
    }
}
