//! What every function of a listing must hold; a breach is a bug of ours.

use std::collections::BTreeMap;

use super::{
    Code, Entry, Expression, Extent, Facts, Function, Stage, Statement,
    constants::{FINGERPRINT, OPERATIONS},
};
use crate::functions::{Access, Signature};

/// A broken promise of a function.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// A name that some language cannot have.
    #[error("`{0}` is no identifier in lower snake case")]
    NoIdentifier(String),
    /// Two arguments, locals, arrays or constants with one name.
    #[error("`{0}` is the name of two things")]
    SameName(String),
    /// A local or array is read before it is assigned, or is none of the function's.
    #[error("`{0}` is read before it is assigned")]
    Unassigned(String),
    /// A local or array is assigned twice.
    #[error("`{0}` is assigned twice")]
    AssignedTwice(String),
    /// A local is assigned and not read, or both arrays of one statement.
    #[error("`{0}` is never read")]
    Unread(String),
    /// What is read is not there.
    #[error("{0:?} is read, which is nothing that the function is given")]
    Unreadable(Entry),
    /// What no earlier stage keeps.
    #[error("number {1} of what stage {0} keeps is read, which is not there")]
    NotKept(usize, usize),
    /// An element of an array that it does not have.
    #[error("`{0}` has no element {1}")]
    NoElement(String, usize),
    /// Angles, and places for more or fewer sines or cosines.
    #[error("{0} angles have places for {1} sines or cosines")]
    Places(usize, usize),
    /// A helper that is called and not there.
    #[error("helper {0} is called, which is not there")]
    NoHelper(usize),
    /// A call gives a helper other numbers than it is declared with, or has places for others than it computes.
    #[error("a call does not fit helper {0}")]
    Unfit(usize),
    /// A call reads an argument that is not there, or is not written.
    #[error("a call reads argument {0}, which nothing is stored to")]
    NoArgument(usize),
    /// What is stored has no place in an output.
    #[error("{0:?} is stored, which is nothing that the function writes")]
    Unwritable(Entry),
    /// A place of an output is stored twice.
    #[error("{0:?} is stored twice")]
    StoredTwice(Entry),
    /// A place of an output is not stored.
    #[error("number {1} of `{0}` is not stored")]
    NotStored(String, usize),
    /// A number that no literal is.
    #[error("a number is not finite")]
    NotFinite,
}

/// Checks that names of parameters, of prepared fields and of bodies are unique identifiers, and that no two constants have one name.
///
/// # Errors
/// The first that is none.
pub fn verify_facts(facts: &Facts) -> Result<(), Fault> {
    check_names(facts.parameters.iter().map(|parameter| &parameter.name))?;
    check_names(facts.fields.iter())?;
    check_names(facts.bodies.iter().map(|body| &body.identifier))?;
    let constants = facts.all_constants().into_iter();
    let constants = constants.chain(facts.prescribed_constant());
    let constants = constants.map(|constant| constant.name);
    check_unique(constants.chain([FINGERPRINT, OPERATIONS]).collect())
}

/// Checks that names are unique identifiers; that each local is assigned once, before it is read, and is read; that what is
/// read of arguments is there; and that each place of each output is stored once: by the function, and by its stages together.
///
/// # Errors
/// The first promise that is broken.
pub fn verify(facts: &Facts, function: &Function) -> Result<(), Fault> {
    let Function {
        signature,
        code,
        stages,
        ..
    } = function;
    for own in &function.helpers {
        verify_code(facts, &own.signature, &own.code, &own.loops)?;
    }
    check_calls(facts, function)?;
    let signature = &Signature {
        arguments: function.places().cloned().collect(),
        ..signature.clone()
    };
    verify_code(facts, signature, code, stages)
}

/// The same of code with these arguments, and of its stages or loops.
fn verify_code(
    facts: &Facts,
    signature: &Signature,
    code: &Code,
    stages: &[Stage],
) -> Result<(), Fault> {
    let whole = State::after(facts, signature, code, &[], unstored(facts, signature))?;
    check_stored(&whole.close()?)?;
    if stages.is_empty() {
        return Ok(());
    }
    let mut stored = unstored(facts, signature);
    for (place, stage) in stages.iter().enumerate() {
        stored = verify_stage(facts, &stages[..place], stage, stored)?;
    }
    check_stored(&stored)
}

/// Checks that helpers that are called are there, and are given and compute what the arrays of a call hold, of every lane.
fn check_calls(facts: &Facts, function: &Function) -> Result<(), Fault> {
    let Function { code, helpers, .. } = function;
    let extents = function.places().map(|place| facts.extent(place).size());
    let extents: Vec<usize> = extents.collect();
    for statement in &code.statements {
        let Statement::Call {
            helper,
            shared,
            sides,
            solved,
        } = statement
        else {
            continue;
        };
        let place = *helper;
        let helper = helpers.get(place).ok_or(Fault::NoHelper(place))?;
        let own = helper.signature.arguments.iter();
        let own: Vec<usize> = own.map(|place| facts.extent(place).size()).collect();
        let lanes = helper.lanes;
        let extent = |place: usize| extents.get(place).ok_or(Fault::NoArgument(place));
        let shared = shared.map(extent).transpose()?;
        let mut held: Vec<_> = shared.into_iter().map(|extent| (*extent, 1)).collect();
        held.push((*extent(*sides)?, lanes));
        held.push((code.array(*solved).length, lanes));
        let mut both = own.iter().zip(&held);
        if own.len() != held.len() || both.any(|(own, (held, lanes))| lanes * own != *held) {
            return Err(Fault::Unfit(place));
        }
    }
    Ok(())
}

/// What is stored after a stage; `stored` is what those before it have stored.
fn verify_stage<'a>(
    facts: &Facts,
    before: &[Stage],
    stage: &Stage,
    stored: Stored<'a>,
) -> Result<Stored<'a>, Fault> {
    check_names(stage.kept.iter().map(|kept| &kept.name))?;
    let mut state = State::after(facts, &stage.signature, &stage.code, before, stored)?;
    let mut kept = stage.kept.iter();
    kept.try_for_each(|kept| state.read(&kept.value))?;
    state.close()
}

/// Which places of each output are stored, by the outputs' names.
type Stored<'a> = BTreeMap<&'a str, Vec<bool>>;

/// Before the first statement.
fn unstored<'a>(facts: &Facts, signature: &'a Signature) -> Stored<'a> {
    let arguments = signature.arguments.iter();
    let outputs = arguments.filter(|argument| argument.access == Access::Written);
    outputs
        .map(|output| {
            (
                output.name.as_str(),
                vec![false; facts.extent(output).size()],
            )
        })
        .collect()
}

/// Nothing is left to store.
fn check_stored(stored: &Stored<'_>) -> Result<(), Fault> {
    for (name, places) in stored {
        if let Some(place) = places.iter().position(|is_stored| !is_stored) {
            return Err(Fault::NotStored((*name).to_owned(), place));
        }
    }
    Ok(())
}

fn check_names<'a>(names: impl Iterator<Item = &'a String>) -> Result<(), Fault> {
    let names: Vec<&str> = names.map(String::as_str).collect();
    if let Some(name) = names.iter().find(|name| !is_identifier(name)) {
        return Err(Fault::NoIdentifier((*name).to_owned()));
    }
    check_unique(names)
}

fn check_unique(mut names: Vec<&str>) -> Result<(), Fault> {
    names.sort_unstable();
    let twice = names.windows(2).find(|pair| pair[0] == pair[1]);
    twice.map_or(Ok(()), |pair| Err(Fault::SameName(pair[0].to_owned())))
}

/// True for lower-case letters of ASCII, digits and `_`, with a letter first.
fn is_identifier(name: &str) -> bool {
    let is_inner = |byte: u8| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_';
    name.starts_with(|first: char| first.is_ascii_lowercase()) && name.bytes().all(is_inner)
}

/// How far a local or array has come.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    Unassigned,
    Assigned,
    Read,
}

struct State<'a, 's> {
    signature: &'a Signature,
    code: &'a Code,
    before: &'a [Stage],
    /// Of the arguments.
    extents: Vec<Extent>,
    stored: Stored<'s>,
    locals: Vec<Use>,
    arrays: Vec<Use>,
}

impl<'a, 's> State<'a, 's> {
    /// After all statements; `before` are the stages before it, where it is one, and `stored` is what these have stored.
    fn after(
        facts: &Facts,
        signature: &'a Signature,
        code: &'a Code,
        before: &'a [Stage],
        stored: Stored<'s>,
    ) -> Result<Self, Fault> {
        let arguments = &signature.arguments;
        let locals = code.locals.iter().map(|local| &local.name);
        let arrays = code.arrays.iter().map(|array| &array.name);
        let names = arguments.iter().map(|argument| &argument.name);
        check_names(names.chain(locals).chain(arrays))?;
        let extents = arguments.iter().map(|argument| facts.extent(argument));
        let mut state = Self {
            signature,
            code,
            before,
            extents: extents.collect(),
            stored,
            locals: vec![Use::Unassigned; code.locals.len()],
            arrays: vec![Use::Unassigned; code.arrays.len()],
        };
        for statement in &code.statements {
            state.statement(statement)?;
        }
        Ok(state)
    }

    fn statement(&mut self, statement: &Statement) -> Result<(), Fault> {
        for value in statement.values() {
            self.read(value)?;
        }
        for local in statement.assigned() {
            assign(
                &mut self.locals[local.index()],
                &self.code.local(local).name,
            )?;
        }
        match statement {
            Statement::SinCosArray {
                angles,
                sines,
                cosines,
            } => {
                for &id in [sines, cosines] {
                    let array = self.code.array(id);
                    check_places(angles.len(), array.length)?;
                    assign(&mut self.arrays[id.index()], &array.name)?;
                }
            }
            Statement::Call {
                shared,
                sides,
                solved,
                ..
            } => {
                let mut given = shared.iter().chain([sides]);
                given.try_for_each(|&place| self.read_whole(place))?;
                let array = self.code.array(*solved);
                assign(&mut self.arrays[solved.index()], &array.name)?;
            }
            Statement::StoreSinCos {
                angles,
                sines,
                cosines,
            } => {
                check_places(angles.len(), sines.len())?;
                check_places(angles.len(), cosines.len())?;
            }
            _ => {}
        }
        statement.stored().try_for_each(|place| self.store(place))
    }

    fn read(&mut self, value: &Expression) -> Result<(), Fault> {
        match value {
            Expression::Number(number) if !number.is_finite() => return Err(Fault::NotFinite),
            Expression::Local(id) => {
                read(&mut self.locals[id.index()], &self.code.local(*id).name)?;
            }
            Expression::Element(id, place) => {
                let array = self.code.array(*id);
                if *place >= array.length {
                    return Err(Fault::NoElement(array.name.clone(), *place));
                }
                read(&mut self.arrays[id.index()], &array.name)?;
            }
            Expression::Entry(entry) => {
                let place = self.place(entry, Access::Read);
                place.ok_or_else(|| Fault::Unreadable(entry.clone()))?;
            }
            Expression::Kept(stage, place) => {
                let kept = self
                    .before
                    .get(*stage)
                    .and_then(|stage| stage.kept.get(*place));
                kept.ok_or(Fault::NotKept(*stage, *place))?;
            }
            _ => {}
        }
        let mut operands = value.operands().iter();
        operands.try_for_each(|operand| self.read(operand))
    }

    /// Reads all that was stored to an argument.
    fn read_whole(&self, place: usize) -> Result<(), Fault> {
        let argument = self.signature.arguments.get(place);
        let stored = argument.and_then(|argument| self.stored.get(argument.name.as_str()));
        match (argument, stored) {
            (Some(argument), Some(places)) => {
                match places.iter().position(|is_stored| !is_stored) {
                    Some(place) => Err(Fault::NotStored(argument.name.clone(), place)),
                    None => Ok(()),
                }
            }
            _ => Err(Fault::NoArgument(place)),
        }
    }

    /// The name of the argument with this access, and the place in it.
    fn place(&self, entry: &Entry, access: Access) -> Option<(&'a str, usize)> {
        let declared = self.signature.arguments.get(entry.argument)?;
        let extent = self.extents.get(entry.argument)?;
        let place = extent.place(&entry.steps)?;
        (declared.access == access).then_some((declared.name.as_str(), place))
    }

    fn store(&mut self, entry: &Entry) -> Result<(), Fault> {
        let place = self.place(entry, Access::Written);
        let slot = place.and_then(|(name, place)| self.stored.get_mut(name)?.get_mut(place));
        let is_stored = slot.ok_or_else(|| Fault::Unwritable(entry.clone()))?;
        if std::mem::replace(is_stored, true) {
            return Err(Fault::StoredTwice(entry.clone()));
        }
        Ok(())
    }

    /// Nothing is left to read; what is stored.
    fn close(self) -> Result<Stored<'s>, Fault> {
        let locals = self.locals.iter().zip(&self.code.locals);
        let locals = locals.map(|(how, local)| (how, &local.name));
        let mut unread = locals.filter(|(how, _)| **how != Use::Read);
        if let Some((_, name)) = unread.next() {
            return Err(Fault::Unread(name.clone()));
        }
        self.close_arrays()?;
        Ok(self.stored)
    }

    /// Of sines and cosines that are taken together, one may be of no use, but not both.
    fn close_arrays(&self) -> Result<(), Fault> {
        for statement in &self.code.statements {
            if let Statement::SinCosArray { sines, cosines, .. } = statement {
                let mut both = [sines, cosines].into_iter();
                if both.all(|id| self.arrays[id.index()] != Use::Read) {
                    return Err(Fault::Unread(self.code.array(*sines).name.clone()));
                }
            }
        }
        Ok(())
    }
}

fn assign(how: &mut Use, name: &str) -> Result<(), Fault> {
    match how {
        Use::Unassigned => *how = Use::Assigned,
        Use::Assigned | Use::Read => return Err(Fault::AssignedTwice(name.to_owned())),
    }
    Ok(())
}

fn read(how: &mut Use, name: &str) -> Result<(), Fault> {
    if *how == Use::Unassigned {
        return Err(Fault::Unassigned(name.to_owned()));
    }
    *how = Use::Read;
    Ok(())
}

fn check_places(angles: usize, places: usize) -> Result<(), Fault> {
    if angles == places {
        Ok(())
    } else {
        Err(Fault::Places(angles, places))
    }
}
