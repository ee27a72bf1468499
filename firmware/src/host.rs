//! Compares what microcontrollers printed with the same calls on this machine, and prints what these cost there.
//!
//! In: for each microcontroller its name, its program and the file of what that printed. Out: a table; or the first number
//! that differs, or the functions that could panic.

use std::{
    env,
    error::Error,
    fmt::{self, Display, Formatter, Write as _},
    fs,
    process::ExitCode,
};

use crate::{
    calls::{self, Cost, Machine},
    elf::Program,
};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

pub(crate) fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match report(&arguments) {
        Ok(table) => {
            print!("{table}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn report(arguments: &[String]) -> Result<Table> {
    let (microcontrollers @ [_, ..], []) = arguments.as_chunks() else {
        return Err("arguments: NAME PROGRAM OUTPUT, for each microcontroller".into());
    };
    let mut host = Host::default();
    calls::run(&mut host);
    let expected = read_calls(&host.printed)?;

    let mut table = Table::new(&expected);
    for [name, program, printed] in microcontrollers {
        let (program, printed) = (read(program)?, read(printed)?);
        let program = Program::new(&program)?;
        let found = read_calls(str::from_utf8(&printed)?)?;
        if let Some(difference) = first_difference(&expected, &found) {
            return Err(format!("{name}: other bits: {difference}").into());
        }
        let paths = program.panic_paths()?;
        if !paths.is_empty() {
            let paths = paths.join("\n");
            return Err(format!("{name}: a panic can be reached:\n{paths}").into());
        }
        table.add(name, &program, &found)?;
    }
    Ok(table)
}

fn read(path: &str) -> Result<Vec<u8>> {
    fs::read(path).map_err(|error| format!("{path}: {error}").into())
}

/// Where the calls are only made and printed.
#[derive(Default)]
struct Host {
    printed: String,
}

impl Machine for Host {
    fn measure(&mut self, call: impl FnOnce()) -> Cost {
        call();
        Cost::default()
    }

    fn print(&mut self, text: &[u8]) {
        self.printed.push_str(&String::from_utf8_lossy(text));
    }
}

/// A call as it was printed.
struct Call<'text> {
    function: &'text str,
    scalar: &'text str,
    state: &'text str,
    address: usize,
    cost: Cost,
    bits: Vec<&'text str>,
}

impl<'text> Call<'text> {
    fn read(line: &'text str) -> Option<Self> {
        let mut fields = line.split(' ');
        let (function, scalar, state) = (fields.next()?, fields.next()?, fields.next()?);
        let mut number = || usize::from_str_radix(fields.next()?, 16).ok();
        Some(Self {
            function,
            scalar,
            state,
            address: number()?,
            cost: Cost {
                instructions: number()?,
                stack: number()?,
            },
            bits: fields.collect(),
        })
    }

    fn name(&self) -> String {
        format!("{} {}, state {}", self.function, self.scalar, self.state)
    }
}

fn read_calls(printed: &str) -> Result<Vec<Call<'_>>> {
    let read = |line| Call::read(line).ok_or_else(|| format!("this is no call: {line}").into());
    printed.lines().map(read).collect()
}

/// The first difference of the bits, where there is one.
fn first_difference(expected: &[Call<'_>], found: &[Call<'_>]) -> Option<String> {
    for (expected, found) in expected.iter().zip(found) {
        let name = expected.name();
        if name != found.name() || expected.bits.len() != found.bits.len() {
            return Some(format!("another call in place of {name}: {}", found.name()));
        }
        let mut pairs = expected.bits.iter().zip(&found.bits).enumerate();
        if let Some((place, (expected, found))) =
            pairs.find(|(_, (expected, found))| expected != found)
        {
            return Some(format!(
                "{name}, number {place}: {found}, and {expected} on the host"
            ));
        }
    }
    (expected.len() != found.len())
        .then(|| format!("{} calls, and {} on the host", found.len(), expected.len()))
}

/// What the functions cost, a row for each with each scalar.
struct Table {
    head: String,
    rule: String,
    rows: Vec<String>,
    legend: String,
}

impl Table {
    fn new(calls: &[Call<'_>]) -> Self {
        let numbers: usize = calls.iter().map(|call| call.bits.len()).sum();
        let row = |calls: &[Call<'_>]| format!("| `{}` | {} |", calls[0].function, calls[0].scalar);
        Self {
            head: "| function | scalar |".into(),
            rule: "| --- | --- |".into(),
            rows: by_function(calls).map(row).collect(),
            legend: format!(
                "All {numbers} numbers have the same bits as on the host.\n\
                 Flash is that of the function alone; stack and instructions are the most of any state, with all that it calls.\n"
            ),
        }
    }

    /// Adds the columns of a microcontroller.
    fn add(&mut self, name: &str, program: &Program<'_>, calls: &[Call<'_>]) -> Result<()> {
        write!(
            self.head,
            " {name}: flash, bytes | stack, bytes | instructions |"
        )?;
        self.rule += " ---: | ---: | ---: |";
        for (row, calls) in self.rows.iter_mut().zip(by_function(calls)) {
            let address = calls[0].address;
            let flash = program
                .function_size(address)
                .ok_or_else(|| format!("{name}: no function at {address:x}"))?;
            let most = |of: fn(&Cost) -> usize| calls.iter().map(|call| of(&call.cost)).max();
            let stack = most(|cost| cost.stack).unwrap_or_default();
            let instructions = most(|cost| cost.instructions).unwrap_or_default();
            write!(row, " {flash} | {stack} | {instructions} |")?;
        }
        writeln!(
            self.legend,
            "The whole program takes {} bytes of flash on the {name}.",
            program.flash_size()
        )?;
        Ok(())
    }
}

/// The calls of each function with each scalar.
fn by_function<'calls, 'text>(
    calls: &'calls [Call<'text>],
) -> impl Iterator<Item = &'calls [Call<'text>]> {
    calls.chunk_by(|a, b| (a.function, a.scalar) == (b.function, b.scalar))
}

impl Display for Table {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n{}", self.head, self.rule)?;
        for row in &self.rows {
            writeln!(f, "{row}")?;
        }
        write!(f, "\n{}", self.legend)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference(expected: &str, found: &str) -> Option<String> {
        first_difference(&read_calls(expected).unwrap(), &read_calls(found).unwrap())
    }

    const TWO_STATES: &str =
        "arm::bias f32 00 0 0 0 3F800000 40000000\narm::bias f32 01 0 0 0 3F800000 40000000";

    #[test]
    fn the_same_bits_differ_in_nothing_whatever_they_cost() {
        let costly = TWO_STATES.replace(" 0 0 0", " 8000 1F 40");
        assert_eq!(difference(TWO_STATES, &costly), None);
    }

    #[test]
    fn one_other_bit_is_named_with_its_place() {
        let other =
            "arm::bias f32 00 0 0 0 3F800000 40000000\narm::bias f32 01 0 0 0 3F800000 40000001";
        let difference = difference(TWO_STATES, other);
        assert_eq!(
            difference.as_deref(),
            Some("arm::bias f32, state 01, number 1: 40000001, and 40000000 on the host")
        );
    }

    #[test]
    fn missing_calls_and_numbers_are_differences() {
        let (one_state, _) = TWO_STATES.split_once('\n').unwrap();
        let (without_last, _) = TWO_STATES.rsplit_once(' ').unwrap();
        assert!(difference(TWO_STATES, one_state).is_some());
        assert!(difference(TWO_STATES, without_last).is_some());
    }
}
