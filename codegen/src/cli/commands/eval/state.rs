//! The state at which a function is evaluated: a JSON file.
//!
//! In: its text, the tree, the function. Out: a number for every input the function may read, parameters included. All faults
//! are reported at once, in the file's own words: `loads[2].force` counts from 0, as the arrays do.

use std::collections::{BTreeMap, BTreeSet};

use kane_codegen::{
    diagnostic::{Diagnostic, Diagnostics, Escaped, Faults, NearNames, Severity, Source, Span},
    expr::Input,
    functions::{Argument, Dimension, Element, Function, PARAMETERS, Request, variable_elsewhere},
    id::ParameterId,
    tree::{Changes, Tree},
};
use serde_json::{Map, Value, error::Category};

use crate::cli::commands::eval::{
    by_name::{Places, elsewhere, held},
    place::{self, Place},
    unique::Unique,
};

/// The values of inputs.
pub(crate) type State = BTreeMap<Input, f64>;

/// So many faults are shown where they stand: to find each, the text is read again.
const MOST_PLACED: usize = 100;

/// Reads the state of a tree, as far as the function needs it; what else the file holds must be right as well.
///
/// # Errors
/// Everything that is wrong with the file.
pub(crate) fn read(
    source: &Source,
    tree: &Tree,
    function: &Request,
    changes: &Changes,
) -> Result<State, Diagnostics> {
    let mut reader = Reader {
        text: source.text(),
        tree,
        changes,
        state: nominal(tree),
        faults: Faults::default(),
        near: NearNames::default(),
    };
    match serde_json::from_str(source.text()) {
        Ok(Unique(Value::Object(file))) => reader.file(&file, function),
        Ok(Unique(other)) => reader.fault(format!(
            "the file holds {}; expected an object such as {{\"q\": [...]}}",
            described(&other)
        )),
        Err(error) => reader.faults.push(not_json(source, &error)),
    }
    reader.sines();
    if reader.faults.count() == 0 {
        Ok(reader.state)
    } else {
        Err(Diagnostics::new(source.clone(), reader.faults.into_told()))
    }
}

/// A state that holds nothing, for a function that needs no more.
pub(crate) fn of_no_inputs(tree: &Tree, function: &Request) -> Option<Source> {
    let arguments = function.arguments();
    let is_empty = |argument: &Argument| argument.lengths(tree).contains(&0);
    arguments
        .iter()
        .all(is_empty)
        .then(|| Source::new("no state", "{}"))
}

/// The parameters' own values.
fn nominal(tree: &Tree) -> State {
    let parameters = tree.parameters.iter().enumerate();
    parameters
        .map(|(place, parameter)| (Input::Parameter(ParameterId::new(place)), parameter.nominal))
        .collect()
}

struct Reader<'a> {
    text: &'a str,
    tree: &'a Tree,
    changes: &'a Changes,
    state: State,
    faults: Faults,
    near: NearNames,
}

impl Reader<'_> {
    /// The file lacks what the function needs.
    fn missing(&mut self, argument: Argument, function: &Request) {
        let (name, expected) = (argument.name(), self.expected(argument));
        let message = format!(
            "`{}` needs `{name}`, which is missing; expected {expected}",
            function.text()
        );
        let is_turned = argument == Argument::Q && self.tree.quaternions().next().is_some();
        let help = Places::of(self.tree, argument).map(|_| {
            let quaternions = if is_turned {
                ", and quaternions no rotation"
            } else {
                ""
            };
            format!("`\"{name}\": {{}}` means that all are zero{quaternions}")
        });
        self.faults.push(Diagnostic::error(message).help_if(help));
    }

    /// What is wrong with the file.
    fn fault(&mut self, message: String) {
        self.faults.push(Diagnostic::error(message));
    }

    /// What is wrong with a value.
    fn fault_at(&mut self, place: &Place, message: String) {
        let fault = self.placed(Diagnostic::error(message), || place.span(self.text));
        self.faults.push(fault);
    }

    /// What is wrong with a key.
    fn fault_of_key(&mut self, place: &Place, fault: Diagnostic) {
        let fault = self.placed(fault, || place.key_span(self.text));
        self.faults.push(fault);
    }

    fn placed(&self, fault: Diagnostic, span: impl FnOnce() -> Option<Span>) -> Diagnostic {
        let is_shown = self.faults.count() < MOST_PLACED;
        fault.at_if(is_shown.then(span).flatten(), "here")
    }

    fn file(&mut self, file: &Map<String, Value>, function: &Request) {
        // Directions and multipliers are the function's: those of others may have other shapes.
        let own = function.arguments();
        let plain = Argument::ALL.into_iter();
        let plain = plain.filter(|one| !one.is_of_product());
        let all: BTreeSet<Argument> = plain.chain(own.iter().copied()).collect();
        let keys = all.iter().map(|argument| argument.name());
        let keys: Vec<&str> = keys.chain([PARAMETERS]).collect();
        let others = Argument::ALL.into_iter().map(Argument::name);
        let others: BTreeSet<&str> = others.chain(Function::multipliers()).collect();
        let mut asked = file.clone();
        asked.retain(|key, _| keys.contains(&key.as_str()) || !others.contains(key.as_str()));
        self.unknown_keys(None, &asked, &keys);
        for argument in all {
            match file.get(argument.name()) {
                Some(value) => self.argument(argument, value),
                None if own.contains(&argument) && !self.is_empty(argument) => {
                    self.missing(argument, function);
                }
                None => {}
            }
        }
        match file.get(PARAMETERS) {
            None => {}
            Some(Value::Object(values)) => self.parameters(values),
            Some(other) => self.fault_at(
                &Place::of(PARAMETERS),
                format!(
                    "`{PARAMETERS}` is {}; expected an object of names and numbers",
                    described(other)
                ),
            ),
        }
    }

    /// True for what no number is to be given of.
    fn is_empty(&self, argument: Argument) -> bool {
        argument.lengths(self.tree).contains(&0)
    }

    fn argument(&mut self, argument: Argument, value: &Value) {
        let lengths = argument.lengths(self.tree);
        let expected = self.expected(argument);
        if let (Value::Object(named), Some(places)) = (value, Places::of(self.tree, argument)) {
            return self.by_name(argument, named, &places);
        }
        let mut place = 0;
        self.array(
            argument,
            &Place::of(argument.name()),
            value,
            (&lengths, &expected),
            &mut place,
        );
    }

    /// An argument whose places are given by names.
    fn by_name(&mut self, argument: Argument, named: &Map<String, Value>, places: &Places) {
        let lengths = argument.lengths(self.tree);
        let inner = lengths.get(1..).unwrap_or_default();
        let n_own = inner.iter().product::<usize>() * argument.element().n_numbers();
        for (place, &number) in places.otherwise.iter().enumerate() {
            let inputs = (place * n_own..(place + 1) * n_own).map(|own| argument.input(own));
            self.state.extend(inputs.map(|input| (input, number)));
        }
        let mut given: BTreeMap<usize, &str> = BTreeMap::new();
        for (name, value) in named {
            let what = Place::of(argument.name()).key(name);
            if let Some(place) = places.place(name) {
                if let Some(other) = given.insert(place, name) {
                    let other = other.escaped();
                    let fault = format!("`{what}` is `{other}` by another name; expected one");
                    self.fault_of_key(&what, Diagnostic::error(fault));
                }
                let mut first = place * n_own;
                self.array(argument, &what, value, (inner, &numbers(inner)), &mut first);
            } else if !self.faults.is_full(Severity::Error) {
                let fault =
                    Diagnostic::error(format!("`{what}` names none of the {}", places.kind));
                // Names of speeds end in it, and are listed without.
                let name = name.strip_suffix("_dot").unwrap_or(name);
                let help = elsewhere(self.tree, argument, name)
                    .or_else(|| held(self.changes, argument, name))
                    .unwrap_or_else(|| self.known_names(name, &places.names(), places.kind));
                self.fault_of_key(&what, fault.help(help));
            }
        }
    }

    /// An array of these lengths, or one element; `place` counts the numbers before it.
    fn array(
        &mut self,
        argument: Argument,
        what: &Place,
        value: &Value,
        (lengths, expected): (&[usize], &str),
        place: &mut usize,
    ) {
        let Some((&length, inner)) = lengths.split_first() else {
            return self.element(argument, what, value, place);
        };
        let Some(items) = self.list(what, value, expected, length) else {
            *place += lengths.iter().product::<usize>() * argument.element().n_numbers();
            return;
        };
        let expected = numbers(inner);
        for (index, item) in items.iter().enumerate() {
            let what = what.index(index);
            self.array(argument, &what, item, (inner, &expected), place);
        }
    }

    /// One element: a number, or an object of vectors.
    fn element(&mut self, argument: Argument, what: &Place, value: &Value, place: &mut usize) {
        let vectors = argument.element().vectors();
        if vectors.is_empty() {
            self.number(what, value, argument.input(*place));
        } else {
            self.vectors(argument, what, value, (vectors, *place));
        }
        *place += argument.element().n_numbers();
    }

    /// The sines and cosines of the angles, which some functions are given.
    fn sines(&mut self) {
        for (place, angle) in self.tree.angles().into_iter().enumerate() {
            if let Some(&angle) = self.state.get(&Input::Q(angle.coordinate)) {
                let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
                self.state.insert(Input::Sine(place), sine);
                self.state.insert(Input::Cosine(place), cosine);
            }
        }
    }

    /// What was probably meant.
    fn known_names(&mut self, name: &str, known: &[&str], what: &str) -> String {
        match self.near.nearest(name, known.iter().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None if known.is_empty() => format!("there are no {what}"),
            None => format!("the {what} are {}", known.join(", ")),
        }
    }

    /// What an argument should be.
    fn expected(&self, argument: Argument) -> String {
        let shape = argument.shape();
        let lengths = argument.lengths(self.tree);
        let (Some((length, inner)), Some(dimension)) =
            (lengths.split_first(), shape.dimensions.first())
        else {
            return numbers(&lengths);
        };
        if *dimension == Dimension::Three || lengths == [1] {
            return numbers(&lengths);
        }
        let of = match (inner, argument.element()) {
            ([], Element::Load) => "loads".to_owned(),
            ([], _) => "numbers".to_owned(),
            (inner, _) => numbers(inner).replacen("a list", "lists", 1),
        };
        format!("a list of {length} {of}, one {}", dimension.one())
    }

    fn vectors(
        &mut self,
        argument: Argument,
        what: &Place,
        value: &Value,
        (names, first): (&[&str], usize),
    ) {
        let Value::Object(element) = value else {
            let names = names.iter();
            let vectors: Vec<String> = names.map(|name| format!("\"{name}\": [x, y, z]")).collect();
            let (found, expected) = (described(value), vectors.join(", "));
            return self.fault_at(
                what,
                format!("`{what}` is {found}; expected {{{expected}}}"),
            );
        };
        self.unknown_keys(Some(what), element, names);
        for (name, place) in names.iter().zip((first..).step_by(3)) {
            match element.get(*name) {
                Some(value) => {
                    self.vector(&what.key(name), value, |axis| argument.input(place + axis));
                }
                None => self.fault_at(
                    what,
                    format!("`{what}` has no `{name}`; expected {}", numbers(&[3])),
                ),
            }
        }
    }

    fn vector(&mut self, what: &Place, value: &Value, input: impl Fn(usize) -> Input) {
        let items = self.list(what, value, &numbers(&[3]), 3);
        for (axis, item) in items.into_iter().flatten().enumerate() {
            self.number(&what.index(axis), item, input(axis));
        }
    }

    fn parameters(&mut self, values: &Map<String, Value>) {
        let tree = self.tree;
        let names: Vec<&str> = tree
            .parameters
            .iter()
            .map(|parameter| parameter.name.as_str())
            .collect();
        for (name, value) in values {
            let what = Place::of(PARAMETERS).key(name);
            if let Some(place) = names.iter().position(|known| known == name) {
                let input = Input::Parameter(ParameterId::new(place));
                self.number(&what, value, input);
            } else if !self.faults.is_full(Severity::Error) {
                let name_shown = name.escaped();
                let fault = format!("`{PARAMETERS}` names `{name_shown}`, which is no parameter");
                let help = self.known_names(name, &names, "parameters");
                self.fault_of_key(&what, Diagnostic::error(fault).help(help));
            }
        }
    }

    /// The entries, if they are as many as they should be.
    fn list<'v>(
        &mut self,
        what: &Place,
        value: &'v Value,
        expected: &str,
        length: usize,
    ) -> Option<&'v Vec<Value>> {
        match value {
            Value::Array(items) if items.len() == length => Some(items),
            Value::Array(items) => {
                let found = count_of(items.len());
                self.fault_at(what, format!("`{what}` has {found}; expected {expected}"));
                None
            }
            other => {
                let found = described(other);
                self.fault_at(what, format!("`{what}` is {found}; expected {expected}"));
                None
            }
        }
    }

    fn number(&mut self, what: &Place, value: &Value, input: Input) {
        match value.as_f64() {
            Some(number) => {
                self.state.insert(input, number);
            }
            None => self.fault_at(
                what,
                format!("`{what}` is {}; expected a number", described(value)),
            ),
        }
    }

    /// `of` is the place of an object; `None` is the whole file.
    fn unknown_keys(&mut self, of: Option<&Place>, object: &Map<String, Value>, known: &[&str]) {
        let what = of.map_or_else(|| "the file".to_owned(), |of| format!("`{of}`"));
        for key in object.keys().filter(|key| !known.contains(&key.as_str())) {
            if self.faults.is_full(Severity::Error) {
                return;
            }
            let fault = format!("{what} has the unknown key `{}`", key.escaped());
            let own = variable_elsewhere(key).filter(|own| known.contains(own));
            let help = own.map(|own| format!("here it is called `{own}`"));
            let help = help.unwrap_or_else(|| self.known_names(key, known, "keys"));
            let place = of.map_or_else(|| Place::of(key), |of| of.key(key));
            self.fault_of_key(&place, Diagnostic::error(fault).help(help));
        }
    }
}

/// Entries of a list, in words.
fn count_of(entries: usize) -> String {
    let word = if entries == 1 { "entry" } else { "entries" };
    format!("{entries} {word}")
}

/// Nested lists of numbers, in words.
fn numbers(lengths: &[usize]) -> String {
    match lengths {
        [] => "a number".to_owned(),
        [1] => "a list of one number".to_owned(),
        [length] => format!("a list of {length} numbers"),
        [length, inner @ ..] => {
            let inner = numbers(inner).replacen("a list", "lists", 1);
            format!("a list of {length} {inner}")
        }
    }
}

fn not_json(source: &Source, error: &serde_json::Error) -> Diagnostic {
    let (line, column) = (error.line(), error.column());
    let before = source
        .text()
        .split_inclusive('\n')
        .take(line.saturating_sub(1));
    let start = before.map(str::len).sum::<usize>() + column.saturating_sub(1);
    let text = error.to_string();
    let place = format!(" at line {line} column {column}");
    let reason = text.strip_suffix(&place).unwrap_or(&text);
    let message = match error.classify() {
        Category::Data => reason.to_owned(),
        _ => format!("not valid JSON: {reason}"),
    };
    // The reader stops at the end of a key.
    let key = (error.classify() == Category::Data)
        .then(|| place::string_span(source.text().get(..=start)?))
        .flatten();
    let span = key.unwrap_or((start..start + 1).into());
    Diagnostic::error(message).at(span, "here")
}

/// What a value is, in words.
fn described(value: &Value) -> String {
    match value {
        Value::Null => "null".to_owned(),
        Value::Bool(value) => value.to_string(),
        Value::Number(number) => format!("the number {number}"),
        Value::String(_) => "a string".to_owned(),
        Value::Array(_) => "a list".to_owned(),
        Value::Object(_) => "an object".to_owned(),
    }
}
