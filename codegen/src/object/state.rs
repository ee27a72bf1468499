//! What the registers and the stack hold, as far as addresses are concerned.

use std::{collections::BTreeMap, ops::Range};

use iced_x86::Register;

use super::file::Target;

/// What a register or a place of the stack holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Content {
    /// An address in what the argument of this number refers to: so far from what it was given.
    Argument(usize, i64),
    /// An address in the stack: so far from that of the return address.
    Stack(i64),
    /// An address in what is compiled, or of it.
    Address(Target),
    /// A number in the code.
    Number(i64),
    /// Anything else: what was computed or loaded.
    Unknown,
}

/// The registers in which arguments are given, in order.
const ARGUMENTS: [Register; 6] = [
    Register::RDI,
    Register::RSI,
    Register::RDX,
    Register::RCX,
    Register::R8,
    Register::R9,
];

/// The registers that are of a callee.
const OF_CALLEE: [Register; 9] = [
    Register::RAX,
    Register::RCX,
    Register::RDX,
    Register::RSI,
    Register::RDI,
    Register::R8,
    Register::R9,
    Register::R10,
    Register::R11,
];

/// What a function may use of the stack below the stack pointer.
const RED_ZONE: i64 = 128;
/// What it may read above its return address, where further arguments are.
const MOST_ARGUMENTS: i64 = 4096;
/// Bytes of a return address, and of a register.
pub(super) const WORD: i64 = 8;
/// The largest alignment of a stack: a page.
const MOST_ALIGNMENT: i64 = 4096;
/// What an alignment is taken to move the stack pointer by: no displacement reaches so far.
const GAP: i64 = 1 << 40;

/// What is used of the memory to which an argument refers.
#[derive(Clone, Debug)]
pub(super) struct Used {
    /// From the first byte to the last, by their distance from what was given.
    pub(super) bytes: Range<i64>,
    pub(super) writes: bool,
}

/// What is known between two instructions.
#[derive(Debug)]
pub(super) struct State {
    registers: BTreeMap<Register, Content>,
    /// What vectors hold that were loaded from constants, by their largest registers.
    vectors: BTreeMap<Register, Vec<u8>>,
    /// By their distance from the return address.
    stack: BTreeMap<i64, Content>,
    /// The lowest address of the stack that was used.
    pub(super) lowest: i64,
    /// Between what was on the stack before it was aligned, and what came after.
    gap: Range<i64>,
    /// The most bytes by which that has moved the stack pointer.
    aligned: i64,
    /// What was used through arguments, by their numbers.
    pub(super) arguments: BTreeMap<usize, Used>,
    /// Whether the numbers or the addresses of the stack that were compared last are one.
    pub(super) are_equal: Option<bool>,
}

impl State {
    /// At the first instruction of a function.
    pub(super) fn new() -> Self {
        let arguments = ARGUMENTS.into_iter().enumerate();
        let mut registers: BTreeMap<_, _> = arguments
            .map(|(number, register)| (register, Content::Argument(number, 0)))
            .collect();
        registers.insert(Register::RSP, Content::Stack(0));
        Self {
            registers,
            vectors: BTreeMap::new(),
            stack: BTreeMap::new(),
            lowest: 0,
            gap: 0..0,
            aligned: 0,
            arguments: BTreeMap::new(),
            are_equal: None,
        }
    }

    /// What a register of 64 bits holds.
    pub(super) fn register(&self, register: Register) -> Content {
        let value = self.registers.get(&register).cloned();
        value.unwrap_or(Content::Unknown)
    }

    /// Gives a register, or a part of it, a value.
    pub(super) fn set(&mut self, register: Register, value: Content) {
        let full = register.full_register();
        if full.is_gpr64() {
            let value = if register == full {
                value
            } else {
                Content::Unknown
            };
            self.registers.insert(full, value);
        }
    }

    /// The bytes of a vector, where it was loaded from a constant.
    pub(super) fn vector(&self, register: Register) -> Option<&[u8]> {
        let bytes = self.vectors.get(&register.full_register())?;
        bytes.get(..register.size())
    }

    /// Gives a vector the bytes of a constant, or others that are not known.
    pub(super) fn set_vector(&mut self, register: Register, bytes: Option<&[u8]>) {
        let full = register.full_register();
        match bytes {
            Some(bytes) => self.vectors.insert(full, bytes.to_vec()),
            None => self.vectors.remove(&full),
        };
    }

    /// What the argument of a number is, at a call that pushes so much onto the stack.
    pub(super) fn argument(&self, number: usize, pushed: i64) -> Content {
        if let Some(&register) = ARGUMENTS.get(number) {
            return self.register(register);
        }
        let above = i64::try_from(number - ARGUMENTS.len()).unwrap_or(i64::MAX);
        let above = above.saturating_add(1).saturating_mul(WORD);
        match self.stack_pointer() {
            Some(pointer) => self.load(pointer.saturating_add(pushed).saturating_add(above)),
            None => Content::Unknown,
        }
    }

    /// The stack pointer's distance from the return address; none where it is lost.
    pub(super) fn stack_pointer(&self) -> Option<i64> {
        match self.register(Register::RSP) {
            Content::Stack(offset) => Some(offset),
            _ => None,
        }
    }

    /// True for bytes of the stack that the function may read, or write.
    pub(super) fn is_own(&self, offset: i64, size: i64, writes: bool) -> bool {
        let lowest = self.stack_pointer();
        let lowest = lowest.map(|pointer| pointer.saturating_sub(RED_ZONE));
        let end = offset.saturating_add(size);
        let is_argument = !writes && offset >= WORD && end <= WORD + MOST_ARGUMENTS;
        lowest.is_some_and(|lowest| offset >= lowest)
            && (end <= self.gap.start || offset >= self.gap.end)
            && (end <= 0 || is_argument)
    }

    /// Aligns the stack pointer. How far that moves it depends on the caller, so what is above is no longer a known
    /// distance away.
    pub(super) fn align(&mut self, mask: i64) {
        let alignment = mask.wrapping_neg();
        let is_mask = (WORD..=MOST_ALIGNMENT).contains(&alignment) && alignment.count_ones() == 1;
        let pointer = match self.stack_pointer() {
            Some(pointer) if is_mask && pointer % WORD == 0 && self.gap.is_empty() => {
                self.gap = pointer.saturating_sub(GAP)..pointer;
                // A return address is aligned to a word.
                self.aligned = alignment - WORD;
                Content::Stack(self.gap.start)
            }
            _ => Content::Unknown,
        };
        self.set(Register::RSP, pointer);
    }

    /// The most bytes of stack that were used below the return address.
    pub(super) fn bytes(&self) -> u64 {
        let lowest = if self.lowest < self.gap.start {
            self.lowest + (self.gap.end - self.gap.start) - self.aligned
        } else {
            self.lowest
        };
        lowest.unsigned_abs()
    }

    /// Uses memory to which an argument refers.
    pub(super) fn uses(&mut self, number: usize, bytes: Range<i64>, writes: bool) {
        let used = self.arguments.entry(number).or_insert(Used {
            bytes: bytes.clone(),
            writes,
        });
        used.bytes = used.bytes.start.min(bytes.start)..used.bytes.end.max(bytes.end);
        used.writes |= writes;
    }

    /// What eight bytes of the stack hold.
    pub(super) fn load(&self, offset: i64) -> Content {
        if offset >= WORD && offset % WORD == 0 {
            let number = usize::try_from(offset / WORD - 1).expect("it is above");
            return Content::Argument(ARGUMENTS.len() + number, 0);
        }
        self.stack.get(&offset).cloned().unwrap_or(Content::Unknown)
    }

    /// Forgets what bytes of the stack held.
    pub(super) fn overwrite(&mut self, offset: i64, size: i64) {
        let end = offset.saturating_add(size);
        self.stack
            .retain(|&place, _| place.saturating_add(WORD) <= offset || end <= place);
    }

    /// Writes eight bytes of the stack.
    pub(super) fn store(&mut self, offset: i64, value: Content) {
        self.overwrite(offset, WORD);
        self.stack.insert(offset, value);
    }

    /// After a call, which keeps what the stack holds from an address on.
    pub(super) fn returned(&mut self, kept: i64) {
        self.stack.retain(|&place, _| place >= kept);
        self.are_equal = None;
        self.vectors.clear();
        for register in OF_CALLEE {
            self.set(register, Content::Unknown);
        }
    }
}

impl Content {
    /// So many bytes further.
    pub(super) fn plus(self, number: i64) -> Self {
        match self {
            Self::Address(Target::Constant) => self,
            Self::Argument(argument, distance) => {
                Self::Argument(argument, distance.wrapping_add(number))
            }
            Self::Stack(offset) => Self::Stack(offset.wrapping_add(number)),
            Self::Number(other) => Self::Number(other.wrapping_add(number)),
            _ if number == 0 => self,
            _ => Self::Unknown,
        }
    }
}
