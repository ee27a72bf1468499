//! Rust of any depth, read or refused.

use kane_codegen::rust::{MOST_OPEN, read};

#[test]
fn syntax_nested_too_deep_is_an_error() {
    let many = |text: &str| text.repeat(200_000);
    for deep in [
        format!("const A: f64 = {}1{};", many("("), many(")")),
        format!("const A: f64 = {}1;", many("-")),
        format!("const A: f64 = 1{};", many("+1")),
        format!("const A: f64 = {{1}}{};", many("+{1}")),
        format!("const A: {}u8 = 1;", many("&")),
        format!("const A: {}", many("B<u8, ")),
        format!("const A: {}", many("B<fn() -> u8, ")),
        format!("fn a() -> {}", many("B<{1}, ")),
        format!("const A: f64 = {}1;", many("|a, b| ")),
        format!("fn a() {{ {} }}", many("if a {} else ")),
    ] {
        let error = read(&deep, drop).unwrap_err().to_string();
        assert_eq!(error, "nested too deep", "{}", &deep[..40]);
    }
    // A first line that is no Rust hides nothing.
    let hidden = format!("#!'\nconst A: f64 = {}1;", many("-"));
    assert!(read(&hidden, drop).is_err());
}

#[test]
fn syntax_that_is_only_long_is_read() {
    let many = |text: &str| text.repeat(MOST_OPEN);
    for wide in [
        format!("const A: [f64; 10000] = [{}];", many("1.0, ")),
        many("#[doc = \"a\"] fn a<A: B<C>>(a: &A) -> A { a }\n"),
        many("struct A; impl A { fn a() {} }\n"),
        format!("fn a() {{ {} }}", many("let a = b < c;")),
    ] {
        let read = read(&wide, drop);
        assert!(read.is_ok(), "{}: {:?}", &wide[..40], read);
    }
}

#[test]
fn byte_order_mark_is_no_syntax() {
    assert!(read("\u{feff}fn a() {}", drop).is_ok());
}
