//! What one instruction does, and what of that is promised not to be.

use iced_x86::{
    Code, ConstantOffsets, CpuidFeature, Instruction, InstructionInfo, Mnemonic, OpAccess, OpKind,
    Register, RflagsBits, UsedMemory,
};

use super::{
    What,
    file::{Files, Location, Reference, Target},
    state::{Content, State, WORD},
};

/// Where arithmetic and moves are, of numbers and of vectors of them; all else is strange.
const FEATURES: [CpuidFeature; 24] = [
    CpuidFeature::INTEL8086,
    CpuidFeature::INTEL186,
    CpuidFeature::INTEL386,
    CpuidFeature::INTEL486,
    CpuidFeature::X64,
    CpuidFeature::CMOV,
    CpuidFeature::MULTIBYTENOP,
    CpuidFeature::SSE,
    CpuidFeature::SSE2,
    CpuidFeature::SSE3,
    CpuidFeature::SSSE3,
    CpuidFeature::SSE4_1,
    CpuidFeature::SSE4_2,
    CpuidFeature::AVX,
    CpuidFeature::AVX2,
    CpuidFeature::FMA,
    CpuidFeature::BMI1,
    CpuidFeature::BMI2,
    CpuidFeature::LZCNT,
    CpuidFeature::POPCNT,
    CpuidFeature::AVX512F,
    CpuidFeature::AVX512VL,
    CpuidFeature::AVX512DQ,
    CpuidFeature::AVX512BW,
];

/// What is neither, there too: the state of the processor, the order of accesses to memory, and what is read ahead.
const STRANGE: [Mnemonic; 29] = [
    Mnemonic::Cld,
    Mnemonic::Lar,
    Mnemonic::Ldmxcsr,
    Mnemonic::Lfence,
    Mnemonic::Lfs,
    Mnemonic::Lgs,
    Mnemonic::Lsl,
    Mnemonic::Lss,
    Mnemonic::Mfence,
    Mnemonic::Popf,
    Mnemonic::Popfq,
    Mnemonic::Prefetchnta,
    Mnemonic::Prefetcht0,
    Mnemonic::Prefetcht1,
    Mnemonic::Prefetcht2,
    Mnemonic::Pushf,
    Mnemonic::Pushfq,
    Mnemonic::Sfence,
    Mnemonic::Sgdt,
    Mnemonic::Sidt,
    Mnemonic::Sldt,
    Mnemonic::Smsw,
    Mnemonic::Std,
    Mnemonic::Stmxcsr,
    Mnemonic::Str,
    Mnemonic::Vldmxcsr,
    Mnemonic::Vstmxcsr,
    Mnemonic::Wait,
    Mnemonic::Xlatb,
];

/// An instruction at its location.
pub(super) struct At<'a, 'data> {
    pub(super) files: &'a Files<'data>,
    /// Its first byte.
    pub(super) location: Location,
    pub(super) instruction: &'a Instruction,
    pub(super) offsets: ConstantOffsets,
}

impl At<'_, '_> {
    /// What the function is that is called or jumped to; none for a location within the function.
    pub(super) fn callee(&self, state: Option<&State>) -> Option<Target> {
        let instruction = self.instruction;
        match instruction.op0_kind() {
            OpKind::NearBranch64 => {
                if let Some(reference) = self.reference(self.offsets.immediate_offset()) {
                    return Some(reference.target);
                }
                // Within the section everything is where it will be.
                let (file, section, offset) = self.location;
                let distance = instruction
                    .near_branch_target()
                    .wrapping_sub(instruction.ip());
                let location = (file, section, offset.wrapping_add(distance));
                self.files
                    .function(location)
                    .map(|_| Target::Function(location))
            }
            OpKind::Memory => {
                let reference = self.reference(self.offsets.displacement_offset());
                let reference = reference.filter(|reference| reference.is_indirect);
                Some(reference.map_or_else(unknown, |reference| reference.target))
            }
            _ => match state.map(|state| state.register(instruction.op0_register())) {
                Some(Content::Address(target)) => Some(target),
                _ => Some(unknown()),
            },
        }
    }

    /// Neither arithmetic nor a move.
    pub(super) fn is_strange(&self) -> bool {
        let instruction = self.instruction;
        instruction.is_invalid()
            || instruction.is_privileged()
            || instruction.is_string_instruction()
            || instruction.has_lock_prefix()
            || instruction.is_save_restore_instruction()
            || STRANGE.contains(&instruction.mnemonic())
            || !instruction
                .cpuid_features()
                .iter()
                .all(|feature| FEATURES.contains(feature))
            || (0..instruction.op_count()).any(|number| {
                instruction.op_kind(number) == OpKind::Register
                    && instruction.op_register(number).is_segment_register()
            })
            || self.reaches_a_bit()
    }

    /// A bit in memory that a register counts, which may be far from the operand.
    fn reaches_a_bit(&self) -> bool {
        let instruction = self.instruction;
        let bits = [Mnemonic::Bt, Mnemonic::Btc, Mnemonic::Btr, Mnemonic::Bts];
        bits.contains(&instruction.mnemonic())
            && instruction.op0_kind() == OpKind::Memory
            && instruction.op1_kind() == OpKind::Register
    }

    /// Holds the memory that it uses to what is promised.
    pub(super) fn check_memory(&self, info: &InstructionInfo, state: &mut State) -> Vec<What> {
        let mut broken = Vec::new();
        for memory in info.used_memory() {
            if memory.access() == OpAccess::NoMemAccess {
                continue;
            }
            let writes = !matches!(memory.access(), OpAccess::Read | OpAccess::CondRead);
            let size = i64::try_from(memory.memory_size().size()).expect("it fits a register");
            let what = match memory.segment() {
                Register::FS | Register::GS => Some(What::Segment),
                // The state of the processor, of which only it knows the size.
                _ if size == 0 => Some(What::Strange),
                _ => {
                    let mut addresses = self.used_addresses(memory, state).into_iter();
                    addresses.find_map(|address| check_address(address, size, writes, state))
                }
            };
            broken.extend(what);
        }
        broken
    }

    /// Does to the registers and the stack what it does to addresses in them.
    pub(super) fn update(&self, info: &InstructionInfo, state: &mut State) {
        let instruction = self.instruction;
        if instruction.rflags_modified() != RflagsBits::NONE {
            state.are_equal = self.compared(state);
        }
        self.update_vectors(info, state);
        match instruction.mnemonic() {
            // What pushes or pops fewer bytes leaves the stack pointer unknown, below.
            Mnemonic::Push if instruction.stack_pointer_increment() == -8 => {
                let value = self.operand(0, state);
                move_stack_pointer(state, -WORD);
                if let Some(pointer) = state.stack_pointer() {
                    state.store(pointer, value);
                }
            }
            Mnemonic::Pop if instruction.stack_pointer_increment() == 8 => {
                let pointer = state.stack_pointer();
                let value = pointer.map_or(Content::Unknown, |pointer| state.load(pointer));
                move_stack_pointer(state, WORD);
                state.set(instruction.op0_register(), value);
            }
            Mnemonic::Leave if instruction.code() == Code::Leaveq => {
                let frame = state.register(Register::RBP);
                let value = match frame {
                    Content::Stack(offset) => state.load(offset),
                    _ => Content::Unknown,
                };
                state.set(Register::RSP, frame.plus(WORD));
                state.set(Register::RBP, value);
            }
            Mnemonic::Mov => self.assign(self.operand(1, state), state),
            Mnemonic::Lea => {
                let value = self.operand_address(state);
                state.set(instruction.op0_register(), value);
            }
            Mnemonic::Add => {
                let value = match self.operand(1, state) {
                    Content::Number(number) => self.operand(0, state).plus(number),
                    _ => Content::Unknown,
                };
                self.assign(value, state);
            }
            Mnemonic::Sub | Mnemonic::Xor if self.is_zero() => {
                state.set(
                    instruction.op0_register().full_register(),
                    Content::Number(0),
                );
            }
            Mnemonic::Inc => self.assign(self.operand(0, state).plus(1), state),
            Mnemonic::Dec => self.assign(self.operand(0, state).plus(-1), state),
            Mnemonic::Sub => {
                let value = match self.operand(1, state) {
                    Content::Number(number) => self.operand(0, state).plus(number.wrapping_neg()),
                    _ => Content::Unknown,
                };
                self.assign(value, state);
            }
            Mnemonic::And if instruction.op0_register() == Register::RSP => {
                match self.operand(1, state) {
                    Content::Number(mask) => state.align(mask),
                    _ => state.set(Register::RSP, Content::Unknown),
                }
            }
            _ => {
                for register in info.used_registers() {
                    if !matches!(register.access(), OpAccess::Read | OpAccess::CondRead) {
                        state.set(register.register().full_register(), Content::Unknown);
                    }
                }
            }
        }
    }

    /// Whether the numbers, or the addresses of the stack, that it compares are one, or whether the number that it computes is zero.
    fn compared(&self, state: &State) -> Option<bool> {
        let instruction = self.instruction;
        let is_half = match instruction.op0_register() {
            register if register.is_gpr32() => true,
            register if register.is_gpr64() => false,
            _ => return None,
        };
        let [one, other] = match instruction.mnemonic() {
            Mnemonic::Cmp | Mnemonic::Sub | Mnemonic::Add => {
                [0, 1].map(|number| self.operand(number, state))
            }
            Mnemonic::Inc | Mnemonic::Dec => [self.operand(0, state), Content::Number(1)],
            _ => return None,
        };
        match (one, other) {
            (Content::Stack(one), Content::Stack(other)) => {
                (instruction.mnemonic() == Mnemonic::Cmp).then_some(one == other)
            }
            (Content::Number(one), Content::Number(other)) => {
                let is_sum = matches!(instruction.mnemonic(), Mnemonic::Add | Mnemonic::Inc);
                let left = one.wrapping_sub(if is_sum { other.wrapping_neg() } else { other });
                let half = u64::from(u32::MAX).cast_signed();
                Some(if is_half { left & half == 0 } else { left == 0 })
            }
            _ => None,
        }
    }

    /// Where it jumps to within its function, if whether it does follows from numbers in the code or addresses of the stack alone:
    /// columns are counted, and a large stack is touched page by page.
    pub(super) fn counted_jump(&self, state: &State) -> Option<u64> {
        let instruction = self.instruction;
        let is_taken = match instruction.mnemonic() {
            Mnemonic::Je => state.are_equal?,
            Mnemonic::Jne => !state.are_equal?,
            // Back to the start of a loop whose test stands in its middle.
            Mnemonic::Jmp if self.is_back() => true,
            _ => return None,
        };
        let is_near = self.reference(self.offsets.immediate_offset()).is_none();
        is_near.then_some(if is_taken {
            instruction.near_branch_target()
        } else {
            instruction.next_ip()
        })
    }

    fn is_back(&self) -> bool {
        let instruction = self.instruction;
        let is_near = instruction.op0_kind() == OpKind::NearBranch64;
        is_near && instruction.near_branch_target() < instruction.ip()
    }

    /// Twice the same register, of which the difference is taken.
    fn is_zero(&self) -> bool {
        let instruction = self.instruction;
        instruction.op0_kind() == OpKind::Register
            && instruction.op1_kind() == OpKind::Register
            && instruction.op0_register() == instruction.op1_register()
            && (instruction.op0_register().is_gpr32() || instruction.op0_register().is_gpr64())
    }

    /// What the first operand becomes.
    fn assign(&self, value: Content, state: &mut State) {
        let instruction = self.instruction;
        match instruction.op0_kind() {
            OpKind::Register => {
                let register = instruction.op0_register();
                // A number that is given to a half fills the whole.
                let (register, value) = match value {
                    Content::Number(number) if register.is_gpr32() => {
                        (register.full_register(), half(number))
                    }
                    value => (register, value),
                };
                state.set(register, value);
            }
            OpKind::Memory => {
                if let (8, Content::Stack(offset)) = (self.size(), self.operand_address(state)) {
                    state.store(offset, value);
                }
            }
            _ => {}
        }
    }

    /// What an operand is.
    fn operand(&self, number: u32, state: &State) -> Content {
        let instruction = self.instruction;
        match instruction.op_kind(number) {
            OpKind::Register => {
                let register = instruction.op_register(number);
                match state.register(register.full_register()) {
                    Content::Number(number) if register.is_gpr32() => half(number),
                    own if register.is_gpr64() => own,
                    _ => Content::Unknown,
                }
            }
            OpKind::Memory => {
                let reference = self.reference(self.offsets.displacement_offset());
                if let Some(reference) = reference.filter(|reference| reference.is_indirect) {
                    return Content::Address(reference.target);
                }
                match (self.size(), self.operand_address(state)) {
                    (8, Content::Stack(offset)) => state.load(offset),
                    _ => Content::Unknown,
                }
            }
            // All others of these instructions are numbers in the code, of which none but an address needs all bits.
            _ => Content::Number(instruction.immediate(number).cast_signed()),
        }
    }

    /// The address of memory that is used, be it an operand or the stack.
    pub(super) fn used_address(&self, memory: &UsedMemory, state: &State) -> Content {
        // Iced has counted an address from the instruction's end already.
        if self.instruction.is_ip_rel_memory_operand() && memory.base() == Register::None {
            return self.operand_address(state);
        }
        self.address(
            [memory.base(), memory.index()],
            memory.scale().into(),
            memory.displacement(),
            state,
        )
    }

    /// Bytes of the operand in memory.
    pub(super) fn size(&self) -> usize {
        self.instruction.memory_size().size()
    }

    /// The address of the operand in memory.
    fn operand_address(&self, state: &State) -> Content {
        let instruction = self.instruction;
        self.address(
            [instruction.memory_base(), instruction.memory_index()],
            instruction.memory_index_scale().into(),
            instruction.memory_displacement64(),
            state,
        )
    }

    fn address(
        &self,
        [base, index]: [Register; 2],
        scale: i64,
        displacement: u64,
        state: &State,
    ) -> Content {
        if matches!(base, Register::RIP | Register::EIP) {
            return Content::Address(match self.reference(self.offsets.displacement_offset()) {
                Some(reference) if reference.is_indirect => Target::Constant,
                Some(reference) => reference.target,
                None => unknown(),
            });
        }
        let [base, index] = [base, index].map(|register| match register {
            Register::None => Content::Number(0),
            register => state.register(register),
        });
        match index {
            Content::Number(index) => {
                let distance = displacement.cast_signed();
                base.plus(distance.wrapping_add(index.wrapping_mul(scale)))
            }
            _ => Content::Unknown,
        }
    }

    fn reference(&self, within: usize) -> Option<Reference> {
        let (file, section, offset) = self.location;
        let at = (file, section, offset + within as u64);
        let after = self.instruction.len().checked_sub(within)?;
        self.files.reference(at, i64::try_from(after).ok()?)
    }
}

/// The lower half of a number.
fn half(number: i64) -> Content {
    Content::Number(number & u64::from(u32::MAX).cast_signed())
}

fn unknown() -> Target {
    Target::Other("?".to_owned())
}

fn move_stack_pointer(state: &mut State, distance: i64) {
    let pointer = state.register(Register::RSP).plus(distance);
    state.set(Register::RSP, pointer);
}

/// What is broken where so many bytes at an address are read or written.
pub(super) fn check_address(
    address: Content,
    size: i64,
    writes: bool,
    state: &mut State,
) -> Option<What> {
    match address {
        Content::Argument(number, distance) => {
            state.uses(number, distance..distance.saturating_add(size), writes);
            None
        }
        Content::Stack(offset) if state.is_own(offset, size, writes) => {
            state.lowest = state.lowest.min(offset);
            if writes {
                state.overwrite(offset, size);
            }
            None
        }
        Content::Stack(_) => Some(What::Stack),
        Content::Address(Target::Constant) if !writes => None,
        Content::Address(Target::Other(name)) => Some(What::Static(Some(name))),
        Content::Address(_) => Some(What::Static(None)),
        Content::Number(_) => Some(What::Absolute),
        Content::Unknown => Some(What::Computed),
    }
}
