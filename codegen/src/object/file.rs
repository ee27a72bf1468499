//! Machine code as rustc leaves it: functions, and what their instructions refer to.

use std::collections::BTreeMap;

use object::{
    Architecture, Object as _, ObjectSection, ObjectSymbol as _, Relocation, RelocationFlags,
    RelocationTarget, SectionFlags, SymbolSection, elf,
};
use rustc_demangle::demangle;

use super::Error;

/// Where a function or a constant is: the file, the section, the offset.
pub(super) type Location = (usize, usize, u64);

/// A function: its bytes, and where they are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Code<'data> {
    pub(super) location: Location,
    pub(super) bytes: &'data [u8],
}

/// What a part of an instruction refers to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Reference {
    pub(super) target: Target,
    /// True where a constant is meant that holds the target's address.
    pub(super) is_indirect: bool,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// A function that is here.
    Function(Location),
    /// What nobody can write.
    Constant,
    /// Anything else, by name.
    Other(String),
}

/// Functions of several files that refer to one another by name.
#[derive(Debug)]
pub(super) struct Files<'data> {
    objects: Vec<object::File<'data>>,
    functions: BTreeMap<Location, Code<'data>>,
    /// Several functions may be one, where their bytes are the same.
    locations: BTreeMap<String, Location>,
    names: BTreeMap<Location, String>,
    /// By where the reference stands.
    relocations: BTreeMap<Location, Relocation>,
}

impl<'data> Files<'data> {
    pub(super) fn new(files: &'data [Vec<u8>]) -> Result<Self, Error> {
        let mut read = Self {
            objects: Vec::new(),
            functions: BTreeMap::new(),
            locations: BTreeMap::new(),
            names: BTreeMap::new(),
            relocations: BTreeMap::new(),
        };
        for bytes in files {
            read.add(bytes)?;
        }
        Ok(read)
    }

    /// The location of a function, by its name.
    pub(super) fn location(&self, name: &str) -> Option<Location> {
        self.locations.get(name).copied()
    }

    /// The function at a location.
    pub(super) fn function(&self, location: Location) -> Option<Code<'data>> {
        self.functions.get(&location).copied()
    }

    /// The name of the function at a location.
    pub(super) fn name(&self, location: Location) -> &str {
        self.names.get(&location).map_or("?", String::as_str)
    }

    /// What the bytes at a location refer to; `after` is how far from there the instruction ends. None where no reference
    /// stands.
    pub(super) fn reference(&self, at: Location, after: i64) -> Option<Reference> {
        let relocation = self.relocations.get(&at)?;
        let RelocationFlags::Elf { r_type } = relocation.flags() else {
            return None;
        };
        let is_indirect = [
            elf::R_X86_64_GOTPCREL,
            elf::R_X86_64_GOTPCRELX,
            elf::R_X86_64_REX_GOTPCRELX,
        ]
        .contains(&r_type);
        let (file, _, _) = at;
        let target = self.target(file, relocation, after);
        let target = target.unwrap_or_else(|| Target::Other("?".to_owned()));
        Some(Reference {
            target,
            is_indirect,
        })
    }

    /// So many bytes of the constant to which those at a location refer, as [`Self::reference`] has it.
    pub(super) fn constant(&self, at: Location, after: i64, length: usize) -> Option<&'data [u8]> {
        let reference = self.reference(at, after)?;
        if reference.target != Target::Constant || reference.is_indirect {
            return None;
        }
        let (file, relocation) = (self.objects.get(at.0)?, self.relocations.get(&at)?);
        let RelocationTarget::Symbol(index) = relocation.target() else {
            return None;
        };
        let symbol = file.symbol_by_index(index).ok()?;
        let section = file.section_by_index(symbol.section_index()?).ok()?;
        let start = symbol
            .address()
            .wrapping_add_signed(relocation.addend() + after);
        let start = usize::try_from(start.checked_sub(section.address())?).ok()?;
        section.data().ok()?.get(start..start.checked_add(length)?)
    }

    fn target(&self, number: usize, relocation: &Relocation, after: i64) -> Option<Target> {
        let file = self.objects.get(number)?;
        let RelocationTarget::Symbol(index) = relocation.target() else {
            return None;
        };
        let symbol = file.symbol_by_index(index).ok()?;
        let name = format!("{:#}", demangle(symbol.name().ok()?));
        let SymbolSection::Section(section) = symbol.section() else {
            // In another file, or in none that is here.
            let location = self.location(&name);
            return Some(location.map_or(Target::Other(name), Target::Function));
        };
        // From the end of the instruction the processor counts.
        let offset = symbol
            .address()
            .wrapping_add_signed(relocation.addend() + after);
        let location = (number, section.0, offset);
        if self.functions.contains_key(&location) {
            return Some(Target::Function(location));
        }
        let section = file.section_by_index(section).ok()?;
        Some(if is_constant(&section) {
            Target::Constant
        } else if name.is_empty() {
            Target::Other(section.name().ok()?.to_owned())
        } else {
            Target::Other(name)
        })
    }

    fn add(&mut self, bytes: &'data [u8]) -> Result<(), Error> {
        let unreadable = |error: object::Error| Error::Object(error.to_string());
        let number = self.objects.len();
        let file = object::File::parse(bytes).map_err(|_| Error::Target {
            found: "files that are not ELF".to_owned(),
        })?;
        if file.architecture() != Architecture::X86_64 {
            return Err(Error::Target {
                found: format!("{:?}", file.architecture()),
            });
        }
        for symbol in file.symbols() {
            let SymbolSection::Section(section) = symbol.section() else {
                continue;
            };
            if symbol.kind() != object::SymbolKind::Text || symbol.size() == 0 {
                continue;
            }
            let data = file.section_by_index(section).map_err(unreadable)?;
            let data = data.data_range(symbol.address(), symbol.size());
            let Some(bytes) = data.map_err(unreadable)? else {
                continue;
            };
            let location = (number, section.0, symbol.address());
            let name = format!("{:#}", demangle(symbol.name().map_err(unreadable)?));
            self.functions.insert(location, Code { location, bytes });
            self.names.entry(location).or_insert_with(|| name.clone());
            self.locations.entry(name).or_insert(location);
        }
        for section in file.sections() {
            for (offset, relocation) in section.relocations() {
                let at = (number, section.index().0, offset);
                self.relocations.insert(at, relocation);
            }
        }
        self.objects.push(file);
        Ok(())
    }
}

/// True for what is loaded, and neither written nor executed.
fn is_constant<'data>(section: &impl ObjectSection<'data>) -> bool {
    let SectionFlags::Elf { sh_flags, .. } = section.flags() else {
        return false;
    };
    let flags = [elf::SHF_ALLOC, elf::SHF_WRITE, elf::SHF_EXECINSTR];
    flags.map(|flag| (sh_flags & flag).0 != 0) == [true, false, false]
}
