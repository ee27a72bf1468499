//! Long functions in stages: what is promised of machine code holds for them.

use std::fs;

use kane_codegen::{config::Functions, diagnostic::Source};

use super::{assert_holds, module, report, repository};

/// A function whose first stage keeps more than the stack has pages that a compiler touches one by one without a loop.
#[test]
fn stages_that_keep_much_hold() {
    let kept: Vec<String> = (0..5_000)
        .map(|place| format!("q[{}]", 3 * place % 7))
        .collect();
    let text = format!(
        "#[inline(never)]\nfn long_stage_1<R: kane::Real>(q: &[R; 7]) -> [R; 5000] {{ [{}] }}\n\
         #[inline(never)]\nfn long_stage_2<R: kane::Real>(o: &mut [R; 1], kept: &[R; 5000]) {{ o[0] = kept[3] + kept[4999]; }}\n\
         #[inline(never)]\npub fn long<R: kane::Real>(q: &[R; 7], o: &mut [R; 1]) {{\n\
         let kept = self::long_stage_1(q);\nself::long_stage_2(o, &kept);\n}}\n",
        kept.join(", ")
    );
    let report = report(&text);
    let names: Vec<&str> = report
        .functions
        .iter()
        .map(|one| one.name.as_str())
        .collect();
    assert_eq!(names, ["long_stage_1", "long_stage_2", "long"]);
    assert!(report.functions[2].stack >= 40_000);
    assert_holds(&report, "long");
}

#[test]
fn a_long_function_as_it_is_written_holds() {
    let path = repository("tests/reference/tree12.toml");
    let source = Source::new("tree12.toml", fs::read_to_string(path).unwrap());
    let functions = Functions::Named(vec!["forward_dynamics_pivots".to_owned()]);
    let report = report(&module(&source, None, functions));
    let stages = report
        .functions
        .iter()
        .filter(|one| one.name.contains("_stage_"));
    assert!(stages.count() > 2);
    assert_holds(&report, "tree12");
}
