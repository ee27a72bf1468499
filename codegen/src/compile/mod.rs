//! From a checked tree to programs: refuse, derive, pass, count, choose.
//!
//! In: a [`Tree`] and [`Options`]. Out: a [`Compiled`] module. Afterwards: each function is in the formulation that
//! [`choose`] takes, and its program is verified.

mod arranged;
mod branches;
mod cheapest;
mod choose;
mod fields;
mod notes;
mod option_check;
mod pipeline;
mod planned;
mod plans;
mod search;
mod size_check;
mod sweeps;
mod warnings;

pub use cheapest::cheapest;
pub use choose::{Choice, choose, of_formulation};
pub(crate) use notes::cost_no_more as notes_cost_no_more;
pub(crate) use option_check::check as check_options;
pub use planned::{Planned, by_plan, cost, emitted, operations};
pub use plans::Plans;
pub use size_check::check as check_size;
pub use warnings::nothing_prescribed;
pub(crate) use warnings::warnings;

use pipeline::Lowering;

use crate::{
    error::Error,
    functions::{CompactBlock, Formulation, PREPARED_NEW, Request},
    options::Options,
    passes::hoist::Preparation,
    program::{self, Operations, Program},
    threads,
    tree::Tree,
};

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

/// A function that was compiled.
#[derive(Clone, Debug)]
pub struct Emittable {
    /// What was asked for.
    pub request: Request,
    /// How the sums over bodies are associated.
    pub formulation: Formulation,
    /// The program; its inputs may be prepared values.
    pub program: Program,
    /// Its operations.
    pub operations: Operations,
    /// For compact outputs: the non-zero partitions.
    pub blocks: Vec<CompactBlock>,
}

/// Compiles the functions that the options select; no other is derived.
///
/// # Errors
/// Options that cannot be; [`Error::TooLarge`]; [`Error::Unrepresentable`] where the description's numbers multiply to more than f64 holds.
pub fn compile(tree: &Tree, options: &Options) -> Result<Compiled, Error> {
    check_options(options)?;
    check_frames(tree)?;
    let mut preparation = Preparation::default();
    let mut functions = Vec::new();
    let requests = options.requests(tree).map_err(Error::Requests)?;
    check_size(tree, &requests, options)?;
    let plans = Plans::new(tree, &options.without);
    let choices = threads::map(&requests, |request| {
        choose(&plans, request, options.formulation)
    });
    let lowering = Lowering {
        fuses: options.fma,
        ..Lowering::without(&options.without)
    };
    for (request, choice) in requests.into_iter().zip(choices) {
        let Choice {
            formulation,
            derived,
        } = choice;
        let name = request.name();
        let program = pipeline::program(tree, &request, &derived, &mut preparation, lowering);
        let Some(program) = program else {
            return Err(Error::Unrepresentable { what: name });
        };
        verify(&program, &name)?;
        let operations = program.operations();
        functions.push(Emittable {
            request,
            formulation,
            program,
            operations,
            blocks: derived.blocks,
        });
    }
    if preparation.graph.overflowed() {
        return Err(Error::Unrepresentable {
            what: PREPARED_NEW.to_owned(),
        });
    }
    let fields = fields::names(&preparation, tree);
    let preparation = program::flatten(&preparation.graph, &preparation.roots());
    verify(&preparation, PREPARED_NEW)?;
    Ok(Compiled {
        preparation,
        fields,
        functions,
    })
}

/// Checks the poses of frames, which a module has whatever is asked for.
fn check_frames(tree: &Tree) -> Result<(), Error> {
    let vectors = tree.frames.iter().chain(&tree.markers);
    let vectors = vectors.flat_map(|frame| frame.rotation.iter().chain([&frame.position]));
    if vectors.flatten().all(|entry| entry.is_finite()) {
        Ok(())
    } else {
        Err(Error::Unrepresentable {
            what: "FRAMES".to_owned(),
        })
    }
}

fn verify(program: &Program, name: &str) -> Result<(), Error> {
    program::verify(program).map_err(|error| match error {
        program::VerifyError::NotFinite => Error::Unrepresentable {
            what: name.to_owned(),
        },
        bug => unreachable!("program: `{name}` breaks a promise: {bug}"),
    })
}
