//! From a checked tree to programs: derive, pass, count, choose.
//!
//! In: a [`Tree`] and [`Options`]. Out: a [`Compiled`] module. Afterwards: each function is in the formulation that
//! was asked for, or in the one with fewer operations, and its program is verified.

use std::{
    collections::{BTreeMap, BTreeSet},
    ops::Range,
};

use crate::{
    companions,
    config::{self, Functions},
    description::Reading,
    emit::Emittable,
    error::Error,
    functions::{CATALOGUE, Derived, Formulation, Function, Parsed, Request, RequestError},
    passes::{factor, hoist, hoist::Preparation, sines},
    program::{self, Operations, Program},
    recursive::{Plan, Technique},
    search, size, threads,
    tree::{Changes, Tree},
};

/// The tolerances to which constant rotations may be snapped: beyond, a joint would be another one.
pub const SNAP_TOLERANCES: Range<f64> = 0.0..1e-2;

/// How a model is read, what is changed of it, and what is generated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// What a URDF or MJCF leaves to the user.
    pub reading: Reading,
    /// What is changed of the description.
    pub changes: Changes,
    /// Which functions. `q_dot` is always among them, and with quaternions `normalize`: the runtime's trait `System` needs
    /// them.
    pub functions: Functions,
    /// In which formulation.
    pub formulation: config::Formulation,
    /// Whether functions fuse products into sums, `Real::mul_add`: faster where the hardware has that, but the last bits
    /// then depend on the machine. `Prepared::new` does not.
    pub fma: bool,
    /// The techniques to leave out.
    pub without: BTreeSet<Technique>,
    /// What else is written, beside the module.
    pub companions: BTreeSet<companions::Kind>,
    /// The module's name, that of its file without the ending, for what is beside it and speaks of it.
    pub module: String,
}

/// A module's programs.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// What depends on parameters alone: one store for each of `fields`.
    pub preparation: Program,
    /// The fields of `Prepared`.
    pub fields: Vec<String>,
    /// The functions, in the order of the catalogue, then the others.
    pub functions: Vec<Emittable>,
}

impl Options {
    /// Refuses what no description can make right.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let tolerance = self.changes.snap;
        if !SNAP_TOLERANCES.contains(&tolerance) {
            return Err(Error::SnapTolerance { tolerance });
        }
        let mut locked = self.changes.lock.iter();
        if let Some((name, value)) = locked.find(|(_, value)| !value.is_finite()) {
            return Err(Error::LockedValue {
                name: name.clone(),
                value: *value,
            });
        }
        let names: Vec<&String> = self.changes.lock.iter().map(|(name, _)| name).collect();
        let twice = (1..names.len()).find(|&place| names[..place].contains(&names[place]));
        if let Some(place) = twice {
            return Err(Error::LockedTwice {
                name: names[place].clone(),
            });
        }
        if !companions::can_be_beside(&self.companions, &self.module) {
            return Err(Error::ModuleName {
                name: self.module.clone(),
            });
        }
        let Functions::Named(names) = &self.functions else {
            return Ok(());
        };
        let fault = names.iter().find_map(|name| Parsed::read(name).err());
        fault.map_or(Ok(()), |fault| {
            Err(match fault {
                RequestError::Unknown { name } => {
                    let known = CATALOGUE.iter().map(|function| function.name).collect();
                    Error::UnknownFunction { name, known }
                }
                fault => Error::Request(fault),
            })
        })
    }

    /// True where the function is to be generated.
    pub fn selects(&self, tree: &Tree, function: &Function) -> bool {
        let always = match function.name {
            "q_dot" => true,
            "normalize" => tree.has_quaternions(),
            _ => false,
        };
        always || self.functions.names(function)
    }

    /// What is to be generated, in the order of a module.
    ///
    /// # Errors
    /// What the model lacks, and two functions of one name.
    pub fn requests(&self, tree: &Tree) -> Result<Vec<Request>, RequestError> {
        let catalogue = CATALOGUE.iter();
        let selected = catalogue.filter(|function| self.selects(tree, function));
        let mut requests: Vec<Request> = selected.map(Request::from).collect();
        let named = self.functions.requests().into_iter();
        for named in named.filter(|named| named.alone().is_none()) {
            requests.push(named.on(tree)?);
        }
        check_names(&requests)?;
        Ok(requests)
    }
}

/// Refuses two functions of one name.
fn check_names(requests: &[Request]) -> Result<(), RequestError> {
    let mut known: BTreeMap<String, &Request> = BTreeMap::new();
    for request in requests {
        if let Some(first) = known.insert(request.name(), request) {
            return Err(RequestError::SameName {
                first: first.text(),
                second: request.text(),
                name: request.name(),
            });
        }
    }
    Ok(())
}

/// Compiles the functions that the options select; no other is derived.
///
/// # Errors
/// Options that cannot be; [`Error::TooLarge`]; [`Error::Unrepresentable`] where the description's numbers multiply to more than f64 holds.
pub fn compile(tree: &Tree, options: &Options) -> Result<Compiled, Error> {
    options.check()?;
    let numbers = tree.frames.iter();
    let mut numbers = numbers.flat_map(|frame| frame.rotation.iter().chain([&frame.position]));
    if !numbers.all(|vector| vector.iter().all(|entry| entry.is_finite())) {
        return Err(Error::Unrepresentable {
            function: "FRAMES".to_owned(),
        });
    }
    let mut preparation = Preparation::default();
    let mut functions = Vec::new();
    let requests = options.requests(tree).map_err(Error::Request)?;
    size::check(tree, &requests, options)?;
    let choices = threads::map(&requests, |function| choose(tree, function, options));
    for (function, choice) in requests.into_iter().zip(choices) {
        let Choice {
            formulation,
            derived,
        } = choice;
        let name = function.name();
        let (graph, roots) = hoist::run(&derived.graph, &derived.roots, &name, &mut preparation);
        if derived.graph.overflowed() || graph.overflowed() {
            return Err(Error::Unrepresentable { function: name });
        }
        let program = program::flatten(&graph, &roots);
        let program = if options.fma {
            program::fuse(program)
        } else {
            program
        };
        verify(&program, &name)?;
        let operations = program.operations();
        functions.push(Emittable {
            function,
            formulation,
            program,
            operations,
            blocks: derived.blocks,
        });
    }
    if preparation.graph.overflowed() {
        return Err(Error::Unrepresentable {
            function: "Prepared::new".to_owned(),
        });
    }
    let fields = program::prepared_fields(&preparation, tree);
    let preparation = program::flatten(&preparation.graph, &preparation.roots());
    verify(&preparation, "Prepared::new")?;
    Ok(Compiled {
        preparation,
        fields,
        functions,
    })
}

/// A function in one formulation.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The formulation.
    pub formulation: Formulation,
    /// The expressions that are emitted.
    pub derived: Derived,
}

/// The function in the formulation that is wanted, where it has it, else in that with the fewest operations: what is
/// emitted.
pub fn choose(tree: &Tree, function: &Request, options: &Options) -> Choice {
    let formulations = function.formulations();
    let of = |formulation| of_formulation(tree, function, formulation, &options.without);
    let wanted = match options.formulation {
        config::Formulation::Cheapest => None,
        config::Formulation::Notes => Some(Formulation::Notes),
        config::Formulation::Recursive => Some(Formulation::Recursive),
    };
    let has = |wanted: &Formulation| formulations.contains(wanted);
    let only = (formulations.len() == 1).then(|| formulations[0]);
    if let Some(formulation) = wanted.filter(has).or(only) {
        return of(formulation);
    }
    let recursive = of(Formulation::Recursive);
    let count = operations(&recursive.derived).total();
    // On a large tree the literal sums alone would take longer than all the rest.
    if count < function.literal_terms(tree) {
        return recursive;
    }
    let notes = of(Formulation::Notes);
    if operations(&notes.derived).total() <= count {
        notes
    } else {
        recursive
    }
}

/// The function in this formulation, by its cheapest plan without some techniques.
pub fn of_formulation(
    tree: &Tree,
    function: &Request,
    formulation: Formulation,
    without: &BTreeSet<Technique>,
) -> Choice {
    let plan = if function.takes_plan(formulation) {
        search::cheapest(tree, function, without)
    } else {
        Plan::plain(tree).with(Technique::Factor, !without.contains(&Technique::Factor))
    };
    Choice {
        formulation,
        derived: candidate(tree, function, formulation, &plan),
    }
}

/// The function in this formulation by this plan, as it would be emitted: its sums factored, and sines and cosines inputs
/// where they are to be given.
pub fn candidate(
    tree: &Tree,
    function: &Request,
    formulation: Formulation,
    plan: &Plan,
) -> Derived {
    let mut derived = function.derive(tree, formulation, plan);
    if plan.uses(Technique::Factor) {
        derived = factored(function, derived);
    }
    given_sines(tree, function, derived)
}

/// A function with its sums factored.
fn factored(function: &Request, derived: Derived) -> Derived {
    let (graph, roots) = if function.compact().is_some() {
        // The pattern of a compact output follows from the tree: nothing to factor across columns.
        (derived.graph, derived.roots)
    } else {
        factor::run(&derived.graph, &derived.roots)
    };
    Derived {
        graph,
        roots,
        blocks: derived.blocks,
    }
}

/// A function with sines and cosines as inputs where they are to be given.
pub(crate) fn given_sines(tree: &Tree, function: &Request, derived: Derived) -> Derived {
    if !function.is_at_sin_cos() {
        return derived;
    }
    let (graph, roots) = sines::run(&derived.graph, &derived.roots, &sines::angles(tree));
    Derived {
        graph,
        roots,
        blocks: derived.blocks,
    }
}

/// The operations that are left in the loop.
pub fn operations(derived: &Derived) -> Operations {
    let mut preparation = Preparation::default();
    let (graph, roots) = hoist::run(&derived.graph, &derived.roots, "", &mut preparation);
    program::flatten(&graph, &roots).operations()
}

fn verify(program: &Program, name: &str) -> Result<(), Error> {
    program::verify(program).map_err(|error| match error {
        program::VerifyError::NotFinite => Error::Unrepresentable {
            function: name.to_owned(),
        },
        bug => unreachable!("program: `{name}` breaks a promise: {bug}"),
    })
}
