//! `kane.toml`: which systems a repository generates.
//!
//! In: the file. Out: a [`Config`], every fault reported at once otherwise. Afterwards: paths are relative to the
//! file, with `/` between folders, no two systems write one file, and every function named is known.
//! Does not: open the files.

mod budget;
mod changes;
mod functions;
mod outputs;
mod path;
mod prescribed;
mod system;

pub use changes::Changed;
pub use functions::Named;
pub use path::clean_path;
pub use prescribed::Prescribed;
pub use system::System;

pub use crate::options::{Formulation, Functions};

use crate::{
    description::toml_reader::Reader,
    diagnostic::{Diagnostic, Diagnostics, Source},
};

/// What a `kane.toml` asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// The systems, in the order of the file.
    pub systems: Vec<System>,
    /// The models of all systems, also of those with faults, relative to the file; `None` if a fault leaves some unknown.
    pub models: Option<Vec<String>>,
}

/// Reads a `kane.toml`.
///
/// ```
/// use kane_codegen::config::{self, Functions};
/// use kane_codegen::diagnostic::Source;
///
/// let text = "[[system]]\nmodel = \"models/arm.toml\"\noutput = \"generated/arm.rs\"\nfunctions = [\"bias\"]\n";
/// let config = config::parse(&Source::new("kane.toml", text)).unwrap();
/// assert_eq!(config.systems[0].options.functions, Functions::Named(vec!["bias".to_owned()]));
/// ```
///
/// # Errors
/// Everything that is wrong with the file.
pub fn parse(source: &Source) -> Result<Config, Diagnostics> {
    let (config, faults) = read(source);
    faults.map(|()| config)
}

/// Reads a `kane.toml`: the systems that could be read, and everything that is wrong with the file.
pub fn read(source: &Source) -> (Config, Result<(), Diagnostics>) {
    let mut reader = Reader::default();
    let document = reader.document(source);
    let (mut systems, mut outputs) = (Vec::new(), Vec::new());
    let mut models = None;
    if !(document.is_empty() && reader.has_faults()) {
        let root = reader.root(&document, &["system"]);
        // A key that is repeated or unknown may stand for systems.
        let is_whole = !reader.has_faults();
        let item = reader.required(&root, "system", "[[system]]");
        let is_absent = item.is_none();
        let items = item.and_then(|item| reader.list(item, "`system`", "tables, `[[system]]`"));
        let are_known = is_whole && (is_absent || items.is_some());
        if let (Some([]), Some(item)) = (items.as_deref(), item) {
            let fault = Diagnostic::error("`system` is an empty list");
            reader.faults.push(
                fault
                    .at(item.span().into(), "expected one or more")
                    .help("write a table `[[system]]` for each"),
            );
        }
        let mut named = Vec::new();
        for (index, item) in items.unwrap_or_default().into_iter().enumerate() {
            let system::Read {
                model,
                system,
                output,
            } = system::read(&mut reader, item, index + 1);
            named.push(model);
            systems.extend(system);
            outputs.extend(output);
        }
        outputs::check(&mut reader, &outputs);
        let named: Option<Vec<String>> = named.into_iter().collect();
        models = named.filter(|_| are_known);
    }
    let faults = if reader.has_faults() {
        Err(Diagnostics::new(source.clone(), reader.faults.into_told()))
    } else {
        Ok(())
    };
    (Config { systems, models }, faults)
}
