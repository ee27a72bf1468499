//! What tests beside a module say: the states in which they call its functions, and the numbers that they expect.

use std::collections::BTreeMap;

use syn::{Expr, Item, Member, UnOp};

use super::interpreter::{Numbers, number};

/// The tests' two states.
pub(super) const STATES: usize = 2;

/// An output of a function in a state: the numbers with their tolerances, each of one entry or of a sum of so many.
struct Output {
    numbers: Vec<[f64; 2]>,
    entries: usize,
}

/// The constants and expectations of the tests beside a module.
pub(super) struct Expected {
    /// By the text of their place, as `STATES[0].q[3]`.
    constants: BTreeMap<String, f64>,
    /// For each function its outputs, in each state.
    outputs: BTreeMap<String, [Vec<Output>; STATES]>,
}

impl Expected {
    pub(super) fn parse(tests: &str) -> Self {
        let mut expected = Self {
            constants: BTreeMap::new(),
            outputs: BTreeMap::new(),
        };
        for item in syn::parse_file(tests).unwrap().items {
            match item {
                Item::Const(constant) => {
                    list(
                        &constant.expr,
                        constant.ident.to_string(),
                        &mut expected.constants,
                    );
                }
                Item::Fn(function) => {
                    let name = function.sig.ident.to_string();
                    let constant = function.block.stmts.first();
                    if let (Some(name), Some(syn::Stmt::Item(Item::Const(constant)))) =
                        (name.strip_suffix("_has_its_values"), constant)
                    {
                        let outputs = outputs(&constant.expr, &entries(tests, name));
                        expected.outputs.insert(name.to_owned(), outputs);
                    }
                }
                _ => {}
            }
        }
        expected
    }

    /// What an argument's place is in a state, as the tests call functions.
    pub(super) fn given(&self, place: &str, state: usize) -> Option<f64> {
        let end = place.find(['[', '.']).unwrap_or(place.len());
        let (argument, rest) = place.split_at(end);
        let constant = match argument {
            "parameters" => format!("PARAMETERS[{state}]"),
            "tau" => format!("FORCES[{state}]"),
            "loads" => format!("LOADS[{state}]"),
            "w_rel" => format!("RELATIVE_ANGULAR_VELOCITIES[{state}]"),
            argument => format!("STATES[{state}].{argument}"),
        };
        self.constants.get(&format!("{constant}{rest}")).copied()
    }

    /// Whether the test of a function's values is passed with what it writes in the tests' states, which come first.
    pub(super) fn passes(&self, function: &str, written: &[Vec<Numbers>]) -> bool {
        let states = self.outputs[function].iter().enumerate();
        states
            .flat_map(|(state, outputs)| outputs.iter().zip(written).map(move |pair| (state, pair)))
            .all(|(state, (output, written))| {
                let entries: Vec<f64> = written.iter().map(|entry| entry[state]).collect();
                let sums: Vec<f64> = entries.chunks(output.entries).map(sum).collect();
                sums.len() == output.numbers.len()
                    && sums
                        .iter()
                        .zip(&output.numbers)
                        .all(|(found, [expected, tolerance])| {
                            (found - expected).abs() <= *tolerance
                        })
            })
    }
}

/// As `kane::self_test` sums.
fn sum(entries: &[f64]) -> f64 {
    match entries {
        [entry] => *entry,
        entries => {
            let terms = entries.iter().enumerate();
            terms
                .map(|(place, entry)| (1 + place * 397 % 1021) as f64 / 1024.0 * entry)
                .sum()
        }
    }
}

/// How many entries make a number of each output of a function.
fn entries(tests: &str, name: &str) -> Vec<usize> {
    let start = tests.find(&format!("fn {name}_has_its_values(")).unwrap();
    let text = &tests[start..];
    let text = &text[..text.find("\n}\n").unwrap()];
    let calls = text.split("has_values(").skip(1);
    let entries = calls.map(|call| call.split(',').nth(2).unwrap().trim().parse().unwrap());
    entries.collect()
}

/// Two states of a tuple of lists of pairs.
fn outputs(expr: &Expr, entries: &[usize]) -> [Vec<Output>; STATES] {
    let states = elements(expr);
    [0, 1].map(|state| {
        let lists = elements(states[state]);
        assert_eq!(lists.len(), entries.len(), "a call for each output");
        let lists = lists.into_iter().zip(entries);
        let outputs = lists.map(|(list, &entries)| Output {
            numbers: elements(list).into_iter().map(pair).collect(),
            entries,
        });
        outputs.collect()
    })
}

fn pair(expr: &Expr) -> [f64; 2] {
    let pair = elements(expr);
    [0, 1].map(|place| literal(pair[place]))
}

fn elements(expr: &Expr) -> Vec<&Expr> {
    match expr {
        Expr::Array(list) => list.elems.iter().collect(),
        Expr::Tuple(list) => list.elems.iter().collect(),
        _ => unreachable!("no function has such a form"),
    }
}

fn literal(expr: &Expr) -> f64 {
    match expr {
        Expr::Lit(literal) => number(&literal.lit),
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => -literal(&unary.expr),
        _ => unreachable!("no function has such a form"),
    }
}

/// The numbers of a constant, by their places.
fn list(expr: &Expr, place: String, constants: &mut BTreeMap<String, f64>) {
    match expr {
        Expr::Array(all) => {
            for (index, expr) in all.elems.iter().enumerate() {
                list(expr, format!("{place}[{index}]"), constants);
            }
        }
        Expr::Struct(fields) => {
            for field in &fields.fields {
                let Member::Named(name) = &field.member else {
                    unreachable!("fields have names")
                };
                list(&field.expr, format!("{place}.{name}"), constants);
            }
        }
        number => drop(constants.insert(place, literal(number))),
    }
}
