//! Names in C that two modules of one `kane.toml` declare: their headers, and their Rust sides in one library, would clash.

use std::collections::BTreeSet;

use kane_codegen::{
    companions::HEADER,
    diagnostic::{Diagnostic, Diagnostics, Source},
    generate::Generated,
    printers::c,
};

use crate::cli::{
    Failures,
    job::{self, Job, Listing},
};

/// What a module declares in C, and where it is listed.
struct Declaring<'a> {
    listing: &'a Listing,
    module: &'a str,
    identifiers: BTreeSet<&'a str>,
}

/// Generates every module, or says what is wrong with any of them, alone or beside the others.
pub(crate) fn generate(jobs: &[Job]) -> Result<Vec<Generated>, Failures> {
    let modules = job::generate(jobs)?;
    check(jobs, &modules)?;
    Ok(modules)
}

/// Refuses modules that declare the same.
fn check(jobs: &[Job], modules: &[Generated]) -> Result<(), Failures> {
    let pairs = jobs.iter().zip(modules);
    let declaring: Vec<Declaring<'_>> = pairs
        .filter_map(|(job, generated)| declaring(job, generated))
        .collect();
    let mut failures = Failures::default();
    for (place, second) in declaring.iter().enumerate() {
        for first in &declaring[..place] {
            if let Some(fault) = fault(first, second) {
                let source = Source::clone(&second.listing.config);
                failures.add(Diagnostics::new(source, vec![fault]));
            }
        }
    }
    failures.none()
}

fn declaring<'a>(job: &'a Job, generated: &'a Generated) -> Option<Declaring<'a>> {
    let listing = job.listing.as_ref()?;
    let module = &job.options.module;
    let mut companions = generated.companions.iter();
    let header = companions.find(|companion| companion.ending == HEADER)?;
    Some(Declaring {
        listing,
        module,
        identifiers: c::identifiers(&header.text, module),
    })
}

/// That both declare a name.
fn fault(first: &Declaring<'_>, second: &Declaring<'_>) -> Option<Diagnostic> {
    let mut shared = first.identifiers.intersection(&second.identifiers);
    let name = shared.next()?;
    let others = match shared.count() {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    let fault = Diagnostic::error(format!(
        "the modules `{}` and `{}` both declare `{name}`{others} in C",
        first.module, second.module
    ));
    let fault = fault.at(second.listing.output, "the second one");
    let fault = fault.at(first.listing.output, "the first one");
    Some(fault.help("names in C begin with that of the module: rename one file, or the function"))
}
