//! Long functions as several, called one after the other: a compiler's time and memory grow faster than what it compiles.

use std::{
    collections::{BTreeMap, BTreeSet},
    ops::Range,
};

use crate::functions::{Declared, STAGE_INFIX, Signature};
use crate::listing::{
    Array, ArrayId, Code, Entry, Expression, Kept, Local, LocalId, Stage, Statement,
};
use crate::taken::Taken;

/// Longer functions have stages. They are beyond what a person reads line by line: a new body moves where stages end.
const LONGEST: usize = 15_000;

/// So many statements a stage has, or up to twice as many: it ends where those of another body begin.
const STAGE: usize = 2_000;

/// The stages of a function, in order; none where it is short.
pub(super) fn of(signature: &Signature, scratch: &[Declared], code: &Code) -> Vec<Stage> {
    let arguments = signature.arguments.iter().chain(scratch).cloned();
    let signature = &Signature {
        arguments: arguments.collect(),
        ..signature.clone()
    };
    match &ranges(code)[..] {
        [] | [_] => Vec::new(),
        ranges => cut(signature, code, ranges),
    }
}

/// A stage of each range of statements.
pub(super) fn cut(signature: &Signature, code: &Code, ranges: &[Range<usize>]) -> Vec<Stage> {
    let flow = Flow::of(code, ranges);
    let stages = ranges.iter().enumerate().map(|(number, range)| {
        let cut = Cut::new(signature, code, &flow, number, range.clone());
        cut.stage()
    });
    stages.collect()
}

/// Where the stages' statements are. Headings are no statements, and stay with what follows them.
fn ranges(code: &Code) -> Vec<Range<usize>> {
    let is_heading = |place: usize| matches!(code.statements[place], Statement::Heading(_));
    let places: Vec<usize> = (0..code.statements.len())
        .filter(|place| !is_heading(*place))
        .collect();
    if places.len() <= LONGEST {
        return Vec::new();
    }
    let mut ranges = Vec::new();
    let (mut first, mut length, mut body) = (0, 0, None);
    for place in places {
        length += 1;
        let Some(local) = code.statements[place].assigned().next() else {
            continue;
        };
        let own = code.local(local).body;
        if length > 2 * STAGE || length > STAGE && own != body {
            let end = place - usize::from(is_heading(place - 1));
            ranges.push(first..end);
            (first, length) = (end, 1);
        }
        body = own;
    }
    ranges.push(first..code.statements.len());
    ranges
}

/// What a stage may hand on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Passed {
    Element(ArrayId, usize),
    Local(LocalId),
}

impl Passed {
    fn of(expression: &Expression) -> Option<Self> {
        match *expression {
            Expression::Local(id) => Some(Self::Local(id)),
            Expression::Element(id, place) => Some(Self::Element(id, place)),
            _ => None,
        }
    }
}

/// What passes from stage to stage.
struct Flow<'a> {
    /// What the function's locals and arrays are called.
    names: Taken,
    /// What argument each local holds, where it holds one as it is.
    given: Vec<Option<&'a Entry>>,
    /// The stage that assigns each local.
    locals: Vec<usize>,
    /// The stage that assigns each array.
    arrays: Vec<usize>,
    /// What each stage keeps for later ones.
    kept: Vec<Vec<Passed>>,
}

impl<'a> Flow<'a> {
    fn of(code: &'a Code, ranges: &[Range<usize>]) -> Self {
        let mut flow = Self {
            names: names(code),
            given: given(code),
            locals: vec![0; code.locals.len()],
            arrays: vec![0; code.arrays.len()],
            kept: Vec::new(),
        };
        let mut kept = vec![BTreeSet::new(); ranges.len()];
        for (stage, range) in ranges.iter().enumerate() {
            for statement in &code.statements[range.clone()] {
                for local in statement.assigned() {
                    flow.locals[local.index()] = stage;
                }
                for array in statement.filled() {
                    flow.arrays[array.index()] = stage;
                }
                for_each(statement, &mut |expression| {
                    if let Some(value) = Passed::of(expression)
                        && flow.stage(value) < stage
                        && flow.given(value).is_none()
                    {
                        kept[flow.stage(value)].insert(value);
                    }
                });
            }
        }
        flow.kept = kept
            .into_iter()
            .map(|values| values.into_iter().collect())
            .collect();
        flow
    }

    /// What argument it is, where it is one.
    fn given(&self, value: Passed) -> Option<&'a Entry> {
        match value {
            Passed::Local(id) => self.given[id.index()],
            Passed::Element(..) => None,
        }
    }

    /// The stage that assigns a value.
    fn stage(&self, value: Passed) -> usize {
        match value {
            Passed::Local(id) => self.locals[id.index()],
            Passed::Element(id, _) => self.arrays[id.index()],
        }
    }
}

/// True where a local is given what an argument holds: each stage does that where it first needs it.
fn reads(statement: &Statement) -> bool {
    let is_entry = |value: &Expression| matches!(value, Expression::Entry(_));
    matches!(statement, Statement::Assign { value, .. } if is_entry(value))
}

/// What argument each local holds, where it holds one as it is.
pub(super) fn given(code: &Code) -> Vec<Option<&Entry>> {
    let mut given = vec![None; code.locals.len()];
    for statement in &code.statements {
        if let Statement::Assign {
            local,
            value: Expression::Entry(entry),
        } = statement
        {
            given[local.index()] = Some(entry);
        }
    }
    given
}

/// What locals and arrays are called.
fn names(code: &Code) -> Taken {
    let locals = code.locals.iter().map(|local| local.name.as_str());
    let arrays = code.arrays.iter().map(|array| array.name.as_str());
    locals.chain(arrays).collect()
}

/// Visits all expressions of a statement, and what they are made of.
pub(super) fn for_each<'a>(statement: &'a Statement, visit: &mut impl FnMut(&'a Expression)) {
    let mut open: Vec<&Expression> = statement.values().iter().collect();
    while let Some(expression) = open.pop() {
        visit(expression);
        open.extend(expression.operands());
    }
}

/// One stage while it is cut out of its function.
struct Cut<'a> {
    signature: &'a Signature,
    whole: &'a Code,
    flow: &'a Flow<'a>,
    number: usize,
    range: Range<usize>,
    /// The function's arguments that it has, by their places.
    given: Vec<usize>,
    /// The stages whose kept values it has.
    earlier: Vec<usize>,
    locals: BTreeMap<LocalId, LocalId>,
    arrays: BTreeMap<ArrayId, ArrayId>,
    code: Code,
}

impl<'a> Cut<'a> {
    fn new(
        signature: &'a Signature,
        whole: &'a Code,
        flow: &'a Flow<'a>,
        number: usize,
        range: Range<usize>,
    ) -> Self {
        let (mut given, mut earlier) = (BTreeSet::new(), BTreeSet::new());
        let statements = whole.statements[range.clone()].iter();
        for statement in statements.filter(|own| !reads(own)) {
            given.extend(statement.stored().map(|entry| entry.argument));
            if let Statement::Call { shared, sides, .. } = statement {
                given.extend(shared.iter().chain([sides]));
            }
            for_each(statement, &mut |expression| {
                if let Expression::Entry(entry) = expression {
                    given.insert(entry.argument);
                }
                let Some(value) = Passed::of(expression) else {
                    return;
                };
                match flow.given(value) {
                    Some(entry) => {
                        given.insert(entry.argument);
                    }
                    None => earlier.extend(Some(flow.stage(value)).filter(|own| *own < number)),
                }
            });
        }
        Self {
            signature,
            whole,
            flow,
            number,
            range,
            given: given.into_iter().collect(),
            earlier: earlier.into_iter().collect(),
            locals: BTreeMap::new(),
            arrays: BTreeMap::new(),
            code: Code::default(),
        }
    }

    fn stage(mut self) -> Stage {
        let statements = self.whole.statements[self.range.clone()].iter();
        for statement in statements.filter(|own| !reads(own)) {
            let statement = self.statement(statement);
            self.code.statements.push(statement);
        }
        let kept = self.flow.kept[self.number].iter();
        let kept = kept.map(|value| match *value {
            Passed::Local(id) => Kept {
                name: self.whole.local(id).name.clone(),
                value: Expression::Local(self.locals[&id]),
            },
            Passed::Element(id, place) => Kept {
                name: self.flow.names.free(self.whole.array(id).element(place)),
                value: Expression::Element(self.arrays[&id], place),
            },
        });
        let number = self.number + 1;
        Stage {
            kept: kept.collect(),
            keeps: self.flow.names.free(format!("kept_{number}")),
            signature: self.declared(number),
            given: self.given,
            earlier: self.earlier,
            code: self.code,
        }
    }

    fn declared(&self, number: usize) -> Signature {
        let name = &self.signature.name;
        let given = self.given.iter();
        let given = given.map(|&place| self.signature.arguments[place].clone());
        Signature {
            name: format!("{name}{STAGE_INFIX}{number}"),
            doc: vec![format!("Stage {number} of `{name}`.")],
            arguments: given.collect(),
        }
    }

    fn statement(&mut self, statement: &Statement) -> Statement {
        match statement {
            Statement::Assign { local, value } => {
                let value = self.expression(value);
                let local = self.local(*local);
                Statement::Assign { local, value }
            }
            Statement::SinCos {
                angle,
                sine,
                cosine,
            } => {
                let angle = self.expression(angle);
                let [sine, cosine] = [sine, cosine].map(|id| id.map(|id| self.local(id)));
                Statement::SinCos {
                    angle,
                    sine,
                    cosine,
                }
            }
            Statement::SinCosArray {
                angles,
                sines,
                cosines,
            } => {
                let angles = angles.iter().map(|angle| self.expression(angle)).collect();
                let [sines, cosines] = [sines, cosines].map(|&id| self.array(id));
                Statement::SinCosArray {
                    angles,
                    sines,
                    cosines,
                }
            }
            Statement::Call {
                helper,
                shared,
                sides,
                solved,
            } => Statement::Call {
                helper: *helper,
                shared: shared.map(|argument| self.argument(argument)),
                sides: self.argument(*sides),
                solved: self.array(*solved),
            },
            Statement::StoreSinCos {
                angles,
                sines,
                cosines,
            } => Statement::StoreSinCos {
                angles: angles.iter().map(|angle| self.expression(angle)).collect(),
                sines: sines.iter().map(|entry| self.entry(entry)).collect(),
                cosines: cosines.iter().map(|entry| self.entry(entry)).collect(),
            },
            Statement::Store {
                place,
                value,
                is_apart,
            } => Statement::Store {
                value: self.expression(value),
                place: self.entry(place),
                is_apart: *is_apart,
            },
            Statement::Heading(words) => Statement::Heading(words.clone()),
        }
    }

    /// A local of the stage for one of the function.
    fn local(&mut self, id: LocalId) -> LocalId {
        let own = LocalId::new(self.code.locals.len());
        self.code.locals.push(Local::clone(self.whole.local(id)));
        self.locals.insert(id, own);
        own
    }

    fn array(&mut self, id: ArrayId) -> ArrayId {
        let own = ArrayId::new(self.code.arrays.len());
        self.code.arrays.push(Array::clone(self.whole.array(id)));
        self.arrays.insert(id, own);
        own
    }

    fn entry(&self, entry: &Entry) -> Entry {
        Entry {
            argument: self.argument(entry.argument),
            steps: entry.steps.clone(),
        }
    }

    fn argument(&self, place: usize) -> usize {
        let argument = self.given.binary_search(&place);
        argument.unwrap_or_else(|_| unreachable!("listing: an argument not given"))
    }

    /// What an earlier stage keeps.
    fn kept(&self, value: Passed) -> Expression {
        let stage = self.flow.stage(value);
        let place = self.flow.kept[stage].binary_search(&value);
        let place = place.unwrap_or_else(|_| unreachable!("listing: {value:?} is not kept"));
        Expression::Kept(stage, place)
    }

    /// The same on the stage's own locals; what arguments hold and earlier stages keep is read where it is first needed.
    fn expression(&mut self, expression: &Expression) -> Expression {
        match expression {
            Expression::Number(_) | Expression::Kept(..) => expression.clone(),
            Expression::Local(id) => {
                if let Some(&own) = self.locals.get(id) {
                    return Expression::Local(own);
                }
                let passed = Passed::Local(*id);
                let value = match self.flow.given(passed) {
                    Some(entry) => Expression::Entry(self.entry(entry)),
                    None => self.kept(passed),
                };
                let local = self.local(*id);
                self.code
                    .statements
                    .push(Statement::Assign { local, value });
                Expression::Local(local)
            }
            Expression::Element(id, place) => match self.arrays.get(id) {
                Some(&own) => Expression::Element(own, *place),
                None => self.kept(Passed::Element(*id, *place)),
            },
            Expression::Entry(entry) => Expression::Entry(self.entry(entry)),
            Expression::Negative(a) => Expression::Negative(Box::new(self.expression(a))),
            Expression::Absolute(a) => Expression::Absolute(Box::new(self.expression(a))),
            Expression::Sum(both) => Expression::Sum(Box::new(self.all(both))),
            Expression::Difference(both) => Expression::Difference(Box::new(self.all(both))),
            Expression::Product(both) => Expression::Product(Box::new(self.all(both))),
            Expression::Quotient(both) => Expression::Quotient(Box::new(self.all(both))),
            Expression::Fused(all) => Expression::Fused(Box::new(self.all(all))),
        }
    }

    fn all<const N: usize>(&mut self, operands: &[Expression; N]) -> [Expression; N] {
        operands.each_ref().map(|operand| self.expression(operand))
    }
}
