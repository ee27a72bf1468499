//! The schemas for editors: what they accept, what they refuse, and that they have the keys and words that the readers know.

use std::{collections::BTreeSet, fs, path::PathBuf};

use kane_codegen::{
    config,
    description::toml,
    diagnostic::{Diagnostics, Source},
    recursive::Technique,
    tree,
};
use serde_json::{Map, Value};

use crate::page::{self, repository};

/// A schema with what it defines.
struct Schema(Value);

impl Schema {
    fn of(name: &str) -> Self {
        let path = repository(&format!("docs/schemas/{name}.schema.json"));
        Self(serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap())
    }

    fn accepts(&self, text: &str) -> Result<(), String> {
        let table: ::toml::Table = text.parse().map_err(|error| format!("{error}"))?;
        let value = serde_json::to_value(table).unwrap();
        self.check(&self.0, &value, "")
    }

    /// Those keywords of draft 7 that the schemas use; any other is a fault of the schema.
    fn check(&self, schema: &Value, value: &Value, place: &str) -> Result<(), String> {
        for (keyword, rule) in schema.as_object().unwrap() {
            let holds = match keyword.as_str() {
                "$schema" | "title" | "description" | "definitions" => true,
                "required" | "properties" => {
                    // Both speak of tables alone.
                    value.as_object().is_none_or(|table| {
                        keyword == "properties"
                            || texts(rule).iter().all(|key| table.contains_key(key))
                    })
                }
                "additionalProperties" => self.entries(schema, rule, value, place)?,
                "$ref" => {
                    let name = rule.as_str().unwrap().strip_prefix("#/definitions/");
                    self.check(&self.0["definitions"][name.unwrap()], value, place)?;
                    true
                }
                "anyOf" => {
                    let mut choices = rule.as_array().unwrap().iter();
                    choices.any(|choice| self.check(choice, value, place).is_ok())
                }
                "items" => {
                    for item in value.as_array().into_iter().flatten() {
                        self.check(rule, item, &format!("{place}[]"))?;
                    }
                    true
                }
                _ => holds(keyword, rule, value),
            };
            if !holds {
                return Err(format!(
                    "{place}: {keyword} {rule} does not hold of {value}"
                ));
            }
        }
        Ok(())
    }

    /// Whether a table has the keys that it may have; each value is checked.
    fn entries(
        &self,
        schema: &Value,
        others: &Value,
        value: &Value,
        place: &str,
    ) -> Result<bool, String> {
        let none = Map::new();
        let known = schema["properties"].as_object().unwrap_or(&none);
        for (key, entry) in value.as_object().into_iter().flatten() {
            let place = format!("{place}.{key}");
            match known.get(key) {
                Some(rule) => self.check(rule, entry, &place)?,
                None if others == &Value::Bool(false) => return Ok(false),
                None => self.check(others, entry, &place)?,
            }
        }
        Ok(true)
    }
}

/// A rule that concerns one value alone.
fn holds(keyword: &str, rule: &Value, value: &Value) -> bool {
    let length = value.as_array().map(Vec::len);
    let letters = value.as_str().map(str::len);
    let size = value.as_object().map(Map::len);
    let limit = rule.as_u64().and_then(|limit| usize::try_from(limit).ok());
    let number = value.as_f64();
    match keyword {
        "type" => match rule.as_str().unwrap() {
            "object" => value.is_object(),
            "array" => value.is_array(),
            "string" => value.is_string(),
            "boolean" => value.is_boolean(),
            "number" => value.is_number(),
            "integer" => value.is_i64() || value.is_u64(),
            other => panic!("unknown type {other}"),
        },
        "enum" => rule.as_array().unwrap().contains(value),
        "minItems" => length.is_none_or(|length| length >= limit.unwrap()),
        "maxItems" => length.is_none_or(|length| length <= limit.unwrap()),
        "minLength" => letters.is_none_or(|length| length >= limit.unwrap()),
        "minProperties" => size.is_none_or(|size| size >= limit.unwrap()),
        "minimum" => number.is_none_or(|number| number >= rule.as_f64().unwrap()),
        "exclusiveMaximum" => number.is_none_or(|number| number < rule.as_f64().unwrap()),
        "uniqueItems" => value.as_array().is_none_or(|list| {
            let texts: BTreeSet<String> = list.iter().map(ToString::to_string).collect();
            texts.len() == list.len()
        }),
        _ => panic!("this test does not know the keyword {keyword}"),
    }
}

fn texts(list: &Value) -> Vec<String> {
    let entries = list.as_array().unwrap().iter();
    entries
        .map(|text| text.as_str().unwrap().to_owned())
        .collect()
}

/// Files of a folder that end in `toml`.
fn files(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(repository(folder)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .collect();
    paths.sort();
    paths
}

fn model_is_right(text: &str) -> bool {
    tree::build(&toml::parse(&Source::new("model.toml", text))).is_ok()
}

#[test]
fn right_models_are_accepted() {
    let schema = Schema::of("model");
    let folders = [
        "models",
        "codegen/tests/models",
        "codegen/tests/fuzzed",
        "tests/reference",
        "examples/optimal/models",
    ];
    let mut seen = 0;
    for path in folders.into_iter().flat_map(files) {
        let text = fs::read_to_string(&path).unwrap();
        if model_is_right(&text) {
            let accepted = schema.accepts(&text);
            assert!(accepted.is_ok(), "{}: {accepted:?}", path.display());
            seen += 1;
        }
    }
    assert!(seen > 8, "{seen} models");
}

#[test]
fn models_and_configurations_of_the_pages_are_accepted() {
    let mut seen = (0, 0);
    for page in page::all() {
        for block in page.blocks.iter().filter(|block| block.language == "toml") {
            let accepted = if block.text.contains("[[system]]") {
                seen.0 += 1;
                Schema::of("kane").accepts(&block.text)
            } else if block.text.contains("lower_bodies") {
                seen.1 += 1;
                Schema::of("model").accepts(&block.text)
            } else {
                continue;
            };
            assert!(accepted.is_ok(), "{}: {accepted:?}", page.path);
        }
    }
    assert!(seen.0 > 2 && seen.1 > 1, "{seen:?}");
    let own = fs::read_to_string(repository("kane.toml")).unwrap();
    Schema::of("kane").accepts(&own).unwrap();
}

/// What a schema cannot say, such as which inertia is a body's, the reader says. These it can say.
#[test]
fn keys_and_words_that_are_unknown_are_refused() {
    for (schema, folder, faults) in [
        (
            "model",
            "codegen/tests/invalid",
            &["unknown", "misspelt", "missing_"][..],
        ),
        (
            "kane",
            "codegen/tests/invalid/config",
            &[
                "unknown_key",
                "unknown_base",
                "unknown_technique",
                "missing_output",
            ][..],
        ),
    ] {
        let schema = Schema::of(schema);
        let mut seen = 0;
        for path in files(folder) {
            let name = path.file_stem().unwrap().to_str().unwrap();
            // An unknown joint or body is a word of the model's own.
            let own = [
                "mimic_of_unknown_joint",
                "unknown_lower_body",
                "frame_in_unknown_body",
            ]
            .contains(&name);
            if !own && faults.iter().any(|fault| name.contains(fault)) {
                let text = fs::read_to_string(&path).unwrap();
                assert!(schema.accepts(&text).is_err(), "{name} is accepted");
                seen += 1;
            }
        }
        assert!(seen >= 4, "{folder}: {seen}");
    }
}

/// The keys that a reader names when it meets one that it does not know.
fn known_keys(faults: &Diagnostics) -> BTreeSet<String> {
    let text = faults.to_string();
    let list = text.split("here are ").nth(1);
    let line = list.unwrap_or_else(|| panic!("{text}")).lines().next();
    let names = line.unwrap().split('`').skip(1).step_by(2);
    names.map(str::to_owned).collect()
}

fn of_model(text: &str) -> BTreeSet<String> {
    let description = toml::parse(&Source::new("model.toml", text));
    known_keys(&tree::build(&description).unwrap_err())
}

fn keys(schema: &Value) -> BTreeSet<String> {
    schema["properties"]
        .as_object()
        .unwrap()
        .keys()
        .cloned()
        .collect()
}

#[test]
fn the_schema_of_models_has_the_keys_of_the_reader() {
    let schema = Schema::of("model").0;
    let body = &schema["definitions"]["body"];
    for (text, part) in [
        ("xxxxxxxxxxxxxxxx = 1\n", &schema),
        ("[[body]]\nxxxxxxxxxxxxxxxx = 1\n", body),
        (
            "[[body]]\ninertia = { xxxxxxxxxxxxxxxx = 1 }\n",
            &body["properties"]["inertia"],
        ),
        (
            "[[body]]\nmimic = { xxxxxxxxxxxxxxxx = 1 }\n",
            &body["properties"]["mimic"],
        ),
        (
            "[[frame]]\nxxxxxxxxxxxxxxxx = 1\n",
            &schema["definitions"]["frame"],
        ),
    ] {
        assert_eq!(of_model(text), keys(part), "after {text}");
    }
}

#[test]
fn the_schema_of_kane_toml_has_the_keys_and_words_of_the_reader() {
    let schema = Schema::of("kane").0;
    let system = &schema["properties"]["system"]["items"];
    let read = |text: &str| config::parse(&Source::new("kane.toml", text)).unwrap_err();
    let known = known_keys(&read("[[system]]\nxxxxxxxxxxxxxxxx = 1\n"));
    assert_eq!(known, keys(system));
    let techniques = Technique::ALL.map(|(name, _)| name.to_owned());
    let words = texts(&system["properties"]["without"]["items"]["enum"]);
    assert_eq!(
        words.into_iter().collect::<BTreeSet<_>>(),
        techniques.into_iter().collect()
    );
}
