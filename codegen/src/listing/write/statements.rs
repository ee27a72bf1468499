//! From a program to statements: inputs are read where they are first needed, values stored as soon as they are there. A
//! compiler needs a fifth less time for that than for all stores in one block, which it tries to make vectors of.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    group::Groups,
    headings,
    name::Names,
    scratch::{Scratch, numbered},
    stores::{Stores, is_field},
};
use crate::listing::{
    Array, ArrayId, Code, Entry, Expression, Local, LocalId, Role, Statement, Step,
};
use crate::{
    expr::Input,
    program::{Definition, Instruction, Operand, Operation, Program, ValueId},
    tree::Tree,
};

/// The most angles that are taken together. Of a hundred and more a compiler makes a loop. Fewer cost time: of values that stand
/// in one array it finds more that can be computed side by side.
pub(super) const MOST_ANGLES: usize = 64;

/// What is known of a program's values beside it.
pub(super) struct ProgramContext<'a> {
    /// Which operations stand inside others.
    pub(super) groups: &'a Groups,
    /// What locals are called.
    pub(super) names: &'a Names,
    /// Whose bodies they are.
    pub(super) tree: &'a Tree,
    /// Where inputs stand.
    pub(super) entry: &'a dyn Fn(Input) -> Entry,
    /// Where what calls read stands.
    pub(super) scratch: &'a Scratch,
    /// True where computed numbers stay apart: of those that are stored side by side a compiler makes vectors of two, and of all that
    /// they are computed from, though it moves more than that saves.
    pub(super) keeps_apart: bool,
}

/// The statements of a program that stores to these places.
pub(super) fn of(program: &Program, known: &ProgramContext<'_>, places: &[Entry]) -> Code {
    let mut writer = StatementWriter {
        program,
        known,
        held: vec![None; program.values.len()],
        in_arrays: BTreeMap::new(),
        stores: BTreeMap::new(),
        headings: headings::of(program, known.groups, known.tree),
        code: Code::default(),
        n_calls: 0,
        stored: BTreeSet::new(),
    };
    assert_eq!(
        places.len(),
        program.stores.len(),
        "listing: outputs have a place for each store"
    );
    let constant = |operand| writer.operand(operand);
    let outputs = places.iter().cloned().zip(program.stores.iter().copied());
    let outputs = Stores::of(program, outputs, constant);
    let scratch = Stores::of(program, known.scratch.stores(program), constant);
    writer.code.statements = scratch.of_constants;
    writer.stores = scratch.of_values;
    for (id, mut stores) in outputs.of_values {
        writer.stores.entry(id).or_default().append(&mut stores);
    }
    for instruction in &program.instructions {
        writer.instruction(instruction);
    }
    // What is left to store was not needed before.
    for id in program.stores.iter().filter_map(|store| store.value()) {
        if !writer.stored.contains(&id) {
            writer.read(id);
        }
    }
    writer.code.statements.extend(outputs.of_constants);
    writer.code
}

struct StatementWriter<'a> {
    program: &'a Program,
    known: &'a ProgramContext<'a>,
    /// The local of each value, once it is assigned.
    held: Vec<Option<LocalId>>,
    /// Values that stand in an array and have no local yet: sines and cosines, and what calls compute.
    in_arrays: BTreeMap<ValueId, Expression>,
    /// What is not stored yet.
    stores: BTreeMap<ValueId, Vec<(Entry, Operand)>>,
    /// What stands before statements that are not written yet.
    headings: BTreeMap<ValueId, String>,
    code: Code,
    n_calls: usize,
    /// What calls compute and is stored from their arrays.
    stored: BTreeSet<ValueId>,
}

impl StatementWriter<'_> {
    fn instruction(&mut self, instruction: &Instruction) {
        match instruction {
            Instruction::Compute { result, operation } => {
                if self.known.groups.inlined(*result).is_none() {
                    let heading = self.headings.remove(result);
                    let heading = heading.map(Statement::Heading);
                    self.code.statements.extend(heading);
                    self.read_by(*operation);
                    let value = self.operation(*operation);
                    self.assign(*result, value);
                }
            }
            Instruction::SinCos {
                angles,
                sines,
                cosines,
            } => match (&angles[..], &sines[..], &cosines[..]) {
                (&[angle], &[sine], &[cosine]) => self.sin_cos(angle, sine, cosine),
                (angles, sines, cosines) => self.sin_cos_arrays(angles, sines, cosines),
            },
            Instruction::Share { .. } => self.read_all(instruction),
            Instruction::Call {
                lockstep,
                helper,
                results,
                ..
            } => {
                self.read_all(instruction);
                self.call((*lockstep, *helper), results);
            }
        }
    }

    fn sin_cos(&mut self, angle: Operand, sine: Option<ValueId>, cosine: Option<ValueId>) {
        if let Some(id) = angle.value() {
            self.read(id);
        }
        let angle = self.operand(angle);
        let [sine_local, cosine_local] = [sine, cosine].map(|id| id.map(|id| self.local(id)));
        self.code.statements.push(Statement::SinCos {
            angle,
            sine: sine_local,
            cosine: cosine_local,
        });
        for id in [sine, cosine].into_iter().flatten() {
            // The runtime computed them: this is a copy.
            self.store(id, false);
        }
    }

    fn sin_cos_arrays(
        &mut self,
        angles: &[Operand],
        sines: &[Option<ValueId>],
        cosines: &[Option<ValueId>],
    ) {
        let [sines, cosines] = [sines, cosines].map(|ids| ids.chunks(MOST_ANGLES));
        let calls = angles.chunks(MOST_ANGLES).zip(sines).zip(cosines);
        for (number, ((angles, sines), cosines)) in (1..).zip(calls) {
            let arrays = ["sines", "cosines"].map(|name| match number {
                // Reserved for them.
                1 => name.to_owned(),
                // A coordinate may be called `sines_2`.
                _ => self.known.names.taken.free(format!("{name}_{number}")),
            });
            self.sin_cos_array(arrays, angles, sines, cosines);
        }
    }

    fn sin_cos_array(
        &mut self,
        names: [String; 2],
        angles: &[Operand],
        sines: &[Option<ValueId>],
        cosines: &[Option<ValueId>],
    ) {
        for id in angles.iter().filter_map(|angle| angle.value()) {
            self.read(id);
        }
        let arrays = names.map(|name| self.array(name, angles.len(), None));
        let angles = angles.iter().map(|&angle| self.operand(angle)).collect();
        self.code.statements.push(Statement::SinCosArray {
            angles,
            sines: arrays[0],
            cosines: arrays[1],
        });
        // Each body takes its own from the arrays, so that a new body adds a line here and none to the others.
        for (array, values) in arrays.into_iter().zip([sines, cosines]) {
            for (place, id) in values.iter().enumerate() {
                let element = Expression::Element(array, place);
                self.in_arrays.extend(id.map(|id| (id, element)));
            }
        }
    }

    /// Reads all that an instruction needs.
    fn read_all(&mut self, instruction: &Instruction) {
        for id in instruction.operands().filter_map(Operand::value) {
            // What another call computes may stand where it is needed already.
            if !self.stored.contains(&id) {
                self.read(id);
            }
        }
    }

    fn array(&mut self, name: String, length: usize, row: Option<usize>) -> ArrayId {
        self.code.arrays.push(Array { name, length, row });
        ArrayId::new(self.code.arrays.len() - 1)
    }

    /// A call; what it computes goes from its array to where it is stored.
    fn call(&mut self, (lockstep, helper): (usize, usize), results: &[Vec<Option<ValueId>>]) {
        let name = self
            .known
            .names
            .taken
            .free(numbered(Role::Solved.name(), self.n_calls));
        let lanes = self.program.helpers[helper].lanes;
        let solved = self.array(name, lanes * results.len(), Some(lanes));
        let (shared, sides) = self.known.scratch.given(lockstep, self.n_calls);
        self.code.statements.push(Statement::Call {
            helper,
            shared,
            sides,
            solved,
        });
        self.n_calls += 1;
        for (place, id) in results.iter().flatten().enumerate() {
            if let Some(id) = *id {
                self.in_arrays
                    .insert(id, Expression::Element(solved, place));
                self.store_from(id);
            }
        }
    }

    /// Stores what stands in an array, wherever it goes, without a local.
    fn store_from(&mut self, id: ValueId) {
        let stores = self.stores.remove(&id).unwrap_or_default();
        let element = self
            .in_arrays
            .get(&id)
            .cloned()
            .filter(|_| !stores.is_empty());
        let Some(element) = element else { return };
        self.stored.insert(id);
        for (place, operand) in stores {
            let value = if operand.is_negative() {
                Expression::Negative(Box::new(element.clone()))
            } else {
                element.clone()
            };
            self.put(place, value, false);
        }
    }

    fn assign(&mut self, id: ValueId, value: Expression) {
        let local = self.local(id);
        // Copies of what is in memory may well be joined.
        let is_computed = !matches!(value, Expression::Entry(_) | Expression::Element(..));
        self.code
            .statements
            .push(Statement::Assign { local, value });
        self.store(id, is_computed);
    }

    /// A local for a value.
    fn local(&mut self, id: ValueId) -> LocalId {
        let local = LocalId::new(self.code.locals.len());
        self.code.locals.push(Local {
            name: self.known.names.of_values[id.index()].clone(),
            body: self.program.value(id).scope,
        });
        self.held[id.index()] = Some(local);
        local
    }

    /// Stores a value that has a local, wherever it goes.
    fn store(&mut self, id: ValueId, is_computed: bool) {
        for (place, operand) in self.stores.remove(&id).unwrap_or_default() {
            let value = self.operand(operand);
            self.put(place, value, is_computed);
        }
    }

    fn put(&mut self, place: Entry, value: Expression, is_computed: bool) {
        // A number alone has no neighbour.
        let is_of_array = matches!(place.steps.last(), Some(Step::Index(_)));
        let is_apart = self.known.keeps_apart && is_computed && is_of_array;
        self.code.statements.push(Statement::Store {
            place,
            value,
            is_apart,
        });
    }

    /// Reads what the operation and those inside it need, in order.
    fn read_by(&mut self, operation: Operation) {
        for id in operation.operands().filter_map(Operand::value) {
            match self.known.groups.inlined(id) {
                Some(inner) => self.read_by(inner),
                None => self.read(id),
            }
        }
    }

    /// Reads a value into a local, where it has none yet; fields of `Prepared` are read where they stand.
    fn read(&mut self, id: ValueId) {
        if self.held[id.index()].is_some() || is_field(self.program, id) {
            return;
        }
        let value = match self.program.value(id).definition {
            Definition::Input(input) => Some(Expression::Entry((self.known.entry)(input))),
            Definition::Instruction => self.in_arrays.remove(&id),
        };
        if let Some(value) = value {
            self.assign(id, value);
        }
    }

    /// An operation, with those that stand inside it.
    fn operation(&self, operation: Operation) -> Expression {
        let both = |a, b| Box::new([self.operand(a), self.operand(b)]);
        match operation {
            Operation::Add(a, b) if b.is_negative() => Expression::Difference(both(a, -b)),
            Operation::Add(a, b) => Expression::Sum(both(a, b)),
            Operation::Mul(a, b) => Expression::Product(both(a, b)),
            Operation::Div(a, b) => Expression::Quotient(both(a, b)),
            Operation::MulAdd(a, b, c) => {
                Expression::Fused(Box::new([a, b, c].map(|operand| self.operand(operand))))
            }
            Operation::Abs(a) => Expression::Absolute(Box::new(self.operand(a))),
            Operation::Neg(a) => Expression::Negative(Box::new(self.operand(a))),
        }
    }

    /// A number, a value, or the negative of one.
    fn operand(&self, operand: Operand) -> Expression {
        match operand {
            Operand::Number(number) => Expression::Number(number),
            Operand::Value {
                id,
                negative: false,
            } => self.value(id),
            Operand::Value { id, negative: true } => Expression::Negative(Box::new(self.value(id))),
        }
    }

    fn value(&self, id: ValueId) -> Expression {
        if let Some(operation) = self.known.groups.inlined(id) {
            return self.operation(operation);
        }
        match (self.held[id.index()], self.program.value(id).definition) {
            (Some(local), _) => Expression::Local(local),
            (None, Definition::Input(input @ Input::Prepared(_))) => {
                Expression::Entry((self.known.entry)(input))
            }
            (None, _) => unreachable!("listing: value {} is read before it is there", id.index()),
        }
    }
}
