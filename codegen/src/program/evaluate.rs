//! The meaning of a program: what it stores. Flattening is tested against the graph's own meaning.

use std::collections::BTreeMap;

use super::{Definition, Instruction, Operand, Operation, Program};
use crate::{expr::Input, number::Number};

impl Program {
    /// The stored values where `input` gives the inputs, in any kind of numbers.
    pub fn evaluate<N: Number>(&self, mut input: impl FnMut(Input) -> N) -> Vec<N> {
        self.evaluate_by(&mut input)
    }

    /// The same, which helpers go through in turn.
    fn evaluate_by<N: Number>(&self, input: &mut dyn FnMut(Input) -> N) -> Vec<N> {
        let mut values = vec![N::constant(f64::NAN); self.values.len()];
        for (value, slot) in self.values.iter().zip(&mut values) {
            if let Definition::Input(given) = value.definition {
                *slot = input(given);
            }
        }
        let mut shared = BTreeMap::new();
        for instruction in &self.instructions {
            match instruction {
                Instruction::Compute { result, operation } => {
                    values[result.index()] = match *operation {
                        Operation::Add(a, b) => read(&values, a) + read(&values, b),
                        Operation::Mul(a, b) => read(&values, a) * read(&values, b),
                        Operation::MulAdd(a, b, c) => {
                            read(&values, a).mul_add(read(&values, b), read(&values, c))
                        }
                        Operation::Div(a, b) => read(&values, a) / read(&values, b),
                        Operation::Abs(a) => read(&values, a).abs(),
                        Operation::Neg(a) => -read(&values, a),
                    };
                }
                Instruction::SinCos {
                    angles,
                    sines,
                    cosines,
                } => {
                    for (place, &angle) in angles.iter().enumerate() {
                        let (sine, cosine) = read(&values, angle).sin_cos();
                        for (result, number) in [(sines[place], sine), (cosines[place], cosine)] {
                            if let Some(result) = result {
                                values[result.index()] = number;
                            }
                        }
                    }
                }
                Instruction::Share {
                    lockstep,
                    values: given,
                } => {
                    let given = given.iter().map(|&own| read(&values, own));
                    shared.insert(lockstep, given.collect::<Vec<_>>());
                }
                Instruction::Call {
                    lockstep,
                    helper,
                    sides,
                    results,
                } => {
                    let shared = shared.get(lockstep).map_or(&[][..], Vec::as_slice);
                    let helper = &self.helpers[*helper];
                    for lane in 0..helper.lanes {
                        let found = helper.program.evaluate_by(&mut |input| match input {
                            Input::Shared(place) => shared[place],
                            Input::Side(place) => read(&values, sides[place][lane]),
                            other => unreachable!("program: a helper is not given {other:?}"),
                        });
                        for (result, number) in results.iter().zip(found) {
                            if let Some(result) = result[lane] {
                                values[result.index()] = number;
                            }
                        }
                    }
                }
            }
        }
        self.stores
            .iter()
            .map(|&store| read(&values, store))
            .collect()
    }
}

fn read<N: Number>(values: &[N], operand: Operand) -> N {
    match operand {
        Operand::Number(number) => N::constant(number),
        Operand::Value {
            id,
            negative: false,
        } => values[id.index()],
        Operand::Value { id, negative: true } => -values[id.index()],
    }
}
