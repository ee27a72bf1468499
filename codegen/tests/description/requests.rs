//! The grammar of requests.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::ops::Range;

use kane_codegen::functions::parse::syntax::{Kind, Sum, Unexpected, read, written};
use kane_codegen::functions::{Parsed, TRAITS, split};

fn expected(text: &str) -> (&'static str, Range<usize>) {
    let Unexpected { expected, place } = read(text).unwrap_err();
    (expected, place)
}

#[test]
fn parts_stand_where_they_are_written() {
    let Sum {
        parts, at_sin_cos, ..
    } = read("bias + velocity(\"left foot\", local) (sin_cos)").unwrap();
    assert!(at_sin_cos);
    let places: Vec<_> = parts.iter().map(|part| part.place.clone()).collect();
    assert_eq!(places, [0..4, 7..35]);
    let Kind::Named { name, of } = &parts[1].kind else {
        panic!("{parts:?}");
    };
    assert_eq!(name.text, "velocity");
    let of: Vec<_> = of
        .iter()
        .map(|word| (word.text.as_str(), word.place.clone()))
        .collect();
    assert_eq!(of, [("left foot", 16..27), ("local", 29..34)]);
}

#[test]
fn derivatives_and_products_hold_parts() {
    let sum = read("d(pose(tool0))/d(q, u)+vjp(bias; q)").unwrap();
    let Kind::Derivative { of, by, .. } = &sum.parts[0].kind else {
        panic!("{sum:?}");
    };
    assert!(matches!(&of.kind, Kind::Named { name, .. } if name.text == "pose"));
    assert_eq!(by.len(), 2);
    assert!(matches!(&sum.parts[1].kind, Kind::Product { along, .. } if along.len() == 1));
}

#[test]
fn a_frame_called_as_a_word_of_requests_is_quoted() {
    let sum = read("pose(\"sin_cos\")").unwrap();
    assert!(!sum.at_sin_cos);
    assert_eq!(written("sin_cos"), "\"sin_cos\"");
    assert_eq!(written("local"), "\"local\"");
    let text = |text: &str| Parsed::read(text).unwrap().text();
    let of_frame = "jacobian(tool, \"local\")";
    assert_eq!(text(of_frame), of_frame);
    assert_eq!(text("jacobian(tool, local)"), "jacobian(tool, local)");
    assert_eq!(written("a/b c"), "a/b c");
}

#[test]
fn any_name_can_be_asked_for() {
    let names = [
        "a\"b", "\"", "\"\"", "a\"", "\"a", "a, b", "a)", "\\", "a\\\"", " a ", "é\"+;",
    ];
    for name in names {
        let request = format!("pose({}, local)", written(name));
        let sum = read(&request).unwrap();
        let Kind::Named { of, .. } = &sum.parts[0].kind else {
            panic!("{sum:?}");
        };
        assert_eq!([&of[0].text, &of[1].text], [name, "local"]);
        let list = format!("bias,{request},q_dot");
        assert_eq!(
            split(&list).collect::<Vec<_>>(),
            ["bias", &request, "q_dot"]
        );
    }
}

#[test]
fn what_is_not_in_the_grammar_is_pointed_at() {
    assert_eq!(expected("pose(tool0"), ("expected `,` or `)`", 10..10));
    let words = "expected `,` or `)`; with `;` there are `jvp(F; X)`, `vjp(F; X)`, the gradient, and `hessian(F; X)`; a name that contains `;` stands in quotes";
    assert_eq!(expected("gradient(bias; q)"), (words, 13..14));
    assert_eq!(expected("bias)"), ("expected `+` or the end", 4..5));
    assert_eq!(expected("pose(\"tool0)"), ("expected `\"`", 12..12));
    assert_eq!(expected("pose(\"tool0\"\")"), ("expected `\"`", 14..14));
    let by = "expected `/d(VARIABLES)`, as in `d(forward_dynamics)/d(q, u, tau)`";
    assert_eq!(expected("d(bias)/q"), (by, 8..9));
    let by = "expected `; VARIABLES`, as in `jvp(inverse_dynamics; q, u)`";
    assert_eq!(expected("jvp(bias)"), (by, 8..9));
    let by = "expected `; VARIABLES`, as in `hessian(inverse_dynamics; q, u)`";
    assert_eq!(expected("hessian(bias)"), (by, 12..13));
    assert_eq!(expected("packed(d(bias)/d(q)"), ("expected `)`", 19..19));
    let parts = "differentiate each part by itself, and join what comes of them with `+`";
    assert_eq!(expected("d(bias+forcing)/d(q)"), (parts, 6..7));
    assert_eq!(expected("vjp(bias + forcing; q)"), (parts, 9..10));
    let second = "expected `+` or the end; second derivatives are `hessian(PART; VARIABLES)`";
    assert_eq!(expected("d(bias)/d(q)/d(u)"), (second, 12..13));
}

#[test]
fn a_request_of_too_many_words_is_refused() {
    let words = vec!["bias"; 1_001].join("+");
    assert_eq!(
        expected(&words),
        ("expected a thousand words at most", 5_000..5_001)
    );
    assert!(read(&words[5..]).is_ok());
}

fn faults(text: &str) -> Vec<String> {
    let faults = Parsed::read(text).expect_err("it has a fault");
    faults.iter().map(ToString::to_string).collect()
}

#[test]
fn packed_is_of_derivatives_and_what_is_a_function_of_its_own_is_named() {
    let faults = |text| faults(text).join("\n");
    let derivative = "expected `d(PART)/d(VARIABLES)`";
    for text in ["packed(bias)", "packed(d)", "packed(jvp(bias; q))"] {
        assert!(faults(text).ends_with(derivative), "{text}");
    }
    assert_eq!(
        faults("packed(hessian(bias; q))"),
        "`packed(hessian(bias; q))` is no request: a `hessian` is packed without it"
    );
    assert_eq!(
        faults("packed(jacobian(tool0, local))"),
        "`packed(jacobian(tool0, local))` is the function `jacobian_packed(tool0, local)`"
    );
}

#[test]
fn what_is_missing_or_misplaced_is_said() {
    for (text, expected) in [
        ("bias+", "expected the name of a function"),
        ("jacobian()", "expected the name of a frame"),
        (
            "bias(sin_cos)+mass_matrix",
            "`(sin_cos)` stands last, behind the whole request",
        ),
        ("d(bias)/d()", "expected a variable"),
        ("hessian(bias; q,)", "expected a variable"),
        (
            "mass_matrix bias",
            "`+` joins functions in one; where several may stand, commas are between them",
        ),
        (
            "sin_cos",
            "a module has it beside functions such as `bias(sin_cos)`",
        ),
        (
            "\"d(bias)/d(q)\"",
            "quotes stand around one name, not around a request",
        ),
    ] {
        assert!(faults(text).concat().ends_with(expected), "{text}");
    }
}

#[test]
fn name_with_one_ending_again_and_again_is_no_function() {
    let endless = "_at_sin_cos".repeat(100_000);
    assert!(faults(&endless).concat().contains("is no function; "));
    assert_eq!(
        faults("bias_at_sin_cos"),
        ["`bias_at_sin_cos` is no function; did you mean `bias(sin_cos)`?"]
    );
}

#[test]
fn every_part_with_a_fault_is_told() {
    assert_eq!(
        faults("masss_matrix + bias + jacobian"),
        [
            "`masss_matrix` is no function; did you mean `mass_matrix`?",
            "`jacobian` is of a frame; expected `jacobian(FRAME)`"
        ]
    );
}

#[test]
fn traits_of_derivatives_say_what_was_not_asked_for() {
    let text = include_str!("../../../src/functions/derivatives.rs");
    for (request, name) in TRAITS {
        let before = text.split(&format!("\n    {name} of ")).next();
        let message = before.and_then(|before| before.lines().next_back());
        let is_named = |text: &str| text.contains(&format!("without `{request}`;"));
        assert!(message.is_some_and(is_named), "{name}");
    }
}

#[test]
fn every_text_of_the_table_is_a_request_as_it_is_written_back() {
    for (text, name) in TRAITS {
        let parsed = Parsed::read(text).expect(name);
        assert_eq!(parsed.text(), text);
    }
}

#[test]
fn a_function_may_be_given_a_name() {
    for (text, written) in [
        ("step=mass_matrix + bias", "step = mass_matrix+bias"),
        (" a_2 = bias (sin_cos)", "a_2 = bias(sin_cos)"),
        ("pose(a=b)", "pose(a=b)"),
    ] {
        let parsed = Parsed::read(text).unwrap();
        assert_eq!(parsed.text(), written);
        assert_eq!(Parsed::read(written).unwrap().place(), parsed.place());
    }
    let named = |text: &str| Parsed::read(text).unwrap().of_any_model().unwrap();
    assert_eq!(named("step = bias(sin_cos)").name(), "step");
    assert_eq!(named("step = bias(sin_cos)").sum(), "bias(sin_cos)");
}

#[test]
fn what_cannot_be_a_name_is_told_with_why_beside_other_faults() {
    for (name, why) in [
        ("", "expected a name before `=`"),
        (
            "Step",
            "expected words of lower-case letters and digits with one `_` between them, a letter first",
        ),
        (
            "2a",
            "expected words of lower-case letters and digits with one `_` between them, a letter first",
        ),
        (
            "a__b",
            "expected words of lower-case letters and digits with one `_` between them, a letter first",
        ),
        ("fn", "it is a keyword of Rust"),
        ("bias", "it is a function of the catalogue"),
        ("prepare", "a module has something of that name"),
        ("parameters", "a module has something of that name"),
        ("rk4_step", "the C interface has a function of that name"),
        (
            "loaded_euler_adjoint",
            "the C interface has a function of that name",
        ),
        (
            "a_stage_b",
            "`_stage_` marks what a long function calls, such as `bias_stage_1`",
        ),
        (
            "a_lockstep_1",
            "`_lockstep_` marks what a long function calls, such as `bias_lockstep_1`",
        ),
        (&"a".repeat(65), "expected 64 characters at most"),
    ] {
        let fault = format!("`{name}` cannot be the name of a function: {why}");
        assert_eq!(faults(&format!("{name} = mass_matrix")), [fault]);
    }
    assert_eq!(faults("Step = foo+bar").len(), 3);
    assert_eq!(faults("Step = bias+bias").len(), 2);
    assert!(faults("a = b = bias")[0].starts_with("`b = bias` is no function"));
}
