//! Faults that stand in several files.

use kane_codegen::diagnostic::{Diagnostic, Diagnostics, Source, Span};

/// The place of a word in the files of a source.
fn place(source: &Source, word: &str) -> Span {
    let found = source.files().find_map(|file| {
        let at = file.text().find(word)?;
        Some(file.base() + at)
    });
    let start = found.expect("the word is in one of the files");
    Span::from(start..start + word.len())
}

#[test]
fn each_label_is_shown_in_its_own_file() {
    let mut source = Source::new("models/arm.xml", "one\ntwo");
    source.append("models/hand.xml", "three\nfour");
    source.append("models/foot.xml", "\u{feff}five\nsix");
    let fault = Diagnostic::error("two things do not agree")
        .at(place(&source, "four"), "this one")
        .at(place(&source, "two"), "and that one")
        .at(place(&source, "three"), "see also")
        .help("change one");
    insta::assert_snapshot!(fault.render(&source), @r"
    error: two things do not agree
     --> models/hand.xml:2:1
      |
    1 | three
      | ----- see also
    2 | four
      | ^^^^ this one
      |
     ::: models/arm.xml:2:1
      |
    2 | two
      | --- and that one
      |
      = help: change one
    ");
    let fault = Diagnostic::warning("not well").at(place(&source, "five"), "at the start");
    insta::assert_snapshot!(fault.render(&source), @r"
    warning: not well
     --> models/foot.xml:1:1
      |
    1 | five
      | ^^^^ at the start
    ");
}

#[test]
fn place_after_a_files_end_is_not_in_the_next_file() {
    let mut source = Source::new("arm.xml", "one");
    let base = source.append("hand.xml", "two");
    let end = Diagnostic::error("something is missing").at(Span::from(3..3), "here");
    insta::assert_snapshot!(end.render(&source), @r"
    error: something is missing
     --> arm.xml:1:4
      |
    1 | one
      |    ^ here
    ");
    let start = Diagnostic::error("something is wrong").at(Span::from(base..base), "here");
    insta::assert_snapshot!(start.render(&source), @r"
    error: something is wrong
     --> hand.xml:1:1
      |
    1 | two
      | ^ here
    ");
}

#[test]
fn end_of_a_file_is_that_of_its_last_line_however_long_it_is() {
    for length in [3, 10_000] {
        let text = format!("one\n{}\n", "x".repeat(length));
        let end = Span::from(text.len()..text.len());
        let fault = Diagnostic::error("something is missing").at(end, "here");
        let rendered = fault.render(&Source::new("arm.toml", text));
        let place = format!("--> arm.toml:2:{}", length + 2);
        assert!(
            rendered.lines().any(|line| line.trim() == place),
            "{rendered}"
        );
        assert!(rendered.len() < 1_000);
    }
}

#[test]
fn faults_of_included_files_follow_those_of_the_file_itself() {
    let mut source = Source::new("arm.xml", "one two");
    source.append("hand.xml", "three");
    let faults =
        ["three", "two", "one"].map(|word| Diagnostic::error(word).at(place(&source, word), ""));
    let faults = Diagnostics::new(source, faults.to_vec());
    let order: Vec<&str> = faults
        .list()
        .iter()
        .map(|fault| fault.message.as_str())
        .collect();
    assert_eq!(order, ["one", "two", "three"]);
}

#[test]
fn many_warnings_hide_no_error() {
    let source = Source::new("model.toml", "word");
    let warning = Diagnostic::warning("this is odd").at(place(&source, "word"), "here");
    let mut list = vec![warning; 150];
    list.push(Diagnostic::error("this is wrong").at(place(&source, "word"), "here"));
    let told = Diagnostics::new(source, list).to_string();
    let (before, error) = told.split_once("\n\n").unwrap();
    assert_eq!(before, "warning: model.toml:1:1: this is odd (150 times)");
    assert!(error.starts_with("error: this is wrong"), "{told}");
}

#[test]
fn of_many_errors_the_first_hundred_are_shown() {
    let source = Source::new("model.toml", "word");
    let error = Diagnostic::error("this is wrong").at(place(&source, "word"), "here");
    let told = Diagnostics::new(source, vec![error; 150]).to_string();
    assert_eq!(told.matches("this is wrong").count(), 100);
    assert!(told.ends_with("50 more faults are not shown"), "{told}");
}
