//! The examples for those who host code: a workflow and a hook, run as they stand.

use std::{
    env, fs,
    os::unix::fs::{PermissionsExt as _, symlink},
    process::Command,
};

use yaml_rust2::{Yaml, YamlLoader};

use super::project::{Project, Ran, repository};

/// A repository of an arm, with a folder `.git/bin` of commands: `kane`, and whatever else a test puts there.
fn committed() -> Project {
    let project = Project::generated().committed();
    let commands = project.path(".git/bin");
    fs::create_dir(&commands).unwrap();
    symlink(env!("CARGO_BIN_EXE_kane"), commands.join("kane")).unwrap();
    project
}

/// The command with the repository's own commands before all others.
fn with_commands(project: &Project, mut command: Command) -> Ran {
    let own = project.path(".git/bin");
    let others = env::var_os("PATH").unwrap();
    let all = env::join_paths([own].into_iter().chain(env::split_paths(&others)));
    command.env("PATH", all.unwrap()).output().unwrap().into()
}

fn executable(project: &Project, path: &str, text: &str) {
    project.write(path, text);
    fs::set_permissions(project.path(path), fs::Permissions::from_mode(0o755)).unwrap();
}

/// A repository with the hook.
fn hooked() -> Project {
    let project = committed();
    let hook = repository("docs/ci/pre-commit");
    let mode = fs::metadata(&hook).unwrap().permissions().mode();
    assert_ne!(mode & 0o111, 0, "the hook can be executed as it is");
    executable(
        &project,
        ".git/hooks/pre-commit",
        &fs::read_to_string(hook).unwrap(),
    );
    project
}

/// Commits what is staged.
fn commit(project: &Project) -> Ran {
    with_commands(
        project,
        project.git_command(&["commit", "--message", "edit"]),
    )
}

#[test]
fn hook_refuses_a_commit_with_a_stale_file_and_takes_it_once_it_is_fresh() {
    let project = hooked();
    let head = project.git(&["rev-parse", "HEAD"]);
    project.replace("models/arm.toml", "mass = 1.5", "mass = 1.25");
    project.git(&["add", "--all"]);
    let ran = commit(&project);
    assert_eq!(ran.code, 1, "{ran:?}");
    let told = ran.out + &ran.err;
    assert!(
        told.contains("to bring this up to date, run: kane generate\n"),
        "{told}"
    );
    assert_eq!(project.git(&["rev-parse", "HEAD"]), head);

    // Fresh in the folder, and still stale in the commit.
    assert_eq!(project.kane(&["generate"]).code, 0);
    assert_eq!(commit(&project).code, 1);

    project.git(&["add", "--all"]);
    let ran = commit(&project);
    assert_eq!(ran.code, 0, "{ran:?}");
    assert_ne!(project.git(&["rev-parse", "HEAD"]), head);
}

#[test]
fn hook_judges_what_is_staged_and_not_what_lies_about() {
    let project = hooked();
    project.write("notes.txt", "by hand\n");
    project.git(&["add", "notes.txt"]);
    project.replace("models/arm.toml", "mass = 1.5", "mass = 1.25");
    let ran = commit(&project);
    assert_eq!(ran.code, 0, "{ran:?}");
}

/// The workflow's steps.
fn steps() -> Vec<Yaml> {
    let text = fs::read_to_string(repository("docs/ci/github.yml")).unwrap();
    let documents = YamlLoader::load_from_str(&text).unwrap();
    assert_eq!(documents.len(), 1);
    let workflow = &documents[0];
    let events = workflow["on"].as_hash().unwrap().keys();
    let events: Vec<&str> = events.filter_map(Yaml::as_str).collect();
    assert_eq!(events, ["push", "pull_request"]);
    let job = &workflow["jobs"]["check"];
    assert!(job["runs-on"].as_str().unwrap().starts_with("ubuntu-"));
    job["steps"].as_vec().unwrap().clone()
}

/// Runs the steps that a pull request onto `base` runs, as the host does, until one fails: what that one said, and the summary.
fn pull_request(project: &Project, base: &str) -> (Ran, String) {
    executable(
        project,
        ".git/bin/cargo",
        "#!/bin/sh\nprintf '%s\\n' \"$*\" > .git/installed\n",
    );
    project.write(".git/summary", "");
    let mut last = None;
    for step in steps() {
        let Some(script) = step["run"].as_str() else {
            continue;
        };
        if let Some(condition) = step["if"].as_str() {
            assert_eq!(condition, "github.event_name == 'pull_request'");
        }
        let mut command = Command::new("bash");
        command
            .args(["-e", "-c", script])
            .current_dir(project.path(""));
        command.env("RUNNER_TEMP", project.path(".git"));
        command.env("GITHUB_STEP_SUMMARY", project.path(".git/summary"));
        for (name, value) in step["env"].as_hash().into_iter().flatten() {
            assert_eq!(
                value.as_str(),
                Some("${{ github.event.pull_request.base.sha }}")
            );
            command.env(name.as_str().unwrap(), base);
        }
        let ran = with_commands(project, command);
        let failed = ran.code != 0;
        last = Some(ran);
        if failed {
            break;
        }
    }
    (last.unwrap(), project.read(".git/summary"))
}

#[test]
fn workflow_checks_out_all_revisions_and_installs_this_package() {
    let uses = steps()
        .into_iter()
        .filter(|step| !step["uses"].is_badvalue());
    let uses: Vec<Yaml> = uses.collect();
    let [checkout] = uses.as_slice() else {
        panic!("one action")
    };
    assert!(
        checkout["uses"]
            .as_str()
            .unwrap()
            .starts_with("actions/checkout@v")
    );
    assert_eq!(checkout["with"]["fetch-depth"].as_i64(), Some(0));
    let project = committed();
    let base = project.git(&["rev-parse", "HEAD"]);
    assert_eq!(pull_request(&project, base.trim()).0.code, 0);
    let installed = concat!(
        "install --locked --git REPOSITORY ",
        env!("CARGO_PKG_NAME"),
        "\n"
    );
    assert_eq!(project.read(".git/installed"), installed);
}

#[test]
fn workflow_shows_what_a_pull_request_changes() {
    let project = committed();
    let base = project.git(&["rev-parse", "HEAD"]);
    project.replace("models/arm.toml", "[\"theta2\"]", "[\"s3\"]");
    assert_eq!(project.kane(&["generate"]).code, 0);
    project.commit();
    let (ran, summary) = pull_request(&project, base.trim());
    assert_eq!(ran.code, 0, "{ran:?}");
    let base = base.trim();
    let title = format!(
        "## `{base}` → `HEAD`\n\n**BREAKING: files that are gone, or in which places, names, functions or arguments changed**\n\n\
         | | | |\n| --- | --- | --- |\n| changed | `HEAD:generated/arm.rs` | `q, u` |\n\n\
         ### `{base}:generated/arm.rs` → `HEAD:generated/arm.rs`\n"
    );
    assert!(summary.starts_with(&title), "{summary}");
    assert!(
        summary.contains("\n**BREAKING: the places in q changed**\n"),
        "{summary}"
    );
}

#[test]
fn workflow_fails_where_a_file_is_stale() {
    let project = committed();
    let base = project.git(&["rev-parse", "HEAD"]);
    project.replace("models/arm.toml", "mass = 1.5", "mass = 1.25");
    project.commit();
    let (ran, summary) = pull_request(&project, base.trim());
    assert_eq!((ran.code, summary.as_str()), (1, ""));
    assert!(
        ran.out
            .contains("to bring this up to date, run: kane generate\n")
    );
}
