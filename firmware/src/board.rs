//! The microcontroller: counts the instructions and the stack of a call, and prints by semihosting.

use core::{arch::asm, panic::PanicInfo, ptr};

use cortex_m_rt::entry;
use cortex_m_semihosting::{
    debug::{EXIT_FAILURE, EXIT_SUCCESS, ExitStatus, exit},
    hio::{HostStream, hstdout},
};

use crate::calls::{self, Cost, Machine};

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    panic_handler()
}

/// Where every panic ends, under a name that the host finds: it is in the program only if something can panic.
#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn panic_handler() -> ! {
    end(EXIT_FAILURE)
}

#[entry]
fn main() -> ! {
    let Ok(host) = hstdout() else {
        end(EXIT_FAILURE)
    };
    start_timer();
    let mut board = Board { host, overhead: 0 };
    board.overhead = board.measure(|| ()).instructions;
    calls::run(&mut board);
    end(EXIT_SUCCESS)
}

fn end(status: ExitStatus) -> ! {
    loop {
        exit(status);
    }
}

struct Board {
    host: HostStream,
    /// Instructions of a measurement itself.
    overhead: usize,
}

impl Machine for Board {
    #[inline(never)]
    fn measure(&mut self, call: impl FnOnce()) -> Cost {
        let stack = PaintedStack::new();
        let start = timer();
        call();
        let ticks = start.wrapping_sub(timer()) & TIMER_BITS;
        Cost {
            instructions: instructions(ticks) - self.overhead,
            stack: stack.used(),
        }
    }

    fn print(&mut self, text: &[u8]) {
        if self.host.write_all(text).is_err() {
            end(EXIT_FAILURE);
        }
    }
}

// The SysTick timer counts down 24 bits with the boards' clock of 25 MHz. QEMU, asked for `-icount shift=7`, lets 2^7 ns pass
// with every instruction: more than two ticks of 40 ns, so that counts are exact, up to five million. It does not
// model how long instructions take, and has not the cycle counter that one would read on hardware.
const CONTROL: *mut usize = ptr::without_provenance_mut(0xE000_E010);
const RELOAD: *mut usize = ptr::without_provenance_mut(0xE000_E014);
const CURRENT: *mut usize = ptr::without_provenance_mut(0xE000_E018);
const TIMER_BITS: usize = 0x00FF_FFFF;
const NANOSECONDS_PER_TICK: usize = 40;
const NANOSECONDS_PER_INSTRUCTION: usize = 128;

fn start_timer() {
    // SAFETY: the registers of a timer that nothing else uses.
    unsafe {
        RELOAD.write_volatile(TIMER_BITS);
        CURRENT.write_volatile(0);
        // On, with the processor's clock, without interrupts.
        CONTROL.write_volatile(0b101);
    }
}

fn timer() -> usize {
    // SAFETY: a register that can be read at any time.
    unsafe { CURRENT.read_volatile() }
}

/// The nearest number, for the difference of two readings is less than a tick off.
fn instructions(ticks: usize) -> usize {
    (ticks * NANOSECONDS_PER_TICK + NANOSECONDS_PER_INSTRUCTION / 2) / NANOSECONDS_PER_INSTRUCTION
}

/// The stack below the function that holds this, filled with one word as far as any call may reach.
struct PaintedStack {
    top: usize,
}

impl PaintedStack {
    const BYTES: usize = 256 * 1024;
    const PAINT: usize = 0xA5C3_96E1;

    #[expect(
        clippy::inline_always,
        reason = "a call would itself stand on that stack"
    )]
    #[inline(always)]
    fn new() -> Self {
        let top: usize;
        // SAFETY: reads a register.
        unsafe { asm!("mov {}, sp", out(reg) top, options(nomem, nostack, preserves_flags)) };
        let stack = Self { top };
        for word in stack.words() {
            // SAFETY: memory below the stack pointer, with megabytes to spare, of which no interrupt makes use.
            unsafe { word.write_volatile(Self::PAINT) };
        }
        stack
    }

    /// Bytes down to the lowest word that was written since.
    #[expect(
        clippy::inline_always,
        reason = "a call would itself stand on that stack"
    )]
    #[inline(always)]
    fn used(&self) -> usize {
        // SAFETY: as above.
        let is_untouched = |word: &*mut usize| unsafe { word.read_volatile() } == Self::PAINT;
        Self::BYTES - size_of::<usize>() * self.words().take_while(is_untouched).count()
    }

    /// The lowest first.
    fn words(&self) -> impl Iterator<Item = *mut usize> {
        let words = (self.top - Self::BYTES..self.top).step_by(size_of::<usize>());
        words.map(ptr::with_exposed_provenance_mut)
    }
}
