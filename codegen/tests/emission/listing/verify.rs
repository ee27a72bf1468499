//! Faults that are planted in a module's functions.

use std::sync::OnceLock;

use kane_codegen::config::Functions;
use kane_codegen::listing::{
    ArrayId, Entry, Expression, Fault, Function, LocalId, Member, Module, Statement, Step, verify,
    verify_facts,
};
use kane_codegen::origin::Origin;
use kane_codegen::{compile, options::Options};
use kane_test_support::models;

/// Two bodies with five angles, of which one has a mass that is set at run time.
const MODEL: &str = "name = \"two\"\n\
    gravity = [0.0, 0.0, -9.81]\n\
    lower_bodies = [0, 1]\n\
    [[body]]\n\
    name = \"one\"\n\
    mass = { runtime = 2.0 }\n\
    mass_center = [0.1, 0.0, -0.5]\n\
    inertia = { xx = 0.2, yy = 0.3, zz = 0.3, xy = 0.0, xz = 0.01, yz = 0.0 }\n\
    attachment = [0.0, 0.0, 0.0]\n\
    joint = [\"theta1\", \"theta2\", \"theta3\"]\n\
    [[body]]\n\
    name = \"two\"\n\
    mass = 1.0\n\
    mass_center = [0.0, 0.2, -0.5]\n\
    inertia = { xx = 0.2, yy = 0.3, zz = 0.3, xy = 0.0, xz = 0.01, yz = 0.0 }\n\
    attachment = [0.0, 0.4, 0.0]\n\
    joint = [\"theta1\", \"s2\"]\n";

/// The module, compiled once.
fn module() -> Module {
    static MODULE: OnceLock<Module> = OnceLock::new();
    let functions = ["mass_matrix", "generalized_forces", "bias(sin_cos)"];
    let module = MODULE.get_or_init(|| module_of(MODEL, &functions));
    module.clone()
}

pub(super) fn module_of(model: &str, names: &[&str]) -> Module {
    let tree = models::build(model).expect("a sound description").tree;
    let options = Options {
        functions: Functions::Named(names.iter().map(ToString::to_string).collect()),
        ..Options::default()
    };
    let compiled = compile::compile(&tree, &options).expect("functions of the catalogue");
    Module::new(&tree, Origin::new(&tree, "two.toml", &options), &compiled)
}

/// What is wrong with a function after a fault is planted in it.
fn planted(name: &str, plant: impl FnOnce(&mut Function)) -> Fault {
    let module = module();
    let mut function = module.function(name).expect("a function").clone();
    plant(&mut function);
    verify(&module.facts, &function).expect_err("a planted fault")
}

/// The place of the first statement that is so.
fn first(function: &Function, is: impl Fn(&Statement) -> bool) -> usize {
    let mut statements = function.code.statements.iter();
    statements.position(is).expect("such a statement")
}

fn is_assignment(statement: &Statement) -> bool {
    matches!(statement, Statement::Assign { .. })
}

fn is_store(statement: &Statement) -> bool {
    matches!(statement, Statement::Store { .. })
}

fn is_array(statement: &Statement) -> bool {
    matches!(statement, Statement::SinCosArray { .. })
}

#[test]
fn every_function_of_a_module_is_right() {
    let module = module();
    for function in module.all() {
        let name = &function.signature.name;
        assert_eq!(verify(&module.facts, function), Ok(()), "{name}");
    }
    let named: Vec<&str> = module
        .all()
        .map(|one| one.signature.name.as_str())
        .collect();
    assert_eq!(named[..3], ["nominal", "prepare", "sin_cos"]);
}

#[test]
fn name_that_is_no_identifier_is_refused() {
    for name in ["", "1", "_one", "one-two", "One", "straße"] {
        let fault = planted("mass_matrix", |function| {
            name.clone_into(&mut function.code.locals[0].name);
        });
        assert_eq!(fault, Fault::NoIdentifier(name.to_owned()));
    }
}

#[test]
fn name_of_two_things_is_refused() {
    let fault = planted("mass_matrix", |function| {
        function.code.locals[1].name = function.code.locals[0].name.clone();
    });
    assert!(matches!(fault, Fault::SameName(_)), "{fault}");
    for name in ["q", "sines"] {
        let fault = planted("mass_matrix", |function| {
            name.clone_into(&mut function.code.locals[0].name);
        });
        assert_eq!(fault, Fault::SameName(name.to_owned()));
    }
    let mut facts = module().facts;
    assert_eq!(verify_facts(&facts), Ok(()));
    "one".clone_into(&mut facts.bodies[1].identifier);
    assert_eq!(verify_facts(&facts), Err(Fault::SameName("one".to_owned())));
}

#[test]
fn name_of_two_constants_is_refused() {
    let facts = module_of(MODEL, &["partial_velocity"]).facts;
    assert_eq!(verify_facts(&facts), Ok(()));
    for name in ["NB", "JOINTS", "FINGERPRINT"] {
        let mut facts = facts.clone();
        name.clone_into(&mut facts.patterns[0].blocks);
        let fault = Fault::SameName(name.to_owned());
        assert_eq!(verify_facts(&facts), Err(fault));
    }
}

#[test]
fn local_that_is_read_before_it_is_assigned_is_refused() {
    let fault = planted("mass_matrix", |function| {
        let place = first(function, is_assignment);
        function.code.statements.remove(place);
    });
    assert!(matches!(fault, Fault::Unassigned(_)), "{fault}");
    let fault = planted("mass_matrix", |function| {
        let place = first(function, is_array);
        function.code.statements.remove(place);
    });
    assert!(matches!(fault, Fault::Unassigned(_)), "{fault}");
}

#[test]
fn local_that_is_assigned_twice_is_refused() {
    for is in [is_assignment, is_array] {
        let fault = planted("mass_matrix", |function| {
            let place = first(function, is);
            let twice = function.code.statements[place].clone();
            function.code.statements.insert(place, twice);
        });
        assert!(matches!(fault, Fault::AssignedTwice(_)), "{fault}");
    }
}

#[test]
fn local_that_is_never_read_is_refused() {
    let fault = planted("mass_matrix", |function| {
        let mut local = function.code.locals[0].clone();
        local.name.push_str("_unread");
        function.code.locals.push(local);
        function.code.statements.push(Statement::Assign {
            local: LocalId::new(function.code.locals.len() - 1),
            value: Expression::Number(1.0),
        });
    });
    assert!(matches!(fault, Fault::Unread(_)), "{fault}");
    let fault = planted("mass_matrix", |function| {
        for array in 0..2 {
            let mut more = function.code.arrays[array].clone();
            more.name.push_str("_unread");
            function.code.arrays.push(more);
        }
        let n_arrays = function.code.arrays.len();
        let place = first(function, is_array);
        let mut again = function.code.statements[place].clone();
        if let Statement::SinCosArray { sines, cosines, .. } = &mut again {
            [*sines, *cosines] = [n_arrays - 2, n_arrays - 1].map(ArrayId::new);
        }
        function.code.statements.push(again);
    });
    assert_eq!(fault, Fault::Unread("sines_unread".to_owned()));
}

#[test]
fn what_no_argument_holds_cannot_be_read() {
    let (index, member) = (Step::Index, Step::Member);
    for (argument, steps) in [
        (9, vec![]),
        (1, vec![]),
        (1, vec![index(5)]),
        (1, vec![index(0), index(0)]),
        (1, vec![member(Member::Force)]),
        (0, vec![member(Member::Prepared(1000))]),
        (0, vec![member(Member::Parameter(0))]),
        (2, vec![index(0), member(Member::Force), index(3)]),
        (2, vec![index(2), member(Member::Force), index(0)]),
        // An output.
        (3, vec![index(0)]),
    ] {
        let entry = Entry { argument, steps };
        let fault = planted("generalized_forces", |function| {
            let place = first(function, is_assignment);
            if let Statement::Assign { value, .. } = &mut function.code.statements[place] {
                *value = Expression::Entry(entry.clone());
            }
        });
        assert_eq!(fault, Fault::Unreadable(entry));
    }
}

#[test]
fn array_has_the_elements_that_are_read_and_as_many_as_angles() {
    let fault = planted("mass_matrix", |function| {
        let place = first(function, |statement| {
            matches!(statement.values(), [Expression::Element(..)])
        });
        if let Statement::Assign { value, .. } = &mut function.code.statements[place] {
            *value = Expression::Element(ArrayId::new(0), 64);
        }
    });
    assert_eq!(fault, Fault::NoElement("sines".to_owned(), 64));
    let fault = planted("mass_matrix", |function| {
        function.code.arrays[1].length += 1;
    });
    assert!(matches!(fault, Fault::Places(..)), "{fault}");
}

#[test]
fn every_place_of_an_output_is_stored_once() {
    let fault = planted("mass_matrix", |function| {
        let place = first(function, is_store);
        let twice = function.code.statements[place].clone();
        function.code.statements.push(twice);
    });
    assert!(matches!(fault, Fault::StoredTwice(_)), "{fault}");
    let fault = planted("mass_matrix", |function| {
        let place = first(function, |statement| {
            matches!(
                statement,
                Statement::Store {
                    value: Expression::Number(_),
                    ..
                }
            )
        });
        function.code.statements.remove(place);
    });
    assert!(matches!(fault, Fault::NotStored(..)), "{fault}");
}

#[test]
fn nothing_is_stored_elsewhere() {
    for (argument, steps) in [
        (9, vec![]),
        (1, vec![Step::Index(0)]),
        (2, vec![Step::Index(0)]),
        (2, vec![Step::Index(0), Step::Index(5)]),
    ] {
        let entry = Entry { argument, steps };
        let fault = planted("mass_matrix", |function| {
            let at = first(function, is_store);
            if let Statement::Store { place, .. } = &mut function.code.statements[at] {
                *place = entry.clone();
            }
        });
        assert_eq!(fault, Fault::Unwritable(entry));
    }
}

#[test]
fn number_that_no_literal_is_is_refused() {
    let fault = planted("mass_matrix", |function| {
        let place = first(function, is_store);
        if let Statement::Store { value, .. } = &mut function.code.statements[place] {
            *value = Expression::Number(f64::INFINITY);
        }
    });
    assert_eq!(fault, Fault::NotFinite);
}

#[test]
fn array_gives_way_to_a_coordinate_of_its_name() {
    let n_bodies = 70;
    let mut model = format!("name = \"many\"\nlower_bodies = {:?}\n", vec![0; n_bodies]);
    for body in 0..n_bodies {
        let name = if body == 3 {
            "joint_name = \"sines_2\"\n"
        } else {
            ""
        };
        let body = format!(
            "[[body]]\nname = \"b{body}\"\nmass = 1.0\nmass_center = [0.0, 0.0, -0.5]\n\
             inertia = {{ xx = 1.0, yy = 1.0, zz = 1.0, xy = 0.0, xz = 0.0, yz = 0.0 }}\n\
             attachment = [0.0, 0.0, 0.0]\njoint = [\"theta1\"]\n{name}"
        );
        model += &body;
    }
    let module = module_of(&model, &["relative_rotation"]);
    let function = module.function("relative_rotation").expect("a function");
    let arrays = function.code.arrays.iter();
    let names: Vec<&str> = arrays.map(|array| array.name.as_str()).collect();
    assert_eq!(names, ["sines", "cosines", "sines_2_", "cosines_2"]);
}
