//! A module's functions and those of its mutants, evaluated side by side: which mutants change a value, and which of these
//! the tests of values beside the module see.

use std::collections::BTreeMap;

use kane_test_support::{
    compare::{distance, larger, largest},
    mutant::Mutant,
    random::Random,
};

use super::{
    expected::{Expected, STATES},
    interpreter::{Function, Numbers, Places},
};

/// How many states say that a mutant changes nothing: numbers anywhere between -1 and 1, and parameters of bodies that there
/// can be, near those of the tests' second state.
const DRAWN: usize = 100;

/// How far parameters are from these, as a part of them.
const NEAR: f64 = 0.1;

/// How far rounding leads two ways to one number apart: relative to the largest number of an output, or to how fast it moves
/// with what it is computed from. Solutions with a mass matrix that keeps few digits move fast.
const ROUNDING: f64 = 1e-13;

/// By which part everything is moved to see how fast an output moves.
const NUDGE: f64 = 1e-9;

/// What is known of a mutant without a compiler.
#[derive(Debug, PartialEq)]
pub(super) enum Verdict {
    /// No value changes by more than rounding.
    Harmless,
    /// A value changes, and so does one that the tests expect.
    Seen,
    /// A value of this function changes, and the tests of values pass.
    Unseen(String),
}

/// Functions by their names, with what they write.
type Outputs = BTreeMap<String, Vec<Vec<Numbers>>>;

/// A module, evaluated in the states of its tests and in those drawn.
pub(super) struct Evaluated {
    expected: Expected,
    functions: BTreeMap<String, Function>,
    given: Places,
    outputs: Outputs,
    /// The outputs of all that is given, [`NUDGE`]d.
    nudged: Outputs,
}

impl Evaluated {
    pub(super) fn new(module: &str, tests: &str) -> Self {
        let functions = module.match_indices("\npub fn ").map(|(start, _)| {
            let text = item(module, start + 1);
            (name(text).to_owned(), Function::parse(text))
        });
        let mut evaluated = Self {
            expected: Expected::parse(tests),
            functions: functions.collect(),
            given: Places::new(),
            outputs: Outputs::new(),
            nudged: Outputs::new(),
        };
        let arguments = evaluated.arguments(module);
        let mut nudged = arguments.clone();
        let mut random = Random::new(1);
        for number in nudged.values_mut().flatten() {
            *number *= 1.0 + NUDGE * random.symmetric();
        }
        let [arguments, nudged] = [arguments, nudged].map(|mut given| {
            given.extend(prepared(preparation(module), &given));
            given
        });
        evaluated.outputs = evaluated.all(&arguments);
        evaluated.nudged = evaluated.all(&nudged);
        evaluated.given = arguments;
        for (name, outputs) in &evaluated.outputs {
            assert!(evaluated.expected.passes(name, outputs), "{name} as it is");
        }
        evaluated
    }

    /// Compares a mutant with the module.
    pub(super) fn verdict(&self, mutant: &Mutant) -> Verdict {
        let text = &mutant.module;
        let start = text[..mutant.place].rfind("pub fn ").unwrap();
        let changed = if text[..start].ends_with('\n') {
            let text = item(text, start);
            let function = Function::parse(text);
            let outputs = function.outputs(&self.given, STATES + DRAWN);
            Outputs::from([(name(text).to_owned(), outputs)])
        } else {
            let mut given = self.given.clone();
            given.extend(prepared(preparation(text), &self.given));
            self.all(&given)
        };
        let harmed = |name: &&String| self.is_harmed(name, &changed[*name]);
        let Some(harmed) = changed.keys().find(harmed) else {
            return Verdict::Harmless;
        };
        let mut changed = changed.iter();
        if changed.all(|(name, outputs)| self.expected.passes(name, outputs)) {
            Verdict::Unseen(harmed.clone())
        } else {
            Verdict::Seen
        }
    }

    fn all(&self, given: &Places) -> Outputs {
        let functions = self.functions.iter();
        let outputs = functions
            .map(|(name, function)| (name.clone(), function.outputs(given, STATES + DRAWN)));
        outputs.collect()
    }

    /// Whether what a function writes differs by more than rounding in a state that was drawn.
    fn is_harmed(&self, name: &str, wrong: &[Vec<Numbers>]) -> bool {
        let (right, nudged) = (&self.outputs[name], &self.nudged[name]);
        (STATES..STATES + DRAWN).any(|state| {
            let [right, nudged, wrong] = [right, nudged, wrong].map(|outputs| -> Vec<f64> {
                outputs.iter().flatten().map(|entry| entry[state]).collect()
            });
            let speed = distance(&nudged, &right) / NUDGE;
            let allowed = ROUNDING * larger(largest(&right), speed);
            // A state without values says nothing; what is not a number beside one is another one.
            allowed.is_finite() && !(distance(&wrong, &right) <= allowed)
        })
    }

    /// Every place of an argument that the module's text has, in all states.
    fn arguments(&self, module: &str) -> Places {
        let is_of_place = |c: char| c.is_ascii_alphanumeric() || "_[].".contains(c);
        let words = module.split(|c| !is_of_place(c));
        let known = words.filter_map(|word| {
            let given = [0, 1].map(|state| self.expected.given(word, state));
            let [Some(first), Some(second)] = given else {
                return None;
            };
            let seed = word
                .bytes()
                .fold(0, |seed: u64, byte| seed.wrapping_mul(31) + u64::from(byte));
            let mut drawn = Random::new(seed).numbers(DRAWN);
            if word.starts_with("parameters.") {
                for number in &mut drawn {
                    *number = second * (1.0 + NEAR * *number);
                }
            }
            Some((word.to_owned(), [vec![first, second], drawn].concat()))
        });
        known.collect()
    }
}

/// The function that begins at a place of a module.
fn item(module: &str, start: usize) -> &str {
    let text = &module[start..];
    // What writes nothing has no lines.
    let end = ["\n}\n", " {}\n"].map(|end| text.find(end).map(|place| place + end.len()));
    &text[..end.into_iter().flatten().min().unwrap()]
}

/// What `Prepared::new` makes of parameters.
fn prepared(preparation: &str, given: &Places) -> Places {
    Function::parse(preparation).prepared(given, STATES + DRAWN)
}

/// `Prepared::new`.
fn preparation(module: &str) -> &str {
    let start = module.find("pub fn new(parameters").unwrap();
    let end = module[start..].find("\n    }\n").unwrap();
    &module[start..start + end + 6]
}

fn name(function: &str) -> &str {
    let name = function["pub fn ".len()..].split(['<', '(']).next();
    name.unwrap()
}
