//! Function by function, instruction by instruction.

use std::{
    collections::{BTreeMap, BTreeSet},
    ops::Range,
    path::Path,
};

use iced_x86::{
    Decoder, DecoderOptions, FlowControl, Formatter as _, Instruction, InstructionInfoFactory,
    IntelFormatter,
};

use crate::{
    functions::{HELPER_INFIX, STAGE_INFIX},
    input,
};

use super::{
    Breach, Error, FunctionReport, Report, Runtime, What,
    compile::MODULE,
    file::{Code, Files, Location, Target},
    instruction::{At, check_address},
    roots,
    state::{Content, State, Used, WORD},
};

/// The runtime's sines and cosines: the beginnings of their names.
const SINES: [&str; 3] = [
    "<f64 as kane::real::Real>::sin_cos",
    "<f32 as kane::real::Real>::sin_cos",
    "kane::sin_cos::",
];

/// More pages no stack has.
const MOST_PAGES: u64 = 1 << 16;

/// Compiles a generated module, and holds its functions to what is promised.
///
/// # Errors
/// Where the module cannot be read or compiled, or rustc's machine code cannot be read. A broken promise is none.
pub fn verify(runtime: &Runtime, path: &Path) -> Result<Report, Error> {
    let text = input::generated(path).map_err(|source| Error::Io {
        path: path.to_owned(),
        source,
    })?;
    let roots = roots::of(path, &text)?;
    let objects = runtime.compile(path, &roots)?;
    let files = Files::new(&objects)?;
    let mut verifier = Verifier {
        files: &files,
        facts: BTreeMap::new(),
        open: BTreeSet::new(),
    };
    let mut functions = Vec::new();
    let mut generated = BTreeSet::new();
    for root in roots {
        let symbol = root.symbol(MODULE, runtime.scalar());
        let code = files
            .location(&symbol)
            .and_then(|location| files.function(location));
        let code = code.ok_or_else(|| Error::Object(format!("`{symbol}` is not in it")))?;
        let facts = verifier.facts(code);
        functions.extend(verifier.parts(code.location, &mut generated));
        functions.push(FunctionReport {
            name: root.name,
            ..facts.function
        });
    }
    let sines = verifier.facts.into_iter();
    let sines = sines.filter(|(location, _)| !generated.contains(location));
    let mut sines: Vec<FunctionReport> = sines.map(|(_, facts)| facts.function).collect();
    sines.sort_by(|one, other| one.name.cmp(&other.name));
    Ok(Report { functions, sines })
}

/// The name of a function of the module itself, without its scalar.
fn name_in_module(name: &str) -> Option<&str> {
    let name = name.strip_prefix(MODULE)?.strip_prefix("::")?;
    let (name, scalar) = name.split_once("::").unwrap_or((name, ""));
    (scalar.is_empty() || scalar.starts_with('<') && scalar.ends_with('>')).then_some(name)
}

/// True for a stage of a function of the module, and for what it runs on several columns.
fn is_part(name: &str) -> bool {
    let own = name_in_module(name);
    [STAGE_INFIX, HELPER_INFIX].into_iter().any(|kind| {
        let number = own.and_then(|name| name.rsplit_once(kind));
        number.is_some_and(|(_, number)| number.parse::<usize>().is_ok())
    })
}

/// What is known of a function.
#[derive(Clone, Debug)]
struct Facts {
    function: FunctionReport,
    /// What it uses of the memory to which its arguments refer, by their numbers.
    arguments: BTreeMap<usize, Used>,
}

struct Verifier<'a, 'data> {
    files: &'a Files<'data>,
    facts: BTreeMap<Location, Facts>,
    /// The functions that are being read: one that calls itself does not end.
    open: BTreeSet<Location>,
}

impl Verifier<'_, '_> {
    fn facts(&mut self, code: Code<'_>) -> Facts {
        if let Some(facts) = self.facts.get(&code.location) {
            return facts.clone();
        }
        self.open.insert(code.location);
        let name = self.files.name(code.location).to_owned();
        let mut walk = Walk {
            verifier: self,
            state: Some(State::new()),
            instructions: 0,
            breaches: Vec::new(),
            has_returned: false,
            stack: 0,
            arguments: BTreeMap::new(),
            elsewhere: None,
            n_back: 0,
        };
        walk.run(code);
        let facts = Facts {
            function: FunctionReport {
                name,
                text: code.bytes.len() as u64,
                stack: walk.stack,
                instructions: walk.instructions,
                breaches: walk.breaches,
            },
            arguments: walk.arguments,
        };
        self.open.remove(&code.location);
        self.facts.insert(code.location, facts.clone());
        facts
    }

    /// The functions of the module that were read for the one at a location, and not for one before it; with it they are known as
    /// generated.
    fn parts(&self, own: Location, generated: &mut BTreeSet<Location>) -> Vec<FunctionReport> {
        generated.insert(own);
        let read = self.facts.iter();
        let read = read.filter(|(_, facts)| is_part(&facts.function.name));
        let parts = read.filter(|(location, _)| generated.insert(**location));
        let mut parts: Vec<FunctionReport> =
            parts.map(|(_, facts)| facts.function.clone()).collect();
        for part in &mut parts {
            part.name = name_in_module(&part.name).unwrap_or_default().to_owned();
        }
        // The tenth after the ninth.
        parts.sort_by(|one, other| {
            (one.name.len(), &one.name).cmp(&(other.name.len(), &other.name))
        });
        parts
    }

    /// The facts of a callee, where it is one of the runtime's sines and cosines, or a part of a function.
    fn of_callee(&mut self, target: &Target) -> Option<Facts> {
        let Target::Function(location) = *target else {
            return None;
        };
        let name = self.files.name(location);
        let is_sine = SINES.iter().any(|start| name.starts_with(start));
        let is_known = is_sine || is_part(name);
        let code = self.files.function(location);
        let code = code.filter(|_| is_known && !self.open.contains(&location))?;
        Some(self.facts(code))
    }
}

/// A function's instructions in order.
struct Walk<'v, 'a, 'data> {
    verifier: &'v mut Verifier<'a, 'data>,
    /// None behind a jump, where nothing is known.
    state: Option<State>,
    instructions: u64,
    breaches: Vec<Breach>,
    has_returned: bool,
    stack: u64,
    arguments: BTreeMap<usize, Used>,
    /// Where it goes on, if not at the next instruction.
    elsewhere: Option<u64>,
    /// How often it went back.
    n_back: u64,
}

impl Walk<'_, '_, '_> {
    fn run(&mut self, code: Code<'_>) {
        let (file, section, start) = code.location;
        let mut decoder = Decoder::new(64, code.bytes, DecoderOptions::NONE);
        let mut factory = InstructionInfoFactory::new();
        let mut instruction = Instruction::default();
        while decoder.can_decode() {
            decoder.decode_out(&mut instruction);
            self.instructions += 1;
            let at = At {
                files: self.verifier.files,
                location: (file, section, start + instruction.ip()),
                instruction: &instruction,
                offsets: decoder.get_constant_offsets(&instruction),
            };
            for what in self.step(&at, &mut factory) {
                self.broken(&instruction, what);
            }
            let elsewhere = self.elsewhere.take();
            if let Some(offset) = elsewhere.and_then(|ip| usize::try_from(ip).ok())
                && decoder.set_position(offset).is_ok()
            {
                decoder.set_ip(offset as u64);
            }
        }
        self.record();
        if !self.has_returned {
            self.broken(&instruction, What::End);
        }
    }

    fn step(&mut self, at: &At<'_, '_>, factory: &mut InstructionInfoFactory) -> Vec<What> {
        match at.instruction.flow_control() {
            _ if at.is_strange() => vec![What::Strange],
            FlowControl::Next => {
                let info = factory.info(at.instruction);
                let Some(state) = &mut self.state else {
                    return Vec::new();
                };
                let broken = at.check_memory(info, state);
                at.update(info, state);
                broken
            }
            FlowControl::Call | FlowControl::IndirectCall => self.call(at, -WORD),
            FlowControl::UnconditionalBranch
            | FlowControl::IndirectBranch
            | FlowControl::ConditionalBranch => self.jump(at),
            FlowControl::Return if at.instruction.code() == iced_x86::Code::Retnq => self.end(),
            _ => vec![What::Strange],
        }
    }

    /// A call, which pushes so much onto the stack.
    fn call(&mut self, at: &At<'_, '_>, pushed: i64) -> Vec<What> {
        let target = at.callee(self.state.as_ref());
        let target = target.unwrap_or_else(|| Target::Other("itself".to_owned()));
        let Some(callee) = self.verifier.of_callee(&target) else {
            let name = match target {
                Target::Function(location) => self.verifier.files.name(location).to_owned(),
                Target::Other(name) => name,
                Target::Constant => "a constant".to_owned(),
            };
            let is_panic = name.contains("panic") || name.starts_with("core::slice::index::");
            let what = if is_panic { What::Panic } else { What::Call };
            if let Some(state) = &mut self.state {
                state.returned(i64::MAX);
            }
            return vec![what(name)];
        };
        self.instructions += callee.function.instructions;
        let Some(state) = &mut self.state else {
            return Vec::new();
        };
        let Some(pointer) = state.stack_pointer() else {
            state.returned(i64::MAX);
            return vec![What::Stack];
        };
        let mut broken = Vec::new();
        for (&number, used) in &callee.arguments {
            let Range { start, end } = used.bytes;
            broken.extend(match state.argument(number, pushed).plus(start) {
                // There the callee's own stack is.
                Content::Stack(offset) if offset < pointer => Some(What::Stack),
                address => check_address(address, end.saturating_sub(start), used.writes, state),
            });
        }
        let depth = i64::try_from(callee.function.stack).unwrap_or(i64::MAX);
        let lowest = pointer.saturating_add(pushed).saturating_sub(depth);
        state.lowest = state.lowest.min(lowest);
        state.returned(pointer);
        broken
    }

    /// A jump.
    fn jump(&mut self, at: &At<'_, '_>) -> Vec<What> {
        let counted = self.state.as_ref().and_then(|state| at.counted_jump(state));
        if let Some(offset) = counted.filter(|_| self.n_back < MOST_PAGES) {
            self.n_back += u64::from(offset < at.instruction.ip());
            self.elsewhere = Some(offset);
            return Vec::new();
        }
        let is_last = at.instruction.flow_control() != FlowControl::ConditionalBranch;
        match at.callee(self.state.as_ref()) {
            // Out of the function and not back: a call and a return in one.
            Some(_) if is_last => {
                let mut broken = self.call(at, 0);
                broken.extend(self.end());
                broken
            }
            _ => {
                self.leave();
                vec![What::Jump]
            }
        }
    }

    /// The return.
    fn end(&mut self) -> Vec<What> {
        let is_as_it_was = match &self.state {
            Some(state) => state.stack_pointer() == Some(0),
            None => true,
        };
        self.leave();
        if is_as_it_was {
            Vec::new()
        } else {
            vec![What::End]
        }
    }

    /// What follows is reached from elsewhere, or not at all.
    fn leave(&mut self) {
        self.record();
        self.has_returned = true;
        self.state = None;
    }

    /// Keeps what the state has gathered.
    fn record(&mut self) {
        if let Some(state) = &self.state {
            self.stack = state.bytes();
            self.arguments.clone_from(&state.arguments);
        }
    }

    fn broken(&mut self, instruction: &Instruction, what: What) {
        let mut formatter = IntelFormatter::new();
        let options = formatter.options_mut();
        options.set_branch_leading_zeros(false);
        options.set_hex_prefix("0x");
        options.set_hex_suffix("");
        let mut text = String::new();
        formatter.format(instruction, &mut text);
        self.breaches.push(Breach {
            offset: instruction.ip(),
            instruction: text,
            what,
        });
    }
}
