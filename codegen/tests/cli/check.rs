//! `kane check`.

use std::{fs, process::Stdio};

use super::project::{Project, Ran, model, system};

#[test]
fn file_that_is_up_to_date_is_the_same() {
    let project = Project::generated();
    let ran = project.kane(&["check"]);
    assert_eq!((ran.code, ran.out.as_str(), ran.err.as_str()), (0, "", ""));
    let ran = project.kane(&["check", "--verbose"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    assert_eq!(ran.err, "generated/arm.rs is up to date\n");
}

#[test]
fn changed_lines_are_told_by_number_and_place_and_shown_where_asked_for() {
    let project = Project::generated();
    project.replace("models/arm.toml", "mass = 1.5", "mass = 1.25");
    let ran = project.kane(&["check"]);
    insta::assert_snapshot!(ran.out);
    let shown = project.kane(&["check", "--lines"]);
    assert!(shown.out.contains("\n@@ -"), "{}", shown.out);
    assert!(!shown.out.contains("add --lines"), "{}", shown.out);
    let removed = |line: &&str| line.starts_with('-') && !line.starts_with("---");
    let removed = shown.out.lines().filter(removed).count();
    let told = format!("generated/arm.rs differs: {removed} lines removed, ");
    assert!(ran.out.starts_with(&told), "{told}\n{}", ran.out);
}

#[test]
fn lines_that_are_shown_turn_what_is_there_into_what_is_generated() {
    let project = Project::generated().committed();
    let generated = project.read("generated/arm.rs");
    let half = &generated[..generated.len() / 2];
    let doubled = generated.replace("];\n", "];\n];\n");
    let lines: Vec<&str> = generated.lines().collect();
    let edited = (0..12).map(|line| generated.replacen(lines[line], "edited", 1));
    let apart = edited.clone().map(|text| text.replacen(lines[12], "", 1));
    let found = ["", "x", generated.trim_end(), half, &doubled].map(str::to_owned);
    for found in found.into_iter().chain(edited).chain(apart) {
        project.write("generated/arm.rs", &found);
        let ran = project.kane(&["check", "--lines"]);
        project.write("lines.diff", &ran.out);
        let mut apply = project.git_command(&["apply", "--verbose", "-p0", "lines.diff"]);
        let applied: Ran = apply.output().unwrap().into();
        assert!(!applied.err.contains("offset"), "{}", applied.err);
        assert_eq!(project.read("generated/arm.rs"), generated, "{}", ran.out);
    }
}

#[test]
fn change_of_the_model_is_shown_as_a_diff_and_as_operations() {
    let project = Project::generated();
    // A mass centre on an axis saves operations.
    project.replace(
        "models/arm.toml",
        "mass_center = [0.0, 0.02, -0.4]",
        "mass_center = [0.0, 0.0, -0.4]",
    );
    let ran = project.kane(&["check", "--lines"]);
    assert_eq!(ran.code, 1);
    let mut lines = ran.out.lines();
    let summary = lines.next().unwrap();
    assert!(
        summary.starts_with("generated/arm.rs differs: "),
        "{summary}"
    );
    assert!(!summary.ends_with("only numbers changed"), "{summary}");
    assert_eq!(lines.next(), Some("--- generated/arm.rs\tas it is"));
    assert_eq!(lines.next(), Some("+++ generated/arm.rs\tas generated"));
    assert!(lines.next().unwrap().starts_with("@@ -1,"));
    let tail: Vec<&str> = ran
        .out
        .lines()
        .skip_while(|line| *line != "generated/arm.rs: operations")
        .collect();
    let [_, mass_matrix, bias, fix] = tail[..] else {
        panic!("{tail:#?}")
    };
    for (line, name) in [(mass_matrix, "mass_matrix"), (bias, "bias")] {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [_, _, old, "->", new, _] = words[..] else {
            panic!("{line}")
        };
        assert_eq!(&words[..2], ["changed", name]);
        let (old, new): (usize, usize) = (old.parse().unwrap(), new.parse().unwrap());
        assert!(new < old);
        assert!(line.ends_with(&format!("(-{})", old - new)), "{line}");
        assert!(ran.out.contains(&format!("-/// Operations: {old} = ")));
        assert!(ran.out.contains(&format!("+/// Operations: {new} = ")));
    }
    assert_eq!(fix, "to bring this up to date, run: kane generate");
}

#[test]
fn numbers_are_told_from_indexes() {
    let project = Project::generated();
    let text = project.read("generated/arm.rs");
    let differs = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        project.write("generated/arm.rs", &text.replacen(from, to, 1));
        let told = project.kane(&["check"]).out;
        let first = told.lines().next().unwrap_or_default().to_owned();
        let where_ = ": 1 line removed, 1 added, in 1 function: ";
        assert!(first.contains(where_), "{first}");
        first.ends_with("; only numbers changed")
    };
    let literal = text.split("R::from_f64(").nth(1).unwrap();
    let literal = literal.split(')').next().unwrap();
    let literal = format!("R::from_f64({literal})");
    assert!(differs(&literal, "R::from_f64(123.5)"));
    assert!(!differs("[0][1], ", "[0][0], "));
}

#[test]
fn comments_are_told_from_numbers_and_layout() {
    let project = Project::generated();
    let text = project.read("generated/arm.rs");
    project.write("generated/arm.rs", &(text + "// a word\n"));
    let told = project.kane(&["check"]).out;
    let first = told.lines().next().unwrap_or_default();
    assert_eq!(
        first,
        "generated/arm.rs differs: 1 line removed, 0 added, none of them in a function; only comments changed"
    );
    assert!(!told.contains("layout"), "{told}");
}

#[test]
fn documentation_of_an_item_is_a_comment_and_code_beside_it_is_not() {
    let project = Project::generated();
    let text = project.read("generated/arm.rs");
    let told = |text: &str| {
        project.write("generated/arm.rs", text);
        let told = project.kane(&["check"]).out;
        told.lines().next().unwrap_or_default().to_owned()
    };
    let documented = "\n/// Operations: ";
    assert!(text.contains(documented));
    let more = text.replacen(documented, "\n/// Some more words.\n/// Operations: ", 1);
    let first = told(&more);
    let said = "generated/arm.rs differs: 1 line removed, 0 added, in 1 function: ";
    assert!(first.starts_with(said), "{first}");
    assert!(first.ends_with("; only comments changed"), "{first}");
    assert!(more.contains("    let "));
    let first = told(&more.replacen("    let ", "    let more_", 1));
    assert!(!first.contains("only"), "{first}");
}

#[test]
fn command_that_is_printed_brings_the_files_up_to_date() {
    let project = Project::generated();
    project.replace("models/arm.toml", "mass = 1.5", "mass = 1.25");
    let ran = project.kane_in(
        "models",
        &[
            "check",
            "arm.toml",
            "--functions",
            "bias",
            "--formulation",
            "notes",
            "--fma",
        ],
    );
    let command = ran.out.lines().last().unwrap();
    let command = command
        .strip_prefix("to bring this up to date, run: kane ")
        .unwrap();
    assert_eq!(
        command,
        "generate arm.toml --functions bias --formulation notes --fma"
    );
    let words: Vec<&str> = command.split(' ').collect();
    assert_eq!(project.kane_in("models", &words).code, 0);
    let again = [&["check"], &words[1..]].concat();
    assert_eq!(project.kane_in("models", &again).code, 0);
}

#[test]
fn nothing_is_written() {
    let project = Project::generated();
    project.replace("models/arm.toml", "mass = 1.5", "mass = 1.25");
    project.write("generated/old.rs", "old");
    let (files, modified) = (project.files(), project.modified("generated/arm.rs"));
    assert_eq!(project.kane(&["check", "--force"]).code, 1);
    assert_eq!(project.files(), files);
    assert_eq!(project.modified("generated/arm.rs"), modified);
}

#[test]
fn options_that_were_forgotten_are_named() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "2.0"));
    let asked = ["--functions", "default,jvp(bias; q, u)", "--snap", "1e-5"];
    let generate = [&["generate", "arm.toml"][..], &asked].concat();
    assert_eq!(project.kane(&generate).code, 0);
    let ran = project.kane(&["check", "arm.toml"]);
    assert_eq!(ran.code, 1);
    let told = "arm.rs was generated with other options: functions: default, jvp(bias; q, u); snap: 1e-5; asked for: snap: 1e-9\n";
    assert!(ran.out.contains(told), "{}", ran.out);
}

#[test]
fn missing_file_differs() {
    let project = Project::arm();
    let ran = project.kane(&["check"]);
    assert_eq!(ran.code, 1);
    assert!(
        ran.out.starts_with("generated/arm.rs is missing\n"),
        "{}",
        ran.out
    );
    assert!(ran.out.ends_with("run: kane generate\n"));
    assert!(!project.path("generated").exists());
}

#[test]
fn functions_that_came_and_went_are_named() {
    let project = Project::generated();
    project.replace("kane.toml", "\"mass_matrix\"", "\"kinetic_energy\"");
    let ran = project.kane(&["check"]);
    assert_eq!(ran.code, 1);
    assert!(
        ran.out.contains("\n  added    kinetic_energy  "),
        "{}",
        ran.out
    );
    assert!(
        ran.out.contains("\n  removed  mass_matrix     "),
        "{}",
        ran.out
    );
    assert!(!ran.out.contains("  changed"));
}

#[test]
fn change_of_formulation_is_named() {
    let project = Project::arm();
    let config = project.read("kane.toml");
    project.write(
        "kane.toml",
        &format!("{config}formulation = \"recursive\"\n"),
    );
    assert_eq!(project.kane(&["generate"]).code, 0);
    project.write("kane.toml", &format!("{config}formulation = \"notes\"\n"));
    let ran = project.kane(&["check"]);
    assert_eq!(ran.code, 1);
    assert!(
        ran.out.contains(", formulation recursive -> notes)\n"),
        "{}",
        ran.out
    );
}

#[test]
fn file_that_is_not_rust_is_compared_as_text() {
    let project = Project::generated();
    project.replace(
        "generated/arm.rs",
        "pub const NB: usize",
        "pub const NB usize",
    );
    let ran = project.kane(&["check", "--lines"]);
    assert_eq!(ran.code, 1);
    assert!(
        ran.out
            .contains("\n-pub const NB usize = 2;\n+pub const NB: usize = 2;\n")
    );
    assert!(
        ran.out
            .contains("generated/arm.rs is not Rust that can be read ("),
        "{}",
        ran.out
    );
}

#[test]
fn file_that_is_not_text_differs() {
    let project = Project::generated();
    fs::write(project.path("generated/arm.rs"), [0xff, 0xfe, b'\n']).unwrap();
    let ran = project.kane(&["check"]);
    assert_eq!(ran.code, 1);
    assert!(
        ran.out.ends_with("run: kane generate --force\n"),
        "{}",
        ran.out
    );
}

#[test]
fn line_ends_of_another_system_are_named_instead_of_every_line() {
    let project = Project::generated();
    project.replace("generated/arm.rs", "\n", "\r\n");
    let ran = project.kane(&["check"]);
    assert_eq!(ran.code, 1);
    insta::assert_snapshot!(ran.out, @"
    generated/arm.rs has line ends CR LF; expected LF: write `* text=auto eol=lf` into .gitattributes
    to bring this up to date, run: kane generate
    ");
}

#[test]
fn files_that_nothing_produces_are_stray() {
    let project = Project::generated();
    project.write("generated/mod.rs", "pub mod arm;\n");
    project.write("generated/.gitkeep", "");
    project.write("generated/old.rs", &project.read("generated/arm.rs"));
    project.write("generated/by/hand.txt", "hand-written");
    let ran = project.kane(&["check"]);
    assert_eq!(ran.code, 1);
    insta::assert_snapshot!(ran.out, @"
    generated/by/hand.txt is produced by nothing in kane.toml, or another kane.toml writes here: remove it, or list its system
    generated/old.rs is produced by nothing in kane.toml, or another kane.toml writes here: remove it, or list its system
    ");
    assert_eq!(
        project.kane_in("generated", &["check"]).out,
        ran.out
            .replace("generated/", "../generated/")
            .replace("in kane.toml", "in ../kane.toml")
    );
}

#[test]
fn what_people_wrote_beside_an_output_is_not_stray() {
    let project = Project::arm();
    project.replace("kane.toml", "generated/arm.rs", "src/arm.rs");
    assert_eq!(project.kane(&["generate"]).code, 0);
    project.write("src/lib.rs", "pub mod arm;\n");
    assert_eq!(project.kane(&["check"]).code, 0);
    fs::copy(project.path("src/arm.rs"), project.path("src/old.rs")).unwrap();
    let ran = project.kane(&["check"]);
    assert_eq!(ran.code, 1);
    assert!(
        ran.out.starts_with("src/old.rs is produced by nothing"),
        "{}",
        ran.out
    );
}

#[test]
fn folder_above_the_project_that_is_named_generated_does_not_matter() {
    let project = Project::empty();
    project.write("generated/arm/models/arm.toml", &model("arm", "2.0"));
    project.write(
        "generated/arm/kane.toml",
        &system("models/arm.toml", "src/arm.rs"),
    );
    for folder in ["generated/arm", ""] {
        let arguments = |command| {
            [
                command,
                "--config",
                if folder.is_empty() {
                    "generated/arm/kane.toml"
                } else {
                    "kane.toml"
                },
            ]
        };
        assert_eq!(project.kane_in(folder, &arguments("generate")).code, 0);
        let ran = project.kane_in(folder, &arguments("check"));
        assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    }
}

#[test]
fn stray_files_are_no_matter_of_one_model() {
    let project = Project::generated();
    project.write("generated/old.rs", "old");
    assert_eq!(project.kane(&["check", "models/arm.toml"]).code, 0);
}

#[test]
fn bad_input_is_2_whatever_differs() {
    let project = Project::generated();
    project.write("generated/old.rs", "old");
    project.replace("models/arm.toml", "mass = 1.5", "mass = -1.5");
    let ran = project.kane(&["check"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert!(ran.err.contains("models/arm.toml:15:8"), "{}", ran.err);
}

#[test]
fn output_that_is_a_folder_is_2() {
    let project = Project::arm();
    fs::create_dir_all(project.path("generated/arm.rs")).unwrap();
    let ran = project.kane(&["check"]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .starts_with("error: cannot access `generated/arm.rs`: "),
        "{}",
        ran.err
    );
}

#[test]
fn standard_output_is_nothing_to_compare_with() {
    let ran = Project::arm().kane(&["check", "models/arm.toml", "--output", "-"]);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @"error: standard output holds nothing to compare with; expected the name of a file after --output");
}

#[test]
fn reader_that_leaves_early_changes_nothing() {
    let project = Project::generated();
    // Far more than a pipe holds.
    project.write("generated/arm.rs", &"// old\n".repeat(100_000));
    let mut command = project.command();
    let mut child = command
        .arg("check")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let ended = child.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(1));
    assert_eq!(String::from_utf8_lossy(&ended.stderr), "");
}

#[test]
fn operations_of_functions_in_one_and_at_sines_and_cosines_are_compared_like_others() {
    let project = Project::arm();
    let functions = "\"mass_matrix+bias\", \"bias(sin_cos)\"";
    let listed = system("models/arm.toml", "generated/arm.rs");
    let listed = listed.replace("\"mass_matrix\", \"bias\"", functions);
    project.write("kane.toml", &listed);
    let generated = project.kane(&["generate"]);
    assert_eq!(generated.code, 0, "{}", generated.err);
    assert_eq!(project.kane(&["check"]).code, 0);
    project.replace(
        "models/arm.toml",
        "mass_center = [0.0, 0.02, -0.4]",
        "mass_center = [0.0, 0.0, -0.4]",
    );
    let ran = project.kane(&["check"]);
    assert_eq!(ran.code, 1);
    for name in ["mass_matrix_and_bias", "bias_at_sin_cos"] {
        let of_function = |line: &str| line.split_whitespace().nth(1) == Some(name);
        let line = ran.out.lines().find(|line| of_function(line));
        assert!(line.is_some_and(|line| line.contains("(-")), "{}", ran.out);
    }
}

#[test]
fn a_command_to_copy_names_a_model_that_begins_with_a_dash() {
    let project = Project::arm();
    project.write("-arm.toml", &project.read("models/arm.toml"));
    let ran = project.kane(&["check", "--output", "arm.rs", "--", "-arm.toml"]);
    assert_eq!(ran.code, 1, "{}", ran.err);
    let told = ran.out + &ran.err;
    assert!(
        told.contains("kane generate ./-arm.toml --output arm.rs"),
        "{told}"
    );
}

#[test]
fn functions_given_on_the_command_line_are_joined_as_in_the_file() {
    let project = Project::arm();
    let text = |functions: &str| {
        let arguments = ["generate", "models/arm.toml", "--output", "-"];
        project.kane(&[&arguments[..], &["--functions", functions]].concat())
    };
    let ran = text("mass_matrix+bias,mass_matrix+bias(sin_cos)");
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(
        ran.out
            .contains("functions: mass_matrix+bias, mass_matrix+bias(sin_cos);")
    );
    assert!(ran.out.contains("pub fn mass_matrix_and_bias_at_sin_cos<"));
    let ran = text(
        "bias+bais,bias+bias,bias+partial_velocity,bias+mass_matrix,bias +mass_matrix, bias,bias",
    );
    assert_eq!(ran.code, 2);
    for fault in [
        "`bais` is no function; did you mean `bias`?",
        "`bias+bias` names `bias` twice",
        "`bias+partial_velocity` joins `partial_velocity` to others",
        "--functions names `bias +mass_matrix` twice",
        "--functions names `bias` twice",
    ] {
        assert!(ran.err.contains(fault), "{fault}\n{}", ran.err);
    }
}
