//! Small crates with faults that are found, and without.

use crate::{krate::Crate, lengths, nan, no_tests, order, walk::Sources};

fn sources(files: &[(&str, &str)]) -> Sources {
    let files = files.iter();
    Sources(
        files
            .map(|(file, text)| ((*file).to_owned(), (*text).to_owned()))
            .collect(),
    )
}

/// The circles among files beside a root that lists `a`, `b` and `c`.
fn circles(files: &[(&str, &str)]) -> String {
    let root = [("lib.rs", "mod a; mod b; mod c;")];
    let files: Vec<(&str, &str)> = root.iter().chain(files).copied().collect();
    let imports = Crate::read(&sources(&files), "lib.rs").imports();
    order::circles(&imports).concat()
}

#[test]
fn circle_of_two_is_found() {
    let found = circles(&[
        ("a.rs", "use crate::b::{B, self as other}; pub struct A;"),
        ("b.rs", "use std::fmt; use crate::a::A; pub struct B;"),
        ("c.rs", "use crate::{a::A, b::B};"),
    ]);
    assert_eq!(
        found,
        "  a.rs imports b.rs: crate::b::B\n  b.rs imports a.rs: crate::a::A\n"
    );
}

#[test]
fn circle_through_three_is_told_in_its_order() {
    let found = circles(&[
        ("a.rs", "use crate::b; pub struct A(b::B);"),
        ("b.rs", "use super::c::C; pub struct B;"),
        ("c.rs", "use crate::a::A; pub struct C;"),
    ]);
    assert_eq!(
        found,
        "  a.rs imports b.rs: crate::b\n  b.rs imports c.rs: super::c::C\n  c.rs imports a.rs: crate::a::A\n"
    );
}

#[test]
fn paths_in_code_are_imports() {
    let b = (
        "b.rs",
        "use crate::a::A; pub const B: usize = 1; pub fn b() {}",
    );
    for code in [
        "fn f() -> usize { crate::b::B }",
        "fn f() { super::b::b() }",
        "fn f() { println!(\"{}\", crate::b::B) }",
        "fn f() { use crate::{b::B}; }",
        "impl A { fn f() -> [u8; crate::b::B] { [0] } }",
        "macro_rules! f { () => { $crate::b::b() } }",
        "#[derive(crate::b::B)] struct S;",
    ] {
        let a = format!("pub struct A; {code}");
        let found = circles(&[("a.rs", &a), b]);
        assert!(found.contains("a.rs imports b.rs"), "{code}");
    }
}

#[test]
fn what_another_crate_names_is_no_import() {
    let b = ("b.rs", "use crate::a::A; pub mod std {}");
    for code in [
        "use std::fmt; fn f() { std::mem::drop(1) }",
        "use ::b::B; fn f() { ::b::f() }",
        "fn f() { quote!(crate::b::B) }",
        "pub(in crate::b) fn f() {}",
        "/// Of [`crate::b::B`].\nfn f() {}",
    ] {
        let a = format!("pub struct A; {code}");
        assert_eq!(circles(&[("a.rs", &a), b]), "", "{code}");
    }
}

#[test]
fn module_and_its_parent_can_be_a_circle() {
    let child = (
        "a/child.rs",
        "use super::A; pub struct Child; pub fn f() {}",
    );
    let found = circles(&[
        ("a/mod.rs", "mod child; pub struct A; fn f() { child::f() }"),
        child,
    ]);
    assert_eq!(
        found,
        "  a/child.rs imports a/mod.rs: super::A\n  a/mod.rs imports a/child.rs: child::f\n"
    );
    assert_eq!(
        circles(&[
            ("a/mod.rs", "mod child; pub use child::Child; pub struct A;"),
            child
        ]),
        ""
    );
    let names_alone =
        "mod child; pub use child::f; fn g(a: A) -> A { a.f(); A { ..a.f } } pub struct A;";
    assert_eq!(circles(&[("a/mod.rs", names_alone), child]), "");
    let spoken_of = "mod child; pub use child::Child; pub struct A(Child);";
    assert!(circles(&[("a/mod.rs", spoken_of), child]).contains("a/mod.rs imports a/child.rs"));
}

#[test]
fn function_can_have_the_name_of_a_module() {
    let found = circles(&[
        ("a/mod.rs", "mod read; pub fn read() { read::f() }"),
        (
            "a/read.rs",
            "use crate::b::B; pub struct Item; pub fn f() {}",
        ),
        ("b.rs", "use crate::a::read::Item; pub struct B;"),
    ]);
    assert_eq!(
        found,
        "  a/read.rs imports b.rs: crate::b::B\n  b.rs imports a/read.rs: crate::a::read::Item\n"
    );
}

#[test]
fn what_is_passed_on_belongs_to_its_own_file() {
    let files = |one: &'static str, other: &'static str| {
        circles(&[
            (
                "a/mod.rs",
                "mod one; mod other; pub use one::One; pub use other::*;",
            ),
            ("a/one.rs", one),
            ("a/other.rs", other),
        ])
    };
    assert_eq!(
        files("pub struct One;", "use super::One; pub struct Other;"),
        ""
    );
    assert_eq!(
        files(
            "use super::Other; pub struct One;",
            "use crate::a::One; pub struct Other;"
        ),
        "  a/one.rs imports a/other.rs: super::Other\n  a/other.rs imports a/one.rs: crate::a::One\n"
    );
}

#[test]
fn modules_that_import_from_below_are_told() {
    let breaches = |list: &str| {
        let files = sources(&[
            ("lib.rs", list),
            ("a/mod.rs", "mod within;"),
            ("a/within.rs", "use crate::b::B;"),
            ("b.rs", "pub struct B;"),
        ]);
        order::breaches(&Crate::read(&files, "lib.rs"))
    };
    assert_eq!(breaches("mod b; mod a;"), [""; 0]);
    assert_eq!(
        breaches("mod a; mod b;"),
        ["a/within.rs imports crate::b::B, but lib.rs lists `b` below `a`"]
    );
}

#[test]
fn long_files_and_functions_are_told() {
    let body = "        let x = 1;\n".repeat(79);
    let text = format!(
        "impl A {{\n    pub(crate) const fn long(\n        a: A,\n    ) {{\n{body}    }}\n}}\nfn short() {{}}\n\
         trait T {{\n    fn none(\n        a: A,\n    );\n}}\n{body}"
    );
    assert_eq!(
        lengths::too_long(&sources(&[("a.rs", &text)])),
        ["a.rs:2: `long` has 83 lines; at most 80"]
    );
    let text = format!("pub(in crate::a) fn seen() {{\n{body}\n    1;\n}}\n");
    assert_eq!(
        lengths::too_long(&sources(&[("a.rs", &text)])),
        ["a.rs:1: `seen` has 83 lines; at most 80"]
    );
    let text = "//\n".repeat(501);
    assert_eq!(
        lengths::too_long(&sources(&[("b.rs", &text)])),
        ["b.rs has 501 lines; at most 500"]
    );
}

#[test]
fn test_among_sources_is_found() {
    for test in [
        "#[cfg(test)]\nmod tests;\n",
        "mod tests {\n    #[test]\n    fn holds() {}\n}\n",
        "#[cfg(all(test, unix))]\nuse a::A;\n",
        "#![cfg(test)]\nuse a::A;\n",
    ] {
        assert_eq!(
            no_tests::found(&sources(&[("a.rs", test)])).len(),
            1,
            "{test}"
        );
    }
    for text in [
        "/// #[test]\nfn f() {}\n",
        "fn f() { quote! { #[test] fn g() {} } }",
        "#[cfg(feature = \"std\")] fn f() {}",
    ] {
        let found = no_tests::found(&sources(&[("a.rs", text)]));
        assert!(found.is_empty(), "{text}");
    }
}

#[test]
fn test_that_passes_over_nan_is_found() {
    let found = |text| nan::passed_over(&sources(&[("a/tests/b.rs", text)]));
    assert_eq!(
        found("fn f() { x.fold(0.0, f64::max); }"),
        ["a/tests/b.rs: `max` of floats"]
    );
    assert_eq!(
        found("fn f() { x.min(-1.0) }"),
        ["a/tests/b.rs: `min` of floats"]
    );
    assert_eq!(
        found("fn f() { x.max(1e-300) }"),
        ["a/tests/b.rs: `max` of floats"]
    );
    assert_eq!(
        found("fn f() { x.reduce(f64::max) }"),
        ["a/tests/b.rs: `max` of floats"]
    );
    for text in [
        "fn f() { x.fold(0.0, |a, b| a.max(b)) }",
        "fn f() { x.fold(-f64::INFINITY, |a, b| (a).max(b.abs())) }",
    ] {
        assert_eq!(found(text), ["a/tests/b.rs: `max` of floats"], "{text}");
    }
    for text in [
        "fn f() { x.fold(0, |a, b| a.max(b)) }",
        "fn f() { x.fold(0.0, |a, b| a + b).to_bits().max(y) }",
        "// f64::max\nfn f() {}",
        "const MOST: f64 = f64::MAX;",
        "fn f() { x.min(1) }",
        "fn f() { x.max(y.z) }",
    ] {
        assert!(found(text).is_empty(), "{text}");
    }
}
