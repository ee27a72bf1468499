//! A whole module as data.

use std::collections::BTreeSet;

use super::{
    Code, Entry, Expression, Facts, Function, Member, Pattern, Statement, Step, code,
    code::{Known, MOST_ANGLES},
    facts::Wanted,
    function::places,
    group::Groups,
    name::{self, Counted},
    verify::{verify, verify_facts},
};
use crate::{
    compile::Compiled,
    compile::Emittable,
    expr::Input,
    functions::{Argument, Request, Signature},
    origin::Origin,
    program::{Operations, Program},
    threads,
    tree::Tree,
};

/// What a module says and does.
#[derive(Clone, Debug)]
pub struct Module {
    /// What is known beside the functions.
    pub facts: Facts,
    /// Writes the nominal parameters.
    pub nominal: Function,
    /// Computes what depends on parameters alone.
    pub prepare: Function,
    /// Takes sines and cosines, for functions that are given them.
    pub sin_cos: Option<Function>,
    /// What was asked for, in order.
    pub functions: Vec<Function>,
}

impl Module {
    /// The module of a tree with these programs.
    ///
    /// # Panics
    /// Where the listing breaks a promise: a bug of ours.
    pub fn new(tree: &Tree, origin: Origin, compiled: &Compiled) -> Self {
        let facts = Facts::of(tree, origin, &compiled.fields, wanted(&compiled.functions));
        let writer = Writer {
            tree,
            compiled,
            facts: &facts,
        };
        let module = Self {
            nominal: nominal(&facts),
            prepare: writer.prepare(&compiled.preparation),
            sin_cos: facts.angles.as_ref().map(|_| sin_cos(&facts)),
            functions: threads::map(&compiled.functions, |emittable| writer.function(emittable)),
            facts,
        };
        if let Err(fault) = module.verify() {
            unreachable!("listing: {fault}");
        }
        module
    }

    /// Checks what every listing holds.
    fn verify(&self) -> Result<(), String> {
        verify_facts(&self.facts).map_err(|fault| fault.to_string())?;
        self.all().try_for_each(|function| {
            let name = &function.signature.name;
            verify(&self.facts, function).map_err(|fault| format!("`{name}`: {fault}"))
        })
    }

    /// All functions: those that others need before, then what was asked for.
    pub fn all(&self) -> impl Iterator<Item = &Function> {
        [&self.nominal, &self.prepare]
            .into_iter()
            .chain(&self.sin_cos)
            .chain(&self.functions)
    }

    /// Those that say what they cost.
    pub fn costed(&self) -> impl Iterator<Item = &Function> {
        self.all().skip(1)
    }

    /// The function of this name, among those asked for.
    pub fn function(&self, name: &str) -> Option<&Function> {
        let mut functions = self.functions.iter();
        functions.find(|function| function.signature.name == name)
    }
}

/// What the functions want of the facts.
fn wanted(functions: &[Emittable]) -> Wanted {
    let any = |is: fn(&Request) -> bool| functions.iter().any(|one| is(&one.function));
    let mut known = BTreeSet::new();
    let patterns = functions.iter().filter_map(|emittable| {
        let function = emittable.function.compact()?;
        known.insert(function.name).then(|| Pattern {
            function: function.name,
            columns: function.columns_constant(),
            blocks: function.blocks_constant(),
            doc: format!(
                "The non-zero partitions that `{}` writes, body after body.",
                function.name
            ),
            n_columns: emittable.program.stores.len() / 3,
            entries: emittable.blocks.clone(),
        })
    });
    Wanted {
        patterns: patterns.collect(),
        angles: any(Request::is_at_sin_cos),
        packed: any(Request::is_packed),
    }
}

/// What functions are made from.
struct Writer<'a> {
    tree: &'a Tree,
    compiled: &'a Compiled,
    facts: &'a Facts,
}

impl Writer<'_> {
    fn function(&self, emittable: &Emittable) -> Function {
        let (request, program) = (&emittable.function, &emittable.program);
        let signature = request.signature();
        let places = places(&signature, self.facts);
        let code = self.code(program, &signature, places, Counted::InFunction);
        let of_frame = request.alone_of_frame();
        Function {
            alone: request.alone(),
            of_frame: of_frame.map(|(function, subject)| (function, subject.clone())),
            pattern: self.pattern(emittable),
            formulation: emittable.formulation,
            has_choice: request.formulations().len() > 1,
            fused: program.fused(),
            ..Function::plain(signature, emittable.operations, code)
        }
    }

    /// The pattern that stands before a function: before the first that writes such an output.
    fn pattern(&self, emittable: &Emittable) -> Option<usize> {
        let name = |one: &Emittable| one.function.compact().map(|function| function.name);
        let own = name(emittable)?;
        let mut functions = self.compiled.functions.iter();
        let first = functions.find(|other| name(other) == Some(own))?;
        let mut patterns = self.facts.patterns.iter();
        let place = patterns.position(|pattern| pattern.function == own);
        place.filter(|_| std::ptr::eq(first, emittable))
    }

    fn prepare(&self, program: &Program) -> Function {
        let signature = Signature::prepare();
        let argument = signature.arguments.len() - 1;
        let places = self.compiled.fields.iter().map(|field| Entry {
            argument,
            steps: vec![self.prepared(field)],
        });
        let code = self.code(
            program,
            &signature,
            places.collect(),
            Counted::InPreparation,
        );
        Function::plain(signature, program.operations(), code)
    }

    fn code(
        &self,
        program: &Program,
        signature: &Signature,
        places: Vec<Entry>,
        counted: Counted,
    ) -> Code {
        let groups = Groups::of(program);
        let arguments = signature.arguments.iter();
        let arguments = arguments.map(|argument| argument.name.as_str());
        let names = name::names(program, &groups, self.tree, arguments, counted);
        let known = Known {
            groups: &groups,
            names: &names,
            entry: &|input| self.entry(input, signature),
        };
        code::of(program, &known, places)
    }

    /// Where a function finds an input.
    fn entry(&self, input: Input, signature: &Signature) -> Entry {
        let (name, steps) = match input {
            Input::Q(id) => (Argument::Q.name(), vec![Step::Index(id.index())]),
            Input::U(id) => (Argument::U.name(), vec![Step::Index(id.index())]),
            Input::UDot(id) => (Argument::UDot.name(), vec![Step::Index(id.index())]),
            Input::Tau(id) => (Argument::Tau.name(), vec![Step::Index(id.index())]),
            Input::Sine(place) => ("sin_cos", of_member(Member::Sines, place)),
            Input::Cosine(place) => ("sin_cos", of_member(Member::Cosines, place)),
            Input::Force(body, axis) => (
                Argument::Loads.name(),
                [
                    vec![Step::Index(body.index())],
                    of_member(Member::Force, axis),
                ]
                .concat(),
            ),
            Input::Moment(body, axis) => (
                Argument::Loads.name(),
                [
                    vec![Step::Index(body.index())],
                    of_member(Member::Moment, axis),
                ]
                .concat(),
            ),
            Input::RelativeAngularVelocity(body, axis) => (
                Argument::RelativeAngularVelocity.name(),
                vec![Step::Index(body.index()), Step::Index(axis)],
            ),
            Input::Parameter(id) => (
                "parameters",
                vec![Step::Member(Member::Parameter(id.index()))],
            ),
            Input::Prepared(place) => ("p", vec![self.prepared(&self.compiled.fields[place])]),
        };
        let mut arguments = signature.arguments.iter();
        let argument = arguments.position(|argument| argument.name == name);
        let argument =
            argument.unwrap_or_else(|| unreachable!("listing: {} has no `{name}`", signature.name));
        Entry { argument, steps }
    }

    fn prepared(&self, field: &String) -> Step {
        let place = self.facts.fields.binary_search(field);
        let place = place.unwrap_or_else(|_| unreachable!("listing: no field `{field}`"));
        Step::Member(Member::Prepared(place))
    }
}

fn of_member(member: Member, place: usize) -> Vec<Step> {
    vec![Step::Member(member), Step::Index(place)]
}

fn nominal(facts: &Facts) -> Function {
    let signature = Signature::nominal();
    let places = places(&signature, facts);
    let stores = places.into_iter().zip(&facts.parameters);
    let stores = stores.map(|(place, parameter)| Statement::Store {
        place,
        value: Expression::Number(parameter.nominal),
    });
    let code = Code {
        statements: stores.collect(),
        ..Code::default()
    };
    Function::plain(signature, Operations::default(), code)
}

fn sin_cos(facts: &Facts) -> Function {
    let signature = Signature::sin_cos();
    let angles = facts.angles.as_deref().unwrap_or_default();
    let mut arguments = signature.arguments.iter();
    let q = arguments.position(|argument| argument.name == Argument::Q.name());
    let q = q.expect("listing: sines are those of coordinates");
    let places = places(&signature, facts);
    let (sines, cosines) = places.split_at(angles.len());
    let calls = angles
        .chunks(MOST_ANGLES)
        .zip(sines.chunks(MOST_ANGLES).zip(cosines.chunks(MOST_ANGLES)));
    let calls = calls.map(|(angles, (sines, cosines))| Statement::StoreSinCos {
        angles: angles
            .iter()
            .map(|angle| {
                Expression::Entry(Entry {
                    argument: q,
                    steps: vec![Step::Index(angle.coordinate)],
                })
            })
            .collect(),
        sines: sines.to_vec(),
        cosines: cosines.to_vec(),
    });
    let operations = Operations {
        trig: 2 * angles.len(),
        ..Operations::default()
    };
    let code = Code {
        statements: calls.collect(),
        ..Code::default()
    };
    Function::plain(signature, operations, code)
}
