//! Reading `kane.toml`.

use kane_codegen::budget::{Budget, OperationKind};
use kane_codegen::companions;
use kane_codegen::config::{self, Formulation, Functions};
use kane_codegen::description::{Base, Chart, Reading};
use kane_codegen::diagnostic::Source;
use kane_codegen::tree::Changes;

#[test]
fn what_is_absent_has_its_default() {
    let text = "[[system]]\nmodel = \"models/arm.toml\"\noutput = \"generated/arm.rs\"\n";
    let config = config::parse(&Source::new("kane.toml", text)).unwrap();
    let [arm] = config.systems.as_slice() else {
        panic!("one system")
    };
    assert_eq!(
        (arm.model.value.as_str(), arm.output.value.as_str()),
        ("models/arm.toml", "generated/arm.rs")
    );
    assert_eq!(
        (&arm.options.functions, arm.options.formulation),
        (&Functions::default(), Formulation::Cheapest)
    );
}

#[test]
fn systems_and_functions_keep_their_order() {
    let text = r#"
        [[system]]
        output = "b.rs"
        model = "b.toml"
        functions = ["rotation", "bias"]
        formulation = "notes"
        fma = true
        [[system]]
        model = "a.toml"
        output = "../a.rs"
        functions = ["all"]
        formulation = "recursive"
    "#;
    let config = config::parse(&Source::new("kane.toml", text)).unwrap();
    let [b, a] = config.systems.as_slice() else {
        panic!("two systems")
    };
    assert_eq!(
        b.options.functions,
        Functions::Named(vec!["rotation".to_owned(), "bias".to_owned()])
    );
    assert_eq!(
        (b.options.formulation, a.options.formulation),
        (Formulation::Notes, Formulation::Recursive)
    );
    assert_eq!((b.options.fma, a.options.fma), (true, false));
    assert_eq!(
        (a.model.value.as_str(), &a.options.functions),
        ("a.toml", &Functions::All(Vec::new()))
    );
}

#[test]
fn file_that_is_not_toml_has_that_fault_alone() {
    let faults = config::parse(&Source::new("kane.toml", "[[system]\nmodel = 1")).unwrap_err();
    insta::assert_snapshot!(faults, @r#"
    error: not valid TOML: unclosed array table, expected `]`
     --> kane.toml:1:10
      |
    1 | [[system]
      |          ^ here
    "#);
}

#[test]
fn reading_and_changes_are_read_in_an_order_of_their_own() {
    let text = r#"
        [[system]]
        model = "panda.urdf"
        output = "panda.rs"
        base = "free"
        chart = "angles"
        leave_out = ["loop", "fluid"]
        snap = 1e-5
        lock = { wrist = 1, "elbow joint" = -0.5 }
        remove = ["finger_2", "finger_1"]
        prescribed = ["base", "arm base"]

        [[system]]
        model = "arm.toml"
        output = "arm.rs"
    "#;
    let config = config::parse(&Source::new("kane.toml", text)).unwrap();
    let [panda, arm] = config.systems.as_slice() else {
        panic!("two systems")
    };
    assert_eq!(
        panda.options.reading,
        Reading {
            base: Some(Base::Free),
            chart: Some(Chart::Angles),
            leave_out: ["fluid", "loop"].map(str::to_owned).into(),
        }
    );
    assert_eq!(
        panda.options.changes,
        Changes {
            snap: 1e-5,
            lock: vec![("elbow joint".to_owned(), -0.5), ("wrist".to_owned(), 1.0)],
            remove: vec!["finger_2".to_owned(), "finger_1".to_owned()],
            remove_massless: false,
        }
    );
    assert_eq!(panda.options.prescribed, ["base", "arm base"]);
    assert_eq!(arm.options.prescribed, [""; 0]);
    assert_eq!(
        (&arm.options.reading, &arm.options.changes),
        (&Reading::default(), &Changes::default())
    );
}

#[test]
fn budgets_limit_all_operations_or_some_kind() {
    let text = r#"
        [[system]]
        model = "arm.toml"
        output = "arm.rs"
        functions = ["bias", "mass_matrix+bias"]
        manifest = true
        [system.budget]
        bias = 60
        "mass_matrix+bias" = { total = 90, mul = 0 }
    "#;
    let config = config::parse(&Source::new("kane.toml", text)).unwrap();
    let limit = |function: &str, kind, limit| Budget {
        function: function.to_owned(),
        kind,
        limit,
    };
    assert_eq!(
        config.systems[0].budget,
        [
            limit("bias", OperationKind::Total, 60),
            limit("mass_matrix_and_bias", OperationKind::Total, 90),
            limit("mass_matrix_and_bias", OperationKind::Mul, 0),
        ]
    );
    assert_eq!(
        config.systems[0].options.companions,
        [companions::CompanionKind::Manifest].into()
    );
}
