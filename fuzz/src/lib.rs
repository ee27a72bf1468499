//! What is done with each invention of the fuzzer: bytes to a model, the model to where it leads, with everything asserted that
//! holds of any model.

mod tree;

use std::collections::BTreeSet;

use arbitrary::Unstructured;
use kane_codegen::companions;
use kane_codegen::config::{Formulation, Functions};
use kane_codegen::description::{Base, Chart, Reading};
use kane_codegen::functions::CATALOGUE;
use kane_codegen::options::Options;
use kane_codegen::recursive::Technique;
use kane_codegen::tree::Changes;
use kane_test_support::promises::{self, Files};

/// The names of models, by their format.
const MODELS: [&str; 3] = ["model.toml", "model.urdf", "model.xml"];

/// Up to this many bodies every function is generated, up to the other one alone or those of one frame, and of more nothing: a
/// run is to be fast.
const FEW_BODIES: (usize, usize) = (2, 6);

/// Reads a model as the command does, but for bytes that are no text, which the command refuses. How it is read follows from
/// how long it is, so that a seed is a model as it stands.
pub fn read(name: &str, data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let reading = reading(data.len(), name != MODELS[0]);
    promises::reading(&Files::new(name, &text), &reading);
}

/// Generates from a text as it stands, or from a tree that is made of the bytes; the first says of which, the next ones how.
pub fn generate(data: &[u8]) {
    let Some((&[format, how, function, technique], rest)) = data.split_first_chunk() else {
        return;
    };
    let name = MODELS.get(usize::from(format % 4)).copied();
    let text = match name {
        Some(_) => String::from_utf8_lossy(rest).into_owned(),
        None => match tree::text(&mut Unstructured::new(rest)) {
            Ok(text) => text,
            Err(_) => return,
        },
    };
    let files = Files::new(name.unwrap_or(MODELS[0]), &text);
    let reading = reading(
        usize::from(format / 4),
        name.is_some_and(|name| name != MODELS[0]),
    );
    let n_bodies = promises::n_bodies(&files, &reading);
    if n_bodies > FEW_BODIES.1 {
        return;
    }
    let of_frames = || {
        let frame = promises::frame(&files, &reading, usize::from(function));
        let asked = frame.map_or_else(Vec::new, |frame| promises::of_frame(&frame));
        match how & 64 {
            0 => asked,
            _ => promises::joined(&asked, usize::from(technique))
                .map(|joined| joined + "(sin_cos)")
                .into_iter()
                .collect(),
        }
    };
    let function = &CATALOGUE[usize::from(function) % CATALOGUE.len()];
    let options = Options {
        reading: reading.clone(),
        changes: Changes::default(),
        prescribed: match how & 128 {
            0 => Vec::new(),
            _ => promises::frame(&files, &reading, usize::from(technique))
                .into_iter()
                .collect(),
        },
        functions: match how % 4 {
            0 if n_bodies <= FEW_BODIES.0 => Functions::All(Vec::new()),
            1 => Functions::Named(vec![format!("{}(sin_cos)", function.name)]),
            2 => Functions::Named(of_frames()),
            _ => Functions::Named(vec![function.name.to_owned()]),
        },
        formulation: Formulation::ALL[usize::from(how / 4) % Formulation::ALL.len()].1,
        fma: how & 16 != 0,
        without: Technique::ALL
            .iter()
            .skip(usize::from(technique))
            .take(1)
            .map(|(_, technique)| *technique)
            .collect(),
        companions: if how & 32 == 0 {
            BTreeSet::new()
        } else {
            companions::CompanionKind::ALL.into()
        },
        module: "model".to_owned(),
    };
    promises::generating(&files, &options);
}

/// One of the ways in which a model can be read.
fn reading(choice: usize, has_choice: bool) -> Reading {
    Reading {
        base: (has_choice && choice & 1 != 0).then_some(Base::Free),
        chart: (has_choice && choice & 2 != 0).then_some(Chart::Angles),
        ..Reading::default()
    }
}
