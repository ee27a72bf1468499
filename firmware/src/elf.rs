//! A linked program: what its functions take of the flash, and whether one of them could panic.

use std::{
    collections::{BTreeMap, BTreeSet},
    error::Error,
};

use object::{
    Object, ObjectSection, ObjectSegment, ObjectSymbol, RelocationTarget, SymbolKind,
    read::elf::ElfFile32,
};

/// Where every panic ends.
const PANIC_HANDLER: &str = "panic_handler";

pub(crate) struct Program<'data> {
    file: ElfFile32<'data>,
    functions: Vec<Function<'data>>,
}

struct Function<'data> {
    name: &'data str,
    address: u64,
    size: u64,
}

impl<'data> Program<'data> {
    pub(crate) fn new(bytes: &'data [u8]) -> Result<Self, Box<dyn Error>> {
        let file = ElfFile32::parse(bytes)?;
        let mut functions = Vec::new();
        for symbol in file.symbols() {
            if symbol.kind() == SymbolKind::Text && symbol.size() > 0 {
                functions.push(Function {
                    name: symbol.name()?,
                    address: without_thumb_bit(symbol.address()),
                    size: symbol.size(),
                });
            }
        }
        Ok(Self { file, functions })
    }

    /// Bytes of the function at an address.
    pub(crate) fn function_size(&self, address: usize) -> Option<u64> {
        let address = without_thumb_bit(address as u64);
        let mut functions = self.functions.iter();
        functions
            .find(|function| function.address == address)
            .map(|function| function.size)
    }

    /// Bytes of everything that is stored: vectors, functions and constants.
    pub(crate) fn flash_size(&self) -> u64 {
        let stored = self.file.segments().map(|segment| segment.file_range().1);
        stored.sum()
    }

    /// Every function from which the panic handler can be reached, with the next one on the way; empty where nothing can
    /// panic, for then the linker has left the handler out.
    pub(crate) fn panic_paths(&self) -> Result<Vec<String>, Box<dyn Error>> {
        if self.file.symbol_by_name(PANIC_HANDLER).is_none() {
            return Ok(Vec::new());
        }
        let callers = self.callers()?;
        let mut paths = vec![PANIC_HANDLER.to_owned()];
        let (mut reached, mut seen) = (vec![PANIC_HANDLER], BTreeSet::new());
        while let Some(callee) = reached.pop() {
            for &caller in callers.get(callee).into_iter().flatten() {
                paths.push(format!("{callee} from {caller}"));
                if seen.insert(caller) {
                    reached.push(caller);
                }
            }
        }
        Ok(paths)
    }

    /// Of each function those that name it, by the relocations that the linker has kept.
    fn callers(&self) -> Result<BTreeMap<&'data str, BTreeSet<&'data str>>, Box<dyn Error>> {
        let mut callers = BTreeMap::<_, BTreeSet<_>>::new();
        for section in self.file.sections() {
            for (address, relocation) in section.relocations() {
                let RelocationTarget::Symbol(index) = relocation.target() else {
                    continue;
                };
                let callee = self.file.symbol_by_index(index)?.name()?;
                let within = |function: &&Function<'_>| {
                    (function.address..function.address + function.size).contains(&address)
                };
                if let Some(caller) = self.functions.iter().find(within) {
                    callers.entry(callee).or_default().insert(caller.name);
                }
            }
        }
        Ok(callers)
    }
}

/// The lowest bit of a function's address says which of two instruction sets it is in.
fn without_thumb_bit(address: u64) -> u64 {
    address & !1
}
