//! Functions of a listing, from programs.

use std::collections::BTreeSet;

use super::{
    InputPlaces,
    given_names::{GivenNames, Known},
    group::Groups,
    helper,
    input_names::InputNames,
    loops,
    name::{self, Numbering},
    scratch::Scratch,
    signatures, stages, statements,
    statements::ProgramContext,
};
use crate::listing::{Code, Entry, Facts, Function, Helper, Member, Step, function::places};
use crate::{
    compile::{Compiled, Emittable},
    expr::Input,
    functions::{Argument, PARAMETERS, PREPARED, SIN_COS, Signature},
    program::{self, Program},
    threads,
    tree::Tree,
};

/// What functions are made from.
pub(in crate::listing) struct FunctionWriter<'a> {
    tree: &'a Tree,
    compiled: &'a Compiled,
    facts: &'a Facts,
    /// Where each prepared value stands among the fields.
    fields: Vec<usize>,
    /// What locals that hold inputs are called.
    inputs: InputNames,
}

/// A program that becomes the body of a function.
struct Body<'b> {
    program: &'b Program,
    signature: &'b Signature,
    /// Where inputs stand among the arguments.
    given: InputPlaces,
    /// What locals are called that hold what a helper is given.
    names: &'b GivenNames,
    scratch: &'b Scratch,
    /// Where outputs go.
    places: Vec<Entry>,
    /// See [`ProgramContext::keeps_apart`].
    keeps_apart: bool,
    numbering: Numbering,
}

impl<'a> FunctionWriter<'a> {
    pub(in crate::listing) fn new(
        tree: &'a Tree,
        compiled: &'a Compiled,
        facts: &'a Facts,
    ) -> Self {
        Self {
            tree,
            compiled,
            facts,
            fields: places_of(&compiled.fields, &facts.fields),
            inputs: InputNames::of(tree),
        }
    }

    /// The functions that were compiled, in order.
    pub(in crate::listing) fn functions(&self) -> Vec<Function> {
        let functions = self.compiled.functions.iter();
        let sums: Vec<String> = functions.map(|own| own.request.sum()).collect();
        // A trait is implemented once, whatever other names what it stands for has.
        let mut known = BTreeSet::new();
        let places = sums.iter().enumerate();
        let places = places.map(|(place, sum)| (place, known.insert(sum)));
        let places: Vec<(usize, bool)> = places.collect();
        threads::map(&places, |&(place, is_first)| self.function(place, is_first))
    }

    fn function(&self, place: usize, is_first: bool) -> Function {
        let emittable = &self.compiled.functions[place];
        let (request, program) = (&emittable.request, &emittable.program);
        let signature = request.signature();
        let arguments = request.arguments();
        let scratch = Scratch::of(program, signature.arguments.len());
        let code = self.code(&Body {
            program,
            signature: &signature,
            given: self.given(&arguments),
            names: &GivenNames::default(),
            scratch: &scratch,
            places: places(&signature, self.facts),
            // Vectors of neighbours pay where these are copies of what calls compute, and where they are products with the same factors.
            keeps_apart: program.helpers.is_empty() && !request.differentiates_accelerations(),
            numbering: Numbering::InFunction,
        });
        let stages = stages::of(&signature, &scratch.declared, &code);
        let known = Known {
            tree: self.tree,
            inputs: &self.inputs,
            fields: &self.compiled.fields,
        };
        let helpers = program.helpers.iter().enumerate();
        let helpers = helpers.map(|(place, own)| {
            let names = known.given(program, place);
            self.helper((&signature.name, place), own, &names)
        });
        let helpers = helpers.collect();
        Function {
            request: Some(request.text()),
            arguments,
            catalogue_part: request.only_part().filter(|_| is_first).cloned(),
            derivative_trait: request.derivative_trait().filter(|_| is_first),
            pattern: self.pattern(place),
            formulation: emittable.formulation,
            has_choice: request.formulations().len() > 1,
            fused: program.fused(),
            stages,
            helpers,
            scratch: scratch.declared,
            ..Function::plain(signature, emittable.operations, code)
        }
    }

    /// What a function runs on several columns.
    fn helper(
        &self,
        (of, place): (&str, usize),
        helper: &program::Helper,
        names: &GivenNames,
    ) -> Helper {
        let (roles, signature) = helper::declared(of, place, helper);
        let program = &helper.program;
        let code = self.code(&Body {
            program,
            signature: &signature,
            given: helper::entries(program),
            names,
            scratch: &Scratch::default(),
            places: places(&signature, self.facts),
            keeps_apart: false,
            numbering: Numbering::InFunction,
        });
        Helper {
            lanes: helper.lanes,
            loops: loops::of(&signature, &roles, &code),
            signature,
            roles,
            operations: program.operations(),
            fused: program.fused(),
            code,
        }
    }

    /// The pattern that stands before the function at this place: before the first that writes such an output.
    fn pattern(&self, place: usize) -> Option<usize> {
        let functions = &self.compiled.functions;
        let name = |one: &Emittable| one.request.compact().map(|function| function.name);
        let own = name(&functions[place])?;
        let first = functions.iter().position(|other| name(other) == Some(own));
        let mut patterns = self.facts.patterns.iter();
        let pattern = patterns.position(|pattern| pattern.function == own);
        pattern.filter(|_| first == Some(place))
    }

    pub(in crate::listing) fn prepare(&self, program: &Program) -> Function {
        let signature = signatures::prepare();
        let argument = signature.arguments.len() - 1;
        let places = self.fields.iter().map(|&field| Entry {
            argument,
            steps: vec![Step::Member(Member::Prepared(field))],
        });
        let code = self.code(&Body {
            program,
            signature: &signature,
            given: InputPlaces::new(),
            names: &GivenNames::default(),
            scratch: &Scratch::default(),
            places: places.collect(),
            keeps_apart: false,
            numbering: Numbering::InPreparation,
        });
        Function::plain(signature, program.operations(), code)
    }

    fn code(&self, body: &Body<'_>) -> Code {
        let (program, signature) = (body.program, body.signature);
        let groups = Groups::of(program);
        let arguments = signature.arguments.iter().chain(&body.scratch.declared);
        let arguments = arguments.map(|argument| argument.name.as_str());
        let of_input = |input| match input {
            Input::Side(place) => body.names.sides[place].clone(),
            Input::Shared(place) => body.names.shared[place].clone(),
            input => self.inputs.input(self.tree, input),
        };
        let names = name::names(
            program,
            &groups,
            (self.tree, &of_input),
            arguments,
            body.numbering,
        );
        let known = ProgramContext {
            groups: &groups,
            names: &names,
            tree: self.tree,
            entry: &|input| self.entry(input, body),
            scratch: body.scratch,
            keeps_apart: body.keeps_apart,
        };
        statements::of(program, &known, &body.places)
    }

    /// Where each input of the equations stands that is no parameter, in a function with these arguments.
    fn given(&self, arguments: &[Argument]) -> InputPlaces {
        let all = arguments.iter().flat_map(|argument| {
            let extent = self.facts.extent(&argument.declared());
            let inputs = argument.inputs(self.tree).enumerate();
            inputs.map(move |(place, input)| (input, (argument.name(), extent.steps(place))))
        });
        all.collect()
    }

    /// Where a function finds an input.
    fn entry(&self, input: Input, body: &Body<'_>) -> Entry {
        let (name, steps) = match input {
            Input::Sine(place) => (SIN_COS, of_member(Member::Sines, place)),
            Input::Cosine(place) => (SIN_COS, of_member(Member::Cosines, place)),
            Input::Parameter(id) => (
                PARAMETERS,
                vec![Step::Member(Member::Parameter(id.index()))],
            ),
            Input::Prepared(place) => (
                PREPARED,
                vec![Step::Member(Member::Prepared(self.fields[place]))],
            ),
            input => body.given[&input].clone(),
        };
        let signature = body.signature;
        let mut arguments = signature.arguments.iter();
        let argument = arguments.position(|argument| argument.name == name);
        let argument =
            argument.unwrap_or_else(|| unreachable!("listing: {} has no `{name}`", signature.name));
        Entry { argument, steps }
    }
}

/// Where each name stands in a sorted list of them.
fn places_of(names: &[String], sorted: &[String]) -> Vec<usize> {
    let place = |name: &String| {
        let place = sorted.binary_search(name);
        place.unwrap_or_else(|_| unreachable!("listing: no field `{name}`"))
    };
    names.iter().map(place).collect()
}

fn of_member(member: Member, place: usize) -> Vec<Step> {
    vec![Step::Member(member), Step::Index(place)]
}
