//! A long function's stages do what the function does.

use std::collections::BTreeMap;

use kane_codegen::listing::{
    Code, Entry, Expression, Facts, Fault, Function, Helper, LocalId, Module, Role, Stage,
    Statement, verify,
};
use kane_codegen::{
    description::{self, Base, Reading, no_includes},
    diagnostic::Source,
    functions::Signature,
};

use super::verify::module_of;
use crate::module::hinges;

/// Numbers of arguments, by the argument's name and the place.
type Numbers = BTreeMap<(String, usize), f64>;

/// What statements are given.
struct Given<'a> {
    facts: &'a Facts,
    /// What stands at a place of an argument that is read.
    number: &'a dyn Fn(&(String, usize)) -> f64,
    /// What earlier stages have stored.
    stored: &'a Numbers,
    helpers: &'a [Helper],
}

/// What statements have computed.
struct Run<'a> {
    given: &'a Given<'a>,
    signature: &'a Signature,
    locals: Vec<f64>,
    arrays: Vec<Vec<f64>>,
    /// What earlier stages have returned.
    kept: &'a [Vec<f64>],
    stored: Numbers,
}

impl<'a> Run<'a> {
    fn of(
        given: &'a Given<'a>,
        signature: &'a Signature,
        code: &Code,
        kept: &'a [Vec<f64>],
    ) -> Self {
        let mut run = Self {
            given,
            signature,
            locals: vec![f64::NAN; code.locals.len()],
            arrays: code
                .arrays
                .iter()
                .map(|array| vec![f64::NAN; array.length])
                .collect(),
            kept,
            stored: Numbers::new(),
        };
        for statement in &code.statements {
            run.statement(statement);
        }
        run
    }

    fn place(&self, entry: &Entry) -> (String, usize) {
        let argument = &self.signature.arguments[entry.argument];
        let place = self.given.facts.extent(argument).place(&entry.steps);
        (
            argument.name.clone(),
            place.expect("a place of the argument"),
        )
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Assign { local, value } => self.locals[local.index()] = self.value(value),
            Statement::SinCos {
                angle,
                sine,
                cosine,
            } => {
                let (sin, cos) = libm::sincos(self.value(angle));
                let mut assign = |local: &Option<LocalId>, value| {
                    if let Some(local) = local {
                        self.locals[local.index()] = value;
                    }
                };
                assign(sine, sin);
                assign(cosine, cos);
            }
            Statement::SinCosArray {
                angles,
                sines,
                cosines,
            } => {
                let both = angles.iter().map(|angle| libm::sincos(self.value(angle)));
                let (sin, cos) = both.unzip();
                self.arrays[sines.index()] = sin;
                self.arrays[cosines.index()] = cos;
            }
            Statement::Store { place, value, .. } => {
                let (place, value) = (self.place(place), self.value(value));
                assert!(self.stored.insert(place, value).is_none());
            }
            Statement::Call {
                helper,
                shared,
                sides,
                solved,
            } => {
                let shared = shared.map(|place| self.scratch(place)).unwrap_or_default();
                let given = [shared, self.scratch(*sides)];
                self.arrays[solved.index()] = self.called(&self.given.helpers[*helper], &given);
            }
            Statement::Heading(_) => {}
            Statement::StoreSinCos { .. } => unreachable!("of the function of sines alone"),
        }
    }

    /// All that was stored to an argument.
    fn scratch(&self, place: usize) -> Vec<f64> {
        let name = &self.signature.arguments[place].name;
        let own = (name.clone(), 0)..(format!("{name} "), 0);
        let both = [self.given.stored, &self.stored];
        let stored = both
            .into_iter()
            .flat_map(|numbers| numbers.range(own.clone()));
        let stored: BTreeMap<usize, f64> =
            stored.map(|((_, place), value)| (*place, *value)).collect();
        stored.into_values().collect()
    }

    /// What a helper computes, a row for each number, with that of each lane.
    fn called(&self, helper: &Helper, [shared, sides]: &[Vec<f64>; 2]) -> Vec<f64> {
        let mut rows = BTreeMap::new();
        let lanes = helper.lanes;
        for lane in 0..lanes {
            let shared_name = Role::Shared.name();
            let number = |(name, place): &(String, usize)| {
                if name == shared_name {
                    shared[*place]
                } else {
                    sides[lanes * place + lane]
                }
            };
            let given = Given {
                number: &number,
                ..*self.given
            };
            let run = Run::of(&given, &helper.signature, &helper.code, &[]);
            let stored = run.stored.into_iter();
            rows.extend(stored.map(|((_, place), value)| (lanes * place + lane, value)));
        }
        rows.into_values().collect()
    }

    fn value(&self, expression: &Expression) -> f64 {
        let two = |both: &[Expression; 2]| both.each_ref().map(|one| self.value(one));
        match expression {
            Expression::Number(number) => *number,
            Expression::Local(id) => self.locals[id.index()],
            Expression::Element(id, place) => self.arrays[id.index()][*place],
            Expression::Kept(stage, place) => self.kept[*stage][*place],
            Expression::Entry(entry) => (self.given.number)(&self.place(entry)),
            Expression::Negative(a) => -self.value(a),
            Expression::Absolute(a) => self.value(a).abs(),
            Expression::Sum(both) => two(both).iter().sum(),
            Expression::Difference(both) => two(both)[0] - two(both)[1],
            Expression::Product(both) => two(both).iter().product(),
            Expression::Quotient(both) => two(both)[0] / two(both)[1],
            Expression::Fused(all) => {
                let [a, b, c] = all.each_ref().map(|one| self.value(one));
                a.mul_add(b, c)
            }
        }
    }
}

/// What stands at a place of an argument: some number, another at each.
fn given((name, place): &(String, usize)) -> f64 {
    let name: u32 = name.bytes().map(u32::from).sum();
    libm::sin(f64::from(name) + 0.7 * f64::from(u32::try_from(*place).expect("few numbers")))
}

/// What the stages store, one after the other, each given what those before it keep.
fn staged(facts: &Facts, stages: &[Stage], helpers: &[Helper]) -> Numbers {
    let (mut stored, mut kept) = (Numbers::new(), Vec::new());
    for stage in stages {
        let given = Given {
            facts,
            number: &given,
            stored: &stored,
            helpers,
        };
        let run = Run::of(&given, &stage.signature, &stage.code, &kept);
        let returned = stage
            .kept
            .iter()
            .map(|kept| run.value(&kept.value))
            .collect();
        let own = run.stored;
        stored.extend(own);
        kept.push(returned);
    }
    stored
}

fn assert_same(module: &Module, function: &Function) {
    let with_scratch = Signature {
        arguments: function.places().cloned().collect(),
        ..function.signature.clone()
    };
    let Function {
        code,
        stages,
        helpers,
        ..
    } = function;
    assert_same_in_parts(&module.facts, &with_scratch, code, stages, helpers);
}

fn assert_same_in_parts(
    facts: &Facts,
    signature: &Signature,
    code: &Code,
    stages: &[Stage],
    helpers: &[Helper],
) {
    assert!(stages.len() > 2, "{} is not long", signature.name);
    let of_whole = Given {
        facts,
        number: &given,
        stored: &Numbers::new(),
        helpers,
    };
    let whole = Run::of(&of_whole, signature, code, &[]).stored;
    let staged = staged(facts, stages, helpers);
    assert_eq!(whole.len(), staged.len());
    // The operations are the same, so are the bits.
    for (place, value) in &whole {
        assert!(value.is_finite(), "{place:?}");
        assert_eq!(value.to_bits(), staged[place].to_bits(), "{place:?}");
    }
}

#[test]
fn stages_store_what_their_function_does() {
    let module = module_of(&hinges(1_600), &["relative_rotation"]);
    assert_same(
        &module,
        module
            .function("relative_rotation")
            .expect("it is asked for"),
    );
    let model = include_str!("../../../../models/eight_body.toml");
    let module = module_of(model, &["d(forward_dynamics)/d(q, u)"]);
    let name = "d_forward_dynamics_d_q_u";
    assert_same(&module, module.function(name).expect("it is asked for"));
}

/// The derivatives of a floating robot's accelerations.
fn in_lockstep(name: &str, urdf: &str, request: &str) -> Module {
    let reading = Reading {
        base: Some(Base::Free),
        ..Reading::default()
    };
    let source = Source::new(name, urdf);
    let description = description::read(&source, &reading, &no_includes);
    let model = description::toml::write(&description).expect("it can be written");
    module_of(&model, &[request])
}

#[test]
fn stages_fill_what_helpers_are_given() {
    let talos = include_str!("../../../../tests/robots/talos/talos.urdf");
    let module = in_lockstep("talos.urdf", talos, "d(forward_dynamics)/d(q, u, tau)");
    let function = module.function("d_forward_dynamics_d_q_u_tau");
    let function = function.expect("it is asked for");
    assert!(function.helpers.len() > 2, "columns are solved in lockstep");
    assert_same(&module, function);
}

#[test]
fn loops_of_a_helper_compute_what_one_does() {
    let talos = include_str!("../../../../tests/robots/talos/talos.urdf");
    let module = in_lockstep("talos.urdf", talos, "d(inverse_dynamics)/d(q, u, u_dot)");
    let function = module.function("d_inverse_dynamics_d_q_u_u_dot");
    let helpers = &function.expect("it is asked for").helpers;
    let long: Vec<&Helper> = helpers.iter().filter(|own| !own.loops.is_empty()).collect();
    assert!(!long.is_empty(), "legs and arms go through much");
    for helper in long {
        let Helper {
            signature,
            code,
            loops,
            ..
        } = helper;
        assert_same_in_parts(&module.facts, signature, code, loops, &[]);
    }
}

#[test]
fn calls_of_what_is_not_there_are_refused() {
    let solo12 = include_str!("../../../../tests/robots/solo12/solo12.urdf");
    let module = in_lockstep("solo12.urdf", solo12, "d(forward_dynamics)/d(q, u)");
    let right = module.function("d_forward_dynamics_d_q_u");
    let right = right.expect("it is asked for");
    assert_eq!(verify(&module.facts, right), Ok(()));
    let planted = |plant: &dyn Fn(&mut Vec<Statement>)| {
        let mut function = right.clone();
        plant(&mut function.code.statements);
        verify(&module.facts, &function).expect_err("a planted fault")
    };
    let each_call = |change: &dyn Fn(&mut usize, &mut usize)| {
        planted(&|statements| {
            for statement in statements {
                if let Statement::Call { helper, sides, .. } = statement {
                    change(helper, sides);
                }
            }
        })
    };
    let fault = each_call(&|helper, _| *helper += 1_000);
    assert!(matches!(fault, Fault::NoHelper(_)), "{fault}");
    let fault = each_call(&|_, sides| *sides = 1_000);
    assert_eq!(fault, Fault::NoArgument(1_000));
    // What the function is given, and not what it has filled.
    let fault = each_call(&|_, sides| *sides = 0);
    assert!(matches!(fault, Fault::Unfit(_)), "{fault}");
    let n_own = right.signature.arguments.len();
    let fault = planted(&|statements| {
        statements.retain(|statement| {
            let mut stored = statement.stored();
            !stored.any(|entry| entry.argument >= n_own)
        });
    });
    assert!(matches!(fault, Fault::NotStored(..)), "{fault}");
}

#[test]
fn short_functions_have_no_stages() {
    let model = include_str!("../../../../models/eight_body.toml");
    let module = module_of(model, &["mass_matrix_factors", "forward_dynamics"]);
    assert!(
        module
            .functions
            .iter()
            .all(|function| function.stages.is_empty())
    );
}

#[test]
fn what_no_earlier_stage_keeps_cannot_be_read() {
    let fault = planted(|stages| {
        let assigned = stages[1].code.statements.iter_mut();
        let value = assigned.filter_map(|statement| match statement {
            Statement::Assign { value, .. } => Some(value),
            _ => None,
        });
        for value in value.filter(|value| matches!(value, Expression::Kept(..))) {
            // The second stage's own.
            *value = Expression::Kept(1, 0);
        }
    });
    assert!(matches!(fault, Fault::NotKept(1, 0)), "{fault}");
}

/// A function in stages, after a fault is planted in these.
fn planted(plant: impl FnOnce(&mut [Stage])) -> Fault {
    let (facts, mut function) = long();
    plant(&mut function.stages);
    verify(&facts, &function).expect_err("a planted fault")
}

fn long() -> (Facts, Function) {
    let module = module_of(&hinges(1_600), &["relative_rotation"]);
    let function = module.function("relative_rotation");
    let function = function.expect("it is asked for").clone();
    (module.facts, function)
}

#[test]
fn store_that_no_stage_has_is_missed() {
    let (facts, function) = long();
    let statements = &function.stages[1].code.statements;
    let stores =
        (0..statements.len()).filter(|at| matches!(statements[*at], Statement::Store { .. }));
    let without = |at: usize| {
        let mut function = function.clone();
        function.stages[1].code.statements.remove(at);
        verify(&facts, &function)
    };
    // Without some of these a local is unread, which is told first.
    let missed = stores
        .take(10)
        .map(without)
        .filter(|found| matches!(found, Err(Fault::NotStored(name, _)) if name == "rotations"));
    assert_ne!(missed.count(), 0);
}

#[test]
fn place_that_two_stages_store_is_refused() {
    let fault = planted(|stages| {
        let (before, after) = stages.split_at_mut(1);
        // Arguments are counted by each stage.
        first_place(&mut after[0]).steps = first_place(&mut before[0]).steps.clone();
    });
    assert!(matches!(fault, Fault::StoredTwice(_)), "{fault}");
}

/// Where a stage stores first.
fn first_place(stage: &mut Stage) -> &mut Entry {
    let mut statements = stage.code.statements.iter_mut();
    let place = statements.find_map(|statement| match statement {
        Statement::Store { place, .. } => Some(place),
        _ => None,
    });
    place.expect("a store")
}
