//! The arguments that say what is generated of a model, and how.
//!
//! In: arguments. Out: what they ask for, read, to stand above what `kane.toml` says.

use std::path::Path;

use clap::Args;
use kane_codegen::{
    choices::name_of,
    config::Named,
    functions::Parsed,
    options::{Formulation, Functions, Options},
    recursive::Technique,
};

use crate::cli::{
    Failures,
    arguments::{
        changes::ChangesArguments,
        functions::{functions, names},
        parse::one_of,
    },
    job::Listing,
    listed,
};

/// What is generated of a model, and how.
#[derive(Args, Debug)]
pub(crate) struct OptionsArguments {
    /// The functions, comma-separated; `all` for every function of the system, `default` for the default set
    ///
    /// `kane info MODEL --functions all` lists the functions of the system. `mass_matrix+bias` is one function that computes both, and
    /// `step = mass_matrix+bias` names it; `bias(sin_cos)` takes the sines and cosines of the angles as inputs. `q_dot`, and with
    /// quaternions `normalize`, are always generated: the trait `kane::System` needs them.
    #[arg(long, value_name = "A,B", requires = "model")]
    functions: Option<Vec<String>>,

    /// How to compute sums over bodies: `notes`, term by term as in the lecture notes that docs/equations.md cites; `recursive`,
    /// along the tree; `cheapest`, whichever costs less
    #[arg(long, value_name = "WHICH", requires = "model", value_parser = one_of(Formulation::ALL))]
    formulation: Option<Formulation>,

    /// Use fused multiply-add: faster on hardware that has it, but the last bits then depend on the machine
    ///
    /// Generated code calls `kane::Real::mul_add`. It is one instruction if the compilation target has one (x86 with
    /// `-C target-feature=+fma` or a `target-cpu` that has it, 64-bit Arm), else two. `--fma=false` overrides
    /// `fma = true` in `kane.toml`.
    #[arg(
        long,
        value_name = "BOOL",
        requires = "model",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "true"
    )]
    fma: Option<bool>,

    /// Operation-saving techniques to disable, comma-separated; the values stay the same
    #[arg(long, value_name = "A,B", requires = "model", value_delimiter = ',', value_parser = one_of(Technique::ALL))]
    without: Vec<Technique>,

    #[command(flatten)]
    changes: ChangesArguments,
}

/// What is asked for, read.
pub(crate) struct Asked<'a> {
    arguments: &'a OptionsArguments,
    functions: Option<Functions>,
}

impl OptionsArguments {
    /// What is asked for, or everything that is wrong with it.
    pub(crate) fn read(&self) -> Result<Asked<'_>, Failures> {
        let mut failures = Failures::default();
        let functions = self
            .functions
            .as_deref()
            .map(|lists| functions(lists, None))
            .transpose();
        let functions = failures.keep(functions).flatten();
        failures.keep(self.changes.check());
        failures.none()?;
        Ok(Asked {
            arguments: self,
            functions,
        })
    }

    /// What is wrong with the model, and what it lacks of that, beside names that are none.
    pub(crate) fn lacking(&self, model: &Path) -> Failures {
        let asked = self.functions.as_deref().unwrap_or_default();
        let Ok(mut job) = listed::looked_at(model, &self.changes, asked) else {
            return Failures::default();
        };
        let known = names(asked).into_iter();
        let known = known.filter(|name| Parsed::read(name).is_ok());
        job.options.functions = Functions::Named(known.map(str::to_owned).collect());
        job.check_model().err().unwrap_or_default()
    }

    /// The same arguments, as words of a command.
    pub(crate) fn words(&self) -> Vec<String> {
        let mut words = Vec::new();
        let mut push = |word: &str| words.push(word.to_owned());
        if let Some(functions) = &self.functions {
            push("--functions");
            push(&functions.join(","));
        }
        if let Some(formulation) = self.formulation {
            push("--formulation");
            push(name_of(&formulation, &Formulation::ALL));
        }
        if !self.without.is_empty() {
            push("--without");
            let names = self.without.iter();
            let names: Vec<&str> = names.map(|one| name_of(one, &Technique::ALL)).collect();
            push(&names.join(","));
        }
        if let Some(fma) = self.fma {
            push(if fma { "--fma" } else { "--fma=false" });
        }
        words.extend(self.changes.words());
        words
    }
}

impl Asked<'_> {
    /// True where functions are asked for, in place of those that `kane.toml` has.
    pub(crate) fn says_functions(&self) -> bool {
        self.functions.is_some()
    }

    /// Leaves out what `kane.toml` names and it names others for.
    pub(crate) fn replace(&self, listing: &mut Listing) {
        if self.functions.is_some() {
            listing.functions = Named::default();
        }
        self.arguments.changes.replace(listing);
    }

    /// Sets what is asked for, above what was said before.
    pub(crate) fn set(&self, options: &mut Options) {
        let arguments = self.arguments;
        arguments.changes.set(options);
        let Options {
            functions,
            formulation,
            fma,
            without,
            ..
        } = options;
        if let Some(asked) = &self.functions {
            functions.clone_from(asked);
        }
        *formulation = arguments.formulation.unwrap_or(*formulation);
        *fma = arguments.fma.unwrap_or(*fma);
        if !arguments.without.is_empty() {
            *without = arguments.without.iter().copied().collect();
        }
    }
}
