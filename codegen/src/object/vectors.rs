//! Vectors of distances, from one address to several: where they are constants, each of these is known.

use iced_x86::{InstructionInfo, Mnemonic, OpAccess, OpKind, Register, UsedMemory};

use super::{
    instruction::At,
    state::{Content, State},
};

/// What loads a whole vector, and does nothing else.
const LOADS: [Mnemonic; 10] = [
    Mnemonic::Vmovapd,
    Mnemonic::Vmovaps,
    Mnemonic::Vmovdqa,
    Mnemonic::Vmovdqa32,
    Mnemonic::Vmovdqa64,
    Mnemonic::Vmovdqu,
    Mnemonic::Vmovdqu32,
    Mnemonic::Vmovdqu64,
    Mnemonic::Vmovupd,
    Mnemonic::Vmovups,
];

impl At<'_, '_> {
    /// Vectors that it loads from constants are known, others that it writes are not.
    pub(super) fn update_vectors(&self, info: &InstructionInfo, state: &mut State) {
        for used in info.used_registers() {
            let is_read = matches!(used.access(), OpAccess::Read | OpAccess::CondRead);
            if used.register().is_vector_register() && !is_read {
                state.set_vector(used.register(), None);
            }
        }
        let instruction = self.instruction;
        let is_load = LOADS.contains(&instruction.mnemonic())
            && instruction.op1_kind() == OpKind::Memory
            && instruction.op_mask() == Register::None;
        if is_load {
            state.set_vector(instruction.op0_register(), self.constant());
        }
    }

    /// The constant in memory that it reads.
    fn constant(&self) -> Option<&[u8]> {
        if !self.instruction.is_ip_rel_memory_operand() {
            return None;
        }
        let (file, section, offset) = self.location;
        let within = self.offsets.displacement_offset();
        let after = self.instruction.len().checked_sub(within)?;
        let at = (file, section, offset + within as u64);
        let after = i64::try_from(after).ok()?;
        self.files.constant(at, after, self.size())
    }

    /// The addresses of memory that is used: several, where a vector says how far from the first.
    pub(super) fn used_addresses(&self, memory: &UsedMemory, state: &State) -> Vec<Content> {
        let width = memory.vsib_size() as usize;
        if width == 0 {
            return vec![self.used_address(memory, state)];
        }
        let Some(distances) = state.vector(memory.index()) else {
            return vec![Content::Unknown];
        };
        let distances = distances.chunks_exact(width).map(|bytes| match *bytes {
            [a, b, c, d] => i64::from(i32::from_le_bytes([a, b, c, d])),
            [a, b, c, d, e, f, g, h] => i64::from_le_bytes([a, b, c, d, e, f, g, h]),
            _ => unreachable!("object: distances have four or eight bytes"),
        });
        let base = state.register(memory.base());
        let displacement = memory.displacement().cast_signed();
        distances
            .map(|distance| {
                let scaled = distance.wrapping_mul(memory.scale().into());
                base.clone().plus(displacement.wrapping_add(scaled))
            })
            .collect()
    }
}
