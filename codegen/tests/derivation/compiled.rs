//! Models of this repository, compiled, and their functions evaluated.
#![allow(
    clippy::unwrap_used,
    reason = "functions of tests, which clippy takes for others"
)]

use std::{collections::BTreeMap, fs, path::Path};

use kane_codegen::{
    compile::{self, Emittable},
    config::Functions,
    description::{self, Base, Description, Reading, no_includes, toml},
    diagnostic::Source,
    expr::Input,
    options::Options,
    tree::{self, Tree},
};

use crate::evaluator::product;

/// The model at a path of the repository.
pub(crate) fn read(path: &str, reading: &Reading) -> Tree {
    tree::build(&described(path, reading)).unwrap().tree
}

/// A robot of the repository; those with legs stand free.
pub(crate) fn robot(name: &str) -> Tree {
    let (path, reading) = file(name);
    read(&path, &reading)
}

/// The same as it is written in our own format.
pub(crate) fn written(name: &str) -> String {
    let (path, reading) = file(name);
    toml::write(&described(&path, &reading)).unwrap()
}

fn file(name: &str) -> (String, Reading) {
    let base = ["solo12", "talos"].contains(&name).then_some(Base::Free);
    let path = format!("tests/robots/{name}/{name}.urdf");
    let reading = Reading {
        base,
        ..Reading::default()
    };
    (path, reading)
}

fn described(path: &str, reading: &Reading) -> Description {
    let path = format!("{}/../{path}", env!("CARGO_MANIFEST_DIR"));
    let folder = Path::new(&path).parent().unwrap();
    let include = |own: &str| fs::read(folder.join(own));
    let source = Source::new(path.as_str(), fs::read_to_string(&path).unwrap());
    description::read(&source, reading, &include)
}

/// The model that a text describes.
pub(crate) fn built(name: &str, text: String, reading: &Reading) -> Tree {
    let description = description::read(&Source::new(name, text), reading, &no_includes);
    tree::build(&description).unwrap().tree
}

/// Numbers between -1 and 1 without a pattern; quaternions have length one.
pub(crate) fn input(tree: &Tree, given: Input) -> f64 {
    if let Input::Q(id) = given
        && let Some((_, own)) = tree.quaternions().find(|(_, own)| own.contains(&id))
    {
        let numbers = own.map(|component| number(1.0, component.index()));
        return number(1.0, id.index()) / libm::sqrt(numbers.iter().map(|e| e * e).sum());
    }
    let (kind, place) = match given {
        Input::Q(id) => (1.0, id.index()),
        Input::U(id) => (2.0, id.index()),
        Input::UDot(id) => (3.0, id.index()),
        Input::Tau(id) => (4.0, id.index()),
        Input::Force(body, axis) => (5.0, 3 * body.index() + axis),
        Input::Moment(body, axis) => (6.0, 3 * body.index() + axis),
        Input::Sine(place) => {
            let angle = tree.angles()[place].coordinate;
            return libm::sin(input(tree, Input::Q(angle)));
        }
        Input::Cosine(place) => {
            let angle = tree.angles()[place].coordinate;
            return libm::cos(input(tree, Input::Q(angle)));
        }
        Input::Product(of, place) => return product(of, place),
        Input::Parameter(id) => return tree.parameters[id.index()].nominal,
        other => unreachable!("{other:?} is no argument of these functions"),
    };
    number(kind, place)
}

fn number(kind: f64, place: usize) -> f64 {
    libm::sin(12.9 * f64::from(u32::try_from(place).unwrap()) + 7.3 * kind + 0.4)
}

/// The functions of a module that is asked for these, as they are asked for, with their values.
pub(crate) fn compiled(tree: &Tree, names: &[&str]) -> BTreeMap<String, (Emittable, Vec<f64>)> {
    let options = Options {
        functions: Functions::Named(names.iter().map(ToString::to_string).collect()),
        ..Options::default()
    };
    let compiled = compile::compile(tree, &options).unwrap();
    let prepared = compiled.preparation.evaluate(|given| input(tree, given));
    let evaluated = compiled.functions.into_iter().map(|emittable| {
        let values = emittable.program.evaluate(|given| match given {
            Input::Prepared(place) => prepared[place],
            given => input(tree, given),
        });
        (emittable.request.text(), (emittable, values))
    });
    evaluated.collect()
}
